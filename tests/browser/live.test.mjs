// The live page in a browser, served by the program itself.
import assert from "node:assert/strict";
import { execFileSync, spawn } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { contrasts } from "./contrast.mjs";
import { launch, PHONE, picture, visit } from "./harness.mjs";
import { program } from "./program.mjs";

const carom = program();
let browser;
let folder;
let server;
let address;

before(async () => {
  folder = mkdtempSync(join(tmpdir(), "carom-live-"));
  browser = await launch();
  server = spawn(carom, ["play", "--no-open", "--port", "0"], { stdio: ["ignore", "pipe", "inherit"] });
  address = await new Promise((resolve, reject) => {
    server.stdout.once("data", (line) => resolve(/http:\S+/.exec(String(line))[0]));
    server.once("exit", (code) => reject(new Error(`carom play ended with ${code}`)));
  });
});

after(async () => {
  await browser?.close();
  server?.kill("SIGINT");
  rmSync(folder, { recursive: true, force: true });
});

/** The page at a path of the server. */
const at = (path, options, act) => visit(browser, new URL(path, address).href, options, act);

const FIVE = { mass: "0.12", force: "118", gravity: "9.7", friction: "0.22", angle: "89.6" };

async function fill(page, fields) {
  for (const [name, value] of Object.entries(fields)) {
    await page.locator(`#shot [name="${name}"]:not([type=hidden])`).fill(value);
  }
}

const value = (page, name) => page.locator(`#shot [name="${name}"]:not([type=hidden])`).inputValue();

/** Presses Start and waits for the answer. */
async function run(page) {
  await page.getByRole("button", { name: "Start" }).click();
  await page.locator("#status", { hasText: "Answered in" }).waitFor({ timeout: 60_000 });
}

/** The comparison table as shown: heading row, then one row an engine. */
const table = (page) => page.locator("#answer table").first().evaluate((element) => [...element.querySelectorAll("tr")].map((row) => [...row.children].map((cell) => cell.textContent.trim())));

/** What `carom compare --format json` prints of a scene file. */
function compared(file) {
  return JSON.parse(execFileSync(carom, ["compare", file, "--format", "json"], { encoding: "utf8" }));
}

/** Saves the scene of the page, and answers the file. */
async function saved(page) {
  const [download] = await Promise.all([page.waitForEvent("download"), page.getByRole("button", { name: /Save/ }).click()]);
  const file = join(folder, `${Date.now()}-${download.suggestedFilename()}`);
  await download.saveAs(file);
  return file;
}

/** Holds a number as shown, `1.69`, against the number itself: half a unit of its last digit. */
function sameNumber(shown, exact, what) {
  const digits = /^-?\d+(?:\.(\d+))?(?:e(-?\d+))?$/.exec(shown);
  assert.ok(digits, `${what}: ${shown} is no number`);
  const unit = 10 ** (Number(digits[2] ?? 0) - (digits[1]?.length ?? 0));
  assert.ok(Math.abs(Number(shown) - exact) <= 0.5 * unit * (1 + 1e-9), `${what}: shown ${shown}, printed ${exact}`);
}

/** The words that describe a control and are errors. */
const errorOf = (page, name) =>
  page.locator(`#shot [name="${name}"]:not([type=hidden])`).evaluate((element) => {
    const described = (element.getAttribute("aria-describedby") ?? "").split(" ").map((id) => document.getElementById(id));
    return { invalid: element.getAttribute("aria-invalid"), words: described.find((words) => words?.className === "error")?.textContent ?? "" };
  });

test("the five inputs run in all engines and give the numbers of carom compare", () =>
  at("/", {}, async (page) => {
    await fill(page, FIVE);
    await run(page);
    const rows = (await table(page)).slice(1);
    const printed = compared(await saved(page)).tables.comparison.rows;
    assert.deepEqual(rows.map((row) => row[0]), printed.map((row) => row.engine));
    assert.ok(printed.length >= 5);
    let numbers = 0;
    printed.forEach((row, i) => {
      const [, stop, final, strict] = rows[i];
      for (const [key, shown] of [["stop-time", stop], ["final-position", final]]) {
        if (row[key] === null) {
          assert.equal(shown, "–");
          continue;
        }
        const [number, owner] = shown.split(" ");
        sameNumber(number, row[key], `${key} of ${row.engine}`);
        assert.equal(owner, `(${row[`${key}-owner`]})`);
        numbers += 1;
      }
      assert.equal(strict, row["order-strict"] ?? "–");
    });
    assert.ok(numbers >= 8, `${numbers} numbers`);
    await picture(page, "live-desktop", { fullPage: true });
  }));

test("the shot plays as soon as it is answered, and its graphs grow", () =>
  at("/", {}, async (page) => {
    await run(page);
    const replay = page.locator(".rp[data-drawn]");
    await replay.waitFor({ timeout: 60_000 });
    assert.equal(await page.locator(".rp-run").count(), 5);
    const time = () => replay.evaluate((element) => Number(element.dataset.time));
    const first = await time();
    await page.waitForFunction((first) => Number(document.querySelector(".rp").dataset.time) > first + 0.1, first);
    assert.equal(await replay.getAttribute("data-playing"), "true");
    // the picture of the start has made room
    assert.equal(await page.locator(".at-start").isVisible(), false);
  }));

test("whoever asked for less motion starts it himself", () =>
  at("/?scene=three-ball", { calm: true }, async (page) => {
    await run(page);
    const replay = page.locator(".rp[data-drawn]");
    await replay.waitFor({ timeout: 60_000 });
    assert.equal(await replay.getAttribute("data-playing"), "false");
  }));

test("what is wrong stands at its field, which has the focus, and goes when it is mended", () =>
  at("/", {}, async (page) => {
    await fill(page, { friction: "-0.2" });
    await page.getByRole("button", { name: "Start" }).click();
    await page.locator("#f-friction[aria-invalid=true]").waitFor();
    const error = await errorOf(page, "friction");
    assert.match(error.words, /finite number, 0 or greater.*typically 0\.2/);
    assert.equal(await page.evaluate(() => document.activeElement.id), "f-friction");
    assert.match(await page.locator("#status").textContent(), /wrong/);
    assert.equal(await page.locator("#answer table").count(), 0, "something ran");
    await picture(page, "live-error");
    await page.locator("#f-friction").fill("0.3");
    await page.locator("#f-friction:not([aria-invalid])").waitFor();
    assert.equal(await page.locator(".error").count(), 0);
    await run(page);
  }));

test("an error in a part that is closed opens it", () =>
  at("/", {}, async (page) => {
    await page.locator("#f-Engines > summary").click();
    await page.locator("[name='dt.stepper']").fill("0");
    await page.locator("#f-Engines > summary").click();
    await page.getByRole("button", { name: "Start" }).click();
    await page.locator("[name='dt.stepper'][aria-invalid=true]").waitFor();
    assert.ok(await page.locator("[name='dt.stepper']").isVisible());
    assert.match((await errorOf(page, "dt.stepper")).words, /expected a step above 0/);
  }));

test("keys that make no number are told so", () =>
  at("/", {}, async (page) => {
    await page.locator("#f-mass").focus();
    await page.keyboard.press("Control+A");
    await page.keyboard.type("1e");
    await page.keyboard.press("Enter");
    await page.locator("#f-mass[aria-invalid=true]").waitFor();
    assert.match((await errorOf(page, "mass")).words, /Ball mass must be a number/);
  }));

test("a link carries the whole shot to another page, with scripts and without", () =>
  at("/", {}, async (page) => {
    await page.context().grantPermissions(["clipboard-read", "clipboard-write"]);
    await fill(page, FIVE);
    await page.locator("#f-Effects > summary").click();
    await page.locator("[name='effects.contact']").selectOption("inelastic");
    await page.waitForFunction(() => document.querySelector("#f-scene").value.includes("inelastic"));
    await page.getByRole("button", { name: /Copy/ }).click();
    await page.locator("#status", { hasText: "copied" }).waitFor();
    const link = await page.evaluate(() => navigator.clipboard.readText());
    assert.ok(link.startsWith(address), link);
    const file = await value(page, "scene");
    for (const scripts of [true, false]) {
      await at(link, { scripts }, async (other) => {
        for (const [name, expected] of Object.entries(FIVE)) {
          assert.equal(await value(other, name), expected, name);
        }
        assert.equal(await value(other, "scene"), file);
        assert.equal(await value(other, "effects.contact"), "inelastic");
      });
    }
  }));

test("without scripts the form is answered with a page that has the comparison and pictures", () =>
  at("/?scene=three-ball", { scripts: false }, async (page) => {
    await page.locator("#f-friction").fill("0.25");
    await page.getByRole("button", { name: "Start" }).click();
    await page.locator("#answer table").first().waitFor({ timeout: 60_000 });
    assert.ok((await table(page)).length > 4);
    assert.ok((await page.locator("#answer svg").count()) > 3);
    assert.equal(await value(page, "friction"), "0.25");
    await picture(page, "live-without-scripts");
  }));

test("only the fields of the laws that are chosen are shown", () =>
  at("/", { scripts: false }, async (page) => {
    await page.locator("#f-Effects > summary").click();
    const height = page.locator("[name='effects.cushion.han-2005.height']");
    assert.equal(await height.isVisible(), false);
    await page.locator("[name='effects.cushion']").selectOption("han-2005");
    assert.equal(await height.isVisible(), true);
    assert.equal(await height.inputValue(), "1.28");
    assert.equal(await page.locator(".unused-f-friction").isVisible(), false);
    await page.locator("[name='effects.cloth']").selectOption("none");
    assert.equal(await page.locator(".unused-f-friction").isVisible(), true);
  }));

test("effects are switched on and run, and an engine that lacks one says so", () =>
  at("/?scene=three-ball", {}, async (page) => {
    await page.locator("#f-Effects > summary").click();
    await page.locator("[name='effects.cloth']").selectOption("rotational");
    await page.locator("[name='effects.cushion']").selectOption("han-2005");
    await run(page);
    const rows = (await table(page)).slice(1);
    assert.ok(rows.some((row) => row[0] === "rapier-f64: cannot simulate cushion.han-2005"), rows.map((row) => row[0]).join("; "));
  }));

test("a scene is saved as a file and opened again, and a broken one is told where", () =>
  at("/", {}, async (page) => {
    await fill(page, FIVE);
    await page.waitForFunction(() => document.querySelector("#f-scene").value.includes("118"));
    const file = await saved(page);
    assert.match(readFileSync(file, "utf8"), /force = 118/);
    await at("/", {}, async (other) => {
      await other.locator("#open-file").setInputFiles(file);
      await other.locator("#status", { hasText: "Opened" }).waitFor();
      for (const [name, expected] of Object.entries(FIVE)) {
        assert.equal(await value(other, name), expected, name);
      }
      const broken = join(folder, "broken.toml");
      writeFileSync(broken, readFileSync(file, "utf8").replace("[ball]", "[ball"));
      await other.locator("#open-file").setInputFiles(broken);
      await other.locator("#f-scene[aria-invalid=true]").waitFor();
      assert.match((await errorOf(other, "scene")).words, /line \d+: unclosed table/);
    });
  }));

test("the scene can be changed as a file, and the fields follow", () =>
  at("/", {}, async (page) => {
    await page.locator("#f-file > summary").click();
    const text = await value(page, "scene");
    await page.locator("#f-scene").fill(text.replace("mu = 0.2", "mu = 0.31"));
    await page.waitForFunction(() => document.querySelector("#f-friction").value === "0.31");
    await page.getByRole("button", { name: "Run this file" }).click();
    await page.locator("#status", { hasText: "Answered in" }).waitFor({ timeout: 60_000 });
    assert.match(await page.locator("#answer").textContent(), /mu 0\.31/);
  }));

test("a scene of the catalogue is opened by its name", () =>
  at("/", {}, async (page) => {
    await page.getByLabel("Scene", { exact: true }).selectOption("pool-break");
    await page.getByRole("button", { name: "Open", exact: true }).click();
    await page.locator("#status", { hasText: "Opened pool-break" }).waitFor();
    assert.equal(await value(page, "effects.cushion"), "han-2005");
    assert.equal(await value(page, "angle"), "83.932");
    await run(page);
    assert.match(await page.locator("#answer").textContent(), /6 pockets/);
    await page.locator(".rp[data-drawn]").waitFor({ timeout: 60_000 });
  }));

test("a shot that takes long can be stopped", () =>
  at("/", {}, async (page) => {
    await page.locator("#f-Engines > summary").click();
    // some minutes, if nobody stops it
    await page.locator("[name='dt.rapier-f64']").fill("1e-6");
    await page.getByRole("button", { name: "Start" }).click();
    await page.getByRole("button", { name: "Stop" }).click();
    await page.locator("#status", { hasText: "stopped" }).waitFor();
    await page.locator("[name='dt.rapier-f64']").fill("1e-3");
    await run(page);
  }));

test("the keyboard alone is enough", () =>
  at("/?scene=three-ball", {}, async (page) => {
    await page.keyboard.press("Tab");
    assert.equal(await page.evaluate(() => document.activeElement.className), "skip");
    await page.keyboard.press("Enter");
    await page.keyboard.press("Tab");
    assert.equal(await page.evaluate(() => document.activeElement.name), "mass");
    await page.keyboard.press("Control+A");
    await page.keyboard.type("0.2");
    await page.keyboard.press("Enter");
    await page.locator("#status", { hasText: "Answered in" }).waitFor({ timeout: 60_000 });
    const names = await page.locator("body").ariaSnapshot();
    assert.doesNotMatch(names, /- (button|checkbox|radio|combobox|slider|textbox|spinbutton)(:| \[|$)/m, "no control without a name");
  }));

for (const dark of [false, true]) {
  test(`words stand out ${dark ? "in the dark" : "by day"}`, () =>
    at("/", { dark }, async (page) => {
      for (const part of await page.locator(".part > summary").all()) {
        await part.click();
      }
      await page.locator("#f-friction").fill("-1");
      await page.locator("#f-friction[aria-invalid=true]").waitFor();
      const { weak, seen } = await page.evaluate(contrasts, "body");
      assert.ok(seen > 100, `only ${seen} words were looked at`);
      assert.deepEqual(weak, []);
      await picture(page, `live-${dark ? "dark" : "light"}`, { fullPage: true });
    }));
}

test("a phone shows all of it without scrolling sideways", () =>
  at("/", { viewport: PHONE, touch: true }, async (page) => {
    await picture(page, "live-phone-open", { fullPage: true });
    await run(page);
    await page.locator(".rp[data-drawn]").waitFor({ timeout: 60_000 });
    const { wide, small } = await page.evaluate(() => ({
      wide: document.documentElement.scrollWidth - window.innerWidth,
      // WCAG 2.5.8: 24 px
      small: [...document.querySelectorAll("#shot input:not([type=hidden]), #shot select, #shot button, #tools button, #tools label, .picker select, .picker button")]
        .filter((element) => element.checkVisibility() && element.type !== "checkbox")
        .map((element) => [element.id || element.textContent, element.getBoundingClientRect().height])
        .filter(([, height]) => height < 24),
    }));
    assert.equal(wide, 0);
    assert.deepEqual(small, []);
    await picture(page, "live-phone", { fullPage: true });
  }));
