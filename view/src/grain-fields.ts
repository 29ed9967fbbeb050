// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
// The fields by which grains are coloured: one line each.

import type { Run } from "./api";
import { component, coordination, largestForce, pressure, shear, speed } from "./derived";
import type { Frame } from "./frame";

export interface GrainField {
  name: string;
  label: string;
  unit: (run: Run) => string;
  compute: (frame: Frame, period: number) => Float32Array;
  /** Values of both signs: the range is symmetric, the map diverges. */
  signed?: boolean;
  /** Whole numbers. */
  counts?: boolean;
  needsForces?: boolean;
}

export const grainFields: GrainField[] = [
  { name: "speed", label: "speed", unit: (run) => run.unit.speed, compute: speed },
  { name: "pressure", label: "pressure", unit: (run) => run.unit.pressure, compute: pressure, needsForces: true },
  { name: "shear", label: "shear stress", unit: (run) => run.unit.pressure, compute: shear, needsForces: true },
  { name: "force", label: "largest force", unit: (run) => run.unit.force, compute: largestForce, needsForces: true },
  { name: "coordination", label: "coordination", unit: () => "", compute: coordination, counts: true },
  { name: "spin", label: "spin", unit: (run) => `1/${run.unit.time}`, compute: (frame) => frame.spin, signed: true },
  { name: "velocity_x", label: "velocity x", unit: (run) => run.unit.speed, compute: (frame) => component(frame.velocity, 0), signed: true },
  { name: "velocity_y", label: "velocity y", unit: (run) => run.unit.speed, compute: (frame) => component(frame.velocity, 1), signed: true },
  { name: "height", label: "height", unit: (run) => run.unit.length, compute: (frame) => component(frame.position, 1) },
  { name: "radius", label: "radius", unit: (run) => run.unit.length, compute: (frame) => frame.radius },
  { name: "id", label: "id", unit: () => "", compute: (frame) => Float32Array.from(frame.id), counts: true },
  { name: "material", label: "material", unit: () => "", compute: (frame) => Float32Array.from(frame.material), counts: true },
];

export function grainField(name: string): GrainField | null {
  return grainFields.find((field) => field.name === name) ?? null;
}

export function valuesOf(frame: Frame, field: GrainField, period: number): Float32Array {
  let values = frame.fields.get(field.name);
  if (!values) {
    values = field.compute(frame, period);
    frame.fields.set(field.name, values);
  }
  return values;
}

export function period(run: Run): number {
  return run.box.periodic ? run.box.period ?? run.box.high[0] - run.box.low[0] : 0;
}
