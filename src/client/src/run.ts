// One engine's run, unpacked: paths, events, and when balls leave play.
import { unpack } from "./columns.ts";
import type { ReplayData, RunFacts } from "./format.ts";
import type { Path } from "./path.ts";
import { Turning } from "./turning.ts";

/** One event. Knots keep their times as f32, so `at` is the time at which the paths have it; `time` is what to print. */
export interface Event {
  at: number;
  time: number;
  kind: string;
  a: string;
  b: string;
}

export interface Run {
  facts: RunFacts;
  index: number;
  paths: Path[];
  turnings: Turning[];
  events: Event[];
  /** When each ball falls, s; infinite for those that stay. */
  leaves: Float64Array;
}

/** All runs of a replay. */
export async function runs(data: ReplayData): Promise<Run[]> {
  const order = new Map(data.balls.map((ball, index) => [ball.id, index]));
  return Promise.all(
    data.runs.map(async (facts, index) => {
      const paths = await unpack(facts.knots, data);
      const leaves = new Float64Array(data.balls.length).fill(Infinity);
      const events = facts.events.map(([time, kind, a, b]) => ({ at: Math.fround(time), time, kind, a, b }));
      for (const event of events) {
        const ball = order.get(event.a);
        if (event.kind === "pocket" && ball !== undefined) {
          leaves[ball] = event.at;
        }
      }
      const turnings = data.rotates ? paths.map((path) => new Turning(path)) : [];
      return { facts, index, paths, turnings, events, leaves };
    }),
  );
}

/** An event in words, without its time. */
export function words(event: Event): string {
  switch (event.kind) {
    case "ball-ball":
      return `${event.a} hits ${event.b}`;
    case "ball-cushion":
      return `${event.a} meets cushion ${event.b}`;
    case "stop":
      return `${event.a} stops`;
    case "slide-to-roll":
      return `${event.a} starts to roll`;
    case "spin-end":
      return `${event.a} stops spinning`;
    case "contact-begin":
      return `${event.a} and ${event.b} stay in contact`;
    case "contact-end":
      return `${event.a} and ${event.b} are no longer in contact`;
    case "pocket":
      return `${event.a} falls in pocket ${event.b.replace(/^p/, "")}`;
    default:
      return [event.kind, event.a, event.b].filter(Boolean).join(" ");
  }
}

/** Events up to time t: how many have `at` <= t. */
export function eventsUntil(events: Event[], t: number): number {
  let low = 0;
  let high = events.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (events[middle].at <= t) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return low;
}
