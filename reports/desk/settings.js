// Language, scheme and step of the page: in the bar, and with each question to the server.

import { found, make } from "./elements.js";
import { request, speakIn } from "./requests.js";
import { followWords, say, speak } from "./words.js";
import { keep, kept } from "./work/store.js";

/** @import { Config } from "./types" */

/**
 * @param {Config} config
 * @param {() => void} changed
 */
export function settingsIn(config, changed) {
  const language = found("desk-language", HTMLSelectElement),
    scheme = found("desk-scheme", HTMLSelectElement),
    step = found("desk-step", HTMLInputElement);
  let spoken = config.language;

  async function translate() {
    const response = await request("GET", `/?language=${encodeURIComponent(language.value)}`);
    const page = new DOMParser().parseFromString(await response.text(), "text/html");
    const other = /** @type {Config} */ (JSON.parse(page.getElementById("desk-config")?.textContent ?? "{}"));
    spoken = document.documentElement.lang = language.value;
    speakIn(spoken);
    scheme.replaceChildren(
      make("option", { value: "" }),
      ...other.schemes.map(([value, text]) => make("option", { value, textContent: text, selected: value === scheme.value })),
    );
    speak(other.words);
    changed();
  }
  language.value = spoken;
  language.addEventListener("change", () => void translate().catch(() => (language.value = spoken)));
  for (const control of [scheme, step]) {
    const name = `chosen.${control.id}`;
    const before = kept(name);
    if (typeof before === "string") control.value = before;
    control.addEventListener("change", () => (keep(name, control.value || null), changed()));
  }
  followWords(() => {
    if (scheme.options[0]) scheme.options[0].textContent = say("of_file");
    step.placeholder = say("of_file");
    found("desk-page", HTMLIFrameElement).title = say("page");
  });

  return {
    get language() {
      return spoken;
    },
    /** What is sent beside a text. */
    given() {
      const chosen = { language: spoken };
      return {
        ...chosen,
        ...(scheme.value && { scheme: scheme.value }),
        ...(step.value.trim() && { step: step.value.trim().replace(",", ".") }),
      };
    },
  };
}
