// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
// The layer of contacts: a capsule for each, as wide as its force, with a thin rim of paper where it lies on colours.

import { ArrayTexture, cellFunction, makeProgram, placeUniforms, rgb, setPlace, uniforms, type Place } from "./gl";
import { firstFrom, type Segments } from "./network";

export interface LineStyle {
  /** Full width in lengths of a line of force 1, and the largest. */
  width: number;
  largest: number;
  push: string;
  pull: string;
  /** Colour of sliding contacts, or null to leave them as the others. */
  slide: string | null;
  rim: string | null;
}

const vertex = `
uniform sampler2D ends, marks;
uniform float width, largest, rim;
uniform int corners;
out vec2 at;
flat out float span, half_, fade, force, slides;
${cellFunction}
${placeUniforms}
const vec2 square[6] = vec2[6](vec2(-1, -1), vec2(1, -1), vec2(1, 1), vec2(-1, -1), vec2(1, 1), vec2(-1, 1));
void main() {
  int line = gl_VertexID / corners;
  int turn = gl_VertexID - corners * line;
  vec2 corner = corners == 6 ? square[turn] : vec2(2 * turn - 1, 0);
  ivec2 here = cell(line);
  vec4 both = texelFetch(ends, here, 0);
  vec2 mark = texelFetch(marks, here, 0).rg;
  force = mark.x;
  slides = mark.y;
  float wanted = 0.5 * min(width * abs(force), largest) * pixels;
  half_ = max(wanted, 0.4);
  fade = min(1.0, wanted / 0.4);
  vec2 along = both.zw - both.xy;
  span = 0.5 * length(along) * pixels;
  along = span > 0.0 ? normalize(along) : vec2(1, 0);
  float more = half_ + rim + 0.5;
  at = corner * vec2(span + more, more);
  vec2 offset = at.x * along + at.y * vec2(-along.y, along.x);
  gl_Position = clip(0.5 * (both.xy + both.zw) + offset / pixels);
}`;

const fragment = `
uniform vec3 push, pull, slide, rimColour;
uniform bool marked;
uniform float rim;
in vec2 at;
flat in float span, half_, fade, force, slides;
out vec4 colour;
void main() {
  float distance = length(vec2(max(abs(at.x) - span, 0.0), at.y));
  float inner = clamp(half_ - distance + 0.5, 0.0, 1.0) * fade;
  float outer = rim > 0.0 ? 0.75 * fade * clamp(half_ + rim - distance + 0.5, 0.0, 1.0) : 0.0;
  float alpha = max(inner, outer);
  if (alpha <= 0.0) discard;
  vec3 core = force < 0.0 ? pull : marked && slides > 0.5 ? slide : push;
  colour = vec4(mix(rimColour, core, inner / alpha) * alpha, alpha);
}`;

export class LineLayer {
  private readonly program: WebGLProgram;
  private readonly at: (name: string) => WebGLUniformLocation | null;
  private readonly ends: ArrayTexture;
  private readonly marks: ArrayTexture;

  constructor(private readonly gl: WebGL2RenderingContext) {
    this.program = makeProgram(gl, vertex, fragment);
    this.at = uniforms(gl, this.program);
    this.ends = new ArrayTexture(gl, "rgba32f");
    this.marks = new ArrayTexture(gl, "rg32f");
  }

  draw(segments: Segments, look: LineStyle, place: Place): void {
    if (segments.count === 0) return;
    const { gl, at } = this;
    gl.useProgram(this.program);
    setPlace(gl, at, place);
    gl.activeTexture(gl.TEXTURE0);
    this.ends.upload(segments.ends, segments.count);
    this.marks.upload(segments.marks, segments.count);
    this.ends.bind(0);
    this.marks.bind(1);
    gl.uniform1i(at("ends"), 0);
    gl.uniform1i(at("marks"), 1);
    gl.uniform1f(at("width"), look.width);
    gl.uniform1f(at("largest"), look.largest);
    gl.uniform1f(at("rim"), look.rim ? Math.min(0.9 * place.ratio, 0.08 * look.largest * place.pixels) : 0);
    gl.uniform1i(at("marked"), look.slide ? 1 : 0);
    gl.uniform3fv(at("push"), rgb(look.push));
    gl.uniform3fv(at("pull"), rgb(look.pull));
    gl.uniform3fv(at("slide"), rgb(look.slide ?? look.push));
    gl.uniform3fv(at("rimColour"), rgb(look.rim ?? look.push));
    // In large networks, what is thinner than a pixel is drawn as plain lines, and what would not show is left out.
    const perForce = 0.5 * look.width * place.pixels;
    const many = segments.count > 50_000;
    const shown = many ? firstFrom(segments, 0.02 / perForce) : 0;
    const wide = many ? firstFrom(segments, 0.4 / perForce) : 0;
    gl.uniform1i(at("corners"), 2);
    if (wide > shown) gl.drawArrays(gl.LINES, 2 * shown, 2 * (wide - shown));
    gl.uniform1i(at("corners"), 6);
    if (segments.count > wide) gl.drawArrays(gl.TRIANGLES, 6 * wide, 6 * (segments.count - wide));
  }
}
