// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause

import assert from "node:assert/strict";
import { test } from "node:test";
import { automaticRange, fractionOf, lookupTable, mapNames, roundUp, textOf, ticks } from "../src/colour";
import { near } from "./helpers";

test("maps begin and end with matplotlib's colours", () => {
  assert.deepEqual(mapNames, ["viridis", "magma", "cividis", "coolwarm"]);
  assert.deepEqual([...lookupTable("viridis").slice(0, 4)], [0x44, 0x01, 0x54, 255]);
  assert.deepEqual([...lookupTable("viridis").slice(-4)], [0xfd, 0xe7, 0x25, 255]);
});

test("automatic ranges have round ends and hold nearly all values", () => {
  const values = Float32Array.from({ length: 1000 }, (_, i) => i / 137);
  const range = automaticRange(values, {});
  assert.deepEqual(range, { low: 0, high: 8, log: false });
  assert.deepEqual(automaticRange(values.map((value) => value - 3), { signed: true }), { low: -5, high: 5, log: false });
  assert.deepEqual(automaticRange([2, NaN, 6], { counts: true }), { low: 0, high: 6, log: false });
  assert.deepEqual(automaticRange([], {}), { low: 0, high: 1, log: false });
  assert.ok(automaticRange([0.5, 0.5], {}).high > automaticRange([0.5, 0.5], {}).low);
  const log = automaticRange(Float32Array.from({ length: 100 }, (_, i) => 10 ** (-i / 25)), { log: true });
  assert.ok(log.log && log.low > 0 && log.high === 1);
});

test("ticks, fractions and texts", () => {
  assert.deepEqual(ticks({ low: 0, high: 8, log: false }, 4), [0, 2, 4, 6, 8]);
  assert.deepEqual(ticks({ low: 1e-3, high: 1, log: true }, 5).map((value) => Math.round(Math.log10(value))), [-3, -2, -1, 0]);
  near(fractionOf(0.1, { low: 0.01, high: 1, log: true }), 0.5);
  near(roundUp(0.0234), 0.03);
  assert.equal(textOf(-0.00025), "−2.5×10⁻⁴");
  assert.equal(textOf(NaN), "–");
  assert.equal(textOf(1234.5678, 6), "1234.57");
  assert.equal(textOf(1e-5), "10⁻⁵");
});
