// Play, steps, rate, the jump to where runs part, the scrubber with its ticks, and how the table is looked at.
import { type Actions, RATES } from "./actions.ts";
import type { Clock } from "./clock.ts";
import { button, draw, icon, make, say } from "./dom.ts";
import { timeText } from "./numbers.ts";
import { type Event, eventsUntil, words } from "./run.ts";
import type { Stage } from "./stage.ts";
import type { Camera, Choice } from "./view.ts";

const PLAY = "M8 5v14l11-7z";
const PAUSE = "M6 5h4v14H6zM14 5h4v14h-4z";
const NEXT = "M6 6l8.5 6L6 18zM16 6h2v12h-2z";
const BEFORE = "M18 6l-8.5 6L18 18zM6 6h2v12H6z";
const PART = "M11 21v-7L5.6 8.6 4 10V4h6L8.4 5.6 12 9.2l3.6-3.6L14 4h6v6l-1.6-1.4L13 14v7z";

export class Controls {
  readonly element: HTMLElement;
  readonly scrubber: HTMLInputElement;
  private readonly play: HTMLButtonElement;
  private readonly shape: SVGPathElement;
  private readonly now = make("span", { class: "rp-now" });
  private readonly last = make("span", { class: "rp-event" });
  private readonly rates: HTMLSelectElement;
  private readonly jump: HTMLButtonElement | null = null;
  private readonly ticks = draw("svg", { class: "rp-ticks", viewBox: "0 0 1000 12", preserveAspectRatio: "none", "aria-hidden": "true" });
  private readonly cameras = new Map<Camera, HTMLButtonElement>();
  private readonly boxes: { apart: HTMLInputElement | null; trails: HTMLInputElement; marks: HTMLInputElement };
  private spoken = -Infinity;

  constructor(
    private readonly stage: Stage,
    private readonly clock: Clock,
    actions: Actions,
    solidView: boolean,
  ) {
    const unit = stage.data.scene.time_unit;
    this.shape = draw("path", { d: PLAY });
    this.play = button("Play", [draw("svg", { viewBox: "0 0 24 24", "aria-hidden": "true", class: "rp-icon" }, this.shape)], () => actions.toggle());
    this.play.classList.add("rp-play");
    this.rates = make("select", { "aria-label": "Speed", title: clock.base === 1 ? `1x: one ${unit} in one second` : "1x: the longest run in ten seconds" });
    this.rates.append(...RATES.map((rate) => make("option", { value: rate, selected: rate === 1 }, `${rate}×`)));
    this.rates.addEventListener("change", () => actions.rate(Number(this.rates.value)));
    this.scrubber = make("input", { type: "range", min: 0, max: stage.end || 1, step: "any", value: 0, class: "rp-scrub", "aria-label": "Time" });
    this.scrubber.addEventListener("input", () => actions.seek(Number(this.scrubber.value)));
    const transport = make(
      "div",
      { class: "rp-transport", role: "group", "aria-label": "Playback" },
      button("Event before", [icon(BEFORE)], () => actions.event(-1)),
      this.play,
      button("Next event", [icon(NEXT)], () => actions.event(1)),
    );
    const row = make("div", { class: "rp-row" }, transport, make("span", { class: "rp-clock" }, this.now, make("span", { class: "rp-end" }, ` / ${timeText(stage.end, stage.end)} ${unit}`)), this.rates);
    if (stage.data.partings.length > 0) {
      const first = stage.data.partings[0].time;
      this.jump = button("Jump to the first divergence", [icon(PART), make("span", {}, "First divergence"), make("span", { class: "rp-at" }, `${timeText(first, stage.end)} ${unit}`)], () => actions.parting());
      this.jump.classList.add("rp-jump");
      row.append(this.jump);
    } else if (stage.runs.length > 1) {
      row.append(make("span", { class: "rp-none" }, "No collision order differs"));
    }
    row.append(this.last);
    const views = make("div", { class: "rp-views", role: "group", "aria-label": "Camera" });
    const offered: [Camera, string][] = solidView ? [["above", "From above"], ["free", "Free"], ["flat", "Flat"]] : [["flat", "Flat"]];
    for (const [camera, name] of offered) {
      const choice = make("button", { type: "button", "aria-pressed": "false" }, name);
      choice.addEventListener("click", () => actions.look(camera));
      this.cameras.set(camera, choice);
      views.append(choice);
    }
    this.boxes = {
      apart: stage.runs.length > 1 ? this.box("Side by side", (on) => actions.apart(on)) : null,
      trails: this.box("Trails", (on) => actions.trails(on)),
      marks: this.box("Hits", (on) => actions.marks(on)),
    };
    const looks = make("div", { class: "rp-row rp-looks" }, views);
    for (const box of [this.boxes.apart, this.boxes.trails, this.boxes.marks]) {
      if (box?.parentElement) {
        looks.append(box.parentElement);
      }
    }
    this.element = make("div", { class: "rp-controls" }, make("div", { class: "rp-time" }, this.scrubber, this.ticks), row, looks);
  }

  /** Takes the time and the state of the clock; `events` are those of the solid run. */
  tell(events: Event[]): void {
    const { clock, stage } = this;
    const text = timeText(clock.time, stage.end);
    say(this.now, text);
    this.scrubber.value = String(clock.time);
    this.scrubber.style.setProperty("--rp-part", String(stage.end > 0 ? clock.time / stage.end : 0));
    const passed = eventsUntil(events, clock.time);
    const line = passed > 0 ? `event ${passed} of ${events.length}: ${words(events[passed - 1])}` : `before the first of ${events.length} events`;
    const shown = events.length > 0 ? line : "no events";
    say(this.last, shown);
    // a screen reader that stands on the scrubber hears of the time when it rests, and once a second while it runs
    const now = performance.now();
    if (!clock.playing || now - this.spoken > 1000) {
      this.spoken = now;
      this.scrubber.setAttribute("aria-valuetext", `${text} ${stage.data.scene.time_unit}, ${shown}`);
    }
    const label = clock.playing ? "Pause" : "Play";
    if (this.play.title !== label) {
      this.play.title = label;
      this.play.setAttribute("aria-label", label);
      this.shape.setAttribute("d", clock.playing ? PAUSE : PLAY);
    }
    this.rates.value = String(clock.rate);
  }

  /** Takes what the reader chose. */
  choose(choice: Choice): void {
    for (const [camera, element] of this.cameras) {
      element.setAttribute("aria-pressed", String(camera === choice.camera));
    }
    if (this.boxes.apart) {
      this.boxes.apart.checked = choice.apart;
    }
    this.boxes.trails.checked = choice.trails;
    this.boxes.marks.checked = choice.marks;
  }

  /** Draws the ticks of a run's events, of partings and of the horizon. */
  mark(events: Event[]): void {
    const { data, end } = this.stage;
    const at = (t: number): string => ((1000 * t) / (end || 1)).toFixed(2);
    const heights: Record<string, number> = { "ball-ball": 9, "ball-cushion": 6, pocket: 9, stop: 3 };
    const line = (kind: string, d: string): SVGPathElement => draw("path", { d, class: `rp-tick ${kind}`, "vector-effect": "non-scaling-stroke" });
    const paths = Object.entries(heights).map(([kind, height]) => {
      const d = events.filter((event) => event.kind === kind).map((event) => `M${at(event.at)} 0v${height}`);
      return line(`rp-${kind}`, d.join(""));
    });
    const partings = data.partings.map((parting) => line("rp-part", `M${at(parting.time)} 0v12`));
    const horizon = data.horizon === null ? [] : [line("rp-horizon", `M${at(data.horizon)} 0v12`)];
    this.ticks.replaceChildren(...paths, ...horizon, ...partings);
  }

  private box(name: string, change: (on: boolean) => void): HTMLInputElement {
    const input = make("input", { type: "checkbox" });
    input.addEventListener("change", () => change(input.checked));
    make("label", { class: "rp-check" }, input, name);
    return input;
  }
}
