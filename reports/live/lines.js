// The table of what is tried, one line for each of its rows; the one at which the animation stands is marked.
// Enters: `motion`.  Leaves: `lines`.  Lines are as high as the stylesheet says, so that nobody has to measure them.
// What writing a cell and making one cost, in evaluations; px; cells that are spelled out for a frame.
const CELL = 4, NEW_CELL = 12, HEIGHT = 22, SPELLED = 120;
const lines = {
  columns: ["t", ...data.shown], kept: [], lit: null, inSight: 15, top: 0,
  prepare() {
    const row = document.createElement("tr");
    row.setAttribute("role", "row");
    for (const name of this.columns) {
      const cell = document.createElement("th");
      cell.scope = "col";
      cell.setAttribute("role", "columnheader");
      symbolic(cell, label(name));
      const unit = document.createElement("small");
      unit.textContent = data.unit_words[name];
      cell.append(document.createElement("br"), unit);
      row.append(cell);
    }
    byId("lab-head").replaceChildren(row);
    byId("lab-table").style.setProperty("--columns", this.columns.length);
    this.body = byId("lab-table").tBodies[0];
    this.box = this.body.closest(".live-scroll");
    this.box.addEventListener("scroll", () => (this.top = this.box.scrollTop), { passive: true });
    // How many lines are on the screen, told at every tenth of the box.
    const threshold = [...Array(11).keys()].map((k) => k / 10);
    const see = ({ isIntersecting, intersectionRect }) => (this.inSight = isIntersecting ? Math.ceil(intersectionRect.height / HEIGHT) + 2 : 0);
    new IntersectionObserver((entries) => entries.forEach(see), { threshold }).observe(this.box);
    this.blank = document.createElement("tr");
    this.blank.setAttribute("role", "row");
    for (const name of this.columns) {
      const cell = this.blank.appendChild(document.createElement("td"));
      cell.setAttribute("role", "cell");
      cell.setAttribute("data-column", name);
      cell.append(" ");
    }
  },
  // One line of the page for each row of the motion, elements kept from the last time.  Every value is there at once, its text
  // at once where it is in sight; the other lines are spelled out a few for each frame.
  // Of a table finer than that of the file no more is written out than can be read.
  *write() {
    const { body } = this, { rows, h } = motion, all = rows.n;
    const count = Math.min(all, Math.max(data.rows, Math.floor(data.most_cells / this.columns.length)));
    const columns = data.shown.map((name) => motion.column(false, name).value);
    const decimals = columns.map((value) => {
      let largest = 0;
      for (let i = 0; i < all; i++) largest = Math.max(largest, abs(value(i)));
      return largest > 0 ? Math.min(8, Math.max(0, 4 - Math.floor(Math.log10(largest)))) : 0;
    });
    columns.unshift((i) => i * h);
    decimals.unshift(decimalsOf(h));
    while (body.rows.length > count) this.kept.push(body.removeChild(body.lastElementChild));
    tell("lab-more", count < all ? say("first_rows", { rows: count, all }) : "");
    const spell = (line, i) => {
      line.classList.remove("live-later");
      for (let c = 0, cell = line.firstChild; c < columns.length; c++, cell = cell.nextSibling) {
        const text = fixed(columns[c](i), decimals[c]);
        if (cell.firstChild.data !== text) cell.firstChild.data = text;
      }
    };
    const first = Math.floor(this.top / HEIGHT), later = [];
    let line = body.firstElementChild;
    for (let i = 0; i < count; i++, line = line.nextElementSibling) {
      const made = !line;
      if (made) {
        line = this.kept.pop() ?? this.blank.cloneNode(true);
        line.setAttribute("data-row", i + 1);
        line.classList.add("live-later");
        body.appendChild(line);
      }
      for (let c = 0, cell = line.firstChild; c < columns.length; c++, cell = cell.nextSibling) cell.setAttribute("data-value", columns[c](i));
      if (i >= first && i < first + this.inSight) spell(line, i);
      else later.push([line, i]);
      yield (made ? NEW_CELL : CELL) * columns.length;
    }
    this.light(Number(live.dataset.row), false);
    const few = Math.ceil(SPELLED / columns.length);
    for (let k = 0; k < later.length; k++) {
      if (k % few === 0) yield FRAME;
      spell(...later[k]);
    }
  },
  // Mark the line of a row, and keep it in view while the mechanism moves.
  light(row, moving) {
    const next = this.body?.children[row - 1] ?? null;
    if (this.lit === next) return;
    if (moving && next) {
      // Read before anything is written, so that nothing is laid out twice.
      const top = row * HEIGHT, { scrollTop, clientHeight } = this.box;
      if (top < scrollTop + 2 * HEIGHT || top > scrollTop + clientHeight - 2 * HEIGHT) this.box.scrollTop = top - clientHeight / 2;
    }
    this.lit?.classList.remove("live-now");
    next?.classList.add("live-now");
    this.lit = next;
  },
};
