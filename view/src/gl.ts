// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
// The few helpers that raw WebGL2 needs: programs, and arrays as textures that shaders read by row.

/** Texels in a row of a texture that holds an array. */
export const textureWidth = 2048;

/** Shader text that finds element `i` of such a texture. */
export const cellFunction = `ivec2 cell(int i) { return ivec2(i & ${textureWidth - 1}, i >> ${Math.log2(textureWidth)}); }`;

export function makeProgram(gl: WebGL2RenderingContext, vertex: string, fragment: string): WebGLProgram {
  const program = gl.createProgram()!;
  for (const [type, text] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]] as const) {
    const shader = gl.createShader(type)!;
    gl.shaderSource(shader, `#version 300 es\nprecision highp float;\nprecision highp int;\nprecision highp usampler2D;\n${text}`);
    gl.compileShader(shader);
    gl.attachShader(program, shader);
    gl.deleteShader(shader);
    if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS) && !gl.isContextLost()) {
      throw new Error(`shader: ${gl.getShaderInfoLog(shader) ?? ""}`);
    }
  }
  gl.linkProgram(program);
  if (!gl.getProgramParameter(program, gl.LINK_STATUS) && !gl.isContextLost()) {
    throw new Error(`program: ${gl.getProgramInfoLog(program) ?? ""}`);
  }
  return program;
}

/** Locations of the uniforms of a program, asked once. */
export function uniforms(gl: WebGL2RenderingContext, program: WebGLProgram): (name: string) => WebGLUniformLocation | null {
  const known = new Map<string, WebGLUniformLocation | null>();
  return (name) => {
    if (!known.has(name)) known.set(name, gl.getUniformLocation(program, name));
    return known.get(name)!;
  };
}

type Kind = "r32f" | "rg32f" | "rgba32f" | "r32ui";

/** An array on the graphics card, one texel an element. */
export class ArrayTexture {
  readonly texture: WebGLTexture;
  private rows = 0;
  private held: ArrayLike<number> | null = null;

  constructor(private readonly gl: WebGL2RenderingContext, private readonly kind: Kind) {
    this.texture = gl.createTexture()!;
  }

  /** Uploads straight from the array; the same array is not uploaded again. */
  upload(values: Float32Array | Uint32Array, count: number): void {
    if (this.held === values) return;
    this.held = values;
    const gl = this.gl;
    const { internal, format, type, parts } = {
      r32f: { internal: gl.R32F, format: gl.RED, type: gl.FLOAT, parts: 1 },
      rg32f: { internal: gl.RG32F, format: gl.RG, type: gl.FLOAT, parts: 2 },
      rgba32f: { internal: gl.RGBA32F, format: gl.RGBA, type: gl.FLOAT, parts: 4 },
      r32ui: { internal: gl.R32UI, format: gl.RED_INTEGER, type: gl.UNSIGNED_INT, parts: 1 },
    }[this.kind];
    gl.bindTexture(gl.TEXTURE_2D, this.texture);
    const rows = Math.max(1, Math.ceil(count / textureWidth));
    if (rows > this.rows || rows < this.rows / 4) {
      this.rows = rows;
      gl.texImage2D(gl.TEXTURE_2D, 0, internal, textureWidth, rows, 0, format, type, null);
      gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
      gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
    }
    const full = Math.floor(count / textureWidth);
    const left = count - full * textureWidth;
    if (full > 0) gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, textureWidth, full, format, type, values, 0);
    if (left > 0) gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, full, left, 1, format, type, values, full * textureWidth * parts);
  }

  bind(unit: number): void {
    this.gl.activeTexture(this.gl.TEXTURE0 + unit);
    this.gl.bindTexture(this.gl.TEXTURE_2D, this.texture);
  }

  /** Upload again at the next call, whatever it holds. */
  forget(): void {
    this.held = null;
    this.rows = 0;
  }
}

/** A colour map as a texture of 256 colours. */
export class MapTexture {
  private readonly texture: WebGLTexture;
  private held = "";

  constructor(private readonly gl: WebGL2RenderingContext) {
    this.texture = gl.createTexture()!;
  }

  bind(unit: number, name: string, table: (name: string) => Uint8Array): void {
    const gl = this.gl;
    gl.activeTexture(gl.TEXTURE0 + unit);
    gl.bindTexture(gl.TEXTURE_2D, this.texture);
    if (this.held === name) return;
    this.held = name;
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA8, 256, 1, 0, gl.RGBA, gl.UNSIGNED_BYTE, table(name));
    for (const parameter of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T]) gl.texParameteri(gl.TEXTURE_2D, parameter, gl.CLAMP_TO_EDGE);
    for (const parameter of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D, parameter, gl.LINEAR);
  }
}

/** What all layers need to place lengths on the picture. */
export interface Place {
  /** Middle of the picture, and clip units per length in x and y. */
  view: [number, number, number, number];
  /** Shift of the middle in clip units, for the strip below. */
  lift: number;
  /** Device pixels per length. */
  pixels: number;
  /** Device pixels per CSS pixel. */
  ratio: number;
  /** Size of the picture in device pixels. */
  size: [number, number];
}

export function setPlace(gl: WebGL2RenderingContext, at: (name: string) => WebGLUniformLocation | null, place: Place): void {
  gl.uniform4fv(at("view"), place.view);
  gl.uniform1f(at("lift"), place.lift);
  gl.uniform1f(at("pixels"), place.pixels);
  gl.uniform1f(at("ratio"), place.ratio);
}

export const placeUniforms = `
uniform vec4 view;
uniform float lift, pixels, ratio;
vec4 clip(vec2 place) { return vec4((place - view.xy) * view.zw + vec2(0.0, lift), 0.0, 1.0); }`;

/** sRGB from "#rrggbb", each part in [0, 1]. */
export function rgb(hex: string): [number, number, number] {
  const number = parseInt(hex.slice(1), 16);
  return [(number >> 16) / 255, ((number >> 8) & 255) / 255, (number & 255) / 255];
}
