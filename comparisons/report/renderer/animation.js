// An animation record: the half-section and its mirror image above the plate, with a
// slider over time. It stands still until asked to play.

const framesPerSecond = 15;

function svgElement(tag, attributes) {
  const node = document.createElementNS("http://www.w3.org/2000/svg", tag);
  for (const [name, value] of Object.entries(attributes)) node.setAttribute(name, value);
  return node;
}

/** One path for all cells; heights grow upwards, SVG's y downwards. */
function pathOfFrame(frame, cells) {
  const point = (vertex) => `${frame.radius[vertex].toPrecision(6)} ${(-frame.height[vertex]).toPrecision(6)}`;
  return cells.map((cell) => `M${cell.map(point).join("L")}Z`).join("");
}

/** 1, 2 or 5 times a power of ten, about a quarter of `length`. */
function roundLength(length) {
  const power = 10 ** Math.floor(Math.log10(length / 4));
  return [5, 2, 1].map((digit) => digit * power).find((candidate) => candidate <= length / 4);
}

function drawSection(animation) {
  const radius = animation.frames.reduce((most, frame) => frame.radius.reduce((a, b) => Math.max(a, b), most), 0);
  const height = animation.frames.reduce((most, frame) => frame.height.reduce((a, b) => Math.max(a, b), most), 0);
  const margin = 0.12 * radius;
  const half = radius + margin;
  const svg = svgElement("svg", {
    viewBox: `${-half} ${-height - margin} ${2 * half} ${height + 3.2 * margin}`, role: "img",
    "aria-label": `${animation.title}: half-section, mirrored, above the plate`,
  });
  const shape = svgElement("path", { class: "cells" });
  const mirror = svgElement("g", { transform: "scale(-1 1)" });
  const mirrored = svgElement("path", { class: "cells mirrored" });
  mirror.append(mirrored);
  const bar = roundLength(2 * radius);
  const text = svgElement("text", { x: -half + bar + 0.5 * margin, y: 1.78 * margin, "font-size": 0.5 * margin });
  text.textContent = `${bar} ${animation.length_unit}`;
  svg.append(shape, mirror,
    svgElement("rect", { class: "plate", x: -half, y: 0, width: 2 * half, height: 0.6 * margin }),
    svgElement("line", { class: "scale-bar", x1: -half + 0.1 * margin, x2: -half + 0.1 * margin + bar, y1: 1.6 * margin, y2: 1.6 * margin }),
    text);
  return { svg, paths: [shape, mirrored] };
}

function renderAnimation(animation) {
  const { svg, paths } = drawSection(animation);
  const last = animation.frames.length - 1;
  const slider = element("input", { type: "range", min: "0", max: String(last), step: "1", value: "0", "aria-label": "time" });
  const shown = element("output", { "aria-live": "off" });
  const button = element("button", { type: "button" }, "Play");
  let timer = null;

  function show(position) {
    const frame = animation.frames[position];
    const path = pathOfFrame(frame, animation.cells);
    paths.forEach((node) => node.setAttribute("d", path));
    shown.textContent = `${frame.time.toFixed(2)} ${animation.time_unit}`;
    slider.value = String(position);
    slider.setAttribute("aria-valuetext", shown.textContent);
  }
  function stop() {
    clearInterval(timer);
    timer = null;
    button.textContent = "Play";
  }
  slider.addEventListener("input", () => { stop(); show(Number(slider.value)); });
  button.addEventListener("click", () => {
    if (timer !== null) return stop();
    button.textContent = "Pause";
    timer = setInterval(() => show((Number(slider.value) + 1) % (last + 1)), 1000 / framesPerSecond);
    return undefined;
  });
  // At rest, and on paper, the most squeezed shape.
  const heights = animation.frames.map((frame) => frame.height.reduce((a, b) => Math.max(a, b), 0));
  show(heights.indexOf(Math.min(...heights)));
  return captioned("moving", animation, svg, element("div", { class: "controls" }, button, slider, shown));
}
