// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
// Fields of the grains that follow from the arrays of a frame. Compression is positive.

import type { Frame } from "./frame";
import { nearest } from "./nearest";

export function speed(frame: Frame): Float32Array {
  const values = new Float32Array(frame.grains);
  for (let i = 0; i < values.length; i++) values[i] = Math.hypot(frame.velocity[2 * i]!, frame.velocity[2 * i + 1]!);
  return values;
}

/** One component of an array with two columns. */
export function component(pairs: Float32Array, axis: 0 | 1): Float32Array {
  const values = new Float32Array(pairs.length / 2);
  for (let i = 0; i < values.length; i++) values[i] = pairs[2 * i + axis]!;
  return values;
}

/** Contacts of each grain whose normal force is positive; without forces, all that it has. Walls count. */
export function coordination(frame: Frame): Float32Array {
  const values = new Float32Array(frame.grains);
  for (let c = 0; c < frame.contacts; c++) {
    if (frame.normalForce && !(frame.normalForce[c]! > 0)) continue;
    values[frame.pair[2 * c]!]! += 1;
    const second = frame.pair[2 * c + 1]!;
    if (second < frame.grains) values[second]! += 1;
  }
  return values;
}

/** The largest normal force on each grain; 0 where it has none that pushes. */
export function largestForce(frame: Frame): Float32Array {
  const values = new Float32Array(frame.grains);
  if (!frame.normalForce) return values.fill(NaN);
  for (let c = 0; c < frame.contacts; c++) {
    const force = frame.normalForce[c]!;
    const first = frame.pair[2 * c]!;
    const second = frame.pair[2 * c + 1]!;
    if (force > values[first]!) values[first] = force;
    if (second < frame.grains && force > values[second]!) values[second] = force;
  }
  return values;
}

export interface GrainStress {
  xx: Float32Array;
  xy: Float32Array;
  yx: Float32Array;
  yy: Float32Array;
}

/**
 * Stress of each grain: the sum over its contacts of the force on it times the branch from the contact point to its
 * centre, over the area of its disc.
 */
export function grainStress(frame: Frame, period: number): GrainStress {
  const stress = {
    xx: new Float32Array(frame.grains),
    xy: new Float32Array(frame.grains),
    yx: new Float32Array(frame.grains),
    yy: new Float32Array(frame.grains),
  };
  const { position, pair, normal, point, radius } = frame;
  const add = (grain: number, fx: number, fy: number, x: number, y: number): void => {
    const area = Math.PI * radius[grain]! ** 2;
    const bx = nearest(position[2 * grain]! - x, period);
    const by = position[2 * grain + 1]! - y;
    stress.xx[grain]! += (fx * bx) / area;
    stress.xy[grain]! += (fx * by) / area;
    stress.yx[grain]! += (fy * bx) / area;
    stress.yy[grain]! += (fy * by) / area;
  };
  for (let c = 0; c < frame.contacts; c++) {
    const push = frame.normalForce?.[c] ?? NaN;
    const along = frame.tangentialForce?.[c] ?? 0;
    const nx = normal[2 * c]!;
    const ny = normal[2 * c + 1]!;
    const fx = push * nx - along * ny;
    const fy = push * ny + along * nx;
    const x = point[2 * c]!;
    const y = point[2 * c + 1]!;
    add(pair[2 * c]!, fx, fy, x, y);
    const second = pair[2 * c + 1]!;
    if (second < frame.grains) add(second, -fx, -fy, x, y);
  }
  return stress;
}

/** Half the trace of the stress of each grain. */
export function pressure(frame: Frame, period: number): Float32Array {
  const { xx, yy } = grainStress(frame, period);
  return xx.map((value, i) => (value + yy[i]!) / 2);
}

/** Half the difference of the principal stresses of each grain, of the symmetric part. */
export function shear(frame: Frame, period: number): Float32Array {
  const { xx, xy, yx, yy } = grainStress(frame, period);
  return xx.map((value, i) => Math.hypot((value - yy[i]!) / 2, (xy[i]! + yx[i]!) / 2));
}

/** Rows of the contacts of one grain. */
export function contactsOf(frame: Frame, grain: number): number[] {
  const rows: number[] = [];
  for (let c = 0; c < frame.contacts; c++) {
    if (frame.pair[2 * c] === grain || frame.pair[2 * c + 1] === grain) rows.push(c);
  }
  return rows;
}
