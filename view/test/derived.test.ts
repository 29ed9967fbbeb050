// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause

import assert from "node:assert/strict";
import { test } from "node:test";
import type { Wall } from "../src/api";
import { frameProfile } from "../src/base-profile";
import { contactsOf, coordination, grainStress, largestForce, pressure, shear, speed } from "../src/derived";
import { principal } from "../src/field-grid";
import { extent, rowOf } from "../src/frame";
import { Grid } from "../src/grid";
import { nearest } from "../src/nearest";
import { firstFrom, networkOf } from "../src/network";
import { frame, near, wall } from "./helpers";

// A disc of radius 2 between two plates that press it with the force 5.
const squeezed = frame(
  [[1, 2, 2]],
  [
    { pair: [0, wall(0)], normal: [0, 1], point: [1, 0], force: 5 },
    { pair: [0, wall(1)], normal: [0, -1], point: [1, 4], force: 5 },
  ],
);

test("a disc between two plates: sigma_yy = 2 F r / (pi r^2), pressure and shear half of it", () => {
  const stress = grainStress(squeezed, 0);
  near(stress.yy[0]!, (2 * 5 * 2) / (Math.PI * 4));
  near(stress.xx[0]!, 0);
  near(pressure(squeezed, 0)[0]!, 5 / (Math.PI * 2));
  near(shear(squeezed, 0)[0]!, 5 / (Math.PI * 2));
});

test("both partners feel a contact: equal discs have equal stress, tangential forces no pressure", () => {
  const pairOf = frame([[0, 0, 1], [2, 0, 1]], [{ pair: [1, 0], normal: [1, 0], point: [1, 0], force: 3, tangential: 2 }]);
  const stress = grainStress(pairOf, 0);
  for (const i of [0, 1]) {
    near(stress.xx[i]!, 3 / Math.PI);
    near(stress.yx[i]!, 2 / Math.PI);
    near(pressure(pairOf, 0)[i]!, 1.5 / Math.PI);
  }
});

test("across the sides of a periodic box", () => {
  const across = frame([[1, 0, 1], [9, 0, 1]], [{ pair: [0, 1], normal: [1, 0], point: [0, 0], force: 3 }]);
  for (const i of [0, 1]) near(pressure(across, 10)[i]!, 1.5 / Math.PI);
  near(nearest(8, 10), -2);
  const { count, ends } = networkOf(across, 10, 1, 0);
  assert.equal(count, 2);
  assert.deepEqual([...ends], [1, 0, -1, 0, 11, 0, 9, 0]);
});

test("coordination counts contacts that push, walls too; without forces all", () => {
  const contacts = [
    { pair: [0, 1] as [number, number], normal: [-1, 0] as [number, number], point: [1, 0] as [number, number], force: 1 },
    { pair: [0, 2] as [number, number], normal: [0, -1] as [number, number], point: [0, 1] as [number, number], force: -1 },
    { pair: [1, wall(0)] as [number, number], normal: [0, 1] as [number, number], point: [2, -1] as [number, number], force: 2 },
  ];
  const three: [number, number, number][] = [[0, 0, 1], [2, 0, 1], [0, 2, 1]];
  assert.deepEqual([...coordination(frame(three, contacts))], [1, 2, 0]);
  assert.deepEqual([...coordination(frame(three, contacts.map(({ force: _, ...one }) => one)))], [2, 2, 1]);
  assert.deepEqual([...largestForce(frame(three, contacts))], [1, 2, 0]);
  assert.deepEqual(contactsOf(frame(three, contacts), 1), [0, 2]);
});

test("contacts without normals and points get them from the centres and walls", () => {
  const walls = [
    { name: "drum", number: 1, from: [-9, 5], to: [-9, -5] },
    { name: "drum", number: 1, from: [0, -2], to: [9, -2] },
    { name: "lid", number: 0, from: [-9, 3], to: [9, 3] },
  ] as Wall[];
  const grains: [number, number, number][] = [[0, -1, 1], [1.6, 0.2, 1], [9, -1, 1]];
  const contacts = [
    { pair: [0, 1] as [number, number], normal: [-0.8, -0.6] as [number, number], point: [0.8, -0.4] as [number, number], force: 1 },
    { pair: [0, wall(1)] as [number, number], normal: [0, 1] as [number, number], point: [0, -2] as [number, number], force: 2 },
    { pair: [2, 0] as [number, number], normal: [-1, 0] as [number, number], point: [10, -1] as [number, number], force: 3 },
  ];
  const given = frame(grains, contacts, [], { walls, period: 11 });
  const bare = frame(grains, contacts, [], { walls, period: 11, bare: true });
  given.normal.forEach((value, i) => near(bare.normal[i]!, value));
  given.point.forEach((value, i) => near(bare.point[i]!, value));
  pressure(given, 11).forEach((value, i) => near(pressure(bare, 11)[i]!, value));
});

test("speed, rows by id, and the network above a threshold", () => {
  assert.deepEqual([...speed(squeezed)], [5]);
  const three = frame([[0, 0, 1], [2, 0, 1], [0, 2, 1]], [
    { pair: [0, 1], normal: [-1, 0], point: [1, 0], force: 4 },
    { pair: [0, 2], normal: [0, -1], point: [0, 1], force: -1 },
  ]);
  assert.equal(rowOf(three, 20), 2);
  assert.equal(rowOf(three, 15), -1);
  const all = networkOf(three, 0, 2, 0);
  // The strong ones come last.
  assert.deepEqual([...all.ends], [0, 0, 0, 2, 0, 0, 2, 0]);
  assert.deepEqual([...all.marks], [-0.5, 0, 2, 0]);
  assert.deepEqual([firstFrom(all, 0), firstFrom(all, 0.4), firstFrom(all, 1), firstFrom(all, 3)], [0, 0, 1, 2]);
  assert.equal(networkOf(three, 0, 2, 1).count, 1);
  assert.deepEqual(extent(three), { low: [-1, -1], high: [3, 3] });
});

test("forces on base grains: downward and to the right are positive", () => {
  const heap = frame(
    [[0, 0, 0.5], [1, 0, 0.5], [0.5, 0.8, 0.5]],
    [
      { pair: [0, 2], normal: [-0.6, -0.8], point: [0.3, 0.4], force: 5 },
      { pair: [2, 1], normal: [-0.6, 0.8], point: [0.8, 0.4], force: 10 },
    ],
    [3, 3, 0],
  );
  const profile = frameProfile(heap, 2, "grain weights")!;
  assert.deepEqual([...profile.x], [0, 1]);
  near(profile.normal[0]!, 2);
  near(profile.normal[1]!, 4);
  near(profile.shear[0]!, -1.5);
  near(profile.shear[1]!, 3);
});

test("the grid finds the grain under a place", () => {
  const many = frame(Array.from({ length: 400 }, (_, i): [number, number, number] => [i % 20, Math.floor(i / 20), i === 7 ? 0.2 : 0.5]), []);
  const grid = new Grid(many);
  assert.equal(grid.at(3.1, 4.2, 0), 83);
  assert.equal(grid.at(7, 0.3, 0), -1);
  assert.equal(grid.at(7, 0.3, 0.15), 7);
  assert.equal(grid.at(-5, -5, 1), -1);
});

test("principal stresses", () => {
  const { major, minor, angle } = principal(1, 1, 1);
  near(major, 2);
  near(minor, 0);
  near(angle, Math.PI / 4);
  near(principal(0, 0, 3).angle, Math.PI / 2);
});
