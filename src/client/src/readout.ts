// Where the balls are now, in the scene's units: the picture as a table.
import { make, say } from "./dom.ts";
import type { Frame } from "./frame.ts";
import { decimals, short, timeText } from "./numbers.ts";
import type { Stage } from "./stage.ts";

/** Time between two updates while it plays, ms. */
const PACE = 250;

export class Readout {
  readonly element: HTMLDetailsElement;
  private readonly caption = make("caption", {});
  private readonly cells: HTMLElement[][] = [];
  private last = -Infinity;

  constructor(private readonly stage: Stage) {
    const { balls, rotates, scene } = stage.data;
    const [length, time] = [scene.length_unit, scene.time_unit];
    const heads = [`x, ${length}`, `y, ${length}`, `speed, ${length}/${time}`, ...(rotates ? [`spin, rad/${time}`] : []), "state"];
    const head = make("tr", {}, make("th", { scope: "col" }, "ball"), ...heads.map((name) => make("th", { scope: "col", class: "r" }, name)));
    const rows = balls.map((ball) => {
      const cells = heads.map(() => make("td", { class: "r" }));
      this.cells.push(cells);
      return make("tr", { "data-ball": ball.id }, make("th", { scope: "row" }, ball.id), ...cells);
    });
    const table = make("table", {}, this.caption, make("thead", {}, head), make("tbody", {}, ...rows));
    this.element = make("details", { class: "rp-readout" }, make("summary", {}, "Where the balls are now"), make("div", { class: "rp-scroll", tabindex: 0, role: "region", "aria-label": "Where the balls are now" }, table));
  }

  /** Takes the balls of a run as a frame has them; a closed table is written only when the time rests. */
  tell(frame: Frame, solid: number, playing: boolean): void {
    const now = performance.now();
    if (playing && (!this.element.open || now - this.last < PACE)) {
      return;
    }
    this.last = now;
    const { data, end } = this.stage;
    const scatter = frame.scatters[solid];
    const places = decimals(data.R, 4);
    say(this.caption, `${scatter.run.facts.label} at ${timeText(frame.time, end)} ${data.scene.time_unit}`);
    this.cells.forEach((cells, ball) => {
      const at = (axis: number): number => data.origin[axis] + data.R * scatter.positions[3 * ball + axis];
      const norm = (values: Float64Array): number => Math.hypot(values[3 * ball], values[3 * ball + 1], values[3 * ball + 2]);
      const speed = norm(scatter.velocities) * data.R;
      const spin = norm(scatter.spins);
      const state = !scatter.present[ball] ? "fallen" : speed > 0 ? "moves" : spin > 0 ? "spins" : "rests";
      const texts = [at(0).toFixed(places), at(1).toFixed(places), short(speed, 5), ...(data.rotates ? [short(spin, 5)] : []), state];
      texts.forEach((text, i) => say(cells[i], text));
    });
  }
}
