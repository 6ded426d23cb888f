// The time that the page shows: it runs, stands, and is moved by hand; everything on the page follows it.

/** Time of a run in seconds, from its start to its end. */
export class Clock {
  time: number;
  /** Seconds of the run in a second of the reader. */
  speed = 1;
  private running = false;
  private last = 0;
  private readonly listeners: (() => void)[] = [];

  constructor(
    readonly start: number,
    readonly end: number,
  ) {
    this.time = start;
  }

  /** Calls back whenever the time changed, or whether it runs. */
  onChange(listener: () => void): void {
    this.listeners.push(listener);
  }

  get runs(): boolean {
    return this.running;
  }

  /** Goes to a time; one outside is its nearer end. */
  moveTo(time: number): void {
    this.time = Math.min(this.end, Math.max(this.start, time));
    this.announce();
  }

  /** Runs on, from the start where it is at its end; or stands. */
  toggle(): void {
    this.running = !this.running;
    if (this.running) {
      if (this.time >= this.end) this.time = this.start;
      this.last = performance.now();
      requestAnimationFrame((now) => this.tick(now));
    }
    this.announce();
  }

  private tick(now: number): void {
    if (!this.running) return;
    this.time += (this.speed * (now - this.last)) / 1000;
    this.last = now;
    if (this.time >= this.end) {
      this.time = this.end;
      this.running = false;
    }
    this.announce();
    if (this.running) requestAnimationFrame((next) => this.tick(next));
  }

  private announce(): void {
    for (const listener of this.listeners) listener();
  }
}

/** Index of the last moment that is not after a time; 0 before the first. */
export function momentAt(times: number[], time: number): number {
  let [low, high] = [0, times.length - 1];
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if ((times[middle] as number) <= time) low = middle;
    else high = middle - 1;
  }
  return low;
}
