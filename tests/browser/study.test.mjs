// The report of the main job, made at test time on meshes too coarse to believe.

import assert from "node:assert/strict";
import test from "node:test";
import { pagePath, withPage } from "./opened_page.mjs";

const study = pagePath("study/report.html");

test("the study's report is drawn without a complaint or a request", () => withPage(study, 1280, async ({ page, complaints, requests }) => {
  assert.equal(await page.getAttribute("html", "data-state"), "ready");
  assert.deepEqual(complaints, []);
  assert.deepEqual(requests, []);
  const titles = await page.$$eval(".plot", (places) => places.flatMap((place) =>
    [".xtitle", ".ytitle"].map((title) => place.querySelector(title)?.textContent ?? "missing")));
  assert.ok(titles.length >= 4);
  for (const title of titles) assert.match(title, /\S \(.+\)$/);
}));

test("every linked cell of the study's matrices shows its impact", () => withPage(study, 1280, async ({ page, complaints }) => {
  const cells = await page.$$(".matrix button.cell");
  assert.ok(cells.length >= 9, `${cells.length} cells lead to an overlay`);
  const shown = new Set();
  for (const cell of cells) {
    await cell.click();
    assert.equal(await cell.getAttribute("aria-pressed"), "true");
    shown.add(await page.getAttribute(".overlays", "data-shown"));
  }
  assert.equal(shown.size, 3, "core A was shot at three speeds");
  assert.deepEqual(complaints, []);
}));

test("nothing that is drawn as measured is a line", () => withPage(study, 1280, async ({ page }) => {
  const report = await page.evaluate(() => JSON.parse(document.getElementById("data").textContent));
  const blocks = report.sections.flatMap((section) => section.blocks);
  const figures = blocks.flatMap((block) => (block.kind === "overlays" ? block.items.flatMap((item) => item.figures)
    : block.kind === "figure" ? [block] : []));
  const measured = figures.flatMap((figure) => figure.series).filter((series) => series.origin === "measured");
  assert.ok(measured.length > 0);
  for (const series of measured) assert.equal(series.style, "points", series.name);
}));

test("the study's report fits a telephone", () => withPage(study, 390, async ({ page, complaints }) => {
  await page.$$eval("details", (all) => all.forEach((details) => { details.open = true; }));
  const widths = await page.evaluate(() => [document.documentElement.scrollWidth, document.documentElement.clientWidth]);
  assert.ok(widths[0] <= widths[1], `the page is ${widths[0]} px wide on ${widths[1]} px`);
  assert.deepEqual(complaints, []);
}));

test("the deepest impact shows its stress", () => withPage(study, 1280, async ({ page, complaints }) => {
  const names = await page.$$eval(".moving select option", (options) => options.map((option) => option.textContent));
  assert.ok(names.includes("von Mises stress") && names.includes("shape only"), names.join());
  assert.ok(await page.$$eval(".moving .coloured", (paths) => paths.filter((path) => path.getAttribute("d")).length) > 20);
  assert.deepEqual(complaints, []);
}));
