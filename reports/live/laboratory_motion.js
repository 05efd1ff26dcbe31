// What is tried in the laboratory: step, scheme, one datum -> rows of the scheme beside the true motion.
// Enters: `data`, the generated functions, `march` and `follow`.  Leaves: `motion`, which the drawing and the panels read.
// Points of the true motion from row to row of the file.
const FINE = 16;
/** @type {string[]} */
const names = data.given_order.filter((name) => name in data.sliders);
/** @type {Tried} */
const tried = { halvings: 0, scheme: data.scheme, datum: names[0] ?? null, value: null };

// Newton's rule on what the links close, with the least change; false where it does not settle.
/** @type {(q: Float64Array, d: any) => boolean} */
const settle = (q, d) => {
  const f = data.moved.length, k = data.closed;
  const out = new Float64Array(k * (1 + f));
  for (let tries = 0; tries < 25; tries++) {
    closing(0, q, d, out);
    /** @type {(r: number, c: number) => number} */
    const J = (r, c) => out[k + r * f + c];
    const n = Math.min(k, f), wide = k <= f;
    const entries = [], right = [];
    for (let r = 0; r < n; r++) {
      for (let c = 0; c < n; c++) {
        let total = 0;
        if (k === f) total = J(r, c);
        else for (let i = 0; i < Math.max(k, f); i++) total += wide ? J(r, i) * J(c, i) : J(i, r) * J(i, c);
        entries.push(total);
      }
      let known = 0;
      if (wide) known = -out[r];
      else for (let i = 0; i < k; i++) known -= J(i, r) * out[i];
      right.push(known);
    }
    const found = _solve([...entries, ...right]);
    let size = 0;
    for (let c = 0; c < f; c++) {
      let change = found[c];
      if (k < f) {
        change = 0;
        for (let r = 0; r < k; r++) change += J(r, c) * found[r];
      }
      size = Math.max(size, abs(change));
      q[data.moved[c]] += change;
    }
    if (!(size < 10)) return false;
    if (size < 1e-12) return true;
  }
  return false;
};

// The start for other data: the position that closes, followed from that of the file; null where there is none.
/** @type {(d: any) => Float64Array | null} */
const startFor = (d) => {
  const q = Float64Array.from(data.start);
  if (tried.value === null || !data.followed.includes(tried.datum)) return q;
  const place = data.given_order.indexOf(tried.datum), from = data.given[tried.datum];
  const way = Float64Array.from(d);
  for (let i = 1; i <= 16; i++) {
    way[place] = from + ((tried.value - from) * i) / 16;
    if (!settle(q, way)) return null;
  }
  return q;
};

// Between rows: along the straight way that Euler's step goes, or by Hermite's cubic, which takes the slopes of both rows: the
// chord of a better scheme is far more off than its rows are, and that of closed positions opens between them.
/** @type {(rows: Rows, t: number, into: Float64Array) => Float64Array} */
const interpolated = (rows, t, into) => {
  const i = Math.min(Math.max(Math.floor(t / rows.h), 0), Math.max(rows.n - 2, 0)), share = t / rows.h - i, rest = 1 - share;
  const next = i + 1 < rows.n ? i + 1 : i, isBent = data.forces?.free || data.schemes[rows.name ?? data.precise].order > 1;
  const bent = next > i && isBent ? share * rest : 0;
  for (let k = 0; k < m; k++) {
    const from = rows.q[i * m + k], way = rows.q[next * m + k] - from;
    const slopes = bent && bent * (rest * (rows.h * rows.u[i * width + k] - way) - share * (rows.h * rows.u[next * width + k] - way));
    into[k] = from + share * way + slopes;
  }
  return into;
};

const motion = /** @type {Motion} */ ({
  d: null, start: null, h: data.step, truth: null, rows: table(), worst: null, first: null,
  // The true motion of `made` is kept while only step and scheme are moved; `drawn` tells one true motion from another.
  made: "", drawn: "", fine: table(), next: table(), rough: table(), spare: table(), timed: table(),
  // Take over what is tried: the data, the start that goes with them, the step.
  choose() {
    const chosen = tried.value === null ? "" : `${tried.datum} ${tried.value}`;
    if (chosen !== this.chosen) {
      this.chosen = chosen;
      this.d = Float64Array.from(data.numbers);
      if (tried.value !== null) this.d[data.given_order.indexOf(tried.datum)] = tried.value;
      this.start = startFor(this.d);
    }
    this.h = data.step / 2 ** tried.halvings;
    // What is as good as the true motion at its own points is measured by one made with still smaller steps.
    this.inside = data.schemes[tried.scheme].order < 4 ? 1 : Math.max(1, 2 ** (tried.halvings - 2));
    this.wanted = `${chosen} ${this.inside}`;
    this.stop = tried.value === null ? data.stop : null;
  },
  // How many evaluations `compute` will make.
  get cost() {
    /** @type {(h: number) => number} */
    const steps = (h) => Math.max(1, wholeSteps(h, data.end));
    const own = steps(this.h) * data.schemes[tried.scheme].inner.length;
    return own + (this.wanted === this.made ? 0 : steps(data.step / FINE) * this.inside * data.schemes[data.precise].inner.length);
  },
  // The same with one step a row for the true motion and none finer for the table: enough to draw, not to be read.
  sketch() {
    this.worst = null;
    this.truth = this.start && this.rough;
    this.drawn = `rough ${this.chosen}`;
    if (this.start) drain(follow(this.rough, data.step, 1, this.start, this.d, this.stop));
    drain(this.again(this.rows, Math.max(this.h, data.step)));
  },
  // Compute what has changed since the last time: the true motion goes with the datum alone.  What is shown changes at the end.
  *compute() {
    let truth = this.start && this.fine;
    if (truth && this.wanted !== this.made) {
      truth = this.next;
      yield* follow(truth, data.step / FINE, this.inside, this.start, this.d, this.stop);
    }
    yield* this.again(this.spare, this.h, truth);
    [this.rows, this.spare, this.truth] = [this.spare, this.rows, truth];
    if (truth === this.next) [this.fine, this.next] = [this.next, this.fine];
    if (truth) this.made = this.wanted;
    this.drawn = this.wanted;
    this.worst = truth ? largestError(this.rows, truth) : { value: NaN, place: 0, row: 1 };
    this.first ??= { ...this.worst, evaluations: this.rows.evaluations };
  },
  // March once more, with what is tried now or another scheme: what the stop-watch times.
  /** @this {Motion} */
  *again(into = this.timed, h = this.h, truth = this.truth, scheme = tried.scheme) {
    if (truth) yield* march(into, scheme, h, this.start, this.d, truth.dead);
    else Object.assign(clear(into, h, 0), { lost: true });
  },
  get dead() {
    return this.truth ? this.truth.dead : null;
  },
  // The number of rows that a table of this step has, whether or not the scheme gets so far.
  get count() {
    const last = wholeSteps(this.h, data.end);
    return 1 + Math.max(0, this.dead === null ? last : Math.min(last, rowsBefore(this.dead, this.h) - 1));
  },
  // What is short beside the change of a velocity (s).
  get grain() {
    return this.h / 32;
  },
  get duration() {
    return (this.count - 1) * this.h;
  },
  // Where everything drawn is at t (s), flat x, y in m; null where that motion has no such time or a point no place.
  at(true_, t) {
    const rows = true_ ? this.truth : this.rows;
    if (!rows?.n || t > (rows.n - 1) * rows.h * (1 + 1e-9)) return null;
    const place = places(t, interpolated(rows, t, new Float64Array(m)), this.d, new Float64Array(2 * data.points.length));
    return finite(place) ? place : null;
  },
  // A velocity of the table at t, null where there is none.
  rate(true_, t, name) {
    const k = data.velocities.indexOf(name), rows = true_ ? this.truth : this.rows;
    if (k < 0 || !rows || !rows.n) return null;
    const i = Math.min(Math.max(Math.floor(t / rows.h), 0), rows.n - 1), from = rows.u[i * width + k];
    return from + (t / rows.h - i) * (rows.u[Math.min(i + 1, rows.n - 1) * width + k] - from);
  },
  // The column of a coordinate or velocity in one motion: how many rows, and the value of each.
  column(true_, name) {
    const rows = (true_ ? this.truth : this.rows) ?? table(), place = data.coordinates.indexOf(name);
    const from = place < 0 ? data.velocities.indexOf(name) : place, [values, step] = place < 0 ? [rows.u, width] : [rows.q, m];
    return { n: rows.n, h: rows.h, value: (i) => values[i * step + from] };
  },
});
