// The time that a table takes on this very machine, and the diagram of error against time: every scheme with the step of the
// page has a mark from the beginning, and each try leaves one.
// Enters: `motion`.  Leaves: `watch`.  Nothing here is ever printed, and no number of the report depends on it.
/** @type {Record<string, string>} */
const MARKS = {
  euler: "M-4 0a4 4 0 1 0 8 0a4 4 0 1 0 -8 0", midpoint: "M-4 4h8l-4 -8z", heun: "M-4 -4h8v8h-8z",
  ralston: "M-4 -4h8l-4 8z", rk4: "M0 -5l5 5l-5 5l-5 -5z",
};
const MOST_TABLES = 2 ** 16;
// Rounds whose best counts: for what is tried, and for each scheme it is compared with.
const OWN_ROUNDS = 6, OTHER_ROUNDS = 3;
const OTHER_MARK = "M-4 -4l8 8m-8 0l8 -8";
// The marks as letters, for the line below the diagram.
/** @type {Record<string, string>} */
const SIGNS = { euler: "○", midpoint: "△", heun: "□", ralston: "▽", rk4: "◇" };

const watch = /** @type {Watch} */ ({
  tries: [], schemes: [],
  // What is tried now has not been measured yet.
  open() {
    tell("lab-time", "…", "");
  },
  // Wait until nothing is moved any more, then measure.
  later() {
    work.later(200, this.measure());
  },
  *measure() {
    const best = motion.rows.n ? yield* this.best(() => motion.again(), OWN_ROUNDS) : NaN;
    if (best > 0) this.note(best);
    else tell("lab-time", "–", "");
    yield* this.compare();
  },
  // The other schemes with the step of the page, as long as the data are those of the page too.
  *compare() {
    if (tried.value !== null || !motion.truth) return;
    for (const scheme of Object.keys(data.schemes)) {
      if (this.schemes.some((one) => one.scheme === scheme)) continue;
      const remake = () => motion.again(motion.timed, data.step, motion.truth, scheme);
      yield* remake();
      const error = motion.timed.n ? largestError(motion.timed, motion.truth).value : 0;
      const time = error > 0 ? yield* this.best(remake, OTHER_ROUNDS) : NaN;
      this.schemes.push({ scheme, h: data.step, error, time });
      if (time > 0) this.draw();
    }
  },
  // The best of some rounds (ms), each of so many tables that the clock of a browser can tell; nothing waits longer than for
  // one round.  A clock that stands still measures nothing: NaN.
  *best(remake, rounds) {
    let many = 1, best = Infinity;
    for (let round = 0; round < rounds; ) {
      if (many > MOST_TABLES) return NaN;
      const took = yield* this.round(remake, many);
      if (took < 4) many *= 2;
      else {
        best = Math.min(best, took / many);
        round++;
      }
    }
    return best;
  },
  // The time (ms) of so many tables; a long table is interrupted, and the clock with it.
  *round(remake, many) {
    let took = 0, begun = performance.now();
    for (let i = 0; i < many; i++) {
      for (const _ of remake()) {
        const now = performance.now();
        if (now - begun < 8) continue;
        took += now - begun;
        yield Infinity;
        begun = performance.now();
      }
    }
    took += performance.now() - begun;
    yield Infinity;
    return took;
  },
  note(best) {
    tell("lab-time", this.duration(best), String(best / 1000));
    this.first ??= best;
    tell("lab-time-ratio", say("time_ratio", { ratio: plain(best / this.first, 2) }));
    const error = motion.worst.value;
    if (!(error > 0)) return;
    /** @type {(one: Try) => boolean} */
    const known = (one) => one.error === error && one.scheme === tried.scheme && one.h === motion.h;
    this.tries = [...this.tries.filter((one) => !known(one)).slice(-59), { scheme: tried.scheme, h: motion.h, error, time: best }];
    this.draw();
  },
  duration: (ms) => (ms < 1 ? `${plain(ms * 1000, 3)} ${data.words.us}` : `${plain(ms, 3)} ${data.words.ms}`),
  draw() {
    // One mark is no diagram.
    byId("lab-diagram").closest("figure").hidden = this.schemes.length + this.tries.length < 2;
    const field = byId("lab-diagram"), left = 62, right = 330, top = 32, bottom = 174;
    /** @type {(values: number[]) => Point} */
    const powers = (values) => {
      const low = Math.floor(Math.log10(Math.min(...values)) - 0.05), high = Math.ceil(Math.log10(Math.max(...values)) + 0.05);
      return [low, high];
    };
    // A scheme that has been tried with this step has the mark of the try.
    /** @type {(one: Try) => boolean} */
    const again = (one) => this.tries.some((own) => own.scheme === one.scheme && own.h === one.h && own.error === one.error);
    const marks = [...this.schemes.filter((one) => one.time > 0 && !again(one)), ...this.tries], own = this.tries.at(-1);
    // Nothing is measured yet: the axes stand there all the same.
    const [t0, t1] = marks.length ? powers(marks.map((one) => one.time)) : [0, -1];
    const [e0, e1] = marks.length ? powers(marks.map((one) => one.error)) : [0, -1];
    /** @type {(time: number) => number} */
    const x = (time) => left + ((right - left) * (Math.log10(time) - t0)) / (t1 - t0);
    /** @type {(error: number) => number} */
    const y = (error) => bottom - ((bottom - top) * (Math.log10(error) - e0)) / (e1 - e0);
    field.replaceChildren();
    let path = `M${left} ${top}V${bottom}H${right}`;
    for (let power = t0; power <= t1; power++) {
      path += `M${f1(x(10 ** power))} ${bottom}v4`;
      svg("text", { x: f1(x(10 ** power)), y: bottom + 17, "text-anchor": "middle" }, field).textContent = this.duration(10 ** power);
    }
    for (let power = e0; power <= e1; power += Math.ceil((e1 - e0) / 6) || 1) {
      path += `M${left - 4} ${f1(y(10 ** power))}h4`;
      svg("text", { x: left - 7, y: f1(y(10 ** power) + 4), "text-anchor": "end" }, field).textContent = `10${raised(power)}`;
    }
    svg("path", { d: path, class: "live-axes" }, field);
    /** @type {(text: string, x: number, y: number, anchor: string) => void} */
    const title = (text, x, y, anchor) => (svg("text", { x, y, "text-anchor": anchor, class: "live-title" }, field).textContent = text);
    // One try may be furthest off in an angle, another in a length.
    const units = [...new Set(data.coordinates.map((name) => data.unit_words[name]))].join(data.words.or);
    title(say("error_axis", { unit: units }), left + 6, 17, "start");
    title(data.words.time_axis, right, bottom + 34, "end");
    // The tries of a scheme are joined.
    /** @type {Record<string, string>} */
    const ways = {};
    /** @type {(one: Try) => string} */
    const place = (one) => `${f1(x(one.time))} ${f1(y(one.error))}`;
    for (const one of this.tries.toSorted((a, b) => a.time - b.time)) ways[one.scheme] = (ways[one.scheme] ? ways[one.scheme] + "L" : "M") + place(one);
    svg("path", { d: Object.values(ways).join(""), class: "live-tries" }, field);
    for (const one of marks) {
      const mark = svg("path", { d: MARKS[one.scheme] ?? OTHER_MARK, class: one === own ? "live-mark live-last" : "live-mark" }, field);
      mark.setAttribute("transform", `translate(${place(one)})`);
      mark.dataset.scheme = one.scheme;
      if (this.tries.includes(one)) mark.dataset.tried = "";
      svg("title", {}, mark).textContent =
        `${data.words["scheme_" + one.scheme]}, h = ${plain(one.h, 4)} ${data.words.s}: ${shown(one.error, 3)}, ${this.duration(one.time)}`;
    }
    // Named behind or before its mark where that covers no other mark or name, what was tried last first.
    const taken = marks.map((one) => ({ from: x(one.time) - 6, to: x(one.time) + 6, at: y(one.error) }));
    for (const one of marks.toReversed()) {
      const name = data.words["scheme_" + one.scheme], at = Math.min(y(one.error), bottom - 9);
      const long = [...name].reduce((sum, letter) => sum + (letter > "\u2e80" ? 14 : 8.5), 0);
      for (const way of [8, -8]) {
        const from = x(one.time) + (way < 0 ? way - long : way), to = from + long;
        if (from < left + 2 || to > 362 || taken.some((other) => other.to > from && other.from < to && Math.abs(other.at - at) < 14)) continue;
        taken.push({ from, to, at });
        const said = svg("text", { x: f1(x(one.time) + way), y: f1(at + 4), "text-anchor": way < 0 ? "end" : "start" }, field);
        said.textContent = name;
        said.dataset.names = one.scheme;
        break;
      }
    }
    // No line breaks within the name of a scheme.
    tell("lab-key", [...new Set(marks.map((one) => one.scheme))].map((name) => `\ue003${SIGNS[name] ?? "×"} ${data.words["scheme_" + name]}\ue004`).join(", "));
  },
});
