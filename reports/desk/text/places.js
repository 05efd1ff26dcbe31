// Places in a text: line and column of the server (from 1) and offsets of the editor, and the smallest change to another text.

/** @import { Text } from "@codemirror/state" */

/**
 * The offset of line and column; what lies outside is moved inside.
 * @param {Text} doc
 * @param {number | null} line
 * @param {number | null} column In letters (code points) from 1; null or 0 for the start of the line.
 */
export function offset(doc, line, column) {
  const at = doc.line(Math.min(Math.max(line ?? 1, 1), doc.lines));
  if (!column) return at.from;
  // Python counts code points, the editor UTF-16 units.
  const before = Array.from(at.text)
    .slice(0, column - 1)
    .join("");
  return at.from + Math.min(before.length, at.length);
}

/**
 * The letters that a fault at a place is about: the word, the sign or what is in quotes there, else what stands on the line.
 * @param {Text} doc
 * @param {number | null} line
 * @param {number | null} column
 */
export function extent(doc, line, column) {
  const at = doc.line(Math.min(Math.max(line ?? 1, 1), doc.lines));
  if (!column) {
    const lead = /^\s*/.exec(at.text)?.[0].length ?? 0;
    return { from: at.from + Math.min(lead, at.text.trimEnd().length), to: at.from + at.text.trimEnd().length };
  }
  const from = offset(doc, line, column);
  const word = /^(?:"[^"]*"|'[^']*'|[\p{L}\p{N}_]+|\S)/u.exec(at.text.slice(from - at.from))?.[0] ?? "";
  return word ? { from, to: from + word.length } : { from: Math.max(at.from, from - 1), to: from };
}

/**
 * The one change that makes one text another: what both begin and end with stays.
 * @param {string} before
 * @param {string} after
 */
export function change(before, after) {
  if (before === after) return null;
  const least = Math.min(before.length, after.length);
  let from = 0,
    behind = 0;
  while (from < least && before[from] === after[from]) from++;
  while (behind < least - from && before[before.length - 1 - behind] === after[after.length - 1 - behind]) behind++;
  return { from, to: before.length - behind, insert: after.slice(from, after.length - behind) };
}

/**
 * The changes that make one text another: line by line where both have as many, so that what stands between stays what it is.
 * @param {string} before
 * @param {string} after
 */
export function changes(before, after) {
  const old = before.split("\n"),
    lines = after.split("\n");
  if (old.length !== lines.length) return [change(before, after)].filter((one) => one !== null);
  let start = 0;
  return old.flatMap((line, k) => {
    const found = change(line, lines[k] ?? ""),
      at = start;
    start += line.length + 1;
    return found ? [{ from: at + found.from, to: at + found.to, insert: found.insert }] : [];
  });
}

/**
 * A value with so many decimals, as it stands in a text: the decimals of the file, a power of ten only where it had one.
 * @param {number} value
 * @param {number} decimals
 */
export function written(value, decimals) {
  return value.toFixed(Math.min(Math.max(decimals, 0), 12)).replace(/^-(?=0(\.0*)?$)/, "");
}
