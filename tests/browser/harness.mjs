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
export async function open(browser, { viewport = DESKTOP, dark = false, calm = false, touch = false, scripts = true } = {}) {
  const context = await browser.newContext({
    viewport,
    colorScheme: dark ? "dark" : "light",
    reducedMotion: calm ? "reduce" : "no-preference",
    hasTouch: touch,
    javaScriptEnabled: scripts,
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

/** A page that holds replays as the report's pages do: data in the page, one script, the same policy. `attributes`: of each box. */
export function html(replays, attributes = "") {
  const script = readFileSync(join(dist, "replay.js"), "utf8");
  const style = readFileSync(join(dist, "replay.css"), "utf8");
  const own = ":root{color-scheme:light dark}body{margin:0 auto;padding:0 1rem;max-width:74rem;background:#fff}@media (prefers-color-scheme:dark){body{background:#14181b}}";
  const policy = `default-src 'none'; script-src ${hash(script)}; style-src 'unsafe-inline'; img-src data:; base-uri 'none'; form-action 'none'`;
  const boxes = [replays].flat().map((data) => `<div class="replay" ${attributes}><p class="replay-static">A picture without scripts.</p><script type="application/json" class="replay-data">${JSON.stringify(data).replaceAll("<", "\\u003c")}</script></div>`);
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

/** Opens a page at `address`, hands it to `act`, and fails for any complaint or any request that left the machine. */
export async function visit(browser, address, options, act) {
  const page = await open(browser, options);
  try {
    await page.goto(address);
    await act(page);
    page.assertQuiet();
  } finally {
    await page.context().close();
  }
}

/** The mounted component of a page, once it has drawn. */
export async function mounted(page) {
  await page.waitForSelector(".rp[data-drawn]", { state: "attached", timeout: 60_000 });
  await settled(page);
  return page.locator(".rp").first();
}

/** Waits until the picture shows the time of a clock that rests. */
export async function settled(page) {
  await page.waitForFunction(() => {
    const element = document.querySelector(".rp");
    return element?.dataset.drawn === element?.dataset.time && element?.dataset.playing === "false" && element.dataset.pending !== "true";
  });
}

/** Moves the scrubber to a time as a reader's hand does. */
export async function scrub(page, time) {
  await page.locator(".rp-scrub").first().evaluate((element, value) => {
    element.value = String(value);
    element.dispatchEvent(new Event("input", { bubbles: true }));
  }, time);
  await settled(page);
}

/** The table of where the balls are: by ball, then by column. */
export async function readout(page) {
  return page.locator(".rp-readout table").first().evaluate((table) => {
    const heads = [...table.tHead.rows[0].cells].map((cell) => cell.textContent.split(",")[0]);
    return Object.fromEntries([...table.tBodies[0].rows].map((row) => [row.dataset.ball, Object.fromEntries(heads.map((head, i) => [head, row.cells[i].textContent]))]));
  });
}

/** The picture of the table as bytes of a PNG, once two in a row are the same: nothing moves any more. */
export async function pixels(page) {
  await settled(page);
  let before = await page.locator(".rp-picture").first().screenshot();
  for (let i = 0; i < 20; i += 1) {
    const now = await page.locator(".rp-picture").first().screenshot();
    if (now.equals(before)) {
      return now;
    }
    before = now;
  }
  throw new Error("the picture of a time that rests does not come to rest");
}

/** A picture of a page or an element, if SCREENSHOTS names a folder. */
export async function picture(target, name, options = {}) {
  const folder = process.env.SCREENSHOTS;
  if (folder) {
    mkdirSync(folder, { recursive: true });
    await target.screenshot({ path: join(folder, `${name}.png`), ...options });
  }
}

/** Modules of the client for tests without a browser: bundled into memory, imported. */
export async function modules(...names) {
  const { buildSync } = createRequire(join(client, "package.json"))("esbuild");
  const entry = names.map((name) => `export * from "./${name}.ts";`).join("\n");
  const { outputFiles } = buildSync({ stdin: { contents: entry, resolveDir: join(client, "src") }, bundle: true, format: "esm", target: "es2022", write: false });
  return import(`data:text/javascript;base64,${Buffer.from(outputFiles[0].text).toString("base64")}`);
}
