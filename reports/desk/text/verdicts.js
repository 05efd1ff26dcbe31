// Beside each equation of the text: what the geometry says of it, right or which term differs.
// What a joint has moved is marked, too.

import { Decoration, EditorView, RangeSet, StateEffect, StateField, WidgetType } from "../editor/codemirror.js";
import { say } from "../words.js";
import { rewrite } from "./editor.js";
import { offset } from "./places.js";

/** @import { ChangeDesc, Text } from "@codemirror/state" */
/** @import { Span, Verdict } from "../types" */

class Beside extends WidgetType {
  /**
   * @param {boolean} right
   * @param {string} sentence
   * @param {boolean} asked Whether its line was edited since, so that the next answer is waited for.
   */
  constructor(right, sentence, asked = false) {
    super();
    this.right = right;
    this.sentence = sentence;
    this.asked = asked;
  }
  /** @param {Beside} other */
  eq(other) {
    return other.right === this.right && other.sentence === this.sentence && other.asked === this.asked;
  }
  toDOM() {
    const place = document.createElement("span");
    place.className = `verdict ${this.asked ? "asked" : this.right ? "right" : "wrong"}`;
    const words = this.sentence || say(this.right ? "equation_right" : "equation_wrong");
    place.textContent = `${this.right ? "✓" : "✗"} ${words}`;
    return place;
  }
}

/** @returns {import("@codemirror/state").StateEffectType<RangeSet<Decoration>>} */
const effect = () => StateEffect.define();
const told = effect(),
  marked = effect();
const MOVED = Decoration.mark({ class: "desk-moved" });

/**
 * What was said of a line that has changed since is no longer said of it: it is grey until the answer comes.
 * @param {RangeSet<Decoration>} beside
 * @param {ChangeDesc} changes
 * @param {Text} doc
 */
function greyed(beside, changes, doc) {
  /** @type {[number, number][]} */
  const lines = [];
  changes.iterChangedRanges((_from, _to, from, to) => lines.push([doc.lineAt(from).from, doc.lineAt(to).to]));
  /** @type {import("@codemirror/state").Range<Decoration>[]} */
  const add = [];
  const filter = (/** @type {number} */ at, /** @type {number} */ _to, /** @type {Decoration} */ { spec }) => {
    const { widget } = spec;
    if (!(widget instanceof Beside) || !lines.some(([from, to]) => from <= at && at <= to)) return true;
    add.push(Decoration.widget({ widget: new Beside(widget.right, widget.sentence, true), side: 1 }).range(at));
    return false;
  };
  return beside.update({ filter }).update({ add, sort: true });
}

/**
 * @param {import("@codemirror/state").StateEffectType<RangeSet<Decoration>>} kind
 * @param {boolean} passing Whether the next change of the text takes it away.
 */
const field = (kind, passing) =>
  StateField.define({
    /** @returns {RangeSet<Decoration>} */
    create: () => Decoration.none,
    update(value, { changes, effects, docChanged, newDoc }) {
      let now = passing && docChanged ? Decoration.none : value.map(changes);
      if (docChanged) now = greyed(now, changes, newDoc);
      for (const one of effects) if (one.is(kind)) now = one.value;
      return now;
    },
    provide: (one) => EditorView.decorations.from(one),
  });

export const verdicts = [field(told, false), field(marked, true)];

/**
 * @param {EditorView} view
 * @param {Verdict[]} equations
 * @param {Text} doc The text that was asked about.
 * @param {ChangeDesc} since What was changed in it since.
 */
export function showVerdicts(view, equations, doc, since) {
  const known = equations.filter(({ line, right }) => right !== null && line >= 1 && line <= doc.lines);
  const beside = known.map(({ line, right, sentence }) =>
    Decoration.widget({ widget: new Beside(right === true, sentence), side: 1 }).range(since.mapPos(doc.line(line).to, 1)),
  );
  view.dispatch({ effects: told.of(Decoration.set(beside, true)) });
}

/**
 * Let the desk itself change the text, and mark where it did.  What was typed since it was asked wins: then nothing is done.
 * @param {EditorView} view
 * @param {Text} doc The text that was asked about.
 * @param {{text: string, ranges: Span[]}} found
 * @param {string} kind
 * @returns {number | null} Where the first change is, null where there is none.
 */
export function edited(view, doc, { text, ranges }, kind) {
  if (!view.state.doc.eq(doc) || !rewrite(view, text, { kind })) return null;
  const now = view.state.doc;
  const places = ranges.map((one) => ({
    from: offset(now, one.line, one.column),
    to: offset(now, one.end_line, one.end_column),
  }));
  const moved = places.filter(({ from, to }) => from < to).map(({ from, to }) => MOVED.range(from, to));
  view.dispatch({ effects: marked.of(Decoration.set(moved, true)) });
  return places[0]?.from ?? 0;
}

/**
 * As `edited`, and go to where it stands.
 * @type {(view: EditorView, doc: Parameters<typeof edited>[1], made: Parameters<typeof edited>[2]) => boolean}
 */
export function written(view, doc, made) {
  const from = edited(view, doc, made, "input.desk");
  // Data and faults below may take some of the height at once.
  if (from !== null)
    view.dispatch({ selection: { anchor: from }, effects: EditorView.scrollIntoView(from, { y: "start", yMargin: 60 }) });
  return from !== null;
}
