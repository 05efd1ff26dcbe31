// Texts in the store of this browser: on `serve` all work of a person is here and nowhere else.

import { isName } from "../names.js";
import { say } from "../words.js";
import { keep, kept, keptNames } from "./store.js";
import { unzipped, zipped } from "./zip.js";

/** @import { Kept, Works } from "../types" */

const WORK = "work.",
  DELETED = "deleted.",
  TABLE = "table.";
/** @param {string} name */
const refused = (name) => new Error(say("name_taken", { name }));

/** A version's name: two texts that differ have two. @param {string} text */
function version(text) {
  let sum = 0x811c9dc5;
  for (let i = 0; i < text.length; i++) sum = Math.imul(sum ^ text.charCodeAt(i), 0x01000193) >>> 0;
  return `"${text.length}-${sum.toString(16)}"`;
}

/**
 * @param {string} name
 * @returns {Kept | null}
 */
function read(name) {
  const text = kept(WORK + name);
  return typeof text === "string" ? { text, etag: version(text) } : null;
}

/**
 * @param {string} key
 * @param {string | null} text
 */
function put(key, text) {
  if (!keep(key, text)) throw new Error(say("keeps_nothing"));
}

/** @returns {Works} */
export const browserWorks = () => ({
  list: async () => [
    ...keptNames(WORK).map((name) => ({ name, etag: read(name)?.etag ?? "", deleted: false })),
    ...keptNames(DELETED).map((name) => ({ name, etag: "", deleted: true })),
  ],
  read: async (name) => read(name),
  async write(name, text, etag) {
    const there = read(name);
    if (there && there.etag !== etag && there.text !== text) return { theirs: there };
    put(WORK + name, text);
    return { etag: version(text) };
  },
  async rename(name, other) {
    if (read(other)) throw refused(other);
    put(WORK + other, read(name)?.text ?? "");
    put(WORK + name, null);
  },
  async duplicate(name, other) {
    if (read(other)) throw refused(other);
    put(WORK + other, read(name)?.text ?? "");
  },
  async remove(name) {
    put(DELETED + name, read(name)?.text ?? "");
    put(WORK + name, null);
  },
  async restore(name) {
    if (read(name)) throw refused(name);
    put(WORK + name, kept(DELETED + name) ?? "");
    put(DELETED + name, null);
  },
  async zip() {
    const files = Object.fromEntries(keptNames(WORK).map((name) => [`${name}.toml`, read(name)?.text ?? ""]));
    for (const name of keptNames(TABLE)) files[name] = kept(TABLE + name) ?? "";
    return zipped(files);
  },
  async unzip(file) {
    const written = [],
      skipped = [];
    for (const [path, text] of Object.entries(await unzipped(file))) {
      const name = path.replace(/^.*\//, ""),
        stem = /^(.*)\.toml$/u.exec(name)?.[1],
        work = stem && isName(stem) ? stem : null;
      const key = work ? WORK + work : /\.(?:csv|txt)$/i.test(name) ? TABLE + name : null,
        there = key && kept(key);
      if (!key) skipped.push({ name, sentence: say(stem === undefined ? "no_work" : "name_wrong") });
      else if (typeof there === "string" && there !== text)
        skipped.push({ name, sentence: say("name_taken", { name: work ?? name }) });
      else put(key, text), written.push(name);
    }
    return { written, skipped };
  },
  watch(changed) {
    addEventListener("storage", () => changed(keptNames(WORK).map((name) => ({ name, etag: read(name)?.etag ?? "" }))));
  },
  tables: () => Object.fromEntries(keptNames(TABLE).map((name) => [name, kept(TABLE + name) ?? ""])),
  keepTables(tables) {
    for (const [name, text] of Object.entries(tables)) put(TABLE + name, text);
  },
});
