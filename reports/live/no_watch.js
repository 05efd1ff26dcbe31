// Where a script has no room for the stop-watch nothing is timed.
// Leaves: `watch`.
const watch = { open() {}, later() {}, draw() {} };
