// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
// Decoder of the binary answers (docs/reference/view.md, Arrays): views into the buffer, without copies.

export interface ArrayHead {
  type: "f32" | "u32" | "u16" | "u8";
  shape: number[];
  offset: number;
  unit?: string;
  meaning?: string;
  low?: number | number[];
  scale?: number | number[];
}

export interface NumberArray {
  values: Float32Array | Uint32Array;
  shape: number[];
  unit: string;
  meaning: string;
}

export interface Arrays {
  /** The text: `time`, `key`, `walls` and whatever else the answer states. */
  head: Record<string, unknown>;
  arrays: Map<string, NumberArray>;
  bytes: number;
}

const magic = 0x31565052; // "RPV1"

export function decodeArrays(buffer: ArrayBuffer): Arrays {
  const start = new DataView(buffer);
  if (buffer.byteLength < 8 || start.getUint32(0, true) !== magic) throw new Error("the answer is not of the form RPV1");
  const length = start.getUint32(4, true);
  if (8 + length > buffer.byteLength) throw new Error("the answer is cut off");
  const head = JSON.parse(new TextDecoder().decode(new Uint8Array(buffer, 8, length))) as Record<string, unknown>;
  const arrays = new Map<string, NumberArray>();
  let bytes = buffer.byteLength;
  for (const [name, entry] of Object.entries((head["arrays"] ?? {}) as Record<string, ArrayHead>)) {
    const values = decodeValues(buffer, 8 + length + entry.offset, entry, name);
    if (values.buffer !== buffer) bytes += values.byteLength;
    arrays.set(name, { values, shape: entry.shape, unit: entry.unit ?? "", meaning: entry.meaning ?? "" });
  }
  return { head, arrays, bytes };
}

function decodeValues(buffer: ArrayBuffer, at: number, entry: ArrayHead, name: string): Float32Array | Uint32Array {
  const count = entry.shape.reduce((product, n) => product * n, 1);
  const size = { f32: 4, u32: 4, u16: 2, u8: 1 }[entry.type];
  if (size === undefined) throw new Error(`${name}: unknown type ${String(entry.type)}`);
  if (at % 4 !== 0 || at + count * size > buffer.byteLength) throw new Error(`${name}: outside the answer`);
  if (entry.type === "f32") return new Float32Array(buffer, at, count);
  if (entry.type === "u32") return new Uint32Array(buffer, at, count);
  const steps = entry.type === "u16" ? new Uint16Array(buffer, at, count) : new Uint8Array(buffer, at, count);
  return scaled(steps, entry);
}

/** low + scale times the number; one pair of them, or one for each column. */
function scaled(steps: Uint16Array | Uint8Array, entry: ArrayHead): Float32Array {
  const columns = entry.shape.length > 1 ? entry.shape[entry.shape.length - 1]! : 1;
  const of = (value: number | number[] | undefined, absent: number, column: number): number =>
    Array.isArray(value) ? value[column] ?? absent : value ?? absent;
  const values = new Float32Array(steps.length);
  for (let column = 0; column < columns; column++) {
    const low = of(entry.low, 0, column);
    const scale = of(entry.scale, 1, column);
    for (let i = column; i < steps.length; i += columns) values[i] = low + scale * steps[i]!;
  }
  return values;
}

export function floats(arrays: Arrays, name: string): Float32Array | null {
  const found = arrays.arrays.get(name);
  if (!found) return null;
  return found.values instanceof Float32Array ? found.values : Float32Array.from(found.values);
}

/** Whole numbers; those that an exported page keeps as u16 or u8 have become floats. */
export function integers(arrays: Arrays, name: string): Uint32Array | null {
  const found = arrays.arrays.get(name);
  if (!found) return null;
  return found.values instanceof Uint32Array ? found.values : Uint32Array.from(found.values);
}
