// The frame with the report: what the shell sends into it and hears from it.  It has an origin of its own;
// nothing it says is trusted.

/** @import { Told } from "../types" */

/**
 * @typedef {{
 *   shown: (id: number) => void, later: () => void, key: (key: string) => void,
 *   drag: (move: {joint: string, place: [number, number], free: boolean, first: boolean}) => void,
 * }} Heard
 */

/**
 * @param {HTMLIFrameElement} frame
 * @param {() => Record<string, string>} words
 * @param {Heard} heard
 */
export function pageIn(frame, words, heard) {
  let ready = false,
    id = 0;
  /** @type {{kind: "page", id: number, html: string, later: string[]} | null} */
  let last = null;

  /** @param {unknown} message */
  const send = (message) => frame.contentWindow?.postMessage(message, "*");

  addEventListener("message", ({ source, data }) => {
    if (source !== frame.contentWindow || typeof data !== "object" || data === null) return;
    const told = /** @type {Told} */ (data);
    if (told.kind === "ready") {
      ready = true;
      send({ kind: "words", words: words() });
      if (last) send(last);
    } else if (told.kind === "shown") heard.shown(Number(told.id));
    else if (told.kind === "later") heard.later();
    else if (told.kind === "key") heard.key(String(told.key));
    else if (told.kind === "drag") {
      const [x, y] = Array.isArray(told.place) ? told.place.map(Number) : [];
      if (typeof told.joint !== "string" || x === undefined || y === undefined || !Number.isFinite(x + y)) return;
      heard.drag({ joint: told.joint.slice(0, 60), place: [x, y], free: told.free === true, first: told.first === true });
    }
  });

  // A frame that was there first has said so to nobody.
  send({ kind: "hello" });
  return {
    /**
     * Show a page; `shown` is called with the number that this returns.
     * @param {string} html
     * @param {string[]} later Sections of which only the heading is there, until somebody looks at them.
     */
    show(html, later) {
      last = { kind: "page", id: ++id, html, later };
      if (ready) send(last);
      return id;
    },
    /** Another text begins: nothing is shown until its first page. */
    clear() {
      last = null;
      if (ready) send({ kind: "clear" });
    },
    speak: () => ready && send({ kind: "words", words: words() }),
    /** @param {string} sentence Why a joint does not follow, "" where it does. */
    refuse: (sentence) => ready && send({ kind: "refused", sentence }),
    get html() {
      return last?.html ?? null;
    },
  };
}
