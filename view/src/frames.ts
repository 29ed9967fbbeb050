// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
// Frames that were loaded, the latest used ones within a number of bytes.

import { frameOf, type Frame } from "./frame";
import type { Source } from "./source";

export class FrameStore {
  private readonly held = new Map<string, Frame>();
  private readonly coming = new Map<string, Promise<Frame>>();
  private bytes = 0;

  constructor(private readonly source: Source, private readonly prefix: string, private readonly period: number, private readonly budget = 384 * 2 ** 20) {}

  get(key: string): Frame | null {
    return this.held.get(key) ?? null;
  }

  load(key: string): Promise<Frame> {
    const held = this.held.get(key);
    if (held) {
      this.held.delete(key);
      this.held.set(key, held);
      return Promise.resolve(held);
    }
    const coming = this.coming.get(key);
    if (coming) return coming;
    const request: Promise<Frame> = this.source
      .arrays(`${this.prefix}frame/${key}`)
      .then((answer) => {
        const frame = frameOf(key, answer, this.period);
        // Dropped in the meantime, as a last frame that has changed: give it to who asked, do not keep it.
        if (this.coming.get(key) === request) this.keep(key, frame);
        return frame;
      })
      .finally(() => {
        if (this.coming.get(key) === request) this.coming.delete(key);
      });
    this.coming.set(key, request);
    return request;
  }

  drop(key: string): void {
    this.bytes -= this.held.get(key)?.bytes ?? 0;
    this.held.delete(key);
    this.coming.delete(key);
  }

  clear(): void {
    for (const key of [...this.held.keys(), ...this.coming.keys()]) this.drop(key);
  }

  /** Whether frames of this size can be loaded ahead without pushing each other out. */
  roomFor(frames: number, bytes: number): boolean {
    return frames * bytes < this.budget / 2;
  }

  private keep(key: string, frame: Frame): void {
    this.held.set(key, frame);
    this.bytes += frame.bytes;
    for (const [old, other] of this.held) {
      if (this.bytes <= this.budget || old === key) break;
      this.held.delete(old);
      this.bytes -= other.bytes;
    }
  }
}
