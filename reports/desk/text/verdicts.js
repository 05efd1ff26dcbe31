// Beside each equation of the text: what the geometry says of it, right or which term differs.  Data moved by a joint are marked, too.

import { Decoration, EditorView, RangeSet, StateEffect, StateField, WidgetType } from "../editor/codemirror.js";
import { say } from "../words.js";

/** @import { ChangeDesc, Text } from "@codemirror/state" */
/** @import { Verdict } from "../types" */

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

const told = StateEffect.define(), marked = StateEffect.define();
const MOVED = Decoration.mark({ class: "desk-moved" });

/** @param {(value: RangeSet<Decoration>, effect: any) => RangeSet<Decoration> | null} taken */
const field = (taken) =>
  StateField.define({
    /** @returns {RangeSet<Decoration>} */
    create: () => Decoration.none,
    update(value, { changes, effects }) {
      let now = value.map(changes);
      for (const effect of effects) now = taken(now, effect) ?? now;
      return now;
    },
    provide: (one) => EditorView.decorations.from(one),
  });

export const verdicts = [
  field((_, effect) => (effect.is(told) ? effect.value : null)),
  field((_, effect) => (effect.is(marked) ? effect.value : null)),
];

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
 * Mark what the desk itself has changed in the text.
 * @param {EditorView} view
 * @param {{from: number, to: number}[]} ranges
 */
export function markMoved(view, ranges) {
  const found = ranges.filter(({ from, to }) => from < to).map(({ from, to }) => MOVED.range(from, to));
  view.dispatch({ effects: marked.of(Decoration.set(found, true)) });
}
