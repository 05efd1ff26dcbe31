// The state of the part that moves: row, step, scheme, datum, switches and speed, kept while the page is made anew.
// Leaves: `laboratory`.
const CONTROLS = ["lab-scheme", "lab-step", "lab-datum-name", "lab-datum", "speed", "scrub"];
const laboratory = {
  /** @type {Map<string, string>} */
  values: new Map(),
  /** @type {Map<string, string | null>} */
  switches: new Map(),
  playing: false,
  focus: "",
  keep() {
    this.values = new Map();
    for (const id of CONTROLS) {
      const control = document.getElementById(id);
      if (!(control instanceof HTMLInputElement || control instanceof HTMLSelectElement)) continue;
      if (id === "lab-datum" ? control.dataset.moved : control.value !== control.dataset.first)
        this.values.set(id, control.value);
    }
    const switches = document.querySelectorAll("#live .live-switches [aria-pressed]");
    this.switches = new Map([...switches].map((one) => [one.id, one.getAttribute("aria-pressed")]));
    const play = document.getElementById("play");
    this.playing = play?.getAttribute("aria-pressed") === "true";
    this.focus = document.activeElement?.closest("#live") ? document.activeElement.id : "";
    // What is taken off the page shall not go on moving.
    if (this.playing) play?.click();
  },
  restore() {
    for (const id of CONTROLS) {
      const control = document.getElementById(id);
      if (!(control instanceof HTMLInputElement || control instanceof HTMLSelectElement)) continue;
      control.dataset.first = control.value;
      if (id === "lab-datum") control.addEventListener("input", () => (control.dataset.moved = "yes"));
      const value = this.values.get(id);
      if (value === undefined) continue;
      control.value = value;
      for (const kind of ["input", "change"]) control.dispatchEvent(new Event(kind, { bubbles: true }));
    }
    // Some are on from the beginning.
    for (const [id, pressed] of this.switches) {
      const own = document.getElementById(id);
      if (own && own.getAttribute("aria-pressed") !== pressed) own.click();
    }
    if (this.playing) document.getElementById("play")?.click();
    if (this.focus) document.getElementById(this.focus)?.focus({ preventScroll: true });
  },
};
