// Work in slices, so that nothing waits for it longer than a frame lasts.
// Enters: generators that yield how much they have done (evaluations, and what else costs as much), or FRAME where the rest
// may wait until what is done so far is on the screen.  Leaves: `work`.
const AT_ONCE = 8000, SLICE = 4000, FRAME = -1, FRAME_LASTS = 17;

const work = {
  waiting: 0,
  // Do a job in place of the one before it: so much of it now, the rest whenever the page has nothing else to do.
  begin(job, most = AT_ONCE) {
    this.job = job;
    this.go(most);
  },
  // Do a job when nothing else has been begun for so long (ms).
  later(wait, job) {
    clearTimeout(this.waiting);
    this.waiting = setTimeout(() => this.begin(job), wait);
  },
  go(most) {
    clearTimeout(this.waiting);
    for (let done = 0; done < most; ) {
      const { value, done: ended } = this.job.next();
      if (ended) return;
      if (value === FRAME) return (this.waiting = setTimeout(() => this.go(SLICE), FRAME_LASTS));
      done += value;
    }
    this.waiting = setTimeout(() => this.go(SLICE), 0);
  },
};
