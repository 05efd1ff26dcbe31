// When the server is asked: after a pause in typing, at once where a hand moves something;
// the newest text supersedes the others.

import { Refused, request } from "../requests.js";

/** @import { Answer, Ask } from "../types" */

const PAUSE = 200,
  RETRY = 1500; // ms

/**
 * @typedef {{
 *   body: () => Ask,
 *   answered: (answer: Answer, ask: Ask) => void,
 *   began: () => void,
 *   lost: (sentence: string | null) => void,
 * }} Asked `began` when a text goes off, `lost` when it was not answered: null where nobody is there.
 */

/** @param {Asked} asked */
export function asking({ body, answered, began, lost }) {
  /** @type {AbortController | null} */
  let flying = null;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let waiting;
  let again = false;

  async function go() {
    clearTimeout(waiting);
    again = false;
    const controller = (flying = new AbortController()),
      ask = body();
    began();
    try {
      const answer = await (await request("POST", "/api/page", { json: ask, signal: controller.signal })).json();
      if (flying !== controller) return;
      flying = null;
      answered(answer, ask);
      if (again) await go();
    } catch (error) {
      if (flying !== controller) return;
      flying = null;
      if (error instanceof Refused && error.body?.cancelled) return void later(0);
      const refused = error instanceof Refused;
      lost(refused ? error.message : null);
      // Who asked too often or found no worker asks again; a refusal for what the text is stands until the text is another.
      if (!refused || error.seconds !== null || error.status >= 500) later(1000 * ((refused && error.seconds) || RETRY / 1000));
    }
  }

  /** @param {number} pause */
  function later(pause) {
    clearTimeout(waiting);
    waiting = setTimeout(() => {
      flying?.abort();
      void go();
    }, pause);
  }

  return {
    /** The text was typed: ask after a pause, and let go of what was asked before. */
    typed: () => later(PAUSE),
    /** Something was moved: ask as soon as the answer before is there, so that each move is seen. */
    moved() {
      if (flying) again = true;
      else void go();
    },
    /** What was asked is of another text. */
    drop() {
      flying?.abort();
      flying = null;
    },
    get busy() {
      return flying !== null;
    },
  };
}
