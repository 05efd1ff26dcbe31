// What is tried in the laboratory: step, scheme, one datum -> rows of the scheme beside the true motion.
// Enters: `data` and the functions of numbers.js.  Leaves: `motion`, which the drawing and the panels read.
// Points of the true motion from row to row of the file.
const FINE = 16;
const m = data.coordinates.length;
const names = data.given_order.filter((name) => name in data.sliders);
const tried = { halvings: 0, scheme: data.scheme, datum: names[0] ?? null, value: null };

// Newton's rule on what the links close, with the least change; false where it does not settle.
const settle = (q, d) => {
  const f = data.moved.length, k = data.closed;
  const out = new Float64Array(k * (1 + f));
  for (let tries = 0; tries < 25; tries++) {
    closing(0, q, d, out);
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

const interpolated = (rows, h, t, into) => {
  const i = Math.min(Math.max(Math.floor(t / h), 0), Math.max(rows.length - 2, 0));
  const from = rows[i], to = rows[i + 1] ?? from, share = t / h - i;
  for (let k = 0; k < into.length; k++) into[k] = from[k] + share * (to[k] - from[k]);
  return into;
};

const motion = {
  d: null, truth: null, rows: null, worst: null, first: null, made: "",
  // Compute what has changed since the last time: the true motion goes with the datum alone.
  compute() {
    const d = Float64Array.from(data.numbers);
    if (tried.value !== null) d[data.given_order.indexOf(tried.datum)] = tried.value;
    // What is as good as the true motion at its own points is measured by one made with still smaller steps.
    const inside = data.schemes[tried.scheme].order < 4 ? 1 : Math.max(1, 2 ** (tried.halvings - 2));
    const key = `${tried.value === null ? "" : tried.datum} ${tried.value} ${inside}`;
    if (key !== this.made) {
      this.made = key;
      this.d = d;
      this.start = startFor(d);
      const known = tried.value === null ? data.stop : null;
      this.truth = this.start && follow(data.step / FINE, inside, this.start, d, known);
    }
    this.h = data.step / 2 ** tried.halvings;
    this.rows = this.again();
    this.worst = this.truth ? largestError(this.rows, this.truth) : { value: NaN, place: 0, row: 1 };
    this.first ??= { error: this.worst.value, evaluations: this.rows.evaluations };
  },
  // March once more with what is tried now: what the stop-watch times.
  again() {
    if (!this.truth) return { h: this.h, q: [], u: [], lost: true, evaluations: 0 };
    return march(tried.scheme, this.h, this.start, this.d, this.truth.dead);
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
  // Where everything drawn is at t (s), flat x, y in m; null where that motion has no such time.
  at(true_, t) {
    const [rows, h] = true_ ? [this.truth ? this.truth.q : [], data.step / FINE] : [this.rows.q, this.rows.h];
    if (!rows.length || t > (rows.length - 1) * h * (1 + 1e-9)) return null;
    return places(t, interpolated(rows, h, t, new Float64Array(m)), this.d, new Float64Array(2 * data.points.length));
  },
  // A velocity of the table at t, null where there is none.
  rate(true_, t, name) {
    const k = data.velocities.indexOf(name);
    const [rows, h] = true_ ? [this.truth ? this.truth.u : [], data.step / FINE] : [this.rows.u, this.rows.h];
    const i = Math.min(Math.max(Math.floor(t / h), 0), rows.length - 1);
    return k < 0 || i < 0 ? null : rows[i][k] + (t / h - i) * ((rows[i + 1] ?? rows[i])[k] - rows[i][k]);
  },
  // The column of a coordinate or velocity over all rows of one motion.
  column(true_, name) {
    const rows = true_ ? this.truth : this.rows;
    const place = data.coordinates.indexOf(name);
    if (!rows) return [];
    return place >= 0 ? rows.q.map((at) => at[place]) : rows.u.map((at) => at[data.velocities.indexOf(name)]);
  },
};
