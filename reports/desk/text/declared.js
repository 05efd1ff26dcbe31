// What a text declares so far, read line by line so that half-typed files are read too; and where in it a place lies.

/** @typedef {{section: string, key: string, inside: boolean, before: string}} Where */

const HEAD = /^\s*\[\[?\s*([^\]#]*?)\s*\]?\]?\s*(?:#.*)?$/;
const ENTRY = /^\s*("[^"]*"|[\p{L}\p{N}_.-]+)\s*=/u;

/** @param {string} text */
export function declaredIn(text) {
  /** @type {Map<string, string>} */
  const names = new Map();
  /** @type {Set<string>} */
  const points = new Set();
  let section = "";
  for (const line of text.split("\n")) {
    const head = HEAD.exec(line);
    if (head) section = head[1] ?? "";
    const key = !head && ENTRY.exec(line)?.[1]?.replaceAll('"', "");
    if (key && ["given", "drive", "coordinates", "unknowns", "functions"].includes(section)) names.set(key, section);
    if (key && section === "points") points.add(key);
    for (const [, rate] of line.matchAll(/\brate\s*=\s*"([^"]+)"/g)) if (rate && !names.has(rate)) names.set(rate, "rate");
    const meets = section === "group" && /^\s*meets\s*=\s*"([^"]+)"/.exec(line)?.[1];
    if (meets) points.add(meets);
    if (section === "group" && /^\s*coordinates\s*=/.test(line))
      for (const [, name] of line.matchAll(/"([^"]+)"/g)) if (name && !names.has(name)) names.set(name, "coordinates");
  }
  return { names, points };
}

/**
 * Where the end of a text lies: its section, the key behind which it stands, inside quotes or not.
 * @param {string} before
 * @returns {Where}
 */
export function whereIn(before) {
  const lines = before.split("\n"),
    last = lines.at(-1) ?? "";
  let section = "";
  for (const line of lines.slice(0, -1)) section = HEAD.exec(line)?.[1] ?? section;
  const unquoted = last.replace(/"[^"]*"/g, (text) => "_".repeat(text.length)),
    inside = (unquoted.match(/"/g)?.length ?? 0) % 2 === 1;
  const entries = [...unquoted.replace(/"[^"]*$/, "").matchAll(/([\p{L}\p{N}_.-]+)\s*=/gu)];
  return { section, key: entries.at(-1)?.[1] ?? "", inside, before: last };
}
