// What the desk says of itself: reached, faulty, computing, changed or saved, as data for programs and as words for people.

import { followWords, say } from "./words.js";

/** @import { State } from "./types" */

/** @param {HTMLElement} place */
export function stateIn(place) {
  /** @type {State} */
  const now = { unreachable: null, faults: 0, missing: false, computing: true, file: "saved", fresh: false };
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let patience;
  let told = "";

  const name = () => {
    if (now.unreachable !== null) return "unreachable";
    if (now.faults) return "faulty";
    if (now.computing) return "computing";
    return now.file === "saved" ? "saved" : "changed";
  };

  /** @param {string} key */
  function words(key) {
    const file = say(now.file === "changed" && now.fresh ? "state_new" : `state_${now.file}`);
    if (key === "unreachable") return now.unreachable || say("state_unreachable");
    if (key === "faulty") return `${say(now.missing ? "state_missing" : "state_faulty", { n: now.faults })} · ${file}`;
    return key === "computing" ? say("state_computing") : file;
  }

  function write() {
    const key = name();
    place.dataset.state = key;
    place.dataset.file = now.file;
    place.toggleAttribute("data-missing", key === "faulty" && now.missing);
    clearTimeout(patience);
    // What is computed within a moment is not spoken of: the words stay, only the sign turns.
    const say_ = () => {
      if (told !== (told = words(key))) /** @type {HTMLElement} */ (place.lastElementChild).textContent = told;
    };
    if (key === "computing" && told) patience = setTimeout(say_, 700);
    else say_();
  }
  followWords(() => ((told = ""), write()));

  return {
    now,
    /** @param {Partial<State>} change */
    set(change) {
      Object.assign(now, change);
      write();
    },
  };
}
