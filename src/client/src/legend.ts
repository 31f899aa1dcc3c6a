// The runs: which are shown, whose balls are solid, how each ended, where it parts from another.
import type { Actions } from "./actions.ts";
import { draw, make } from "./dom.ts";
import type { RunFacts } from "./format.ts";
import { timeText } from "./numbers.ts";
import { ink } from "./palette.ts";
import type { Stage } from "./stage.ts";
import type { Choice } from "./view.ts";

export class Legend {
  readonly element: HTMLElement;
  private readonly shown: HTMLInputElement[] = [];
  private readonly solid: HTMLInputElement[] = [];
  private readonly rows: HTMLElement[] = [];

  constructor(stage: Stage, actions: Actions) {
    this.element = make("fieldset", { class: "rp-legend" }, make("legend", {}, "Engines"));
    const group = `rp-solid-${Math.random().toString(36).slice(2)}`;
    const unit = stage.data.scene.time_unit;
    for (const { facts, index } of stage.runs) {
      const show = make("input", { type: "checkbox", "aria-label": `Show ${facts.label}` });
      show.addEventListener("change", () => actions.show(index, show.checked));
      const solid = make("input", { type: "radio", name: group, "aria-label": `Balls of ${facts.label} solid` });
      solid.addEventListener("change", () => actions.solid(index));
      this.shown.push(show);
      this.solid.push(solid);
      const name = make("span", { class: "rp-name" }, facts.label, ...(facts.reference ? [make("small", {}, "reference")] : []));
      const ending = make("span", { class: "rp-ending" }, ended(facts, `${timeText(facts.end, stage.end)} ${unit}`));
      const row = make("div", { class: "rp-run" }, make("label", { class: "rp-show" }, show, swatch(index), name));
      if (stage.runs.length > 1) {
        row.append(make("label", { class: "rp-solid" }, solid, "solid"));
      }
      row.append(ending);
      stage.data.partings.forEach((parting, at) => {
        if (parting.runs[0] === index) {
          const from = stage.runs[parting.runs[1]]?.facts.label ?? "";
          const jump = make("button", { type: "button", class: "rp-parts", title: parting.words }, `parts from ${from} at ${timeText(parting.time, stage.end)} ${unit}`);
          jump.addEventListener("click", () => actions.parting(at));
          row.append(jump);
        }
      });
      this.rows.push(row);
      this.element.append(row);
    }
  }

  choose(choice: Choice): void {
    this.shown.forEach((box, index) => {
      box.checked = choice.shown[index] || index === choice.solid;
      box.disabled = index === choice.solid;
      this.solid[index].checked = index === choice.solid;
      this.rows[index].classList.toggle("rp-off", !box.checked);
    });
  }
}

/** Why a run ended, without its own name in front, and when unless that is said already. */
function ended(facts: RunFacts, time: string): string {
  const plain = facts.ending.startsWith(`${facts.engine}: `) ? facts.ending.slice(facts.engine.length + 2) : facts.ending;
  return /\d/.test(plain) ? plain : `${plain}, ${time}`;
}

/** A piece of the line by which a run is known in the plots. */
export function swatch(run: number): SVGSVGElement {
  const line = draw("line", { x1: 0, y1: 5, x2: 34, y2: 5, class: `rp-ink${run % 7}`, "stroke-width": 2.5, "stroke-dasharray": ink(run).dash.join(" ") || "none" });
  return draw("svg", { viewBox: "0 0 34 10", class: "rp-swatch", "aria-hidden": "true" }, line);
}
