// The arithmetic of the page: what the generated functions call, steps of a scheme, tables, the true motion, dead points.
// Enters: `data`, the numbers of the page, and the generated `rates`.  Leaves: functions over plain arrays in SI.
const { sin, cos, tan, asin, acos, atan, atan2, exp, log, abs, sign, sqrt, pow } = Math;
const _choose = (holds, yes, no) => (holds ? yes() : no());

// Linear equations, the matrix row by row and then the right side: the unknowns, then the determinant.
const _solve = (entries) => {
  const n = (sqrt(4 * entries.length + 1) - 1) / 2;
  const rows = [];
  for (let i = 0; i < n; i++) rows.push([...entries.slice(i * n, i * n + n), entries[n * n + i]]);
  let determinant = 1;
  for (let c = 0; c < n; c++) {
    let best = c;
    for (let r = c + 1; r < n; r++) if (abs(rows[r][c]) > abs(rows[best][c])) best = r;
    if (best !== c) {
      [rows[c], rows[best]] = [rows[best], rows[c]];
      determinant = -determinant;
    }
    determinant *= rows[c][c];
    for (let r = c + 1; r < n; r++) {
      const share = rows[r][c] / rows[c][c];
      for (let k = c; k <= n; k++) rows[r][k] -= share * rows[c][k];
    }
  }
  const found = new Array(n + 1);
  found[n] = determinant;
  for (let r = n - 1; r >= 0; r--) {
    let left = rows[r][n];
    for (let k = r + 1; k < n; k++) left -= rows[r][k] * found[k];
    found[r] = left / rows[r][r];
  }
  return found;
};

// A tabulated law or its derivative: a polynomial between every two nodes; no number beyond the table.
const law = (name, order) => {
  const { first, step, pieces } = data.tables[name];
  const own = pieces[order];
  return (argument) => {
    const place = (argument - first) / step;
    if (!(place >= -1e-6 && place <= own.length + 1e-6)) return NaN;
    const interval = Math.min(Math.max(Math.trunc(place), 0), own.length - 1);
    let total = 0;
    for (let k = own[interval].length - 1; k >= 0; k--) total = total * (place - interval) + own[interval][k];
    return total;
  };
};

const part = (share, h) => (share[0] * h) / share[1];
// A step that ends at a break of the drive still sees the old formula there.
const latest = (end) => {
  for (const time of data.breaks) if (abs(end - time) <= 1e-13 * time) return end * (1 - 1e-13);
  return Infinity;
};

// Returns a stepper: step(t, q, h, first, d, into) writes the position after h; `first` are the slopes at (t, q).
// `sound` says whether every determinant kept its sign inside the step.
const stepper = (scheme) => {
  const m = data.coordinates.length;
  const width = data.velocities.length + data.determinants;
  const slopes = scheme.inner.map(() => new Float64Array(width));
  const inside = new Float64Array(m);
  const moved = (row, q, h, into) => {
    const factor = part(row.factor, h);
    for (let i = 0; i < m; i++) {
      let total = row.terms[0][1] * slopes[row.terms[0][0]][i];
      for (let k = 1; k < row.terms.length; k++) total += row.terms[k][1] * slopes[row.terms[k][0]][i];
      into[i] = q[i] + factor * total;
    }
    return into;
  };
  const self = {
    sound: true,
    step(t, q, h, first, d, into) {
      slopes[0].set(first);
      self.sound = true;
      const last = latest(t + h);
      for (let stage = 1; stage < slopes.length; stage++) {
        const row = scheme.inner[stage];
        const at = row.terms.length ? moved(row, q, h, inside) : q;
        rates(Math.min(t + part(scheme.nodes[stage], h), last), at, d, slopes[stage]);
        for (let b = data.velocities.length; b < width; b++) if (!(slopes[stage][b] * first[b] > 0)) self.sound = false;
      }
      return moved(scheme.outer, q, h, into);
    },
  };
  return self;
};

const rowsBefore = (time, step) => Math.max(0, Math.ceil((time / step) * (1 - 1e-9) - 1e-9));
const wholeSteps = (step, end) => Math.trunc((end / step) * (1 + 1e-12) + 1e-9);
const finite = (values) => {
  for (let i = 0; i < values.length; i++) if (values[i] - values[i] !== 0) return false;
  return true;
};

// The rows of a scheme with a step h (s): positions q[i], velocities and determinants u[i] at t = i h.
// They end before `dead` (s), and where the scheme itself leaves the motion: then `lost` is true.
const march = (name, h, start, d, dead) => {
  const scheme = data.schemes[name];
  const stepping = stepper(scheme);
  const k = data.velocities.length;
  let last = wholeSteps(h, data.end);
  if (dead !== null) last = Math.min(last, rowsBefore(dead, h) - 1);
  const q = [], u = [];
  let at = Float64Array.from(start);
  for (let i = 0; i <= last; i++) {
    const row = rates(i * h, at, d, new Float64Array(k + data.determinants));
    let kept = finite(row);
    for (let b = k; b < row.length && i; b++) if (row[b] * u[i - 1][b] <= 0 && u[i - 1][b] !== 0) kept = false;
    if (!kept) break;
    q.push(at);
    u.push(row);
    if (i === last) break;
    const next = stepping.step(i * h, at, h, row, d, new Float64Array(at.length));
    if (!finite(next) || data.guarded.some((place) => !(abs(next[place] - at[place]) <= data.widest))) break;
    at = next;
  }
  return { name, h, q, u, lost: q.length <= last, evaluations: Math.max(0, q.length - 1) * scheme.inner.length };
};

// The true motion at t = i h: Runge-Kutta steps, `inside` of them from row to row, smaller ones near a dead point.
// Where a determinant goes to nothing the steps shrink with it, so that the end of the motion is reached from one side.
const follow = (h, inside, start, d, known) => {
  const stepping = stepper(data.schemes[data.precise]);
  const k = data.velocities.length;
  const last = wholeSteps(h, data.end);
  const q = [], u = [];
  const largest = new Float64Array(data.determinants);
  let at = Float64Array.from(start), next = new Float64Array(at.length);
  let row = rates(0, at, d, new Float64Array(k + data.determinants)), ahead = new Float64Array(k + data.determinants);
  let shrunk = 1, dead = known, t = 0;
  const closeness = () => {
    let least = 1;
    for (let b = 0; b < data.determinants; b++) {
      largest[b] = Math.max(largest[b], abs(row[k + b]));
      least = Math.min(least, abs(row[k + b]) / largest[b]);
    }
    return least;
  };
  const sound = () => {
    for (let b = k; b < row.length; b++) if (!(ahead[b] * row[b] > 0)) return false;
    return stepping.sound && finite(next) && finite(ahead);
  };
  if (!finite(row)) return { h, q, u, dead: 0 };
  for (let i = 0; i <= last; i++) {
    const end = i * h;
    if (known !== null && end >= known * (1 - 1e-9)) break;
    let tries = 0;
    while (t < end) {
      let goal = end;
      for (const time of data.breaks) if (time > t * (1 + 1e-13) && time < goal) goal = time;
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
      if (near < 1e-12 || shrunk < 1e-12 || ++tries > 1e4) {
        dead = t;
        break;
      }
    }
    if (dead !== null && dead !== known) break;
    q.push(at.slice());
    u.push(row.slice());
  }
  return { h, q, u, dead };
};

// The largest difference of a coordinate from the true motion over the rows: value, coordinate and row from 1.
const largestError = (rows, truth) => {
  const stride = Math.round(rows.h / truth.h);
  const worst = { value: 0, place: 0, row: 1 };
  rows.q.forEach((at, i) => {
    const right = truth.q[i * stride];
    for (let place = 0; right && place < at.length; place++) {
      const gap = abs(at[place] - right[place]);
      if (gap > worst.value) Object.assign(worst, { value: gap, place, row: i + 1 });
    }
  });
  return worst;
};
