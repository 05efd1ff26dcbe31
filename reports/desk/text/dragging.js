// A joint is dragged: the server says which numbers follow, the text takes them.  One move is under way, the newest one waits.

import { Refused, request } from "../requests.js";
import { moving, takeHold } from "./editor.js";
import { edited } from "./verdicts.js";

/** @import { EditorView } from "@codemirror/view" */
/** @typedef {{joint: string, place: [number, number], free: boolean, first: boolean}} Move */

/**
 * @param {EditorView} view
 * @param {{given: () => object, refuse: (sentence: string) => void, began: () => void, ended: () => void}} desk
 *   What is sent beside the text; where it is said why a joint stays; a move is under way, and none is any more.
 */
export function draggingIn(view, { given, refuse, began, ended }) {
  let busy = false;
  /** @type {Move | null} */
  let next = null;

  /** @param {Move} move */
  async function go({ joint, place, free, first }) {
    busy = true;
    began();
    if (first) takeHold();
    const { doc } = view.state;
    try {
      const asked = { ...given(), text: doc.toString(), joint, place, free };
      const found = await (await request("POST", "/api/drag", { json: asked })).json();
      refuse(found.sentence ?? "");
      // Whoever took it back meanwhile, or typed, does not want the rest of the way either.
      if (!view.state.doc.eq(doc)) next = null;
      else if (found.text) edited(view, doc, found, moving());
    } catch (error) {
      if (error instanceof Refused && error.status !== 429) refuse(error.message);
    }
    busy = false;
    const waiting = next;
    next = null;
    if (waiting) await go(waiting);
    else ended();
  }

  return {
    get busy() {
      return busy;
    },
    /** @param {Move} move */
    to(move) {
      if (busy) next = { ...move, first: move.first || Boolean(next?.first) };
      else void go(move);
    },
  };
}
