// The laboratory: step, scheme and one datum are moved; table, graphs, error, work and time follow at once.
// Enters: `motion`, `panels`, `lines`, `watch`, the controls of the page.  Leaves: `laboratory`; `changed` tells the animation.
// What a move does before the next paint, in evaluations: what they leave of it goes to graphs and lines, PIECE for each, and
// a part of it to the cells of the table.  Pieces that come with each paint after it.
const MOMENT = 7000, PIECE = 1500, NEXT = 3;
// An error below this (rad or m) is none, as in the checks of the page.
const ROUND_OFF = 1e-10;
const laboratory = /** @type {Laboratory} */ ({
  turn: 0,
  prepare() {
    /** @type {(list: any, value: string, textContent: string) => void} */
    const option = (list, value, textContent) => list.append(element("option", { value, textContent }));
    for (const name of Object.keys(data.schemes)) option(byId("lab-scheme"), name, data.words["scheme_" + name]);
    byId("lab-scheme").value = tried.scheme;
    for (const name of names) option(byId("lab-datum-name"), name, label(name));
    byId("lab-datum-box").hidden = !names.length;
    lines.prepare();
    this.slide();
    byId("lab-step").addEventListener("input", (event) => this.move({ halvings: Number(event.target.value) }));
    byId("lab-scheme").addEventListener("change", (event) => this.move({ scheme: event.target.value }));
    byId("lab-datum").addEventListener("input", (event) => this.move({ value: Number(event.target.value) }));
    byId("lab-datum-name").addEventListener("change", (event) => {
      tried.datum = event.target.value;
      tried.value = null;
      this.slide();
      this.move({});
    });
    byId("lab-reset").addEventListener("click", () => {
      Object.assign(tried, { halvings: 0, scheme: data.scheme, value: null });
      byId("lab-step").value = 0;
      byId("lab-scheme").value = tried.scheme;
      this.slide();
      this.move({});
    });
    work.begin(this.answer(Infinity), Infinity);
  },
  // Set the slider of the datum: its range and the value of the file.
  slide() {
    const slider = data.sliders[tried.datum], input = byId("lab-datum");
    if (!slider) return;
    input.min = slider.low;
    input.max = slider.high;
    input.value = data.given[tried.datum];
    byId("lab-file").firstElementChild.value = input.value;
  },
  move(change) {
    Object.assign(tried, change);
    work.begin(this.answer());
  },
  // Everything that follows from a move.  What takes longer than a moment is drawn from a sketch first, its numbers left open.
  // Graphs and lines of the table come a few before the next paint and a few with each one after it, those in sight first.
  *answer(cells = 0) {
    motion.choose();
    watch.open();
    this.tellMoved();
    const { cost } = motion, left = Math.max(PIECE, MOMENT - cost), begun = this.turn;
    if (cost > AT_ONCE && !cells) {
      motion.sketch();
      for (const id of ["lab-error", "lab-evaluations"]) tell(id, "…", "");
      tell("lab-dead", "", "");
      for (const id of ["lab-where", "lab-ratio", "lab-lost"]) tell(id, "");
      changed();
      this.draw(panels.seen, 1);
      yield FRAME;
    }
    yield* motion.compute();
    this.tellFound();
    changed();
    lines.open();
    const inSight = () => [...panels.seen, ...lines.seen];
    if (!cells) this.draw(inSight(), left / PIECE);
    yield* lines.write(cells || left / 8);
    // The first time all is drawn before the page is shown or printed, or a picture is taken of it.
    if (cells) {
      this.draw([...panels.all, ...lines.all], Infinity);
      watch.draw();
    }
    for (const pieces of [() => inSight(), () => [...panels.all, ...lines.all]]) {
      for (let late; (late = pieces().filter((one) => one.turn <= begun)).length; this.draw(late, NEXT)) yield FRAME;
    }
    watch.later();
  },
  // Draw so many pieces.  What has waited longest comes first: while a slider is dragged each has its turn.
  draw(pieces, many) {
    for (const piece of pieces.sort((a, b) => a.turn - b.turn).slice(0, many)) {
      piece.turn = ++this.turn;
      piece.draw();
    }
  },
  tellMoved() {
    const steps = Math.max(0, motion.count - 1);
    tell("lab-h", say("step", { h: plain(motion.h, 4), steps }));
    byId("lab-step").setAttribute("aria-valuetext", byId("lab-h").textContent);
    const datum = data.sliders[tried.datum];
    if (!datum) return;
    const value = (tried.value ?? data.given[tried.datum]) / datum.size;
    const text = (plain(value, 5) + (datum.unit === "°" ? "" : " ") + datum.unit).trim();
    tell("lab-value", text);
    byId("lab-datum").setAttribute("aria-valuetext", text);
  },
  tellFound() {
    const { worst, rows, dead } = motion, name = data.coordinates[worst.place];
    const none = worst.value < ROUND_OFF, error = this.amount(worst);
    // Where the links do not close there is no error.
    const known = Number.isFinite(worst.value);
    tell("lab-error", known ? error : "–", known ? String(worst.value) : "");
    const place = known ? say("where", { name: label(name), row: worst.row }) : "";
    const where = none ? data.words.round_off : place;
    if (where !== this.where) symbolic(byId("lab-where"), (this.where = where));
    tell("lab-evaluations", String(rows.evaluations), String(rows.evaluations));
    tell("lab-h", say("step", { h: plain(motion.h, 4), steps: Math.max(0, rows.n - 1) }));
    tell("lab-dead", dead === null ? "" : say("dead", { t: fixed(dead, 5) }), dead === null ? "" : String(dead));
    tell("lab-lost", !motion.truth ? data.words.open : rows.lost ? say("lost", { row: rows.n, h: plain(motion.h, 4) }) : "");
    tell("lab-ratio", this.ratio());
  },
  // Errors of other data are those of another mechanism: both are told.
  otherDatum() {
    const file = plain(data.given[tried.datum] / data.sliders[tried.datum].size, 4), { worst, first } = motion;
    return say("other_datum", { name: label(tried.datum), value: byId("lab-value").textContent, file, error: this.amount(worst), first: this.amount(first) });
  },
  amount({ value, place }) {
    const size = value < ROUND_OFF ? 0 : value, angle = data.units[data.coordinates[place]] === "rad";
    return angle ? `${shown((size * 180) / Math.PI, 3)}°` : `${shown(size * 1000, 3)} ${data.words.mm}`;
  },
  // "k times the error for n times the work", against the table of the page.
  ratio() {
    const { first, worst, rows } = motion;
    const error = worst.value / first.value, work = rows.evaluations / first.evaluations;
    if (tried.value !== null) return data.own && Number.isFinite(error) ? this.otherDatum() : "";
    if (!tried.halvings && tried.scheme === data.scheme) return data.own ? data.words.same : "";
    // Rows that end before the others are no table of so much less work.
    if (rows.lost || !Number.isFinite(error) || !Number.isFinite(work) || Math.min(first.value, worst.value) < ROUND_OFF) return "";
    /** @type {(times: number) => string} */
    const told = (times) => (times < 1e5 ? plain(times, 2) : shown(times, 2));
    return error < 0.1 ? say("less", { error: told(1 / error), work: told(work) }) : say("more", { error: told(error), work: told(work) });
  },
});

const begin = () => {
  motion.choose();
  motion.sketch();
};
const furnish = () => {
  panels.prepare();
  laboratory.prepare();
};
/** @type {(row: number, moving: boolean) => void} */
const light = (row, moving) => lines.light(row, moving);
