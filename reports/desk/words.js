// The sentences of the desk, in the language that was chosen.

/** @type {Record<string, string>} */
let words = {};
/** @type {(() => void)[]} */
const followers = [];

/**
 * @param {string} key
 * @param {Record<string, unknown>} [gaps]
 */
export function say(key, gaps = {}) {
  return (words[key] ?? key).replace(/\{(\w+)\}/g, (_, gap) => String(gaps[gap]));
}

/** All of them, for the frame. */
export const spoken = () => words;

/** @param {Record<string, string>} others */
export function speak(others) {
  words = others;
  for (const place of document.querySelectorAll("[data-word]"))
    place.textContent = say(/** @type {HTMLElement} */ (place).dataset.word ?? "");
  for (const place of document.querySelectorAll("[data-label]"))
    place.setAttribute("aria-label", say(/** @type {HTMLElement} */ (place).dataset.label ?? ""));
  for (const follow of followers) follow();
}

/**
 * Call when the language changes.
 * @param {() => void} follow
 */
export function followWords(follow) {
  followers.push(follow);
}
