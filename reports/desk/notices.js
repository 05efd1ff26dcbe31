// Sentences above the text that wait for a person: restored work, a conflict, a browser that keeps nothing.

import { button, cross, make } from "./elements.js";

/** @param {HTMLElement} place */
export function noticesIn(place) {
  /** @type {Map<string, HTMLElement>} */
  const shown = new Map();

  /** @param {string} key */
  function drop(key) {
    shown.get(key)?.remove();
    shown.delete(key);
  }

  return {
    drop,
    /**
     * Show a sentence in place of the one of the same key.
     * @param {string} key
     * @param {string} sentence
     * @param {Record<string, () => void>} [answers] What its buttons do, by their words; each drops the sentence.
     */
    show(key, sentence, answers = {}) {
      const buttons = Object.entries(answers).map(([text, act]) => button(text, () => (drop(key), act())));
      const notice = make(
        "p",
        { "data-notice": key },
        make("span", {}, sentence),
        ...buttons,
        cross(() => drop(key)),
      );
      const old = shown.get(key);
      if (old) old.replaceWith(notice);
      else place.append(notice);
      shown.set(key, notice);
    },
  };
}
