// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
// The panel of layers: grains, force network, fields, base.

import type { App } from "./app";
import { mapNames } from "./colour";
import { button, checkbox, choice, h, rangeInputs, section, slider, type Option } from "./dom";
import { layerFields, layerValues } from "./field-grid";
import { grainFields } from "./grain-fields";
import { canLog, grainLook, layerLook } from "./look";
import type { BaseChoice, GrainStyle } from "./state";

const maps = (first: string): Option[] => [["", first], ...mapNames.map((name): Option => [name, name])];

export function picturePanel(app: App): { element: HTMLElement; update(): void } {
  const { store } = app;
  const field = choice("colour by", [], (value) => store.set({ field: value, range: null, ...(value && store.get().grains === "hidden" ? { grains: "filled" } : {}) }));
  const grains = choice("grains", [["filled", "filled"], ["outline", "outlines"], ["hidden", "hidden"]], (value) => store.set({ grains: value as GrainStyle }));
  const map = choice("map", maps("default"), (value) => store.set({ map: value }));
  const range = rangeInputs((value) => store.set({ range: value }));
  const log = checkbox("logarithmic", (value) => store.set({ log: value }));

  const contacts = checkbox("draw the contacts", (value) => store.set({ contacts: value }));
  const threshold = slider("at least", [0, 4, 0.05], (value) => `${value.toFixed(2)} ⟨f⟩`, (value) => store.set({ threshold: value }));
  const width = slider("width", [-2, 2, 0.05], (value) => `${(2 ** value).toFixed(2)}×`, (value) => store.set({ width: Number((2 ** value).toPrecision(4)) }));
  const sliding = checkbox("mark sliding contacts", (value) => store.set({ sliding: value }));

  const layer = choice("field", [], (value) => store.set({ layer: value, layerRange: null, ...(value && store.get().grains === "filled" ? { grains: "outline" } : {}) }));
  const layerMap = choice("map", maps("default"), (value) => store.set({ layerMap: value }));
  const layerRange = rangeInputs((value) => store.set({ layerRange: value }));
  const bars = checkbox("principal stresses", (value) => store.set({ bars: value }));

  const base = choice("show", [["off", "nothing"], ["window", "mean over the window"], ["frame", "this moment"]], (value) => store.set({ base: value as BaseChoice }));
  const shear = checkbox("shear", (value) => store.set({ shear: value }));

  const grainDetails = h("div", { class: "more" }, map.element, range.element, log.element);
  const layerDetails = h("div", { class: "more" }, layerMap.element, layerRange.element);
  const networkDetails = h("div", { class: "more" }, threshold.element, width.element, sliding.element);
  const fields = section("Fields of the last state", layer.element, layerDetails, bars.element);
  const forces = section("Force network", contacts.element, networkDetails);
  const baseSection = section("Forces on the base", base.element, shear.element);
  const presets = h(
    "div",
    { class: "presets", role: "group", "aria-label": "Ready-made views" },
    button("network", () => store.set({ field: "", grains: "filled", contacts: true, threshold: 0, layer: "", bars: false })),
    button("pressure", () => store.set({ field: "pressure", range: null, map: "", log: false, grains: "filled", contacts: false, layer: "", bars: false })),
    button("motion", () => store.set({ field: "speed", range: null, map: "", log: true, grains: "filled", contacts: false, layer: "", bars: false })),
    button("stress field", () => store.set({ layer: "pressure", layerRange: null, bars: true, grains: "outline", field: "", contacts: false })),
  );
  const element = h("div", { class: "panel" }, presets, section("Grains", field.element, grains.element, grainDetails), forces, fields, baseSection);
  let offered = "";
  let layersOffered = "";

  function update(): void {
    const state = store.get();
    const hasForces = app.frame ? app.frame.normalForce !== null : true;
    if (offered !== String(hasForces)) {
      offered = String(hasForces);
      field.options([["", "nothing"], ...grainFields.filter((one) => hasForces || !one.needsForces).map((one): Option => [one.name, one.label])]);
    }
    field.show(state.field);
    grains.show(state.grains);
    const look = grainLook(app);
    grainDetails.hidden = !look;
    map.show(state.map);
    if (look) {
      range.show({ range: [look.range.low, look.range.high], fixed: state.range !== null });
      log.element.hidden = !canLog(look.field);
    }
    log.show(state.log);

    contacts.show(state.contacts);
    networkDetails.hidden = !state.contacts || !hasForces;
    threshold.show(state.threshold);
    width.show(Math.log2(state.width));
    sliding.show(state.sliding);
    sliding.element.hidden = !app.frame?.sliding;

    fields.hidden = !app.fields;
    if (app.fields) {
      const there = layerFields.filter((one) => layerValues(app.fields!, one) !== null);
      const key = there.map((one) => one.name).join();
      if (layersOffered !== key) {
        layersOffered = key;
        layer.options([["", "none"], ...there.map((one): Option => [one.name, one.label])]);
      }
      bars.element.hidden = !app.fields.arrays.has("stress_xx");
    }
    layer.show(state.layer);
    const layerNow = layerLook(app);
    layerDetails.hidden = !layerNow;
    layerMap.show(state.layerMap);
    if (layerNow) layerRange.show({ range: [layerNow.range.low, layerNow.range.high], fixed: state.layerRange !== null });
    bars.show(state.bars);

    baseSection.hidden = !hasForces && !app.base;
    base.show(state.base);
    shear.show(state.shear);
    shear.element.hidden = state.base === "off";
  }
  return { element, update };
}
