// Where the animation stands, on the rest of the page: a line in every graph, the row of the table.
// Enters: graphs [data-panel] with the box of their axes and its times; rows [data-row].  Leaves: `cursors`.
const cursors = {
  panels: [],
  rows: [],
  // A graph, or the drawing in it, says data-box="left top right bottom" in its own units and data-time="first last" (s).
  find() {
    const graphs = [...document.querySelectorAll("[data-panel]")];
    const homes = graphs.map((graph) => (graph.dataset.box ? graph : graph.querySelector("[data-box]"))).filter(Boolean);
    this.panels = homes.map((home) => {
      const [left, top, right, bottom] = home.dataset.box.split(" ").map(Number);
      const [from, to] = home.dataset.time.split(" ").map(Number);
      const line = svg("line", { class: "live-cursor", y1: top, y2: bottom }, home);
      return { line, at: (t) => left + ((right - left) * (t - from)) / (to - from || 1) };
    });
    const rows = [...document.querySelectorAll("tr[data-row]")].filter((row) => !live.contains(row));
    this.rows = rows.map((row) => [Number(row.dataset.row), row]);
  },
  place(t) {
    for (const { line, at } of this.panels) {
      const x = at(t).toFixed(2);
      line.setAttribute("x1", x);
      line.setAttribute("x2", x);
    }
    const own = 1 + Math.round(t / data.step);
    const reached = Math.max(...this.rows.map(([row]) => row).filter((row) => row <= own));
    for (const [row, element] of this.rows) element.classList.toggle("live-now", row === reached);
  },
};
