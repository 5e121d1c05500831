// The report in a browser: what a reader sees, reaches and can choose.

import assert from "node:assert/strict";
import test from "node:test";
import { pagePath, withPage } from "./opened_page.mjs";

const demo = pagePath("demo.html");

const reportOf = (page) => page.evaluate(() => JSON.parse(document.getElementById("data").textContent));
const curvesOf = (page) => page.$$eval(".overlays .plot", (plots) =>
  plots.map((plot) => [...plot.querySelectorAll(".scatterlayer path.js-line")].map((path) => path.getAttribute("d")).join()));

for (const name of ["demo.html", "hostile.html"]) {
  test(`${name} is drawn without a complaint or a request`, () => withPage(pagePath(name), 1280, async ({ page, complaints, requests }) => {
    assert.equal(await page.getAttribute("html", "data-state"), "ready");
    assert.deepEqual(complaints, []);
    assert.deepEqual(requests, []);
  }));
}

test("every figure is drawn, with a unit on each axis", () => withPage(demo, 1280, async ({ page }) => {
  const plots = await page.$$eval(".plot", (places) => places.map((place) => ({
    svg: place.querySelectorAll("svg.main-svg").length,
    x: place.querySelector(".xtitle")?.textContent ?? "",
    y: place.querySelector(".ytitle")?.textContent ?? "",
    marks: place.querySelectorAll(".scatterlayer .trace").length,
  })));
  assert.equal(plots.length, 3);
  for (const plot of plots) {
    assert.ok(plot.svg > 0, "no drawing");
    assert.match(plot.x, /\S \(.+\)$/);
    assert.match(plot.y, /\S \(.+\)$/);
    assert.ok(plot.marks >= 2, "series are missing");
  }
  assert.equal(plots[0].x, "deflection (mm)");
  assert.equal(plots[0].y, "force (kN)");
}));

test("marks are those of the legend: filled where measured, open where not", () => withPage(demo, 1280, async ({ page }) => {
  const marked = await page.$$eval(".plot", (plots) => plots.flatMap((plot) => plot.data)
    .filter((trace) => trace.mode === "markers")
    .map((trace) => ({ symbol: trace.marker.symbol, measured: /, measured</.test(trace.hovertemplate) })));
  assert.ok(marked.length > 0, "no points are drawn");
  for (const { symbol, measured } of marked) {
    assert.ok(symbol, "the library's own mark");
    assert.equal(symbol.endsWith("-open"), !measured, symbol);
  }
}));

test("a click on a matrix cell shows its overlay", () => withPage(demo, 1280, async ({ page, complaints }) => {
  const before = await curvesOf(page);
  assert.equal(await page.getAttribute(".overlays", "data-shown"), "ball P/15");
  await page.click('button.cell[aria-label^="linear spring, ball Q 25 m/s"]');
  assert.equal(await page.getAttribute(".overlays", "data-shown"), "ball Q/25");
  assert.equal(await page.textContent(".overlays h3"), "ball Q at 25 m/s: linear spring brought forward");
  const after = await curvesOf(page);
  assert.equal(after.length, before.length);
  after.forEach((curve, i) => assert.notEqual(curve, before[i], "the drawing did not change"));
  const pressed = await page.$$eval('.matrix button[aria-pressed="true"]', (cells) => cells.map((cell) => cell.ariaLabel));
  assert.equal(pressed.length, 1);
  assert.match(pressed[0], /^linear spring, ball Q 25 m\/s/);
  assert.deepEqual(complaints, []);
}));

test("the matrix is reached and used by keyboard alone", () => withPage(demo, 1280, async ({ page }) => {
  for (let i = 0; i < 60; ++i) {
    await page.keyboard.press("Tab");
    if (await page.evaluate(() => document.activeElement.matches("button.cell"))) break;
  }
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("ArrowDown");
  const label = await page.evaluate(() => document.activeElement.ariaLabel);
  assert.match(label, /^Kelvin–Voigt, ζ = 0.1, ball P 15 m\/s/);
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("Enter");
  assert.equal(await page.getAttribute(".overlays", "data-shown"), "ball P/25");
}));

test("matrix cells hold a readable number beside their colour", () => withPage(demo, 1280, async ({ page }) => {
  const cells = await page.$$eval(".matrix .cell", (nodes) => nodes.map((node) => {
    const channels = (colour) => colour.match(/[\d.]+/g).slice(0, 3).map(Number);
    const luminance = (colour) => channels(colour)
      .map((c) => (c / 255 <= 0.04045 ? c / 255 / 12.92 : ((c / 255 + 0.055) / 1.055) ** 2.4))
      .reduce((sum, c, i) => sum + c * [0.2126, 0.7152, 0.0722][i], 0);
    const style = getComputedStyle(node);
    const [low, high] = [luminance(style.color), luminance(style.backgroundColor)].sort((a, b) => a - b);
    return { text: node.textContent, colour: style.backgroundColor, contrast: (high + 0.05) / (low + 0.05) };
  }));
  assert.equal(cells.length, 18);
  for (const cell of cells) {
    assert.match(cell.text, /^([+-]\d+\.\d|not run)$/);
    assert.ok(cell.contrast >= 4.5, `${cell.text} has a contrast of ${cell.contrast.toFixed(2)}`);
  }
  assert.ok(new Set(cells.map((cell) => cell.colour)).size > 5, "the colours do not follow the values");
}));

test("the legend hides a series in all figures of its group", () => withPage(demo, 1280, async ({ page }) => {
  const traces = () => page.$$eval(".overlays .plot", (plots) => plots.map((plot) => plot.querySelectorAll(".scatterlayer .trace").length));
  const before = await traces();
  await page.click('.overlays .legend button:has-text("linear spring")');
  assert.deepEqual(await traces(), before.map((count) => count - 1));
}));

test("the half-section moves with the slider and by itself", () => withPage(demo, 1280, async ({ page, complaints }) => {
  const shape = () => page.getAttribute(".moving .cells", "d");
  assert.equal(await page.inputValue(".moving input"), "8", "the most squeezed shape comes first");
  const squeezed = await shape();
  await page.focus(".moving input");
  await page.keyboard.press("End");
  assert.match(await page.textContent(".moving output"), /2(\.0+)? ms$/);
  assert.notEqual(await shape(), squeezed);
  for (let i = 0; i < 8; ++i) await page.keyboard.press("ArrowLeft");
  assert.equal(await shape(), squeezed);
  await page.click(".moving button");
  await page.waitForFunction((before) => document.querySelector(".moving .cells").getAttribute("d") !== before, squeezed);
  assert.deepEqual(complaints, []);
}));

test("the half-section is coloured by the chosen field, over one range", () => withPage(demo, 1280, async ({ page, complaints }) => {
  const coloured = () => page.$$eval(".moving .coloured", (paths) =>
    paths.map((path) => path.getAttribute("d")).filter(Boolean).length);
  const legend = () => page.textContent(".moving .legend-place");
  assert.deepEqual(await page.$$eval(".moving select option", (options) => options.map((option) => option.textContent)),
    ["made-up stress", "made-up depth", "shape only"]);
  assert.equal(await page.getAttribute(".moving label", "class"), "field-choice");
  assert.match(await legend(), /made-up stress \(MPa\)012/);
  // Ten rings, each of one value, on both sides of the axis.
  assert.equal(await coloured(), 20);
  await page.focus(".moving input");
  await page.keyboard.press("Home");
  assert.equal(await coloured(), 2, "at rest every cell has the first colour");
  assert.match(await legend(), /made-up stress \(MPa\)012/);
  // By keyboard alone: the next option.
  await page.focus(".moving select");
  await page.keyboard.press("ArrowDown");
  assert.match(await legend(), /made-up depth \(mm\)-101/);
  assert.ok(await coloured() >= 40);
  const cells = () => page.$eval(".moving .cells", (path) => getComputedStyle(path).fill);
  assert.equal(await cells(), "none");
  await page.keyboard.press("ArrowDown");
  assert.equal(await coloured(), 0);
  assert.equal(await legend(), "");
  assert.notEqual(await cells(), "none");
  assert.deepEqual(complaints, []);
}));

test("the contact pressure hangs under the plate and follows time", () => withPage(demo, 1280, async ({ page }) => {
  const depth = () => page.$eval(".contact-pressure", (path) => path.getBBox().height);
  const squeezed = await depth();
  assert.ok(squeezed > 0);
  assert.match(await page.textContent(".moving .note"), /largest of all frames is 3 MPa/);
  await page.focus(".moving input");
  for (let i = 0; i < 4; ++i) await page.keyboard.press("ArrowLeft");
  assert.ok(Math.abs(await depth() / squeezed - Math.SQRT1_2) < 1e-3);
  await page.keyboard.press("Home");
  assert.equal(await depth(), 0);
}));

test("the half-section pauses where it is", () => withPage(demo, 1280, async ({ page }) => {
  const place = () => page.inputValue(".moving input");
  await page.click(".moving button");
  assert.equal(await page.textContent(".moving button"), "Pause");
  await page.waitForFunction(() => document.querySelector(".moving input").value !== "8");
  await page.click(".moving button");
  const paused = await place();
  await page.waitForTimeout(300);
  assert.equal(await place(), paused);
  assert.equal(await page.textContent(".moving button"), "Play");
}));

test("folded sections open and show their text", () => withPage(demo, 1280, async ({ page }) => {
  assert.equal(await page.isVisible("pre"), false);
  await page.click("section:last-of-type summary");
  assert.equal(await page.isVisible("pre"), true);
}));

test("a finding and its evidence share one box", () => withPage(demo, 1280, async ({ page }) => {
  assert.match(await page.textContent(".notice-failure"), /20 % low\.\s*Measured 3\.1 mm/);
}));

test("a press on a heading sorts by number, a second one the other way", () => withPage(demo, 1280, async ({ page }) => {
  const table = '.overlays table[aria-label="Restitution"]';
  const values = () => page.$$eval(`${table} tbody tr`, (rows) => rows.map((row) => Number(row.children[1].textContent)));
  await page.click(`${table} th:nth-child(2) .sort`);
  const rising = await values();
  assert.ok(rising.length >= 3 && rising.every((value, i) => i === 0 || rising[i - 1] <= value), rising.join());
  assert.equal(await page.getAttribute(`${table} th:nth-child(2)`, "aria-sort"), "ascending");
  await page.focus(`${table} th:nth-child(2) .sort`);
  await page.keyboard.press("Enter");
  assert.deepEqual(await values(), [...rising].reverse());
}));

test("a table is copied as comma-separated values", () => withPage(demo, 1280, async ({ page }) => {
  await page.evaluate(() => {
    Object.defineProperty(navigator, "clipboard", { value: { writeText: async (text) => { window.copied = text; } } });
  });
  await page.click('button[aria-label="Copy as CSV: Restitution"]');
  const lines = (await page.evaluate(() => window.copied)).trimEnd().split("\n");
  assert.equal(lines[0], "law,restitution (–),reference (–)");
  assert.equal(lines[1], "linear spring,1.00,0.582 ± 0.012");
  assert.match(lines[2], /^"Kelvin–Voigt, ζ = 0\.1",/);
}));

test("a negative number has a minus in its table and a hyphen in its copy", () => withPage(demo, 1280, async ({ page }) => {
  const title = "Checks that were not fitted";
  assert.equal(await page.textContent(`table[aria-label="${title}"] tbody tr:last-child td:nth-child(3)`), "−1.2e−07");
  await page.evaluate(() => {
    Object.defineProperty(navigator, "clipboard", { value: { writeText: async (text) => { window.copied = text; } } });
  });
  await page.click(`button[aria-label="Copy as CSV: ${title}"]`);
  assert.match((await page.evaluate(() => window.copied)).trimEnd().split("\n").at(-1), /,-1\.2e-07,/);
}));

test("the page is dark where the reader's screen is, and light on paper", () => withPage(demo, 1280, async ({ page, complaints }) => {
  const look = () => page.evaluate(() => {
    const light = (colour) => Math.min(...colour.match(/\d+/g).slice(0, 3).map(Number));
    return [light(getComputedStyle(document.body).backgroundColor),
      light(document.querySelector(".plot .main-svg").style.background)];
  });
  assert.deepEqual(await look(), [255, 255]);
  await page.emulateMedia({ colorScheme: "dark" });
  await page.waitForFunction(() => document.querySelector(".plot .main-svg").style.background.includes("20, 25, 30"));
  assert.ok((await look()).every((channel) => channel < 60));
  await page.evaluate(() => window.dispatchEvent(new Event("beforeprint")));
  await page.waitForFunction(() => document.querySelector(".plot .main-svg").style.background.includes("255, 255, 255"));
  assert.deepEqual(await look(), [255, 255]);
  assert.equal(await page.$$eval("details:not([open])", (all) => all.length), 0, "folded text is not printed");
  assert.deepEqual(complaints, []);
}));

for (const name of ["demo.html", "hostile.html"]) {
  test(`${name} fits a telephone`, () => withPage(pagePath(name), 390, async ({ page, complaints }) => {
    await page.$$eval("details", (all) => all.forEach((details) => { details.open = true; }));
    const widths = await page.evaluate(() => [document.documentElement.scrollWidth, document.documentElement.clientWidth]);
    assert.ok(widths[0] <= widths[1], `the page is ${widths[0]} px wide on ${widths[1]} px`);
    const outside = await page.$$eval(".plot svg.main-svg", (drawings) =>
      drawings.filter((drawing) => drawing.getBoundingClientRect().right > window.innerWidth).length);
    assert.equal(outside, 0, "a drawing leaves the page");
    assert.deepEqual(complaints, []);
  }));
}

test("text that looks like markup is shown as text", () => withPage(pagePath("hostile.html"), 1280, async ({ page }) => {
  const name = "</script><img src=x onerror=alert(1)>&amp;%{x}{{data}}<b>";
  assert.equal(await page.locator("img").count(), 0);
  assert.equal(await page.locator("#page b").count(), 0);
  assert.ok((await page.textContent(".headline")).includes(name));
  const report = await reportOf(page);
  assert.equal(report.sections[0].blocks[0].columns[0].group, name);
}));
