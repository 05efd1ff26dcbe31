// A zip of texts: what is written is read again, by this reader and by Python's; what others write is read, too.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { test } from "node:test";
import { unzipped, zipped } from "../../reports/desk/work/zip.js";

const FILES = { "31.toml": 'title = "Колесо, 轮"\n', "mine.toml": "", "r.csv": "0,1\n".repeat(2000) };
const PACKING = [
  "import io, json, sys, zipfile",
  "made = io.BytesIO(); zipped = zipfile.ZipFile(made, 'w', zipfile.ZIP_DEFLATED)",
];
const PYTHON = process.env.PYTHON ?? "python3";

test("what is written is read again", async () => {
  assert.deepEqual(await unzipped(zipped(FILES)), FILES);
  assert.deepEqual(await unzipped(zipped({})), {});
});

test("Python reads it, names and texts", async () => {
  const read = [
    "import io, json, sys, zipfile",
    "zipped = zipfile.ZipFile(io.BytesIO(sys.stdin.buffer.read()))",
    "assert zipped.testzip() is None",
    "print(json.dumps({name: zipped.read(name).decode() for name in zipped.namelist()}))",
  ];
  const told = execFileSync(PYTHON, ["-c", read.join("\n")], { input: Buffer.from(await zipped(FILES).arrayBuffer()) });
  assert.deepEqual(JSON.parse(told.toString()), FILES);
});

test("a zip that Python has compressed is read", async () => {
  const write = [
    ...PACKING,
    "for name, text in json.load(sys.stdin).items(): zipped.writestr(name, text)",
    "zipped.close(); sys.stdout.buffer.write(made.getvalue())",
  ];
  const packed = execFileSync(PYTHON, ["-c", write.join("\n")], { input: JSON.stringify(FILES) });
  assert.deepEqual(await unzipped(new Blob([packed])), FILES);
});

test("what is no zip, and what is too large, is refused", async () => {
  await assert.rejects(unzipped(new Blob(["no zip at all, but long enough for its end"])), /no zip/);
  await assert.rejects(unzipped(new Blob([])), /no zip/);
  // Its directory says 100 bytes.
  const bomb = [
    ...PACKING,
    "zipped.writestr('a.toml', 'a' * 9_000_000); zipped.close()",
    "content = bytearray(made.getvalue()); at = content.rfind(b'PK\x01\x02')",
    "content[at + 24:at + 28] = (100).to_bytes(4, 'little'); sys.stdout.buffer.write(content)",
  ];
  const packed = execFileSync(PYTHON, ["-c", bomb.join("\n")], { maxBuffer: 1e8 });
  await assert.rejects(unzipped(new Blob([packed])), /too large/);
});
