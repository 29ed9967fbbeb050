// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
// The JSON answers of docs/reference/view.md.

export interface Folder {
  kind: "run" | "sweep";
  name: string;
  repose_version: string;
}

export type Status = "running" | "finished" | "interrupted" | "failed";

export interface FrameEntry {
  key: string;
  time: number;
}

export interface Avalanche {
  start: number;
  end: number;
  size: number;
}

export interface Units {
  length: string;
  time: string;
  mass: string;
  force: string;
  speed: string;
  energy: string;
  pressure: string;
}

export interface Run {
  title: string;
  method: string;
  units: string;
  seed: number;
  dimension: number;
  status: Status;
  message: string;
  time: number;
  grains: number;
  released: number;
  lost: number;
  box: { low: [number, number]; high: [number, number]; periodic: boolean; period?: number };
  grain_diameter: number;
  grain_weight: number;
  gravity: number[];
  materials: string[];
  unit: Units;
  frames: FrameEntry[];
  force_scale: number | null;
  avalanches: Avalanche[];
  has: { series: boolean; base: boolean; fields: boolean; summary: boolean };
}

export interface Wall {
  name: string;
  from: [number, number];
  to: [number, number];
  /** Of the wall, where one wall has many lines or some are left out; else its place in the list. */
  number?: number;
}

export type ParameterValue = number | string | boolean | null;

export interface Point {
  name: string;
  values: Record<string, ParameterValue>;
  members: string[];
}

export interface Member {
  name: string;
  point: string;
  seed: number;
  status: "waiting" | "running" | "finished" | "failed";
  message: string;
  measures: Record<string, number | null>;
}

export interface Sweep {
  title: string;
  scene: string;
  seeds: number[] | number;
  parameters: string[];
  points: Point[];
  members: Member[];
  measures: { name: string; unit: string }[];
  means: Record<string, [number | null, number | null, number]>[];
}

/** Data of the server-sent event `change`: of a run the first four, of a sweep the others. */
export interface Change {
  status?: Status;
  frames?: number;
  rows?: number;
  time?: number;
  finished?: number;
  running?: number;
  failed?: number;
}
