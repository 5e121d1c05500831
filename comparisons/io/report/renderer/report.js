// The page: headline first, then the sections in the order of the record.

const levelWord = { finding: "Finding", abstention: "Not decided", warning: "Warning", failure: "Failure" };

function renderNotice(notice) {
  return element("p", { class: `notice notice-${notice.level}`, role: "note" },
    element("strong", {}, `${levelWord[notice.level]}. `), notice.text,
    notice.evidence ? element("span", { class: "evidence" }, notice.evidence) : null);
}

function renderVerbatim(verbatim) {
  return element("div", { class: "verbatim" }, element("h3", {}, verbatim.title),
    scrollBox(verbatim.title, element("pre", {}, verbatim.text)));
}

function renderLoneFigure(figure, later) {
  const group = figureGroup("below");
  later.push(group.show([figure]));
  return group.root;
}

function renderBlock(block, later) {
  switch (block.kind) {
    case "paragraph": return element("p", {}, block.text);
    case "notice": return renderNotice(block);
    case "verbatim": return renderVerbatim(block);
    case "table": return renderTable(block);
    case "figure": return renderLoneFigure(block, later);
    case "animation": return renderAnimation(block);
    case "matrix": return renderMatrix(block, chooseOverlay, onChosen);
    case "overlays": return renderOverlays(block, later);
    default: throw new Error(`unknown block "${block.kind}"`);
  }
}

function renderSection(section, position, later) {
  const id = `section-${position + 1}`;
  const heading = element("h2", {}, element("span", { class: "place" }, `${position + 1}`), section.title);
  const blocks = section.blocks.map((block) => renderBlock(block, later));
  if (section.details.length > 0) {
    blocks.push(foldedAway(element("span", {}, "Details"),
      section.details.map((block) => renderBlock(block, later))));
  }
  return element("section", { id }, ...(section.folded ? [foldedAway(heading, blocks)] : [heading, ...blocks]));
}

function foldedAway(summary, blocks) {
  const details = element("details", {}, element("summary", {}, summary), ...blocks);
  // Drawn while folded away, a figure has no width.
  details.addEventListener("toggle", () => {
    details.querySelectorAll(".plot").forEach((place) => { if (details.open) Plotly.Plots.resize(place); });
  });
  return details;
}

function contentsOf(report) {
  return element("nav", { "aria-label": "Contents" }, element("ol", {}, ...report.sections.map((section, i) =>
    element("li", {}, element("a", { href: `#section-${i + 1}` }, section.title)))));
}

function originKey() {
  return element("p", { class: "origin-key" }, "Every mark is labelled ",
    ...Object.entries(originMeaning).flatMap(([origin, meaning], i) =>
      [i > 0 ? "; " : "", originTag(origin), ` ${meaning}`]), ".");
}

function renderReport(report) {
  const later = [];
  assignLooks(report);
  const head = element("header", {}, element("h1", {}, report.title));
  if (report.subtitle) head.append(element("p", { class: "subtitle" }, report.subtitle));
  if (report.question) head.append(element("p", { class: "question" }, report.question));
  head.append(element("p", { class: report.question ? "headline answer" : "headline" }, report.headline),
    ...report.notices.map(renderNotice), ...report.lead.map((block) => renderBlock(block, later)),
    originKey(), contentsOf(report));
  const page = document.getElementById("page");
  page.append(head, ...report.sections.map((section, i) => renderSection(section, i, later)));
  return later;
}

window.addEventListener("beforeprint", () => {
  document.querySelectorAll("details").forEach((details) => { details.open = true; });
  document.documentElement.dataset.paper = "";
  redrawAll();
});
window.addEventListener("afterprint", () => {
  delete document.documentElement.dataset.paper;
  redrawAll();
});

function sayThatItFailed(error) {
  state.state = "failed";
  document.getElementById("page").prepend(
    element("p", { class: "notice notice-failure", role: "alert" }, `This report could not be drawn: ${error.message}`));
  throw error;
}

function drawAll(later) {
  try {
    later.forEach((draw) => draw());
  } catch (error) {
    sayThatItFailed(error);
  }
  Promise.all(drawings).then(() => { state.state = "ready"; }, sayThatItFailed);
}

// A report that cannot be drawn says so on the page, and its state is there for tests.
const state = document.documentElement.dataset;
try {
  const later = renderReport(JSON.parse(document.getElementById("data").textContent));
  // Text, tables and matrices are read while the drawing library, which follows, is taken in.
  window.addEventListener("load", () => requestAnimationFrame(() => setTimeout(() => drawAll(later))));
} catch (error) {
  sayThatItFailed(error);
}
