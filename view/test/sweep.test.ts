// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause

import assert from "node:assert/strict";
import { test } from "node:test";
import type { Sweep } from "../src/api";
import { aligned, meanLines, shortKey } from "../src/sweep-lines";

const point = (friction: number, law: string, members: string[]): Sweep["points"][number] => ({
  name: `${friction}${law}`,
  values: { "contact.friction": friction, "contact.normal.law": law },
  members,
});
const sweep: Sweep = {
  title: "",
  scene: "heap.toml",
  seeds: [1],
  parameters: ["contact.friction", "contact.normal.law"],
  points: [point(0.5, "hooke", ["a"]), point(0.1, "hooke", ["b"]), point(0.3, "hertz", ["c"]), point(0.1, "hertz", ["d"])],
  members: ["a", "b", "c", "d"].map((name, i) => ({ name, point: "", seed: 1, status: "finished", message: "", measures: { angle: 20 + i } })),
  measures: [{ name: "angle", unit: "deg" }],
  means: [{ angle: [20, 1, 2] }, { angle: [21, null, 1] }, { angle: [22, 1, 2] }, { angle: [null, null, 0] }],
};

test("one line for each value of the second parameter, ascending", () => {
  const { lines, names } = meanLines(sweep, "angle", "contact.friction");
  assert.equal(names, null);
  assert.deepEqual(lines.map((line) => line.label), ["law hooke", "law hertz"]);
  assert.deepEqual(lines[0]!.points.map(({ x, mean, values }) => [x, mean, values]), [[0.1, 21, [21]], [0.5, 20, [20]]]);
  assert.deepEqual(aligned(lines), { x: [0.1, 0.3, 0.5], means: [[21, undefined, 20], [undefined, 22, undefined]] });
});

test("a parameter of texts has names on the axis", () => {
  const { lines, names } = meanLines(sweep, "angle", "contact.normal.law");
  assert.deepEqual(names, ["hooke", "hertz"]);
  assert.deepEqual(lines.map((line) => line.label), ["friction 0.5", "friction 0.1", "friction 0.3"]);
});

test("keys are as short as is clear", () => {
  assert.equal(shortKey("contact.friction", sweep.parameters), "friction");
  assert.equal(shortKey("a.rate", ["a.rate", "b.rate"]), "a.rate");
});
