// One text under one name: what is saved of it, what only this browser keeps, what another program made of it meanwhile.

import { rewrite } from "../text/editor.js";
import { whyNot } from "../requests.js";
import { say } from "../words.js";
import { keep, kept, keptNames } from "./store.js";

/** @import { EditorView } from "@codemirror/view" */
/** @import { Kept, Works } from "../types" */

/**
 * @typedef {{
 *   works: Works, view: EditorView, state: ReturnType<typeof import("../state.js").stateIn>,
 *   notices: ReturnType<typeof import("../notices.js").noticesIn>, named: (name: string) => void, began: () => void, again: () => void,
 *   sure: () => Promise<boolean>,
 *   askName: (name: string) => Promise<string | null>,
 *   compare: (theirs: Kept, own: string) => Promise<"mine" | "theirs" | null>,
 * }} Parts
 */

const DRAFT = "draft.";

/** @param {Parts} parts */
export function savingIn({ works, view, state, notices, named, began, again, sure, askName, compare }) {
  let name = "",
    safe = true,
    asked = false,
    warned = false;
  /** @type {{text: string, etag: string | null}} */
  let base = { text: "", etag: null };
  /** @type {Kept | null} */
  let conflict = null;
  /** @type {Promise<unknown>} */
  let writing = Promise.resolve();

  const text = () => view.state.doc.toString();
  const draft = () => DRAFT + name;

  function tell() {
    const same = text() === base.text && base.etag !== null;
    state.set({ file: conflict ? "conflict" : same ? "saved" : "changed", fresh: base.etag === null });
  }

  /** What was typed is kept at once: a tab may be closed, a browser may die. */
  function changed() {
    const unsaved = text() !== base.text;
    safe = keep(draft(), unsaved ? { text: text(), etag: base.etag, at: Date.now() } : null);
    if (!safe && !warned) notices.show("keeps", say("keeps_nothing"));
    warned ||= !safe;
    tell();
  }

  /** @param {Kept} theirs */
  function collide(theirs) {
    conflict = theirs;
    tell();
    notices.drop("outside");
    notices.show("conflict", say("conflict", { name }), { [say("compare")]: () => void save() });
  }

  /** Let a person choose between two texts; what was chosen stands in the editor behind it. */
  async function settle() {
    const theirs = conflict,
      choice = theirs && (await compare(theirs, text()));
    if (!theirs) return;
    if (!choice) return collide(theirs);
    notices.drop("conflict");
    conflict = null;
    base = theirs;
    if (choice === "theirs") rewrite(view, theirs.text);
    changed();
  }

  async function write() {
    await settle();
    if (conflict || (text() === base.text && base.etag !== null)) return;
    const whole = text();
    try {
      let done = await works.write(name, whole, base.etag);
      // The file has gone meanwhile: it is written as a new one.
      if ("theirs" in done && !done.theirs) done = await works.write(name, whole, null);
      if ("theirs" in done && done.theirs && done.theirs.text !== whole) return collide(done.theirs);
      base = { text: whole, etag: "theirs" in done ? (done.theirs?.etag ?? null) : done.etag };
      notices.drop("refused");
      notices.drop("restored");
      changed();
    } catch (error) {
      notices.show("refused", say("not_saved", { why: whyNot(error) }));
      changed();
    }
  }

  async function save() {
    if (!name) {
      if (asked) return;
      asked = true;
      const chosen = await askName("");
      asked = false;
      if (!chosen) return;
      keep(draft(), null);
      name = chosen;
      named(name);
    }
    await (writing = writing.then(write));
  }

  /**
   * Begin with a text: `etag` null where nothing is saved under the name yet.
   * @param {string} other
   * @param {string} content
   * @param {string | null} etag
   */
  function begin(other, content, etag) {
    name = other;
    base = { text: content, etag };
    conflict = null;
    for (const key of ["conflict", "restored", "refused", "outside"]) notices.drop(key);
    named(name);
    began();
    const unsaved = kept(draft());
    const restored = typeof unsaved?.text === "string" && unsaved.text !== content ? unsaved : null;
    if (!rewrite(view, restored ? restored.text : content, { undo: false })) again();
    if (restored && etag !== null && restored.etag !== etag) collide({ text: content, etag });
    else if (restored) {
      const time = new Date(restored.at).toLocaleTimeString([], { hour: "2-digit", minute: "2-digit" });
      notices.show("restored", say("restored", { time }), { [say("drop_restored")]: () => rewrite(view, content) });
    }
    tell();
  }

  const lost = () => !safe && text() !== base.text;
  /**
   * Begin with another text; where the browser keeps nothing a person is asked before what was typed goes.
   * @type {(...text: Parameters<typeof begin>) => Promise<void>}
   */
  const open = async (...given) => {
    if (!lost() || (await sure())) begin(...given);
  };
  addEventListener("beforeunload", (event) => lost() && event.preventDefault());

  /** @param {{name: string, etag: string}[]} entries */
  async function outside(entries) {
    await writing;
    const mine = entries.find((entry) => entry.name === name);
    if (!name || base.etag === null || mine?.etag === base.etag) return;
    const theirs = mine ? await works.read(name) : null;
    if (!theirs) {
      base = { text: base.text, etag: null };
      return tell();
    }
    if (theirs.etag === base.etag) return;
    const unsaved = text() !== base.text;
    if (unsaved && theirs.text !== text()) return collide(theirs);
    base = theirs;
    conflict = null;
    if (rewrite(view, theirs.text)) notices.show("outside", say("outside", { name }));
    changed();
  }
  works.watch((entries) => void outside(entries));

  return {
    save,
    begin,
    open,
    changed,
    /** What is not saved yet by its name, the text that is open too. */
    drafts() {
      /** @type {Record<string, string>} */
      const found = {};
      for (const one of keptNames(DRAFT)) found[one] = kept(DRAFT + one).text;
      if (base.etag === null && text()) found[name] = text();
      return found;
    },
    get name() {
      return name;
    },
    get unsaved() {
      return text() !== base.text;
    },
  };
}
