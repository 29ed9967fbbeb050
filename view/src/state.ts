// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
// Everything that a link reproduces: which moment, seen how.

import { rounded, sevenDigits, type Camera } from "./camera";

export type GrainStyle = "filled" | "outline" | "hidden";
export type BaseChoice = "off" | "window" | "frame";
export type Theme = "auto" | "light" | "dark";

export interface ViewState {
  /** Member of a sweep; "" is the folder itself. */
  member: string;
  /** Key of a frame; "" follows the last. */
  frame: string;
  camera: Camera | null;
  /** The camera was fitted, not moved by hand: a growing heap may be fitted again. */
  fitted: boolean;
  grains: GrainStyle;
  /** A grain field; "" leaves grains plain. */
  field: string;
  /** A colour map; "" is that of the field. */
  map: string;
  range: [number, number] | null;
  log: boolean;
  contacts: boolean;
  /** Contacts with smaller forces, in mean forces, are not drawn. */
  threshold: number;
  /** Widths of lines, over the usual one. */
  width: number;
  sliding: boolean;
  /** A coarse-grained field; "" is none. */
  layer: string;
  layerMap: string;
  layerRange: [number, number] | null;
  /** Bars along the principal stresses. */
  bars: boolean;
  base: BaseChoice;
  shear: boolean;
  /** Series that are drawn; none chosen: the usual ones. */
  series: string[];
  /** Id of a grain, or -1. */
  picked: number;
  chase: boolean;
  /** Two places of a measured line. */
  line: number[] | null;
  theme: Theme;
  tab: string;
  /** In a sweep: the measure that is drawn, and over which parameter. */
  measure: string;
  over: string;
}

export const initialState: ViewState = {
  member: "",
  frame: "",
  camera: null,
  fitted: true,
  grains: "filled",
  field: "",
  map: "",
  range: null,
  log: false,
  contacts: true,
  threshold: 0,
  width: 1,
  sliding: false,
  layer: "",
  layerMap: "",
  layerRange: null,
  bars: false,
  base: "window",
  shear: false,
  series: [],
  picked: -1,
  chase: false,
  line: null,
  theme: "auto",
  tab: "picture",
  measure: "",
  over: "",
};

export type Changed = ReadonlySet<keyof ViewState>;

export class Store {
  private listeners: ((state: ViewState, changed: Changed) => void)[] = [];

  constructor(private state: ViewState) {}

  get(): Readonly<ViewState> {
    return this.state;
  }

  set(change: Partial<ViewState>): void {
    const changed = new Set<keyof ViewState>();
    // As the address will hold it.
    if (change.camera) change = { ...change, camera: rounded(change.camera) };
    if (change.line) change = { ...change, line: change.line.map(sevenDigits) };
    for (const key of Object.keys(change) as (keyof ViewState)[]) {
      if (JSON.stringify(change[key]) !== JSON.stringify(this.state[key])) changed.add(key);
    }
    if (changed.size === 0) return;
    this.state = { ...this.state, ...change };
    for (const listener of [...this.listeners]) listener(this.state, changed);
  }

  listen(listener: (state: ViewState, changed: Changed) => void): () => void {
    this.listeners.push(listener);
    return () => {
      this.listeners = this.listeners.filter((other) => other !== listener);
    };
  }
}
