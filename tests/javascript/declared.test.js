// What a half-typed text declares, and where in it one types.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { declaredIn, whereIn } from "../../reports/desk/text/declared.js";

const TEXT = readFileSync(new URL("../../variants/31.toml", import.meta.url), "utf-8");

test("names and points of a whole file", () => {
  const { names, points } = declaredIn(TEXT);
  assert.deepEqual([...names.keys()].sort(), [
    "V1",
    "VMx",
    "VMy",
    "alpha",
    "p",
    "phi1",
    "phi2",
    "phi3",
    "r1",
    "r2",
    "r3",
    "w1",
    "w2",
    "w3",
    "w4",
  ]);
  assert.equal(names.get("w1"), "rate");
  assert.equal(names.get("w4"), "unknowns");
  assert.deepEqual([...points], ["D", "A", "B", "M", "C", "P"]);
});

test("a chain of groups declares its coordinates and points", () => {
  const { names, points } = declaredIn('[[group]]\nkind = "RRR"\ncoordinates = ["phi2", "phi3"]\nmeets = "C"\n');
  assert.deepEqual([[...names.keys()], [...points]], [["phi2", "phi3"], ["C"]]);
});

test("half a text is read too", () => {
  assert.deepEqual([...declaredIn('[given]\nr1 = "0.9').names.keys()], ["r1"]);
  assert.deepEqual([...declaredIn("[giv").names.keys()], []);
});

test("where one types: section, key, inside quotes or not", () => {
  const at = (before) => {
    const { section, key, inside } = whereIn(before);
    return [section, key, inside];
  };
  assert.deepEqual(at("[given]\nr1 = "), ["given", "r1", false]);
  assert.deepEqual(at('[given]\nr1 = "0.9 '), ["given", "r1", true]);
  assert.deepEqual(at('[coordinates]\nphi1 = { start = "1.6 rad", rate = "w'), ["coordinates", "rate", true]);
  assert.deepEqual(at('[[constraint]]\nequation = "VMx - r'), ["constraint", "equation", true]);
  assert.deepEqual(at("fo"), ["", "", false]);
  // A key inside a text in quotes is none.
  assert.deepEqual(at('title = "a = b'), ["", "title", true]);
});
