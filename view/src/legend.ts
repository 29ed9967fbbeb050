// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
// Legends at the top left: a bar of colours for each coloured layer, and what the widths of lines mean.

import { fractionOf, labelled, lookupTable, textOf, ticks, type Range } from "./colour";
import { forceScale, grainLook, layerLook } from "./look";
import { fontOf, lineWidth, type Sheet } from "./overlay";

const bar = { width: 190, height: 9 };

export function drawLegends(sheet: Sheet): void {
  const { context, app, viewport, inks } = sheet;
  const state = app.store.get();
  const left = 16;
  const width = Math.min(bar.width, viewport.width * 0.45);
  const entries: ((y: number) => number)[] = [];
  const look = state.grains === "hidden" ? null : grainLook(app);
  const layer = layerLook(app);
  if (look) {
    const title = labelled(look.field.label, look.field.unit(app.run));
    entries.push((y) => drawBar(sheet, left, y, width, title, look.range, look.map, look.field.counts === true));
  }
  if (layer) {
    const title = `${labelled(layer.field.label, layer.field.unit(app.run))}, last state`;
    entries.push((y) => drawBar(sheet, left, y, width, title, layer.range, layer.map, false));
  }
  if (state.contacts && app.frame?.normalForce && app.frame.contacts > 0) entries.push((y) => drawWidths(sheet, left, y));
  if (entries.length === 0) return;
  // Text stays readable where the picture runs under it.
  const tall = (look ? 42 : 0) + (layer ? 42 : 0) + (state.contacts ? 22 : 0);
  context.fillStyle = inks.paper;
  context.globalAlpha = 0.8;
  context.fillRect(left - 8, 6, width + 26, tall + 6);
  context.globalAlpha = 1;
  let y = 12;
  for (const entry of entries) y = entry(y);
}

function drawBar({ context, inks }: Sheet, x: number, y: number, width: number, title: string, range: Range, map: string, whole: boolean): number {
  context.font = fontOf(12);
  context.textBaseline = "top";
  context.textAlign = "left";
  context.fillStyle = inks.ink;
  context.fillText(title, x, y);
  const table = lookupTable(map);
  const gradient = context.createLinearGradient(x, 0, x + width, 0);
  for (let i = 0; i <= 32; i++) {
    const at = 4 * Math.round((i / 32) * 255);
    gradient.addColorStop(i / 32, `rgb(${table[at]}, ${table[at + 1]}, ${table[at + 2]})`);
  }
  context.fillStyle = gradient;
  context.fillRect(x, y + 16, width, bar.height);
  context.strokeStyle = inks.ink;
  context.fillStyle = inks.ink;
  context.lineWidth = 1;
  context.font = fontOf(11);
  const places = ticks(range, 4).filter((value) => !whole || Number.isInteger(value));
  for (const value of places) {
    const at = x + width * fractionOf(value, range);
    context.beginPath();
    context.moveTo(at, y + 16 + bar.height);
    context.lineTo(at, y + 19 + bar.height);
    context.stroke();
    context.textAlign = at < x + 8 ? "left" : at > x + width - 8 ? "center" : "center";
    context.fillText(textOf(value, 3), at, y + 20 + bar.height);
  }
  return y + 44;
}

function drawWidths({ context, app, inks, camera, viewport }: Sheet, x: number, y: number): number {
  const state = app.store.get();
  const scale = forceScale(app);
  const wide = Math.min(Math.max(lineWidth * app.run.grain_diameter * state.width * (viewport.width / camera.width), 0.8), 12);
  context.strokeStyle = inks.push;
  context.lineCap = "round";
  context.lineWidth = wide;
  context.beginPath();
  context.moveTo(x + 3, y + 8);
  context.lineTo(x + 29, y + 8);
  context.stroke();
  context.fillStyle = inks.ink;
  context.font = fontOf(12);
  context.textAlign = "left";
  context.textBaseline = "middle";
  let at = x + 40;
  const say = (text: string, colour: string): void => {
    context.fillStyle = colour;
    context.fillText(text, at, y + 8.5);
    at += context.measureText(text).width + 10;
  };
  say(`mean force ${textOf(scale, 3)} ${app.run.unit.force}`, inks.ink);
  if (app.frame!.normalForce!.some((force) => force < 0)) say("tension", inks.pull);
  if (state.sliding) say("sliding", inks.slide);
  return y + 22;
}
