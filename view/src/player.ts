// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
// Playing the frames, so many a second, no faster than they arrive; the next ones are loaded ahead.

import type { App } from "./app";

export const speeds = [1, 2, 5, 10, 20, 30];

export class Player {
  playing = false;
  speed = 10;
  private request = 0;
  private since = 0;

  constructor(private readonly app: App, private readonly changed: () => void) {
    app.signal.addEventListener("abort", () => window.cancelAnimationFrame(this.request));
  }

  toggle(on = !this.playing): void {
    if (on === this.playing || (on && this.app.run.frames.length < 2)) return;
    this.playing = on;
    if (on) {
      if (this.app.index() >= this.app.run.frames.length - 1) this.app.goTo(0);
      this.since = performance.now();
      this.request = window.requestAnimationFrame((now) => this.tick(now));
    } else window.cancelAnimationFrame(this.request);
    this.changed();
  }

  step(by: number): void {
    this.toggle(false);
    this.app.goTo(this.app.index() + by);
  }

  /** Load the frames after the shown one. */
  ahead(): void {
    const { run, frames, frame } = this.app;
    if (!frame || !frames.roomFor(4, frame.bytes)) return;
    const at = this.app.index();
    for (const entry of run.frames.slice(at + 1, at + 1 + (this.playing ? 3 : 1))) frames.load(entry.key).catch(() => undefined);
  }

  private tick(now: number): void {
    if (!this.playing) return;
    const at = this.app.index();
    const arrived = this.app.frame?.key === this.app.chosenKey();
    if (at >= this.app.run.frames.length - 1) return this.toggle(false);
    if (arrived && now - this.since >= 1000 / this.speed) {
      this.since = now;
      this.app.goTo(at + 1);
    }
    this.request = window.requestAnimationFrame((next) => this.tick(next));
  }
}
