// What a switch adds to the drawing: traces of the points, velocities as arrows, instantaneous centres as they move.
// Enters: positions at any time.  Leaves: `additions`, and `offRail`, by how much the table's mechanism has left its guides.
// The velocity of every point at t (s), flat, m/s: from where it is a little before and a little after.
/** @type {(true_: boolean, t: number) => any} */
const velocities = (true_, t) => {
  const h = motion.grain, before = Math.max(0, t - h), after = Math.min(motion.duration, t + h);
  const from = motion.at(true_, before), to = motion.at(true_, after);
  return from && to ? from.map((value, k) => (to[k] - value) / (after - before)) : null;
};

// A contact is another point of the wheel at every moment; the one that touches is at rest.
const moving_ = data.shown_points.filter((name) => !data.wheels.some((wheel) => wheel.contact === name));

const additions = /** @type {Additions} */ ({
  on: { traces: false, velocities: false, centres: false }, long: 0,
  // After the motion has changed: its traces, and the scale of the arrows.
  renew() {
    this.long = Infinity;
    tell("live-scale", "");
    const { traces } = drawing.layers;
    traces.replaceChildren();
    if (!drawing.first) return;
    let fastest = 0;
    for (let i = 0; this.on.velocities && i < motion.count; i++) {
      const place = motion.at(true, i * motion.h), speeds = velocities(true, i * motion.h);
      if (!place || !speeds) continue;
      for (const name of moving_) {
        const [x, y] = drawing.put(place, name), dx = X(speeds, name), dy = -Y(speeds, name), size = Math.hypot(dx, dy);
        if (!(size > 0)) continue;
        fastest = Math.max(fastest, size);
        this.long = Math.min(this.long, 80 / size, drawing.room(x, y, dx, dy));
      }
    }
    if (fastest > 0) tell("live-scale", say("arrows", { speed: plain(fastest, 3) }));
    if (!this.on.traces) return;
    const parts = Math.min(600, 8 * motion.count);
    for (const true_ of [true, false]) {
      const paths = data.shown_points.map(() => "");
      for (let i = 0; i <= parts; i++) {
        const place = motion.at(true_, (motion.duration * i) / parts);
        if (!place) break;
        data.shown_points.forEach((name, k) => {
          paths[k] += `${i ? "L" : "M"}${drawing.put(place, name).map(f1).join(" ")}`;
        });
      }
      for (const path of paths) svg("path", { d: path, class: true_ ? "live-true" : "live-table" }, traces);
    }
  },
  draw(place, t) {
    const { arrows, centres } = drawing.layers;
    arrows.replaceChildren();
    centres.replaceChildren();
    if (!place || !(this.on.velocities || this.on.centres)) return;
    const speeds = velocities(true, t);
    if (!speeds) return;
    for (const name of this.on.velocities && this.long < Infinity ? moving_ : []) {
      const [x, y] = drawing.put(place, name);
      this.arrow(arrows, x, y, X(speeds, name) * this.long, -Y(speeds, name) * this.long);
    }
    if (this.on.centres) for (const bar of data.links) this.centre(centres, bar, place, speeds, t);
  },
  arrow(layer, x, y, dx, dy) {
    const size = Math.hypot(dx, dy);
    if (size < 2) return;
    // A short one has no head.
    const ux = dx / size, uy = dy / size, head = size < 8 ? 0 : 8;
    const tip = [x + dx, y + dy], neck = [tip[0] - head * ux, tip[1] - head * uy];
    svg("path", { d: `M${f1(x)} ${f1(y)}L${f1(neck[0])} ${f1(neck[1])}` }, layer);
    if (!head) return;
    const side = [0.35 * head * uy, -0.35 * head * ux];
    /** @type {(sign: number) => string} */
    const wing = (sign) => `${f1(neck[0] + sign * side[0])} ${f1(neck[1] + sign * side[1])}`;
    svg("path", { d: `M${f1(tip[0])} ${f1(tip[1])}L${wing(1)}L${wing(-1)}Z`, class: "live-filled" }, layer);
  },
  // The point of a link that is at rest now: A + i V/ω.
  centre(layer, bar, place, speeds, t) {
    if (!bar.points.length) return;
    const [a, b] = [bar.points[0], bar.points[bar.points.length - 1]];
    const dx = X(place, b) - X(place, a), dy = Y(place, b) - Y(place, a), size = dx * dx + dy * dy;
    const wheel = data.wheels.some((one) => one.link === bar.name);
    /** @type {any} */
    let turning = bar.rate ? motion.rate(true, t, bar.rate) : null;
    if (turning === null && size > 0 && !wheel) {
      turning = (dx * (Y(speeds, b) - Y(speeds, a)) - dy * (X(speeds, b) - X(speeds, a))) / size;
    }
    const x = drawing.x(X(place, a) - Y(speeds, a) / turning), y = drawing.y(Y(place, a) + X(speeds, a) / turning);
    if (!turning || !(Math.abs(x) < 1e4 && Math.abs(y) < 1e4)) return;
    svg("path", { d: `M${f1(x - 5)} ${f1(y)}h10M${f1(x)} ${f1(y - 5)}v10` }, layer);
    for (const name of bar.points) {
      svg("path", { d: `M${f1(x)} ${f1(y)}L${drawing.put(place, name).map(f1).join(" ")}`, class: "live-ray" }, layer);
    }
    // On the side away from the link.
    const [px, py] = drawing.put(place, a), [qx, qy] = drawing.put(place, b), wx = 2 * x - px - qx, wy = 2 * y - py - qy;
    const off = 12 / (Math.hypot(wx, wy) || 1), at = { x: f1(x + off * wx), y: f1(y + off * wy + 5) };
    const text = svg("text", { ...at, "text-anchor": wx < 0 ? "end" : "start" }, layer);
    symbolic(text, `${data.centre}_${bar.name}`);
  },
});

// The farthest that a point of the table's mechanism has left its rail or its fixed circle: which, point and distance (m).
/** @type {(ghost: Place) => Off | null} */
const offRail = (ghost) => {
  /** @type {any} */
  let worst = null;
  /** @type {(guide: string, point: string, distance: number) => void} */
  const take = (guide, point, distance) => {
    if (!worst || distance > worst.distance) worst = { guide, point, distance };
  };
  for (const rail of data.rails) {
    if (!rail.rider) continue;
    const [ux, uy] = along(drawing.first, rail.base, rail.toward);
    const dx = X(ghost, rail.rider) - X(drawing.first, rail.at), dy = Y(ghost, rail.rider) - Y(drawing.first, rail.at);
    take("rail", rail.rider, Math.abs(ux * dy - uy * dx));
  }
  /** @type {(place: Place, a: string, b: string) => number} */
  const distance = (place, a, b) => Math.hypot(X(place, a) - X(place, b), Y(place, a) - Y(place, b));
  for (const track of data.tracks) {
    const radius = distance(drawing.first, track.centre, track.rim);
    for (const wheel of data.wheels) {
      const begun = Math.abs(distance(drawing.first, wheel.contact, track.centre) - radius);
      const gap = Math.abs(Math.hypot(X(ghost, wheel.contact) - X(drawing.first, track.centre), Y(ghost, wheel.contact) - Y(drawing.first, track.centre)) - radius);
      if (begun < 1e-3 * radius) take("circle", wheel.contact, gap);
    }
  }
  return worst;
};

// The point of the table's mechanism that is farthest from where it should be: point and distance (m).
/** @type {(ghost: Place, right: Place) => Off | null} */
const offPlace = (ghost, right) => {
  /** @type {any} */
  let worst = null;
  for (const name of data.shown_points) {
    const distance = Math.hypot(X(ghost, name) - X(right, name), Y(ghost, name) - Y(right, name));
    if (!worst || distance > worst.distance) worst = { point: name, distance };
  }
  return worst;
};
