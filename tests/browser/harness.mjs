// A browser for tests: headless Chromium, a page that holds a replay as the report's pages do, and a watch over what it asks for
// and complains of.
import { mkdirSync, readFileSync } from "node:fs";
import { createServer } from "node:http";
import { createRequire } from "node:module";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { createHash } from "node:crypto";

const here = dirname(fileURLToPath(import.meta.url));
export const client = join(here, "../../src/client");
// the client's own packages, wherever the tests are called from
const { chromium } = createRequire(join(client, "package.json"))("playwright-core");

/** Built files to test: those that are checked in, or another folder. */
const dist = process.env.CAROM_DIST ?? join(client, "dist");

export const DESKTOP = { width: 1280, height: 800 };
export const PHONE = { width: 390, height: 844 };

/** Chromium without any traffic of its own; `webgl: false`: as on a machine without graphics. */
export async function launch({ webgl = true } = {}) {
  const graphics = webgl ? ["--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist"] : ["--disable-gpu", "--disable-3d-apis"];
  return chromium.launch({
    executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
    args: ["--no-sandbox", "--disable-quic", "--no-first-run", "--disable-background-networking", "--disable-component-update", "--disable-sync", ...graphics],
  });
}

/** A page that fails the test for every complaint and every request that leaves the machine: `assertQuiet` says so. */
export async function open(browser, { viewport = DESKTOP, dark = false, calm = false, touch = false } = {}) {
  const context = await browser.newContext({
    viewport,
    colorScheme: dark ? "dark" : "light",
    reducedMotion: calm ? "reduce" : "no-preference",
    hasTouch: touch,
  });
  const page = await context.newPage();
  const complaints = [];
  page.on("console", (message) => {
    if (message.type() === "error" || message.type() === "warning") {
      complaints.push(`console ${message.type()}: ${message.text()}`);
    }
  });
  page.on("pageerror", (error) => complaints.push(`error: ${error.message}`));
  await page.route(/.*/, (route) => {
    const url = new URL(route.request().url());
    if (["file:", "data:", "about:"].includes(url.protocol) || ["127.0.0.1", "localhost", "[::1]"].includes(url.hostname)) {
      return route.continue();
    }
    complaints.push(`request to ${url.href}`);
    return route.abort();
  });
  page.assertQuiet = () => {
    // what software rendering says of itself is not ours
    const ours = complaints.filter((line) => !/GPU stall due to ReadPixels|GL Driver Message|Automatic fallback to software WebGL/.test(line));
    if (ours.length > 0) {
      throw new Error(ours.join("\n"));
    }
  };
  return page;
}

const hash = (text) => `'sha256-${createHash("sha256").update(text).digest("base64")}'`;

/** A page that holds replays as the report's pages do: data in the page, one script, the same policy. */
export function html(...replays) {
  const script = readFileSync(join(dist, "replay.js"), "utf8");
  const style = readFileSync(join(dist, "replay.css"), "utf8");
  const own = ":root{color-scheme:light dark}body{margin:0 auto;padding:0 1rem;max-width:74rem;background:#fff}@media (prefers-color-scheme:dark){body{background:#14181b}}";
  const policy = `default-src 'none'; script-src ${hash(script)}; style-src 'unsafe-inline'; img-src data:; base-uri 'none'; form-action 'none'`;
  const boxes = replays.map((data) => `<div class="replay"><p class="replay-static">A picture without scripts.</p><script type="application/json" class="replay-data">${JSON.stringify(data).replaceAll("<", "\\u003c")}</script></div>`);
  return `<!doctype html><html lang="en"><head><meta charset="utf-8"><meta http-equiv="Content-Security-Policy" content="${policy}"><meta name="viewport" content="width=device-width, initial-scale=1"><title>replay</title><link rel="icon" href="data:,"><style>${style}${own}</style></head><body>${boxes.join("\n")}<script>${script}</script></body></html>`;
}

/** Serves pages by path on the loopback until closed; `url(path)`. */
export async function serve(pages) {
  const server = createServer((request, response) => {
    const body = pages[request.url];
    response.writeHead(body === undefined ? 404 : 200, { "content-type": "text/html; charset=utf-8" });
    response.end(body ?? "nothing here");
  });
  await new Promise((resolve) => server.listen(0, "127.0.0.1", resolve));
  return { url: (path) => `http://127.0.0.1:${server.address().port}${path}`, close: () => new Promise((resolve) => server.close(resolve)) };
}

/** The mounted component of a page, once it has drawn. */
export async function mounted(page) {
  const component = page.locator(".rp[data-drawn]").first();
  await component.waitFor({ timeout: 30_000 });
  return component;
}

/** Waits until the picture shows the time of the clock. */
export async function settled(page) {
  await page.waitForFunction(() => {
    const element = document.querySelector(".rp");
    return element?.dataset.drawn === element?.dataset.time && element?.dataset.playing === "false";
  });
}

/** A picture of the page or of an element, if SCREENSHOTS names a folder. */
export async function picture(target, name, options = {}) {
  const folder = process.env.SCREENSHOTS;
  if (folder) {
    mkdirSync(folder, { recursive: true });
    await target.screenshot({ path: join(folder, `${name}.png`), ...options });
  }
}
