// Printing: the sandboxed frame may not print, so the shell stands a copy of the report in for itself, on paper only.

import { make } from "../elements.js";

/**
 * @param {HTMLElement} place
 * @param {string} nonce
 * @param {() => string | null} html
 */
export function printed(place, nonce, html) {
  const title = document.title;
  addEventListener("beforeprint", () => {
    const text = html();
    if (!text) return;
    // The policy drops styles that come as text: sheets get the nonce, attributes are set through their element.
    /** @type {HTMLElement[]} */
    const sheets = [];
    const bare = text.replaceAll(/ style="/g, ' data-style="').replaceAll(/<style>([\s\S]*?)<\/style>/g, (_, sheet) => {
      sheets.push(make("style", { nonce, media: "print", textContent: sheet }));
      return "";
    });
    const page = new DOMParser().parseFromString(bare, "text/html");
    for (const bad of page.querySelectorAll("script, #live")) bad.remove();
    place.replaceChildren(...sheets, ...[...page.body.childNodes].map((node) => document.importNode(node, true)));
    for (const one of /** @type {NodeListOf<HTMLElement>} */ (place.querySelectorAll("[data-style]")))
      one.style.cssText = one.dataset.style ?? "";
    place.lang = page.documentElement.lang;
    document.title = page.title || title;
  });
  addEventListener("afterprint", () => {
    place.replaceChildren();
    document.title = title;
  });
}
