// Where the animation stands, on the rest of the page: a line in every graph, the row of every table.
// Enters: graphs [data-panel] with the box of their axes and its times; rows [data-row].  Leaves: `cursors`.
const cursors = /** @type {Cursors} */ ({
  panels: [],
  tables: [],
  // A graph, or the drawing in it, says data-box="left top right bottom" in its own units and data-time="first last" (s).
  find() {
    /** @type {any[]} */
    const homes = [...document.querySelectorAll("[data-panel] [data-box]")];
    // While it moves, only the graphs that are on the screen follow.
    const watching = new IntersectionObserver((all) => {
      for (const one of all) Object.assign(one.target, { seen: one.isIntersecting });
    });
    this.panels = homes.map((home) => {
      const [left, top, right, bottom] = home.dataset.box.split(" ").map(Number);
      const [from, to] = home.dataset.time.split(" ").map(Number);
      const [, , wide, high] = home.getAttribute("viewBox").split(" ").map(Number);
      const line = element("i", { className: "live-cursor" });
      Object.assign(line.style, { left: `${(100 * left) / wide}%`, top: `${(100 * top) / high}%`, height: `${(100 * (bottom - top)) / high}%` });
      home.parentElement.classList.add("live-graph");
      home.parentElement.append(line);
      watching.observe(home);
      // Its way through the graph is an animation that is held at a time: moved so, nothing is laid out or painted anew.
      const whole = `translateX(${(100 * (right - left)) / wide}cqw)`;
      const way = line.animate({ transform: ["translateX(0)", whole] }, { duration: 1000 * (to - from) || 1, fill: "both" });
      way.pause();
      return { home, way, from };
    });
    const tables = [...document.querySelectorAll("table:has(tr[data-row])")].filter((table) => !live.contains(table));
    this.tables = tables.map((table) => ({ rows: [...table.querySelectorAll("tr[data-row]")], lit: null }));
  },
  place(t, moving) {
    for (const one of this.panels) {
      const at = 1000 * (t - one.from);
      if (one.at === at || (moving && !one.home.seen)) continue;
      one.at = at;
      one.way.currentTime = at;
    }
    // A printed table may have every n-th row only: the last one that is reached.
    const own = 1 + Math.round(t / data.step);
    for (const table of this.tables) {
      const reached = table.rows.findLast((row) => Number(row.dataset.row) <= own) ?? null;
      if (reached === table.lit) continue;
      table.lit?.classList.remove("live-now");
      reached?.classList.add("live-now");
      table.lit = reached;
    }
  },
});
