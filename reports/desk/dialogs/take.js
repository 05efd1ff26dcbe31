// Give me: the page, the paper, the table, the text, in every format there is; all my work as one zip, and that opened again.

import { button, download, make } from "../elements.js";
import { faultless, request, whyNot } from "../requests.js";
import { say } from "../words.js";
import { unzipped, zipped } from "../work/zip.js";
import { openDialog } from "./dialog.js";

/** @import { Desk } from "../commands.js" */

/**
 * @param {HTMLElement} host
 * @param {Desk} desk
 */
export function openTake(host, { config, works, view, given, saving }) {
  const told = make("output", { className: "told" });
  const name = () => saving.name || say("unnamed");
  /**
   * @param {string} text
   * @param {string} key
   * @param {() => Promise<void>} act
   */
  const giving = (text, key, act) =>
    button(
      text,
      async () => {
        told.textContent = say("waiting");
        try {
          await act();
          told.textContent = "";
        } catch (error) {
          told.textContent = whyNot(error);
        }
      },
      { "data-format": key },
    );

  /** @param {string} format */
  async function take(format) {
    const json = { ...given(), text: view.state.doc.toString() };
    const response = await request("POST", `/api/take/${format}`, { json });
    const named = /filename\*=UTF-8''(.+)/.exec(response.headers.get("Content-Disposition") ?? "")?.[1];
    if (named) download(await response.blob(), decodeURIComponent(named));
    else faultless(await response.json());
  }
  /** All work as it is now: what is not saved yet stands in the place of what was saved. */
  async function everything() {
    const files = await unzipped(await works.zip());
    for (const [title, text] of Object.entries(saving.drafts())) files[`${title || say("unnamed")}.toml`] = text;
    return zipped(files);
  }
  const file = make("input", {
    type: "file",
    className: "unseen",
    accept: ".zip,.toml,.csv",
    id: "desk-open",
    onchange: async () => {
      const chosen = file.files?.[0];
      if (!chosen) return;
      told.textContent = "";
      try {
        // A text or a table alone comes the way of a zip.
        const packed = chosen.name.endsWith(".zip") ? chosen : zipped({ [chosen.name]: await chosen.text() });
        const { written, skipped } = await works.unzip(packed);
        const lines = [
          say("opened", { names: written.join(", ") || "–" }),
          ...skipped.map(({ name, sentence }) => (sentence.includes(name) ? sentence : `${name}: ${sentence}`)),
        ];
        told.replaceChildren(...lines.map((line) => make("p", {}, line)));
        // Who opens one text wants to see it.
        const only = written.length === 1 && !skipped.length && /^(.+)\.toml$/.exec(written[0] ?? "")?.[1];
        const there = only && (await works.read(only));
        if (!there) return;
        dialog.close();
        await saving.open(only, there.text, there.etag);
        view.focus();
      } catch (error) {
        told.textContent = error instanceof Error && error.message === "no zip" ? say("no_zip") : whyNot(error);
      }
    },
  });
  const { dialog } = openDialog(host, say("take_title", { name: name() }), [
    make(
      "p",
      { className: "row" },
      ...config.formats.map((format) => giving(say(`format_${format}`), format, () => take(format))),
      giving(say("format_toml"), "toml", async () =>
        download(new Blob([view.state.doc.toString()], { type: "application/toml" }), `${name()}.toml`),
      ),
      giving(say("format_print"), "print", async () => print()),
    ),
    make("h3", {}, say("all_work")),
    make(
      "p",
      { className: "row" },
      giving(say("zip"), "zip", async () => download(await everything(), "coursework.zip")),
      make("label", { className: "file" }, say("unzip"), file),
    ),
    told,
  ]);
}
