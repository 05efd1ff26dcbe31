// Small graphs of what is tried: every column over time, the true motion as a line, the rows as dots.
// Enters: `motion`.  Leaves: `panels`; each bears the box of its axes, so that the cursor finds it.
const WIDE = 300, HIGH = 120, LEFT = 44, RIGHT = 292, TOP = 20, BOTTOM = 100;
// Some round numbers from low to high.
const ticks = (low, high, most) => {
  const raw = (high - low) / most, power = 10 ** Math.floor(Math.log10(raw));
  const step = power * [1, 2, 5, 10].find((part) => part * power >= raw * (1 - 1e-9));
  const found = [];
  for (let i = Math.ceil(low / step - 1e-9); i * step <= high + 1e-9 * step; i++) found.push(i * step);
  const decimals = Math.max(0, -Math.floor(Math.log10(step) + 1e-9));
  return found.map((value) => [value, fixed(Math.abs(value) < step / 2 ? 0 : value, Math.min(decimals, 9))]);
};

const panels = {
  prepare() {
    this.all = data.shown.map((name) => {
      const panel = svg("svg", { viewBox: `0 0 ${WIDE} ${HIGH}`, role: "img", "data-panel": name }, byId("live-panels"));
      panel.dataset.box = `${LEFT} ${TOP} ${RIGHT} ${BOTTOM}`;
      const told = [label(name), data.unit_words[name]].filter(Boolean).join(", ");
      panel.setAttribute("aria-label", told);
      const title = svg("text", { x: LEFT + 4, y: 12, class: "live-title" }, panel);
      symbolic(title, told);
      const axes = svg("g", { class: "live-axes" }, panel);
      const clip = svg("svg", { x: 0, y: TOP - 3, width: WIDE, height: BOTTOM - TOP + 6, viewBox: `0 ${TOP - 3} ${WIDE} ${BOTTOM - TOP + 6}` }, panel);
      const line = svg("path", { class: "live-true" }, clip), rows = svg("path", { class: "live-table" }, clip);
      const dots = svg("path", { class: "live-dots" }, clip), dead = svg("path", { class: "live-dead" }, panel);
      return { name, panel, axes, line, rows, dots, dead };
    });
  },
  draw() {
    const last = data.end, x = (t) => f1(LEFT + ((RIGHT - LEFT) * t) / last);
    for (const one of this.all) {
      one.panel.dataset.time = `0 ${last}`;
      if (one.truth !== motion.truth) this.truth(one, x);
      const rows = motion.column(false, one.name);
      let [low, high] = this.range(motion.dead === null ? [one.range, rows] : [one.range]);
      const room = 0.06 * (high - low) || Math.max(0.5, 0.1 * Math.abs(high));
      low -= room;
      high += room;
      const y = (value) => f1(Math.max(-999, Math.min(999, BOTTOM - ((BOTTOM - TOP) * (value - low)) / (high - low))));
      // The line of the true motion is kept; what changes is how its range lies in the panel.
      const [from, to] = [y(one.range[0]), y(one.range[1])];
      one.line.setAttribute("transform", `translate(0 ${from}) scale(1 ${(to - from) / 1000})`);
      const stride = Math.ceil(rows.length / 200);
      let joined = "", dotted = "";
      for (let i = 0; i < rows.length; i += stride) {
        const at = `${x(i * motion.h)} ${y(rows[i])}`;
        joined += `${i ? "L" : "M"}${at}`;
        if (rows.length <= 80) dotted += `M${at}h0`;
      }
      one.rows.setAttribute("d", joined);
      one.dots.setAttribute("d", dotted);
      one.dead.setAttribute("d", motion.dead === null ? "" : `M${x(motion.dead)} ${TOP}V${BOTTOM}`);
      this.scale(one, `${low} ${high}`, low, high, y, x);
    }
  },
  range(columns) {
    let low = Infinity, high = -Infinity;
    for (const column of columns) {
      for (const value of column) {
        if (value < low) low = value;
        if (value > high) high = value;
      }
    }
    return low <= high ? [low, high] : [0, 1];
  },
  // The line of the true motion, its range one thousand high.
  truth(one, x) {
    one.truth = motion.truth;
    const right = motion.column(true, one.name), stride = Math.max(2, Math.ceil(right.length / 160));
    one.range = this.range([right]);
    if (motion.dead !== null && right.length) {
      // Beside a dead point a velocity grows beyond bounds: nearly all of the rows say what is worth seeing.
      const sorted = [...right].sort((a, b) => a - b), cut = 0.03 * (sorted.length - 1);
      one.range = [sorted[Math.floor(cut)], sorted[Math.ceil(sorted.length - 1 - cut)]];
    }
    const [low, high] = one.range, whole = high - low || 1;
    let path = "";
    for (let i = 0; i < right.length; i += stride) {
      const share = Math.max(-9, Math.min(9, (right[i] - low) / whole));
      path += `${i ? "L" : "M"}${x((i * data.step) / FINE)} ${Math.round(1000 * share)}`;
    }
    one.line.setAttribute("d", path);
  },
  // Axes and their numbers, written anew only where they have changed.
  scale(one, key, low, high, y, x) {
    if (one.key === key) return;
    one.key = key;
    one.axes.replaceChildren();
    let path = `M${LEFT} ${TOP}V${BOTTOM}H${RIGHT}`;
    const number = (text, x, y, anchor) => {
      svg("text", { x, y, "text-anchor": anchor }, one.axes).textContent = text;
    };
    for (const [value, text] of ticks(low, high, 3)) {
      path += `M${LEFT - 3} ${y(value)}h3`;
      number(text, LEFT - 5, y(value) + 4, "end");
    }
    for (const [value, text] of ticks(0, data.end, 4)) {
      path += `M${x(value)} ${BOTTOM}v3`;
      number(value ? text : "0", x(value), BOTTOM + 15, value ? "middle" : "start");
    }
    svg("path", { d: path }, one.axes);
    if (low < 0 && high > 0) svg("path", { d: `M${LEFT} ${y(0)}H${RIGHT}`, class: "live-zero" }, one.axes);
  },
};
