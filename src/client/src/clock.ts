// The time that is shown, and how it goes on.

/** Seconds of the scene that a replay of unusual length should take to play. */
const COMFORTABLE = 10;

export type Listener = (clock: Clock) => void;

export class Clock {
  private shown = 0;
  private running = false;
  private factor = 1;
  private last = 0;
  private request = 0;
  private readonly listeners = new Set<Listener>();
  /** Scene seconds a second at 1x: 1, or what plays a very short or very long shot in comfortable time. */
  readonly base: number;

  constructor(
    /** s. */
    readonly end: number,
  ) {
    this.base = end >= 0.5 && end <= 120 ? 1 : end / COMFORTABLE || 1;
  }

  get time(): number {
    return this.shown;
  }

  get playing(): boolean {
    return this.running;
  }

  get rate(): number {
    return this.factor;
  }

  set rate(factor: number) {
    this.factor = factor;
    this.tell();
  }

  /** Calls back at every change of time, rate or state. */
  listen(listener: Listener): void {
    this.listeners.add(listener);
  }

  seek(t: number): void {
    this.shown = Math.min(this.end, Math.max(0, Number.isFinite(t) ? t : 0));
    this.tell();
  }

  play(): void {
    if (this.running) {
      return;
    }
    if (this.shown >= this.end) {
      this.shown = 0;
    }
    this.running = true;
    this.last = performance.now();
    this.request = requestAnimationFrame(this.step);
    this.tell();
  }

  pause(): void {
    cancelAnimationFrame(this.request);
    if (this.running) {
      this.running = false;
      this.tell();
    }
  }

  stop(): void {
    this.listeners.clear();
    this.pause();
  }

  private readonly step = (now: number): void => {
    // a page that was in the background goes on where it was
    const passed = Math.min(0.25, Math.max(0, (now - this.last) / 1000));
    this.last = now;
    this.shown = Math.min(this.end, this.shown + passed * this.factor * this.base);
    this.running = this.shown < this.end;
    if (this.running) {
      this.request = requestAnimationFrame(this.step);
    }
    this.tell();
  };

  private tell(): void {
    for (const listener of this.listeners) {
      listener(this);
    }
  }
}
