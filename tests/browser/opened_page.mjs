// A report opened in Debian's Chromium, with everything it complained about or asked for.

import { after } from "node:test";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { chromium } from "playwright-core";

const executablePath = process.env.REBOUND_CHROMIUM;
const pages = process.env.REBOUND_PAGES;
if (!executablePath || !pages) throw new Error("REBOUND_CHROMIUM and REBOUND_PAGES are set by CTest");

export function pagePath(name) {
  return join(pages, name);
}

// One browser for all tests of a file, its profile new; each page has a context of its own.
const browser = await chromium.launch({
  executablePath,
  headless: true,
  args: ["--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run",
    "--disable-background-networking", "--disable-component-update", "--disable-sync"],
});
after(() => browser.close());

/**
 * Opens `file` at that width until the report says that it is drawn, calls use(page) and
 * closes. `complaints` are console errors and uncaught exceptions, `requests` every
 * address asked for beside the file itself.
 */
export async function withPage(file, width, use) {
  const context = await browser.newContext({ viewport: { width, height: 900 } });
  try {
    const page = await context.newPage();
    const complaints = [];
    const requests = [];
    const address = pathToFileURL(file).href;
    page.on("console", (message) => { if (message.type() === "error") complaints.push(message.text()); });
    page.on("pageerror", (error) => complaints.push(String(error)));
    page.on("dialog", (dialog) => { complaints.push(`dialog: ${dialog.message()}`); dialog.dismiss(); });
    page.on("request", (request) => {
      const asked = request.url();
      if (asked !== address && !asked.startsWith("data:") && !asked.startsWith("blob:")) requests.push(asked);
    });
    await page.goto(address);
    await page.waitForSelector('html:not([data-state="loading"])', { state: "attached", timeout: 20000 })
      .catch((error) => { throw new Error(`${error.message}\n${complaints.join("\n")}`); });
    await use({ page, complaints, requests });
  } finally {
    await context.close();
  }
}
