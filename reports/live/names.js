// Names of the points and numbers of the links, in the drawing beside what they name.
// Enters: places of a drawing, and `data.spots`, chosen clear of the motion.  Leaves: `words`, moved with the mechanism.
const words = /** @type {Words} */ ({
  prepare(layer) {
    layer.setAttribute("lang", "en"); // Latin letters in every language: a Chinese face is taller than the room chosen for them
    /** @type {(points: string[], given: Attributes, text: string) => { made: any; points: string[] }} */
    const add = (points, given, text) => {
      const made = svg("text", { dy: 5, ...given }, layer);
      symbolic(made, text);
      return { made, points };
    };
    this.all = [
      ...data.shown_points.map((name) => add([name], {}, label(name))),
      ...data.links.map((link) => add(link.points, { class: "live-link" }, link.points.length ? link.name : "")),
    ];
  },
  // A spot is [x, y] from the point of a word, or [part, across, side] on a link: so far along that side and beside it.
  place(place) {
    this.all.forEach(({ made, points }, i) => {
      const [dx, dy, side] = data.spots[drawing.WIDE < 500 ? 1 : 0][i];
      if (!points.length) return;
      let [x, y] = drawing.put(place, points[side ?? 0]);
      if (side === undefined) [x, y] = [x + dx, y + dy];
      else {
        const [toX, toY] = drawing.put(place, points[side + 1]), wx = toX - x, wy = toY - y, out = dy / (Math.hypot(wx, wy) || 1);
        [x, y] = [x + dx * wx + out * wy, y + dx * wy - out * wx];
      }
      change(made, "x", f1(x));
      change(made, "y", f1(y));
    });
  },
});
