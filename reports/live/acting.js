// What acts on the links at a position, and the unknown forces and couples in the joints: Newton and Euler, link by link.
// Enters: the generated `acting`, the names of `data.forces`.  Leaves: `acts`, of the position it was asked for last.
const { bodies, places: joints, unknowns, size } = data.forces;
const acted = new Float64Array(size), changing = new Float64Array(width + (data.forces.more ?? 0));

/** @type {Acts} */
const acts = {
  // A driven position has its velocities from the time, a free one from the rates in it, which closes it too.
  on(t, q, d) {
    acting(t, q, rates(t, q, d, changing), d, acted);
    return finite(acted);
  },
  // The unknown forces and couples in the joints: three equations a body, two a pin; none where they are too many.
  reactions() {
    const n = unknowns.length, entries = new Array(n * n + n).fill(0);
    for (const [column, [, on, off, at, kind]] of unknowns.entries()) {
      const [x, y] = this.way(kind);
      for (const [body, sign] of [[on, 1], [off, -1]]) {
        if (body < 0) continue;
        const row = body < bodies ? 3 * body : bodies + 2 * body, put = (/** @type {number} */ k, /** @type {number} */ value) => (entries[(row + k) * n + column] = sign * value);
        if (kind !== 2) put(0, x), put(1, y);
        if (body < bodies) put(2, kind === 2 ? 1 : this.arm(at, 5 * body, x, y));
      }
    }
    for (let k = 0; k < (n && 3 * bodies); k++) entries[n * n + k] = -acted[5 * Math.floor(k / 3) + 2 + (k % 3)];
    return _solve(entries);
  },
  way: (kind) => (kind < 2 ? [1 - kind, kind] : kind > 2 ? acted.slice(5 * bodies + 2 * joints + 2 * kind - 6) : [0, 0]),
  place: (at) => [acted[5 * bodies + 2 * at], acted[5 * bodies + 2 * at + 1]],
  arm(at, centre, x, y) {
    const [px, py] = this.place(at);
    return (px - acted[centre]) * y - (py - acted[centre + 1]) * x;
  },
  get kinetic() {
    return acted[size - 2];
  },
  get energy() {
    return acted[size - 2] + acted[size - 1];
  },
};
