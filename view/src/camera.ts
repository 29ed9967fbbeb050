// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
// Which part of the plane is seen. Pixels are those of CSS, y downward; lengths are those of the run, y upward.

export interface Camera {
  /** What is in the middle of the picture. */
  x: number;
  y: number;
  /** Length that the picture is wide. */
  width: number;
}

export interface Viewport {
  width: number;
  height: number;
  /** Height of the strip at the bottom that belongs to the base forces. */
  strip: number;
}

export interface Box {
  low: [number, number];
  high: [number, number];
}

/** Pixels per length. */
export function scaleOf(camera: Camera, viewport: Viewport): number {
  return viewport.width / camera.width;
}

export function toPixel(camera: Camera, viewport: Viewport, x: number, y: number): [number, number] {
  const scale = scaleOf(camera, viewport);
  return [viewport.width / 2 + (x - camera.x) * scale, (viewport.height - viewport.strip) / 2 - (y - camera.y) * scale];
}

export function toPlace(camera: Camera, viewport: Viewport, pixelX: number, pixelY: number): [number, number] {
  const scale = scaleOf(camera, viewport);
  return [camera.x + (pixelX - viewport.width / 2) / scale, camera.y - (pixelY - (viewport.height - viewport.strip) / 2) / scale];
}

/**
 * The smallest view that shows the box with a margin around it, as a fraction of the picture. Above the strip of base
 * forces the box stands at the bottom, else it is in the middle.
 */
export function fit(box: Box, viewport: Viewport, margin = 0.05): Camera {
  const wide = Math.max(box.high[0] - box.low[0], 1e-9);
  const high = Math.max(box.high[1] - box.low[1], 1e-9);
  const across = Math.max(viewport.width, 1);
  const up = Math.max(viewport.height - viewport.strip, 1);
  const width = Math.max(wide, (high * across) / up) / (1 - 2 * margin);
  const low = box.low[1] - (margin * up * width) / across;
  const y = viewport.strip > 0 ? low + (up * width) / across / 2 : (box.low[1] + box.high[1]) / 2;
  return { x: (box.low[0] + box.high[0]) / 2, y, width };
}

/** Zoom by a factor (> 1: closer), with the place under the pixel fixed. */
export function zoomAt(camera: Camera, viewport: Viewport, pixelX: number, pixelY: number, factor: number): Camera {
  const [x, y] = toPlace(camera, viewport, pixelX, pixelY);
  return { x: x + (camera.x - x) / factor, y: y + (camera.y - y) / factor, width: camera.width / factor };
}

/** Move what is seen by pixels, as a dragging hand does. */
export function pan(camera: Camera, viewport: Viewport, dx: number, dy: number): Camera {
  const scale = scaleOf(camera, viewport);
  return { ...camera, x: camera.x - dx / scale, y: camera.y + dy / scale };
}

export function union(a: Box | null, b: Box | null): Box | null {
  if (!a || !b) return a ?? b;
  return {
    low: [Math.min(a.low[0], b.low[0]), Math.min(a.low[1], b.low[1])],
    high: [Math.max(a.high[0], b.high[0]), Math.max(a.high[1], b.high[1])],
  };
}

export function sevenDigits(value: number): number {
  return Number(value.toPrecision(7));
}

export function rounded(camera: Camera): Camera {
  return { x: sevenDigits(camera.x), y: sevenDigits(camera.y), width: sevenDigits(camera.width) };
}

/** Degrees to the horizontal in [0, 90], and length, of the line between two places. */
export function angleAndLength(line: readonly number[]): { degrees: number; length: number } {
  const dx = line[2]! - line[0]!;
  const dy = line[3]! - line[1]!;
  return { degrees: (Math.atan2(Math.abs(dy), Math.abs(dx)) * 180) / Math.PI, length: Math.hypot(dx, dy) };
}
