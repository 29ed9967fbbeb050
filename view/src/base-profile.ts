// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
// Forces on the base along x: means over the window as the server has them, or those of one moment from its contacts.

import { floats, type Arrays } from "./arrays";
import { baseFlag, type Frame } from "./frame";

export interface Profile {
  x: Float32Array;
  /** Downward. */
  normal: Float32Array;
  /** To the right. */
  shear: Float32Array;
  theories: { name: string; x: Float32Array; y: Float32Array }[];
  unit: string;
  when: string;
}

/** Without the prefix, and with numbers of four digits. */
function theoryName(name: string): string {
  return name.slice("theory:".length).replaceAll("_", " ").replace(/\d+\.\d{2,}/g, (digits) => String(Number(Number(digits).toPrecision(4))));
}

export function windowProfile(base: Arrays): Profile | null {
  const x = floats(base, "x");
  const normal = floats(base, "normal");
  if (!x || !normal || !normal.some((force) => force !== 0 && !Number.isNaN(force))) return null;
  const theoryX = floats(base, "theory_x") ?? x;
  const theories = [...base.arrays.keys()]
    .filter((name) => name.startsWith("theory:"))
    .map((name) => ({ name: theoryName(name), x: theoryX, y: floats(base, name)! }));
  return {
    x,
    normal,
    shear: floats(base, "shear") ?? new Float32Array(x.length),
    theories,
    unit: base.arrays.get("normal")!.unit || String(base.head["unit"] ?? "grain weights"),
    when: "mean over the window",
  };
}

/**
 * Forces of the contacts on base grains, and at the points where grains rest on walls that face up. `weight` is the
 * unit of force.
 */
export function frameProfile(frame: Frame, weight: number, unit: string): Profile | null {
  const { normalForce, tangentialForce, pair, normal, point, flags, position } = frame;
  if (!normalForce) return null;
  const down = new Map<number, [number, number]>();
  const x: number[] = [];
  const pushes: number[] = [];
  const shears: number[] = [];
  for (let c = 0; c < frame.contacts; c++) {
    const first = pair[2 * c]!;
    const second = pair[2 * c + 1]!;
    const along = tangentialForce?.[c] ?? 0;
    const fx = normalForce[c]! * normal[2 * c]! - along * normal[2 * c + 1]!;
    const fy = normalForce[c]! * normal[2 * c + 1]! + along * normal[2 * c]!;
    if (second >= frame.grains) {
      if (normal[2 * c + 1]! < 0.7 || flags[first]! & baseFlag) continue;
      x.push(point[2 * c]!);
      pushes.push(fy / weight);
      shears.push(-fx / weight);
      continue;
    }
    const one = (flags[first]! & baseFlag) !== 0;
    const other = (flags[second]! & baseFlag) !== 0;
    if (one === other) continue;
    const sum = down.get(one ? first : second) ?? [0, 0];
    // On the second partner acts the opposite.
    const sign = one ? 1 : -1;
    sum[0] -= sign * fy;
    sum[1] += sign * fx;
    down.set(one ? first : second, sum);
  }
  for (let i = 0; i < frame.grains; i++) {
    if (!(flags[i]! & baseFlag)) continue;
    const [normalSum, shearSum] = down.get(i) ?? [0, 0];
    x.push(position[2 * i]!);
    pushes.push(normalSum / weight);
    shears.push(shearSum / weight);
  }
  if (x.length === 0) return null;
  const order = x.map((_, i) => i).sort((a, b) => x[a]! - x[b]!);
  const sorted = (values: number[]): Float32Array => Float32Array.from(order, (i) => values[i]!);
  return { x: sorted(x), normal: sorted(pushes), shear: sorted(shears), theories: [], unit, when: "at this time" };
}
