// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
// The coarse-grained fields of the last state, what is derived from them, and their principal directions.

import type { Run } from "./api";
import { floats, type Arrays } from "./arrays";

export interface FieldGrid {
  columns: number;
  rows: number;
  x: Float32Array;
  y: Float32Array;
  cell: number;
  low: [number, number];
  high: [number, number];
  solid: Float32Array | null;
  arrays: Map<string, Float32Array>;
}

export interface LayerField {
  name: string;
  label: string;
  unit: (run: Run) => string;
  signed?: boolean;
  /** From the arrays of these names, cell by cell. */
  from: string[];
  compute: (...values: number[]) => number;
}

const own = (value: number): number => value;
const pressureUnit = (run: Run): string => run.unit.pressure;

export const layerFields: LayerField[] = [
  { name: "pressure", label: "pressure", unit: pressureUnit, from: ["stress_xx", "stress_yy"], compute: (xx, yy) => (xx! + yy!) / 2 },
  {
    name: "shear",
    label: "shear stress",
    unit: pressureUnit,
    from: ["stress_xx", "stress_xy", "stress_yy"],
    compute: (xx, xy, yy) => Math.hypot((xx! - yy!) / 2, xy!),
  },
  { name: "stress_xx", label: "stress xx", unit: pressureUnit, from: ["stress_xx"], compute: own },
  { name: "stress_yy", label: "stress yy", unit: pressureUnit, from: ["stress_yy"], compute: own },
  { name: "stress_xy", label: "stress xy", unit: pressureUnit, from: ["stress_xy"], compute: own, signed: true },
  { name: "solid_fraction", label: "solid fraction", unit: () => "", from: ["solid_fraction"], compute: own },
  { name: "coordination", label: "coordination", unit: () => "", from: ["coordination"], compute: own },
  {
    name: "speed",
    label: "mean speed",
    unit: (run) => run.unit.speed,
    from: ["velocity_x", "velocity_y"],
    compute: (x, y) => Math.hypot(x!, y!),
  },
];

export function fieldGrid(answer: Arrays): FieldGrid {
  const x = floats(answer, "x");
  const y = floats(answer, "y");
  if (!x || !y || x.length === 0 || y.length === 0) throw new Error("the fields have no cells");
  const cell = Number(answer.head["cell"]) || (x.length > 1 ? x[1]! - x[0]! : y.length > 1 ? y[1]! - y[0]! : 1);
  const arrays = new Map<string, Float32Array>();
  for (const name of answer.arrays.keys()) if (name !== "x" && name !== "y") arrays.set(name, floats(answer, name)!);
  return {
    columns: x.length,
    rows: y.length,
    x,
    y,
    cell,
    low: [x[0]! - cell / 2, y[0]! - cell / 2],
    high: [x[x.length - 1]! + cell / 2, y[y.length - 1]! + cell / 2],
    solid: arrays.get("solid_fraction") ?? null,
    arrays,
  };
}

export function layerValues(grid: FieldGrid, field: LayerField): Float32Array | null {
  const known = grid.arrays.get(`= ${field.name}`);
  if (known) return known;
  const parts = field.from.map((name) => grid.arrays.get(name));
  if (parts.some((part) => !part)) return null;
  const values = new Float32Array(grid.columns * grid.rows);
  for (let i = 0; i < values.length; i++) values[i] = field.compute(...parts.map((part) => part![i]!));
  grid.arrays.set(`= ${field.name}`, values);
  return values;
}

/** Values in cells that are mostly heap: a range for colours should not count the empty ones. */
export function withinHeap(grid: FieldGrid, values: Float32Array): Float32Array {
  return grid.solid ? values.filter((_, i) => grid.solid![i]! > 0.3) : values;
}

/** Principal stresses of a symmetric tensor: major, minor, and the angle of the major one to x in radians. */
export function principal(xx: number, xy: number, yy: number): { major: number; minor: number; angle: number } {
  const mean = (xx + yy) / 2;
  const radius = Math.hypot((xx - yy) / 2, xy);
  return { major: mean + radius, minor: mean - radius, angle: 0.5 * Math.atan2(2 * xy, xx - yy) };
}
