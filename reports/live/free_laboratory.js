// The laboratory of a mechanism that forces move: what its positions keep, a scheme that takes rates early, errors of rates.
// Enters: `motion`, `laboratory` and what `free_motion.js` leaves.
const driven = { choose: motion.choose, compute: motion.compute, sketch: motion.sketch, again: motion.again, amount: laboratory.amount };
motion.choose = () => {
  driven.choose.call(motion);
  if (motion.start) held(0, motion.start, motion.d, keeps);
};
motion.compute = function* () {
  early.step = 0;
  yield* driven.compute.call(motion);
};
motion.sketch = () => {
  early.step = 0;
  driven.sketch.call(motion);
};
motion.again = function* (into, h = motion.h, truth = motion.truth, scheme = tried.scheme) {
  early.step = data.schemes[scheme].early ? h : 0;
  yield* driven.again.call(motion, into, h, truth, scheme);
  early.step = 0;
};
laboratory.amount = ({ value, place }) => {
  const name = data.coordinates[place];
  return place < positions ? driven.amount({ value, place }) : `${shown(value < ROUND_OFF ? 0 : value, 3)} ${data.unit_words[name]}`;
};
