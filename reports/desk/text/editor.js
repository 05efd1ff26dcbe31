// The editor of the text: CodeMirror with what a variant file needs.  What is typed stands there letter by letter:
// nothing is closed or indented by itself, and Tab leaves it.

import {
  EditorState,
  EditorView,
  Compartment,
  bracketMatching,
  classHighlighter,
  defaultKeymap,
  drawSelection,
  highlightActiveLine,
  highlightActiveLineGutter,
  highlightSelectionMatches,
  highlightSpecialChars,
  history,
  historyKeymap,
  insertNewline,
  keymap,
  lineNumbers,
  lintKeymap,
  search,
  searchKeymap,
  syntaxHighlighting,
  Transaction,
} from "../editor/codemirror.js";
import { followWords, say } from "../words.js";
import { variantLanguage } from "./language.js";
import { changes } from "./places.js";

const PHRASES = [
  "Find",
  "Replace",
  "next",
  "previous",
  "all",
  "match case",
  "regexp",
  "by word",
  "replace",
  "replace all",
  "close",
];

/** What a slider or a joint does to the text. */
export const MOVE = "input.type.move";
let gesture = 0;
/** A hand takes hold, or a key is pressed: what follows is undone apart from what was before. */
export const takeHold = () => void (gesture += 1);
/** The user event of what a hand does in this gesture. */
export const moving = () => `${MOVE}.${gesture}`;

const TYPING = 500, // ms within which letters are undone as one
  NEVER = 1e12;
/** What a hand moves in one gesture is undone as one, however long it takes; typing as everywhere. */
function undoing() {
  let kind = "",
    at = 0;
  return [
    history({
      newGroupDelay: NEVER,
      joinToEvent: (transaction, adjacent) =>
        transaction.isUserEvent(MOVE) ? transaction.isUserEvent(kind) : adjacent && !kind && Date.now() - at < TYPING,
    }),
    EditorView.updateListener.of(({ docChanged, transactions }) => {
      if (docChanged) [kind, at] = [transactions.some((one) => one.isUserEvent(MOVE)) ? moving() : "", Date.now()];
    }),
  ];
}

/** A letter typed over a selection: a browser would keep the colours that stood there as a style, which the policy forbids. */
const typedOver = EditorView.domEventHandlers({
  beforeinput(event, view) {
    if (event.inputType !== "insertText" || event.isComposing || !event.data || view.state.selection.main.empty) return false;
    view.dispatch(view.state.replaceSelection(event.data), { userEvent: "input.type", scrollIntoView: true });
    event.preventDefault();
    return true;
  },
});

/**
 * @typedef {{nonce: string, extensions: import("@codemirror/state").Extension[], save: () => void,
 *   changed: (update: import("@codemirror/view").ViewUpdate) => void}} Wanted
 */

/**
 * @param {HTMLElement} place
 * @param {Wanted} wanted
 */
export function editorIn(place, { nonce, extensions, save, changed }) {
  const spoken = new Compartment(),
    lit = new Compartment();
  const dark = matchMedia("(prefers-color-scheme: dark)");
  const words = () => [
    EditorState.phrases.of(Object.fromEntries(PHRASES.map((phrase) => [phrase, say(`find_${phrase.replaceAll(" ", "_")}`)]))),
    EditorView.contentAttributes.of({ "aria-label": say("text_label"), tabindex: "0" }),
  ];
  const light = () => EditorView.theme({}, { dark: dark.matches });
  const saving = { key: "Mod-s", preventDefault: true, run: () => (save(), true) };
  const view = new EditorView({
    parent: place,
    state: EditorState.create({
      extensions: [
        EditorView.cspNonce.of(nonce),
        lit.of(light()),
        spoken.of(words()),
        lineNumbers(),
        highlightActiveLineGutter(),
        highlightSpecialChars(),
        undoing(),
        typedOver,
        drawSelection(),
        bracketMatching(),
        highlightActiveLine(),
        highlightSelectionMatches(),
        search({ top: true }),
        variantLanguage,
        syntaxHighlighting(classHighlighter),
        EditorView.lineWrapping,
        ...extensions,
        keymap.of([
          saving,
          { key: "Enter", run: insertNewline },
          ...searchKeymap,
          ...historyKeymap,
          ...lintKeymap,
          ...defaultKeymap,
        ]),
        EditorView.updateListener.of((update) => update.docChanged && changed(update)),
      ],
    }),
  });
  dark.addEventListener("change", () => view.dispatch({ effects: lit.reconfigure(light()) }));
  followWords(() => view.dispatch({ effects: spoken.reconfigure(words()) }));
  return view;
}

/**
 * Put another text into the editor by small changes: cursor, undo and what is marked stay.  Returns whether it was another.
 * @param {EditorView} view
 * @param {string} text
 * @param {{kind?: string, undo?: boolean}} [how]
 */
export function rewrite(view, text, { kind = "input.desk", undo = true } = {}) {
  const found = changes(view.state.doc.toString(), text.replaceAll("\r\n", "\n"));
  if (found.length) view.dispatch({ changes: found, userEvent: kind, annotations: Transaction.addToHistory.of(undo) });
  return found.length > 0;
}
