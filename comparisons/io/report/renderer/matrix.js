// A matrix record: an HTML table, so that its numbers are text, its headings are read out
// and its cells can be reached with Tab (one stop), the arrow keys, and Enter.

const sequentialColours = ["#fdfaf3", "#fbdfae", "#f2aa60", "#d9653a", "#9c2a26"];
const divergingColours = ["#2c5f9e", "#86b3d8", "#f7f6f3", "#eeab7c", "#b4431f"];

function channels(colour) {
  return [1, 3, 5].map((i) => parseInt(colour.slice(i, i + 2), 16));
}

/** Colour of a value as [r, g, b], linear between the anchors. */
function colourOfValue(value, matrix) {
  const anchors = matrix.diverging ? divergingColours : sequentialColours;
  const share = matrix.diverging ? (value / matrix.limit + 1) / 2 : Math.abs(value) / matrix.limit;
  const position = Math.min(Math.max(share, 0), 1) * (anchors.length - 1);
  const below = Math.min(Math.floor(position), anchors.length - 2);
  const [from, to] = [channels(anchors[below]), channels(anchors[below + 1])];
  return from.map((channel, i) => Math.round(channel + (to[i] - channel) * (position - below)));
}

/** Ink or white, whichever has the higher contrast (WCAG relative luminance). */
function textColourOn(rgb) {
  const [r, g, b] = rgb.map((c) => (c / 255 <= 0.04045 ? c / 255 / 12.92 : ((c / 255 + 0.055) / 1.055) ** 2.4));
  const luminance = 0.2126 * r + 0.7152 * g + 0.0722 * b;
  return luminance > 0.2 ? ink : "#fff";
}

function matrixHead(matrix) {
  const groups = [];
  for (const column of matrix.columns) {
    const last = groups.at(-1);
    if (last && last.name === column.group) last.span += 1;
    else groups.push({ name: column.group, span: 1 });
  }
  const corner = element("th", { scope: "col", rowspan: "2", class: "corner" }, matrix.row_heading);
  return element("thead", {},
    element("tr", {}, corner, ...groups.map((group) =>
      element("th", { scope: "colgroup", colspan: String(group.span), class: "group-start" }, group.name))),
    element("tr", {}, ...matrix.columns.map((column, i) =>
      element("th", { scope: "col", class: startsGroup(matrix, i) ? "group-start" : null }, column.name))));
}

function startsGroup(matrix, i) {
  return i === 0 || matrix.columns[i].group !== matrix.columns[i - 1].group;
}

function describeCell(matrix, row, column, cell) {
  const number = cell.value === null ? cell.text : `${cell.text}${unitSuffix(matrix.unit)}`;
  return [`${row.name}, ${column.group} ${column.name}: ${number}`,
    cell.hatched ? matrix.hatching : "", cell.overlay ? "show the overlay" : ""].filter(Boolean).join("; ");
}

function matrixCell(matrix, row, column, cell) {
  const content = element(cell.overlay ? "button" : "span", {
    type: cell.overlay ? "button" : null,
    class: `cell${cell.hatched ? " hatched" : ""}${cell.value === null ? " without" : ""}`,
    "aria-label": cell.overlay ? describeCell(matrix, row, column, cell) : null,
    "aria-pressed": cell.overlay ? "false" : null,
    tabindex: cell.overlay ? "-1" : null,
  }, element("span", { class: "value" }, cell.text));
  if (cell.value !== null) {
    const rgb = colourOfValue(cell.value, matrix);
    content.style.setProperty("--cell", `rgb(${rgb.join(",")})`);
    content.style.setProperty("--on-cell", textColourOn(rgb));
  }
  return content;
}

/** What the colours mean, from end to end of the scale, and what hatching means. */
function matrixKey(matrix) {
  const anchors = matrix.diverging ? divergingColours : sequentialColours;
  const bar = element("span", { class: "bar", "aria-hidden": "true" });
  bar.style.background = `linear-gradient(to right, ${anchors.join(",")})`;
  const unit = unitSuffix(matrix.unit);
  const [low, high] = matrix.diverging ? [`≤ −${matrix.limit}`, `≥ +${matrix.limit}`] : ["0", `≥ ${matrix.limit}`];
  const key = element("p", { class: "matrix-key" }, element("span", {}, `${matrix.quantity}:`),
    element("span", { class: "scale" }, `${low}${unit}`, bar, `${high}${unit}`));
  if (matrix.rows.some((row) => row.cells.some((cell) => cell.hatched))) {
    key.append(element("span", { class: "scale" },
      element("span", { class: "cell hatched sample", "aria-hidden": "true" }), matrix.hatching));
  }
  return key;
}

/** Arrow keys move between the linked cells; one of them is a Tab stop. */
function addKeyboard(body, grid) {
  const stops = grid.flat().filter((content) => content.tagName === "BUTTON");
  if (stops.length === 0) return;
  stops[0].tabIndex = 0;
  const step = { ArrowRight: [0, 1], ArrowLeft: [0, -1], ArrowDown: [1, 0], ArrowUp: [-1, 0] };
  body.addEventListener("keydown", (event) => {
    const move = step[event.key];
    let row = grid.findIndex((cells) => cells.includes(event.target));
    if (!move || row < 0) return;
    event.preventDefault();
    let column = grid[row].indexOf(event.target);
    do {
      row += move[0];
      column += move[1];
    } while (grid[row]?.[column] && grid[row][column].tagName !== "BUTTON");
    grid[row]?.[column]?.focus();
  });
  body.addEventListener("focusin", (event) => {
    stops.forEach((stop) => { stop.tabIndex = stop === event.target ? 0 : -1; });
  });
}

/** `choose(overlays, key, highlight)` is called when a cell is pressed. */
function renderMatrix(matrix, choose, onChosen) {
  const buttons = [];
  const grid = matrix.rows.map((row) => row.cells.map((cell, i) => {
    const content = matrixCell(matrix, row, matrix.columns[i], cell);
    if (cell.overlay) {
      buttons.push({ content, cell });
      content.addEventListener("click", () => choose(matrix.overlays, cell.overlay, cell.highlight));
    }
    return content;
  }));
  const body = element("tbody", {}, ...matrix.rows.map((row, r) => element("tr", {},
    element("th", { scope: "row" }, row.name),
    ...grid[r].map((content, i) => element("td", { class: startsGroup(matrix, i) ? "group-start" : null }, content)))));
  addKeyboard(body, grid);
  if (matrix.overlays) {
    onChosen(matrix.overlays, (key, highlight) => buttons.forEach(({ content, cell }) =>
      content.setAttribute("aria-pressed", String(cell.overlay === key && cell.highlight === highlight))));
  }
  const table = element("table", { class: "matrix", "aria-label": matrix.title }, matrixHead(matrix), body);
  return captioned("matrixed", matrix, scrollBox(matrix.title, table), matrixKey(matrix));
}
