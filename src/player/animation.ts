/** Something that moves by itself: a passage of a parameter, a glide to another state. */
export interface Animation {
  readonly running: boolean;
  /** Calls `step` with the share 0 … 1 of the time that has passed; then `done`. */
  start(seconds: number, step: (share: number) => void, done: () => void): void;
  /** Stops where it is, without `done`. */
  stop(): void;
  /** Holds while nobody can see it: no frames, no timers. */
  hold(held: boolean): void;
}

export function createAnimation(): Animation {
  let frame = 0;
  let held = false;
  let passed = 0;
  let last: number | null = null;
  let job: { seconds: number; step: (share: number) => void; done: () => void } | null = null;

  const tick = (now: number) => {
    frame = 0;
    if (!job) return;
    if (last !== null) passed += Math.min(0.1, (now - last) / 1000);
    last = now;
    const share = Math.min(1, passed / job.seconds);
    const { step, done } = job;
    step(share);
    if (!job) return;
    if (share < 1) ask();
    else {
      job = null;
      done();
    }
  };
  const ask = () => {
    if (!frame && job && !held) frame = requestAnimationFrame(tick);
  };
  const stop = () => {
    cancelAnimationFrame(frame);
    frame = 0;
    job = null;
  };
  return {
    get running() {
      return job !== null;
    },
    start(seconds, step, done) {
      stop();
      job = { seconds, step, done };
      passed = 0;
      last = null;
      ask();
    },
    stop,
    hold(next) {
      held = next;
      last = null;
      if (held) {
        cancelAnimationFrame(frame);
        frame = 0;
      } else ask();
    },
  };
}
