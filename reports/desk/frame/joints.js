// The joints of Figure 1 are dragged: mouse, finger, arrow keys.  The shell is told where to; the text and the page follow.
// Enters: `tell`.  Leaves: `joints`.
const KEYS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
const joints = {
  /** @type {import("../types").Held | null} */
  held: null,
  free: false,
  focus: "",

  /** @param {Element | null} ring
   * @returns {import("../types").Joint | null} */
  read(ring) {
    if (!(ring instanceof SVGCircleElement) || !ring.ownerSVGElement) return null;
    const [x, y] = (ring.dataset.at ?? "").split(" ").map(Number);
    return {
      joint: ring.dataset.joint ?? "",
      at: [x ?? 0, y ?? 0],
      mm: Number(ring.dataset.mm),
      svg: ring.ownerSVGElement,
      ring,
    };
  },

  /** Make the joints of a new drawing reachable; a drawing that comes while one is dragged keeps its place under the hand. */
  prepare() {
    const rings = document.querySelectorAll("#mechanism [data-joint]");
    for (const ring of rings) {
      const joint = this.read(ring);
      if (!joint) continue;
      const name = say("drag_joint", { name: joint.joint });
      for (const [key, value] of Object.entries({
        tabindex: "0",
        role: "button",
        "aria-label": name,
        "aria-describedby": "drag-how",
      }))
        ring.setAttribute(key, value);
      // What a hand catches lies on top, and is larger than what is seen.
      const catcher = document.createElementNS("http://www.w3.org/2000/svg", "circle"),
        title = document.createElementNS("http://www.w3.org/2000/svg", "title");
      for (const [key, value] of Object.entries({
        class: "catcher",
        cx: ring.getAttribute("cx"),
        cy: ring.getAttribute("cy"),
        r: 3.4,
      }))
        catcher.setAttribute(key, String(value));
      title.textContent = name;
      catcher.append(title);
      joint.svg.append(catcher);
    }
    // A picture with things in it that are moved is no picture any more.
    rings[0]?.closest("[role=img]")?.setAttribute("role", "group");
    if (this.held) this.hold();
    if (this.focus) this.find(this.focus)?.focus({ preventScroll: true });
  },

  /** @param {string} name
   * @returns {SVGCircleElement | null} */
  find: (name) => document.querySelector(`#mechanism [data-joint="${CSS.escape(name)}"]`),

  /** Of joints whose catchers lie over each other the one that is meant.
   * @param {number} x
   * @param {number} y */
  nearest(x, y) {
    const away = (/** @type {Element} */ ring) => {
      const { left, right, top, bottom } = ring.getBoundingClientRect();
      return Math.hypot((left + right) / 2 - x, (top + bottom) / 2 - y);
    };
    return this.read([...document.querySelectorAll("#mechanism [data-joint]")].sort((a, b) => away(a) - away(b))[0] ?? null);
  },

  hold() {
    const { held } = this,
      joint = held && this.read(this.find(held.name));
    if (!held || !joint) return;
    const { svg, ring, at, mm } = joint;
    // The origin of the mechanism on this sheet, and the window of the sheet that shows it where it was.
    const origin = [ring.cx.baseVal.value - at[0] * mm, ring.cy.baseVal.value + at[1] * mm],
      k = mm / held.mm;
    const [x = 0, y = 0, w = 0, h = 0] = held.box;
    svg.dataset.own ??= svg.getAttribute("viewBox") ?? "";
    svg.setAttribute(
      "viewBox",
      [
        (origin[0] ?? 0) + (x - (held.origin[0] ?? 0)) * k,
        (origin[1] ?? 0) + (y - (held.origin[1] ?? 0)) * k,
        w * k,
        h * k,
      ].join(" "),
    );
    svg.style.width = `${held.width}px`;
    svg.style.height = `${held.height}px`;
    svg.style.overflow = "visible";
    ring.classList.add("held");
  },

  /** The drawing as large as it fits: what was held for one hand is not kept for the next hand, nor for another text. */
  fit() {
    for (const svg of document.querySelectorAll("#mechanism svg[data-own]")) {
      if (!(svg instanceof SVGSVGElement)) continue;
      svg.setAttribute("viewBox", svg.dataset.own ?? "");
      delete svg.dataset.own;
      for (const set of ["width", "height", "overflow"]) svg.style.removeProperty(set);
    }
  },

  /** Where a place of the window lies in the mechanism (m).
   * @param {number} x
   * @param {number} y
   * @returns {[number, number]} */
  place(x, y) {
    const { held } = this;
    if (!held) return [0, 0];
    const at = new DOMPoint(x, y + scrollY).matrixTransform(held.matrix);
    return [(at.x - (held.origin[0] ?? 0)) / held.mm, ((held.origin[1] ?? 0) - at.y) / held.mm];
  },

  /** @param {PointerEvent} event */
  down(event) {
    const joint =
      event.target instanceof Element && event.target.matches(".catcher, .catcher *")
        ? this.nearest(event.clientX, event.clientY)
        : null;
    const screen = joint?.svg.getScreenCTM();
    if (!joint || !screen || event.button) return;
    event.preventDefault();
    const { at, mm, svg } = joint,
      { cx, cy } = joint.ring,
      box = svg.viewBox.baseVal;
    // The window may be scrolled meanwhile: places are counted from the top of the page.
    const matrix = DOMMatrix.fromMatrix(screen);
    matrix.f += scrollY;
    this.held = {
      name: joint.joint,
      mm,
      origin: [cx.baseVal.value - at[0] * mm, cy.baseVal.value + at[1] * mm],
      box: [box.x, box.y, box.width, box.height],
      width: svg.getBoundingClientRect().width,
      height: svg.getBoundingClientRect().height,
      moved: false,
      matrix: matrix.inverse(),
    };
    this.focus = joint.joint;
    joint.ring.focus({ preventScroll: true });
    document.documentElement.classList.add("dragging");
  },

  /** The ring is where the hand is before the drawing is there.
   * @param {number} x
   * @param {number} y */
  follow(x, y) {
    const ring = this.held && this.find(this.held.name),
      screen = ring?.ownerSVGElement?.getScreenCTM();
    if (!ring || !screen) return;
    const at = new DOMPoint(x, y).matrixTransform(screen.inverse());
    ring.setAttribute("transform", `translate(${at.x - ring.cx.baseVal.value} ${at.y - ring.cy.baseVal.value})`);
  },

  /** @param {PointerEvent} event
   * @param {boolean} last */
  move(event, last) {
    if (!this.held) return;
    event.preventDefault();
    this.follow(event.clientX, event.clientY);
    tell({
      kind: "drag",
      joint: this.held.name,
      place: this.place(event.clientX, event.clientY),
      free: event.altKey || this.free,
      first: !this.held.moved,
    });
    this.held.moved = true;
    if (last) this.drop();
  },

  /** What cannot follow to where the hand was is where it can be. */
  drop() {
    if (!this.held) return;
    const ring = this.find(this.held.name);
    this.held = null;
    this.fit();
    ring?.removeAttribute("transform");
    ring?.classList.remove("held");
    document.documentElement.classList.remove("dragging");
  },

  /** @param {KeyboardEvent} event */
  key(event) {
    const joint = this.read(event.target instanceof Element ? event.target.closest("#mechanism [data-joint]") : null);
    const way = joint && Object.entries(KEYS).find(([key]) => key === event.key)?.[1];
    if (!joint || !way || event.ctrlKey || event.metaKey) return;
    event.preventDefault();
    // A millimetre of the drawing; with Shift ten.
    const far = (event.shiftKey ? 10 : 1) / joint.mm;
    this.focus = joint.joint;
    tell({
      kind: "drag",
      joint: joint.joint,
      place: [joint.at[0] + far * (way[0] ?? 0), joint.at[1] + far * (way[1] ?? 0)],
      free: event.altKey || this.free,
      first: !event.repeat,
    });
  },
};
document.addEventListener("pointerdown", (event) => joints.down(event));
document.addEventListener("pointermove", (event) => joints.move(event, false));
document.addEventListener("pointerup", (event) => joints.move(event, true));
// What is broken off has no place of its own: the joint stays where it was last.
document.addEventListener("pointercancel", () => joints.drop());
// A finger on a joint does not move the page, whatever becomes of the drawing under it.
document.addEventListener("touchstart", (event) => joints.held && event.preventDefault(), {
  passive: false,
});
document.addEventListener("keydown", (event) => joints.key(event));
document.addEventListener("focusout", (event) => {
  if (!joints.held && document.hasFocus() && event.relatedTarget) joints.focus = "";
});
