// The report of one FE impact, made at test time on a mesh too coarse to believe.

import assert from "node:assert/strict";
import test from "node:test";
import { pagePath, withPage } from "./opened_page.mjs";

const impact = pagePath("impact/report.html");

test("the impact's report is drawn without a complaint or a request", () => withPage(impact, 1280, async ({ page, complaints, requests }) => {
  assert.equal(await page.getAttribute("html", "data-state"), "ready");
  assert.equal(await page.locator(".plot").count(), 3);
  assert.deepEqual(complaints, []);
  assert.deepEqual(requests, []);
}));

test("every field of the impact can be shown, in every frame", () => withPage(impact, 1280, async ({ page, complaints }) => {
  const names = await page.$$eval(".moving select option", (options) => options.map((option) => option.textContent));
  assert.deepEqual(names, ["von Mises stress", "pressure, compression positive", "stored energy density",
    "dissipated energy density", "speed", "shape only"]);
  const frames = Number(await page.getAttribute(".moving input", "max")) + 1;
  assert.ok(frames >= 18, `${frames} frames`);
  for (const name of names.slice(0, -1)) {
    await page.selectOption(".moving select", { label: name });
    const legend = await page.textContent(".moving .legend-place");
    assert.match(legend, /\((MPa|kJ\/m³|m\/s)\)/);
    const drawn = new Set();
    await page.focus(".moving input");
    await page.keyboard.press("Home");
    for (let i = 0; i < frames; ++i) {
      drawn.add(await page.$$eval(".moving .coloured", (paths) => paths.map((path) => path.getAttribute("d")).join("|")));
      await page.keyboard.press("ArrowRight");
    }
    assert.equal(drawn.size, frames, `${name} does not move`);
    assert.equal(await page.textContent(".moving .legend-place"), legend, "the range moved");
  }
  assert.deepEqual(complaints, []);
}));

test("the impact's report fits a telephone", () => withPage(impact, 390, async ({ page, complaints }) => {
  const widths = await page.evaluate(() => [document.documentElement.scrollWidth, document.documentElement.clientWidth]);
  assert.ok(widths[0] <= widths[1], `the page is ${widths[0]} px wide on ${widths[1]} px`);
  const outside = await page.$$eval(".moving *", (nodes) =>
    nodes.filter((node) => node.getBoundingClientRect().right > window.innerWidth + 0.5).map((node) => node.tagName));
  assert.deepEqual(outside, []);
  assert.deepEqual(complaints, []);
}));
