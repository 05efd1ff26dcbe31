// Beside each equation of the text: what the geometry says of it, right or which term differs.  Data moved by a joint are marked, too.

import { Decoration, EditorView, RangeSet, StateEffect, StateField, WidgetType } from "../editor/codemirror.js";
import { say } from "../words.js";
import { changes } from "./places.js";

/** @import { ChangeDesc, Text } from "@codemirror/state" */
/** @import { Edit, Verdict } from "../types" */

class Beside extends WidgetType {
  /**
   * @param {boolean} right
   * @param {string} sentence
   */
  constructor(right, sentence) {
    super();
    this.right = right;
    this.sentence = sentence;
  }
  /** @param {Beside} other */
  eq(other) {
    return other.right === this.right && other.sentence === this.sentence;
  }
  toDOM() {
    const place = document.createElement("span");
    place.className = `verdict ${this.right ? "right" : "wrong"}`;
    place.textContent = `${this.right ? "✓" : "✗"} ${this.sentence || say(this.right ? "equation_right" : "equation_wrong")}`;
    return place;
  }
}

/** @returns {import("@codemirror/state").StateEffectType<RangeSet<Decoration>>} */
const effect = () => StateEffect.define();
const told = effect(), marked = effect();
const MOVED = Decoration.mark({ class: "desk-moved" });

/** @param {import("@codemirror/state").StateEffectType<RangeSet<Decoration>>} kind */
const field = (kind) =>
  StateField.define({
    /** @returns {RangeSet<Decoration>} */
    create: () => Decoration.none,
    update(value, { changes: made, effects }) {
      let now = value.map(made);
      for (const one of effects) if (one.is(kind)) now = one.value;
      return now;
    },
    provide: (one) => EditorView.decorations.from(one),
  });

export const verdicts = [field(told), field(marked)];

/**
 * @param {EditorView} view
 * @param {Verdict[]} equations
 * @param {Text} doc The text that was asked about.
 * @param {ChangeDesc} since What was changed in it since.
 */
export function showVerdicts(view, equations, doc, since) {
  const known = equations.filter(({ line, right }) => right !== null && line >= 1 && line <= doc.lines);
  const beside = known.map(({ line, right, sentence }) =>
    Decoration.widget({ widget: new Beside(right === true, sentence), side: 1 }).range(since.mapPos(doc.line(line).to, 1)));
  view.dispatch({ effects: told.of(Decoration.set(beside, true)) });
}

/**
 * Let the desk itself change the text, and mark where it did.  What was typed since the edits were asked for wins: then nothing is done.
 * @param {EditorView} view
 * @param {Text} doc The text that was asked about.
 * @param {Edit[]} edits
 * @param {string} kind
 * @returns {number | null} Where the first change is.
 */
export function edited(view, doc, edits, kind) {
  if (!edits.length || !view.state.doc.eq(doc)) return null;
  const made = view.state.changes(changes(doc, edits));
  /** @type {import("@codemirror/state").Range<Decoration>[]} */
  const found = [];
  made.iterChanges((_a, _b, from, to) => from < to && found.push(MOVED.range(from, to)));
  view.dispatch({ changes: made, userEvent: kind, effects: marked.of(Decoration.set(found, true)) });
  return found[0]?.from ?? null;
}
