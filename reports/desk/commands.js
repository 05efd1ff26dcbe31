// What the buttons of the bar do, and the keys that lead from one part of the desk to the next.

import { openFiles } from "./dialogs/files.js";
import { confirmed } from "./dialogs/dialog.js";
import { openNew } from "./dialogs/new.js";
import { openTable } from "./dialogs/table.js";
import { openTake } from "./dialogs/take.js";
import { found } from "./elements.js";
import { post, whyNot } from "./requests.js";
import { written } from "./text/verdicts.js";
import { say } from "./words.js";
import { forgetAll } from "./work/store.js";

/** @import { EditorView } from "@codemirror/view" */
/** @import { Config, Works } from "./types" */
/**
 * @typedef {{
 *   config: Config, works: Works, view: EditorView, given: () => object,
 *   settings: ReturnType<typeof import("./settings.js").settingsIn>,
 *   saving: ReturnType<typeof import("./work/saving.js").savingIn>,
 *   notices: ReturnType<typeof import("./notices.js").noticesIn>,
 * }} Desk
 */

/** @param {Desk} desk */
export function commandsIn(desk) {
  const { view, saving, notices } = desk;

  /** @param {unknown} error */
  const refused = (error) => notices.show("refused", whyNot(error));
  /**
   * @param {string} id
   * @param {(host: HTMLElement) => unknown} act
   */
  function on(id, act) {
    const place = document.getElementById(id);
    if (!place) return;
    // The part that holds a dialog hands the focus on to its button.
    const button = place instanceof HTMLButtonElement ? place : place.querySelector("button");
    if (button !== place) place.addEventListener("focus", () => button?.focus());
    button?.addEventListener("click", () => void Promise.resolve(act(place)).catch(refused));
  }

  on("desk-more", (button) => button.setAttribute("aria-expanded", String(button.getAttribute("aria-expanded") !== "true")));
  on("desk-save", () => saving.save());
  on("desk-new", (host) => openNew(host, desk));
  on("desk-take", (host) => openTake(host, desk));
  on("desk-table", () => openTable(desk));
  on("desk-files", () => openFiles(desk));
  on("desk-equations", async () => {
    const { doc } = view.state;
    const made = await post("/api/equations", { ...desk.given(), text: doc.toString() });
    if (!made.text || !written(view, doc, made))
      return notices.show("refused", made.faults?.[0]?.sentence ?? say("equations_there"));
    view.focus();
  });
  on("desk-forget", async () => {
    const sentence = say(desk.config.mode === "serve" ? "forget_serve" : "forget_edit");
    if (!(await confirmed(say("forget"), sentence, say("forget")))) return;
    forgetAll();
    location.reload();
  });

  // F6 goes from part to part, as in any desktop program.
  const parts = [
    view.contentDOM,
    found("desk-faults", HTMLElement),
    found("desk-data", HTMLElement),
    found("desk-page", HTMLElement),
    found("desk-bar", HTMLElement),
  ];
  addEventListener("keydown", (event) => {
    if (event.key === "s" && (event.ctrlKey || event.metaKey) && !event.altKey) {
      event.preventDefault();
      void saving.save();
    }
    if (event.key !== "F6") return;
    event.preventDefault();
    const at = parts.findIndex((part) => part.contains(document.activeElement));
    for (let k = 1; k <= parts.length; k++) {
      const part = parts[(at + (event.shiftKey ? -k : k) + 2 * parts.length) % parts.length];
      const inside =
        part === view.contentDOM || part instanceof HTMLIFrameElement
          ? part
          : part?.querySelector(/** @type {"button"} */ ("button, summary, a, input"));
      if (!(inside instanceof HTMLElement) || !inside.checkVisibility({ visibilityProperty: true })) continue;
      inside.focus();
      return;
    }
  });
}
