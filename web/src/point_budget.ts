// How many points are drawn.

const MOST = 3_000_000;
const LEAST = 400_000;
const SLOW_MS = 200; // a frame that takes longer does not follow the hand
const STILL_MS = 1500; // what a picture of a view at rest may take
const REST_MS = 300; // without a movement

/** As many as this machine draws smoothly while the view moves; more of them once it rests. */
export class PointBudget {
  private moving = MOST;
  // Of the frames of late together: one alone may end before what it drew is on the screen.
  private drawn = 0;
  private taken_ms = 0;
  private lastFrame = 0; // [ms]
  private slowFrames = 0; // in a row
  private restsFrom = 0; // [ms]
  private atRest = false;

  get points(): number {
    return this.atRest ? this.still() : this.moving;
  }

  /** Whether this is the finer picture of a view at rest. */
  get resting(): boolean {
    return this.atRest;
  }

  moved(): void {
    this.atRest = false;
  }

  /** Nothing is drawn. */
  idle(now: number): void {
    this.lastFrame = now;
  }

  /** A frame of `shown` points follows the one before. Slow ones in a row ask for fewer points. */
  frame(now: number, shown: number): void {
    const taken_ms = now - this.lastFrame;
    this.lastFrame = now;
    this.restsFrom = now + REST_MS;
    if (this.atRest) return;
    this.drawn = 0.8 * this.drawn + shown;
    this.taken_ms = 0.8 * this.taken_ms + taken_ms;
    this.slowFrames = taken_ms > SLOW_MS ? this.slowFrames + 1 : 0;
    if (this.slowFrames < 3) return;
    this.slowFrames = 0;
    this.moving = Math.max(LEAST, this.moving / 2);
  }

  /** Whether a finer picture of the view is still to come. */
  get unfinished(): boolean {
    return !this.atRest && this.still() > this.moving;
  }

  /** @returns whether the view has rested long enough for it; it has begun then. */
  settle(now: number): boolean {
    if (!this.unfinished || now < this.restsFrom) return false;
    this.atRest = true;
    return true;
  }

  private still(): number {
    return Math.min(MOST, Math.max(2 * this.moving, (STILL_MS * this.drawn) / Math.max(this.taken_ms, 1)));
  }
}
