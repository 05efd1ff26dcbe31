// New: the catalogue as pictures, searched by words, links and groups; or pieces that are put to what the text has already.

import { button, make, moving } from "../elements.js";
import { get, request } from "../requests.js";
import { say } from "../words.js";
import { askLine, openDialog, refusedName } from "./dialog.js";
import { hangPiece, pieceCard } from "./pieces.js";

/** @import { CatalogueEntry, Piece } from "../types" */
/** @import { Desk } from "../commands.js" */

/**
 * @param {HTMLElement} host
 * @param {Desk} desk
 */
export async function openNew(host, desk) {
  // Who has keys types at once what is looked for; on a phone they would cover the pictures.
  const autofocus = matchMedia("(hover: hover)").matches;
  const search = make("input", { type: "search", placeholder: say("search"), "aria-label": say("search"), autofocus });
  const cards = make("div", { className: "cards", role: "list" }, make("p", { role: "listitem" }, say("waiting")));
  const pieces = make("div", { className: "cards pieces" });
  const count = make("output", { className: "count" });
  const empty = button(say("new_empty"), () => start("", {}));
  const parts = make("h3", {}, say("pieces"));
  // They stand below some forty pictures.
  const down = button(say("pieces"), () => parts.scrollIntoView());
  const { dialog } = openDialog(
    host,
    say("new_title"),
    [make("p", { className: "row" }, search, count, empty, down), cards, parts, make("p", {}, say("pieces_how")), pieces],
    { wide: true },
  );

  /**
   * @param {string} text
   * @param {Record<string, string>} tables
   * @param {string} [name]
   */
  async function start(text, tables, name = "") {
    const taken = new Set((await desk.works.list()).filter((one) => !one.deleted).map((one) => one.name));
    for (const draft of Object.keys(desk.saving.drafts())) taken.add(draft);
    let free = name || say("new_name");
    for (let k = 2; taken.has(free); k++) free = `${name || say("new_name")}-${k}`;
    const chosen = await askLine({
      title: say("new"),
      label: say("name"),
      value: free,
      verb: say("start_from"),
      refuses: (other) => refusedName(other) || (taken.has(other) ? say("name_taken", { name: other }) : ""),
    });
    if (!chosen) return;
    dialog.close();
    desk.works.keepTables(tables);
    await desk.saving.open(chosen, text, null);
    desk.view.focus();
  }

  /** @param {CatalogueEntry} entry */
  async function choose({ name }) {
    const text = await (await request("GET", `/api/variant/${name}`)).text();
    await start(text, await get(`/api/variant/${name}/tables`), name);
  }

  /** @param {CatalogueEntry[]} entries */
  function fill(entries) {
    const made = entries.map((entry) => {
      const inside = [
        entry.svg ? moving(entry.svg, entry.title) : make("span", { className: "none" }),
        make("b", {}, entry.name),
        make("span", {}, entry.title),
        make("small", {}, [say("links", { n: entry.links }), ...new Set(entry.groups)].join(" · ")),
      ];
      const card = button(inside, () => choose(entry), { className: "card", "data-variant": entry.name });
      if (entry.teaches) card.title = entry.teaches;
      const searched = [entry.name, entry.title, entry.teaches, say("links", { n: entry.links }), ...entry.groups]
        .join(" ")
        .toLowerCase();
      return { item: make("div", { role: "listitem" }, card), searched };
    });
    cards.replaceChildren(...made.map(({ item }) => item));
    const look = () => {
      const words = search.value.toLowerCase().split(/\s+/).filter(Boolean);
      for (const { item, searched } of made) item.hidden = !words.every((word) => searched.includes(word));
      count.textContent = say("found", { n: made.filter(({ item }) => !item.hidden).length });
    };
    search.addEventListener("input", look);
    look();
  }
  const language = encodeURIComponent(desk.settings.language);
  // One after the other: a process stays free for what is typed meanwhile.
  fill(await get(`/api/catalogue?language=${language}`));
  /** @type {Piece[]} */
  const found = await get(`/api/pieces?language=${language}`);
  pieces.replaceChildren(...found.map((piece) => pieceCard(piece, () => (dialog.close(), hangPiece(piece, desk)))));
}
