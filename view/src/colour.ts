// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
// Colour maps, ranges of values, and round numbers for legends and axes.

import { stopsOfMaps } from "./colour-maps";

export const mapNames = Object.keys(stopsOfMaps);

/** 256 colours of a map as RGBA bytes, linear between its stops. */
export function lookupTable(name: string): Uint8Array {
  const stops = stopsOfMaps[name] ?? stopsOfMaps["viridis"]!;
  const last = stops.length / 6 - 1;
  const part = (stop: number, channel: number): number => parseInt(stops.slice(6 * stop + 2 * channel, 6 * stop + 2 * channel + 2), 16);
  const table = new Uint8Array(4 * 256);
  for (let i = 0; i < 256; i++) {
    const at = (i / 255) * last;
    const low = Math.min(Math.floor(at), last - 1);
    for (let channel = 0; channel < 3; channel++) {
      table[4 * i + channel] = Math.round(part(low, channel) + (at - low) * (part(low + 1, channel) - part(low, channel)));
    }
    table[4 * i + 3] = 255;
  }
  return table;
}

export interface Range {
  low: number;
  high: number;
  log: boolean;
}

export interface RangeChoice {
  signed?: boolean;
  counts?: boolean;
  log?: boolean;
}

/**
 * A range for these values, with round ends: from the first to the 99.5th percentile of a sample of them, from zero if
 * they are all positive, symmetric if they have both signs by nature. Undefined values do not count.
 */
export function automaticRange(values: ArrayLike<number>, choice: RangeChoice): Range {
  const stride = Math.max(1, Math.floor(values.length / 20000));
  const sample: number[] = [];
  for (let i = 0; i < values.length; i += stride) if (Number.isFinite(values[i])) sample.push(values[i]!);
  sample.sort((a, b) => a - b);
  const log = choice.log === true;
  if (sample.length === 0) return { low: log ? 0.1 : 0, high: 1, log };
  const at = (fraction: number): number => sample[Math.min(sample.length - 1, Math.floor(fraction * sample.length))]!;
  const largest = sample[sample.length - 1]!;
  if (choice.counts) return { low: Math.min(0, sample[0]!), high: Math.max(largest, 1), log: false };
  if (choice.signed) {
    const most = roundUp(Math.max(Math.abs(at(0.005)), Math.abs(at(0.995))) || Math.max(Math.abs(sample[0]!), largest));
    return { low: -most, high: most, log: false };
  }
  if (log) {
    const positive = sample.filter((value) => value > 0);
    const high = roundUp(positive[Math.floor(0.995 * (positive.length - 1))] ?? 1);
    const low = Math.max(positive[Math.floor(0.05 * positive.length)] ?? high / 10, high * 1e-5);
    return { low: Math.min(10 ** Math.floor(Math.log10(low)), high / 10), high, log };
  }
  const top = at(0.995) > 0 ? at(0.995) : largest;
  if (sample[0]! >= 0 && at(0.01) < 0.5 * top) return { low: 0, high: roundUp(top), log };
  const low = at(0.005);
  const step = tickStep(top - low || Math.abs(top) || 1, 4);
  return { low: Math.floor(low / step) * step, high: Math.ceil(top / step + 1e-9) * step, log };
}

/** The next of 1, 1.5, 2, 3, 4, 5, 6, 8 times a power of ten; 1 for zero. */
export function roundUp(value: number): number {
  if (!(value > 0)) return 1;
  const power = 10 ** Math.floor(Math.log10(value));
  for (const step of [1, 1.5, 2, 3, 4, 5, 6, 8, 10]) if (value <= step * power * (1 + 1e-6)) return step * power;
  return value;
}

/** Distance of about `count` ticks over a length: 1, 2 or 5 times a power of ten. */
export function tickStep(length: number, count: number): number {
  const rough = Math.max(length, 1e-300) / Math.max(count, 1);
  const power = 10 ** Math.floor(Math.log10(rough));
  const left = rough / power;
  return power * (left < 1.5 ? 1 : left < 3.5 ? 2 : left < 7.5 ? 5 : 10);
}

export function ticks(range: Range, count: number): number[] {
  const found: number[] = [];
  if (range.log && range.low > 0) {
    const first = Math.ceil(Math.log10(range.low) - 1e-9);
    const last = Math.floor(Math.log10(range.high) + 1e-9);
    const stride = Math.max(1, Math.ceil((last - first + 1) / (count + 1)));
    for (let power = first; power <= last; power += stride) found.push(10 ** power);
    return found;
  }
  const step = tickStep(range.high - range.low, count);
  for (let k = Math.ceil(range.low / step - 1e-6); k * step <= range.high + 1e-6 * step; k++) found.push(k * step || 0);
  return found;
}

/** Where a value lies in the range: 0 low, 1 high. */
export function fractionOf(value: number, range: Range): number {
  if (range.log && range.low > 0) return Math.log(value / range.low) / Math.log(range.high / range.low);
  return (value - range.low) / (range.high - range.low);
}

/** A number for people: `digits` significant ones, a proper minus, powers of ten as 3×10⁻⁴. */
export function textOf(value: number | null | undefined, digits = 4): string {
  if (value === null || value === undefined || Number.isNaN(value)) return "–";
  if (!Number.isFinite(value)) return value > 0 ? "∞" : "−∞";
  if (value === 0) return "0";
  const size = Math.abs(value);
  if (Number.isInteger(value) && size < 1e7) return String(value).replace("-", "−");
  if (size >= 1e-3 && size < 1e6) return String(Number(value.toPrecision(digits))).replace("-", "−");
  const [mantissa, exponent] = value.toExponential(digits - 1).split("e") as [string, string];
  const raised = String(Number(exponent)).replace(/[-0-9]/g, (sign) => "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"["-0123456789".indexOf(sign)]!);
  const front = String(Number(mantissa)).replace("-", "−");
  return front === "1" ? `10${raised}` : `${front}×10${raised}`;
}

/** "pressure (m g/d)", or without a unit "pressure". */
export function labelled(label: string, unit: string): string {
  return unit && unit !== "1" ? `${label} (${unit})` : label;
}
