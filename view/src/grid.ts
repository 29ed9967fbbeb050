// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
// Which grain is at a place: grains sorted into square cells, when the first one is picked in a frame.

import type { Frame } from "./frame";

export class Grid {
  private readonly cell: number;
  private readonly columns: number;
  private readonly rows: number;
  private readonly low: [number, number] = [Infinity, Infinity];
  private readonly start: Uint32Array;
  private readonly order: Uint32Array;
  private readonly largest: number;

  constructor(private readonly frame: Frame) {
    const { position, radius, grains } = frame;
    let largest = 0;
    let sum = 0;
    const high = [-Infinity, -Infinity];
    for (let i = 0; i < grains; i++) {
      largest = Math.max(largest, radius[i]!);
      sum += radius[i]!;
      for (let a = 0; a < 2; a++) {
        this.low[a] = Math.min(this.low[a]!, position[2 * i + a]!);
        high[a] = Math.max(high[a]!, position[2 * i + a]!);
      }
    }
    this.largest = largest;
    const wide = Math.max(high[0]! - this.low[0], 0);
    const tall = Math.max(high[1]! - this.low[1], 0);
    // No more cells than a few for each grain, however far one of them has flown.
    this.cell = Math.max((2 * sum) / Math.max(grains, 1), Math.sqrt((wide * tall) / (4 * grains + 16)), (wide + tall) / (4 * grains + 16)) || 1;
    this.columns = Math.floor(wide / this.cell) + 1;
    this.rows = Math.floor(tall / this.cell) + 1;
    this.start = new Uint32Array(this.columns * this.rows + 1);
    const cells = new Uint32Array(grains);
    for (let i = 0; i < grains; i++) {
      cells[i] = this.column(position[2 * i]!) + this.columns * this.row(position[2 * i + 1]!);
      this.start[cells[i]! + 1]!++;
    }
    for (let c = 0; c < this.start.length - 1; c++) this.start[c + 1]! += this.start[c]!;
    this.order = new Uint32Array(grains);
    const next = this.start.slice();
    for (let i = 0; i < grains; i++) this.order[next[cells[i]!]!++] = i;
  }

  /** Row of the grain whose rim is nearest to, and no farther than `reach` from, a place; -1: none. */
  at(x: number, y: number, reach: number): number {
    const { position, radius } = this.frame;
    const far = this.largest + reach;
    let best = -1;
    let least = reach;
    for (let row = this.row(y - far); row <= this.row(y + far); row++) {
      for (let column = this.column(x - far); column <= this.column(x + far); column++) {
        const cell = column + this.columns * row;
        for (let k = this.start[cell]!; k < this.start[cell + 1]!; k++) {
          const i = this.order[k]!;
          const distance = Math.hypot(position[2 * i]! - x, position[2 * i + 1]! - y) - radius[i]!;
          if (distance < least) {
            least = distance;
            best = i;
          }
        }
      }
    }
    return best;
  }

  private column(x: number): number {
    return Math.min(Math.max(Math.floor((x - this.low[0]) / this.cell), 0), this.columns - 1);
  }

  private row(y: number): number {
    return Math.min(Math.max(Math.floor((y - this.low[1]) / this.cell), 0), this.rows - 1);
  }
}
