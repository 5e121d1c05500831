// A table record. Verdicts have a sign and a word beside their colour.

const verdictSign = { good: "✓", doubtful: "?", bad: "✗" };
const verdictWord = { good: "agrees", doubtful: "doubtful", bad: "disagrees" };

function tableHeading(column) {
  const heading = element("th", { scope: "col", class: column.number ? "number" : null }, column.name);
  if (column.unit) heading.append(" ", element("span", { class: "unit" }, unitText(column.unit)));
  if (column.origin) heading.append(" ", originTag(column.origin));
  return heading;
}

function tableCell(cell, column, position) {
  const tag = position === 0 && !column.number ? "th" : "td";
  const node = element(tag, {
    scope: tag === "th" ? "row" : null,
    class: [column.number ? "number" : "", cell.verdict === "none" ? "" : `verdict-${cell.verdict}`].join(" ").trim() || null,
  }, cell.text);
  if (cell.verdict !== "none") {
    node.append(" ", element("span", { "aria-hidden": "true", class: "sign" }, verdictSign[cell.verdict]),
      element("span", { class: "spoken" }, verdictWord[cell.verdict]));
  }
  if (cell.origin) node.append(" ", originTag(cell.origin));
  return node;
}

function renderTable(table) {
  const head = element("thead", {}, element("tr", {}, ...table.columns.map(tableHeading)));
  const body = element("tbody", {}, ...table.rows.map((row) =>
    element("tr", {}, ...row.map((cell, i) => tableCell(cell, table.columns[i], i)))));
  return captioned("tabled", table, scrollBox(table.title, element("table", { "aria-label": table.title }, head, body)));
}
