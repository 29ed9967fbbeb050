// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause

import assert from "node:assert/strict";
import { test } from "node:test";
import { deflateSync } from "node:zlib";
import { decodeArrays, floats, integers } from "../src/arrays";
import { EmbeddedSource } from "../src/source";
import { encode } from "./helpers";

const answer = (): ArrayBuffer =>
  encode(
    { time: 12.5, key: "000003" },
    {
      position: { shape: [2, 2], values: [1, 2, 3.5, -4] },
      pair: { type: "u32", shape: [1, 2], values: [0, 4294967295] },
      odd: { type: "u8", shape: [3], values: [0, 1, 255], low: -1, scale: 0.5 },
      small: { type: "u16", shape: [2, 2], values: [0, 0, 65535, 100], low: [1, 2], scale: [0.25, 2] },
      gap: { shape: [2], values: [NaN, 7] },
    },
  );

test("arrays are views into the answer", () => {
  const buffer = answer();
  const arrays = decodeArrays(buffer);
  assert.equal(arrays.head["time"], 12.5);
  assert.deepEqual([...floats(arrays, "position")!], [1, 2, 3.5, -4]);
  assert.equal(floats(arrays, "position")!.buffer, buffer);
  assert.deepEqual([...integers(arrays, "pair")!], [0, 4294967295]);
  assert.equal(arrays.arrays.get("position")!.unit, "L");
  assert.deepEqual(arrays.arrays.get("position")!.shape, [2, 2]);
  assert.deepEqual([...floats(arrays, "gap")!], [NaN, 7]);
  assert.equal(floats(arrays, "absent"), null);
});

test("numbers of one and two bytes are low plus scale times the number", () => {
  const arrays = decodeArrays(answer());
  assert.deepEqual([...floats(arrays, "odd")!], [-1, -0.5, 126.5]);
  assert.deepEqual([...floats(arrays, "small")!], [1, 2, 1 + 0.25 * 65535, 202]);
});

test("what is not such an answer is an error", () => {
  const buffer = answer();
  assert.throws(() => decodeArrays(buffer.slice(0, 6)), /RPV1/);
  assert.throws(() => decodeArrays(buffer.slice(0, 60)), /cut off/);
  assert.throws(() => decodeArrays(buffer.slice(0, buffer.byteLength - 4)), /outside/);
  const wrong = answer();
  new Uint8Array(wrong)[0] = 0x58;
  assert.throws(() => decodeArrays(wrong), /RPV1/);
});

test("an exported page holds the same answers", async () => {
  const packed = deflateSync(new Uint8Array(answer())).toString("base64");
  const source = new EmbeddedSource({ "api/run": { title: "heap" }, "api/frame/000003": packed });
  assert.deepEqual(await source.json("api/run"), { title: "heap" });
  const arrays = await source.arrays("api/frame/000003");
  assert.deepEqual([...floats(arrays, "position")!], [1, 2, 3.5, -4]);
  await assert.rejects(source.json("api/summary"), /not in this page/);
});
