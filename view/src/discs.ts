// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
// The layer of grains: a square around each disc, or a point where all are small, found by gl_VertexID; the fragment
// shader smooths the edge. Instances instead are many times slower in software renderers, and points have a largest size.

import { lookupTable, type Range } from "./colour";
import type { Frame } from "./frame";
import { ArrayTexture, cellFunction, makeProgram, MapTexture, placeUniforms, rgb, setPlace, uniforms, type Place } from "./gl";

export interface DiscStyle {
  style: "filled" | "outline" | "hidden";
  /** Values to colour by, or null for plain grains. */
  values: Float32Array | null;
  range: Range;
  map: string;
  plain: string;
  fixed: string;
  edge: string;
  paper: string;
}

const vertex = `
uniform sampler2D positions, radii, values;
uniform usampler2D flags;
uniform vec2 range;
uniform bool logarithmic, coloured;
uniform int corners;
out vec2 at;
flat out float value, radius, reach;
flat out uint flag;
${cellFunction}
${placeUniforms}
const vec2 square[6] = vec2[6](vec2(-1, -1), vec2(1, -1), vec2(1, 1), vec2(-1, -1), vec2(1, 1), vec2(-1, 1));
void main() {
  int grain = gl_VertexID / corners;
  ivec2 here = cell(grain);
  vec2 corner = corners == 6 ? square[gl_VertexID - 6 * grain] : vec2(0.0);
  float r = texelFetch(radii, here, 0).r;
  radius = r * pixels;
  reach = max(radius, 0.5) + 0.5;
  at = corner * reach;
  flag = texelFetch(flags, here, 0).r;
  value = -1.0;
  if (coloured) {
    float v = texelFetch(values, here, 0).r;
    if (v > -3e38) value = clamp(logarithmic ? (v > 0.0 ? (log(v) - range.x) * range.y : 0.0) : (v - range.x) * range.y, 0.0, 1.0);
  }
  gl_PointSize = 2.0 * reach;
  gl_Position = clip(texelFetch(positions, here, 0).xy + at / pixels);
}`;

const fragment = `
uniform sampler2D map;
uniform bool coloured, filled, points;
uniform vec3 plain, fixedColour, edge, paper;
uniform float ratio;
in vec2 at;
flat in float value, radius, reach;
flat in uint flag;
out vec4 colour;
void main() {
  float distance = points ? length(gl_PointCoord - 0.5) * 2.0 * reach : length(at);
  float shown = max(radius, 0.5);
  float cover = clamp(shown - distance + 0.5, 0.0, 1.0) * min(1.0, radius * radius * 4.0);
  if (cover <= 0.0) discard;
  vec3 inside = plain;
  if (coloured) inside = value < 0.0 ? mix(plain, paper, 0.5) : texture(map, vec2(value * 0.99609375 + 0.001953125, 0.5)).rgb;
  else if ((flag & 1u) != 0u) inside = fixedColour;
  float wide = clamp(radius * 0.09, 0.0, 1.1 * ratio);
  float ring = filled ? clamp(distance - (shown - wide) + 0.5, 0.0, 1.0) * smoothstep(1.5, 5.0, radius)
                      : clamp(distance - (shown - max(wide, 0.8)) + 0.5, 0.0, 1.0);
  vec3 rim = filled && coloured ? mix(inside, edge, 0.55) : edge;
  float alpha = filled ? cover : cover * ring;
  colour = vec4((filled ? mix(inside, rim, ring) : (coloured && value >= 0.0 ? inside : rim)) * alpha, alpha);
}`;

export class DiscLayer {
  private readonly program: WebGLProgram;
  private readonly at: (name: string) => WebGLUniformLocation | null;
  private readonly positions: ArrayTexture;
  private readonly radii: ArrayTexture;
  private readonly flags: ArrayTexture;
  private readonly values: ArrayTexture;
  private readonly map: MapTexture;
  private readonly largestPoint: number;

  constructor(private readonly gl: WebGL2RenderingContext) {
    this.program = makeProgram(gl, vertex, fragment);
    this.at = uniforms(gl, this.program);
    this.positions = new ArrayTexture(gl, "rg32f");
    this.radii = new ArrayTexture(gl, "r32f");
    this.flags = new ArrayTexture(gl, "r32ui");
    this.values = new ArrayTexture(gl, "r32f");
    this.map = new MapTexture(gl);
    this.largestPoint = (gl.getParameter(gl.ALIASED_POINT_SIZE_RANGE) as Float32Array)[1]!;
  }

  draw(frame: Frame, look: DiscStyle, place: Place): void {
    if (look.style === "hidden" || frame.grains === 0) return;
    const { gl, at } = this;
    gl.useProgram(this.program);
    setPlace(gl, at, place);
    gl.activeTexture(gl.TEXTURE0);
    this.positions.upload(frame.position, frame.grains);
    this.radii.upload(frame.radius, frame.grains);
    this.flags.upload(frame.flags, frame.grains);
    if (look.values) this.values.upload(withoutNaN(look.values), frame.grains);
    this.positions.bind(0);
    this.radii.bind(1);
    this.flags.bind(2);
    if (look.values) this.values.bind(3);
    else this.radii.bind(3);
    this.map.bind(4, look.map, lookupTable);
    ["positions", "radii", "flags", "values", "map"].forEach((name, unit) => gl.uniform1i(at(name), unit));
    const { low, high, log } = look.range;
    const from = log ? Math.log(low) : low;
    gl.uniform2f(at("range"), from, 1 / ((log ? Math.log(high) : high) - from || 1));
    gl.uniform1i(at("logarithmic"), log ? 1 : 0);
    gl.uniform1i(at("coloured"), look.values ? 1 : 0);
    gl.uniform1i(at("filled"), look.style === "filled" ? 1 : 0);
    gl.uniform3fv(at("plain"), rgb(look.plain));
    gl.uniform3fv(at("fixedColour"), rgb(look.fixed));
    gl.uniform3fv(at("edge"), rgb(look.edge));
    gl.uniform3fv(at("paper"), rgb(look.paper));
    // Points are clipped by their centres and limited in size: for small discs alone.
    const points = 2 * place.pixels * largestRadius(frame) + 1 < Math.min(this.largestPoint, 8 * place.ratio);
    const corners = points ? 1 : 6;
    gl.uniform1i(at("corners"), corners);
    gl.uniform1i(at("points"), points ? 1 : 0);
    gl.drawArrays(points ? gl.POINTS : gl.TRIANGLES, 0, corners * frame.grains);
  }
}

const largest = new WeakMap<Frame, number>();

function largestRadius(frame: Frame): number {
  let found = largest.get(frame);
  if (found === undefined) largest.set(frame, (found = frame.radius.reduce((most, radius) => Math.max(most, radius), 0)));
  return found;
}

const cleaned = new WeakMap<Float32Array, Float32Array>();

/** The values with a number that shaders can tell apart in place of those that are not defined. */
function withoutNaN(values: Float32Array): Float32Array {
  let found = cleaned.get(values);
  if (!found) {
    found = values.some((value) => Number.isNaN(value)) ? values.map((value) => (Number.isNaN(value) ? -3.4e38 : value)) : values;
    cleaned.set(values, found);
  }
  return found;
}
