// Try your own table: a file is dropped, and the page says what `precheck` says of it.  It goes nowhere else.

import { make } from "../elements.js";
import { faultless, post, whyNot } from "../requests.js";
import { say } from "../words.js";
import { openDialog } from "./dialog.js";

/** @import { Desk } from "../commands.js" */

/** @param {Blob} file @returns {Promise<string>} */
const base64 = (file) =>
  new Promise((answer, fail) => {
    const reader = new FileReader();
    reader.onload = () => answer(String(reader.result).replace(/^[^,]*,/, ""));
    reader.onerror = () => fail(reader.error);
    reader.readAsDataURL(file);
  });

/** @param {Desk} desk */
export function openTable({ view, given }) {
  const told = make("div", { className: "told", "aria-live": "polite" });
  const file = make("input", {
    type: "file",
    className: "unseen",
    id: "desk-own-table",
    onchange: () => file.files?.[0] && void look(file.files[0]),
  });
  const drop = make(
    "label",
    { className: "drop", for: file.id },
    make("b", {}, say("table_drop")),
    make("span", {}, say("table_kinds")),
    file,
  );
  for (const kind of ["dragover", "dragleave", "drop"]) {
    drop.addEventListener(kind, (event) => {
      event.preventDefault();
      drop.classList.toggle("over", kind === "dragover");
      const dropped = kind === "drop" && event instanceof DragEvent ? event.dataTransfer?.files[0] : null;
      if (dropped) void look(dropped);
    });
  }

  /** @param {File} chosen */
  async function look(chosen) {
    told.replaceChildren(say("waiting"));
    try {
      const json = { ...given(), text: view.state.doc.toString(), name: chosen.name, data: await base64(chosen) };
      const { state, sentences } = faultless(await post("/api/table", json));
      told.dataset.state = state;
      told.replaceChildren(
        make("h3", {}, chosen.name),
        make("ul", {}, ...sentences.map((/** @type {string} */ sentence) => make("li", {}, sentence))),
      );
    } catch (error) {
      told.replaceChildren(whyNot(error));
    }
  }
  openDialog(document.body, say("table_title"), [make("p", {}, say("table_how")), drop, told]);
}
