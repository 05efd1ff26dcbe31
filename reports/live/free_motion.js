// Where forces move the mechanism: a row has all coordinates and then the free rates; coordinates that follow are closed.
// Enters: `data` and the generated `slope`, `corrected`, `held`.  Leaves: `moving`, which stands for the rates of driven motions.
const { free, others } = data.forces, positions = data.coordinates.length - free.length;
const MOST_NEWTON = 12, CLOSED = 1e-8, FARTHEST = 1;
const keeps = new Float64Array(data.forces.held), correction = new Float64Array(others.length);
held(0, data.start, data.numbers, keeps);
// The step (s) of a scheme that takes the rates from the end of it, 0 for any other; by how much the others then go further.
const early = { step: 0, further: new Float64Array(others.length) }, later = new Float64Array(free.length);
const spare = new Float64Array(data.velocities.length + data.determinants);

// Closes the position, then writes rates, free accelerations, other velocities and determinants; no numbers where none closes.
/** @type {(t: number, q: Float64Array, d: any, out: Float64Array) => Float64Array} */
const moving = (t, q, d, out) => {
  for (let i = 0; early.step && t > 0 && i < others.length; i++) q[others[i]] += early.further[i];
  for (let tries = 0, size = 1; others.length && size > CLOSED; tries++) {
    corrected(t, q, keeps, d, correction);
    size = 0;
    for (let i = 0; i < others.length; i++) {
      q[others[i]] += correction[i];
      size = Math.max(size, abs(correction[i]));
    }
    if (!(size < FARTHEST) || tries === MOST_NEWTON) return out.fill(NaN);
  }
  slope(t, q, q.subarray(positions), d, out);
  if (early.step) takeEarly(t, q, d, out);
  return out;
};
// Free coordinates go by the rates at the end of the step, and the others with them.
/** @type {(t: number, q: Float64Array, d: any, out: Float64Array) => void} */
const takeEarly = (t, q, d, out) => {
  for (let k = 0; k < free.length; k++) later[k] = q[positions + k] + early.step * out[positions + k];
  slope(t, q, later, d, spare);
  for (let i = 0; i < others.length; i++) early.further[i] = early.step * (spare[others[i]] - out[others[i]]);
  for (let k = 0; k < free.length; k++) out[free[k]] = later[k];
};
