// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
// The force network as segments: from centre to centre, or from a centre to the point on the wall.

import type { Frame } from "./frame";
import { nearest } from "./nearest";

export interface Segments {
  count: number;
  /** x, y of both ends of each. */
  ends: Float32Array;
  /** Force over the force scale, and 1 if the contact slides. */
  marks: Float32Array;
  /** Segments are in classes of ascending force; where each class starts, and after the last one the count. */
  starts: Uint32Array;
}

/** Classes of the size of a force: four for each factor of two, around 1. */
const classes = 128;

function classOf(force: number): number {
  return Math.min(Math.max(Math.floor(4 * Math.log2(Math.abs(force))) + 96, 0), classes - 1);
}

/** The first segment from which on there are all those of at least this force, and few weaker ones. */
export function firstFrom(segments: Segments, force: number): number {
  return force > 0 ? segments.starts[classOf(force)]! : 0;
}

/** Contacts whose force is at least `threshold` times the scale, pulling ones too. Without forces: all, each of force 1. */
export function networkOf(frame: Frame, period: number, scale: number, threshold: number): Segments {
  const { pair, position, point, normalForce, sliding } = frame;
  let room = frame.contacts;
  let ends = new Float32Array(4 * room);
  let marks = new Float32Array(2 * room);
  let count = 0;
  const put = (x: number, y: number, dx: number, dy: number, force: number, slides: number): void => {
    if (count === room) {
      room = Math.ceil(room * 1.1) + 16;
      const longer = new Float32Array(4 * room);
      longer.set(ends);
      ends = longer;
      const more = new Float32Array(2 * room);
      more.set(marks);
      marks = more;
    }
    ends[4 * count] = x;
    ends[4 * count + 1] = y;
    ends[4 * count + 2] = x + dx;
    ends[4 * count + 3] = y + dy;
    marks[2 * count] = force;
    marks[2 * count + 1] = slides;
    count++;
  };
  for (let c = 0; c < frame.contacts; c++) {
    const force = normalForce ? normalForce[c]! / scale : 1;
    if (normalForce && (force === 0 || Math.abs(force) < threshold)) continue;
    const first = pair[2 * c]!;
    const second = pair[2 * c + 1]!;
    const slides = sliding ? sliding[c]! : 0;
    const x = position[2 * first]!;
    const y = position[2 * first + 1]!;
    const wall = second >= frame.grains;
    const endX = wall ? point[2 * c]! : position[2 * second]!;
    const endY = wall ? point[2 * c + 1]! : position[2 * second + 1]!;
    const dx = nearest(endX - x, period);
    put(x, y, dx, endY - y, force, slides);
    // Across the sides of a periodic box the line shows on both.
    if (period > 0 && Math.abs(dx - (endX - x)) > period / 2) put(endX - dx, y, dx, endY - y, force, slides);
  }
  return inClasses(count, ends, marks);
}

/** Sorted by counting: the strong ones are drawn last, and weak ones can be drawn in a simpler way. */
function inClasses(count: number, ends: Float32Array, marks: Float32Array): Segments {
  const starts = new Uint32Array(classes + 1);
  const kinds = new Uint8Array(count);
  for (let i = 0; i < count; i++) {
    kinds[i] = classOf(marks[2 * i]!);
    starts[kinds[i]! + 1]!++;
  }
  for (let k = 0; k < classes; k++) starts[k + 1]! += starts[k]!;
  const next = starts.slice();
  const sorted = { count, ends: new Float32Array(4 * count), marks: new Float32Array(2 * count), starts };
  for (let i = 0; i < count; i++) {
    const to = next[kinds[i]!]!++;
    for (let part = 0; part < 4; part++) sorted.ends[4 * to + part] = ends[4 * i + part]!;
    sorted.marks[2 * to] = marks[2 * i]!;
    sorted.marks[2 * to + 1] = marks[2 * i + 1]!;
  }
  return sorted;
}
