// A table record. Verdicts have a sign and a word beside their colour. A press on a heading
// sorts; the whole table can be copied as comma-separated values.

const verdictSign = { good: "✓", doubtful: "?", bad: "✗" };
const verdictWord = { good: "agrees", doubtful: "doubtful", bad: "disagrees" };

/** The number a text starts with, or none. */
function leadingNumber(text) {
  const found = text.replaceAll("−", "-").match(/^[^\d+-]{0,2}([+-]?\d[\d ]*(\.\d+)?(e[+-]?\d+)?)/i);
  return found ? Number(found[1].replaceAll(" ", "")) : null;
}

/** Numbers before words, each in their own order. */
function compareTexts(a, b) {
  const [left, right] = [leadingNumber(a), leadingNumber(b)];
  if (left !== null && right !== null && left !== right) return left - right;
  if ((left === null) !== (right === null)) return left === null ? 1 : -1;
  return a.localeCompare(b);
}

function csvOf(table) {
  const field = (text) => (/[",\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text);
  const headings = table.columns.map((column) => field(`${column.name} ${unitText(column.unit)}`.trim()));
  return [headings, ...table.rows.map((row) => row.map((cell) => field(cell.text)))]
    .map((fields) => fields.join(",")).join("\n") + "\n";
}

async function copyText(text) {
  try {
    await navigator.clipboard.writeText(text);
  } catch {
    // Pages opened from a folder may have no clipboard of their own.
    const place = element("textarea", { readonly: "" }, text);
    document.body.append(place);
    place.select();
    document.execCommand("copy");
    place.remove();
  }
}

function copyButton(table) {
  const button = element("button", { type: "button", class: "copy", "aria-label": `Copy as CSV: ${table.title}` }, "Copy as CSV");
  button.addEventListener("click", async () => {
    await copyText(csvOf(table));
    button.textContent = "Copied";
    setTimeout(() => { button.textContent = "Copy as CSV"; }, 1500);
  });
  return button;
}

function tableHeading(column, sort) {
  const button = element("button", { type: "button", class: "sort" }, column.name || "sort");
  button.addEventListener("click", sort);
  const heading = element("th", { scope: "col", class: column.number ? "number" : null }, button);
  if (column.unit) heading.append(" ", element("span", { class: "unit" }, unitText(column.unit)));
  if (column.origin) heading.append(" ", originTag(column.origin));
  return heading;
}

/** A number with a minus as long as a plus is wide; its copy keeps the hyphen that programs read. */
function withMinus(text) {
  return text.replace(/(^|[\s([e])-(?=[\d.])/gi, "$1−");
}

function tableCell(cell, column, position) {
  const text = column.number ? withMinus(cell.text) : cell.text;
  const tag = position === 0 && !column.number ? "th" : "td";
  const node = element(tag, {
    scope: tag === "th" ? "row" : null,
    class: [column.number ? "number" : "", cell.verdict === "none" ? "" : `verdict-${cell.verdict}`].join(" ").trim() || null,
  }, cell.link ? element("a", { href: cell.link }, text) : text);
  if (cell.verdict !== "none") {
    node.append(" ", element("span", { "aria-hidden": "true", class: "sign" }, verdictSign[cell.verdict]),
      element("span", { class: "spoken" }, verdictWord[cell.verdict]));
  }
  if (cell.origin) node.append(" ", originTag(cell.origin));
  return node;
}

function renderTable(table) {
  const rows = table.rows.map((row) => ({
    row, node: element("tr", {}, ...row.map((cell, i) => tableCell(cell, table.columns[i], i))),
  }));
  const body = element("tbody", {}, ...rows.map(({ node }) => node));
  const headings = table.columns.map((column, i) => tableHeading(column, () => {
    const descending = headings[i].getAttribute("aria-sort") === "ascending";
    headings.forEach((heading) => heading.removeAttribute("aria-sort"));
    headings[i].setAttribute("aria-sort", descending ? "descending" : "ascending");
    const ordered = rows.toSorted((a, b) => compareTexts(a.row[i].text, b.row[i].text));
    body.replaceChildren(...(descending ? ordered.reverse() : ordered).map(({ node }) => node));
  }));
  const head = element("thead", {}, element("tr", {}, ...headings));
  return captioned("tabled", table, scrollBox(table.title, element("table", { "aria-label": table.title }, head, body)),
    copyButton(table));
}
