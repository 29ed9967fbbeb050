// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
// What the state means for the moment that is shown: values, ranges and maps of the layers.

import type { App } from "./app";
import { automaticRange, type Range } from "./colour";
import { layerFields, layerValues, withinHeap, type LayerField } from "./field-grid";
import { grainField, period, valuesOf, type GrainField } from "./grain-fields";

export interface GrainLook {
  field: GrainField;
  values: Float32Array;
  range: Range;
  map: string;
}

export interface LayerLook {
  field: LayerField;
  values: Float32Array;
  range: Range;
  map: string;
}

const known = new WeakMap<Float32Array, Map<string, Range>>();

function rangeOf(values: Float32Array, choice: { signed?: boolean; counts?: boolean; log?: boolean }, counted = values): Range {
  const key = JSON.stringify(choice);
  let ranges = known.get(values);
  if (!ranges) known.set(values, (ranges = new Map()));
  let range = ranges.get(key);
  if (!range) ranges.set(key, (range = automaticRange(counted, choice)));
  return range;
}

function fixedOr(fixed: [number, number] | null, log: boolean, automatic: () => Range): Range {
  if (!fixed) return automatic();
  return { low: fixed[0], high: fixed[1], log: log && fixed[0] > 0 };
}

/** Whether a logarithm of the field has a meaning. */
export function canLog(field: GrainField): boolean {
  return !field.signed && !field.counts && field.name !== "height";
}

export function grainLook(app: App): GrainLook | null {
  const state = app.store.get();
  const field = grainField(state.field);
  if (!field || !app.frame || (field.needsForces && !app.frame.normalForce)) return null;
  const values = valuesOf(app.frame, field, period(app.run));
  const log = state.log && canLog(field);
  const range = fixedOr(state.range, log, () => rangeOf(values, { signed: field.signed === true, counts: field.counts === true, log }));
  return { field, values, range, map: state.map || (field.signed ? "coolwarm" : "viridis") };
}

export function layerLook(app: App): LayerLook | null {
  const state = app.store.get();
  const field = layerFields.find((one) => one.name === state.layer);
  if (!field || !app.fields) return null;
  const values = layerValues(app.fields, field);
  if (!values) return null;
  const grid = app.fields;
  const range = fixedOr(state.layerRange, false, () => rangeOf(values, { signed: field.signed === true }, withinHeap(grid, values)));
  return { field, values, range, map: state.layerMap || (field.signed ? "coolwarm" : "cividis") };
}

/** The force that is one mean force: that of the last state, or where there is none that of this moment. */
export function forceScale(app: App): number {
  if (app.run.force_scale && app.run.force_scale > 0) return app.run.force_scale;
  const forces = app.frame?.normalForce;
  if (!forces) return 1;
  let sum = 0;
  let count = 0;
  for (const force of forces) {
    if (force > 0) {
      sum += force;
      count++;
    }
  }
  return count > 0 ? sum / count : 1;
}
