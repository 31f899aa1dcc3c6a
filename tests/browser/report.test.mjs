// A page of a report in a browser, opened from its file as a reader does, against what the program prints.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { pathToFileURL } from "node:url";
import { DESKTOP, launch, mounted, PHONE, picture, pixels, readout, scrub, settled, visit } from "./harness.mjs";
import { program } from "./program.mjs";

const SCENE = "report-break";
let browser;
let folder;
let compared;

before(async () => {
  const carom = program();
  folder = mkdtempSync(join(tmpdir(), "carom-report-"));
  execFileSync(carom, ["report", SCENE, "--out", folder], { stdio: "ignore" });
  compared = JSON.parse(execFileSync(carom, ["compare", SCENE, "--format", "json"], { encoding: "utf8", stdio: ["ignore", "pipe", "ignore"], maxBuffer: 1 << 26 }));
  browser = await launch();
});

after(async () => {
  await browser?.close();
  rmSync(folder, { recursive: true, force: true });
});

const address = () => pathToFileURL(join(folder, "pages", `${SCENE}.html`)).href;

/** The page, once its replay has drawn. */
const at = (options, act) =>
  visit(browser, address(), options, async (page) => {
    await mounted(page);
    await act(page);
  });

const time = (page) => page.locator(".rp").first().evaluate((element) => Number(element.dataset.time));

/** The earliest time in the table of first differences, s, with seven digits. */
function firstDifference() {
  const cells = compared.tables["first-difference"].rows.flatMap((row) => [row.reference, row["engine-has"]]);
  const times = cells.map((cell) => / at ([0-9.]+) s$/.exec(cell)?.[1]).filter(Boolean).map(Number);
  assert.ok(times.length > 0, "nobody parts");
  return Math.min(...times);
}

test("the first screen has the verdict, the table of divergences and the picture of the first parting", () =>
  at({ calm: true }, async (page) => {
    for (const selector of [".lead", "#divergences table", ".bare .picture svg"]) {
      const box = await page.locator(selector).first().boundingBox();
      assert.ok(box && box.y >= 0 && box.y + box.height <= DESKTOP.height, `${selector} at ${JSON.stringify(box)}`);
    }
    assert.equal(await page.locator(".lead").innerText().then((text) => text.replaceAll("\u00a0", " ")), compared.lead);
    await picture(page, "report-first-screen");
  }));

test("the shot plays from a file without any other place", () =>
  at({}, async (page) => {
    await page.locator(".rp-play").click();
    await page.waitForFunction(() => Number(document.querySelector(".rp").dataset.time) > 0);
    await page.locator(".rp-play").click();
    await settled(page);
    const reached = await time(page);
    assert.ok(reached > 0, `the clock stands at ${reached}`);
    assert.match(page.url(), /^file:/);
  }));

test("scrubbing moves the balls to where the table of the page has them in the end", () =>
  at({ calm: true }, async (page) => {
    const start = await readout(page);
    const before = await pixels(page);
    const end = await page.locator(".rp-scrub").first().evaluate((element) => Number(element.max));
    await scrub(page, end);
    assert.ok(!(await pixels(page)).equals(before), "the picture has not changed");
    const now = await readout(page);
    const solid = await page.locator(".rp").first().getAttribute("data-solid");
    const rows = await page.locator(`#balls-${SCENE} tbody tr`).evaluateAll((all) => all.map((row) => [...row.cells].map((cell) => cell.textContent)));
    const finals = rows.filter(([, engine]) => engine === solid);
    assert.equal(finals.length, 16);
    let moved = 0;
    for (const [ball, , , x, y] of finals) {
      for (const [axis, value] of [["x", x], ["y", y]]) {
        const shown = now[ball][axis];
        const digits = shown.split(".")[1]?.length ?? 0;
        // half of the last digit shown, and f32 of a place within 128 radii of the origin
        const bound = 0.5 * 10 ** -digits + 128 * 2 ** -24 + 0.5e-6;
        assert.ok(Math.abs(Number(shown) - Number(value)) <= bound, `${ball}: ${axis} is ${shown}, the table has ${value}`);
        moved += shown === start[ball][axis] ? 0 : 1;
      }
    }
    assert.ok(moved > 16, `only ${moved} numbers moved`);
  }));

test("the jump lands on the first difference that compare prints", () =>
  at({ calm: true }, async (page) => {
    await page.locator(".rp-jump").click();
    await settled(page);
    const expected = firstDifference();
    const landed = await time(page);
    // seven digits are printed, and the clock of the knots is f32
    assert.ok(Math.abs(landed - expected) <= 0.5e-7 + expected * 2 ** -24, `landed at ${landed}, compare prints ${expected}`);
    assert.match(await page.locator(".rp-banner").innerText(), /part at/);
    await picture(page, "report-parting", { fullPage: false });
  }));

test("without scripts a sentence stands in place of the replay, and the pictures remain", async () => {
  const context = await browser.newContext({ viewport: DESKTOP, javaScriptEnabled: false });
  try {
    const page = await context.newPage();
    await page.goto(address());
    assert.equal(await page.locator(".rp").count(), 0);
    assert.ok(await page.locator(".replay-static").isVisible());
    assert.ok((await page.locator("figure svg").count()) > 5, "the pictures are gone");
  } finally {
    await context.close();
  }
});

test("on paper there is no replay and there are the pictures", () =>
  at({ calm: true }, async (page) => {
    await page.emulateMedia({ media: "print" });
    assert.ok(!(await page.locator(".rp").first().isVisible()));
    assert.ok(await page.locator(".bare .picture svg").isVisible());
  }));

test("on a phone nothing is wider than the screen", () =>
  at({ viewport: PHONE, touch: true, calm: true }, async (page) => {
    const width = await page.evaluate(() => document.documentElement.scrollWidth);
    assert.ok(width <= PHONE.width, `the page is ${width} px wide`);
    await picture(page, "report-phone");
  }));
