// One figure record, one drawing: lines, points with error bars, uncertainty bands.

const drawings = [];  // promises; the page is ready when all of them are

const manyPoints = 20;  // beyond, marks are small and pale, so that lines stay visible
const redraws = new Set();

function redrawAll() {
  redraws.forEach((redraw) => redraw());
}
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", redrawAll);

function errorBar(half_widths, colour) {
  if (half_widths.length === 0) return undefined;
  return { type: "data", array: half_widths, color: colour, thickness: 1.6, width: half_widths.length > manyPoints ? 0 : 6 };
}

/** The series as traces of the drawing library, band first so that the line is on top. */
function tracesOf(series, figure, faded) {
  const { colour, symbol } = lookOf(series);
  const opacity = faded ? 0.3 : 1;
  const traces = [];
  if (series.y_low.length > 0) {
    traces.push({
      type: "scatter", mode: "lines", fill: "toself", hoverinfo: "skip", line: { width: 0, color: colour },
      x: [...series.x, ...series.x.slice().reverse()],
      y: [...series.y_high, ...series.y_low.slice().reverse()],
      fillcolor: colour, opacity: 0.18 * opacity,
    });
  }
  const line = series.style === "line";
  const barred = series.x_error.length + series.y_error.length > 0;
  const many = !line && series.x.length > manyPoints;
  traces.push({
    type: "scatter", mode: line ? "lines" : "markers", name: drawnText(series.name),
    x: series.x, y: series.y, opacity: many ? 0.55 * opacity : opacity,
    line: { color: colour, width: series.reference ? 2.6 : 2, dash: dashOfOrigin[series.origin] },
    marker: {
      symbol: series.origin === "measured" ? symbol : `${symbol}-open`,
      size: many ? 4 : barred ? 5 : 8,  // smaller than its bar
      color: colour, line: { color: colour, width: many ? 1 : 1.8 },
    },
    error_x: errorBar(series.x_error, colour),
    error_y: errorBar(series.y_error, colour),
    hovertemplate: `%{x:.4g}${drawnText(unitSuffix(figure.x.unit))}, ` +
      `%{y:.4g}${drawnText(unitSuffix(figure.y.unit))}` +
      `<extra>${drawnText(series.name)}, ${series.origin}</extra>`,
  });
  return traces;
}

/** Ticks of a logarithmic axis: 1, 2, 5 over few decades, powers of ten over many. */
function logarithmicTicks(values) {
  const [low, high] = [Math.log10(Math.min(...values)), Math.log10(Math.max(...values))];
  if (high - low > 2.5) return { dtick: 1 };
  const ticks = [];
  for (let power = Math.floor(low) - 1; power <= Math.ceil(high); ++power) {
    for (const digit of [1, 2, 5]) ticks.push({ digit, power, value: digit * 10 ** power });
  }
  return {
    tickvals: ticks.map((tick) => tick.value),
    ticktext: ticks.map(({ digit, power, value }) =>
      (Math.abs(power) <= 2 ? String(Number(value.toPrecision(1)))
        : `${digit === 1 ? "" : `${digit}×`}10<sup>${power}</sup>`)),
  };
}

function axisLayout(axis, values) {
  return {
    title: { text: drawnText(axisText(axis)), standoff: 8 },
    type: axis.logarithmic ? "log" : "linear",
    ...(axis.logarithmic && values.length > 0 ? logarithmicTicks(values) : {}),
    automargin: true, showline: true, mirror: true, linecolor: pageColour("--axis"), ticks: "outside",
    tickcolor: pageColour("--axis"), gridcolor: pageColour("--grid"), zeroline: false, exponentformat: "power",
  };
}

const fileName = (figure) => figure.title.replace(/[^A-Za-z0-9]+/g, "-");

/** Beside the drawing library's own button, which saves SVG. */
function pngButton(figure) {
  return {
    name: "save-png", title: "Download plot as a PNG", icon: Plotly.Icons.disk,
    click: (place) => Plotly.downloadImage(place, { format: "png", filename: fileName(figure), scale: 2 }),
  };
}

function drawFigure(place, figure, hidden, highlight) {
  const shown = figure.series.filter((series) => !hidden.has(series.name));
  const traces = shown.flatMap((series) => tracesOf(series, figure,
    highlight !== "" && series.name !== highlight && !series.reference && series.origin !== "measured"));
  const layout = {
    showlegend: false, hovermode: "closest", margin: { l: 60, r: 14, t: 26, b: 48 },
    font: { family: "system-ui, sans-serif", size: 13, color: pageColour("--ink") },
    xaxis: axisLayout(figure.x, shown.flatMap((series) => series.x)),
    yaxis: axisLayout(figure.y, shown.flatMap((series) => series.y)),
    paper_bgcolor: pageColour("--page"), plot_bgcolor: pageColour("--page"),
    modebar: { bgcolor: "rgba(0,0,0,0)", color: pageColour("--axis"), activecolor: pageColour("--ink") },
  };
  const options = {
    responsive: true, displaylogo: false,
    modeBarButtonsToRemove: ["select2d", "lasso2d", "autoScale2d"], modeBarButtonsToAdd: [pngButton(figure)],
    toImageButtonOptions: { format: "svg", filename: fileName(figure) },
  };
  const drawing = Plotly.react(place, traces, layout, options);
  drawings.push(drawing);
  return drawing;
}

function describeFigure(figure) {
  const names = figure.series.map((series) => `${series.name} (${series.origin})`).join(", ");
  return `${figure.title}. ${axisText(figure.y)} against ${axisText(figure.x)}. Series: ${names}.`;
}

/**
 * Figures side by side under one legend, whose entries hide and show series in all of
 * them. show() changes what is drawn; what was hidden by name stays hidden.
 */
function figureGroup(legendPlace = "above") {
  const legend = element("div", { class: "legend", role: "group", "aria-label": "Series; press to hide or show" });
  const panels = element("div", { class: "panels" });
  const hidden = new Set();
  let drawn = [];
  let highlighted = "";

  const draw = () => drawn.forEach(({ place, figure }) => drawFigure(place, figure, hidden, highlighted));

  redraws.add(() => {
    if (drawn.length === 0) return;
    legend.replaceChildren(...entries());
    draw();
  });

  function entries() {
    const byName = new Map(drawn.flatMap(({ figure }) => figure.series.map((series) => [series.name, series])));
    return [...byName.values()].map(entry);
  }

  function entry(series) {
    const button = element("button", { type: "button", "aria-pressed": String(!hidden.has(series.name)) },
      swatch(series), element("span", {}, series.name), originTag(series.origin));
    button.addEventListener("click", () => {
      if (!hidden.delete(series.name)) hidden.add(series.name);
      button.setAttribute("aria-pressed", String(!hidden.has(series.name)));
      draw();
    });
    if (series.name === highlighted) button.classList.add("highlighted");
    return button;
  }

  function show(figures, highlight = "") {
    drawn.forEach(({ place }) => Plotly.purge(place));
    highlighted = highlight;
    drawn = figures.map((figure) => ({
      figure, place: element("div", { class: "plot", role: "img", "aria-label": describeFigure(figure) }),
    }));
    legend.replaceChildren(...entries());
    panels.replaceChildren(...drawn.map(({ figure, place }) => captioned("drawn", figure, place)));
    // The places have a width only once they are on the page.
    return draw;
  }

  const parts = legendPlace === "above" ? [legend, panels] : [panels, legend];
  return { root: element("div", { class: "figures" }, ...parts), show };
}
