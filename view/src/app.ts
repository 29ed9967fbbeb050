// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
// What the parts of a run's page share: the run, the moment that is shown, and how to hear of changes.

import type { Run } from "./api";
import type { Arrays } from "./arrays";
import type { FieldGrid } from "./field-grid";
import type { Frame } from "./frame";
import { FrameStore } from "./frames";
import { period } from "./grain-fields";
import type { Notices } from "./notices";
import type { Source } from "./source";
import type { Store } from "./state";

/** `frame`: another moment is shown. `run`: api/run was read again. `data`: series, base or fields arrived. */
export type Event = "frame" | "run" | "data";

export class App {
  frame: Frame | null = null;
  series: Arrays | null = null;
  base: Arrays | null = null;
  fields: FieldGrid | null = null;
  readonly frames: FrameStore;
  private wanted = "";
  private showing = false;
  private readonly listeners: Record<Event, (() => void)[]> = { frame: [], run: [], data: [] };

  constructor(
    readonly source: Source,
    /** "api/", or "api/members/NAME/". */
    readonly prefix: string,
    public run: Run,
    readonly store: Store,
    readonly notices: Notices,
    /** Ends with the page of this run: listeners on the window take it. */
    readonly signal: AbortSignal,
  ) {
    this.frames = new FrameStore(source, prefix, period(run));
  }

  on(event: Event, call: () => void): void {
    this.listeners[event].push(call);
  }

  emit(event: Event): void {
    for (const call of this.listeners[event]) call();
  }

  lastKey(): string {
    return this.run.frames[this.run.frames.length - 1]?.key ?? "";
  }

  /** Key of the frame that the state asks for. */
  chosenKey(): string {
    const { frame } = this.store.get();
    return frame !== "" && this.run.frames.some((entry) => entry.key === frame) ? frame : this.lastKey();
  }

  /** Its place among the frames. */
  index(): number {
    const key = this.chosenKey();
    return this.run.frames.findIndex((entry) => entry.key === key);
  }

  /** Ask for the frame at a place; the last one is followed as more arrive. */
  goTo(index: number): void {
    const last = this.run.frames.length - 1;
    const place = Math.round(Math.min(Math.max(index, 0), last));
    this.store.set({ frame: place >= last ? "" : this.run.frames[place]?.key ?? "" });
  }

  goToTime(time: number): void {
    let best = 0;
    this.run.frames.forEach((entry, i) => {
      if (Math.abs(entry.time - time) < Math.abs(this.run.frames[best]!.time - time)) best = i;
    });
    this.goTo(best);
  }

  /** Show the chosen frame: loads one at a time, always the one that is wanted by then. */
  async show(): Promise<void> {
    this.wanted = this.chosenKey();
    if (this.showing || this.wanted === "") return;
    this.showing = true;
    try {
      for (;;) {
        const key = this.wanted;
        const frame = await this.frames.load(key);
        if (this.signal.aborted) return;
        if (frame !== this.frame) {
          this.frame = frame;
          this.emit("frame");
        }
        this.notices.clear("frame");
        if (this.wanted === key) break;
      }
    } catch (error) {
      this.notices.problem("frame", error);
    } finally {
      this.showing = false;
    }
  }
}
