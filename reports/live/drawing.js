// The mechanism on the screen: the true one solid, the one of the table dashed over it, what a switch adds to them.
// Enters: `motion` and the outline in `data` (names of points).  Leaves: `drawing`, redrawn for any time.
/** @type {{ get(name: string): any }} */
const index = new Map(data.points.map((name, i) => [name, 2 * i]));
/** @type {(place: Place, name: string) => number} */
const X = (place, name) => place[index.get(name)];
/** @type {(place: Place, name: string) => number} */
const Y = (place, name) => place[index.get(name) + 1];
/** @type {(place: Place, base: string, toward: string) => Point} */
const along = (place, base, toward) => {
  const x = X(place, toward) - X(place, base), y = Y(place, toward) - Y(place, base);
  const size = Math.hypot(x, y) || 1;
  return [x / size, y / size];
};
// A circle as part of a path.
/** @type {(x: number, y: number, r: number) => string} */
const round = (x, y, r) => `M${f1(x - r)} ${f1(y)}a${r} ${r} 0 1 0 ${f1(2 * r)} 0a${r} ${r} 0 1 0 ${f1(-2 * r)} 0`;

const drawing = /** @type {Drawing} */ ({
  field: byId("live-field"),
  prepare() {
    if (!data.points.length) return;
    // A ground wider than all that moves on it: the browser keeps its layers as long as the ends of what is painted stay.
    svg("rect", { x: "-50%", y: "-50%", width: "200%", height: "200%", fill: "#fff" }, this.field);
    this.layers = Object.fromEntries(
      ["ground", "traces", "ghost", "body", "pins", "arrows", "centres", "words"].map((name) => [
        name, svg("g", { class: `live-${name}` }, this.field),
      ]),
    );
    /** @type {(layer: string) => any} */
    const line = (layer) => svg("path", {}, this.layers[layer]);
    this.paths = Object.fromEntries(["ground", "ghost", "body", "pins"].map((name) => [name, line(name)]));
    this.paths.hatch = svg("path", { class: "live-hatch" }, this.layers.ground);
    this.paths.filled = svg("path", { class: "live-filled" }, this.layers.pins);
    words.prepare(this.layers.words);
  },
  // Choose the window so that both motions fit, and draw what stands still.
  refit() {
    if (!data.points.length) return;
    // Where there is little room the drawing has fewer units, so that its letters keep their size.
    /** @type {(width: string) => boolean} */
    const fits = (width) => matchMedia(width).matches;
    this.WIDE = fits("(max-width: 359px)") ? 350 : fits("(max-width: 599px), (min-width: 721px) and (max-width: 1199px)") ? 380 : 640;
    // The true motion is looked through once, also while step and scheme are moved.
    if (!this.right || this.drawn !== motion.drawn) this.right = this.extent(true, motion.dead ?? data.end, data.step);
    const ghost = this.extent(false, motion.duration, motion.h);
    const box = this.right.box.map((end, k) => (k < 2 ? Math.min : Math.max)(end, ghost.box[k]));
    this.samples = [this.right.rows, ghost.rows];
    this.first = this.right.rows[0];
    if (!this.first) return;
    this.turns = {};
    this.scale = Math.min((this.WIDE - 90) / Math.max(box[2] - box[0], 1e-12), (0.2 * this.WIDE + 200) / Math.max(box[3] - box[1], 1e-12));
    this.HIGH = (box[3] - box[1]) * this.scale + 80;
    this.origin = [(this.WIDE - (box[0] + box[2]) * this.scale) / 2, this.HIGH - 40 + box[1] * this.scale];
    change(this.field, "viewBox", `0 0 ${this.WIDE} ${f1(this.HIGH)}`);
    this.slots = data.slots.map((slot) => this.reach(slot));
    this.racks = data.racks.map((rack) => this.reach(rack));
    this.ground();
    this.drawn = motion.drawn;
    additions.renew();
  },
  // Where everything is in a hundred rows of a motion at most, from the start to a time (s), and the box around it (m).
  extent(true_, last, h) {
    const box = [Infinity, Infinity, -Infinity, -Infinity], rows = [];
    /** @type {(x: number, y: number, room?: number) => void} */
    const take = (x, y, room = 0) => {
      box[0] = Math.min(box[0], x - room);
      box[1] = Math.min(box[1], y - room);
      box[2] = Math.max(box[2], x + room);
      box[3] = Math.max(box[3], y + room);
    };
    const count = 1 + Math.round(last / h);
    /** @type {(place: Place, round: { centre: string }, rim: string) => void} */
    const circle = (place, { centre }, rim) =>
      take(X(place, centre), Y(place, centre), Math.hypot(X(place, rim) - X(place, centre), Y(place, rim) - Y(place, centre)));
    for (let i = 0; i < count; i += Math.ceil(count / 100)) {
      const place = motion.at(true_, i * h);
      if (!place) continue;
      rows.push(place);
      for (const name of data.shown_points) take(X(place, name), Y(place, name));
      for (const wheel of data.wheels) circle(place, wheel, wheel.contact);
      if (true_ && !i) for (const track of data.tracks) circle(place, track, track.rim);
    }
    return { box, rows };
  },
  x(value) {
    return this.origin[0] + value * this.scale;
  },
  y(value) {
    return this.origin[1] - value * this.scale;
  },
  // How many times a way has room between a place and the edge of the field.
  room(x, y, dx, dy) {
    return Math.min((dx > 0 ? this.WIDE - 3 - x : x - 3) / Math.abs(dx), (dy > 0 ? this.HIGH - 3 - y : y - 3) / Math.abs(dy));
  },
  put(place, name) {
    return [this.x(X(place, name)), this.y(Y(place, name))];
  },
  // Rails, fixed circles and hinges, hatched where they are held.
  ground() {
    let lines = "", thin = "";
    /** @type {(...at: number[]) => void} */
    const hatch = (x1, y1, x2, y2, leanX, leanY) => {
      const count = Math.max(2, Math.round(Math.hypot(x2 - x1, y2 - y1) / 8));
      for (let i = 0; i < count; i++) {
        const share = (i + 0.5) / count, x = x1 + share * (x2 - x1), y = y1 + share * (y2 - y1);
        thin += `M${f1(x)} ${f1(y)}l${f1(leanX)} ${f1(leanY)}`;
      }
    };
    for (const rail of data.rails) {
      const [ux, uy] = along(this.first, rail.base, rail.toward), [x0, y0] = this.put(this.first, rail.at);
      let low = -25, high = 25;
      for (const row of rail.rider ? this.samples.flat() : []) {
        const [x, y] = this.put(row, rail.rider);
        const s = (x - x0) * ux - (y - y0) * uy;
        low = Math.min(low, s - 25);
        high = Math.max(high, s + 25);
      }
      // A wheel rolls on the line itself, a block slides beside it.
      const side = -rail.side, gap = rail.rolls || !rail.rider ? 0 : 7 * side, x = x0 + uy * gap, y = y0 + ux * gap;
      const line = [x + low * ux, y - low * uy, x + high * ux, y - high * uy];
      lines += `M${line.map(f1)}`;
      hatch(...line, (uy * side - ux * 0.7) * 6, (ux * side + uy * 0.7) * 6);
    }
    for (const track of data.tracks) {
      const [x, y] = this.put(this.first, track.centre), [rx, ry] = this.put(this.first, track.rim);
      const r = Math.hypot(rx - x, ry - y), count = Math.round((Math.PI * r) / 4), lean = 1 - (track.inward * 6) / r;
      lines += round(x, y, f1(r));
      for (let i = 0; i < (track.inward && count); i++) {
        const at = (2 * Math.PI * i) / count, off = at + 5 / r;
        thin += `M${f1(x + r * Math.cos(at))} ${f1(y + r * Math.sin(at))}L${f1(x + r * lean * Math.cos(off))} ${f1(y + r * lean * Math.sin(off))}`;
      }
    }
    for (const { at, ground } of data.hinges) {
      const [x, y] = this.put(this.first, at), [gx, gy] = [ground[0], -ground[1]], [bx, by] = [x + 15 * gx, y + 15 * gy];
      lines += `M${f1(x)} ${f1(y)}L${f1(bx - 9 * gy)} ${f1(by + 9 * gx)}L${f1(bx + 9 * gy)} ${f1(by - 9 * gx)}Z`;
      hatch(bx - 13 * gy, by - 13 * gx, bx + 13 * gy, by + 13 * gx, 6 * gx - 5 * gy, 6 * gy - 5 * gx);
    }
    change(this.paths.ground, "d", lines);
    change(this.paths.hatch, "d", thin);
  },
  // One mechanism as a path: bars through their corners, slots, blocks, wheels with a spoke.
  outline(place, true_, t) {
    let path = "";
    for (const bar of data.links) {
      if (bar.points.length < 2) continue;
      bar.points.forEach((name, i) => {
        const [x, y] = this.put(place, name);
        path += `${i ? "L" : "M"}${f1(x)} ${f1(y)}`;
      });
    }
    this.slots.forEach(({ slot, beside, low, high }) => {
      const [ux, uy] = along(place, slot.base, slot.toward), [x, y] = this.put(place, slot.at);
      /** @type {(s: number, n: number) => string} */
      const on = (s, n) => `${f1(x + s * ux - n * uy)} ${f1(y - s * uy - n * ux)}`;
      path += `M${on(low, beside)}L${on(high, beside)}`;
      if (Math.abs(beside) > 1) path += `M${on(0, 0)}L${on(0, beside)}`;
    });
    this.racks.forEach(({ slot, low, high }) => {
      const [ux, uy] = along(place, slot.base, slot.toward), [x, y] = this.put(place, slot.at);
      /** @type {(s: number, n: number) => string} */
      const corner = (s, n) => `${f1(x + s * ux - n * uy)} ${f1(y - s * uy - n * ux)}`, deep = 7 * slot.side;
      path += `M${corner(low, 0)}L${corner(high, 0)}L${corner(high, deep)}L${corner(low, deep)}Z`;
    });
    for (const block of data.blocks) {
      const [ux, uy] = along(place, block.base, block.toward), [x, y] = this.put(place, block.at);
      /** @type {(a: number, b: number) => string} */
      const corner = (a, b) => `${f1(x + a * ux - b * uy)} ${f1(y - a * uy - b * ux)}`;
      path += block.open
        ? `M${corner(-14, 7)}L${corner(14, 7)}M${corner(-14, -7)}L${corner(14, -7)}`
        : `M${corner(-12, 7)}L${corner(12, 7)}L${corner(12, -7)}L${corner(-12, -7)}Z`;
    }
    for (const wheel of data.wheels) {
      const [x, y] = this.put(place, wheel.centre), [px, py] = this.put(place, wheel.contact);
      const r = f1(Math.hypot(px - x, py - y)), turned = this.turned(wheel, true_, t);
      path += round(x, y, r);
      if (turned !== null) path += `M${f1(x)} ${f1(y)}l${f1(r * Math.cos(turned))} ${f1(-r * Math.sin(turned))}`;
    }
    return path;
  },
  // How far (px) a slot reaches from its point along its line, so that every rider stays on it, and how far beside it lies.
  reach(slot) {
    const found = { slot, beside: 0, low: 0, high: 0 };
    for (const row of this.samples.flat()) {
      const [ux, uy] = along(row, slot.base, slot.toward), [x0, y0] = this.put(row, slot.at);
      for (const rider of slot.riders) {
        const [x, y] = this.put(row, rider);
        found.low = Math.min(found.low, (x - x0) * ux - (y - y0) * uy - 10);
        found.high = Math.max(found.high, (x - x0) * ux - (y - y0) * uy + 10);
        if (row === this.first) found.beside = -(x - x0) * uy - (y - y0) * ux;
      }
    }
    return found;
  },
  // The angle by which a wheel has turned at t: its rate summed over the rows; null where no rate is known.
  turned(wheel, true_, t) {
    const rate = data.links.find((bar) => bar.name === wheel.link)?.rate;
    if (!rate || motion.rate(true_, 0, rate) === null) return null;
    const key = `${wheel.link} ${true_}`, parts = 8 * motion.count, h = motion.duration / parts;
    if (!this.turns[key]) {
      // The spoke begins at the contact.
      let total = Math.atan2(Y(this.first, wheel.contact) - Y(this.first, wheel.centre), X(this.first, wheel.contact) - X(this.first, wheel.centre));
      this.turns[key] = [total];
      for (let i = 0; i < parts; i++) this.turns[key].push((total += h * motion.rate(true_, (i + 0.5) * h, rate)));
    }
    const row = this.turns[key], i = Math.min(Math.floor(t / h), parts - 1);
    return h > 0 ? row[i] + (t / h - i) * (row[i + 1] - row[i]) : 0;
  },
  // Redraw both mechanisms at t (s).
  draw(t) {
    if (!data.points.length) return;
    const right = this.first ? motion.at(true, t) : null, ghost = this.first ? motion.at(false, t) : null;
    for (const name of ["ground", "pins", "words"]) change(this.layers[name], "visibility", right ? "visible" : "hidden");
    change(this.paths.body, "d", right ? this.outline(right, true, t) : "");
    change(this.paths.ghost, "d", ghost ? this.outline(ghost, false, t) : "");
    if (right) this.joints(right);
    additions.draw(right, t);
    return { right, ghost };
  },
  joints(place) {
    let rings = "", dots = "";
    data.shown_points.forEach((name) => {
      const [x, y] = this.put(place, name);
      if (data.rings.includes(name)) rings += round(x, y, 4);
      else dots += round(x, y, 3);
    });
    words.place(place);
    change(this.paths.pins, "d", rings);
    change(this.paths.filled, "d", dots);
  },
});
