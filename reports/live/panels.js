// Small graphs of what is tried: every column over time, the true motion as a line, the rows as dots.
// Enters: `motion`.  Leaves: `panels`; each bears the box of its axes, so that the cursor finds it.
const WIDE = 300, HIGH = 143, LEFT = 58, RIGHT = 292, TOP = 23, BOTTOM = 103;
// Some round numbers from low to high.
/** @type {(low: number, high: number, most: number) => [number, string][]} */
const ticks = (low, high, most) => {
  const raw = (high - low) / most, power = 10 ** Math.floor(Math.log10(raw));
  const step = power * ([1, 2, 5, 10].find((part) => part * power >= raw * (1 - 1e-9)) ?? NaN);
  const decimals = Math.max(0, -Math.floor(Math.log10(step) + 1e-9)), largest = Math.max(-low, high);
  // What would be mostly noughts is written in powers of ten.
  /** @type {(value: number) => string} */
  const said = decimals > 5 || largest >= 1e6 ? (value) => shown(value, 2 + Math.log10(largest / step)) : (value) => fixed(value, decimals);
  /** @type {[number, string][]} */
  const found = [];
  for (let i = Math.ceil(low / step - 1e-9); i * step <= high + 1e-9 * step; i++) found.push([i * step, i ? said(i * step) : "0"]);
  return found;
};

/** @type {(range: number[], value: number) => void} */
const widen = (range, value) => {
  if (value < range[0]) range[0] = value;
  if (value > range[1]) range[1] = value;
};
// The ends of an axis, at halves of its round numbers: they stay where they are while the values change a little.
/** @type {(...range: number[]) => Point} */
const ends = (least, most) => {
  const room = 0.04 * (most - least) || Math.max(0.5, 0.1 * Math.abs(most)), low = least - room, high = most + room;
  const half = 10 ** Math.floor(Math.log10((high - low) / 3)) / 2;
  return [Math.floor(low / half) * half, Math.ceil(high / half) * half];
};

const panels = /** @type {Panels} */ ({
  prepare() {
    /** @type {(t: number) => number} */
    this.x = (t) => f1(LEFT + ((RIGHT - LEFT) * t) / data.end);
    this.all = data.shown.map((name) => {
      const home = element("div");
      home.dataset.panel = name;
      byId("live-panels").lastElementChild.before(home);
      const panel = svg("svg", { viewBox: `0 0 ${WIDE} ${HIGH}`, role: "img" }, home);
      svg("rect", { width: WIDE, height: HIGH, fill: "#fff" }, panel);
      panel.dataset.box = `${LEFT} ${TOP} ${RIGHT} ${BOTTOM}`;
      panel.dataset.time = `0 ${data.end}`;
      const told = label(name) + data.behind[name];
      panel.setAttribute("aria-label", told);
      const title = svg("text", { x: LEFT + 4, y: 17, class: "live-title" }, panel);
      symbolic(title, told);
      const axes = svg("g", { class: "live-axes" }, panel);
      let path = `M${LEFT} ${TOP}V${BOTTOM}H${RIGHT}`;
      for (const [value, text] of ticks(0, data.end, 4)) {
        path += `M${this.x(value)} ${BOTTOM}v3`;
        // The first number and one at the end stay inside the picture.
        const [x, anchor] = !value ? [LEFT, "start"] : this.x(value) > RIGHT - 12 ? [WIDE - 1, "end"] : [this.x(value), "middle"];
        svg("text", { x, y: BOTTOM + 15, "text-anchor": anchor }, axes).textContent = value ? text : "0";
      }
      svg("path", { d: path }, axes);
      const time = svg("text", { x: RIGHT, y: HIGH - 5, "text-anchor": "end", class: "live-title" }, panel);
      symbolic(time, label("t") + data.behind.t);
      const scale = svg("g", {}, axes);
      const clip = svg("svg", { x: 0, y: TOP - 3, width: WIDE, height: BOTTOM - TOP + 6, viewBox: `0 ${TOP - 3} ${WIDE} ${BOTTOM - TOP + 6}` }, panel);
      const line = svg("path", { class: "live-true" }, clip), rows = svg("path", { class: "live-table" }, clip);
      const dots = svg("path", { class: "live-dots" }, clip), dead = svg("path", { class: "live-dead" }, panel);
      const ticked = svg("path", {}, scale), zero = svg("path", { class: "live-zero" }, scale);
      /** @type {Panel} */
      const made = { turn: 0, panel, name, scale, ticked, zero, texts: [], line, rows, dots, dead, draw: () => this.draw(made) };
      return made;
    });
  },
  // Those that can be seen now; what is not known yet counts among them.
  get seen() {
    return this.all.filter((one) => one.panel.seen !== false);
  },
  draw(one) {
    const dead = motion.dead === null ? "" : `M${this.x(motion.dead)} ${TOP}V${BOTTOM}`;
    if (one.drawn !== motion.drawn) this.truth(one);
    const { n, h, value } = motion.column(false, one.name);
    /** @type {any} */
    const range = [...one.range];
    for (let i = 0; i < n && !dead; i++) widen(range, value(i));
    const [low, high] = ends(...range);
    /** @type {(value: number) => number} */
    const y = (value) => f1(Math.max(-999, Math.min(999, BOTTOM - ((BOTTOM - TOP) * (value - low)) / (high - low))));
    // The line of the true motion is kept; what changes is how its range lies in the panel.
    /** @type {number[]} */
    const [from, to] = one.range.map(y);
    change(one.line, "transform", `translate(0 ${from}) scale(1 ${(to - from) / 1000})`);
    // At most thirty dots, or they are a rope.
    const stride = Math.ceil(n / 200), pace = stride * Math.ceil(n / stride / 30);
    let joined = "", dotted = "";
    for (let i = 0; i < n; i += stride) {
      const at = `${this.x(i * h)} ${y(value(i))}`;
      joined += `${i ? "L" : "M"}${at}`;
      if (i % pace === 0 || i === n - 1) dotted += `M${at}h0`;
    }
    change(one.rows, "d", joined);
    change(one.dots, "d", dotted);
    change(one.dead, "d", dead);
    this.scale(one, low, high, y);
  },
  // The line of the true motion, its range one thousand high.
  truth(one) {
    one.drawn = motion.drawn;
    const { n, h, value } = motion.column(true, one.name);
    one.range = [Infinity, -Infinity];
    for (let i = 0; i < n; i++) widen(one.range, value(i));
    if (motion.dead !== null && n) {
      // Beside a dead point a velocity grows beyond bounds: nearly all of the rows say what is worth seeing.
      const sorted = Float64Array.from({ length: n }, (_, i) => value(i)).sort(), cut = 0.03 * (n - 1);
      one.range = [sorted[Math.floor(cut)], sorted[Math.ceil(n - 1 - cut)]];
    }
    if (!n) one.range = [0, 1];
    const [low, high] = one.range, whole = high - low || 1, stride = Math.ceil(n / 160);
    if (this.drawn !== one.drawn) {
      // The places along the time are those of every graph.
      this.drawn = one.drawn;
      this.along = Array.from({ length: Math.ceil(n / stride) }, (_, k) => `${k ? "L" : "M"}${this.x(k * stride * h)} `);
    }
    const path = this.along.map((x, k) => x + Math.round(1000 * Math.max(-9, Math.min(9, (value(k * stride) - low) / whole)))).join("");
    change(one.line, "d", path);
  },
  // The numbers of the axis, written anew only where they have changed.
  scale(one, low, high, y) {
    const key = `${low} ${high}`;
    if (one.key === key) return;
    one.key = key;
    const few = ticks(low, high, 3), marks = few.length > 1 ? few : ticks(low, high, 6);
    while (one.texts.length > marks.length) one.texts.pop().remove();
    marks.forEach(([value, written_], i) => {
      const text = (one.texts[i] ??= svg("text", { x: LEFT - 5, "text-anchor": "end", lengthAdjust: "spacingAndGlyphs" }, one.scale));
      if (text.textContent !== written_) text.textContent = written_;
      change(text, "y", y(value) + 4);
      // A longer number is set closer, so that none is cut off.
      if (written_.length > 7) text.setAttribute("textLength", LEFT - 8);
      else text.removeAttribute("textLength");
    });
    change(one.ticked, "d", marks.map(([value]) => `M${LEFT - 3} ${y(value)}h3`).join(""));
    change(one.zero, "d", low < 0 && high > 0 ? `M${LEFT} ${y(0)}H${RIGHT}` : "");
  },
});
