// Requests to the server: JSON, the desk's name, and what was refused with its sentence.

import { say } from "./words.js";

/** A request that the server answered with a refusal; `seconds` tells when to ask again. */
export class Refused extends Error {
  /**
   * @param {number} status
   * @param {string} sentence
   * @param {number | null} seconds
   * @param {any} body
   */
  constructor(status, sentence, seconds, body) {
    super(sentence);
    this.status = status;
    this.seconds = seconds;
    this.body = body;
  }
}

const DESK = Array.from(crypto.getRandomValues(new Uint8Array(12)), (byte) => byte.toString(16).padStart(2, "0")).join("");
let root = "";
let language = "en";

/** @param {string} path Root path behind which the server stands. */
export const standBehind = (path) => void (root = path);
/** @param {string} path */
export const rooted = (path) => root + path;
/** @param {string} chosen */
export const speakIn = (chosen) => void (language = chosen);

/** What a person is told of a request that was not done. @param {unknown} error */
export const whyNot = (error) => (error instanceof TypeError ? say("state_unreachable") : /** @type {Error} */ (error).message);

/**
 * Throws `Refused` for a refusal, a TypeError where nobody answers.
 * @param {string} method
 * @param {string} path
 * @param {{json?: unknown, body?: BodyInit, headers?: Record<string, string>, signal?: AbortSignal}} [given]
 */
export async function request(method, path, { json, body, headers = {}, signal } = {}) {
  const sent = json === undefined ? headers : { "Content-Type": "application/json", ...headers };
  const response = await fetch(root + path, {
    method,
    headers: { "X-Desk": DESK, "Accept-Language": language, ...sent },
    body: json === undefined ? (body ?? null) : JSON.stringify(json),
    signal: signal ?? null,
    cache: method === "GET" ? "no-cache" : "default",
  });
  if (response.ok) return response;
  const told = await response.json().catch(() => null);
  const after = Number(response.headers.get("Retry-After"));
  throw new Refused(response.status, told?.sentence ?? `${response.status}`, after > 0 ? after : null, told);
}

/**
 * The answer while everything waits, null where there is none: for the moment before a printing, which waits for no promise.
 * @param {string} path
 * @param {unknown} json
 * @returns {any}
 */
export function postAtOnce(path, json) {
  const asked = new XMLHttpRequest();
  asked.open("POST", root + path, false);
  asked.setRequestHeader("Content-Type", "application/json");
  try {
    asked.send(JSON.stringify(json));
    return asked.status === 200 ? JSON.parse(asked.responseText) : null;
  } catch {
    return null;
  }
}

/**
 * What came of a text; throws where it has faults instead, with the first of them.  One without a line is none of the text.
 * @param {any} answer
 */
export function faultless(answer) {
  const [first] = answer.faults ?? [];
  if (!first) return answer;
  const many = first.line === null ? "" : `${say("state_faulty", { n: answer.faults.length })} · `;
  throw new Error(many + first.sentence);
}

/**
 * What was asked, as JSON; asked again where the server says when, because nobody else does.
 * @param {string} method
 * @param {string} path
 * @param {unknown} [json]
 * @param {number} [left] How many times more.
 * @returns {Promise<any>}
 */
async function patiently(method, path, json, left = 5) {
  try {
    return await (await request(method, path, { json })).json();
  } catch (error) {
    if (!(error instanceof Refused) || error.seconds === null || !left) throw error;
    await new Promise((done) => setTimeout(done, 1000 * Number(error.seconds)));
    return patiently(method, path, json, left - 1);
  }
}

/** @param {string} path */
export const get = (path) => patiently("GET", path);
/**
 * @param {string} path
 * @param {unknown} json
 */
export const post = (path, json) => patiently("POST", path, json);
