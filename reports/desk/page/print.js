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
    const page = new DOMParser().parseFromString(text, "text/html");
    for (const bad of page.querySelectorAll("script, #live")) bad.remove();
    const styles = [...page.querySelectorAll("style")].map((style) => make("style", { nonce, media: "print", textContent: style.textContent }));
    place.replaceChildren(...styles, ...[...page.body.childNodes].map((node) => document.importNode(node, true)));
    // The policy drops style attributes that come as text; set through the element they are none.
    for (const one of /** @type {NodeListOf<HTMLElement>} */ (place.querySelectorAll("[style]"))) one.style.cssText = one.getAttribute("style") ?? "";
    place.lang = page.documentElement.lang;
    document.title = page.title || title;
    document.documentElement.classList.add("desk-printing");
  });
  addEventListener("afterprint", () => {
    place.replaceChildren();
    document.title = title;
    document.documentElement.classList.remove("desk-printing");
  });
}
