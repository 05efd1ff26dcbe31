// The laboratory: step, scheme and one datum are moved; table, graphs, error, work and time follow at once.
// Enters: `motion`, the controls of the page.  Leaves: `laboratory`; `changed` tells the animation.
const laboratory = {
  prepare() {
    const option = (list, value, text) => {
      const made = document.createElement("option");
      made.value = value;
      made.textContent = text;
      list.append(made);
    };
    for (const name of Object.keys(data.schemes)) option(byId("lab-scheme"), name, data.words["scheme_" + name]);
    byId("lab-scheme").value = tried.scheme;
    for (const name of names) option(byId("lab-datum-name"), name, label(name));
    byId("lab-datum-box").hidden = !names.length;
    this.head();
    this.slide();
    byId("lab-step").addEventListener("input", (event) => this.move({ halvings: Number(event.target.value) }));
    byId("lab-scheme").addEventListener("change", (event) => this.move({ scheme: event.target.value }));
    byId("lab-datum").addEventListener("input", (event) => this.move({ value: Number(event.target.value) }));
    byId("lab-datum-name").addEventListener("change", (event) => {
      tried.datum = event.target.value;
      tried.value = null;
      this.slide();
      this.move({});
    });
    byId("lab-reset").addEventListener("click", () => {
      Object.assign(tried, { halvings: 0, scheme: data.scheme, value: null });
      byId("lab-step").value = 0;
      byId("lab-scheme").value = tried.scheme;
      this.slide();
      this.move({});
    });
    this.work();
  },
  // Set the slider of the datum: its range and the value of the file.
  slide() {
    const slider = data.sliders[tried.datum], input = byId("lab-datum");
    if (!slider) return;
    input.min = slider.low;
    input.max = slider.high;
    input.value = data.given[tried.datum];
  },
  move(change) {
    Object.assign(tried, change);
    this.work();
    changed();
  },
  // Compute, and say what came out.
  work() {
    motion.compute();
    const { worst, rows } = motion, name = data.coordinates[worst.place], angle = data.units[name] === "rad";
    const error = angle ? `${shown((worst.value * 180) / Math.PI, 3)}°` : `${shown(worst.value * 1000, 3)} ${data.words.mm}`;
    tell("lab-error", error, String(worst.value));
    symbolic(byId("lab-where"), Number.isFinite(worst.value) ? say("where", { name: label(name), row: worst.row }) : "");
    tell("lab-evaluations", String(rows.evaluations), String(rows.evaluations));
    tell("lab-h", say("step", { h: plain(motion.h, 4), steps: Math.max(0, rows.q.length - 1) }));
    byId("lab-step").setAttribute("aria-valuetext", byId("lab-h").textContent);
    const datum = data.sliders[tried.datum];
    if (datum) {
      const text = `${plain(tried.value ?? data.given[tried.datum], 5)} ${datum.unit}`.trim();
      tell("lab-value", text);
      byId("lab-datum").setAttribute("aria-valuetext", text);
    }
    const dead = motion.dead;
    tell("lab-dead", dead === null ? "" : say("dead", { t: fixed(dead, 5) }), dead === null ? "" : String(dead));
    tell("lab-lost", !motion.truth ? data.words.open : rows.lost ? say("lost", { row: rows.q.length, h: plain(motion.h, 4) }) : "");
    tell("lab-ratio", this.ratio());
    this.table();
    panels.draw();
    watch.later();
  },
  // "k times the error for n times the work", against the table of the page.
  ratio() {
    const { first, worst, rows } = motion;
    const error = worst.value / first.error, work = rows.evaluations / first.evaluations;
    if (!tried.halvings && tried.scheme === data.scheme && tried.value === null) return data.own ? data.words.same : "";
    if (!Number.isFinite(error) || !Number.isFinite(work) || error === 0) return "";
    if (error < 0.1) return say("less", { error: shown(Number((1 / error).toPrecision(2)), 2), work: plain(work, 2) });
    return say("more", { error: plain(error, 2), work: plain(work, 2) });
  },
  columns: ["t", ...data.shown],
  kept: [],
  head() {
    const row = document.createElement("tr");
    for (const name of this.columns) {
      const cell = document.createElement("th");
      cell.scope = "col";
      symbolic(cell, label(name));
      const unit = document.createElement("small");
      unit.textContent = data.unit_words[name];
      cell.append(document.createElement("br"), unit);
      row.append(cell);
    }
    byId("lab-head").replaceChildren(row);
    byId("lab-table").style.minWidth = `${66 * this.columns.length}px`;
    this.blank = document.createElement("tr");
    for (const name of this.columns) {
      const cell = this.blank.appendChild(document.createElement("td"));
      cell.setAttribute("data-column", name);
      cell.append(" ");
    }
  },
  // One row of the page for each row of the motion, elements kept from the last time.
  // Of a table finer than that of the file no more is written out than can be read.
  table() {
    const body = byId("lab-table").tBodies[0], all = motion.rows.q.length;
    const count = Math.min(all, Math.max(data.rows, Math.floor(data.most_cells / this.columns.length)));
    while (body.rows.length > count) this.kept.push(body.removeChild(body.lastElementChild));
    const values = this.columns.map((name) => (name === "t" ? motion.rows.q.map((_, i) => i * motion.h) : motion.column(false, name)));
    const decimals = values.map((column, c) => {
      if (!c) return data.decimals + Math.max(0, tried.halvings);
      const largest = column.reduce((most, value) => Math.max(most, abs(value)), 0);
      return largest > 0 ? Math.min(8, Math.max(0, 4 - Math.floor(Math.log10(largest)))) : 0;
    });
    tell("lab-more", count < all ? say("first_rows", { rows: count, all }) : "");
    let row = body.firstElementChild;
    for (let i = 0; i < count; i++, row = row.nextElementSibling) {
      if (!row) {
        row = this.kept.pop() ?? this.blank.cloneNode(true);
        row.setAttribute("data-row", i + 1);
        body.appendChild(row);
      }
      let cell = row.firstChild;
      for (let c = 0; c < values.length; c++, cell = cell.nextSibling) {
        cell.setAttribute("data-value", values[c][i]);
        cell.firstChild.data = fixed(values[c][i], decimals[c]);
      }
    }
  },
};

const start = () => {
  panels.prepare();
  laboratory.prepare();
};
