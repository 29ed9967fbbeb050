// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
// The strip beneath the picture: a bar for each grain of the base, at its place, and curves of theories.

import type { App } from "./app";
import { frameProfile, windowProfile, type Profile } from "./base-profile";
import { scaleOf } from "./camera";
import { roundUp, textOf, tickStep } from "./colour";
import { fontOf, haloText, type Sheet } from "./overlay";

export function profileOf(app: App): Profile | null {
  const { base } = app.store.get();
  if (base === "off") return null;
  const mean = base === "window" && app.base ? kept("window", app.base, () => windowProfile(app.base!)) : null;
  if (mean || !app.frame) return mean;
  // Floors without base grains have no means, but the forces of each moment.
  const weighs = app.run.gravity.some((part) => part !== 0) && app.run.grain_weight > 0;
  return kept("frame", app.frame, () => frameProfile(app.frame!, weighs ? app.run.grain_weight : 1, weighs ? "grain weights" : app.run.unit.force));
}

const profiles = new Map<string, { of: object; profile: Profile | null }>();

function kept(name: string, of: object, make: () => Profile | null): Profile | null {
  let found = profiles.get(name);
  if (found?.of !== of) {
    found = { of, profile: make() };
    profiles.set(name, found);
  }
  return found.profile;
}

export function stripHeight(app: App, height: number): number {
  return profileOf(app) ? Math.round(Math.min(Math.max(0.2 * height, 64), 130)) : 0;
}

export function drawBaseStrip(sheet: Sheet): void {
  const { context, app, viewport, inks, at } = sheet;
  const profile = profileOf(app);
  if (!profile) return;
  const { shear } = app.store.get();
  const top = viewport.height - viewport.strip + 22;
  const bottom = viewport.height - 18;
  let low = 0;
  let high = 0;
  for (const values of [profile.normal, ...profile.theories.map((theory) => theory.y), ...(shear ? [profile.shear] : [])]) {
    for (const value of values) {
      if (value > high) high = value;
      if (value < low) low = value;
    }
  }
  high = roundUp(high);
  low = low < -0.01 * high ? -roundUp(-low) : 0;
  const y = (value: number): number => bottom - ((value - low) / (high - low)) * (bottom - top);
  context.save();
  context.fillStyle = inks.paper;
  context.fillRect(0, viewport.height - viewport.strip, viewport.width, viewport.strip);
  drawBars(sheet, profile, y);
  const line = (x: Float32Array, values: Float32Array, colour: string, dash: number[]): void => {
    context.strokeStyle = colour;
    context.lineWidth = 1.6;
    context.setLineDash(dash);
    context.beginPath();
    let open = false;
    for (let i = 0; i < x.length; i++) {
      if (Number.isNaN(values[i])) {
        open = false;
        continue;
      }
      const [across] = at(x[i]!, 0);
      if (open) context.lineTo(across, y(values[i]!));
      else context.moveTo(across, y(values[i]!));
      open = true;
    }
    context.stroke();
    context.setLineDash([]);
  };
  profile.theories.forEach((theory, i) => line(theory.x, theory.y, inks.lines[i % inks.lines.length]!, []));
  if (shear) line(profile.x, profile.shear, inks.pull, [4, 2]);
  drawAxes(sheet, y, low, high, bottom);
  drawNames(sheet, profile, shear);
  context.restore();
}

function drawBars({ context, app, viewport, inks, camera, at }: Sheet, profile: Profile, y: (value: number) => number): void {
  const spacing = profile.x.length > 1 ? Math.abs(profile.x[profile.x.length - 1]! - profile.x[0]!) / (profile.x.length - 1) : app.run.grain_diameter;
  const wide = Math.max(0.72 * Math.min(spacing, 1.5 * app.run.grain_diameter) * scaleOf(camera, viewport), 0.8);
  context.fillStyle = inks.push;
  context.globalAlpha = 0.62;
  const zero = y(0);
  for (let i = 0; i < profile.x.length; i++) {
    const [x] = at(profile.x[i]!, 0);
    if (x < -wide || x > viewport.width + wide) continue;
    const end = y(profile.normal[i]!);
    if (Math.abs(end - zero) > 0.2) context.fillRect(x - wide / 2, Math.min(end, zero), wide, Math.abs(end - zero));
  }
  context.globalAlpha = 1;
}

function drawAxes(sheet: Sheet, y: (value: number) => number, low: number, high: number, bottom: number): void {
  const { context, viewport, inks, camera, at } = sheet;
  context.fillStyle = inks.ink;
  context.font = fontOf(11);
  context.beginPath();
  context.moveTo(0, y(0));
  context.lineTo(viewport.width, y(0));
  context.textAlign = "left";
  context.textBaseline = "middle";
  const step = tickStep(high - low, 2);
  for (let value = Math.ceil(low / step) * step; value <= high * 1.001; value += step) {
    context.moveTo(0, y(value));
    context.lineTo(5, y(value));
    if (value !== 0) haloText(sheet, textOf(value, 3), 8, y(value) + 0.5);
  }
  context.textAlign = "center";
  context.textBaseline = "top";
  const wide = tickStep(camera.width, viewport.width / 110);
  const first = Math.ceil((camera.x - camera.width / 2) / wide) * wide;
  for (let k = 0; first + k * wide < camera.x + camera.width / 2; k++) {
    const x = Math.abs(first + k * wide) < 1e-9 * wide ? 0 : first + k * wide;
    const [across] = at(x, 0);
    context.moveTo(across, bottom);
    context.lineTo(across, bottom + 4);
    if (across > 12 && across < viewport.width - 12) context.fillText(textOf(x, 4), across, bottom + 5);
  }
  context.strokeStyle = inks.faint;
  context.lineWidth = 1;
  context.stroke();
}

function drawNames({ context, viewport, inks }: Sheet, profile: Profile, shear: boolean): void {
  const y = viewport.height - viewport.strip + 9;
  context.font = fontOf(11);
  context.textBaseline = "middle";
  context.textAlign = "left";
  let x = 16;
  const say = (text: string, colour: string): void => {
    context.fillStyle = colour;
    context.fillText(text, x, y);
    x += context.measureText(text).width + 12;
  };
  say(`force on the base (${profile.unit})${viewport.width > 520 ? `, ${profile.when}` : ""}`, inks.ink);
  if (shear) say("shear", inks.pull);
  profile.theories.forEach((theory, i) => say(theory.name, inks.lines[i % inks.lines.length]!));
}
