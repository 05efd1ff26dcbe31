// Where the animation stands, on the rest of the page: a line in every graph, the row of the table.
// Enters: graphs [data-panel] with the box of their axes and its times; rows [data-row].  Leaves: `cursors`.
const cursors = {
  panels: [],
  rows: [],
  lit: null,
  // A graph, or the drawing in it, says data-box="left top right bottom" in its own units and data-time="first last" (s).
  find() {
    const graphs = [...document.querySelectorAll("[data-panel]")];
    const homes = graphs.map((graph) => (graph.dataset.box ? graph : graph.querySelector("[data-box]"))).filter(Boolean);
    // While it moves, only the graphs that are on the screen follow.
    const watching = new IntersectionObserver((entries) => entries.forEach((one) => (one.target.seen = one.isIntersecting)));
    this.panels = homes.map((home) => {
      const [left, top, right, bottom] = home.dataset.box.split(" ").map(Number);
      const [from, to] = home.dataset.time.split(" ").map(Number);
      const line = svg("line", { class: "live-cursor", y1: top, y2: bottom }, home);
      watching.observe(home);
      return { home, line, at: (t) => left + ((right - left) * (t - from)) / (to - from || 1) };
    });
    const rows = [...document.querySelectorAll("tr[data-row]")].filter((row) => !live.contains(row));
    this.rows = rows.map((row) => [Number(row.dataset.row), row]).sort(([a], [b]) => a - b);
  },
  place(t, moving) {
    for (const { home, line, at } of this.panels) {
      if (moving && !home.seen) continue;
      const x = f1(at(t));
      change(line, "x1", x);
      change(line, "x2", x);
    }
    // A printed table may have every n-th row only: the last one that is reached.
    const own = 1 + Math.round(t / data.step);
    const reached = this.rows.findLast(([row]) => row <= own)?.[1] ?? null;
    if (reached === this.lit) return;
    this.lit?.classList.remove("live-now");
    reached?.classList.add("live-now");
    this.lit = reached;
  },
};
