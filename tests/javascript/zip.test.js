// A zip of texts: what is written is read again, by this reader and by Python's; what others write is read, too.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { test } from "node:test";
import { unzipped, zipped } from "../../reports/desk/work/zip.js";

const FILES = { "31.toml": 'title = "Колесо, 轮"\n', "mine.toml": "", "r.csv": "0,1\n".repeat(2000) };
const PYTHON = process.env.PYTHON ?? "python3";

test("what is written is read again", async () => {
  assert.deepEqual(await unzipped(zipped(FILES)), FILES);
  assert.deepEqual(await unzipped(zipped({})), {});
});

test("Python reads it, names and texts", async () => {
  const read = "import sys, io, json, zipfile; z = zipfile.ZipFile(io.BytesIO(sys.stdin.buffer.read())); assert z.testzip() is None; print(json.dumps({n: z.read(n).decode() for n in z.namelist()}))";
  const told = execFileSync(PYTHON, ["-c", read], { input: Buffer.from(await zipped(FILES).arrayBuffer()) });
  assert.deepEqual(JSON.parse(told.toString()), FILES);
});

test("a zip that Python has compressed is read", async () => {
  const write = "import sys, json, io, zipfile; b = io.BytesIO(); z = zipfile.ZipFile(b, 'w', zipfile.ZIP_DEFLATED); [z.writestr(n, t) for n, t in json.load(sys.stdin).items()]; z.close(); sys.stdout.buffer.write(b.getvalue())";
  const packed = execFileSync(PYTHON, ["-c", write], { input: JSON.stringify(FILES) });
  assert.deepEqual(await unzipped(new Blob([packed])), FILES);
});

test("what is no zip, and what is too large, is refused", async () => {
  await assert.rejects(unzipped(new Blob(["no zip at all, but long enough for its end"])), /no zip/);
  await assert.rejects(unzipped(new Blob([])), /no zip/);
  const bomb = "import sys, io, zipfile; b = io.BytesIO(); z = zipfile.ZipFile(b, 'w', zipfile.ZIP_DEFLATED); z.writestr('a.toml', 'a' * 9_000_000); z.close(); c = bytearray(b.getvalue()); i = c.rfind(b'PK\\x01\\x02'); c[i + 24:i + 28] = (100).to_bytes(4, 'little'); sys.stdout.buffer.write(c)";
  const packed = execFileSync(PYTHON, ["-c", bomb], { maxBuffer: 1e8 });
  await assert.rejects(unzipped(new Blob([packed])), /too large/);
});
