// How a variant file is coloured: sections, keys, numbers with units, formulas inside their quotes, remarks.

import { StreamLanguage } from "../editor/codemirror.js";

// What stands behind these keys is read by people; behind all others it is a formula, a number with a unit or a name.
const PROSE = new Set(["title", "source", "teaches", "because", "remarks", "means", "name", "text"]);
const FUNCTION = /^(?:sin|cos|tan|tg|ctg|asin|acos|atan|atan2|arcsin|arccos|arctg|sqrt|exp|log|abs)(?=\s*\()/;

/** @typedef {{quote: string, key: string, value: boolean, prose: boolean}} Reading `prose`: texts in another language. */
/** @typedef {import("@codemirror/language").StringStream} Stream */

/**
 * A piece of a text in quotes.
 * @param {Stream} stream
 * @param {Reading} reading
 */
function quoted(stream, reading) {
  if (stream.match(reading.quote)) {
    reading.quote = "";
    return "punctuation";
  }
  if (reading.prose || PROSE.has(reading.key)) {
    while (!stream.eol() && !stream.match(reading.quote, false)) if (stream.next() === "\\") stream.next();
    return "string";
  }
  if (stream.eatSpace()) return null;
  // A number with its unit, alone between the quotes.
  if (stream.match(/^[\d.]+(?:[eE][-+]?\d+)?\s*[\p{L}°µ][\p{L}°µ\d/^·²]*(?=\s*["'])|^[\d.]+\s+1\/[\p{L}]+(?=\s*["'])/u))
    return "number";
  if (stream.match(/^\d+(?:[.,]\d*)?(?:[eE][-+]?\d+)?|^\.\d+/)) return "number";
  if (stream.match(FUNCTION)) return "keyword";
  if (stream.match(/^[\p{L}_][\p{L}\p{N}_.]*/u)) return "variableName";
  stream.next();
  return "operator";
}

const parser = {
  name: "variant",
  /** @returns {Reading} */
  startState: () => ({ quote: "", key: "", value: false, prose: false }),
  /**
   * @param {Stream} stream
   * @param {Reading} reading
   */
  token(stream, reading) {
    if (stream.sol() && reading.quote.length < 3) Object.assign(reading, { quote: "", value: false });
    if (reading.quote) return quoted(stream, reading);
    if (stream.eatSpace()) return null;
    if (stream.match(/^#.*/)) return "comment";
    if (stream.sol() && stream.match(/^\[\[?[^\]#]*\]?\]?/)) {
      reading.prose = /^\[+text\b/.test(stream.current());
      return "heading";
    }
    for (const quote of ['"""', "'''", '"', "'"]) {
      if (!stream.match(quote)) continue;
      if (!reading.value) {
        stream.match(new RegExp(`^[^${quote[0]}]*${quote[0]}?`));
        return "propertyName";
      }
      reading.quote = quote;
      return "punctuation";
    }
    const word = /** @type {RegExpMatchArray | null} */ (stream.match(/^[\p{L}\p{N}_.+-]+/u));
    if (word && stream.match(/^\s*=/, false)) {
      reading.key = word[0];
      reading.value = true;
      return "propertyName";
    }
    if (word) return /^[-+.\d]/.test(word[0]) ? "number" : "atom";
    if (stream.eat("=")) reading.value = true;
    else stream.next();
    return "punctuation";
  },
  languageData: { commentTokens: { line: "#" } },
};

export const variantLanguage = StreamLanguage.define(parser);
