// The replay component: mounts the table, the controls and the plots of one replay into an element.
import { type Actions, RATES } from "./actions.ts";
import { Board } from "./board.ts";
import { Clock } from "./clock.ts";
import { Controls } from "./controls.ts";
import { make, say } from "./dom.ts";
import type { ReplayData } from "./format.ts";
import { Frame } from "./frame.ts";
import { hands } from "./hands.ts";
import { hear, list } from "./keys.ts";
import { Legend, swatch } from "./legend.ts";
import { timeText } from "./numbers.ts";
import { Plots } from "./plots.ts";
import { Readout } from "./readout.ts";
import { type Event, eventsUntil, runs, words } from "./run.ts";
import { grow, type Rect, type Stage, stage } from "./stage.ts";
import { type Camera, cells, type Choice, tables, type View } from "./view.ts";
import { World } from "./world.ts";

export interface Options {
  /** Plots show only what has been played so far. Default false. */
  growing?: boolean;
  /** Start to play at once, unless the reader asked for less motion. Default false. */
  autoplay?: boolean;
  /** Draw flat, even where there is WebGL. Default false. */
  flat?: boolean;
}

/** How much is seen around the balls of a parting, R. */
const CLOSE = 9;

/** What a page can do with a mounted replay. Times in s. */
export interface Handle {
  /** Settles when the data are unpacked and the first picture is drawn; rejects where the data cannot be read. */
  ready: Promise<void>;
  seek(t: number): void;
  play(): void;
  pause(): void;
  time(): number;
  destroy(): void;
}

/** Mounts a replay into `root`, beside what stands there: a page hides its own stand-in with `.rp-live`. */
export function mount(root: HTMLElement, data: ReplayData, options: Options = {}): Handle {
  const clock = new Clock(Math.max(0, ...data.runs.map((run) => run.end)));
  const element = make("section", { class: "rp", "aria-label": `Replay of ${data.scene.title}` }, make("p", { class: "rp-wait" }, "Unpacking the replay …"));
  root.append(element);
  root.classList.add("rp-live");
  let replay: Replay | null = null;
  let gone = false;
  const ready = runs(data)
    .then((unpacked) => {
      if (!gone) {
        replay = new Replay(element, stage(data, unpacked), clock, options);
      }
    })
    .catch((reason: unknown) => {
      element.replaceChildren(make("p", { class: "rp-wait", role: "alert" }, `This replay cannot be shown: ${reason instanceof Error ? reason.message : String(reason)}`));
      root.classList.remove("rp-live");
      throw reason;
    });
  // whoever does not wait for it reads the message on the page
  ready.catch(() => undefined);
  return {
    ready,
    seek: (t) => clock.seek(t),
    play: () => clock.play(),
    pause: () => clock.pause(),
    time: () => clock.time,
    destroy: () => {
      gone = true;
      clock.stop();
      replay?.destroy();
      element.remove();
      root.classList.remove("rp-live");
    },
  };
}

class Replay implements Actions {
  private readonly frame: Frame;
  private readonly choice: Choice;
  private readonly controls: Controls;
  private readonly legend: Legend;
  private readonly readout: Readout;
  private readonly plots: Plots;
  private readonly picture = make("div", { class: "rp-picture", tabindex: 0, role: "group" });
  private readonly captions = make("div", { class: "rp-captions" });
  private readonly banner = make("p", { class: "rp-banner", hidden: true });
  private readonly status = make("p", { class: "rp-status", role: "status" });
  private readonly sizes: ResizeObserver;
  private readonly calm = matchMedia("(prefers-reduced-motion: reduce)");
  private view: View | null = null;
  /** The table whose graphics were lost. */
  private waiting: World | null = null;
  /** The parting that is shown, -1 for none. */
  private called = -1;
  private asked = 0;
  private solidView = true;

  constructor(
    private readonly element: HTMLElement,
    private readonly stage: Stage,
    private readonly clock: Clock,
    options: Options,
  ) {
    const { data, runs: all } = stage;
    this.frame = new Frame(stage);
    const reference = Math.max(0, data.runs.findIndex((run) => run.reference));
    const cue = data.balls.findIndex((ball) => ball.id === "cue");
    this.choice = { camera: "above", solid: reference, shown: all.map(() => true), apart: false, trails: true, marks: true, ball: Math.max(0, cue), called: [] };
    this.view = options.flat ? null : this.world();
    this.solidView = this.view !== null;
    this.view ??= new Board(stage, this.still);
    if (!this.solidView) {
      this.choice.camera = "flat";
    }
    this.controls = new Controls(stage, clock, this, this.solidView);
    this.legend = new Legend(stage, this);
    this.readout = new Readout(stage);
    this.plots = new Plots(stage, this, options.growing ?? false);
    const keys = list();
    this.picture.setAttribute("aria-label", `The table of ${data.scene.title}; the same in numbers under “Where the balls are now”`);
    this.picture.append(this.view.canvas, this.captions);
    element.replaceChildren(this.picture, this.controls.element, this.banner, this.status, this.legend.element, this.plots.element, this.readout.element, keys);
    hands(this.picture, { view: () => this.view, again: this.ask, choose: (ball) => this.follow(ball) });
    hear(element, {
      actions: this,
      view: () => this.view,
      end: () => stage.end,
      camera: () => this.choice.camera,
      nextCamera: () => this.nextCamera(),
      toggleTrails: () => this.trails(!this.choice.trails),
      again: this.ask,
      keys,
    });
    this.sizes = new ResizeObserver(() => this.resize());
    this.sizes.observe(element);
    clock.listen(this.tick);
    this.resize();
    this.view.look(this.choice);
    this.changed();
    this.controls.mark(this.events());
    this.tick();
    if (options.autoplay && !this.calm.matches) {
      clock.play();
    }
  }

  destroy(): void {
    cancelAnimationFrame(this.asked);
    this.sizes.disconnect();
    this.plots.destroy();
    this.view?.dispose();
    this.waiting?.dispose();
    this.view = null;
  }

  toggle(): void {
    if (this.clock.playing) {
      this.clock.pause();
      this.speak(this.where());
    } else {
      this.clock.play();
      this.speak("plays");
    }
  }

  seek(t: number): void {
    this.call(-1);
    this.clock.seek(t);
  }

  nudge(part: number): void {
    this.seek(this.clock.time + part * this.stage.end);
    if (!this.clock.playing) {
      this.speak(this.where());
    }
  }

  event(way: 1 | -1): void {
    this.clock.pause();
    this.call(-1);
    const events = this.events();
    const passed = eventsUntil(events, this.clock.time);
    if (way === 1) {
      this.clock.seek(passed < events.length ? events[passed].at : this.stage.end);
    } else {
      // the last of the events that lie before this time
      let before = passed - 1;
      while (before >= 0 && events[before].at >= this.clock.time) {
        before -= 1;
      }
      this.clock.seek(before >= 0 ? events[before].at : 0);
    }
    this.speak(this.where());
  }

  parting(index?: number): void {
    const { partings, balls } = this.stage.data;
    if (partings.length === 0) {
      this.speak("no collision order differs");
      return;
    }
    this.clock.pause();
    const at = index ?? (this.called + 1) % partings.length;
    const parting = partings[at];
    // both runs must be in sight
    for (const run of parting.runs) {
      if (run < this.choice.shown.length) {
        this.choice.shown[run] = true;
      }
    }
    this.clock.seek(Math.fround(parting.time));
    this.call(at);
    this.choice.called = parting.balls.map((id) => balls.findIndex((ball) => ball.id === id)).filter((ball) => ball >= 0);
    this.view?.close(this.around(this.choice.called));
    this.changed();
    this.speak(`${timeText(parting.time, this.stage.end)} ${this.stage.data.scene.time_unit}: ${parting.words}`);
  }

  rate(factor: number): void {
    this.clock.rate = factor;
  }

  faster(way: 1 | -1): void {
    const at = RATES.indexOf(this.clock.rate) + way;
    this.rate(RATES[Math.min(RATES.length - 1, Math.max(0, at))]);
    this.speak(`speed ${this.clock.rate}`);
  }

  look(camera: Camera): void {
    this.waiting?.dispose();
    this.waiting = null;
    const flat = camera === "flat";
    if (flat !== (this.choice.camera === "flat")) {
      this.swap(flat ? new Board(this.stage, this.still) : this.world());
    }
    this.choice.camera = this.view instanceof Board ? "flat" : camera;
    this.view?.look(this.choice);
    this.changed();
  }

  apart(on: boolean): void {
    this.choice.apart = on;
    this.changed();
  }

  trails(on: boolean): void {
    this.choice.trails = on;
    this.changed();
  }

  marks(on: boolean): void {
    this.choice.marks = on;
    this.changed();
  }

  show(run: number, on: boolean): void {
    this.choice.shown[run] = on;
    this.changed();
  }

  solid(run: number): void {
    this.choice.shown[run] = true;
    this.choice.solid = run;
    this.controls.mark(this.events());
    this.changed();
    this.tick();
  }

  follow(ball: number): void {
    this.choice.ball = ball;
    this.changed();
  }

  private nextCamera(): void {
    const all: Camera[] = this.solidView ? ["above", "free", "flat"] : ["flat"];
    this.look(all[(all.indexOf(this.choice.camera) + 1) % all.length]);
  }

  private readonly still = (): boolean => this.calm.matches;

  /** The solid table, or null where the browser has no WebGL. */
  private world(): World | null {
    try {
      return new World(this.stage, this.still, () => this.lost());
    } catch {
      return null;
    }
  }

  /** The browser took the graphics away: on with the flat picture, and back to the table when it gives them back. */
  private lost(): void {
    const world = this.view;
    if (!(world instanceof World)) {
      return;
    }
    const { camera } = this.choice;
    world.canvas.addEventListener(
      "webglcontextrestored",
      () => {
        if (this.view instanceof Board && this.waiting === world) {
          this.waiting = null;
          this.choice.camera = camera;
          this.swap(world);
          this.changed();
        }
      },
      { once: true },
    );
    this.waiting = world;
    this.choice.camera = "flat";
    this.swap(new Board(this.stage, this.still));
    this.changed();
    this.speak("the graphics were lost: the table is drawn flat");
  }

  /** Shows another view in the place of this one, which goes unless it waits for its graphics. */
  private swap(view: View | null): void {
    if (!view || !this.view) {
      return;
    }
    const before = this.view;
    before.canvas.replaceWith(view.canvas);
    if (before !== this.waiting) {
      before.dispose();
    }
    this.view = view;
    this.resize();
  }

  private events(): Event[] {
    return this.stage.runs[this.choice.solid]?.events ?? [];
  }

  /** The time and what happened at it, in words. */
  private where(): string {
    const { clock, stage } = this;
    const events = this.events();
    const passed = eventsUntil(events, clock.time);
    const now: string[] = [];
    for (let i = passed - 1; i >= 0 && events[i].at === clock.time; i -= 1) {
      now.unshift(words(events[i]));
    }
    const time = `${timeText(clock.time, stage.end)} ${stage.data.scene.time_unit}`;
    return now.length > 0 ? `${time}, event ${passed} of ${events.length}: ${now.join("; ")}` : `${time}, ${passed} of ${events.length} events`;
  }

  private speak(text: string): void {
    say(this.status, text);
  }

  /** Shows a parting's words, or takes them away. */
  private call(index: number): void {
    this.called = index;
    const parting = index >= 0 ? this.stage.data.partings[index] : undefined;
    this.banner.hidden = parting === undefined;
    if (parting) {
      const { data, end } = this.stage;
      const names = parting.runs.map((run) => make("span", { class: "rp-who" }, swatch(run), data.runs[run]?.label ?? ""));
      this.banner.replaceChildren(...names, make("b", {}, `part at ${timeText(parting.time, end)} ${data.scene.time_unit}. `), parting.words);
    } else if (this.choice.called.length > 0) {
      this.choice.called = [];
      this.view?.close(null);
      this.ask();
    }
    this.element.dataset.parting = String(index);
  }

  /** The part of the cloth where some balls are, in every shown run; null where none is. */
  private around(balls: number[]): Rect | null {
    const { choice, frame } = this;
    frame.go(this.clock.time);
    const rect = { x0: Infinity, y0: Infinity, x1: -Infinity, y1: -Infinity };
    for (const scatter of frame.scatters.filter(({ run }) => choice.shown[run.index])) {
      for (const ball of balls) {
        const [x, y] = [scatter.positions[3 * ball], scatter.positions[3 * ball + 1]];
        rect.x0 = Math.min(rect.x0, x);
        rect.x1 = Math.max(rect.x1, x);
        rect.y0 = Math.min(rect.y0, y);
        rect.y1 = Math.max(rect.y1, y);
      }
    }
    return rect.x1 >= rect.x0 && rect.y1 >= rect.y0 ? grow(rect, CLOSE) : null;
  }

  /** After a change of the clock. */
  private readonly tick = (): void => {
    const { clock, element, stage } = this;
    const parting = this.called >= 0 ? stage.data.partings[this.called] : undefined;
    if (parting && Math.abs(clock.time - parting.time) > 0.8 * clock.rate * clock.base) {
      this.call(-1);
    }
    element.dataset.time = String(clock.time);
    element.dataset.playing = String(clock.playing);
    this.controls.tell(this.events());
    this.plots.go(clock.time, clock.playing);
    this.ask();
    if (!clock.playing && clock.time >= stage.end && stage.end > 0) {
      this.speak(`the end, ${this.where()}`);
    }
  };

  /** After a change of what the reader chose. */
  private changed(): void {
    const { choice, stage } = this;
    this.controls.choose(choice);
    this.legend.choose(choice);
    this.plots.choose(choice);
    this.element.dataset.view = choice.camera;
    this.caption();
    this.plots.go(this.clock.time, this.clock.playing);
    this.element.dataset.solid = stage.data.runs[choice.solid]?.label ?? "";
    this.ask();
  }

  /** Names on tables that stand side by side. */
  private caption(): void {
    const { choice, stage } = this;
    const all = tables(choice);
    this.captions.hidden = all.length < 2;
    if (all.length < 2) {
      return;
    }
    const { width, height } = this.picture.getBoundingClientRect();
    const { cells: parts } = cells(stage.sight, all.length, width, height);
    this.captions.replaceChildren(
      ...all.map((run, i) => {
        const name = make("span", {}, swatch(run), stage.data.runs[run].label);
        name.style.left = `${parts[i].x}px`;
        name.style.top = `${parts[i].y}px`;
        return name;
      }),
    );
  }

  private resize(): void {
    const { stage, picture, view } = this;
    const width = this.element.clientWidth;
    if (width <= 0 || !view) {
      return;
    }
    const { sight } = stage;
    const sides = [sight.x1 - sight.x0, sight.y1 - sight.y0];
    const [long, small] = [Math.max(...sides), Math.min(...sides)];
    const tall = width < 560;
    const wanted = tall ? (width * long) / small : (width * small) / long;
    const height = Math.round(Math.min(Math.max(wanted, 260), Math.max(300, (tall ? 0.56 : 0.64) * window.innerHeight)));
    picture.style.height = `${height}px`;
    view.resize(width, height);
    this.caption();
    this.draw();
  }

  /** Draws in the next frame, once however often it is asked for. */
  private readonly ask = (): void => {
    if (this.asked === 0) {
      this.element.dataset.pending = "true";
      this.asked = requestAnimationFrame(() => {
        this.asked = 0;
        this.element.dataset.pending = "false";
        this.draw();
      });
    }
  };

  private draw(): void {
    if (!this.view) {
      return;
    }
    this.frame.go(this.clock.time);
    this.readout.tell(this.frame, this.choice.solid, this.clock.playing);
    this.element.dataset.drawn = String(this.clock.time);
    if (this.view.draw(this.frame, this.choice, this.clock.rate * this.clock.base, this.clock.playing)) {
      this.ask();
    }
  }
}
