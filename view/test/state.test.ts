// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause

import assert from "node:assert/strict";
import { test } from "node:test";
import { fromHash, toHash } from "../src/hash";
import { initialState, Store, type ViewState } from "../src/state";

const all: ViewState = {
  member: "friction=0.5 & more",
  frame: "000012",
  camera: { x: -1.25, y: 3e-5, width: 80 },
  fitted: false,
  grains: "outline",
  field: "pressure",
  map: "magma",
  range: [0.001, 25],
  log: true,
  contacts: false,
  threshold: 0.5,
  width: 1.5,
  sliding: true,
  layer: "shear",
  layerMap: "viridis",
  layerRange: [-1, 1],
  bars: true,
  base: "frame",
  shear: true,
  series: ["grains", "wall_force_x:left"],
  picked: 0,
  chase: true,
  line: [0, 1, 2, 3.5],
  theme: "dark",
  tab: "series",
  measure: "angle.mean",
  over: "contact.friction",
};

test("the address holds the whole state", () => {
  for (const key of Object.keys(initialState) as (keyof ViewState)[]) assert.notDeepEqual(all[key], initialState[key], `${key} must differ`);
  assert.deepEqual(fromHash(`#${toHash(all)}`), all);
  assert.equal(toHash(initialState), "");
  assert.deepEqual(fromHash(""), initialState);
});

test("what cannot be read is ignored", () => {
  assert.deepEqual(fromHash("#camera=1,2&range=a,b&grains=pink&picked=-3&threshold=&log=maybe&unknown=1&__proto__=x&field=%E0%A4%A&tab"), initialState);
  assert.equal(fromHash("#camera=0,0,-1&field=speed").camera, null);
});

test("the store tells what has changed, and only then", () => {
  const store = new Store(initialState);
  const told: string[] = [];
  const stop = store.listen((_, changed) => told.push([...changed].join()));
  store.set({ field: "speed", range: null });
  store.set({ field: "speed" });
  store.set({ camera: { x: 0, y: 0, width: 1 }, log: true });
  stop();
  store.set({ log: false });
  assert.deepEqual(told, ["field", "camera,log"]);
});
