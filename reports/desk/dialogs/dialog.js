// Dialogs: made when they are opened, closed by Escape, by their cross and by a click beside them.

import { button, cross, make } from "../elements.js";
import { isName } from "../names.js";
import { say } from "../words.js";

/**
 * @param {HTMLElement} host
 * @param {string} title
 * @param {(Node | string)[]} inside
 * @param {{wide?: boolean}} [look]
 */
export function openDialog(host, title, inside, { wide = false } = {}) {
  const head = make("h2", { id: "desk-dialog-title" }, title);
  const body = make("div", { className: "body" }, ...inside);
  const dialog = make(
    "dialog",
    { "aria-labelledby": "desk-dialog-title", className: wide ? "wide" : "" },
    make(
      "div",
      { className: "head" },
      head,
      cross(() => dialog.close()),
    ),
    body,
  );
  dialog.addEventListener("click", (event) => event.target === dialog && dialog.close());
  dialog.addEventListener("close", () => dialog.remove());
  host.append(dialog);
  dialog.showModal();
  return { dialog, body };
}

/**
 * Ask for one line of text, checked as it is typed; null where the person thinks better of it.
 * @param {{title: string, label: string, value: string, verb: string, refuses: (text: string) => string}} asked
 * @returns {Promise<string | null>}
 */
export function askLine({ title, label, value, verb, refuses }) {
  return new Promise((answer) => {
    /** @type {string | null} */
    let given = null;
    const field = make("input", {
      type: "text",
      value,
      maxLength: 60,
      autocomplete: "off",
      spellcheck: false,
      id: "desk-line",
      "aria-describedby": "desk-line-why",
    });
    const why = make("output", { id: "desk-line-why" });
    const form = make(
      "form",
      { className: "line" },
      make("label", { for: "desk-line" }, label),
      field,
      make("button", { className: "main" }, verb),
      why,
    );
    form.addEventListener("submit", (event) => {
      event.preventDefault();
      const text = field.value.trim();
      why.textContent = refuses(text);
      if (why.textContent) return field.focus();
      given = text;
      dialog.close();
    });
    const { dialog } = openDialog(document.body, title, [form]);
    dialog.addEventListener("close", () => answer(given));
    field.select();
  });
}

/**
 * Ask before what cannot be undone.
 * @param {string} title
 * @param {string} sentence
 * @param {string} verb
 * @returns {Promise<boolean>}
 */
export function confirmed(title, sentence, verb) {
  return new Promise((answer) => {
    let given = false;
    const sure = button(verb, () => ((given = true), dialog.close()), { className: "main" });
    const { dialog } = openDialog(document.body, title, [make("p", {}, sentence), make("p", { className: "row" }, sure)]);
    dialog.addEventListener("close", () => answer(given));
  });
}

/** @param {string} name */
export const refusedName = (name) => (isName(name) ? "" : say("name_wrong"));
