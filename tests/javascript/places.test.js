// Places, the smallest change between two texts, and numbers as they stand in a text.

import assert from "node:assert/strict";
import { test } from "node:test";
import { change, changes, extent, offset, written } from "../../reports/desk/text/places.js";

/** A text as the editor has it, as far as places need it. */
const textOf = (whole) => {
  const lines = whole.split("\n");
  const from = (number) => lines.slice(0, number - 1).reduce((sum, line) => sum + line.length + 1, 0);
  return {
    lines: lines.length,
    line: (number) => ({ from: from(number), text: lines[number - 1], length: lines[number - 1].length }),
  };
};
const DOC = textOf('[given]\nr1 = "0.953 kg"  # 𝜑 DA\n  phi1 = ph3');

test("line and column of the server are places of the editor", () => {
  assert.equal(offset(DOC, 1, 1), 0);
  assert.equal(offset(DOC, 2, 6), 13);
  // Python counts 𝜑 once, the editor twice.
  assert.equal(offset(DOC, 2, 22), 8 + 22);
  assert.equal(offset(DOC, 2, 19), 8 + 18);
});

test("what lies outside is moved inside", () => {
  assert.equal(offset(DOC, 0, 1), 0);
  assert.equal(offset(DOC, 99, 99), DOC.line(3).from + DOC.line(3).length);
  assert.equal(offset(DOC, null, null), 0);
});

test("a fault underlines the word, the sign, what is in quotes, or its line", () => {
  const taken = (line, column) => {
    const { from, to } = extent(DOC, line, column),
      start = DOC.line(line).from;
    return DOC.line(line).text.slice(from - start, to - start);
  };
  assert.equal(taken(2, 6), '"0.953 kg"');
  assert.equal(taken(3, 10), "ph3");
  assert.equal(taken(3, 8), "=");
  assert.equal(taken(3, 0), "phi1 = ph3");
  // At the end of a line there is nothing but the letter before.
  assert.equal(taken(3, 13), "3");
});

test("one change makes one text the other", () => {
  assert.equal(change("same", "same"), null);
  for (const [before, after] of [
    ["aXb", "aYb"],
    ["", "new"],
    ["gone", ""],
    ["aa", "aaa"],
    ["aaa", "aa"],
    ["0.953 m", "0.96 m"],
  ]) {
    const { from, to, insert } = change(before, after);
    assert.equal(before.slice(0, from) + insert + before.slice(to), after);
  }
  assert.deepEqual(change('r1 = "0.953 m"', 'r1 = "0.954 m"'), { from: 10, to: 11, insert: "4" });
});

test("texts of as many lines are changed line by line", () => {
  const made = (before, after) =>
    changes(before, after).reduceRight((text, { from, to, insert }) => text.slice(0, from) + insert + text.slice(to), before);
  for (const [before, after] of [
    ["a\nb\nc", "x\nb\ny"],
    ["a\nb", "a\nb"],
    ["a\nb", "a\nb\nc"],
    ["", "\n"],
  ])
    assert.equal(made(before, after), after);
  assert.deepEqual(
    changes("a = 1\nb = 2\nc = 3", "a = 4\nb = 2\nc = 5").map(({ from, to }) => [from, to]),
    [
      [4, 5],
      [16, 17],
    ],
  );
});

test("a number keeps the decimals of the file and has no sign where it is nought", () => {
  assert.equal(written(0.9535, 3), "0.954");
  assert.equal(written(-0.0001, 2), "0.00");
  assert.equal(written(-1.5, 0), "-2");
  assert.equal(written(12, 0), "12");
});
