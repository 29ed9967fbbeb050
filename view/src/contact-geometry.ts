// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
// Normals and points of contacts where the answer leaves them out, as exported pages do: from centres, radii and walls.

import type { Wall } from "./api";
import { nearest } from "./nearest";

export interface Geometry {
  normal: Float32Array;
  point: Float32Array;
}

/** The second partner of a contact with wall k is `firstWall` - k. */
export const firstWall = 4294967295;

/** The lines of wall k: those with its number, else the one at that place in the list. */
export function linesOf(walls: Wall[], k: number): Wall[] {
  const numbered = walls.filter((wall) => wall.number === k);
  if (numbered.length > 0) return numbered;
  return walls.some((wall) => wall.number !== undefined) ? [] : walls[k] ? [walls[k]] : [];
}

/** Grain pairs touch in the middle of their overlap, walls at the place nearest to the centre. */
export function geometryOf(pair: Uint32Array, position: Float32Array, radius: Float32Array, walls: Wall[], period: number): Geometry {
  const contacts = pair.length / 2;
  const geometry = { normal: new Float32Array(2 * contacts), point: new Float32Array(2 * contacts) };
  const lines = new Map<number, Wall[]>();
  for (let c = 0; c < contacts; c++) {
    const first = pair[2 * c]!;
    const second = pair[2 * c + 1]!;
    const x = position[2 * first]!;
    const y = position[2 * first + 1]!;
    let lever = radius[first]!;
    let dx: number;
    let dy: number;
    if (second < radius.length) {
      dx = nearest(x - position[2 * second]!, period);
      dy = y - position[2 * second + 1]!;
      lever += (Math.hypot(dx, dy) - lever - radius[second]!) / 2;
    } else {
      const k = firstWall - second;
      if (!lines.has(k)) lines.set(k, linesOf(walls, k));
      [dx, dy] = fromLines(lines.get(k)!, x, y);
    }
    const distance = Math.hypot(dx, dy) || 1;
    geometry.normal[2 * c] = dx / distance;
    geometry.normal[2 * c + 1] = dy / distance;
    geometry.point[2 * c] = x - (lever * dx) / distance;
    geometry.point[2 * c + 1] = y - (lever * dy) / distance;
  }
  return geometry;
}

/** From the nearest place of these lines to a centre. */
function fromLines(lines: Wall[], x: number, y: number): [number, number] {
  let best: [number, number] = [0, 1];
  let least = Infinity;
  for (const { from, to } of lines) {
    const along = [to[0] - from[0], to[1] - from[1]] as const;
    const square = along[0] ** 2 + along[1] ** 2 || 1;
    const part = Math.min(Math.max(((x - from[0]) * along[0] + (y - from[1]) * along[1]) / square, 0), 1);
    const dx = x - from[0] - part * along[0];
    const dy = y - from[1] - part * along[1];
    const distance = Math.hypot(dx, dy);
    if (distance < least) {
      least = distance;
      best = [dx, dy];
    }
  }
  return best;
}
