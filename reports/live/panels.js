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
    const last = data.end, x = (t) => LEFT + ((RIGHT - LEFT) * t) / last;
    const h = data.step / FINE, stride = 2;
    for (const one of this.all) {
      one.panel.dataset.time = `0 ${last}`;
      const right = motion.column(true, one.name), rows = motion.column(false, one.name);
      let low = Infinity, high = -Infinity;
      // Beside a dead point a velocity grows beyond bounds: the middle nine tenths of the rows say what is worth seeing.
      const sorted = [...right, ...rows].filter(Number.isFinite).sort((a, b) => a - b), cut = motion.dead === null ? 0 : 0.03;
      low = sorted[Math.floor(cut * (sorted.length - 1))] ?? 0;
      high = sorted[Math.ceil((1 - cut) * (sorted.length - 1))] ?? 1;
      const room = 0.06 * (high - low) || Math.max(0.5, 0.1 * Math.abs(high));
      low -= room;
      high += room;
      const y = (value) => BOTTOM - ((BOTTOM - TOP) * (value - low)) / (high - low);
      const clip = (value) => Math.max(-999, Math.min(999, y(value))).toFixed(1);
      let path = "", dotted = "", joined = "";
      for (let i = 0; i < right.length; i += stride) path += `${i ? "L" : "M"}${x(i * h).toFixed(1)} ${clip(right[i])}`;
      rows.forEach((value, i) => {
        const at = `${x(i * motion.h).toFixed(1)} ${clip(value)}`;
        joined += `${i ? "L" : "M"}${at}`;
        if (rows.length <= 200) dotted += `M${at}h0`;
      });
      one.line.setAttribute("d", path);
      one.rows.setAttribute("d", joined);
      one.dots.setAttribute("d", dotted);
      one.dead.setAttribute("d", motion.dead === null ? "" : `M${x(motion.dead).toFixed(1)} ${TOP}V${BOTTOM}`);
      this.scale(one, `${low} ${high}`, low, high, y, x);
    }
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
      path += `M${LEFT - 3} ${f1(y(value))}h3`;
      number(text, LEFT - 5, f1(y(value) + 4), "end");
    }
    for (const [value, text] of ticks(0, data.end, 4)) {
      path += `M${f1(x(value))} ${BOTTOM}v3`;
      number(value ? text : "0", f1(x(value)), BOTTOM + 15, value ? "middle" : "start");
    }
    svg("path", { d: path }, one.axes);
    if (low < 0 && high > 0) svg("path", { d: `M${LEFT} ${f1(y(0))}H${RIGHT}`, class: "live-zero" }, one.axes);
  },
};
