// The data of a replay, format 1: what `report/replay.rs` writes and what the live page's answer holds.

/** One scene as every engine ran it. Lengths in the scene's unit, times in seconds of the scene. */
export interface ReplayData {
  format: number;
  scene: Scene;
  /** Where positions are counted from, in the scene's unit: columns hold (x - origin)/R. */
  origin: [number, number, number];
  /** Unit of lengths in the columns: the smallest radius. */
  R: number;
  /** Edges of the playing surface (cushion noses); null is an unbounded plane. */
  table: { min: [number, number]; max: [number, number] } | null;
  /** Pockets: x, y, radius. */
  pockets: [number, number, number][];
  /** Only then balls turn. */
  rotates: boolean;
  balls: BallFacts[];
  runs: RunFacts[];
  /** Where collision orders first differ, by time. */
  partings: Parting[];
  /** Time up to which the reference can be believed, s; null: the whole shot, or unknown. */
  horizon: number | null;
  divergence: Divergence[];
}

export interface Scene {
  name: string;
  title: string;
  duration: number;
  length_unit: string;
  time_unit: string;
  /** Unit of speeds in the columns. */
  speed_scale: number;
}

export interface BallFacts {
  id: string;
  radius: number;
  mass: number;
  /** 0 where the scene does not call for rotation. */
  inertia: number;
}

/** One engine's run. */
export interface RunFacts {
  label: string;
  engine: string;
  reference: boolean;
  end: number;
  /** Why it ended, in words. */
  ending: string;
  /** What its event times are good to, s. */
  resolution: number;
  events: EventRow[];
  knots: Knots;
}

/** Time, kind and parties as in events.csv. */
export type EventRow = [time: number, kind: string, a: string, b: string];

/** Paths of all balls as packed columns; `columns.ts` unpacks them. */
export interface Knots {
  /** Knots of each ball. */
  counts: number[];
  left_out: number;
  tolerance: number;
  /** base64 of deflate-raw of the columns. */
  bytes: string;
}

/** A first difference between the collision orders of two runs. */
export interface Parting {
  time: number;
  runs: [number, number];
  balls: string[];
  words: string;
}

/** Largest distance of any ball between two runs, in R. */
export interface Divergence {
  run: number;
  against: number;
  points: [number, number][];
}
