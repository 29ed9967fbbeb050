// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
// The time series: a plot for each that is chosen, with a line at the time of the frame.

import type uPlot from "uplot";
import type { Units } from "./api";
import type { App } from "./app";
import { floats } from "./arrays";
import { labelled, textOf } from "./colour";
import { h } from "./dom";
import { cursorAt, makePlot, plottable } from "./plot";
import { inksOf } from "./theme";

const usual = ["kinetic_energy_per_grain", "contacts", "force_residual", "grains"];
/** Series that span many powers of ten. */
const logarithmic = /energy_per_grain|residual|creep_rate/;

/** The unit of a series whose answer does not state it. */
function usualUnit(name: string, unit: Units): string {
  if (/energy/.test(name)) return unit.energy;
  if (/^wall_force/.test(name)) return unit.force;
  if (/^wall_(pressure|shear)/.test(name)) return unit.pressure;
  if (/^wall_(displacement|length)|height|centre/.test(name)) return unit.length;
  return /residual/.test(name) ? "grain weights" : "";
}

export function shortName(name: string): string {
  return name.replace(/_deg(?=\.|$)/, "").replaceAll("_", " ").replace(":", ": ");
}

export function seriesPanel(app: App): { element: HTMLElement; update(): void; redraw(): void; active(on: boolean): void } {
  const plots = h("div", { class: "plots" });
  const list = h("div", { class: "choices" });
  const chooser = h("details", {}, h("summary", {}, "Choose series"), list);
  const empty = h("p", { class: "hint" }, "No series yet.");
  const element = h("div", { class: "panel" }, empty, plots, chooser);
  let drawn: { plot: uPlot; log: boolean; name: string; value: HTMLElement; values: Float32Array }[] = [];
  let offered = "";
  let on = false;
  let stale = true;

  function chosen(): string[] {
    const names = available();
    const wanted = app.store.get().series.filter((name) => names.includes(name));
    return wanted.length > 0 ? wanted : usual.filter((name) => names.includes(name)).slice(0, 3);
  }

  function available(): string[] {
    return app.series ? [...app.series.arrays.keys()].filter((name) => name !== "time") : [];
  }

  function offer(): void {
    const names = available();
    const picked = chosen();
    const key = `${names.join()}|${picked.join()}`;
    if (key === offered) return;
    offered = key;
    list.replaceChildren(
      ...names.map((name) => {
        const box = h("input", {
          type: "checkbox",
          ...(picked.includes(name) ? { checked: true } : {}),
          change: () => {
            const now = chosen();
            app.store.set({ series: box.checked ? [...now, name] : now.filter((other) => other !== name) });
          },
        });
        return h("label", { class: "check", title: app.series!.arrays.get(name)!.meaning }, box, h("span", {}, shortName(name)));
      }),
    );
  }

  /** Make the plots again: other series, other data, other colours or another width. */
  function update(): void {
    stale = true;
    if (!on) return;
    stale = false;
    offer();
    const time = app.series && floats(app.series, "time");
    empty.hidden = Boolean(time && time.length > 0);
    const width = Math.max(plots.clientWidth, 200);
    for (const { plot } of drawn) plot.destroy();
    drawn = [];
    plots.replaceChildren();
    if (!time || time.length === 0) return;
    const inks = inksOf(app.store.get().theme);
    chosen().forEach((name, i) => {
      const unit = app.series!.arrays.get(name)!.unit || usualUnit(name, app.run.unit);
      const values = floats(app.series!, name)!;
      const log = logarithmic.test(name) && values.some((value) => value > 0);
      const value = h("output", {});
      const holder = h("figure", {}, h("figcaption", {}, h("span", {}, labelled(shortName(name), unit)), value));
      plots.append(holder);
      const last = i === chosen().length - 1;
      const plot = makePlot(holder, time, [{ label: name, values: plottable(values, log), colour: inks.lines[0]!, points: time.length < 3 }], {
        width,
        height: last ? 146 : 128,
        inks,
        log,
        ...(last ? { xLabel: `time (${app.run.unit.time})` } : {}),
        click: (x) => app.goToTime(x),
        over: (self) => app.frame && cursorAt(self, app.frame.time, inks.mark),
      });
      drawn.push({ plot, log, name, value, values });
    });
    redraw();
  }

  /** Another time: the lines move, the numbers change. */
  function redraw(): void {
    if (!on) return;
    const time = app.series && floats(app.series, "time");
    for (const { plot, value, values } of drawn) {
      plot.redraw(false, false);
      value.textContent = time && app.frame ? textOf(valueAt(time, values, app.frame.time), 4) : "";
    }
  }

  return {
    element,
    update,
    redraw,
    active: (now) => {
      on = now;
      if (on && stale) update();
      else redraw();
    },
  };
}

/** The value of the row nearest in time. */
export function valueAt(time: Float32Array, values: Float32Array, at: number): number {
  let low = 0;
  let high = time.length - 1;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (time[middle]! <= at) low = middle;
    else high = middle;
  }
  return values[Math.abs(time[low]! - at) <= Math.abs(time[high]! - at) ? low : high]!;
}
