// Elements made and found, with their types.

import { say } from "./words.js";

/**
 * @template {keyof HTMLElementTagNameMap} Tag
 * @param {Tag} tag
 * @param {Record<string, unknown>} [given] Properties; `data-…`, `aria-…` and `role` as attributes, `on…` as listeners.
 * @param {...(Node | string | null)} inside
 * @returns {HTMLElementTagNameMap[Tag]}
 */
export function make(tag, given = {}, ...inside) {
  const made = document.createElement(tag);
  for (const [key, value] of Object.entries(given)) {
    if (key.startsWith("on")) made.addEventListener(key.slice(2), /** @type {EventListener} */ (value));
    else if (key.includes("-") || key === "role" || key === "for" || key === "list") made.setAttribute(key, String(value));
    else Object.assign(made, { [key]: value });
  }
  made.append(...inside.filter((one) => one !== null));
  return made;
}

/**
 * A button that does something by itself: it sends no form.
 * @param {Node | string | (Node | string)[]} inside
 * @param {() => unknown} act
 * @param {Record<string, unknown>} [given]
 */
export const button = (inside, act, given = {}) =>
  make("button", { type: "button", onclick: () => void act(), ...given }, ...[inside].flat());

/** The cross at the end of what can be put away. @param {() => void} act */
export const cross = (act) => button("×", act, { className: "close", "aria-label": say("close") });

/**
 * @template {HTMLElement} Kind
 * @param {string} id
 * @param {new () => Kind} kind
 * @returns {Kind}
 */
export function found(id, kind) {
  const element = document.getElementById(id);
  if (!(element instanceof kind)) throw new Error(`The page lacks #${id}.`);
  return element;
}

/**
 * A drawing that the server made, without what could run or fetch.
 * @param {string} text
 * @param {string} title
 */
export function picture(text, title) {
  const svg = new DOMParser().parseFromString(text, "image/svg+xml").documentElement;
  for (const bad of svg.querySelectorAll("script, style, foreignObject, image, a")) bad.remove();
  svg.removeAttribute("width");
  svg.removeAttribute("height");
  svg.setAttribute("role", "img");
  svg.setAttribute("aria-label", title);
  return document.importNode(svg, true);
}

/**
 * A drawing that moves while a hand or the keyboard points at its card.
 * @param {string} text
 * @param {string} title
 */
export function moving(text, title) {
  const svg = picture(text, title);
  if (!(svg instanceof SVGSVGElement)) return svg;
  svg.pauseAnimations();
  if (matchMedia("(prefers-reduced-motion: reduce)").matches) return svg;
  requestAnimationFrame(() => {
    const card = svg.closest("button");
    for (const kind of ["pointerenter", "focus"]) card?.addEventListener(kind, () => svg.unpauseAnimations());
    for (const kind of ["pointerleave", "blur"]) card?.addEventListener(kind, () => svg.pauseAnimations());
  });
  return svg;
}

/**
 * Hand a file to the person.
 * @param {Blob} blob
 * @param {string} name
 */
export function download(blob, name) {
  const link = make("a", { href: URL.createObjectURL(blob), download: name });
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 60_000);
}
