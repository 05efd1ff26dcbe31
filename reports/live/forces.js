// What acts on the links: reactions as arrows on the drawing, what drives and the energy beside the rows of the table.
// Enters: `motion`, `acts`.  Leaves: `forces`; drawing, graphs and columns are asked for more than before.
/** @type {Forces} */
const forces = {
  kept: new Map(), largest: 0, long: 0, scale: 0,
  // What acts in one motion at t (s); false where it has no such time.
  at(true_, t) {
    const rows = true_ ? motion.truth : motion.rows;
    if (!rows?.n || t > (rows.n - 1) * rows.h * (1 + 1e-9)) return false;
    return acts.on(t, interpolated(rows, t, new Float64Array(m)), motion.d);
  },
  // The energy and each drive in all rows of one motion.
  columns(rows) {
    const known = this.kept.get(rows);
    if (known) return known;
    const made = names_.map(() => new Float64Array(rows.n));
    for (let i = 0; i < rows.n; i++) {
      acts.on(i * rows.h, rows.q.slice(i * m, i * m + m), motion.d);
      const found = made.length > 1 ? acts.reactions() : [];
      for (let k = 0; k < made.length; k++) made[k][i] = k ? found[drives[k - 1]] : acts.energy;
    }
    this.kept.set(rows, made);
    return made;
  },
  // Those forces that are drawn: at a place (m), along x and y (N), with a name.
  arrows() {
    const found = acts.reactions();
    return data.forces.arrows.map(([name, ...columns]) => {
      let x = 0, y = 0;
      for (const column of columns) {
        const way = acts.way(unknowns[column][4]);
        x += found[column] * way[0];
        y += found[column] * way[1];
      }
      return { name, at: acts.place(unknowns[columns[0]][3]), x, y, size: Math.hypot(x, y) };
    });
  },
  // Where the name of an arrow stands: ahead of its tip, else beside the tip or the shaft, where least is covered.
  // A word counts more than a piece of a link.
  clear(px, py, dx, dy, half, taken) {
    const far = Math.hypot(dx, dy), ux = dx / far, uy = dy / far;
    const tried = [[far + 9, 0], [far, 14], [far, -14], [far / 2, 14], [far / 2, -14]].flatMap(([on, off]) => {
      return [Math.sign(dx), 0, -Math.sign(dx)].map((way) => {
        const x = Math.max(half + 3, Math.min(px + on * ux - off * uy + way * half, drawing.WIDE - half - 3));
        const y = Math.max(14, Math.min(py + 5 + on * uy + off * ux, drawing.HIGH - 8));
        const met = taken.filter(([ox, oy, wide, high]) => Math.abs(x - ox) < half + wide && Math.abs(y - oy) < 6 + high);
        return [x, y, met.reduce((sum, [, , , high]) => sum + high ** 2, 0)];
      });
    });
    return tried.reduce((best, one) => (one[2] < best[2] ? one : best));
  },
  // What names keep off, as middle, half the width and half the height: the words of points and links, and the links themselves.
  taken(place) {
    const found = words.all.map(({ made }) => {
      return [Number(made.getAttribute("x")), Number(made.getAttribute("y")) + 5, 4 * made.textContent.length, 8];
    });
    for (const { points } of data.links) {
      points.slice(1).forEach((to, k) => {
        const [ax, ay] = drawing.put(place, points[k]), [bx, by] = drawing.put(place, to);
        const count = Math.ceil(Math.hypot(bx - ax, by - ay) / 6);
        for (let i = 0; i <= count; i++) found.push([ax + (i / count) * (bx - ax), 5 + ay + (i / count) * (by - ay), 3, 3]);
      });
    }
    return found;
  },
  draw(t, place) {
    this.layer.replaceChildren();
    if (!place || !this.at(true, t)) return this.tell([], NaN, t);
    const all = this.arrows(), found = acts.reactions(), { energy } = acts;
    if (additions.on.forces && this.largest > 0) {
      const taken = this.taken(place);
      for (const { name, at, x, y } of all) {
        const px = drawing.x(at[0]), py = drawing.y(at[1]), dx = x * this.long, dy = -y * this.long;
        additions.arrow(this.layer, px, py, dx, dy);
        if (Math.hypot(dx, dy) < 14) continue;
        const half = 4 * name.replace("_", "").length, [middle, base] = this.clear(px, py, dx, dy, half, taken);
        taken.push([middle, base, half, 8]);
        symbolic(svg("text", { x: f1(middle), y: f1(base), "text-anchor": "middle" }, this.layer), name);
      }
      for (const path of this.layer.querySelectorAll("path")) Object.assign(path.style, { stroke: COLOUR, fill: COLOUR });
    }
    this.tell(all.toSorted((a, b) => b.size - a.size).slice(0, 1), energy, t, found);
  },
  // What drives, the largest reaction and the energy, the dashed mechanism's behind them.
  tell(first, energy, t, found = []) {
    const own = this.at(false, t), other = own ? acts.reactions() : [], there = own ? acts.energy : NaN;
    const lines = drives.map((column, k) => say("force_drive", {
      name: label(names_[k + 1]).replace("_", ""), value: shown(found[column], 4), own: shown(other[column], 4), unit: data.unit_words[names_[k + 1]],
    }));
    const low = /** @type {(digit: string) => string} */ ((digit) => String.fromCharCode(0x2080 + Number(digit))); // R₀₃
    for (const { name, size } of first)
      lines.push(say("force_largest", { name: name.replace("_", "").replace(/\d/g, low), value: shown(size, 4) }));
    write(byId("live-drive"), lines.join(" "));
    tell("live-energy", say("force_energy", { value: shown(energy, 4), own: shown(there, 4) }), String(there));
    const off = there - energy, part = Math.abs(off) > 0.05 * this.scale;
    tell("live-gained", part ? say(off > 0 ? "force_gained" : "force_lost", { off: shown(Math.abs(off), 3), share: shown((100 * Math.abs(off)) / this.scale, 3) }) : "");
  },
  // After the motion has changed: the scale of the arrows, and how much energy there is to be off by.
  renew() {
    this.kept.clear();
    this.largest = this.scale = 0;
    this.long = Infinity;
    if (!drawing.layers) return;
    this.layer ??= svg("g", { class: "live-arrows" }, drawing.field);
    for (let i = 0; i < motion.count; i += Math.ceil(motion.count / 100)) {
      if (!this.at(true, i * motion.h)) continue;
      this.scale = Math.max(this.scale, acts.kinetic);
      for (const { at, x, y, size } of additions.on.forces ? this.arrows() : []) {
        if (!(size > 0 && size < Infinity)) continue;
        this.largest = Math.max(this.largest, size);
        this.long = Math.min(this.long, 90 / size, drawing.room(drawing.x(at[0]), drawing.y(at[1]), x, -y));
      }
    }
    tell("live-force", this.largest > 0 ? say("force_scale", { force: shown(this.largest, 3) }) : "");
  },
};
const COLOUR = "var(--centre)";
// The columns that forces add to the graphs: the energy, then each drive.
const names_ = ["E", ...data.forces.drives], drives = data.forces.drives.map((name) => unknowns.findIndex(([own]) => own === name));

// What stands before asks for more: drawing, columns, graphs, the start of a free motion.
const before = { renew: additions.renew, draw: additions.draw, column: motion.column, prepare: panels.prepare, truth: panels.truth };
additions.on.forces = true;
additions.renew = () => {
  before.renew.call(additions);
  forces.renew();
};
additions.draw = (place, t) => {
  before.draw.call(additions, place, t);
  if (forces.layer) forces.draw(t, place);
};
motion.column = (true_, name) => {
  const place = names_.indexOf(name), rows = true_ ? motion.truth : motion.rows;
  if (place < 0) return before.column.call(motion, true_, name);
  const found = rows?.n ? forces.columns(rows)[place] : [];
  return { n: rows?.n ?? 0, h: rows?.h ?? 0, value: (i) => found[i] };
};
panels.prepare = () => {
  const { shown: own } = data;
  data.shown = [...names_, ...own];
  before.prepare.call(panels);
  data.shown = own;
};
// An energy that keeps its value is a line all the same.
panels.truth = (one) => {
  before.truth.call(panels, one);
  const [low, high] = one.range, room = 0.02 * Math.abs(high);
  if (high - low > 1e-3 * room) return;
  one.range = [low - room, high + room];
  change(one.line, "d", panels.along.map((x) => `${x}500`).join(""));
};
