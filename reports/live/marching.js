// Tables: the rows of a scheme, the rows of the true motion, and how far the one is from the other.
// Enters: `data` and the generated `rates`.  Leaves: `march`, `follow`, `largestError` over rows in SI.
/** @type {(share: Share, h: number) => number} */
const part = (share, h) => (share[0] * h) / share[1];
// A step that ends at a break of the drive still sees the old formula there.
/** @type {(end: number) => number} */
const latest = (end) => {
  for (let i = 0; i < data.breaks.length; i++) if (abs(end - data.breaks[i]) <= 1e-13 * data.breaks[i]) return end * (1 - 1e-13);
  return Infinity;
};
const m = data.coordinates.length, firstDeterminant = data.velocities.length, width = firstDeterminant + data.determinants;

// Returns a stepper: step(t, q, h, first, d, into) writes the position after h; `first` are the slopes at (t, q).
// `sound` says whether every determinant kept its sign inside the step.
/** @type {(scheme: Scheme) => Stepper} */
const stepper = (scheme) => {
  const slopes = scheme.inner.map(() => new Float64Array(width)), inside = new Float64Array(m);
  /** @type {(row: Sum, q: Float64Array, h: number, into: Float64Array) => Float64Array} */
  const moved = ({ factor, terms }, q, h, into) => {
    const share = part(factor, h), [index, weight] = terms[0], slope = slopes[index];
    for (let i = 0; i < m; i++) into[i] = weight * slope[i];
    for (let k = 1; k < terms.length; k++) {
      const more = terms[k][1], other = slopes[terms[k][0]];
      for (let i = 0; i < m; i++) into[i] += more * other[i];
    }
    for (let i = 0; i < m; i++) into[i] = q[i] + share * into[i];
    return into;
  };
  /** @type {Stepper} */
  const self = {
    sound: true,
    step(t, q, h, first, d, into) {
      slopes[0] = first;
      self.sound = true;
      const last = latest(t + h);
      for (let stage = 1; stage < slopes.length; stage++) {
        const row = scheme.inner[stage], slope = slopes[stage];
        rates(Math.min(t + part(scheme.nodes[stage], h), last), row.terms.length ? moved(row, q, h, inside) : q, d, slope);
        for (let b = firstDeterminant; b < width; b++) if (!(slope[b] * first[b] > 0)) self.sound = false;
      }
      return moved(scheme.outer, q, h, into);
    },
  };
  return self;
};

/** @type {(time: number, step: number) => number} */
const rowsBefore = (time, step) => Math.max(0, Math.ceil((time / step) * (1 - 1e-9) - 1e-9));
/** @type {(step: number, end: number) => number} */
const wholeSteps = (step, end) => Math.trunc((end / step) * (1 + 1e-12) + 1e-9);
// Whether an angle on which a determinant depends goes further in one step than its sign can tell.
/** @type {(at: Float64Array, next: Float64Array) => boolean} */
const leaps = (at, next) => {
  for (let k = 0; k < data.guarded.length; k++) if (!(abs(next[data.guarded[k]] - at[data.guarded[k]]) <= data.widest)) return true;
  return false;
};
/** @type {(values: ArrayLike<number>) => boolean} */
const finite = (values) => {
  for (let i = 0; i < values.length; i++) if (values[i] - values[i] !== 0) return false;
  return true;
};

// The rows of one motion at t = i h: `n` positions in q, `n` rows of velocities and determinants in u, one after another.
// The room is kept from one table to the next.
/** @type {() => Rows} */
const table = () => ({ n: 0, h: 0, q: new Float64Array(0), u: new Float64Array(0), dead: null, lost: false, evaluations: 0 });
/** @type {(rows: Rows, h: number, most: number) => Rows} */
const clear = (rows, h, most) => {
  if (rows.q.length < most * m || rows.u.length < most * width) {
    rows.q = new Float64Array(most * m);
    rows.u = new Float64Array(most * width);
  }
  return Object.assign(rows, { n: 0, h, dead: null, lost: false, evaluations: 0 });
};
/** @type {(rows: Rows, at: Float64Array, row: Float64Array) => void} */
const keep = (rows, at, row) => {
  rows.q.set(at, rows.n * m);
  rows.u.set(row, rows.n * width);
  rows.n++;
};
// What may take long is a generator: now and then it yields how many evaluations it has made since the last time.
const BREATH = 256;
/** @type {(job: Job) => void} */
const drain = (job) => {
  while (!job.next().done) {}
};

// The rows of a scheme with a step h (s) from `start`.
// They end before `dead` (s), and where the scheme itself leaves the motion: then `lost` is true.
/** @type {(rows: Rows, name: string, h: number, start: ArrayLike<number>, d: any, dead: number | null) => Job} */
function* march(rows, name, h, start, d, dead) {
  const scheme = data.schemes[name], stages = scheme.inner.length, stepping = stepper(scheme);
  let last = wholeSteps(h, data.end);
  if (dead !== null) last = Math.min(last, rowsBefore(dead, h) - 1);
  clear(rows, h, last + 1).name = name;
  let at = Float64Array.from(start), next = new Float64Array(m), done = 0;
  const row = new Float64Array(width);
  for (let i = 0; i <= last; i++) {
    rates(i * h, at, d, row);
    let kept = finite(row);
    for (let b = firstDeterminant; b < width && i; b++) {
      const before = rows.u[(i - 1) * width + b];
      if (row[b] * before <= 0 && before !== 0) kept = false;
    }
    if (!kept) break;
    keep(rows, at, row);
    if (i === last) break;
    stepping.step(i * h, at, h, row, d, next);
    if (!finite(next) || leaps(at, next)) break;
    [at, next] = [next, at];
    if ((done += stages) >= BREATH) {
      yield done;
      done = 0;
    }
  }
  rows.lost = rows.n <= last;
  rows.evaluations = Math.max(0, rows.n - 1) * stages;
}

// The true motion at t = i h: Runge-Kutta steps, `inside` of them from row to row, smaller ones near a dead point.
// Where a determinant goes to nothing the steps shrink with it, so that the end of the motion is reached from one side.
/** @type {(rows: Rows, h: number, inside: number, start: ArrayLike<number>, d: any, end: number | null) => Job} */
function* follow(rows, h, inside, start, d, end) {
  const scheme = data.schemes[data.precise], stepping = stepper(scheme);
  const last = wholeSteps(h, data.end);
  clear(rows, h, last + 1);
  const largest = new Float64Array(data.determinants);
  let at = Float64Array.from(start), next = new Float64Array(m);
  let row = rates(0, at, d, new Float64Array(width)), ahead = new Float64Array(width);
  let shrunk = 1, dead = end, t = 0, done = 0;
  const closeness = () => {
    let least = 1;
    for (let b = 0; b < data.determinants; b++) {
      const size = abs(row[firstDeterminant + b]);
      if (size > largest[b]) largest[b] = size;
      least = Math.min(least, size / largest[b]);
    }
    return least;
  };
  const sound = () => {
    for (let b = firstDeterminant; b < width; b++) if (!(ahead[b] * row[b] > 0)) return false;
    return stepping.sound && finite(next) && finite(ahead);
  };
  if (!finite(row)) {
    rows.dead = 0;
    return;
  }
  for (let i = 0; i <= last; i++) {
    const until = i * h;
    if (end !== null && until >= end * (1 - 1e-9)) break;
    let tries = 0;
    while (t < until) {
      let goal = until;
      for (let k = 0; k < data.breaks.length; k++) if (data.breaks[k] > t * (1 + 1e-13) && data.breaks[k] < goal) goal = data.breaks[k];
      const near = closeness();
      const full = (h / inside) * Math.min(1, 10 * near) * shrunk;
      // What round-off leaves of an interval is no step of its own.
      const whole = goal - t <= full * (1 + 1e-9);
      const reached = whole ? goal : t + full;
      stepping.step(t, at, reached - t, row, d, next);
      rates(Math.min(reached, latest(reached)), next, d, ahead);
      if (sound()) {
        t = reached;
        [at, next] = [next, at];
        [row, ahead] = [ahead, row];
        if (latest(t) < t) rates(t, at, d, row);
      } else shrunk /= 2;
      if (!(full > 1e-10 * h) || ++tries > 1e4) {
        dead = t;
        break;
      }
      if ((done += scheme.inner.length) >= BREATH) {
        yield done;
        done = 0;
      }
    }
    if (dead !== null && dead !== end) break;
    keep(rows, at, row);
  }
  rows.dead = dead;
}

// The largest difference of a coordinate from the true motion over the rows: value, coordinate and row from 1.
// Of those alike to the digits shown the first coordinate is named, and its first row, as in the box of the first page.
const ALIKE = 1e-4;
/** @type {(rows: Rows, truth: Rows) => Worst} */
const largestError = (rows, truth) => {
  const stride = Math.round(rows.h / truth.h), count = Math.min(rows.n, Math.ceil(truth.n / stride));
  /** @type {(i: number, place: number) => number} */
  const gap = (i, place) => abs(rows.q[i * m + place] - truth.q[i * stride * m + place]);
  let value = 0;
  for (let i = 0; i < count; i++) for (let place = 0; place < m; place++) if (gap(i, place) > value) value = gap(i, place);
  for (let place = 0; place < m; place++) {
    for (let i = 0; i < count; i++) if (gap(i, place) >= value * (1 - ALIKE)) return { value, place, row: i + 1 };
  }
  return { value, place: 0, row: 1 };
};
