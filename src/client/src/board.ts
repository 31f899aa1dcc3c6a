// The table from above, flat, on a 2D canvas: for browsers without WebGL, and for those who like it better.
import { course, LIFE, type Mark, marks } from "./course.ts";
import type { Frame, Scatter } from "./frame.ts";

import { outline } from "./outline.ts";
import { ink, paint } from "./palette.ts";
import { CLOTH, CUSHION, grow, type Rect, sights, type Stage, WOOD } from "./stage.ts";
import { apartness, type Cell, cellAt, cells, type Choice, closeness, ghosts, tables, type View } from "./view.ts";

/** From places on the cloth, R, to places in the picture, CSS px. */
interface Lens {
  scale: number;
  lying: boolean;
  /** Middle of the cell, and what is shown there. */
  px: number;
  py: number;
  cx: number;
  cy: number;
}

export class Board implements View {
  readonly canvas = document.createElement("canvas");
  private readonly pen: CanvasRenderingContext2D;
  private readonly marksOf = new Map<number, Mark[]>();
  private readonly lines = new Map<number, Float64Array[]>();
  private width = 1;
  private height = 1;
  private ratio = 1;
  private closer = 1;
  /** What stands in the middle, from the middle of everything, R; and how far the reader moved it, px. */
  private middle: [number, number] = [0, 0];
  private shift: [number, number] = [0, 0];
  private drawn: { frame: Frame; choice: Choice } | null = null;

  constructor(
    private readonly stage: Stage,
    private readonly still: () => boolean,
  ) {
    const pen = this.canvas.getContext("2d");
    if (!pen) {
      throw new Error("this browser has no canvas");
    }
    this.pen = pen;
  }

  look(): void {
    this.close(null);
  }

  close(rect: Rect | null): void {
    const { zoom, x, y } = rect ? closeness(this.stage.sight, rect) : { zoom: 1, x: 0, y: 0 };
    this.closer = 1 / zoom;
    this.middle = [x, y];
    this.shift = [0, 0];
  }

  orbit(right: number, down: number): void {
    this.pan(-right, down);
  }

  zoom(factor: number): void {
    this.closer = Math.min(25, Math.max(0.5, this.closer / factor));
  }

  pan(right: number, up: number): void {
    this.shift[0] -= right * this.height;
    this.shift[1] += up * this.height;
  }

  resize(width: number, height: number): void {
    this.width = Math.max(1, width);
    this.height = Math.max(1, height);
    this.ratio = Math.min(2, window.devicePixelRatio || 1);
    this.canvas.width = Math.round(this.width * this.ratio);
    this.canvas.height = Math.round(this.height * this.ratio);
  }

  draw(frame: Frame, choice: Choice, rate: number): boolean {
    this.drawn = { frame, choice };
    const { pen, ratio } = this;
    pen.setTransform(ratio, 0, 0, ratio, 0, 0);
    pen.clearRect(0, 0, this.width, this.height);
    const all = tables(choice);
    const { cells: parts, lying } = cells(this.stage.sight, all.length, this.width, this.height);
    all.forEach((run, i) => {
      const cell = parts[i];
      pen.save();
      pen.beginPath();
      pen.rect(cell.x, cell.y, cell.width, cell.height);
      pen.clip();
      this.one(frame, choice, run, rate, this.lens(cell, lying));
      pen.restore();
    });
    return false;
  }

  pick(px: number, py: number): number {
    if (!this.drawn) {
      return -1;
    }
    const { frame, choice } = this.drawn;
    const all = tables(choice);
    const { cells: parts, lying } = cells(this.stage.sight, all.length, this.width, this.height);
    const index = cellAt(parts, px, py);
    if (index < 0) {
      return -1;
    }
    const lens = this.lens(parts[index], lying);
    const scatter = frame.scatters[all[index]];
    let best = { ball: -1, distance: 18 };
    for (let ball = 0; ball < scatter.present.length; ball += 1) {
      const [x, y] = through(lens, scatter.positions[3 * ball], scatter.positions[3 * ball + 1]);
      const distance = Math.hypot(x - px, y - py);
      if (scatter.present[ball] && distance < best.distance) {
        best = { ball, distance };
      }
    }
    return best.ball;
  }

  dispose(): void {
    this.canvas.remove();
  }

  private lens(cell: Cell, lying: boolean): Lens {
    const { sight } = this.stage;
    const [wide, tall] = [sight.x1 - sight.x0, sight.y1 - sight.y0];
    const scale = 0.96 * this.closer * Math.min(cell.width / (lying ? tall : wide), cell.height / (lying ? wide : tall));
    return {
      scale,
      lying,
      px: cell.x + cell.width / 2 + this.shift[0],
      py: cell.y + cell.height / 2 + this.shift[1],
      cx: (sight.x0 + sight.x1) / 2 + this.middle[0],
      cy: (sight.y0 + sight.y1) / 2 + this.middle[1],
    };
  }

  private one(frame: Frame, choice: Choice, run: number, rate: number, lens: Lens): void {
    const scatter = frame.scatters[run];
    const others = ghosts(choice, run);
    this.table(lens);
    if (choice.trails) {
      others.forEach((index) => this.trails(index, frame.time, true, lens));
      this.trails(run, frame.time, false, lens);
    }
    if (choice.marks) {
      this.rings(run, frame.time, LIFE * rate, lens);
    }
    this.ring(lens, scatter, choice.ball, 1.2, 0.1, "rgba(255,255,255,.8)");
    for (let ball = 0; ball < this.stage.radii.length; ball += 1) {
      if (scatter.present[ball]) {
        this.ball(lens, scatter, ball);
      }
    }
    others.forEach((index) => this.ghosts(lens, frame.scatters[index], scatter, index));
    for (const ball of choice.called) {
      this.ring(lens, scatter, ball, 1.11, 0.18, "#ffe98a");
    }
  }

  private table(lens: Lens): void {
    const { pen, stage } = this;
    const fill = (points: [number, number][], colour: string): void => {
      pen.beginPath();
      for (const [x, y] of points) {
        pen.lineTo(...through(lens, x, y));
      }
      pen.closePath();
      pen.fillStyle = colour;
      pen.fill();
    };
    const box = (rect: { x0: number; y0: number; x1: number; y1: number }): [number, number][] => [
      [rect.x0, rect.y0],
      [rect.x1, rect.y0],
      [rect.x1, rect.y1],
      [rect.x0, rect.y1],
    ];
    if (stage.table) {
      fill(rounded(grow(stage.table, CUSHION + WOOD), 2.4), "#6b3a20");
      fill(rounded(grow(stage.table, CUSHION + WOOD - 0.3), 2.1), "#5a2f19");
      fill(outline(grow(stage.table, CUSHION), stage.pockets).points, "#0d5f46");
      for (const [x, y] of sights(stage.table, stage)) {
        this.disc(lens, x, y, 0.24, "#efe6d2");
      }
    }
    fill(box(stage.cloth), CLOTH);
    for (const { x, y, r } of stage.pockets) {
      this.disc(lens, x, y, r, "#0a0908");
    }
  }

  private disc(lens: Lens, x: number, y: number, r: number, colour: string): void {
    const { pen } = this;
    pen.beginPath();
    pen.arc(...through(lens, x, y), Math.max(0.5, r * lens.scale), 0, 2 * Math.PI);
    pen.fillStyle = colour;
    pen.fill();
  }

  private ball(lens: Lens, scatter: Scatter, ball: number): void {
    const { pen, stage } = this;
    const { colour, striped, label, spotted } = paint(stage.data.balls[ball].id, ball);
    const [x, y] = [scatter.positions[3 * ball], scatter.positions[3 * ball + 1]];
    const [px, py] = through(lens, x, y);
    const r = Math.max(1.5, stage.radii[ball] * lens.scale);
    this.disc(lens, x + 0.12, y - 0.12, stage.radii[ball], "rgba(0,0,0,.3)");
    pen.save();
    pen.beginPath();
    pen.arc(px, py, r, 0, 2 * Math.PI);
    pen.fillStyle = striped ? "#f4efe2" : colour;
    pen.fill();
    pen.clip();
    if (striped) {
      pen.fillStyle = colour;
      pen.fillRect(px - r, py - 0.55 * r, 2 * r, 1.1 * r);
    }
    if (spotted) {
      pen.fillStyle = "#c4202b";
      pen.beginPath();
      pen.arc(px, py, 0.16 * r, 0, 2 * Math.PI);
      pen.fill();
    }
    pen.restore();
    if (label && r > 5) {
      pen.fillStyle = "#f4efe2";
      pen.beginPath();
      pen.arc(px, py, 0.5 * r, 0, 2 * Math.PI);
      pen.fill();
      pen.fillStyle = "#16181a";
      pen.font = `700 ${Math.round((label.length > 2 ? 0.42 : label.length > 1 ? 0.58 : 0.75) * r)}px Arial, sans-serif`;
      pen.textAlign = "center";
      pen.textBaseline = "middle";
      pen.fillText(label, px, py + 0.03 * r);
    }
  }

  private ghosts(lens: Lens, scatter: Scatter, solid: Scatter, run: number): void {
    const { pen, stage } = this;
    const { cloth, dash } = ink(run);
    for (let ball = 0; ball < stage.radii.length; ball += 1) {
      const amount = !scatter.present[ball] ? 0 : solid.present[ball] ? apartness(scatter.positions, solid.positions, ball) : 1;
      if (amount <= 0) {
        continue;
      }
      pen.globalAlpha = amount;
      pen.beginPath();
      pen.arc(...through(lens, scatter.positions[3 * ball], scatter.positions[3 * ball + 1]), Math.max(1.5, stage.radii[ball] * lens.scale), 0, 2 * Math.PI);
      pen.fillStyle = `${cloth}44`;
      pen.fill();
      pen.strokeStyle = cloth;
      pen.lineWidth = 2;
      pen.setLineDash(dash.map((part) => part * 0.6));
      pen.stroke();
    }
    pen.globalAlpha = 1;
    pen.setLineDash([]);
  }

  private ring(lens: Lens, scatter: Scatter, ball: number, r: number, width: number, colour: string): void {
    if (ball < 0 || !scatter.present[ball]) {
      return;
    }
    const { pen } = this;
    pen.beginPath();
    pen.arc(...through(lens, scatter.positions[3 * ball], scatter.positions[3 * ball + 1]), r * this.stage.radii[ball] * lens.scale, 0, 2 * Math.PI);
    pen.strokeStyle = colour;
    pen.lineWidth = Math.max(1.2, width * lens.scale);
    pen.stroke();
  }

  private rings(run: number, now: number, life: number, lens: Lens): void {
    const { pen } = this;
    let all = this.marksOf.get(run);
    if (!all) {
      all = marks(this.stage, this.stage.runs[run]);
      this.marksOf.set(run, all);
    }
    for (const mark of all) {
      const age = (now - mark.at) / life;
      if (age < 0 || age > 1) {
        continue;
      }
      pen.beginPath();
      pen.arc(...through(lens, mark.x, mark.y), mark.r * lens.scale * (this.still() ? 1 : 1 + 0.9 * age), 0, 2 * Math.PI);
      pen.strokeStyle = `rgba(255,247,217,${0.9 * (1 - age)})`;
      pen.lineWidth = 2;
      pen.stroke();
    }
  }

  private trails(run: number, now: number, ghost: boolean, lens: Lens): void {
    const { pen, stage } = this;
    let lines = this.lines.get(run);
    if (!lines) {
      lines = stage.runs[run].paths.map((path, ball) => course(path, stage.runs[run].leaves[ball]));
      this.lines.set(run, lines);
    }
    pen.lineWidth = 1.5;
    pen.globalAlpha = 0.7;
    pen.setLineDash(ghost ? [5, 4] : []);
    lines.forEach((line, ball) => {
      pen.strokeStyle = ghost ? ink(run).cloth : paint(stage.data.balls[ball].id, ball).colour;
      pen.beginPath();
      for (let i = 0; i < line.length && line[i] <= now; i += 3) {
        pen.lineTo(...through(lens, line[i + 1], line[i + 2]));
        if (i + 3 < line.length && line[i + 3] > now) {
          const part = (now - line[i]) / (line[i + 3] - line[i]);
          pen.lineTo(...through(lens, line[i + 1] + part * (line[i + 4] - line[i + 1]), line[i + 2] + part * (line[i + 5] - line[i + 2])));
        }
      }
      pen.stroke();
    });
    pen.globalAlpha = 1;
    pen.setLineDash([]);
  }
}

/** A rectangle with round corners, as a polygon. */
function rounded(rect: Rect, r: number): [number, number][] {
  const corners: [number, number, number][] = [
    [rect.x1 - r, rect.y1 - r, 0],
    [rect.x0 + r, rect.y1 - r, 1],
    [rect.x0 + r, rect.y0 + r, 2],
    [rect.x1 - r, rect.y0 + r, 3],
  ];
  return corners.flatMap(([x, y, quarter]) =>
    Array.from({ length: 9 }, (_, i): [number, number] => {
      const angle = ((quarter + i / 8) * Math.PI) / 2;
      return [x + r * Math.cos(angle), y + r * Math.sin(angle)];
    }),
  );
}

/** Lying tables have y to the right and x down; standing ones x to the right and y up. */
function through(lens: Lens, x: number, y: number): [number, number] {
  const [dx, dy] = [(x - lens.cx) * lens.scale, (y - lens.cy) * lens.scale];
  return lens.lying ? [lens.px + dy, lens.py + dx] : [lens.px + dx, lens.py - dy];
}
