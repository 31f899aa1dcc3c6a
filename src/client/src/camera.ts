// Where the eye is: from above or free, fitted to what is worth seeing, moved by the reader.
import { type PerspectiveCamera, Vector3 } from "three";
import type { Rect } from "./stage.ts";
import { closeness } from "./view.ts";

/** Field of view, degrees: narrow, so that balls at the edge stay round. */
export const FIELD = 26;
/** Tilt of the free view at the start, and the flattest one, rad. */
const TILT = 0.92;
const FLATTEST = 1.5;
/** How long the eye takes to another place, ms. */
const EASING = 420;

interface Pose {
  /** Angle from straight above, rad. */
  tilt: number;
  /** Turn about the vertical, rad, from the view whose long side lies across the picture. */
  turn: number;
  /** Distance as a part of that which shows everything. */
  zoom: number;
  /** What is looked at, from the middle, R. */
  x: number;
  y: number;
}

export class Eye {
  private pose: Pose = { tilt: 0, turn: 0, zoom: 1, x: 0, y: 0 };
  private from: Pose | null = null;
  private goal: Pose | null = null;
  private began = 0;
  /** The table's long side (y) lies across the picture. */
  lying = true;

  constructor(
    private readonly sight: Rect,
    private readonly floor: number,
    private readonly still: () => boolean,
  ) {}

  /** To one of the two views, gently unless the reader asked for less motion. */
  look(view: "above" | "free"): void {
    this.to({ tilt: view === "above" ? 0 : TILT, turn: view === "above" ? 0 : -0.2, zoom: 1, x: 0, y: 0 });
  }

  /** Comes close to a part of what is in sight, or goes back, from the side that the eye is on. */
  close(rect: Rect | null): void {
    const { tilt, turn } = this.goal ?? this.pose;
    this.to({ tilt, turn, ...(rect ? closeness(this.sight, rect) : { zoom: 1, x: 0, y: 0 }) });
  }

  orbit(turn: number, tilt: number): void {
    const pose = this.settle();
    pose.turn += turn;
    pose.tilt = Math.min(FLATTEST, Math.max(0, pose.tilt + tilt));
  }

  zoom(factor: number): void {
    const pose = this.settle();
    pose.zoom = Math.min(2, Math.max(0.04, pose.zoom * factor));
  }

  /** Moves what is looked at by parts of the picture's height. */
  pan(right: number, up: number, camera: PerspectiveCamera): void {
    const pose = this.settle();
    const scale = 2 * Math.tan((FIELD * Math.PI) / 360) * camera.position.distanceTo(this.target(new Vector3()));
    const a = this.heading();
    pose.x += scale * (right * Math.sin(a) + up * Math.cos(a));
    pose.y += scale * (-right * Math.cos(a) + up * Math.sin(a));
  }

  /** Puts the camera where it belongs at time `now`, ms; true while it is still under way. */
  place(camera: PerspectiveCamera, now: number): boolean {
    const moving = this.ease(now);
    const a = this.heading();
    const { tilt, zoom } = this.pose;
    const ahead = new Vector3(Math.cos(a), Math.sin(a), 0);
    const back = ahead.clone().multiplyScalar(-Math.sin(tilt));
    back.z = Math.cos(tilt);
    const up = ahead.clone().multiplyScalar(Math.cos(tilt));
    up.z = Math.sin(tilt);
    const right = new Vector3(Math.sin(a), -Math.cos(a), 0);
    const target = this.target(new Vector3());
    const fit = this.fit(camera.aspect, right, up, back);
    target.addScaledVector(up, fit.rise * zoom);
    camera.up.copy(up);
    camera.position.copy(target).addScaledVector(back, fit.distance * zoom);
    camera.near = Math.max(0.05, 0.02 * fit.distance * zoom);
    camera.far = 6 * fit.distance * Math.max(1, zoom) + 50;
    camera.lookAt(target);
    camera.updateProjectionMatrix();
    camera.updateMatrixWorld();
    return moving;
  }

  private heading(): number {
    return (this.lying ? Math.PI : Math.PI / 2) + this.pose.turn;
  }

  private target(out: Vector3): Vector3 {
    const { sight, floor, pose } = this;
    return out.set((sight.x0 + sight.x1) / 2 + pose.x, (sight.y0 + sight.y1) / 2 + pose.y, floor);
  }

  /** Distance from which the sight fills the picture, and how far the target must rise for it to stand in the middle. */
  private fit(aspect: number, right: Vector3, up: Vector3, back: Vector3): { distance: number; rise: number } {
    const { sight } = this;
    const [hx, hy] = [(sight.x1 - sight.x0) / 2, (sight.y1 - sight.y0) / 2];
    const tall = Math.tan((FIELD * Math.PI) / 360);
    const wide = tall * aspect;
    const corners = [-1, 1].flatMap((sx) => [-1, 1].flatMap((sy) => [-2.6, 2].map((z) => new Vector3(sx * hx, sy * hy, z))));
    const seen = corners.map((p) => ({ x: p.dot(right), y: p.dot(up), z: p.dot(back) }));
    let rise = 0;
    let distance = 0;
    for (let round = 0; round < 6; round += 1) {
      distance = Math.max(...seen.map((p) => p.z + Math.max(Math.abs(p.x) / wide, Math.abs(p.y - rise) / tall)));
      const heights = seen.map((p) => (p.y - rise) / (distance - p.z));
      rise += ((Math.max(...heights) + Math.min(...heights)) / 2) * distance * 0.8;
    }
    distance = Math.max(...seen.map((p) => p.z + Math.max(Math.abs(p.x) / wide, Math.abs(p.y - rise) / tall)));
    return { distance: distance * 1.04, rise };
  }

  private to(goal: Pose): void {
    if (this.still()) {
      this.pose = goal;
      this.goal = null;
      return;
    }
    this.from = { ...this.pose };
    this.goal = goal;
    this.began = performance.now();
  }

  /** Ends an easing where it is: the reader has taken hold. */
  private settle(): Pose {
    this.goal = null;
    return this.pose;
  }

  private ease(now: number): boolean {
    const { from, goal } = this;
    if (!from || !goal) {
      return false;
    }
    const s = Math.min(1, Math.max(0, (now - this.began) / EASING));
    const k = s * s * (3 - 2 * s);
    const mix = (a: number, b: number): number => a + k * (b - a);
    this.pose = {
      tilt: mix(from.tilt, goal.tilt),
      turn: mix(from.turn, goal.turn),
      zoom: mix(from.zoom, goal.zoom),
      x: mix(from.x, goal.x),
      y: mix(from.y, goal.y),
    };
    if (s >= 1) {
      this.goal = null;
    }
    return s < 1;
  }
}
