// The replay component in a browser, on scenes whose motion is known.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { contrasts } from "./contrast.mjs";
import { DESKTOP, html, launch, mounted, open, PHONE, picture, pixels, readout, scrub, serve, settled, visit } from "./harness.mjs";
import { crowd, hit, slide, slidingBall, twoBalls } from "./scenes.mjs";

let browser;
let server;

before(async () => {
  browser = await launch();
  const damaged = slidingBall();
  damaged.runs[0].knots.counts = [3];
  // most of what is tested does not depend on how the table is drawn, and the flat picture is quicker without a graphics card
  server = await serve({
    "/slide": html(slidingBall(), "data-flat"),
    "/far": html(slidingBall([1e8, -3e7])),
    "/small": html(slidingBall([0, 0], 1e-6)),
    "/two": html(twoBalls(), "data-flat"),
    "/two-solid": html(twoBalls()),
    "/same": html(twoBalls({ partings: false }), "data-flat"),
    "/autoplay": html(twoBalls(), "data-flat data-autoplay"),
    "/growing": html(twoBalls(), "data-flat data-growing"),
    "/crowd": html(crowd(500)),
    "/pair": html([slidingBall(), twoBalls()], "data-flat"),
    "/damaged": html(damaged),
  });
});

after(async () => {
  await browser?.close();
  await server?.close();
});

/** A page of replays, once it has drawn. */
const at = (path, options, act) =>
  visit(browser, server.url(path), options, async (page) => {
    await mounted(page);
    await act(page);
  });

const time = (page) => page.locator(".rp").first().evaluate((element) => Number(element.dataset.time));
const state = (page, name) => page.locator(".rp").first().getAttribute(`data-${name}`);
const near = (got, expected, tolerance, what) => assert.ok(Math.abs(got - expected) <= tolerance, `${what}: got ${got}, expected ${expected} within ${tolerance}`);

/** Half a unit of the last digit shown, and what f32 columns lose: two roundings of a number below 64 R. */
const shown = (decimals, R) => 0.5 * 10 ** -decimals + 2 * 64 * 2 ** -24 * R;
/** Speeds are shown to five digits. */
const FIVE = 5e-5;

test("the balls are where the closed form has them, at every time", () =>
  at("/slide", {}, async (page) => {
    for (const part of [0, 0.2, 0.5, 0.9, 1]) {
      const t = part * slide.stop;
      await scrub(page, t);
      const { cue } = await readout(page);
      const decimals = cue.y.split(".")[1].length;
      assert.ok(decimals >= 5, "the table shows a thousandth of R and better");
      near(Number(cue.y), slide.y(t), shown(decimals, 0.03), `y at ${t}`);
      near(Number(cue.x), slide.x0, shown(decimals, 0.03), `x at ${t}`);
      near(Number(cue.speed), slide.speed(t), FIVE * slide.v, `speed at ${t}`);
      assert.equal(cue.state, part < 1 ? "moves" : "rests");
    }
  }));

for (const [path, scale, shift, why] of [
  ["/far", 1, [1e8, -3e7], "moved by 1e8"],
  ["/small", 1e-6, [0, 0], "a millionth of the size"],
]) {
  test(`a scene ${why} is shown as the plain one`, () =>
    at(path, {}, async (page) => {
      const plain = 0.7 * slide.stop;
      await scrub(page, plain);
      const { cue } = await readout(page);
      // numbers of this size have these digits at all
      const digits = 1.2e-7 * 2 ** -3 * (shift[0] > 0 ? 1 : 0);
      near(Number(cue.y), shift[1] + scale * slide.y(plain), shown(cue.y.split(".")[1].length, 0.03 * scale) + digits, "y");
      near(Number(cue.speed), scale * slide.speed(plain), FIVE * scale * slide.v, "speed");
      const picture = await pixels(page);
      await scrub(page, 0);
      assert.ok(!(await pixels(page)).equals(picture), "the ball is seen to move");
    }));
}

test("the scrubber moves the balls in the picture, and back to the same picture", () =>
  at("/two-solid", {}, async (page) => {
    await scrub(page, 0.2);
    const early = await pixels(page);
    await scrub(page, 1.4);
    const late = await pixels(page);
    assert.ok(!early.equals(late), "other times, other pictures");
    const { 1: one, cue } = await readout(page);
    near(Number(one.y), hit.one(1.4), shown(5, 0.03), "the ball that was hit");
    near(Number(cue.y), hit.cue(1.4), shown(5, 0.03), "the ball that hit");
    await scrub(page, 0.2);
    assert.ok((await pixels(page)).equals(early), "the same time, the same picture");
  }));

test("the jump lands on the first divergence, says it and rests there", () =>
  at("/two-solid", {}, async (page) => {
    await page.getByRole("button", { name: "Jump to the first divergence" }).click();
    await settled(page);
    assert.equal(await time(page), Math.fround(hit.time));
    assert.equal(await state(page, "parting"), "0");
    assert.match(await page.locator(".rp-banner").innerText(), /stepper dt=0\.1.*exact.*part at 0\.6400 s\. exact has cue and 1 meet; the stepper is late by a step\./s);
    assert.match(await page.getByRole("status").innerText(), /the stepper is late by a step/);
    const near = await pixels(page);
    await picture(page, "jump");
    // on from there: the words go, and so does the close look
    await scrub(page, hit.time + 0.05);
    assert.equal(await state(page, "parting"), "-1");
    assert.ok(await page.locator(".rp-banner").isHidden());
    await scrub(page, hit.time);
    assert.ok(!(await pixels(page)).equals(near), "the whole table is in view again");
  }));

test("without a divergence there is nothing to jump to, and the page says so", () =>
  at("/same", {}, async (page) => {
    assert.equal(await page.getByRole("button", { name: /divergence/ }).count(), 0);
    assert.ok(await page.getByText("No collision order differs").isVisible());
    await page.locator(".rp-picture").focus();
    await page.keyboard.press("d");
    assert.match(await page.getByRole("status").innerText(), /no collision order differs/);
    assert.equal(await time(page), 0);
  }));

test("the keyboard plays, pauses, steps, jumps and goes to both ends", () =>
  at("/two", {}, async (page) => {
    await page.locator(".rp-picture").focus();
    const press = async (key) => {
      await page.keyboard.press(key);
      await settled(page);
      return time(page);
    };
    assert.equal(await press("End"), hit.end);
    assert.equal(await press(","), Math.fround(hit.time), "the event before");
    assert.match(await page.getByRole("status").innerText(), /0\.6400 s, event 1 of 1: cue hits 1/);
    assert.equal(await press(","), 0, "before the first event: the start");
    assert.equal(await press("."), Math.fround(hit.time), "the next event");
    assert.equal(await press("."), hit.end, "after the last event: the end");
    assert.equal(await press("Home"), 0);
    near(await press("ArrowRight"), 0.01 * hit.end, 1e-12, "a hundredth of the shot");
    near(await press("ArrowLeft"), 0, 1e-12, "and back");
    near(await press("PageUp"), 0.1 * hit.end, 1e-12, "a tenth");
    assert.equal(await press("d"), Math.fround(hit.time), "the first divergence");
    await press("Home");
    await page.keyboard.press(" ");
    assert.equal(await state(page, "playing"), "true");
    await page.waitForFunction(() => Number(document.querySelector(".rp").dataset.time) > 0.05);
    await page.keyboard.press(" ");
    assert.equal(await state(page, "playing"), "false");
    const rest = await time(page);
    await page.waitForTimeout(150);
    assert.equal(await time(page), rest, "paused is paused");
    // keys on the scrubber do the same as elsewhere
    await page.locator(".rp-scrub").focus();
    assert.equal(await press("Home"), 0);
    near(await press("ArrowUp"), 0.01 * hit.end, 1e-12, "up is on");
    assert.match(await page.locator(".rp-scrub").getAttribute("aria-valuetext"), /^0\.0160 s, before the first of 1 events$/);
    await page.keyboard.press("?");
    assert.ok(await page.getByText("first divergence, then the next").isVisible(), "the list of keys");
  }));

test("playing goes to the end and stops there, and starts over from there", () =>
  at("/two", {}, async (page) => {
    await page.getByLabel("Speed", { exact: true }).selectOption("10");
    await page.getByRole("button", { name: "Play" }).click();
    await page.waitForFunction((end) => Number(document.querySelector(".rp").dataset.time) === end, hit.end);
    await settled(page);
    assert.match(await page.getByRole("status").innerText(), /^the end, 1\.6000 s/);
    await page.getByLabel("Speed", { exact: true }).selectOption("0.05");
    await page.getByRole("button", { name: "Play" }).click();
    await page.waitForFunction(() => document.querySelector(".rp").dataset.playing === "true");
    assert.ok((await time(page)) < hit.end);
    await page.getByRole("button", { name: "Pause" }).click();
    await settled(page);
  }));

test("a replay starts by itself where it was asked to, and never where a reader asked for less motion", async () => {
  await at("/autoplay", { calm: true }, async (page) => {
    assert.equal(await state(page, "playing"), "false");
    assert.equal(await time(page), 0);
  });
  const page = await open(browser);
  await page.goto(server.url("/autoplay"));
  await page.waitForFunction(() => Number(document.querySelector(".rp")?.dataset.time) > 0.1);
  page.assertQuiet();
  await page.context().close();
});

test("under reduced motion the camera is where it should be at once", () =>
  at("/two-solid", { calm: true }, async (page) => {
    await page.getByRole("button", { name: "Free" }).click();
    const rest = await pixels(page);
    await page.waitForTimeout(600);
    assert.ok((await pixels(page)).equals(rest));
  }));

test("a run can be hidden, made solid, and put on a table of its own", () =>
  at("/two-solid", {}, async (page) => {
    const t = hit.time + hit.late / 2;
    await scrub(page, t);
    const both = await pixels(page);
    await page.getByLabel("Show stepper").uncheck();
    await settled(page);
    const alone = await pixels(page);
    assert.ok(!alone.equals(both), "the ghost is gone");
    await page.getByLabel("Balls of stepper dt=0.1 solid").check();
    await settled(page);
    assert.equal(await state(page, "solid"), "stepper dt=0.1");
    assert.ok(await page.getByLabel("Show stepper").isDisabled(), "what is solid is shown");
    const { cue } = await readout(page);
    near(Number(cue.y), hit.from + hit.v * t, shown(5, 0.03), "the table of numbers follows: here the cue ball moves on");
    await page.getByRole("checkbox", { name: "Side by side" }).check();
    await page.waitForFunction(() => document.querySelectorAll(".rp-captions span").length === 2);
    assert.deepEqual(await page.locator(".rp-captions span").allInnerTexts(), ["exact", "stepper dt=0.1"]);
    await picture(page, "side-by-side");
  }));

test("a ghost is where its engine has the ball, not where the solid one is", () =>
  at("/two", {}, async (page) => {
    await page.getByRole("checkbox", { name: "Trails" }).uncheck();
    await page.getByRole("checkbox", { name: "Hits" }).uncheck();
    const t = hit.time + 0.9 * hit.late;
    await scrub(page, t);
    const both = await pixels(page);
    await page.getByLabel("Show stepper").uncheck();
    const alone = await pixels(page);
    const { low, high, width, height } = await page.evaluate(changed, [both.toString("base64"), alone.toString("base64")]);
    // the table lies, y to the right, the middle at 1 m; in view are 1 m by 2 m with 4.15 R of rails around, on 96 % of the picture
    const [R, rails] = [0.03, 2 * 4.15 * 0.03];
    const scale = 0.96 * Math.min(width / (2 + rails), height / (1 + rails));
    const across = (y) => width / 2 + (y - 1) * scale;
    // the stepper has not seen the hit: its cue ball ran on, the other lies where it lay; both edges by half a line and its soft edge
    near(low, across(hit.to - R), 2, "left edge of the ghost of the ball that was hit, px");
    near(high, across(hit.from + hit.v * t + R), 2, "right edge of the ghost of the cue ball, px");
  }));

/** The first and the last column in which two pictures differ, and their size. */
async function changed(pictures) {
  const images = await Promise.all(pictures.map((text) => new Promise((done) => Object.assign(new Image(), { src: `data:image/png;base64,${text}`, onload: (event) => done(event.target) }))));
  const [{ width, height }] = images;
  const pen = new OffscreenCanvas(width, height).getContext("2d", { willReadFrequently: true });
  const [p, q] = images.map((image) => (pen.drawImage(image, 0, 0), pen.getImageData(0, 0, width, height).data.slice()));
  let [low, high] = [Infinity, -Infinity];
  for (let i = 0; i < p.length; i += 4) {
    if (Math.abs(p[i] - q[i]) + Math.abs(p[i + 1] - q[i + 1]) + Math.abs(p[i + 2] - q[i + 2]) > 24) {
      low = Math.min(low, (i / 4) % width);
      high = Math.max(high, (i / 4) % width);
    }
  }
  return { low, high: high + 1, width, height };
}

test("the plots follow the time, and a press on a plot is a time", () =>
  at("/two", {}, async (page) => {
    const charts = page.locator(".rp-chart");
    assert.equal(await charts.count(), 3);
    await scrub(page, 0.4);
    const values = (chart) => charts.nth(chart).locator(".rp-values > span").allInnerTexts();
    assert.deepEqual(await values(0), ["0.4000 s:", "exact 1", "stepper dt=0.1 1"], "the cue ball's speed, m/s");
    assert.deepEqual(await values(1), ["0.4000 s:", "exact 1", "stepper dt=0.1 1"], "energy in E0");
    await scrub(page, 1.2);
    assert.deepEqual(await values(0), ["1.2000 s:", "exact 0", "stepper dt=0.1 0"], "after the hit it rests");
    await page.getByLabel("Speed of").selectOption({ label: "all balls, rms" });
    assert.equal((await values(0))[1], "exact 0.7071", "one of two balls moves at 1 m/s");
    const over = charts.nth(1).locator(".u-over");
    await over.scrollIntoViewIfNeeded();
    const box = await over.boundingBox();
    await page.mouse.click(box.x + 0.25 * box.width, box.y + 40);
    await settled(page);
    near(await time(page), 0.25 * hit.end, hit.end / box.width, "a press at a quarter, to a pixel");
    await charts.nth(0).getByText("Data").click();
    await charts.nth(0).locator("tbody tr").first().waitFor();
    assert.equal(await charts.nth(0).locator("tbody tr").count(), 12, "now, and eleven even steps");
    assert.match(await charts.nth(0).locator("tbody tr").first().innerText(), /^now: 0\.4/);
    await picture(page, "plots", { fullPage: true });
  }));

test("growing plots hide what has not been played", () =>
  at("/growing", {}, async (page) => {
    await scrub(page, 0.5 * hit.end);
    const [future, over] = await page.locator(".rp-chart").first().evaluate((chart) => [chart.querySelector(".rp-future").getBoundingClientRect(), chart.querySelector(".u-over").getBoundingClientRect()].map(({ left, width }) => ({ left, width })));
    near(future.left - over.left, 0.5 * over.width, 1, "the cover starts at the time shown");
    near(future.left + future.width, over.left + over.width, 1, "and ends with the plot, or the page would scroll sideways");
    await page.locator(".rp-chart").first().getByText("Data").click();
    await page.locator(".rp-chart tbody tr").first().waitFor();
    assert.equal(await page.locator(".rp-chart").first().locator("tbody tr").count(), 7, "now, and the steps up to half");
  }));

test("five hundred balls are drawn and played", () =>
  at("/crowd", {}, async (page) => {
    const start = await pixels(page);
    await scrub(page, 2);
    assert.ok(!(await pixels(page)).equals(start));
    assert.equal(Object.keys(await readout(page)).length, 500);
    await picture(page, "crowd");
  }));

test("two replays on a page do not disturb each other", () =>
  at("/pair", {}, async (page) => {
    await page.waitForFunction(() => document.querySelectorAll(".rp[data-drawn]").length === 2);
    await scrub(page, 0.3);
    assert.deepEqual(await page.locator(".rp").evaluateAll((all) => all.map((element) => element.dataset.time)), ["0.3", "0"]);
  }));

test("data that cannot be read are said to be so, and the stand-in stays", async () => {
  const page = await open(browser);
  await page.goto(server.url("/damaged"));
  const alert = page.getByRole("alert");
  await alert.waitFor();
  assert.match(await alert.innerText(), /cannot be shown: the knots hold 56 bytes where 3 knots/);
  assert.ok(await page.locator(".replay-static").isVisible());
  page.assertQuiet();
  await page.context().close();
});

test("without scripts the stand-in is what a reader sees; with them, the replay", async () => {
  const page = await open(browser, { scripts: false });
  await page.goto(server.url("/slide"));
  assert.ok(await page.locator(".replay-static").isVisible());
  await page.context().close();
  await at("/slide", {}, async (live) => assert.ok(await live.locator(".replay-static").isHidden()));
});

test("a browser that takes the graphics away gets a flat picture, and the table again when it gives them back", () =>
  at("/two-solid", {}, async (page) => {
    await scrub(page, 0.3);
    const canvas = await page.locator(".rp-picture canvas").elementHandle();
    const lost = await canvas.evaluateHandle((element) => element.getContext("webgl2").getExtension("WEBGL_lose_context"));
    await lost.evaluate((extension) => extension.loseContext());
    await page.waitForFunction(() => document.querySelector(".rp").dataset.view === "flat");
    const flat = await pixels(page);
    await scrub(page, 1.2);
    assert.ok(!(await pixels(page)).equals(flat), "the flat picture goes on");
    await lost.evaluate((extension) => extension.restoreContext());
    await page.waitForFunction(() => document.querySelector(".rp").dataset.view === "above");
    const solid = await pixels(page);
    await scrub(page, 0.3);
    assert.ok(!(await pixels(page)).equals(solid), "the table goes on");
  }));

for (const dark of [false, true]) {
  test(`a phone shows all of it without scrolling sideways, ${dark ? "dark" : "light"}`, () =>
    at("/two-solid", { viewport: PHONE, dark, touch: true }, async (page) => {
      for (const element of await page.locator("details > summary").all()) {
        await element.click();
      }
      const { scroll, client } = await page.evaluate(() => ({ scroll: document.documentElement.scrollWidth, client: document.documentElement.clientWidth }));
      assert.equal(scroll, client);
      const small = await page.locator(".rp button, .rp select").evaluateAll((all) => all.filter((element) => element.offsetParent && element.getBoundingClientRect().height < 24).map((element) => element.textContent));
      assert.deepEqual(small, [], "nothing to press is lower than 24 px (WCAG 2.5.8)");
      await picture(page, `phone-${dark ? "dark" : "light"}`, { fullPage: true });
    }));

  test(`words stand out from what is behind them, ${dark ? "dark" : "light"}`, () =>
    at("/two-solid", { viewport: DESKTOP, dark }, async (page) => {
      await page.locator(".rp-jump").click();
      await settled(page);
      for (const element of await page.locator("details > summary").all()) {
        await element.click();
      }
      const { weak, seen } = await page.evaluate(contrasts, ".rp");
      assert.ok(seen > 30, `only ${seen} words were looked at`);
      assert.deepEqual(weak, []);
      await picture(page, `desktop-${dark ? "dark" : "light"}`, { fullPage: true });
    }));
}

test("everything that can be operated has a name and a focus that is seen", () =>
  at("/two", {}, async (page) => {
    const names = await page.locator(".rp").ariaSnapshot();
    assert.doesNotMatch(names, /- (button|checkbox|radio|combobox|slider)(:| \[|$)/m, "no control without a name");
    const stops = [];
    for (let i = 0; i < 40; i += 1) {
      await page.keyboard.press("Tab");
      const stop = await page.evaluate(() => {
        const element = document.activeElement;
        const style = getComputedStyle(element);
        return element.closest(".rp") ? { what: element.tagName + (element.getAttribute("aria-label") ?? element.textContent).slice(0, 30), outline: parseFloat(style.outlineWidth) * (style.outlineStyle === "none" ? 0 : 1) } : null;
      });
      if (!stop) {
        break;
      }
      stops.push(stop);
    }
    assert.ok(stops.length >= 15, `${stops.length} stops`);
    assert.deepEqual(stops.filter((stop) => stop.outline < 2), []);
  }));

test("a drag turns the free view, a tap chooses a ball", () =>
  at("/two-solid", { calm: true }, async (page) => {
    await page.getByRole("button", { name: "Free" }).click();
    const start = await pixels(page);
    const box = await page.locator(".rp-picture").boundingBox();
    await page.mouse.move(box.x + 300, box.y + 200);
    await page.mouse.down();
    await page.mouse.move(box.x + 420, box.y + 180, { steps: 4 });
    await page.mouse.up();
    assert.ok(!(await pixels(page)).equals(start), "the table turned");
    await page.getByRole("button", { name: "From above" }).click();
    // the other ball lies on the spot in the middle of the table, which is the middle of the picture
    await page.mouse.click(box.x + box.width / 2, box.y + box.height / 2);
    assert.equal(await page.getByLabel("Speed of").evaluate((select) => select.selectedOptions[0].textContent), "ball 1");
  }));

test("without WebGL the table is drawn flat, with the same controls", async () => {
  const plain = await launch({ webgl: false });
  try {
    const page = await open(plain);
    await page.goto(server.url("/two-solid"));
    await mounted(page);
    assert.equal(await state(page, "view"), "flat");
    assert.equal(await page.getByRole("button", { name: "Free" }).count(), 0, "no camera that cannot be had");
    const start = await pixels(page);
    await page.locator(".rp-picture").focus();
    await page.keyboard.press("d");
    await settled(page);
    assert.equal(await time(page), Math.fround(hit.time));
    assert.ok(!(await pixels(page)).equals(start));
    await picture(page, "flat");
    page.assertQuiet();
    await page.context().close();
  } finally {
    await plain.close();
  }
});
