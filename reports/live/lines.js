// The table of what is tried, one line for each of its rows; the one at which the animation stands is marked.
// Enters: `motion`.  Leaves: `lines`.  Lines are as high as the stylesheet says, so that nobody has to measure them.
// How many cells that have to be written making one costs; px; cells that are spelled out together.
const NEW_CELL = 5, HEIGHT = 22, SPELLED = 60;
const lines = /** @type {Lines} */ ({
  columns: ["t", ...data.shown], made: [], groups: [], count: 0, lit: null, inSight: 15, top: 0, few: 0, wanted: 0, value: [], decimals: [],
  prepare() {
    const row = element("tr");
    row.setAttribute("role", "row");
    for (const name of this.columns) {
      const cell = element("th", { scope: "col" });
      cell.setAttribute("role", "columnheader");
      symbolic(cell, label(name));
      cell.append(element("br"), element("small", { textContent: data.unit_words[name] }));
      row.append(cell);
    }
    byId("lab-head").replaceChildren(row);
    byId("lab-table").closest(".live-below").style.setProperty("--columns", this.columns.length);
    this.body = byId("lab-table").tBodies[0];
    this.box = this.body.closest(".live-scroll");
    this.box.addEventListener("scroll", () => (this.top = this.box.scrollTop), { passive: true });
    // How many lines are on the screen, told at every tenth of the box.
    const threshold = [...Array(11).keys()].map((k) => k / 10);
    /** @type {(one: IntersectionObserverEntry) => void} */
    const see = ({ isIntersecting, intersectionRect }) => (this.inSight = isIntersecting ? Math.ceil(intersectionRect.height / HEIGHT) : 0);
    new IntersectionObserver((entries) => entries.forEach(see), { threshold }).observe(this.box);
    this.few = Math.ceil(SPELLED / this.columns.length);
    this.blank = element("tr");
    this.blank.setAttribute("role", "row");
    for (const name of this.columns) {
      const cell = this.blank.appendChild(element("td"));
      cell.setAttribute("role", "cell");
      cell.setAttribute("data-column", name);
      cell.append(" ");
    }
  },
  make(i) {
    const line = this.blank.cloneNode(true), cells = [...line.children];
    line.setAttribute("data-row", i + 1);
    if (i > 15) line.classList.add("live-far");
    // Lines that are spelled out together wait for their turn together.
    if (i % this.few === 0) this.groups.push({ turn: 0, from: i, draw: () => this.spell(i) });
    return { line, cells, texts: cells.map((cell) => cell.firstChild), values: [], said: [] };
  },
  // Take over the rows of the motion; lines behind the last of them go.
  // Of a table finer than that of the file no more is written out than can be read.
  open() {
    const { rows, h } = motion, all = rows.n;
    this.wanted = Math.min(all, Math.max(data.rows, Math.floor(data.most_cells / this.columns.length)));
    this.value = data.shown.map((name) => motion.column(false, name).value);
    this.decimals = this.value.map((value) => {
      let largest = 0;
      for (let i = 0; i < all; i++) largest = Math.max(largest, abs(value(i)));
      return largest > 0 ? Math.max(0, 4 - Math.floor(Math.log10(largest))) : 0;
    });
    this.value.unshift((i) => i * h);
    this.decimals.unshift(decimalsOf(h));
    while (this.count > this.wanted) this.body.removeChild(this.made[--this.count].line);
    tell("lab-more", this.wanted < all ? say("first_rows", { rows: this.wanted, all }) : "");
  },
  // One line of the page for each row, elements kept from the last time, so many cells for a frame; their text comes later.
  *write(room) {
    for (let i = 0, left = room; i < this.wanted; i++) {
      const made = i === this.made.length;
      if ((left -= this.columns.length * (made ? NEW_CELL : 1)) < 0) {
        yield FRAME;
        left = room;
      }
      if (made) this.made.push(this.make(i));
      const { line, cells, values } = this.made[i];
      if (i === this.count) {
        line.ariaBusy = "true";
        this.body.appendChild(line);
        this.count++;
      }
      this.value.forEach((value, c) => {
        const now = value(i);
        if (values[c] !== now) cells[c].setAttribute("data-value", (values[c] = now));
      });
    }
    this.light(Number(live.dataset.row), false);
  },
  spell(from) {
    for (let i = from; i < Math.min(from + this.few, this.count); i++) {
      const { line, texts, said } = this.made[i];
      line.ariaBusy = null;
      this.value.forEach((value, c) => {
        const text = this.decimals[c] > 8 ? shown(value(i), 3) : fixed(value(i), this.decimals[c]);
        if (said[c] !== text) texts[c].data = said[c] = text;
      });
    }
  },
  // The groups of lines that there are, and those in sight.
  get all() {
    return this.groups.filter(({ from }) => from < this.count);
  },
  get seen() {
    const first = Math.floor(this.top / HEIGHT);
    return this.all.filter(({ from }) => from + this.few > first && from < first + this.inSight);
  },
  // Mark the line of a row, and keep it in view while the mechanism moves.
  light(row, moving) {
    const next = row <= this.count ? this.made[row - 1].line : null;
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
});
