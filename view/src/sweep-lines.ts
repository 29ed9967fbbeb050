// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
// Means of a measure over one parameter: one line for each setting of the others.

import type { ParameterValue, Sweep } from "./api";
import { textOf } from "./colour";

export interface MeanPoint {
  x: number;
  mean: number;
  error: number;
  members: number;
  /** Values of the single members. */
  values: number[];
  /** Place in `sweep.points`. */
  index: number;
}

export interface MeanLine {
  label: string;
  points: MeanPoint[];
}

export interface MeanLines {
  lines: MeanLine[];
  /** Names on the x axis where the parameter is not a number: x is their place. */
  names: string[] | null;
}

export function valueText(value: ParameterValue | undefined): string {
  if (typeof value === "number") return textOf(value, 6);
  return value === null || value === undefined ? "–" : String(value);
}

/** "contact.normal.stiffness" as "stiffness" where that is enough to tell it from the others. */
export function shortKey(key: string, all: string[]): string {
  const parts = key.split(".");
  for (let n = 1; n < parts.length; n++) {
    const end = parts.slice(-n).join(".");
    if (all.every((other) => other === key || !other.endsWith(`.${end}`))) return end.replaceAll("_", " ");
  }
  return key.replaceAll("_", " ");
}

export function meanLines(sweep: Sweep, measure: string, over: string): MeanLines {
  const others = sweep.parameters.filter((key) => key !== over);
  const values = sweep.points.map((point) => point.values[over]);
  const numeric = values.every((value) => typeof value === "number");
  const names = numeric ? null : [...new Set(values.map(valueText))];
  const members = new Map(sweep.members.map((member) => [member.name, member]));
  const lines = new Map<string, MeanPoint[]>();
  sweep.points.forEach((point, index) => {
    const [mean, error, count] = sweep.means[index]?.[measure] ?? [null, null, 0];
    if (mean === null || !Number.isFinite(mean)) return;
    const label = others.map((key) => `${shortKey(key, sweep.parameters)} ${valueText(point.values[key])}`).join(", ");
    const x = names ? names.indexOf(valueText(point.values[over])) : (point.values[over] as number);
    const single = point.members.map((name) => members.get(name)?.measures[measure]).filter((value): value is number => typeof value === "number");
    const line = lines.get(label) ?? [];
    line.push({ x, mean, error: error ?? NaN, members: count, values: single, index });
    lines.set(label, line);
  });
  return {
    lines: [...lines].map(([label, points]) => ({ label, points: points.sort((a, b) => a.x - b.x) })),
    names,
  };
}

/** All x in ascending order, and each line's means at them: the form of uPlot. */
export function aligned(lines: MeanLine[]): { x: number[]; means: (number | null | undefined)[][] } {
  const x = [...new Set(lines.flatMap((line) => line.points.map((point) => point.x)))].sort((a, b) => a - b);
  // Undefined, unlike null, leaves no gap in uPlot's lines.
  return { x, means: lines.map((line) => x.map((at) => line.points.find((point) => point.x === at)?.mean)) };
}
