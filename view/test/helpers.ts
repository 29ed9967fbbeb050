// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
// Answers and frames for tests.

import type { Wall } from "../src/api";
import { decodeArrays } from "../src/arrays";
import { frameOf, type Frame } from "../src/frame";

export type Data = Record<string, { type?: "f32" | "u32" | "u16" | "u8"; shape: number[]; values: number[]; low?: number | number[]; scale?: number | number[] }>;

/** The bytes of an answer, as docs/reference/view.md states them. */
export function encode(head: object, data: Data): ArrayBuffer {
  const arrays: Record<string, object> = {};
  const parts: { at: number; type: string; values: number[] }[] = [];
  let offset = 0;
  for (const [name, { type = "f32", shape, values, ...more }] of Object.entries(data)) {
    arrays[name] = { type, shape, offset, unit: "L", meaning: name, ...more };
    parts.push({ at: offset, type, values });
    const size = values.length * { f32: 4, u32: 4, u16: 2, u8: 1 }[type];
    offset += size + ((4 - (size % 4)) % 4);
  }
  let text = JSON.stringify({ ...head, arrays });
  let bytes = new TextEncoder().encode(text);
  text += " ".repeat((4 - (bytes.length % 4)) % 4);
  bytes = new TextEncoder().encode(text);
  const buffer = new ArrayBuffer(8 + bytes.length + offset);
  const view = new DataView(buffer);
  new Uint8Array(buffer).set(new TextEncoder().encode("RPV1"));
  view.setUint32(4, bytes.length, true);
  new Uint8Array(buffer).set(bytes, 8);
  for (const { at, type, values } of parts) {
    values.forEach((value, i) => {
      const start = 8 + bytes.length + at;
      if (type === "f32") view.setFloat32(start + 4 * i, value, true);
      else if (type === "u32") view.setUint32(start + 4 * i, value, true);
      else if (type === "u16") view.setUint16(start + 2 * i, value, true);
      else view.setUint8(start + i, value);
    });
  }
  return buffer;
}

export interface TestContact {
  pair: [number, number];
  normal: [number, number];
  point: [number, number];
  force?: number;
  tangential?: number;
}

/** A frame of these grains (x, y, radius) and contacts. */
export function frame(grains: [number, number, number][], contacts: TestContact[], flags: number[] = [], more: { walls?: Wall[]; period?: number; bare?: boolean } = {}): Frame {
  const { walls = [], period = 0, bare = false } = more;
  const n = grains.length;
  const m = contacts.length;
  const data: Data = {
    id: { type: "u32", shape: [n], values: grains.map((_, i) => 10 * i) },
    position: { shape: [n, 2], values: grains.flatMap(([x, y]) => [x, y]) },
    velocity: { shape: [n, 2], values: grains.flatMap(() => [3, 4]) },
    spin: { shape: [n], values: grains.map(() => 0) },
    radius: { shape: [n], values: grains.map(([, , r]) => r) },
    flags: { type: "u32", shape: [n], values: grains.map((_, i) => flags[i] ?? 0) },
    material: { type: "u32", shape: [n], values: grains.map(() => 0) },
    pair: { type: "u32", shape: [m, 2], values: contacts.flatMap((one) => one.pair) },
    normal: { shape: [m, 2], values: contacts.flatMap((one) => one.normal) },
    point: { shape: [m, 2], values: contacts.flatMap((one) => one.point) },
  };
  if (bare) {
    delete data["normal"];
    delete data["point"];
  }
  if (contacts.every((one) => one.force !== undefined)) {
    data["normal_force"] = { shape: [m], values: contacts.map((one) => one.force!) };
    data["tangential_force"] = { shape: [m], values: contacts.map((one) => one.tangential ?? 0) };
    data["sliding"] = { type: "u32", shape: [m], values: contacts.map(() => 0) };
  }
  return frameOf("last", decodeArrays(encode({ time: 1, key: "last", walls }, data)), period);
}

export const wall = (k: number): number => 4294967295 - k;

export function near(actual: number, expected: number, tolerance = 1e-6): void {
  if (!(Math.abs(actual - expected) <= tolerance * Math.max(1, Math.abs(expected)))) throw new Error(`${actual} is not ${expected}`);
}
