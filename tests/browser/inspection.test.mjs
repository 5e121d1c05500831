// The page of an inspection, made at test time from a synthetic experiment, and that of a comparison.

import assert from "node:assert/strict";
import test from "node:test";
import { pagePath, withPage } from "./opened_page.mjs";

for (const [name, plots] of [["inspection", 4], ["comparison", 3]]) {
  const path = pagePath(`${name}/report.html`);

  test(`the page of an ${name} is drawn without a complaint or a request`, () => withPage(path, 1280, async ({ page, complaints, requests }) => {
    assert.equal(await page.getAttribute("html", "data-state"), "ready");
    assert.ok(await page.locator(".plot").count() >= plots, `${await page.locator(".plot").count()} plots`);
    assert.deepEqual(complaints, []);
    assert.deepEqual(requests, []);
  }));

  test(`axes of the ${name} carry their units`, () => withPage(path, 1280, async ({ page }) => {
    const titles = await page.$$eval(".xtitle, .ytitle", (nodes) => nodes.map((node) => node.textContent));
    assert.ok(titles.length >= 2 * plots, titles.join("; "));
    for (const title of titles) assert.match(title, /\(.+\)$/);
  }));

  test(`the page of an ${name} fits a telephone`, () => withPage(path, 390, async ({ page, complaints }) => {
    const widths = await page.evaluate(() => [document.documentElement.scrollWidth, document.documentElement.clientWidth]);
    assert.ok(widths[0] <= widths[1], `the page is ${widths[0]} px wide on ${widths[1]} px`);
    assert.deepEqual(complaints, []);
  }));
}
