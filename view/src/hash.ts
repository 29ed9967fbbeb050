// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
// The state as the fragment of the address, "#field=pressure&threshold=0.5": what is as usual is left out, what cannot
// be read is ignored.

import { sevenDigits } from "./camera";
import { initialState, type ViewState } from "./state";

interface Codec<T> {
  write: (value: T) => string;
  /** Undefined: the text is not such a value. */
  read: (text: string) => T | undefined;
}

const number = (text: string): number | undefined => {
  const value = Number(text);
  return text !== "" && Number.isFinite(value) ? value : undefined;
};

const numbers = (count: number) => (text: string): number[] | undefined => {
  const parts = text.split(",").map(number);
  return parts.length === count && parts.every((part) => part !== undefined) ? (parts as number[]) : undefined;
};

const short = (value: number): string => String(sevenDigits(value));
const text: Codec<string> = { write: (value) => value, read: (value) => value };
const flag: Codec<boolean> = { write: (value) => (value ? "1" : "0"), read: (value) => (value === "1" ? true : value === "0" ? false : undefined) };
const real: Codec<number> = { write: short, read: number };
const oneOf = <T extends string>(...names: T[]): Codec<T> => ({ write: (value) => value, read: (value) => names.find((name) => name === value) });
const range: Codec<[number, number] | null> = {
  write: (value) => (value ? value.map(short).join(",") : ""),
  read: (value) => numbers(2)(value) as [number, number] | undefined,
};

const codecs: { [Key in keyof ViewState]: Codec<ViewState[Key]> } = {
  member: text,
  frame: text,
  camera: {
    write: (value) => (value ? [value.x, value.y, value.width].map(short).join(",") : ""),
    read: (value) => {
      const read = numbers(3)(value);
      return read && read[2]! > 0 ? { x: read[0]!, y: read[1]!, width: read[2]! } : undefined;
    },
  },
  fitted: flag,
  grains: oneOf("filled", "outline", "hidden"),
  field: text,
  map: text,
  range,
  log: flag,
  contacts: flag,
  threshold: real,
  width: real,
  sliding: flag,
  layer: text,
  layerMap: text,
  layerRange: range,
  bars: flag,
  base: oneOf("off", "window", "frame"),
  shear: flag,
  series: { write: (value) => value.join(","), read: (value) => value.split(",").filter((name) => name !== "") },
  picked: { write: String, read: (value) => (/^\d+$/.test(value) ? Number(value) : undefined) },
  chase: flag,
  line: { write: (value) => (value ? value.map(short).join(",") : ""), read: numbers(4) },
  theme: oneOf("auto", "light", "dark"),
  tab: text,
  measure: text,
  over: text,
};

export function toHash(state: ViewState): string {
  const parts: string[] = [];
  const add = <Key extends keyof ViewState>(key: Key): void => {
    const value = codecs[key].write(state[key]);
    if (value !== codecs[key].write(initialState[key])) parts.push(`${key}=${encodeURIComponent(value).replaceAll("%2C", ",")}`);
  };
  (Object.keys(codecs) as (keyof ViewState)[]).forEach(add);
  return parts.join("&");
}

export function fromHash(hash: string): ViewState {
  const state: ViewState = { ...initialState };
  const take = <Key extends keyof ViewState>(key: Key, value: string): void => {
    const read = codecs[key].read(value);
    if (read !== undefined) state[key] = read;
  };
  for (const part of hash.replace(/^#/, "").split("&")) {
    const at = part.indexOf("=");
    const key = part.slice(0, at);
    if (at < 1 || !Object.hasOwn(codecs, key)) continue;
    let value = part.slice(at + 1);
    try {
      value = decodeURIComponent(value);
    } catch {
      continue;
    }
    take(key as keyof ViewState, value);
  }
  return state;
}
