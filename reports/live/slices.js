// Work in slices, so that nothing waits for it longer than a frame lasts.
// Enters: generators that yield how much they have done (evaluations, and what else costs as much), or FRAME where the rest
// may wait until what is done so far is on the screen.  Leaves: `work`.
const AT_ONCE = 8000, SLICE = 4000, FRAME = -1;

/** @type {Work} */
const work = {
  waiting: 0,
  // Do a job in place of the one before it: so much of it now, the rest whenever the page has nothing else to do.
  begin(job, most = AT_ONCE) {
    clearTimeout(this.waiting);
    this.job = job;
    this.go(job, most);
  },
  // Do a job when nothing else has been begun for so long (ms).
  later(wait, job) {
    this.waiting = setTimeout(() => this.begin(job), wait);
  },
  go(job, most) {
    if (job !== this.job) return;
    const on = () => this.go(job, SLICE);
    for (let done = 0; done < most; ) {
      const { value, done: ended } = job.next();
      if (ended) return;
      // A page that nobody looks at has no frames.
      if (value === FRAME && !document.hidden) return requestAnimationFrame(() => setTimeout(on));
      done += Math.max(0, value);
    }
    setTimeout(on);
  },
};
