// The arithmetic that the generated functions call: linear equations, choices, tabulated laws.
// Enters: `data`, the numbers of the page.  Leaves: functions over plain arrays in SI.
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
