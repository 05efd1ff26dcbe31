// Texts in the folder in which `coursework edit` was started; the server reads and writes them.

import { Refused, get, post, request, rooted } from "../requests.js";

/** @import { Works } from "../types" */

/** @param {string} name */
const path = (name) => `/api/file/${encodeURIComponent(name)}`;

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
  rename: (name, other) => post(path(name), { rename: other }),
  duplicate: (name, other) => post(path(name), { duplicate: other }),
  restore: (name) => post(path(name), { restore: true }),
  remove: async (name, etag) => void (await request("DELETE", path(name), { headers: { "If-Match": etag } })),
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
