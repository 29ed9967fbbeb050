// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
// The picture: layers drawn by the graphics card, an overlay for lines and text. Drawn again only when asked.

import type { App } from "./app";
import { stripHeight } from "./base-strip";
import { fit, scaleOf, toPixel, type Box, type Camera, type Viewport } from "./camera";
import { DiscLayer } from "./discs";
import { h } from "./dom";
import { FieldLayer } from "./field-image";
import { extent, type Frame } from "./frame";
import { rgb, type Place } from "./gl";
import { period } from "./grain-fields";
import { LineLayer } from "./lines";
import { forceScale, grainLook, layerLook } from "./look";
import { networkOf, type Segments } from "./network";
import { drawOverlay, lineWidth } from "./overlay";
import type { Inks } from "./theme";
import { inksOf } from "./theme";

interface Layers {
  gl: WebGL2RenderingContext;
  discs: DiscLayer;
  lines: LineLayer;
  field: FieldLayer;
}

/** Networks of more contacts are not drawn while the camera moves. */
const manyContacts = 200_000;

export const noWebGL = "This browser does not offer WebGL2, which the picture needs. Series, numbers and lists work without it.";

export class Picture {
  readonly canvas = h("canvas", { class: "picture", tabindex: 0, role: "img", "aria-label": "Picture of the grains" });
  readonly overlay = h("canvas", { class: "overlay", "aria-hidden": "true" });
  /** How often it was drawn. */
  drawn = 0;
  /** A line that is being measured, to the pointer. */
  pending: number[] | null = null;
  private layers: Layers | null = null;
  private asked = 0;
  /** Until when the camera counts as moving. */
  private moving = 0;
  private settle = 0;
  private network: { frame: Frame; key: string; segments: Segments } | null = null;
  private box: Box | null = null;
  private size = { width: 0, height: 0 };

  constructor(private readonly app: App) {
    this.start();
    this.canvas.addEventListener("webglcontextlost", (event) => {
      event.preventDefault();
      this.layers = null;
    });
    this.canvas.addEventListener("webglcontextrestored", () => {
      this.start();
      this.ask();
    });
    app.signal.addEventListener("abort", () => {
      window.cancelAnimationFrame(this.asked);
      window.clearTimeout(this.settle);
      this.layers?.gl.getExtension("WEBGL_lose_context")?.loseContext();
    });
  }

  private start(): void {
    const gl = this.canvas.getContext("webgl2", { antialias: false, alpha: false, powerPreference: "high-performance" });
    if (!gl) return this.app.notices.say("webgl", noWebGL);
    try {
      this.layers = { gl, discs: new DiscLayer(gl), lines: new LineLayer(gl), field: new FieldLayer(gl) };
    } catch (error) {
      this.app.notices.problem("webgl", error);
    }
  }

  viewport(): Viewport {
    return { width: this.size.width, height: this.size.height, strip: stripHeight(this.app, this.size.height) };
  }

  camera(): Camera {
    const { camera } = this.app.store.get();
    return camera ?? fit(this.box ?? this.wholeBox(), this.viewport());
  }

  private wholeBox(): Box {
    const { low, high } = this.app.run.box;
    return { low, high };
  }

  resize(width: number, height: number): void {
    if (width === this.size.width && height === this.size.height) return;
    this.size = { width, height };
    if (this.app.store.get().fitted && this.app.frame) this.fitTo();
    this.ask();
  }

  /** Fit what touches, or with `all` the box of the run. */
  fitTo(all = false): void {
    this.box = all ? this.wholeBox() : (this.app.frame && extent(this.app.frame)) ?? this.wholeBox();
    this.app.store.set({ camera: fit(this.box, this.viewport()), fitted: true });
  }

  /** Another frame: follow the grain, or what grows. */
  arrived(): void {
    const state = this.app.store.get();
    if (!state.camera) this.fitTo();
    else if (state.fitted && state.frame === "" && this.app.run.status === "running") {
      const box = this.app.frame && extent(this.app.frame);
      const seen = this.visible(state.camera);
      const inside = box && seen.low.every((low, a) => low <= box.low[a]! && box.high[a]! <= seen.high[a]!);
      if (box && !inside) this.fitTo();
    }
    this.ask();
  }

  private visible(camera: Camera): Box {
    const viewport = this.viewport();
    const up = ((viewport.height - viewport.strip) / viewport.width) * camera.width;
    return { low: [camera.x - camera.width / 2, camera.y - up / 2], high: [camera.x + camera.width / 2, camera.y + up / 2] };
  }

  /** The camera moves: a network of very many contacts is left out until it rests. */
  move(): void {
    this.moving = performance.now() + 180;
    window.clearTimeout(this.settle);
    this.settle = window.setTimeout(() => this.ask(), 200);
    this.ask();
  }

  ask(): void {
    if (this.asked) return;
    this.asked = window.requestAnimationFrame(() => {
      this.asked = 0;
      this.draw(Math.min(window.devicePixelRatio || 1, 3));
    });
  }

  /** Draw at so many pixels per CSS pixel. */
  draw(ratio: number): void {
    const { width, height } = this.size;
    if (width < 2 || height < 2 || this.app.signal.aborted) return;
    const pixels: [number, number] = [Math.round(width * ratio), Math.round(height * ratio)];
    for (const canvas of [this.canvas, this.overlay]) {
      if (canvas.width !== pixels[0] || canvas.height !== pixels[1]) [canvas.width, canvas.height] = pixels;
    }
    const inks = inksOf(this.app.store.get().theme);
    this.drawLayers(ratio, pixels, inks);
    const context = this.overlay.getContext("2d");
    if (context) {
      context.setTransform(ratio, 0, 0, ratio, 0, 0);
      context.clearRect(0, 0, width, height);
      drawOverlay(context, this.app, this.camera(), this.viewport(), inks, this.pending);
    }
    this.drawn++;
  }

  private drawLayers(ratio: number, pixels: [number, number], inks: Inks): void {
    if (!this.layers || this.layers.gl.isContextLost()) return;
    const { gl, discs, lines, field } = this.layers;
    const { app } = this;
    gl.viewport(0, 0, pixels[0], pixels[1]);
    gl.clearColor(...rgb(inks.paper), 1);
    gl.clear(gl.COLOR_BUFFER_BIT);
    const { frame } = app;
    if (!frame) return;
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
    const place = this.place(ratio, pixels);
    const state = app.store.get();
    const layer = layerLook(app);
    if (layer && app.fields) field.draw(app.fields, layer.values, layer.range, layer.map, place);
    const look = grainLook(app);
    discs.draw(
      frame,
      {
        style: state.grains,
        values: look?.values ?? null,
        range: look?.range ?? { low: 0, high: 1, log: false },
        map: look?.map ?? "viridis",
        plain: inks.plain,
        fixed: inks.fixed,
        edge: inks.edge,
        paper: inks.paper,
      },
      place,
    );
    const hurried = frame.contacts > manyContacts && performance.now() < this.moving;
    if (state.contacts && frame.contacts > 0 && !hurried) {
      const coloured = layer !== null || (look !== null && state.grains === "filled");
      lines.draw(
        this.segments(frame, state.threshold),
        {
          width: (frame.normalForce ? lineWidth : 0.07) * app.run.grain_diameter * state.width,
          largest: 0.8 * app.run.grain_diameter,
          push: inks.push,
          pull: inks.pull,
          slide: state.sliding ? inks.slide : null,
          rim: coloured ? inks.paper : null,
        },
        place,
      );
    }
  }

  private place(ratio: number, pixels: [number, number]): Place {
    const camera = this.camera();
    const viewport = this.viewport();
    const scale = scaleOf(camera, viewport);
    return {
      view: [camera.x, camera.y, (2 * scale) / viewport.width, (2 * scale) / viewport.height],
      lift: viewport.strip / viewport.height,
      pixels: scale * ratio,
      ratio,
      size: pixels,
    };
  }

  private segments(frame: Frame, threshold: number): Segments {
    const scale = forceScale(this.app);
    const key = `${scale} ${threshold}`;
    if (this.network?.frame !== frame || this.network.key !== key) {
      this.network = { frame, key, segments: networkOf(frame, period(this.app.run), scale, threshold) };
    }
    return this.network.segments;
  }

  pixelOf(x: number, y: number): [number, number] {
    return toPixel(this.camera(), this.viewport(), x, y);
  }

  /** The picture as it is, `times` as fine. */
  async image(times: number): Promise<Blob> {
    const largest = this.layers ? Math.min(this.layers.gl.getParameter(this.layers.gl.MAX_TEXTURE_SIZE) as number, 16384) : 16384;
    const ratio = Math.min(times, largest / Math.max(this.size.width, this.size.height, 1));
    const paper = document.createElement("canvas");
    this.moving = 0;
    this.draw(ratio);
    [paper.width, paper.height] = [this.canvas.width, this.canvas.height];
    const context = paper.getContext("2d")!;
    context.drawImage(this.canvas, 0, 0);
    context.drawImage(this.overlay, 0, 0);
    this.ask();
    return new Promise((done, failed) => {
      paper.toBlob((blob) => (blob ? done(blob) : failed(new Error("the picture is too large for this browser"))), "image/png");
    });
  }
}
