// An animation record: the half-section and its mirror image above the plate, coloured by
// a field of the reader's choice, with a slider over time. It stands still until asked to play.

const framesPerSecond = 15;
const shapeOnly = -1;
// Evenly spaced to the eye and in grey: samples of viridis (S. van der Walt and N. Smith, CC0).
const fieldColours = ["#440154", "#482878", "#3e4989", "#31688e", "#26828e",
                      "#1f9e89", "#35b779", "#6ece58", "#b5de2b", "#fde725"];
const colourSteps = 32;

function svgElement(tag, attributes) {
  const node = document.createElementNS("http://www.w3.org/2000/svg", tag);
  for (const [name, value] of Object.entries(attributes)) node.setAttribute(name, value);
  return node;
}

/** Colour at a share in [0, 1] of the range, linear between the samples. */
function colourOfShare(share) {
  const position = share * (fieldColours.length - 1);
  const below = Math.min(Math.floor(position), fieldColours.length - 2);
  const [from, to] = [channels(fieldColours[below]), channels(fieldColours[below + 1])];
  return `rgb(${from.map((channel, i) => Math.round(channel + (to[i] - channel) * (position - below))).join(",")})`;
}

/** Outline of every cell; heights grow upwards, SVG's y downwards. */
function outlinesOf(frame, cells) {
  const point = (vertex) => `${frame.radius[vertex].toPrecision(6)} ${(-frame.height[vertex]).toPrecision(6)}`;
  return cells.map((cell) => `M${cell.map(point).join("L")}Z`);
}

/** 1, 2 or 5 times a power of ten, about a quarter of `length`. */
function roundLength(length) {
  const power = 10 ** Math.floor(Math.log10(length / 4));
  return [5, 2, 1].map((digit) => digit * power).find((candidate) => candidate <= length / 4);
}

function largestOf(rows) {
  return rows.reduce((most, row) => row.reduce((a, b) => Math.max(a, b), most), 0);
}

/** The pressure of one frame as an area that hangs from `top`, `depth` at `most`. */
function pressurePath(animation, position, { top, depth, most }) {
  const pressure = animation.contact.pressure[position];
  const { radius } = animation.frames[position];
  const pressed = animation.contact.vertices.slice(0, pressure.findLastIndex((value) => value !== 0) + 2);
  if (pressed.length < 2) return "";
  const points = pressed.map((vertex, i) => [radius[vertex], top + depth * (pressure[i] / most)]);
  const text = ([x, y]) => `${x.toPrecision(6)} ${y.toPrecision(6)}`;
  return `M${[...points.toReversed().map(([x, y]) => [-x, y]), ...points].map(text).join("L")}`;
}

/** The drawing, and how to draw one frame in it. */
function drawSection(animation) {
  const radius = largestOf(animation.frames.map((frame) => frame.radius));
  const height = largestOf(animation.frames.map((frame) => frame.height));
  const margin = 0.12 * radius;
  const half = radius + margin;
  const most = largestOf(animation.contact.pressure);
  const pressed = most > 0;
  const below = { top: 0.6 * margin, depth: 2.2 * margin, most };
  const foot = pressed ? below.top + below.depth : 0;
  const svg = svgElement("svg", {
    viewBox: `${-half} ${-height - margin} ${2 * half} ${height + 3.2 * margin + foot}`, role: "img",
    "aria-label": `${animation.title}: half-section, mirrored, above the plate`,
  });
  const sides = ["scale(1 1)", "scale(-1 1)"].map((transform) => {
    const colours = Array.from({ length: colourSteps }, (_, step) => {
      const colour = colourOfShare((step + 0.5) / colourSteps);
      return svgElement("path", { class: "coloured", fill: colour, stroke: colour });
    });
    const cells = svgElement("path", { class: "cells" });
    const side = svgElement("g", { transform });
    side.append(...colours, cells);
    svg.append(side);
    return { colours, cells };
  });
  const bar = roundLength(2 * radius);
  const text = svgElement("text", { x: -half + bar + 0.5 * margin, y: foot + 1.78 * margin, "font-size": 0.5 * margin });
  text.textContent = `${bar} ${animation.length_unit}`;
  svg.append(
    svgElement("rect", { class: "plate", x: -half, y: 0, width: 2 * half, height: 0.6 * margin }),
    svgElement("line", { class: "scale-bar", x1: -half + 0.1 * margin, x2: -half + 0.1 * margin + bar, y1: foot + 1.6 * margin, y2: foot + 1.6 * margin }),
    text);
  const curve = svgElement("path", { class: "contact-pressure" });
  if (pressed) svg.append(curve);

  function draw(position, field, bytes) {
    const outlines = outlinesOf(animation.frames[position], animation.cells);
    const parts = Array.from({ length: colourSteps }, () => []);
    if (field) outlines.forEach((outline, cell) =>
      parts[Math.floor(bytes[position * animation.cells.length + cell] * colourSteps / 256)].push(outline));
    const whole = outlines.join("");
    const coloured = parts.map((part) => part.join(""));
    sides.forEach(({ colours, cells }) => {
      colours.forEach((path, step) => path.setAttribute("d", coloured[step]));
      cells.setAttribute("d", whole);
      cells.classList.toggle("over-colour", Boolean(field));
    });
    if (pressed) curve.setAttribute("d", pressurePath(animation, position, below));
  }
  return { svg, draw, most };
}

function threeDigits(number) {
  return String(Number(number.toPrecision(3)));
}

/** Colours and numbers of the chosen field, the same for all frames. */
function fieldLegend(field) {
  const bar = element("span", { class: "bar", "aria-hidden": "true" });
  bar.style.background = `linear-gradient(to right, ${fieldColours.join(", ")})`;
  const numbers = [field.low, (field.low + field.high) / 2, field.high].map((number) =>
    element("span", {}, threeDigits(number)));
  return element("div", { class: "field-legend" },
    element("span", {}, `${field.name} ${unitText(field.unit)}`),
    element("span", { class: "scale" }, bar, element("span", { class: "ticks" }, ...numbers)));
}

function fieldChoice(animation) {
  const options = animation.fields.map((field, i) => element("option", { value: String(i) }, field.name));
  return element("select", {}, ...options, element("option", { value: String(shapeOnly) }, "shape only"));
}

function renderAnimation(animation) {
  const { svg, draw, most } = drawSection(animation);
  const bytes = animation.fields.map((field) =>
    Uint8Array.from(atob(field.values), (letter) => letter.charCodeAt(0)));
  const last = animation.frames.length - 1;
  const slider = element("input", { type: "range", min: "0", max: String(last), step: "1", value: "0", "aria-label": "time" });
  const shown = element("output", { "aria-live": "off" });
  const button = element("button", { type: "button" }, "Play");
  const choice = fieldChoice(animation);
  const legend = element("div", { class: "legend-place" });
  let timer = null;
  let chosen = animation.fields.length > 0 ? 0 : shapeOnly;

  function show(position) {
    draw(position, animation.fields[chosen], bytes[chosen]);
    shown.textContent = `${animation.frames[position].time.toFixed(2)} ${animation.time_unit}`;
    slider.value = String(position);
    slider.setAttribute("aria-valuetext", shown.textContent);
  }
  function stop() {
    clearInterval(timer);
    timer = null;
    button.textContent = "Play";
  }
  function choose(field) {
    chosen = field;
    legend.replaceChildren(...(field === shapeOnly ? [] : [fieldLegend(animation.fields[field])]));
    show(Number(slider.value));
  }
  slider.addEventListener("input", () => { stop(); show(Number(slider.value)); });
  choice.addEventListener("change", () => choose(Number(choice.value)));
  button.addEventListener("click", () => {
    if (timer !== null) return stop();
    button.textContent = "Pause";
    timer = setInterval(() => show((Number(slider.value) + 1) % (last + 1)), 1000 / framesPerSecond);
    return undefined;
  });
  // At rest, and on paper, the most squeezed shape.
  const heights = animation.frames.map((frame) => frame.height.reduce((a, b) => Math.max(a, b), 0));
  slider.value = String(heights.indexOf(Math.min(...heights)));
  choose(chosen);
  const chooser = animation.fields.length > 0 ? element("label", { class: "field-choice" }, "Show ", choice) : null;
  const pressure = most > 0 ? element("p", { class: "note" },
    `Under the plate: contact pressure; the largest of all frames is ${threeDigits(most)} ${animation.contact.unit}.`) : null;
  return captioned("moving", animation, chooser, legend, svg,
    element("div", { class: "controls" }, button, slider, shown), pressure);
}
