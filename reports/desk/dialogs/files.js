// Files: open, rename, duplicate, delete and bring back.

import { button, make } from "../elements.js";
import { whyNot } from "../requests.js";
import { keptNames } from "../work/store.js";
import { say } from "../words.js";
import { askLine, openDialog, refusedName } from "./dialog.js";

/** @import { Entry } from "../types" */
/** @import { Desk } from "../commands.js" */

/** @param {Desk} desk */
export async function openFiles({ works, saving, view }) {
  const told = make("output", { className: "told" });
  const list = make("ul", { className: "files" });
  const { dialog } = openDialog(document.body, say("files"), [list, told]);

  /** @param {() => Promise<unknown>} act */
  async function done(act) {
    told.textContent = "";
    try {
      await act();
    } catch (error) {
      told.textContent = whyNot(error);
    }
    await fill();
  }
  /** @param {string} name */
  async function open(name) {
    const there = await works.read(name);
    if (!there) return;
    dialog.close();
    await saving.open(name, there.text, there.etag);
    view.focus();
  }
  /**
   * @param {string} name
   * @param {string} verb
   * @param {string} value What is proposed.
   * @param {(other: string) => Promise<void>} act
   */
  async function otherName(name, verb, value, act) {
    /** @param {string} text */
    const refuses = (text) => refusedName(text) || (text === name ? say("name_taken", { name }) : "");
    const other = await askLine({ title: `${verb}: ${name}`, label: say("name"), value, verb, refuses });
    if (other) await done(() => act(other));
  }
  /** What is open is copied as it stands there, saved or not. @param {string} other */
  async function copy(other) {
    if ("theirs" in (await works.write(other, view.state.doc.toString(), null)))
      throw new Error(say("name_taken", { name: other }));
  }
  /** @type {Set<string>} */
  let known = new Set();
  /** The name with the first number behind it that no other has: crank-2. @param {string} name */
  function unused(name) {
    const stem = name.replace(/-\d+$/, "");
    let number = 2;
    while (known.has(`${stem}-${number}`)) number += 1;
    return `${stem}-${number}`;
  }
  async function fill() {
    const entries = await works.list();
    known = new Set(entries.map((one) => one.name));
    // What was typed under a name and never saved is in this browser alone.
    const drafts = keptNames("draft.").filter((name) => !known.has(name));
    list.replaceChildren(...entries.map(entry), ...drafts.map(draft));
    if (!list.children.length) list.replaceChildren(make("li", {}, say("no_files")));
  }
  /** @param {string} name */
  const draft = (name) =>
    make(
      "li",
      { "data-name": name },
      button(
        name || say("unnamed"),
        () => (dialog.close(), name !== saving.name && void saving.open(name, "", null), view.focus()),
        { className: "name" },
      ),
      make("span", {}, say("state_new")),
    );
  /** @param {Entry} entry */
  function entry({ name, etag, deleted }) {
    const mine = !deleted && name === saving.name;
    /**
     * @param {string} key
     * @param {() => unknown} act
     */
    const does = (key, act) => button(say(key), act, { "data-act": key, "aria-label": `${say(key)}: ${name}` });
    if (deleted)
      return make(
        "li",
        { className: "deleted", "data-name": name },
        make("span", {}, name),
        does("restore", () => done(() => works.restore(name))),
      );
    return make(
      "li",
      { "data-name": name, ...(mine && { "aria-current": "true" }) },
      button(name, () => open(name), { className: "name" }),
      does("rename", () =>
        otherName(name, say("rename"), name, async (other) => {
          if (mine && saving.unsaved) await saving.save();
          await works.rename(name, other);
          if (mine) await open(other);
        }),
      ),
      does("duplicate", () =>
        otherName(name, say("duplicate"), unused(name), (other) => (mine ? copy(other) : works.duplicate(name, other))),
      ),
      does("remove", () =>
        done(async () => {
          await works.remove(name, etag);
          if (mine) saving.begin(name, view.state.doc.toString(), null);
        }),
      ),
    );
  }
  await fill();
}
