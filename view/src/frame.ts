// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
// One moment of the run: views into its answer, and what is derived from it once.

import type { Wall } from "./api";
import { floats, integers, type Arrays } from "./arrays";
import type { Box } from "./camera";
import { geometryOf, type Geometry } from "./contact-geometry";

export const fixedFlag = 1;
export const baseFlag = 2;
export interface Frame {
  key: string;
  time: number;
  walls: Wall[];
  grains: number;
  contacts: number;
  id: Uint32Array;
  position: Float32Array;
  velocity: Float32Array;
  spin: Float32Array;
  radius: Float32Array;
  flags: Uint32Array;
  material: Uint32Array;
  pair: Uint32Array;
  normal: Float32Array;
  point: Float32Array;
  /** Null in frames of a deposition, which have no forces. */
  normalForce: Float32Array | null;
  tangentialForce: Float32Array | null;
  sliding: Uint32Array | null;
  bytes: number;
  /** Fields by name, computed when they are first asked for. */
  fields: Map<string, Float32Array>;
}

export function frameOf(key: string, answer: Arrays, period: number): Frame {
  const need = <T>(values: T | null, name: string): T => {
    if (!values) throw new Error(`frame ${key} has no ${name}`);
    return values;
  };
  const position = need(floats(answer, "position"), "position");
  const grains = position.length / 2;
  const pair = integers(answer, "pair") ?? new Uint32Array(0);
  const contacts = pair.length / 2;
  const walls = (answer.head["walls"] ?? []) as Wall[];
  const radius = need(floats(answer, "radius"), "radius");
  const given = { normal: floats(answer, "normal"), point: floats(answer, "point") };
  const { normal, point } = given.normal && given.point ? (given as Geometry) : geometryOf(pair, position, radius, walls, period);
  return {
    key,
    time: Number(answer.head["time"]),
    walls,
    grains,
    contacts,
    id: integers(answer, "id") ?? Uint32Array.from({ length: grains }, (_, i) => i),
    position,
    velocity: floats(answer, "velocity") ?? new Float32Array(2 * grains),
    spin: floats(answer, "spin") ?? new Float32Array(grains),
    radius,
    flags: integers(answer, "flags") ?? new Uint32Array(grains),
    material: integers(answer, "material") ?? new Uint32Array(grains),
    pair,
    normal,
    point,
    normalForce: floats(answer, "normal_force"),
    tangentialForce: floats(answer, "tangential_force"),
    sliding: integers(answer, "sliding"),
    bytes: answer.bytes,
    fields: new Map(),
  };
}

/** Row of the grain with this id, or -1. Ids ascend. */
export function rowOf(frame: Frame, id: number): number {
  let low = 0;
  let high = frame.grains - 1;
  while (low <= high) {
    const middle = (low + high) >> 1;
    const there = frame.id[middle]!;
    if (there === id) return middle;
    if (there < id) low = middle + 1;
    else high = middle - 1;
  }
  return -1;
}

/** The box around what is worth seeing: grains that touch something, and the walls that grains touch. */
export function extent(frame: Frame): Box | null {
  const touched = new Uint8Array(frame.grains);
  let some = false;
  for (let c = 0; c < frame.contacts; c++) {
    const first = frame.pair[2 * c]!;
    const second = frame.pair[2 * c + 1]!;
    const moving = !(frame.flags[first]! & fixedFlag) || (second < frame.grains && !(frame.flags[second]! & fixedFlag));
    if (!moving) continue;
    touched[first] = 1;
    if (second < frame.grains) touched[second] = 1;
    some = true;
  }
  const low: [number, number] = [Infinity, Infinity];
  const high: [number, number] = [-Infinity, -Infinity];
  for (let i = 0; i < frame.grains; i++) {
    if (some && !touched[i]) continue;
    const r = frame.radius[i]!;
    for (let a = 0; a < 2; a++) {
      const x = frame.position[2 * i + a]!;
      if (x - r < low[a]!) low[a] = x - r;
      if (x + r > high[a]!) high[a] = x + r;
    }
  }
  return low[0] < high[0] && low[1] < high[1] ? { low, high } : null;
}
