// Faults: underlined where they are, listed below with a link to the place and a mend; remarks in another colour.

import { EditorView, setDiagnostics } from "../editor/codemirror.js";
import { button, make } from "../elements.js";
import { say } from "../words.js";
import { extent, offset } from "./places.js";

/** @import { ChangeDesc, Text } from "@codemirror/state" */
/** @import { Answer, Edit, Fault, PlacedFault as Told, Remark } from "../types" */

const MISSING = ["V012", "V072"]; // a section, the equations
/** What the text has not yet is what is still to be typed, no slip: it stands nowhere.
 * @param {Fault | Remark} fault
 */
export const isMissing = (fault) => "code" in fault && MISSING.includes(fault.code);

/** What is wrong with scheme or step stands nowhere in the text, as what is missing.
 * @param {Fault | Remark} fault
 */
const isNowhere = (fault) => isMissing(fault) || fault.line === null;

/** What is told of a fault where its place is not beside it.
 * @param {Fault} fault
 */
export const told = (fault) => (isNowhere(fault) ? begun(fault.sentence) : `${placeOf(fault)} ${fault.sentence}`);

/** @param {string} text What begins a sentence. */
const begun = (text) => text.charAt(0).toLocaleUpperCase() + text.slice(1);

/** @param {{line: number | null, column: number | null}} fault */
const placeOf = ({ line, column }) => say("place", { line: line ?? 1, column: column ?? 1 });

/**
 * @param {Text} doc The text that was asked about.
 * @param {ChangeDesc} since What was changed in it since.
 * @param {Fault | Remark} fault
 * @returns {Told}
 */
function placed(doc, since, fault) {
  const { from, to } = extent(doc, fault.line, fault.column);
  /** @type {Edit | null} */
  const mend = "mend" in fault ? fault.mend : null;
  const mended = mend && {
    from: since.mapPos(offset(doc, mend.line, mend.column), 1),
    to: since.mapPos(offset(doc, mend.end_line, mend.end_column), -1),
    insert: mend.text,
  };
  const start = since.mapPos(from, 1);
  return {
    from: start,
    to: Math.max(start, since.mapPos(to, -1)),
    line: fault.line ?? 1,
    column: fault.column ?? 1,
    sentence: fault.sentence,
    missing: isMissing(fault),
    nowhere: isNowhere(fault),
    mend: mended && mended.from <= mended.to ? mended : null,
  };
}

/**
 * @param {EditorView} view
 * @param {Told} fault
 */
function mendIt(view, { mend }) {
  if (!mend) return;
  view.dispatch({
    changes: mend,
    selection: { anchor: mend.from + mend.insert.length },
    userEvent: "input.mend",
    scrollIntoView: true,
  });
  view.focus();
}

/**
 * @param {EditorView} view
 * @param {Told} fault
 */
function goTo(view, { from, to }) {
  const end = view.state.doc.length;
  view.dispatch({
    selection: { anchor: Math.min(from, end), head: Math.min(to, end) },
    effects: EditorView.scrollIntoView(Math.min(from, end), { y: "center" }),
  });
  view.focus();
}

/**
 * @param {EditorView} view
 * @param {HTMLElement} list
 * @param {Answer} answer
 * @param {Text} doc
 * @param {ChangeDesc} since
 */
export function showFaults(view, list, answer, doc, since) {
  const faults = answer.faults.map((fault) => placed(doc, since, fault));
  const remarks = (answer.remarks ?? []).map((remark) => placed(doc, since, remark));
  const name = () => say("mend");
  /** @param {"error" | "info"} severity */
  const marked = (severity) => (/** @type {Told} */ fault) => ({
    from: fault.from,
    to: fault.to,
    severity,
    message: fault.sentence,
    actions: fault.mend ? [{ name: name(), apply: () => mendIt(view, fault) }] : [],
  });
  const somewhere = (/** @type {Told[]} */ list) => list.filter(({ nowhere }) => !nowhere);
  const signs = [...somewhere(faults).map(marked("error")), ...somewhere(remarks).map(marked("info"))];
  view.dispatch(setDiagnostics(view.state, signs));
  list.replaceChildren(
    ...faults.map((fault) => line(view, fault, fault.missing ? "fault missing" : fault.nowhere ? "fault nowhere" : "fault")),
    ...remarks.map((remark) => line(view, remark, "remark")),
  );
}

/** Sections are begun, anything else is written otherwise.
 * @param {string} insert */
const mendWords = (insert) => {
  const heads = /^\s*\[.*\]\n/.test(insert) && insert.match(/^\[.*\]$/gm);
  return heads ? say("begin_with", { text: heads.join(", ") }) : say("mend_to", { text: insert.trim() || say("nothing") });
};

/**
 * @param {EditorView} view
 * @param {Told} fault
 * @param {string} kind
 */
function line(view, fault, kind) {
  const place = fault.nowhere ? [] : [make("b", {}, placeOf(fault)), " "];
  const go = button([...place, fault.sentence], () => goTo(view, fault), { className: "go" });
  const mend = fault.mend && button(mendWords(fault.mend.insert), () => mendIt(view, fault), { className: "mend" });
  return make("li", { className: kind, "data-line": fault.line, "data-column": fault.column }, go, mend);
}
