// A motion that was computed before: positions of all that is drawn, row by row, where a page cannot compute them itself.
// Enters: `data.frames`.  Leaves: `motion`, which the drawing reads.
const motion = {
  h: data.frames.step,
  count: data.frames.truth.length,
  dead: data.stop,
  get duration() {
    return (this.count - 1) * this.h;
  },
  at(true_, t) {
    const rows = true_ ? data.frames.truth : data.frames.rows;
    const i = Math.min(Math.max(Math.floor(t / this.h), 0), Math.max(rows.length - 2, 0));
    if (!rows.length || t > (rows.length - 1) * this.h * (1 + 1e-9)) return null;
    const from = rows[i], to = rows[i + 1] ?? from, share = t / this.h - i;
    return from.map((value, k) => value + share * (to[k] - value));
  },
  rate: () => null,
};
const start = () => {};
