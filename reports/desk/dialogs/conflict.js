// Two texts of one name side by side: the own one and what another program or window wrote.

import { EditorState, EditorView, MergeView, classHighlighter, lineNumbers, syntaxHighlighting } from "../editor/codemirror.js";
import { button, make } from "../elements.js";
import { variantLanguage } from "../text/language.js";
import { say } from "../words.js";
import { openDialog } from "./dialog.js";

/**
 * @param {string} name
 * @param {string} mine
 * @param {string} theirs
 * @param {string} nonce
 * @returns {Promise<"mine" | "theirs" | null>}
 */
export function compared(name, mine, theirs, nonce) {
  return new Promise((answer) => {
    /** @type {"mine" | "theirs" | null} */
    let choice = null;
    /** @param {"mine" | "theirs"} one */
    const chooses = (one) =>
      button(say(`keep_${one}`), () => ((choice = one), dialog.close()), { className: "main", "data-choice": one });
    const place = make("div", { className: "merge" });
    const heads = make("div", { className: "heads" }, make("h3", {}, say("mine")), make("h3", {}, say("theirs")));
    const row = make("p", { className: "row" }, chooses("mine"), chooses("theirs"));
    const { dialog } = openDialog(document.body, say("conflict", { name }), [row, heads, place], { wide: true });
    /** @param {string} label */
    const extensions = (label) => [
      EditorView.cspNonce.of(nonce),
      EditorState.readOnly.of(true),
      EditorState.phrases.of({ "$ unchanged lines": say("unchanged") }),
      lineNumbers(),
      EditorView.lineWrapping,
      variantLanguage,
      syntaxHighlighting(classHighlighter),
      EditorView.contentAttributes.of({ "aria-label": label, tabindex: "0" }),
    ];
    const merge = new MergeView({
      parent: place,
      collapseUnchanged: { margin: 3, minSize: 6 },
      a: { doc: mine, extensions: extensions(say("mine")) },
      b: { doc: theirs, extensions: extensions(say("theirs")) },
    });
    dialog.addEventListener("close", () => (merge.destroy(), answer(choice)));
  });
}
