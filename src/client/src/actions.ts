// What a reader can do, by button, key or hand.
import type { Camera } from "./view.ts";

export interface Actions {
  /** Plays or pauses. */
  toggle(): void;
  /** To a time, s, as a reader's own choice: it pauses nothing and ends a parting's call. */
  seek(t: number): void;
  /** By a part of the whole shot. */
  nudge(part: number): void;
  /** To the next (1) or the one before (-1) of the events. */
  event(way: 1 | -1): void;
  /** To where runs part: the first, or the next where that is shown already; or the one with this index. */
  parting(index?: number): void;
  rate(factor: number): void;
  /** One up or down in the list of rates. */
  faster(way: 1 | -1): void;
  look(camera: Camera): void;
  apart(on: boolean): void;
  trails(on: boolean): void;
  marks(on: boolean): void;
  /** Shows or hides a run. */
  show(run: number, on: boolean): void;
  /** Makes a run the one whose balls are solid. */
  solid(run: number): void;
  /** The ball that the plots follow, -1 for all. */
  follow(ball: number): void;
}

export const RATES = [0.05, 0.1, 0.25, 0.5, 1, 2, 4, 10];
