// The clock: play, speed, scrub and keys; it moves drawing, cursors, rows and what is told beside them.
// Enters: `motion`, `drawing`, `cursors`; `begin`, `furnish`, `light` of what stands before it.  The last piece: it starts the page.
const scrub = byId("scrub"), play = byId("play");
const still = matchMedia("(prefers-reduced-motion: reduce)");
let now = 0, playing = false, begun = 0, asked = 0, pictures = 0;

// Show the time t (s), what is written of it too or not; the scrub stands at the row, counted from 0 with a fraction.
/** @type {(t: number, inWords?: boolean) => void} */
const show = (t, inWords = true) => {
  now = Math.min(Math.max(t, 0), motion.duration);
  // Nothing is marked before the first move.
  if (now > 0) document.documentElement.classList.add("live-moved");
  const row = motion.h > 0 ? now / motion.h : 0, nearest = Math.round(row) + 1;
  light(nearest, playing);
  change(live, "data-row", nearest);
  if (Number(scrub.value) !== row) scrub.value = row;
  cursors.place(now, playing);
  const places_ = drawing.draw(now);
  if (!inWords) return;
  // Between rows about a tenth of the step is told, not all digits that a row may need.
  const between = Math.abs(row - nearest + 1) > 1e-6, first = Math.floor(row) + 1;
  const told = say(between ? "clock_between" : "clock", {
    row: between ? first : nearest, next: first + 1, t: fixed(now, playing || between ? decimalsOf(+motion.h.toPrecision(1)) + 1 : decimalsOf(motion.h)),
  });
  scrub.setAttribute("aria-valuetext", told);
  tell("live-clock", told);
  const { right, ghost } = places_ ?? {};
  const rail = ghost && offRail(ghost), away = ghost && right && offPlace(ghost, right);
  // What differs by less than 50 nm is where it should be.
  /** @type {(found: Off, there: string, away_: string) => string} */
  const off = ({ point, distance }, there, away_) => {
    const { finest } = motion, known = finest ? Math.round(distance / finest) * finest : distance;
    return say(known < 5e-8 ? there : away_, { point: label(point), distance: (finest ? plain : shown)(known * 1000, 3) });
  };
  tell("live-rail", rail ? off(rail, "on_" + rail.guide, "off_" + rail.guide) : "", rail ? String(rail.distance) : "");
  tell("live-away", away ? off(away, "in_place", "off_place") : right && !ghost ? data.words.no_ghost : "");
};

// After the laboratory has changed the motion: the same time, other rows.
const changed = () => {
  scrub.max = Math.max(motion.count - 1, 1e-9);
  drawing.refit();
  tell("live-ghost", say("ghost", { scheme: data.words["scheme_" + (motion.rows?.name ?? data.scheme)], h: plain(motion.rows?.h ?? data.step, 4) }));
  show(now);
};

/** @type {FrameRequestCallback} */
const frame = (stamp) => {
  if (!playing) return;
  const past = Math.min(stamp - begun, 100) / 1000;
  begun = stamp;
  const t = now + past * Number(byId("speed").value);
  // Nobody reads sixty numbers a second: all of them are written together, at every fourth frame.
  show(t >= motion.duration ? t % (motion.duration || 1) : t, ++pictures % 4 === 0);
  asked = requestAnimationFrame(frame);
};
// Where motion on the screen is not wanted: row by row, once a second.
const tick = () => {
  if (playing) show(now >= motion.duration * (1 - 1e-9) ? 0 : (Math.floor(now / motion.h + 1e-6) + 1) * motion.h);
};
/** @type {(on: boolean) => void} */
const run = (on) => {
  playing = on;
  play.setAttribute("aria-pressed", String(on));
  if (!on) show(now);
  tell("play-text", data.words[on ? "pause" : "play"]);
  live.classList.toggle("live-playing", on);
  cancelAnimationFrame(asked);
  clearInterval(asked);
  if (on && still.matches) asked = setInterval(tick, 1000);
  else if (on) {
    begun = performance.now();
    asked = requestAnimationFrame(frame);
  }
};

/** @type {Record<string, () => void>} */
const KEYS = {
  " ": () => run(!playing),
  ArrowLeft: () => show((Math.ceil(now / motion.h - 1e-6) - 1) * motion.h),
  ArrowRight: () => show((Math.floor(now / motion.h + 1e-6) + 1) * motion.h),
  Home: () => show(0),
  End: () => show(motion.duration),
};
live.addEventListener("keydown", (event) => {
  const own = event.target.closest("input, select, textarea, .live-scroll") || (event.key === " " && event.target.closest("button, summary"));
  if (own || event.ctrlKey || event.altKey || event.metaKey || !KEYS[event.key]) return;
  event.preventDefault();
  KEYS[event.key]();
});
play.addEventListener("click", () => run(!playing));
scrub.addEventListener("input", () => show(Number(scrub.value) * motion.h));
for (const name of Object.keys(additions.on)) {
  const button = byId(`live-${name}`);
  button.addEventListener("click", () => {
    additions.on[name] = !additions.on[name];
    button.setAttribute("aria-pressed", String(additions.on[name]));
    additions.renew();
    show(now);
  });
}
addEventListener("resize", () => {
  stops();
  drawing.refit();
  show(now);
});

live.hidden = false;
document.documentElement.classList.add("live-on");
// What moves is drawn first; the laboratory comes when the rest of the page is there, its tables and graphs behind this script.
begin();
drawing.prepare();
changed();
addEventListener("DOMContentLoaded", () => {
  furnish();
  cursors.find();
  show(now);
  // What can be moved sideways is known when all is laid out, which a browser does once before it draws.
  requestAnimationFrame(stops);
});
