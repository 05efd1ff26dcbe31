// A zip of texts, written and read without a library: names in UTF-8, stored; reading knows deflate as well.

const MOST = 8_000_000; // bytes of a text that are unpacked
const TABLE = Uint32Array.from({ length: 256 }, (_, n) => {
  for (let k = 0; k < 8; k++) n = n & 1 ? 0xedb88320 ^ (n >>> 1) : n >>> 1;
  return n;
});

/** @param {Uint8Array} bytes */
function checksum(bytes) {
  let sum = 0xffffffff;
  for (const byte of bytes) sum = (TABLE[(sum ^ byte) & 255] ?? 0) ^ (sum >>> 8);
  return (sum ^ 0xffffffff) >>> 0;
}

/**
 * Numbers of two or four bytes, little end first: [value, bytes] each.
 * @param {[number, number][]} parts
 */
function packed(parts) {
  const bytes = new Uint8Array(parts.reduce((sum, [, size]) => sum + size, 0));
  let at = 0;
  for (const [value, size] of parts) for (let k = 0; k < size; k++) bytes[at++] = (value >>> (8 * k)) & 255;
  return bytes;
}

/**
 * @param {Record<string, string>} files Text by name.
 * @returns {Blob}
 */
export function zipped(files) {
  const coder = new TextEncoder(),
    body = [],
    index = [];
  let at = 0,
    size = 0,
    count = 0;
  for (const [name, text] of Object.entries(files)) {
    const title = coder.encode(name),
      content = coder.encode(text);
    // Version 2.0, UTF-8, stored, the first day that the format knows.
    const head = /** @type {[number, number][]} */ ([
      [20, 2],
      [0x0800, 2],
      [0, 2],
      [0, 2],
      [0x21, 2],
      [checksum(content), 4],
      [content.length, 4],
      [content.length, 4],
      [title.length, 2],
      [0, 2],
    ]);
    const local = packed([[0x04034b50, 4], ...head]);
    index.push(packed([[0x02014b50, 4], [20, 2], ...head, [0, 2], [0, 2], [0, 2], [0, 4], [at, 4]]), title);
    body.push(local, title, content);
    at += local.length + title.length + content.length;
    size += 46 + title.length;
    count++;
  }
  const end = packed([
    [0x06054b50, 4],
    [0, 2],
    [0, 2],
    [count, 2],
    [count, 2],
    [size, 4],
    [at, 4],
    [0, 2],
  ]);
  return new Blob([...body, ...index, end], { type: "application/zip" });
}

/**
 * The texts of a zip by name; throws for what is none.
 * @param {Blob} file
 * @returns {Promise<Record<string, string>>}
 */
export async function unzipped(file) {
  const bytes = new Uint8Array(await file.arrayBuffer()),
    view = new DataView(bytes.buffer);
  let end = bytes.length - 22;
  while (end >= 0 && view.getUint32(end, true) !== 0x06054b50) end--;
  if (end < 0) throw new Error("no zip");
  /** @type {Record<string, string>} */
  const files = {};
  let at = view.getUint32(end + 16, true);
  for (let left = view.getUint16(end + 10, true); left > 0; left--) {
    if (view.getUint32(at, true) !== 0x02014b50) throw new Error("no zip");
    const [method, size, whole] = [view.getUint16(at + 10, true), view.getUint32(at + 20, true), view.getUint32(at + 24, true)];
    const [title, extra, remark, local] = [
      view.getUint16(at + 28, true),
      view.getUint16(at + 30, true),
      view.getUint16(at + 32, true),
      view.getUint32(at + 42, true),
    ];
    const name = new TextDecoder().decode(bytes.subarray(at + 46, at + 46 + title));
    const from = local + 30 + view.getUint16(local + 26, true) + view.getUint16(local + 28, true);
    const content = new Blob([bytes.subarray(from, from + size)]);
    if (!name.endsWith("/") && whole <= MOST) {
      const open = method === 8 ? content.stream().pipeThrough(new DecompressionStream("deflate-raw")) : content.stream();
      files[name] = await bounded(open);
    }
    at += 46 + title + extra + remark;
  }
  return files;
}

/** @param {ReadableStream<Uint8Array>} stream What says that it is small may be a bomb all the same. */
async function bounded(stream) {
  const reader = stream.getReader(),
    coder = new TextDecoder();
  let text = "",
    size = 0;
  for (;;) {
    const { done, value } = await reader.read();
    if (done) return text + coder.decode();
    size += value.length;
    if (size > MOST) throw new Error("too large");
    text += coder.decode(value, { stream: true });
  }
}
