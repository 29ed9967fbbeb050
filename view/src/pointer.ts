// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
// Mouse, pen and fingers on the picture: drag, wheel and pinch move the camera, a tap picks a grain or, while a line is
// measured, sets its ends.

import type { App } from "./app";
import { pan, toPlace, zoomAt, type Camera } from "./camera";
import type { Frame } from "./frame";
import { Grid } from "./grid";
import type { Picture } from "./picture";

export class Pointer {
  measuring = false;
  private readonly down = new Map<number, [number, number]>();
  private moved = 0;
  private grid: { frame: Frame; grid: Grid } | null = null;

  constructor(private readonly app: App, private readonly picture: Picture, private readonly onMeasured: () => void) {
    const { canvas } = picture;
    canvas.addEventListener("pointerdown", (event) => this.press(event));
    canvas.addEventListener("pointermove", (event) => this.move(event));
    canvas.addEventListener("pointerup", (event) => this.release(event, true));
    canvas.addEventListener("pointercancel", (event) => this.release(event, false));
    canvas.addEventListener("wheel", (event) => this.wheel(event), { passive: false });
    canvas.addEventListener("dblclick", () => picture.fitTo());
  }

  measure(on: boolean): void {
    this.measuring = on;
    this.picture.pending = null;
    this.picture.canvas.classList.toggle("measuring", on);
    if (on) this.app.store.set({ line: null });
    this.picture.ask();
  }

  private place(event: PointerEvent | WheelEvent): [number, number] {
    const box = this.picture.canvas.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  }

  private set(camera: Camera): void {
    this.picture.move();
    this.app.store.set({ camera, fitted: false });
  }

  private press(event: PointerEvent): void {
    if (event.button !== 0) return;
    this.picture.canvas.setPointerCapture(event.pointerId);
    if (this.down.size === 0) this.moved = 0;
    this.down.set(event.pointerId, this.place(event));
  }

  private move(event: PointerEvent): void {
    const now = this.place(event);
    const before = this.down.get(event.pointerId);
    const viewport = this.picture.viewport();
    if (!before) {
      if (this.picture.pending) {
        const [x, y] = toPlace(this.picture.camera(), viewport, ...now);
        this.picture.pending = [this.picture.pending[0]!, this.picture.pending[1]!, x, y];
        this.picture.ask();
      }
      return;
    }
    const dx = now[0] - before[0];
    const dy = now[1] - before[1];
    this.moved += Math.hypot(dx, dy);
    if (this.down.size === 1) {
      if (this.moved > 4) this.set(pan(this.picture.camera(), viewport, dx, dy));
    } else {
      // Two fingers: their middle carries the picture, their distance is the zoom.
      const other = [...this.down].find(([id]) => id !== event.pointerId)![1];
      const from = Math.hypot(before[0] - other[0], before[1] - other[1]);
      const to = Math.hypot(now[0] - other[0], now[1] - other[1]);
      const moved = pan(this.picture.camera(), viewport, dx / 2, dy / 2);
      this.set(zoomAt(moved, viewport, (now[0] + other[0]) / 2, (now[1] + other[1]) / 2, to / Math.max(from, 1)));
    }
    this.down.set(event.pointerId, now);
  }

  private release(event: PointerEvent, meant: boolean): void {
    if (!this.down.delete(event.pointerId) || !meant || this.down.size > 0 || this.moved > 4) return;
    const [x, y] = toPlace(this.picture.camera(), this.picture.viewport(), ...this.place(event));
    if (!this.measuring) {
      const row = this.rowAt(x, y, event.pointerType === "mouse" ? 3 : 12);
      const id = row < 0 ? -1 : this.app.frame!.id[row]!;
      this.app.store.set(id < 0 ? { picked: -1, chase: false } : { picked: id, tab: "grain" });
    } else if (this.picture.pending) {
      const [fromX, fromY] = this.picture.pending as [number, number];
      this.measure(false);
      this.app.store.set({ line: [fromX, fromY, x, y] });
      this.onMeasured();
    } else {
      this.picture.pending = [x, y, x, y];
      this.picture.ask();
    }
  }

  private rowAt(x: number, y: number, pixels: number): number {
    const { frame } = this.app;
    if (!frame) return -1;
    if (this.grid?.frame !== frame) this.grid = { frame, grid: new Grid(frame) };
    return this.grid.grid.at(x, y, (pixels * this.picture.camera().width) / this.picture.viewport().width);
  }

  private wheel(event: WheelEvent): void {
    event.preventDefault();
    const lines = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? 16 : 1;
    const factor = Math.exp(-Math.max(-120, Math.min(120, event.deltaY * lines)) * 0.0022);
    this.set(zoomAt(this.picture.camera(), this.picture.viewport(), ...this.place(event), factor));
  }
}
