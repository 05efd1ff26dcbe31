// What may stand where one types: sections, keys with their meaning, declared names and functions in formulas,
// units behind numbers.

import { autocompletion } from "../editor/codemirror.js";
import { get } from "../requests.js";
import { followWords, say } from "../words.js";
import { declaredIn, whereIn } from "./declared.js";

/** @import { Completion, CompletionContext, CompletionResult } from "@codemirror/autocomplete" */
/** @import { Key, Keys, Section } from "../types" */

const PROSE = new Set(["title", "source", "teaches", "because", "remarks", "means", "name"]);
const POINTS = new Set(["points", "hinges", "from", "meets", "through", "driven", "wheel", "contact", "slides", "of"]);

/** @param {(language: string) => string} path Path of the keys; asked again when the language changes. */
export function completing(path) {
  /** @type {Promise<Keys> | null} */
  let asked = null;
  const keys = () =>
    (asked ??= get(path("")).catch(
      () => ((asked = null), { sections: [], functions: [], units: [], quantities: [], schemes: [], kinds: [] }),
    ));
  followWords(() => (asked = null));

  /**
   * @param {CompletionContext} context
   * @returns {Promise<CompletionResult | null>}
   */
  async function source(context) {
    // A slider or a joint changes the text too, and nobody types.
    if (!context.explicit && !context.view?.hasFocus) return null;
    const whole = context.state.doc.toString();
    const { section, key, inside, before } = whereIn(whole.slice(0, context.pos));
    if (before.replace(/"[^"]*"/g, "").includes("#")) return null;
    const known = await keys();
    const head = /^\s*(\[{1,2})([\w.]*)$/.exec(before);
    if (head) return sections(known, context, head[1] ?? "[", head[2] ?? "");
    const word = /[\p{L}\p{N}_]*$/u.exec(before)?.[0] ?? "",
      from = context.pos - word.length;
    if (!inside) {
      if (!/^\s*[\w]*$/.test(before) && !/[{,]\s*\w*$/.test(before)) return null;
      if (!word && !context.explicit) return null;
      return keysOf(known, section, from, before.includes("{"));
    }
    if (PROSE.has(key)) return null;
    const unit = /(?:^|[^\p{L}\p{N}_])\d[\d.]*\s*([\p{L}/^\d]*)$/u.exec(before.slice(before.lastIndexOf('"') + 1));
    if (unit && /\d\s+[\p{L}/]*$/u.test(before)) return units(known, context.pos - (unit[1]?.length ?? 0));
    if (!word && !context.explicit) return null;
    return { from, options: inFormula(known, whole, section, key), validFor: /^[\p{L}\p{N}_]*$/u };
  }
  return autocompletion({ override: [source], icons: false, activateOnTypingDelay: 150 });
}

/** @param {Section} one Whether it is a table, not a key at the top of the text. */
const isTable = (one) => one.many || one.named || one.keys.length > 0;
/** @param {Key} key A name with what it means beside it and, where that is long, below. */
const told = ({ name, means }) => ({
  label: name,
  detail: means.length > 48 ? `${means.slice(0, 47)}…` : means,
  info: means.length > 48 ? means : "",
});

/**
 * @param {Keys} known
 * @param {CompletionContext} context
 * @param {string} open
 * @param {string} typed
 * @returns {CompletionResult}
 */
function sections(known, context, open, typed) {
  const behind = /^\]*/.exec(context.state.sliceDoc(context.pos, context.pos + 2))?.[0].length ?? 0;
  const begun = new Set(context.state.doc.toString().match(/^\[\w+\]/gm));
  const options = known.sections
    .filter((one) => isTable(one) && (one.many || (open === "[" && !begun.has(`[${one.name}]`))))
    .map((one, at) => {
      const label = one.many ? `[[${one.name}]]` : `[${one.name}]`;
      // In the order of a file; what remarks quote is thought of last.
      return { ...told(one), label, boost: one.name === "quote" ? -99 : -at };
    });
  const from = context.pos - typed.length - open.length;
  return { from, to: context.pos + behind, options, validFor: /^\[{1,2}[\w.]*$/ };
}

/**
 * @param {Keys} known
 * @param {string} section
 * @param {number} from
 * @param {boolean} within Whether between braces: where the author chooses the names, a whole line is shown outside of them.
 * @returns {CompletionResult}
 */
function keysOf(known, section, from, within) {
  const own = known.sections.find((one) => one.name === section);
  if (own?.lines.length && !within) return { from, options: own.lines.map((label) => ({ label })) };
  const keys = section ? own?.keys : known.sections.filter((one) => !isTable(one));
  return { from, options: (keys ?? []).map((key) => ({ ...told(key), apply: `${key.name} = ` })), validFor: /^\w*$/ };
}

/**
 * @param {Keys} known
 * @param {number} from
 * @returns {CompletionResult}
 */
const units = (known, from) => ({
  from,
  // The plain ones first.
  options: known.units.map((label) => ({ label, type: "unit", boost: -label.length })),
  validFor: /^[\p{L}/^\d]*$/u,
});

/**
 * @param {Keys} known
 * @param {string} text
 * @param {string} section
 * @param {string} key
 * @returns {Completion[]}
 */
function inFormula(known, text, section, key) {
  const listed = section === "ask" ? known.quantities : key === "scheme" ? known.schemes : key === "kind" ? known.kinds : null;
  if (listed) return listed.map(told);
  const { names, points } = declaredIn(text);
  const declared = [...names].map(([label, kind]) => ({ label, detail: say(`declared_${kind}`), boost: 2 }));
  const pointed = [...points].map((label) => ({
    label,
    detail: say("declared_point"),
    boost: POINTS.has(key) || section === "points" ? 3 : -1,
  }));
  return [
    ...declared,
    ...pointed,
    ...known.functions.map((label) => ({ label, detail: say("declared_function"), apply: `${label}(` })),
  ];
}
