// A motion that was computed before: positions of all that is drawn, row by row, where a page cannot compute them itself.
// Enters: `data.frames`.  Leaves: `motion`, which the drawing reads.
const motion = /** @type {Recorded} */ ({
  h: data.step,
  count: data.rows,
  grain: data.frames.step,
  finest: data.frames.finest,
  dead: data.stop,
  get duration() {
    return (this.count - 1) * this.h;
  },
  at(true_, t) {
    const rows = true_ ? data.frames.truth : data.frames.rows;
    // Of a long table every n-th row is kept; what lies behind the last of these stands still.
    const place = Math.min(t / data.frames.step, rows.length - 1), i = Math.floor(place);
    if (!rows.length || t > rows.length * data.frames.step) return null;
    /** @type {number[]} */
    const from = rows[i], to = rows[i + 1] ?? from, share = place - i;
    return from.map((value, k) => value + share * (to[k] - value));
  },
  rate: () => null,
});
const begin = () => {};
const furnish = () => {};
/** @type {(...given: any[]) => void} */
const light = () => {};
