// The laboratory of a mechanism that forces move: what its positions keep, a scheme that takes rates early, errors of rates.
// Enters: `motion`, `laboratory` and what `free_motion.js` leaves.
const driven = { choose: motion.choose, compute: motion.compute, sketch: motion.sketch, again: motion.again, amount: laboratory.amount };
motion.choose = function () {
  driven.choose.call(this);
  if (this.start) held(0, this.start, this.d, keeps);
};
motion.compute = function* () {
  early.step = 0;
  yield* driven.compute.call(this);
};
motion.sketch = function () {
  early.step = 0;
  driven.sketch.call(this);
};
motion.again = function* (into, h = this.h, truth = this.truth, scheme = tried.scheme) {
  early.step = data.schemes[scheme].early ? h : 0;
  yield* driven.again.call(this, into, h, truth, scheme);
  early.step = 0;
};
laboratory.amount = ({ value, place }) => {
  const name = data.coordinates[place];
  return place < positions ? driven.amount({ value, place }) : `${shown(value < ROUND_OFF ? 0 : value, 3)} ${data.unit_words[name]}`;
};
