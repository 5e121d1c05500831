// The report of the main job, made at test time on meshes too coarse to believe.

import assert from "node:assert/strict";
import { statSync } from "node:fs";
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

test("the first screen holds question, answer, picture and the verdicts on the measurement", () => withPage(study, 1280, async ({ page }) => {
  assert.match(await page.textContent("header .question"), /\?$/);
  const answer = await page.textContent("header .answer");
  assert.equal(answer.match(/\.(?=\s+[A-Z]|$)/g).length, 3, answer);
  assert.equal(await page.locator("header .matrix button.cell").count(), 21);
  const rows = page.locator("header .tabled tbody tr");
  assert.equal(await rows.count(), 1);
  const box = await rows.last().boundingBox();
  assert.ok(box.y + box.height <= 900, `the last verdict ends at ${box.y + box.height} px`);
}));

test("the contents are short and the page is small", () => withPage(study, 1280, async ({ page }) => {
  const entries = await page.$$eval("nav a", (links) => links.map((link) => link.textContent));
  assert.ok(entries.length <= 10, entries.join());
  assert.ok(statSync(study).size < 3e6, `${statSync(study).size} bytes`);
}));

test("the diagnosis of a core is a page of its own, and drawn", async () => {
  const links = [];
  await withPage(study, 1280, async ({ page }) => {
    links.push(...await page.$$eval("td a, th a", (all) => all.map((link) => link.getAttribute("href"))));
  });
  assert.ok(links.length >= 1);
  for (const link of links) {
    await withPage(pagePath(`study/${link}`), 390, async ({ page, complaints, requests }) => {
      assert.equal(await page.getAttribute("html", "data-state"), "ready");
      assert.deepEqual([complaints, requests], [[], []]);
      const [wide, screen] = await page.evaluate(() => [document.documentElement.scrollWidth, document.documentElement.clientWidth]);
      assert.ok(wide <= screen, `${link} is ${wide} px wide`);
    });
  }
});

test("every chart has drawn data", () => withPage(study, 1280, async ({ page }) => {
  await page.$$eval("details", (all) => all.forEach((details) => { details.open = true; }));
  const empty = await page.$$eval(".plot", (plots) => plots.filter((plot) =>
    ![...plot.querySelectorAll(".scatterlayer path")].some((path) => (path.getAttribute("d") ?? "").length > 10)).length);
  assert.equal(empty, 0);
}));

test("every linked cell of the study's matrices shows its impact", () => withPage(study, 1280, async ({ page, complaints }) => {
  await page.$$eval("details", (all) => all.forEach((details) => { details.open = true; }));
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
