// Names of texts: words of any language, and no device of Windows, in no spelling.

import assert from "node:assert/strict";
import { test } from "node:test";
import { isName } from "../../reports/desk/names.js";

test("a word is a name unless some system takes it for a device", () => {
  const names = ["31", "мой_вариант", "作业-1", "con1", "icon", "com", "com10", "x".repeat(60)];
  const others = ["", "a b", "a.b", "../x", "con", "NUL", "Com1", "lpt9", "com¹", "x".repeat(61)];
  assert.deepEqual([...names, ...others].filter(isName), names);
});
