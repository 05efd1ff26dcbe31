// The arithmetic that the generated functions call: linear equations, choices, tabulated laws.
// Enters: `data`, the numbers of the page.  Leaves: functions over plain arrays in SI.
const { sin, cos, tan, asin, acos, atan, atan2, exp, log, abs, sign, sqrt, pow } = Math;
/** @type {(holds: boolean, yes: () => number, no: () => number) => number} */
const _choose = (holds, yes, no) => (holds ? yes() : no());

// Linear equations, the matrix row by row and then the right side: the unknowns, then the determinant.
/** @type {(entries: number[]) => number[]} */
const _solve = (entries) => {
  const n = (sqrt(4 * entries.length + 1) - 1) / 2;
  /** @type {any[][]} */
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

// A tabulated law or its derivative, from what stands at its nodes; no number beyond the table.
/** @type {(name: string, order: number) => (argument: number) => number} */
const law = (name, order) => {
  const { first, step, spline, levels } = data.tables[name], count = levels[0].length - 1;
  return (argument) => {
    const place = (argument - first) / step;
    if (!(place >= -1e-6 && place <= count + 1e-6)) return NaN;
    const interval = Math.min(Math.max(Math.trunc(place), 0), count - 1);
    return spline ? cubic(levels, interval, place - interval, order) / step ** order : quartic(levels[order], interval, place);
  };
};
// The cubic of the spline in an interval, or its derivative by u = 0 ... 1.
/** @type {(levels: number[][], i: number, u: number, order: number) => number} */
const cubic = ([values, slopes], i, u, order) => {
  const y0 = values[i], y1 = values[i + 1], m0 = slopes[i], m1 = slopes[i + 1];
  const a = 2 * y0 - 2 * y1 + m0 + m1, b = -3 * y0 + 3 * y1 - 2 * m0 - m1;
  if (order === 2) return 6 * a * u + 2 * b;
  return order ? (3 * a * u + 2 * b) * u + m0 : ((a * u + b) * u + m0) * u + y0;
};
// Lagrange's quartic through five nodes, which begin one before the interval, at the ends as far from it as must be.
/** @type {(values: number[], interval: number, place: number) => number} */
const quartic = (values, interval, place) => {
  const start = Math.min(Math.max(interval - 1, 0), values.length - 5);
  const a = place - start, b = a - 1, c = a - 2, d = a - 3, e = a - 4;
  /** @type {(k: number, product: number) => number} */
  const of = (k, product) => values[start + k] * product;
  return of(0, b * c * d * e) / 24 - of(1, a * c * d * e) / 6 + of(2, a * b * d * e) / 4 - of(3, a * b * c * e) / 6 + of(4, a * b * c * d) / 24;
};
