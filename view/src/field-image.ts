// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
// The layer of a coarse-grained field: one rectangle, values read bilinearly between the centres of the cells.

import { lookupTable, type Range } from "./colour";
import type { FieldGrid } from "./field-grid";
import { makeProgram, MapTexture, placeUniforms, setPlace, uniforms, type Place } from "./gl";

const vertex = `
uniform vec4 box;
out vec2 at;
${placeUniforms}
const vec2 square[6] = vec2[6](vec2(0, 0), vec2(1, 0), vec2(1, 1), vec2(0, 0), vec2(1, 1), vec2(0, 1));
void main() {
  at = square[gl_VertexID];
  gl_Position = clip(mix(box.xy, box.zw, at));
}`;

const fragment = `
uniform sampler2D values, map;
uniform ivec2 cells;
uniform vec2 range;
uniform bool logarithmic;
in vec2 at;
out vec4 colour;
void main() {
  vec2 place = at * vec2(cells) - 0.5;
  ivec2 low = ivec2(floor(place));
  vec2 part = place - vec2(low);
  float sum = 0.0, weight = 0.0, solid = 0.0;
  for (int k = 0; k < 4; k++) {
    ivec2 step = ivec2(k & 1, k >> 1);
    ivec2 here = clamp(low + step, ivec2(0), cells - 1);
    vec2 value = texelFetch(values, here, 0).rg;
    float w = (step.x == 1 ? part.x : 1.0 - part.x) * (step.y == 1 ? part.y : 1.0 - part.y);
    solid += w * value.g;
    if (value.r > -3e38) { sum += w * value.r; weight += w; }
  }
  float cover = smoothstep(0.15, 0.5, solid);
  if (weight < 0.25 || cover <= 0.0) discard;
  float v = sum / weight;
  float t = clamp(logarithmic ? (v > 0.0 ? (log(v) - range.x) * range.y : 0.0) : (v - range.x) * range.y, 0.0, 1.0);
  colour = vec4(texture(map, vec2(t * 0.99609375 + 0.001953125, 0.5)).rgb * cover, cover);
}`;

export class FieldLayer {
  private readonly program: WebGLProgram;
  private readonly at: (name: string) => WebGLUniformLocation | null;
  private readonly texture: WebGLTexture;
  private readonly map: MapTexture;
  private held: Float32Array | null = null;

  constructor(private readonly gl: WebGL2RenderingContext) {
    this.program = makeProgram(gl, vertex, fragment);
    this.at = uniforms(gl, this.program);
    this.texture = gl.createTexture()!;
    this.map = new MapTexture(gl);
  }

  draw(grid: FieldGrid, values: Float32Array, range: Range, map: string, place: Place): void {
    const { gl, at } = this;
    gl.useProgram(this.program);
    setPlace(gl, at, place);
    gl.activeTexture(gl.TEXTURE0);
    gl.bindTexture(gl.TEXTURE_2D, this.texture);
    if (this.held !== values) {
      this.held = values;
      const both = new Float32Array(2 * values.length);
      for (let i = 0; i < values.length; i++) {
        both[2 * i] = Number.isFinite(values[i]) ? values[i]! : -3.4e38;
        // How much of the cell is heap: fields fade out where hardly any of it is left.
        both[2 * i + 1] = grid.solid ? grid.solid[i]! : 1;
      }
      gl.texImage2D(gl.TEXTURE_2D, 0, gl.RG32F, grid.columns, grid.rows, 0, gl.RG, gl.FLOAT, both);
      gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
      gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
    }
    this.map.bind(1, map, lookupTable);
    gl.uniform1i(at("values"), 0);
    gl.uniform1i(at("map"), 1);
    gl.uniform2i(at("cells"), grid.columns, grid.rows);
    gl.uniform4f(at("box"), grid.low[0], grid.low[1], grid.high[0], grid.high[1]);
    const from = range.log ? Math.log(range.low) : range.low;
    gl.uniform2f(at("range"), from, 1 / ((range.log ? Math.log(range.high) : range.high) - from || 1));
    gl.uniform1i(at("logarithmic"), range.log ? 1 : 0);
    gl.drawArrays(gl.TRIANGLES, 0, 6);
  }
}
