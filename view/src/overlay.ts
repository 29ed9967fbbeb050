// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
// What lies over the grains: walls, sides of a periodic box, principal directions, the picked grain, the measured
// line, legends and the scale.

import type { App } from "./app";
import { drawBaseStrip } from "./base-strip";
import { angleAndLength, scaleOf, toPixel, type Camera, type Viewport } from "./camera";
import { textOf, tickStep } from "./colour";
import { principal } from "./field-grid";
import { rowOf } from "./frame";
import { period } from "./grain-fields";
import { drawLegends } from "./legend";
import type { Inks } from "./theme";

export const fontOf = (size: number): string => `${size}px "Helvetica Neue", "Segoe UI", Arial, "Liberation Sans", sans-serif`;

/** Width of the line of a mean force, in grain diameters. */
export const lineWidth = 0.1;

/** Text that stays readable over grains and bars. */
export function haloText({ context, inks }: Sheet, text: string, x: number, y: number): void {
  context.lineJoin = "round";
  context.strokeStyle = inks.paper;
  context.lineWidth = 3.5;
  context.globalAlpha = 0.85;
  context.strokeText(text, x, y);
  context.globalAlpha = 1;
  context.fillText(text, x, y);
}

export interface Sheet {
  context: CanvasRenderingContext2D;
  app: App;
  camera: Camera;
  viewport: Viewport;
  inks: Inks;
  at: (x: number, y: number) => [number, number];
}

export function drawOverlay(
  context: CanvasRenderingContext2D,
  app: App,
  camera: Camera,
  viewport: Viewport,
  inks: Inks,
  pending: number[] | null,
): void {
  const sheet: Sheet = { context, app, camera, viewport, inks, at: (x, y) => toPixel(camera, viewport, x, y) };
  const state = app.store.get();
  context.save();
  context.beginPath();
  context.rect(0, 0, viewport.width, viewport.height - viewport.strip);
  context.clip();
  drawWalls(sheet);
  if (state.bars) drawPrincipal(sheet);
  drawPicked(sheet);
  const line = pending ?? state.line;
  if (line) drawMeasured(sheet, line);
  context.restore();
  drawBaseStrip(sheet);
  drawLegends(sheet);
  drawScale(sheet);
}

function drawWalls({ context, app, viewport, inks, at }: Sheet): void {
  context.strokeStyle = inks.wall;
  context.lineWidth = 1.6;
  context.lineCap = "round";
  for (const wall of app.frame?.walls ?? []) {
    context.beginPath();
    context.moveTo(...at(...wall.from));
    context.lineTo(...at(...wall.to));
    context.stroke();
  }
  const { box } = app.run;
  if (box.periodic) {
    context.globalAlpha = 0.4;
    context.lineWidth = 1;
    context.setLineDash([2, 5]);
    for (const side of [-0.5, 0.5]) {
      const [across] = at((box.low[0] + box.high[0]) / 2 + side * period(app.run), 0);
      context.beginPath();
      context.moveTo(across, 0);
      context.lineTo(across, viewport.height);
      context.stroke();
    }
  }
  context.globalAlpha = 1;
  context.setLineDash([]);
}

/** Bars along the principal stresses, as long as these are; the minor ones thinner. */
function drawPrincipal({ context, app, camera, viewport, inks, at }: Sheet): void {
  const grid = app.fields;
  const xx = grid?.arrays.get("stress_xx");
  const xy = grid?.arrays.get("stress_xy");
  const yy = grid?.arrays.get("stress_yy");
  if (!grid || !xx || !xy || !yy) return;
  const scale = scaleOf(camera, viewport);
  const stride = Math.max(1, Math.ceil(17 / (grid.cell * scale)));
  let largest = 0;
  for (let i = 0; i < xx.length; i++) largest = Math.max(largest, principal(xx[i]!, xy[i]!, yy[i]!).major || 0);
  if (largest <= 0) return;
  const longest = 0.5 * stride * grid.cell * scale;
  const minors = new Path2D();
  const majors = new Path2D();
  const bar = (path: Path2D, [x, y]: [number, number], angle: number, length: number): void => {
    const dx = Math.cos(angle) * length;
    const dy = -Math.sin(angle) * length;
    path.moveTo(x - dx, y - dy);
    path.lineTo(x + dx, y + dy);
  };
  for (let row = stride >> 1; row < grid.rows; row += stride) {
    for (let column = stride >> 1; column < grid.columns; column += stride) {
      const i = column + grid.columns * row;
      if (grid.solid && grid.solid[i]! < 0.3) continue;
      const { major, minor, angle } = principal(xx[i]!, xy[i]!, yy[i]!);
      if (!(major > 0.005 * largest)) continue;
      const place = at(grid.x[column]!, grid.y[row]!);
      // The square root keeps the bars of small stresses readable.
      bar(majors, place, angle, longest * Math.sqrt(major / largest));
      if (minor > 0) bar(minors, place, angle + Math.PI / 2, longest * Math.sqrt(minor / largest));
    }
  }
  context.lineCap = "butt";
  for (const [path, wide] of [[minors, 1], [majors, 1.8]] as const) {
    context.strokeStyle = inks.paper;
    context.globalAlpha = 0.7;
    context.lineWidth = wide + 1.6;
    context.stroke(path);
    context.globalAlpha = 1;
    context.strokeStyle = inks.ink;
    context.lineWidth = wide;
    context.stroke(path);
  }
}

function drawPicked({ context, app, camera, viewport, inks, at }: Sheet): void {
  const { picked } = app.store.get();
  const row = picked >= 0 && app.frame ? rowOf(app.frame, picked) : -1;
  if (row < 0) return;
  const [x, y] = at(app.frame!.position[2 * row]!, app.frame!.position[2 * row + 1]!);
  const radius = Math.max(app.frame!.radius[row]! * scaleOf(camera, viewport), 3) + 1.5;
  for (const [colour, wide] of [[inks.paper, 4.5], [inks.mark, 2.2]] as const) {
    context.strokeStyle = colour;
    context.lineWidth = wide;
    context.beginPath();
    context.arc(x, y, radius, 0, 2 * Math.PI);
    context.stroke();
  }
}

function drawMeasured({ context, app, inks, at }: Sheet, line: number[]): void {
  const from = at(line[0]!, line[1]!);
  const to = at(line[2]!, line[3]!);
  const low = from[1] > to[1] ? from : to;
  const other = low === from ? to : from;
  const { degrees, length } = angleAndLength(line);
  context.strokeStyle = inks.mark;
  context.lineWidth = 1.6;
  context.setLineDash([]);
  context.beginPath();
  context.moveTo(...from);
  context.lineTo(...to);
  context.stroke();
  context.lineWidth = 1;
  context.setLineDash([3, 3]);
  const side = other[0] >= low[0] ? 1 : -1;
  const reach = Math.min(Math.hypot(to[0] - from[0], to[1] - from[1]) * 0.35, 70);
  context.beginPath();
  context.moveTo(low[0], low[1]);
  context.lineTo(low[0] + side * (reach + 14), low[1]);
  context.stroke();
  context.setLineDash([]);
  const turn = (degrees * Math.PI) / 180;
  context.beginPath();
  if (side > 0) context.arc(low[0], low[1], reach, -turn, 0);
  else context.arc(low[0], low[1], reach, Math.PI, Math.PI + turn);
  context.stroke();
  for (const [x, y] of [from, to]) {
    context.fillStyle = inks.paper;
    context.beginPath();
    context.arc(x, y, 3.5, 0, 2 * Math.PI);
    context.fill();
    context.stroke();
  }
  const text = `${degrees.toFixed(1)}°   ${textOf(length, 4)} ${app.run.unit.length}`;
  context.font = fontOf(13);
  const wide = context.measureText(text).width + 12;
  const x = (from[0] + to[0]) / 2;
  const y = Math.min((from[1] + to[1]) / 2, Math.min(from[1], to[1]) + 1000) - 18;
  context.fillStyle = inks.paper;
  context.globalAlpha = 0.88;
  context.fillRect(x - wide / 2, y - 11, wide, 21);
  context.globalAlpha = 1;
  context.fillStyle = inks.mark;
  context.textAlign = "center";
  context.textBaseline = "middle";
  context.fillText(text, x, y);
}

/** A bar of a round length, at the top right. */
function drawScale(sheet: Sheet): void {
  const { context, app, camera, viewport, inks } = sheet;
  const scale = scaleOf(camera, viewport);
  const length = tickStep((viewport.width * 0.16) / scale, 1);
  const right = viewport.width - 16;
  const y = 34;
  const text = `${textOf(length)} ${app.run.unit.length}`;
  context.font = fontOf(12);
  const left = right - length * scale;
  for (const [colour, wide] of [[inks.paper, 4.5], [inks.ink, 1.3]] as const) {
    context.strokeStyle = colour;
    context.lineWidth = wide;
    context.beginPath();
    context.moveTo(left, y - 4);
    context.lineTo(left, y);
    context.lineTo(right, y);
    context.lineTo(right, y - 4);
    context.stroke();
  }
  context.fillStyle = inks.ink;
  context.textAlign = "center";
  context.textBaseline = "bottom";
  haloText(sheet, text, (left + right) / 2, y - 5);
}
