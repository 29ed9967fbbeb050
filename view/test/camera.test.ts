// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause

import assert from "node:assert/strict";
import { test } from "node:test";
import { angleAndLength, fit, pan, toPixel, toPlace, union, zoomAt } from "../src/camera";
import { near } from "./helpers";

const viewport = { width: 800, height: 600, strip: 100 };

test("pixels and places are inverse to each other, y upward", () => {
  const camera = { x: 3, y: -2, width: 40 };
  const [x, y] = toPlace(camera, viewport, 123, 456);
  const [across, down] = toPixel(camera, viewport, x, y);
  near(across, 123);
  near(down, 456);
  assert.deepEqual(toPixel(camera, viewport, 3, -2), [400, 250]);
  assert.ok(toPixel(camera, viewport, 3, -1)[1] < 250);
});

test("a fit shows the whole box above the strip, and touches its margin", () => {
  for (const box of [{ low: [0, 0], high: [100, 1] }, { low: [-5, 2], high: [-4, 90] }] as { low: [number, number]; high: [number, number] }[]) {
    const camera = fit(box, viewport, 0.05);
    const [left, bottom] = toPixel(camera, viewport, ...box.low);
    const [right, top] = toPixel(camera, viewport, ...box.high);
    assert.ok(left >= 0 && right <= 800 && top >= 0 && bottom <= 500);
    near(Math.min(left / 800, (500 - bottom) / 500), 0.05, 1e-9);
  }
});

test("zoom keeps the place under the pointer, pan carries it", () => {
  const camera = { x: 1, y: 2, width: 30 };
  const before = toPlace(camera, viewport, 700, 50);
  const closer = zoomAt(camera, viewport, 700, 50, 2);
  near(closer.width, 15);
  toPlace(closer, viewport, 700, 50).forEach((value, i) => near(value, before[i]!));
  toPlace(pan(camera, viewport, 20, -30), viewport, 720, 20).forEach((value, i) => near(value, before[i]!));
});

test("the angle of a line is to the horizontal, whichever end comes first", () => {
  near(angleAndLength([0, 0, 1, Math.tan(Math.PI / 7)]).degrees, 180 / 7);
  near(angleAndLength([1, Math.tan(Math.PI / 7), 0, 0]).degrees, 180 / 7);
  near(angleAndLength([0, 0, -3, 4]).length, 5);
  near(angleAndLength([0, 0, 0, -1]).degrees, 90);
});

test("a union holds both boxes", () => {
  assert.deepEqual(union({ low: [0, 0], high: [1, 1] }, { low: [-1, 0.5], high: [0, 3] }), { low: [-1, 0], high: [1, 3] });
  assert.deepEqual(union(null, { low: [0, 0], high: [1, 1] }), { low: [0, 0], high: [1, 1] });
});
