// The plots of a replay: speed, energy, distance between runs.
import type { Actions } from "./actions.ts";
import { Chart, type ChartFacts, type Content } from "./chart.ts";
import { curves, type Curves, speed, times, type Times, valueAt } from "./curves.ts";
import { make } from "./dom.ts";
import { motion } from "./path.ts";
import type { Stage } from "./stage.ts";
import type { Choice } from "./view.ts";

export class Plots {
  readonly element = make("div", { class: "rp-plots" });
  private readonly speed: Chart;
  private readonly energy: Chart;
  private readonly divergence: Chart | null;
  private readonly ball: HTMLSelectElement;
  private readonly when: Times;
  private readonly made = new Map<number, Curves>();
  private readonly sizes: ResizeObserver;
  private readonly dark = matchMedia("(prefers-color-scheme: dark)");
  private choice: Choice | null = null;
  /** Kinetic energy at the start, mass unit times (R/s)^2. */
  private readonly initial: number;

  constructor(
    private readonly stage: Stage,
    actions: Actions,
    growing: boolean,
  ) {
    const { data, runs, end } = stage;
    const unit = data.scene.time_unit;
    const facts = (title: string, axis: string, measure: string, log = false): ChartFacts => ({
      title,
      axis,
      unit: measure,
      log,
      growing,
      timeUnit: unit,
      end,
      partings: data.partings.map((parting) => parting.time),
      horizon: data.horizon,
      seek: (t) => actions.seek(t),
    });
    this.ball = make("select", { "aria-label": "Speed of" }, make("option", { value: -1 }, "all balls, rms"), ...data.balls.map((ball, i) => make("option", { value: i }, ball.id === "cue" ? "the cue ball" : `ball ${ball.id}`)));
    this.ball.addEventListener("change", () => actions.follow(Number(this.ball.value)));
    this.speed = new Chart(facts("Speed", "speed", `${data.scene.length_unit}/${unit}`), make("label", {}, " of ", this.ball));
    this.energy = new Chart(facts("Kinetic energy", "energy", "E0"));
    this.divergence = data.divergence.some((pair) => pair.points.some(([, d]) => d > 0)) ? new Chart(facts("Distance between engines, worst ball", "distance", "R", true)) : null;
    this.when = times(data, runs, end);
    this.initial = start(stage);
    for (const chart of this.charts()) {
      this.element.append(chart.element);
    }
    this.sizes = new ResizeObserver((entries) => {
      for (const entry of entries) {
        this.charts().find((chart) => chart.element === entry.target)?.resize(Math.floor(entry.contentRect.width));
      }
    });
    this.charts().forEach((chart) => this.sizes.observe(chart.element));
    this.dark.addEventListener("change", this.recolour);
  }

  /** Takes which runs are shown and which ball is followed. */
  choose(choice: Choice): void {
    const before = this.choice;
    const same = before !== null && before.ball === choice.ball && before.solid === choice.solid && before.shown.join() === choice.shown.join();
    this.choice = { ...choice, shown: [...choice.shown] };
    if (same) {
      return;
    }
    this.ball.value = String(choice.ball);
    const { stage, when } = this;
    const { data } = stage;
    const runs = stage.runs.filter((run) => choice.shown[run.index] || run.index === choice.solid);
    const lines = (values: (index: number) => Float64Array): Content => ({ at: when.at, lines: runs.map((run) => ({ label: run.facts.label, run: run.index, values: values(run.index) })) });
    this.speed.show(lines((index) => (choice.ball < 0 ? this.curves(index).rms : speed(stage.runs[index], choice.ball, when)).map((v) => v * data.R)));
    this.energy.show(lines((index) => this.curves(index).energy.map((e) => (this.initial > 0 ? e / this.initial : e))));
    this.divergence?.show(this.pairs(choice));
  }

  go(t: number, playing: boolean): void {
    for (const chart of this.charts()) {
      chart.go(t, playing);
    }
  }

  destroy(): void {
    this.dark.removeEventListener("change", this.recolour);
    this.sizes.disconnect();
    for (const chart of this.charts()) {
      chart.destroy();
    }
  }

  private readonly recolour = (): void => this.charts().forEach((chart) => chart.build());

  private charts(): Chart[] {
    return [this.speed, this.energy, ...(this.divergence ? [this.divergence] : [])];
  }

  private curves(index: number): Curves {
    let made = this.made.get(index);
    if (!made) {
      made = curves(this.stage.data, this.stage.runs[index], this.when);
      this.made.set(index, made);
    }
    return made;
  }

  /** Distances of shown pairs on one list of times. */
  private pairs(choice: Choice): Content {
    const { data } = this.stage;
    const seen = (index: number): boolean => choice.shown[index] || index === choice.solid;
    const pairs = data.divergence.filter((pair) => seen(pair.run) && seen(pair.against));
    const at = Float64Array.from(new Set(pairs.flatMap((pair) => pair.points.map(([t]) => t)))).sort();
    const lines = pairs.map((pair) => {
      const [own, distances] = [pair.points.map(([t]) => t), pair.points.map(([, d]) => d)];
      const label = data.runs[pair.run].label;
      const against = data.runs[pair.against];
      return { label: against.reference ? label : `${label} to ${against.label}`, run: pair.run, values: Float64Array.from(at, (t) => (t <= own[own.length - 1] ? valueAt(own, distances, t) : NaN)) };
    });
    return { at, lines };
  }
}

/** Kinetic energy at the start, of the first run that has knots for every ball. */
function start(stage: Stage): number {
  const { data, runs } = stage;
  const m = motion();
  for (const run of runs) {
    if (!run.paths.every((path) => path.count > 0)) {
      continue;
    }
    return data.balls.reduce((sum, ball, index) => {
      run.paths[index].at(0, m, true);
      const v2 = m.velocity.reduce((s, v) => s + v * v, 0);
      const w2 = m.spin.reduce((s, w) => s + w * w, 0);
      return sum + (ball.mass * v2 + (ball.inertia / data.R ** 2) * w2) / 2;
    }, 0);
  }
  return 0;
}
