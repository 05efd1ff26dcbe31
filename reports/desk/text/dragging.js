// A joint is dragged: the server says which numbers follow, the text takes them.  One move is under way, the newest one waits.

import { Refused, post } from "../requests.js";
import { moving, takeHold } from "./editor.js";
import { edited } from "./verdicts.js";

/** @import { EditorView } from "@codemirror/view" */
/** @typedef {{joint: string, place: [number, number], free: boolean, first: boolean}} Move */

/**
 * @param {EditorView} view
 * @param {() => object} given What is sent beside the text.
 * @param {(sentence: string) => void} refuse
 */
export function draggingIn(view, given, refuse) {
  let busy = false;
  /** @type {Move | null} */
  let next = null;

  /** @param {Move} move */
  async function go({ joint, place, free, first }) {
    busy = true;
    if (first) takeHold();
    const { doc } = view.state;
    try {
      const found = await post("/api/drag", { ...given(), text: doc.toString(), joint, place, free });
      refuse(found.sentence ?? "");
      if (found.text) edited(view, doc, found, moving());
    } catch (error) {
      if (error instanceof Refused && error.status !== 429) refuse(error.message);
    }
    busy = false;
    if (next) {
      const waiting = next;
      next = null;
      await go(waiting);
    }
  }

  return /** @param {Move} move */ (move) => {
    if (busy) next = { ...move, first: move.first || Boolean(next?.first) };
    else void go(move);
  };
}
