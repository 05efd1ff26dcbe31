// A mechanism from pieces: a crank, groups, each with a picture; what is chosen is hung on a point that the text has.

import { button, make, moving, picture } from "../elements.js";
import { post, whyNot } from "../requests.js";
import { declaredIn } from "../text/declared.js";
import { written } from "../text/verdicts.js";
import { say } from "../words.js";
import { openDialog } from "./dialog.js";

/** @import { Piece } from "../types" */
/** @import { Desk } from "../commands.js" */

/**
 * @param {Piece} piece
 * @param {() => void} chosen
 */
export const pieceCard = (piece, chosen) =>
  button([moving(piece.svg, piece.title), make("b", {}, piece.kind), make("span", {}, piece.title)], chosen, {
    className: "card",
    "data-piece": piece.kind,
  });

/**
 * Ask on which points a piece hangs, and append its lines.
 * @param {Piece} piece
 * @param {Desk} desk
 */
export function hangPiece(piece, desk) {
  const { doc } = desk.view.state,
    text = doc.toString(),
    points = [...declaredIn(text).points];
  // A text without points begins with the piece, and with the crank that moves it.
  const asks = points.length ? piece.asks : [];
  const fields = asks.map(({ key, means }) => {
    const select = make("select", { id: `desk-on-${key}` }, ...points.map((name) => make("option", {}, name)));
    return { label: make("label", { for: select.id }, means), select };
  });
  // What came last into the text is what one builds on.
  for (const [k, { select }] of fields.entries()) select.selectedIndex = Math.max(0, points.length - fields.length + k);
  const why = make("output", {});
  const form = make(
    "form",
    { className: "line" },
    ...fields.flatMap(({ label, select }) => [label, select]),
    make("button", { className: "main" }, say("add_piece")),
    why,
  );
  const { dialog } = openDialog(document.body, piece.title, [
    make("div", { className: "piece" }, picture(piece.svg, piece.title)),
    form,
  ]);
  form.addEventListener("submit", async (event) => {
    event.preventDefault();
    try {
      const found = await post("/api/piece", {
        ...desk.given(),
        text,
        kind: piece.kind,
        on: fields.map(({ select }) => select.value),
      });
      why.textContent = found.sentence ?? found.faults?.[0]?.sentence ?? "";
      if (why.textContent) return;
      dialog.close();
      written(desk.view, doc, found);
      desk.view.focus();
    } catch (error) {
      why.textContent = whyNot(error);
    }
  });
}
