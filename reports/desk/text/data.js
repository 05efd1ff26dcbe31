// Every datum and every start value with a slider and a field; both rewrite that one value in the text.

import { RangeSet, RangeValue, StateEffect, StateField } from "../editor/codemirror.js";
import { make } from "../elements.js";
import { say } from "../words.js";
import { moving, takeHold } from "./editor.js";
import { offset, written } from "./places.js";

/** @import { ChangeDesc, Text } from "@codemirror/state" */
/** @import { EditorView } from "@codemirror/view" */
/** @import { Datum, DatumRow } from "../types" */

/** The value of a datum as it stands in the text: its place moves with what is typed before it. */
class Place extends RangeValue {
  /** @param {string} name */
  constructor(name) {
    super();
    this.name = name;
  }
}
Place.prototype.startSide = -1;
Place.prototype.endSide = 1;

const placed = /** @type {import("@codemirror/state").StateEffectType<RangeSet<Place>>} */ (StateEffect.define());
export const places = StateField.define({
  /** @returns {RangeSet<Place>} */
  create: () => RangeSet.empty,
  update(value, { changes, effects }) {
    const told = effects.find((effect) => effect.is(placed));
    return told ? told.value : value.map(changes);
  },
});

/**
 * @param {EditorView} view
 * @param {string} name
 */
function placeOf(view, name) {
  for (const at = view.state.field(places).iter(); at.value; at.next())
    if (at.value.name === name) return { from: at.from, to: at.to };
  return null;
}

/**
 * The controls of all data in a place of the page.
 * @param {HTMLElement} box
 * @param {EditorView} view
 */
export function dataIn(box, view) {
  /** @type {Map<string, DatumRow>} */
  const rows = new Map();
  let held = "";
  /** What stood in the text when it was read last, or was written from here.
   * @type {Map<string, string>} */
  const told = new Map();

  /** @param {string} name */
  const textOf = (name) => {
    const place = placeOf(view, name);
    return place && view.state.sliceDoc(place.from, place.to);
  };
  /** Whether a person has typed over a value since: it is theirs until the text is read again.
   * @param {string} name */
  const isTypedOver = (name) => told.has(name) && textOf(name) !== told.get(name);
  function mind() {
    for (const [name, { slider, field }] of rows) slider.disabled = field.disabled = isTypedOver(name);
  }

  /**
   * @param {string} name
   * @param {string} text Number and unit as they shall stand in the text.
   */
  function put(name, text) {
    const place = placeOf(view, name);
    if (!place || textOf(name) === text || isTypedOver(name)) return;
    told.set(name, text);
    view.dispatch({ changes: { ...place, insert: text }, userEvent: moving() });
  }

  /** @param {Datum} datum */
  function row(datum) {
    const { name } = datum,
      id = `desk-datum-${name}`;
    const slider = make("input", { type: "range", "aria-label": name, tabIndex: 0 });
    const field = make("input", { type: "text", id, inputMode: "decimal", autocomplete: "off", spellcheck: false });
    const unit = make("span", { className: "unit" });
    const whole = make("div", { className: "datum", "data-datum": name }, make("label", { for: id }), slider, field, unit);
    const of = () => rows.get(name)?.datum ?? datum;
    slider.addEventListener("pointerdown", () => {
      held = name;
      takeHold();
    });
    slider.addEventListener("keydown", ({ repeat }) => repeat || takeHold());
    for (const end of ["pointerup", "pointercancel", "change"]) slider.addEventListener(end, () => (held = ""));
    slider.addEventListener("input", () => {
      const text = written(Number(slider.value), decimals(of()));
      field.value = text;
      slider.setAttribute("aria-valuetext", `${text} ${of().unit}`);
      put(name, `${text} ${of().unit}`.trim());
    });
    field.addEventListener("change", () => {
      const text = field.value.replace(/["\\]/g, "").trim().replace(",", ".").replace("−", "-");
      takeHold();
      const number = /^[-+]?(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?$/i.test(text);
      put(name, number ? `${text} ${of().unit}`.trim() : text);
    });
    field.addEventListener("keydown", (event) => event.key === "Escape" && (field.value = written(of().value, of().digits)));
    return { row: whole, slider, field, unit, datum };
  }

  /** @param {Datum} datum */
  const decimals = ({ digits, step }) => Math.max(digits, Math.ceil(-Math.log10(step || 1) - 1e-9), 0);

  /**
   * @param {Datum} datum
   * @param {boolean} current Whether the text is still the one that was asked about: else what a hand has moved since stays.
   */
  function fill(datum, current) {
    const { slider, field, unit, row } = /** @type {NonNullable<ReturnType<typeof rows.get>>} */ (rows.get(datum.name));
    Object.assign(/** @type {object} */ (rows.get(datum.name)), { datum });
    const label = /** @type {HTMLElement} */ (row.firstElementChild);
    // "x_D": no capital letter stands lower by itself.
    const [letter = "", low] = (datum.symbol || datum.name).split(/_(.*)/);
    label.replaceChildren(letter, ...(low ? [make("sub", {}, low)] : []));
    label.title = row.title = datum.title;
    slider.setAttribute("aria-label", say("slider", { name: datum.symbol || datum.name }));
    unit.textContent = datum.unit;
    if (held === datum.name || !current) return;
    const value = String(datum.value);
    Object.assign(slider, { min: String(datum.low), max: String(datum.high), step: String(datum.step) });
    if (slider.value !== value) slider.value = value;
    slider.setAttribute("aria-valuetext", `${value} ${datum.unit}`);
    if (document.activeElement !== field) field.value = /^[-+]?[\d.]+(?:e[-+]?\d+)?/i.exec(datum.text)?.[0] ?? value;
  }

  return {
    mind,
    /**
     * @param {Datum[]} data
     * @param {Text} doc The text that was asked about.
     * @param {ChangeDesc} since What was changed in it since.
     */
    show(data, doc, since) {
      const read = new Map();
      const found = data.flatMap(({ name, place }) => {
        if (!place) return [];
        const [begin, end] = [offset(doc, place.line, place.column), offset(doc, place.end_line, place.end_column)];
        const from = since.mapPos(begin, 1),
          to = since.mapPos(end, -1);
        read.set(name, doc.sliceString(begin, end));
        return from < to ? [new Place(name).range(from, to)] : [];
      });
      view.dispatch({ effects: placed.of(RangeSet.of(found, true)) });
      // What a hand has moved since is its own still.
      for (const name of read.keys()) if (told.has(name) && !isTypedOver(name)) read.delete(name);
      for (const name of told.keys()) if (!data.some((one) => one.name === name && one.place)) told.delete(name);
      for (const [name, text] of read) told.set(name, text);
      const names = new Set(data.map((datum) => datum.name));
      for (const [name, { row }] of rows) if (!names.has(name)) row.remove(), rows.delete(name);
      for (const kind of ["given", "start"]) {
        const group = /** @type {HTMLElement} */ (box.querySelector(`[data-kind=${kind}]`));
        const own = data.filter((datum) => datum.kind === kind);
        own.forEach((datum, k) => {
          if (!rows.has(datum.name)) rows.set(datum.name, row(datum));
          const { row: element } = /** @type {{row: HTMLElement}} */ (rows.get(datum.name));
          if (group.children[k + 1] !== element) group.insertBefore(element, group.children[k + 1] ?? null);
          fill(datum, since.empty);
        });
        group.hidden = !own.length;
      }
      mind();
    },
  };
}
