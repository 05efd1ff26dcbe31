// Texts in the folder in which `coursework edit` was started; the server reads and writes them.

import { Refused, get, request, rooted } from "../requests.js";
import { say } from "../words.js";

/** @import { Works } from "../types" */

/** @param {string} name */
const path = (name) => `/api/file/${encodeURIComponent(name)}`;
/**
 * Done without a word, or refused for what stands there.
 * @param {string} method
 * @param {string} name
 * @param {string} sentence
 * @param {Parameters<typeof request>[2]} given
 */
async function done(method, name, sentence, given) {
  try {
    await request(method, path(name), given);
  } catch (error) {
    throw error instanceof Refused && error.status === 409 ? new Error(sentence) : error;
  }
}
/** @param {string} name */
const taken = (name) => say("name_taken", { name });

/** @returns {Works} */
export const folderWorks = () => ({
  list: () => get("/api/files"),
  async read(name) {
    try {
      const response = await request("GET", path(name));
      return { text: await response.text(), etag: response.headers.get("ETag") ?? "" };
    } catch (error) {
      if (error instanceof Refused && error.status === 404) return null;
      throw error;
    }
  },
  async write(name, text, etag) {
    /** @type {Record<string, string>} */
    const seen = etag === null ? { "If-None-Match": "*" } : { "If-Match": etag };
    try {
      const response = await request("PUT", path(name), {
        body: text,
        headers: { "Content-Type": "text/plain; charset=utf-8", ...seen },
      });
      return { etag: response.headers.get("ETag") ?? "" };
    } catch (error) {
      if (error instanceof Refused && error.status === 409)
        return { theirs: error.body.theirs === null ? null : { text: error.body.theirs, etag: error.body.etag } };
      throw error;
    }
  },
  rename: (name, other) => done("POST", name, taken(other), { json: { rename: other } }),
  duplicate: (name, other) => done("POST", name, taken(other), { json: { duplicate: other } }),
  restore: (name) => done("POST", name, taken(name), { json: { restore: true } }),
  remove: (name, etag) => done("DELETE", name, say("conflict", { name }), { headers: { "If-Match": etag } }),
  zip: async () => (await request("GET", "/api/zip")).blob(),
  unzip: async (file) =>
    (await request("POST", "/api/zip", { body: file, headers: { "Content-Type": "application/zip" } })).json(),
  watch(changed) {
    const events = new EventSource(rooted("/api/events"));
    events.addEventListener("files", (event) => changed(JSON.parse(event.data)));
  },
  // The server reads the tables of the folder itself.
  tables: () => undefined,
  keepTables: () => {},
});
