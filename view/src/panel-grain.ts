// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
// The picked grain: its numbers, its contacts, and one of its fields over the frames.

import type uPlot from "uplot";
import type { App } from "./app";
import { firstWall, linesOf } from "./contact-geometry";
import { labelled, textOf } from "./colour";
import { button, checkbox, choice, facts, h, section, type Option } from "./dom";
import { contactsOf } from "./derived";
import { baseFlag, fixedFlag, rowOf, type Frame } from "./frame";
import { grainField, grainFields, period, valuesOf } from "./grain-fields";
import { cursorAt, makePlot, plottable } from "./plot";
import { inksOf } from "./theme";

const told = ["speed", "spin", "pressure", "shear", "coordination"];

export function grainPanel(app: App, centre: (row: number) => void): { element: HTMLElement; update(): void; restyle(): void } {
  const { store } = app;
  const numbers = h("div", {});
  const contacts = h("div", {});
  const chase = checkbox("camera follows it", (value) => {
    store.set({ chase: value });
    if (value) update();
  });
  const history = choice("over the frames", [], (value) => {
    field = value;
    void draw();
  });
  const holder = h("div", { class: "plots" });
  const start = button("load", () => void gather(true));
  const note = h("p", { class: "hint" });
  const find = h("input", { type: "number", min: 0, step: 1, "aria-label": "Id of a grain", change: () => find.value !== "" && store.set({ picked: Number(find.value) }) });
  const pick = h("label", { class: "row" }, h("span", {}, "grain"), find);
  const hint = h("p", { class: "hint" }, "Click or tap a grain, or give its id.");
  const about = h("div", {}, numbers, chase.element, section("Contacts", contacts), section("History", history.element, holder, note, start));
  const element = h("div", { class: "panel" }, pick, hint, about);
  let field = "speed";
  let plot: uPlot | null = null;
  /** Values of the grain by frame key, for each field. */
  let known = new Map<string, Map<string, number>>();
  let of = -1;
  let runTime = app.run.time;
  let gathering = false;
  let shownFor: Frame | null = null;

  function update(): void {
    const state = store.get();
    const frame = app.frame;
    const row = frame && state.picked >= 0 ? rowOf(frame, state.picked) : -1;
    hint.hidden = state.picked >= 0;
    about.hidden = state.picked < 0;
    if (document.activeElement !== find) find.value = state.picked >= 0 ? String(state.picked) : "";
    if (runTime !== app.run.time) {
      // The last state is another one now; if time went back, so are all.
      if (app.run.time < runTime) known = new Map();
      for (const one of known.values()) one.delete(app.lastKey());
      runTime = app.run.time;
    }
    if (of !== state.picked) {
      of = state.picked;
      known = new Map();
      plot?.destroy();
      plot = null;
      shownFor = null;
    }
    chase.show(state.chase);
    if (!frame || state.picked < 0) return;
    if (row >= 0 && state.chase) centre(row);
    if (state.tab !== "grain") return;
    if (row < 0) {
      numbers.replaceChildren(h("p", { class: "hint" }, `Grain ${state.picked} is not there at this time.`));
      contacts.replaceChildren();
    } else if (shownFor !== frame) {
      shownFor = frame;
      show(frame, row);
    }
    const fields = grainFields.filter((one) => one.name !== "id" && one.name !== "material" && one.name !== "radius");
    history.options(fields.filter((one) => frame.normalForce || !one.needsForces).map((one): Option => [one.name, one.label]));
    history.show(field);
    void gather(false);
  }

  function show(frame: Frame, row: number): void {
    const { run } = app;
    const flags = frame.flags[row]!;
    const list: [string, string][] = [
      ["position", `${textOf(frame.position[2 * row], 5)}, ${textOf(frame.position[2 * row + 1], 5)} ${run.unit.length}`],
      ["velocity", `${textOf(frame.velocity[2 * row], 3)}, ${textOf(frame.velocity[2 * row + 1], 3)} ${run.unit.speed}`],
      ["radius", `${textOf(frame.radius[row], 5)} ${run.unit.length}`],
    ];
    for (const name of told) {
      const one = grainField(name)!;
      if (one.needsForces && !frame.normalForce) continue;
      list.push([one.label, `${textOf(valuesOf(frame, one, period(run))[row], 4)} ${one.unit(run)}`]);
    }
    if (run.materials.length > 1) list.push(["material", run.materials[frame.material[row]!] ?? String(frame.material[row])]);
    const kind = [flags & fixedFlag ? "fixed" : "", flags & baseFlag ? "of the base" : ""].filter(Boolean).join(", ");
    if (kind) list.push(["kind", kind]);
    numbers.replaceChildren(facts(list));
    contacts.replaceChildren(contactTable(frame, row));
  }

  function contactTable(frame: Frame, row: number): HTMLElement {
    const rows = contactsOf(frame, row);
    if (rows.length === 0) return h("p", { class: "hint" }, "none");
    rows.sort((a, b) => (frame.normalForce?.[b] ?? 0) - (frame.normalForce?.[a] ?? 0));
    return h(
      "table",
      {},
      h("thead", {}, h("tr", {}, ...["partner", "normal", "tangential"].map((name) => h("th", { scope: "col" }, name)))),
      h(
        "tbody",
        {},
        ...rows.map((c) => {
          const other = frame.pair[2 * c] === row ? frame.pair[2 * c + 1]! : frame.pair[2 * c]!;
          const wall = other >= frame.grains ? linesOf(frame.walls, firstWall - other)[0]?.name || String(firstWall - other) : "";
          const id = frame.id[other];
          const name = wall ? `wall ${wall}` : button(String(id), () => store.set({ picked: id! }), { title: `Pick grain ${id}` });
          const slides = frame.sliding?.[c] ? " (slides)" : "";
          return h(
            "tr",
            {},
            h("td", {}, name),
            h("td", {}, textOf(frame.normalForce?.[c], 4)),
            h("td", {}, textOf(frame.tangentialForce?.[c], 3) + slides),
          );
        }),
      ),
      h("caption", {}, `forces in ${app.run.unit.force}`),
    );
  }

  /** Read the field of the grain in all frames: at once where they are few, else when asked. */
  async function gather(asked: boolean): Promise<void> {
    const size = (app.frame?.bytes ?? 0) * app.run.frames.length;
    const missing = app.run.frames.filter((entry) => !values().has(entry.key));
    start.hidden = asked || gathering || missing.length === 0 || size < 48 * 2 ** 20;
    start.textContent = `load ${missing.length} frames`;
    if (gathering || (!asked && size >= 48 * 2 ** 20)) return draw();
    gathering = true;
    try {
      for (const entry of missing) {
        const wanted = field;
        const id = of;
        const frame = entry.key === app.frame?.key ? app.frame : await app.frames.load(entry.key);
        if (app.signal.aborted) return;
        if (id !== of || wanted !== field) break;
        const row = rowOf(frame, id);
        values().set(entry.key, row < 0 ? NaN : valuesOf(frame, grainField(field)!, period(app.run))[row]!);
        note.textContent = `${values().size} of ${app.run.frames.length} frames`;
      }
      note.textContent = "";
    } catch (error) {
      note.textContent = error instanceof Error ? error.message : String(error);
    } finally {
      gathering = false;
    }
    draw();
    if (app.run.frames.some((entry) => !values().has(entry.key)) && !note.textContent) void gather(asked);
  }

  function values(): Map<string, number> {
    let map = known.get(field);
    if (!map) known.set(field, (map = new Map()));
    return map;
  }

  let drawnKey = "";
  function draw(): void {
    const there = app.run.frames.filter((entry) => values().has(entry.key));
    const theme = store.get().theme;
    const key = `${of} ${field} ${there.length} ${app.run.time} ${holder.clientWidth}`;
    if (plot && key === drawnKey) return void plot.redraw(false, false);
    drawnKey = key;
    plot?.destroy();
    plot = null;
    if (there.length < 2) return;
    const inks = inksOf(theme);
    const one = grainField(field)!;
    const values_ = there.map((entry) => values().get(entry.key)!);
    plot = makePlot(holder, there.map((entry) => entry.time), [{ label: field, values: plottable(values_), colour: inks.lines[0]!, points: there.length < 40 }], {
      width: Math.max(holder.clientWidth, 200),
      height: 150,
      inks,
      xLabel: `time (${app.run.unit.time}); ${labelled(one.label, one.unit(app.run))}`,
      click: (x) => app.goToTime(x),
      over: (self) => app.frame && cursorAt(self, app.frame.time, inksOf(store.get().theme).mark),
    });
  }

  return {
    element,
    update,
    restyle: () => {
      drawnKey = "";
      if (store.get().tab === "grain") draw();
    },
  };
}
