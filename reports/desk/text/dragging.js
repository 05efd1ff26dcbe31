// A joint is dragged: the server says which numbers follow, the text takes them.  One move is under way, the newest one waits.

import { Refused, post } from "../requests.js";
import { rewrite } from "./editor.js";
import { offset } from "./places.js";
import { markMoved } from "./verdicts.js";

/** @import { EditorView } from "@codemirror/view" */
/** @typedef {{joint: string, place: [number, number], free: boolean, last: boolean}} Move */

/**
 * @param {EditorView} view
 * @param {{given: () => object, moved: () => void, refuse: (sentence: string) => void}} tell `given` is sent beside the text.
 */
export function draggingIn(view, { given, moved, refuse }) {
  let busy = false;
  /** @type {Move | null} */
  let next = null;

  /** @param {Move} move */
  async function go({ joint, place, free }) {
    busy = true;
    const text = view.state.doc.toString();
    try {
      const found = await post("/api/drag", { ...given(), text, joint, place, free });
      refuse(found.sentence ?? "");
      // What was typed meanwhile is not undone by a hand that moved before.
      if (view.state.doc.toString() === text && rewrite(view, found.text, { kind: "move.joint" })) {
        const { doc } = view.state;
        markMoved(view, (found.ranges ?? []).map((/** @type {import("../types").Span} */ one) => ({ from: offset(doc, one.line, one.column), to: offset(doc, one.end_line, one.end_column) })));
        moved();
      }
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
    if (busy) next = move;
    else void go(move);
  };
}
