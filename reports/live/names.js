// Names of the points and numbers of the links, in the drawing beside what they name.
// Enters: places of a drawing.  Leaves: `words`, moved with the mechanism; no word begins over another.
const words = {
  prepare(layer) {
    this.numbers = data.links.map((link) => {
      const text = svg("text", { class: "live-link" }, layer);
      text.textContent = link.name;
      return text;
    });
    this.names = data.shown_points.map((name) => {
      const text = svg("text", {}, layer);
      symbolic(text, label(name));
      return text;
    });
  },
  // Where the number of a link stands: beside the middle of its longest side, or beside its point.
  ofLink(link, place, side) {
    let longest = -1, found = null;
    for (let k = 1; k < link.points.length; k++) {
      const [x1, y1] = drawing.put(place, link.points[k - 1]), [x2, y2] = drawing.put(place, link.points[k]);
      const size = Math.hypot(x2 - x1, y2 - y1), out = (9 * side) / (size || 1);
      if (size <= longest) continue;
      longest = size;
      found = [(x1 + x2) / 2 + out * (y2 - y1), (y1 + y2) / 2 - out * (x2 - x1) + 4];
    }
    if (found || !link.points.length) return found;
    const [x, y] = drawing.put(place, link.points[0]);
    return [x - 16 * side, y - 6];
  },
  // How much of the links (px) lies in a box, each position counted; a point every 3 px tells.
  crossed(lines, [left, top, right, bottom]) {
    let found = 0;
    for (const [x1, y1, x2, y2] of lines) {
      if (Math.max(x1, x2) < left || Math.min(x1, x2) > right || Math.max(y1, y2) < top || Math.min(y1, y2) > bottom) continue;
      const count = Math.ceil(Math.hypot(x2 - x1, y2 - y1) / 3);
      for (let k = 0; k <= count; k++) {
        const x = x1 + ((x2 - x1) * k) / count, y = y1 + ((y2 - y1) * k) / count;
        if (x > left && x < right && y > top && y < bottom) found += 3;
      }
    }
    return found;
  },
  // The links as lines about a point, in the first position and in three others; the first counts as much as these.
  about(place, others, name) {
    const [x0, y0] = drawing.put(place, name);
    return [place, place, place, ...others].flatMap((one) => {
      const [x, y] = drawing.put(one, name);
      const at = (each) => drawing.put(one, each);
      return data.links.flatMap((link) =>
        link.points.slice(1).map((each, k) => [...at(link.points[k]), ...at(each)]).map(([a, b, c, d]) => [a - x + x0, b - y + y0, c - x + x0, d - y + y0]),
      );
    });
  },
  // Choose for each word, in the first position, the side on which it lies over no other word, no joint and few links and rails: once,
  // so that no word leaps when something is tried.
  choose(place, others) {
    if (this.chosen === drawing.WIDE) return;
    this.chosen = drawing.WIDE;
    const taken = data.shown_points.map((name) => drawing.put(place, name)).map(([x, y]) => [x - 4, y - 4, x + 4, y + 4]);
    // Nor over the ground of a hinge, nor over a block.
    const keep = (name, half, gx = 0, gy = 0) => {
      const [x, y] = drawing.put(place, name), [cx, cy] = [x + gx * half, y - gy * half];
      taken.push([cx - half, cy - half, cx + half, cy + half]);
    };
    for (const { at, ground } of data.hinges) keep(at, 11, ...ground);
    for (const block of data.blocks) keep(block.at, 11);
    const choice = (boxes, lines = []) => {
      const over = ([left, top, right, bottom]) =>
        taken.reduce((sum, [l, t, r, b]) => sum + Math.max(0, Math.min(right, r) - Math.max(left, l)) * Math.max(0, Math.min(bottom, b) - Math.max(top, t)), 0);
      const costs = boxes.map((box) => 20 * over(box) + this.crossed(lines, box)), best = costs.indexOf(Math.min(...costs));
      taken.push(boxes[best]);
      return best;
    };
    this.sides = data.links.map((link) => {
      if (!link.points.length) return 1;
      const half = 4 * link.name.length + 5, sides = [1, -1];
      const boxes = sides.map((side) => this.ofLink(link, place, side)).map(([x, y]) => [x - half, y - 11, x + half, y + 2]);
      return sides[choice(boxes, this.about(place, link.points[1] ? [] : others, link.points[0]))];
    });
    this.besides = data.shown_points.map((name) => {
      const [x, y] = drawing.put(place, name), wide = 9 * label(name).replace("_", "").length + 2;
      const besides = [[9, -8], [9, 19], [-8 - wide, -8], [-8 - wide, 19], [16, 5], [-15 - wide, 5], [-wide / 2, -15], [-wide / 2, 28]];
      return besides[choice(besides.map(([dx, dy]) => [x + dx, y + dy - 13, x + dx + wide, y + dy + 4]), [...drawing.rails, ...this.about(place, others, name)])];
    });
  },
  place(place) {
    const move = (text, [x, y]) => {
      change(text, "x", f1(x));
      change(text, "y", f1(y));
    };
    data.shown_points.forEach((name, i) => {
      const [x, y] = drawing.put(place, name), [dx, dy] = this.besides[i];
      move(this.names[i], [x + dx, y + dy]);
    });
    data.links.forEach((link, i) => {
      if (link.points.length) move(this.numbers[i], this.ofLink(link, place, this.sides[i]));
    });
  },
};
