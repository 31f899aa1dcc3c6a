// One plot over time: its lines, a cursor that is the time of the replay, marks, and a table of what it shows.
import uPlot from "uplot";
import { valueAt } from "./curves.ts";
import { make, say } from "./dom.ts";
import { swatch } from "./legend.ts";
import { short, timeText } from "./numbers.ts";
import { ink, inkNow } from "./palette.ts";

/** One line. */
export interface Line {
  label: string;
  /** Index of the run whose ink it has. */
  run: number;
  values: ArrayLike<number>;
}

export interface Content {
  at: Float64Array;
  lines: Line[];
}

export interface ChartFacts {
  title: string;
  /** What is on the vertical axis, and its unit. */
  axis: string;
  unit: string;
  timeUnit: string;
  end: number;
  log: boolean;
  /** Only what was played is shown. */
  growing: boolean;
  /** Times of first partings, and the horizon. */
  partings: number[];
  horizon: number | null;
  seek(t: number): void;
}

const HEIGHT = 210;
/** A unit with more letters stands in the heading: an axis is not long enough. */
const LONG = 10;
/** Rows of the table, besides the one for now. */
const ROWS = 11;

export class Chart {
  readonly element: HTMLElement;
  private readonly host = make("div", { class: "rp-plot" });
  private readonly values = make("p", { class: "rp-values" });
  private readonly numbers: HTMLElement[] = [];
  private readonly at = make("span", {});
  private readonly table = make("table", {});
  private readonly data: HTMLDetailsElement;
  private readonly nowLine = make("div", { class: "rp-now-line" });
  private readonly future = make("div", { class: "rp-future" });
  private plot: uPlot | null = null;
  private content: Content = { at: new Float64Array(0), lines: [] };
  private time = 0;
  private told = -Infinity;
  private width = 0;

  constructor(
    private readonly facts: ChartFacts,
    ...extra: Node[]
  ) {
    this.data = make("details", {}, make("summary", {}, "Data"), make("div", { class: "rp-scroll", tabindex: 0, role: "region", "aria-label": `${facts.title}, data` }, this.table));
    this.data.addEventListener("toggle", () => this.fill());
    const unit = facts.unit.length > LONG ? [make("span", { class: "rp-unit" }, `in ${facts.unit}`)] : [];
    this.element = make("figure", { class: "rp-chart" }, make("figcaption", {}, make("b", {}, facts.title), ...extra, ...unit), this.host, this.values, this.data);
  }

  /** Takes other lines. */
  show(content: Content): void {
    this.content = content;
    const parts = content.lines.map((line) => make("span", { class: "rp-value" }, swatch(line.run), make("span", {})));
    this.numbers.splice(0, Infinity, ...parts.map((part) => part.lastElementChild as HTMLElement));
    this.values.replaceChildren(this.at, ...parts);
    this.build();
  }

  resize(width: number): void {
    if (Math.abs(width - this.width) >= 1) {
      this.width = width;
      if (this.plot) {
        this.plot.setSize({ width, height: HEIGHT });
        this.go(this.time, false);
      } else {
        this.build();
      }
    }
  }

  /** Moves the line of the time. */
  go(t: number, playing: boolean): void {
    this.time = t;
    const { plot } = this;
    if (!plot) {
      return;
    }
    const x = plot.valToPos(t, "x");
    this.nowLine.style.transform = `translateX(${x.toFixed(2)}px)`;
    if (this.facts.growing) {
      this.future.style.left = `${x.toFixed(2)}px`;
    }
    const now = performance.now();
    if (!playing || now - this.told > 200) {
      this.told = now;
      this.tell();
    }
  }

  /** Draws anew, as after a change of colours. */
  build(): void {
    this.plot?.destroy();
    this.plot = null;
    const { content, facts, host, width } = this;
    if (width < 40 || content.at.length === 0) {
      return;
    }
    const style = getComputedStyle(this.element);
    const long = facts.unit.length > LONG;
    const [inkColour, rule] = [style.getPropertyValue("--rp-soft").trim(), style.getPropertyValue("--rp-rule").trim()];
    const font = `12px ${style.fontFamily}`;
    const axis = { stroke: inkColour, grid: { stroke: rule, width: 1 }, ticks: { stroke: rule, width: 1, size: 5 }, font, labelFont: font, labelSize: 18 };
    const positive = content.lines.flatMap((line) => Array.from(line.values).filter((value) => value > 0));
    const low = positive.reduce((least, value) => Math.min(least, value), Infinity);
    const high = positive.reduce((most, value) => Math.max(most, value), 0);
    const decade = (x: number, up: boolean): number => 10 ** (up ? Math.ceil(Math.log10(x) + 0.05) : Math.floor(Math.log10(x)));
    const range: [number, number] = facts.log ? [decade(Math.max(low, 1e-17), false), decade(Math.max(high, 1e-16), true)] : [0, high * 1.16 || 1];
    const options: uPlot.Options = {
      width,
      height: HEIGHT,
      padding: [8, 14, 0, 0],
      legend: { show: false },
      cursor: { y: false, drag: { x: false, y: false }, points: { size: 5 } },
      select: { show: false, left: 0, top: 0, width: 0, height: 0 },
      scales: { x: { time: false, range: [0, facts.end || 1] }, y: facts.log ? { distr: 3, log: 10, range } : { range } },
      axes: [
        { ...axis, label: `time, ${facts.timeUnit}`, size: 34 },
        {
          ...axis,
          label: long ? facts.axis : `${facts.axis}, ${facts.unit}`,
          size: 50,
          ...(facts.log ? { splits: () => decades(range), filter: (_: uPlot, splits: number[]) => splits } : {}),
          values: (_, splits) => splits.map((value) => (facts.log ? `1e${Math.round(Math.log10(value))}`.replace(/^1e0$/, "1") : short(value))),
        },
      ],
      series: [
        {},
        ...content.lines.map((line) => ({
          label: line.label,
          stroke: inkNow(line.run),
          width: 1.8,
          dash: ink(line.run).dash,
          points: { show: false },
        })),
      ],
      hooks: { draw: [(plot) => this.marks(plot), (plot) => this.labels(plot)] },
    };
    const columns = content.lines.map((line) => Array.from(line.values, (value) => (Number.isFinite(value) && (!facts.log || value > 0) ? value : null)));
    this.plot = new uPlot(options, [Array.from(content.at), ...columns] as uPlot.AlignedData, host);
    this.plot.over.append(this.nowLine);
    if (facts.growing) {
      this.plot.over.append(this.future);
    }
    this.hold(this.plot);
    this.go(this.time, false);
    this.fill();
  }

  destroy(): void {
    this.plot?.destroy();
    this.plot = null;
  }

  /** A press on the plot, and what is dragged from there, is a time. */
  private hold(plot: uPlot): void {
    const { over } = plot;
    const seek = (event: PointerEvent): void => {
      const box = over.getBoundingClientRect();
      this.facts.seek(plot.posToVal(event.clientX - box.left, "x"));
    };
    over.addEventListener("pointerdown", (event) => {
      over.setPointerCapture(event.pointerId);
      seek(event);
    });
    over.addEventListener("pointermove", (event) => {
      if ((event.buttons & 1) !== 0) {
        seek(event);
      }
    });
  }

  /** Upright lines at partings and at the horizon. */
  private marks(plot: uPlot): void {
    const { ctx: pen, bbox } = plot;
    const style = getComputedStyle(this.element);
    const upright = (t: number, colour: string, dash: number[], word: string): void => {
      const x = plot.valToPos(t, "x", true);
      pen.save();
      pen.strokeStyle = colour;
      pen.fillStyle = colour;
      pen.lineWidth = devicePixelRatio;
      pen.setLineDash(dash.map((part) => part * devicePixelRatio));
      pen.beginPath();
      pen.moveTo(x, bbox.top);
      pen.lineTo(x, bbox.top + bbox.height);
      pen.stroke();
      pen.font = `${10.5 * devicePixelRatio}px ${style.fontFamily}`;
      const wide = pen.measureText(word).width;
      const right = x + wide + 8 * devicePixelRatio < bbox.left + bbox.width;
      pen.textAlign = right ? "left" : "right";
      pen.fillText(word, x + (right ? 4 : -4) * devicePixelRatio, bbox.top + 10 * devicePixelRatio);
      pen.restore();
    };
    if (this.facts.partings.length > 0) {
      upright(this.facts.partings[0], style.getPropertyValue("--rp-bad").trim(), [], "first divergence");
    }
    for (const t of this.facts.partings.slice(1)) {
      upright(t, style.getPropertyValue("--rp-bad").trim(), [2, 3], "");
    }
    if (this.facts.horizon !== null) {
      upright(this.facts.horizon, style.getPropertyValue("--rp-soft").trim(), [6, 3], "horizon");
    }
  }

  /** The name of each line where it is alone enough to carry it. */
  private labels(plot: uPlot): void {
    const { ctx: pen, bbox } = plot;
    const { lines, at } = this.content;
    if (lines.length < 2) {
      return;
    }
    const ratio = devicePixelRatio;
    const height = 12 * ratio;
    pen.save();
    pen.font = `600 ${11 * ratio}px ${getComputedStyle(this.element).fontFamily}`;
    pen.textAlign = "center";
    const placed: { x: number; y: number; w: number }[] = [];
    lines.forEach((line, own) => {
      const w = pen.measureText(line.label).width + 6 * ratio;
      let best = { x: 0, y: 0, room: 0 };
      for (let x = bbox.left + w / 2 + 2 * ratio; x < bbox.left + bbox.width - w / 2; x += bbox.width / 60) {
        // heights of all lines along the words
        const columns = [-0.5, -0.25, 0, 0.25, 0.5].map((part) => {
          const t = plot.posToVal((x + part * w - bbox.left) / ratio, "x");
          return lines.map((other) => plot.valToPos(valueAt(at, other.values, t), "y", true));
        });
        const mine = columns.map((column) => column[own]);
        if (!mine.every(Number.isFinite)) {
          continue;
        }
        const y = Math.min(...mine) - 5 * ratio;
        const middle = y - height / 3;
        const others = columns.flatMap((column) => column.filter((value, index) => index !== own && Number.isFinite(value))).map((value) => Math.abs(value - middle) - height / 2);
        const lonely = columns.flatMap((column) => column.filter((value, index) => index !== own && Number.isFinite(value)).map((value) => Math.abs(value - column[own]) - 9 * ratio));
        const taken = placed.map((label) => Math.max(Math.abs(label.x - x) - (label.w + w) / 2, Math.abs(label.y - y) - height));
        const steep = Math.max(...mine) - Math.min(...mine);
        const room = Math.min(40 * ratio, y - height - bbox.top - 12 * ratio, ...others, ...lonely, ...taken) - 0.6 * steep;
        if (room > best.room) {
          best = { x, y, room };
        }
      }
      if (best.room > 0) {
        pen.fillStyle = inkNow(line.run);
        pen.fillText(line.label, best.x, best.y);
        placed.push({ x: best.x, y: best.y, w });
      }
    });
    pen.restore();
  }

  /** Values at the time shown, in words. */
  private tell(): void {
    const { content, facts } = this;
    say(this.at, content.lines.length > 0 ? `${timeText(this.time, facts.end)} ${facts.timeUnit}:` : "");
    content.lines.forEach((line, i) => say(this.numbers[i], `${line.label} ${short(valueAt(content.at, line.values, this.time))}`));
    if (this.data.open) {
      this.fill();
    }
  }

  /** The table: even steps, and now. */
  private fill(): void {
    if (!this.data.open) {
      return;
    }
    const { content, facts } = this;
    const row = (t: number, name: string): HTMLTableRowElement =>
      make("tr", {}, make("th", { scope: "row", class: "r" }, name), ...content.lines.map((line) => make("td", { class: "r" }, short(valueAt(content.at, line.values, t)))));
    const even = Array.from({ length: ROWS }, (_, i) => (facts.end * i) / (ROWS - 1));
    const shown = facts.growing ? even.filter((t) => t <= this.time) : even;
    const head = make("tr", {}, make("th", { scope: "col", class: "r" }, `time, ${facts.timeUnit}`), ...content.lines.map((line) => make("th", { scope: "col", class: "r" }, line.label)));
    this.table.replaceChildren(make("caption", {}, `${facts.axis}, ${facts.unit}`), make("thead", {}, head), make("tbody", {}, row(this.time, `now: ${timeText(this.time, facts.end)}`), ...shown.map((t) => row(t, timeText(t, facts.end)))));
  }
}

/** Powers of ten within a range, no more than there is room for. */
function decades([low, high]: [number, number]): number[] {
  const [from, to] = [Math.round(Math.log10(low)), Math.round(Math.log10(high))];
  const every = Math.max(1, Math.ceil((to - from) / 6));
  const powers: number[] = [];
  for (let power = Math.ceil(from / every) * every; power <= to; power += every) {
    powers.push(10 ** power);
  }
  return powers;
}
