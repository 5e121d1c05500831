// How a mark says where its number is from. Colour tells series apart; dash and marker
// tell their origin, so that neither depends on seeing colour.

const originMeaning = {
  measured: "read by an instrument, or published as such",
  derived: "computed from measured numbers alone",
  fitted: "a model's number, adjusted to these data",
  predicted: "a model's number, not adjusted to what it is compared with",
};
const dashOfOrigin = { measured: "solid", derived: "dot", fitted: "dash", predicted: "solid" };
const strokeOfOrigin = { measured: "", derived: "2 3", fitted: "7 4", predicted: "" };

const ink = "#1b1f24";  // on pale cells of a matrix, whatever the page's colours

/** Is the page dark now? Paper never is. */
function isDark() {
  return !("paper" in document.documentElement.dataset) && matchMedia("(prefers-color-scheme: dark)").matches;
}

/** A colour of the page's own, as the style sheet has it now. */
function pageColour(name) {
  return getComputedStyle(document.documentElement).getPropertyValue(name).trim();
}
// Told apart by readers with any common colour vision (after Okabe & Ito), darkened
// where thin lines on white would fade.
const palette = ["#0072b2", "#d55e00", "#008a63", "#b85c94", "#b07d00", "#4a9fd0",
                 "#8c564b", "#6a55a8", "#5b7f2b", "#a02c5a"];
const paletteOnDark = ["#56b4e9", "#ff9a52", "#3ad0a0", "#e79fc4", "#e6c04a", "#8ecbf0",
                       "#c9a298", "#b5a6f2", "#a9cf72", "#f083ab"];
const symbols = ["circle", "square", "diamond", "triangle-up", "cross", "star"];
const placeOfName = new Map();
const placeOfMeasured = new Map();

function placeIn(places, name) {
  if (!places.has(name)) places.set(name, places.size);
  return places.get(name);
}

/** The same name has the same colour and symbol in every figure of the page. */
function lookOf(series) {
  if (series.origin === "measured") {
    return { colour: pageColour("--ink"), symbol: symbols[placeIn(placeOfMeasured, series.name) % symbols.length] };
  }
  if (series.reference) return { colour: pageColour("--ink"), symbol: "circle" };
  const place = placeIn(placeOfName, series.name);
  const colours = isDark() ? paletteOnDark : palette;
  return { colour: colours[place % colours.length], symbol: symbols[place % symbols.length] };
}

/** Gives out the looks in the order of the report: the chosen overlay's series first. */
function assignLooks(report) {
  const blocks = [...report.lead, ...report.sections.flatMap((section) => [...section.blocks, ...section.details])];
  const overlays = blocks.filter((block) => block.kind === "overlays").flatMap((block) => block.items);
  const figures = [...overlays.flatMap((overlay) => overlay.figures),
                   ...blocks.filter((block) => block.kind === "figure")];
  figures.forEach((figure) => figure.series.forEach(lookOf));
}

function originTag(origin) {
  if (!origin) return null;
  return element("span", { class: `origin origin-${origin}`, title: originMeaning[origin] }, origin);
}

/** The drawing library's symbols, as paths around (15, 6). */
const symbolPaths = {
  circle: "M19 6a4 4 0 1 1-8 0a4 4 0 1 1 8 0Z",
  square: "M11.5 2.5h7v7h-7Z",
  diamond: "M15 1l4.6 5L15 11l-4.6-5Z",
  "triangle-up": "M15 1.6l4.6 8h-9.2Z",
  cross: "M13.4 1.4h3.2v3h3v3.2h-3v3h-3.2v-3h-3V4.4h3Z",
  star: "M15 .8l1.3 3.6 3.8.1-3 2.3 1.1 3.7L15 8.3l-3.2 2.2 1.1-3.7-3-2.3 3.8-.1Z",
};

/** A small picture of the series' line or marker, for the legend. */
function swatch(series) {
  const space = "http://www.w3.org/2000/svg";
  const svg = document.createElementNS(space, "svg");
  svg.setAttribute("viewBox", "0 0 30 12");
  svg.setAttribute("aria-hidden", "true");
  const { colour, symbol } = lookOf(series);
  const add = (name, attributes) => {
    const shape = document.createElementNS(space, name);
    for (const [key, value] of Object.entries(attributes)) shape.setAttribute(key, value);
    svg.append(shape);
  };
  if (series.y_low.length > 0) {
    add("rect", { x: 0, y: 1, width: 30, height: 10, fill: colour, "fill-opacity": 0.18 });
  }
  if (series.style === "line") {
    add("line", { x1: 0, y1: 6, x2: 30, y2: 6, stroke: colour, "stroke-width": 2.4,
                  "stroke-dasharray": strokeOfOrigin[series.origin] });
  } else {
    const filled = series.origin === "measured" ? colour : pageColour("--page");
    add("path", { d: symbolPaths[symbol], fill: filled, stroke: colour, "stroke-width": 1.8 });
  }
  return svg;
}
