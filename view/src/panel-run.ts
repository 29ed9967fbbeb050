// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
// What the run is, the forces on its walls, and the numbers of its summary; and the list of its avalanches.

import type { App } from "./app";
import { floats } from "./arrays";
import { linesOf } from "./contact-geometry";
import { textOf } from "./colour";
import { button, facts, h, section } from "./dom";

export function runPanel(app: App): { element: HTMLElement; update(): void } {
  const about = h("div", {});
  const walls = h("div", {});
  const summary = h("div", {});
  const element = h("div", { class: "panel" }, about, walls, summary);
  let read = "";

  function update(): void {
    const { run } = app;
    about.replaceChildren(
      facts([
        ["title", run.title],
        ["method", run.method.replaceAll("_", " ")],
        ["status", run.message ? `${run.status}: ${run.message}` : run.status],
        ["time", `${textOf(run.time, 6)} ${run.unit.time}`],
        ["grains", String(run.grains)],
        ...(run.released > 0 ? ([["released", String(run.released)]] as [string, string][]) : []),
        ...(run.lost > 0 ? ([["lost", String(run.lost)]] as [string, string][]) : []),
        ["units", run.units],
        ["seed", String(run.seed)],
        ...(run.materials.length > 1 ? ([["materials", run.materials.join(", ")]] as [string, string][]) : []),
      ]),
    );
    showWalls();
    if (app.store.get().tab === "run") void readSummary();
  }

  function showWalls(): void {
    const pressures = app.base && floats(app.base, "wall_pressure");
    const shears = app.base && floats(app.base, "wall_shear");
    const named = app.frame?.walls ?? [];
    if (!pressures || pressures.length === 0) return walls.replaceChildren();
    const cell = (value: number | undefined): HTMLElement => h("td", {}, textOf(value, 4));
    walls.replaceChildren(
      section(
        "Forces on the walls",
        h(
          "table",
          {},
          h("caption", {}, `per length, in ${app.base!.arrays.get("wall_pressure")!.unit || app.run.unit.pressure}; means over the window`),
          h("thead", {}, h("tr", {}, ...["wall", "pressure", "shear"].map((name) => h("th", { scope: "col" }, name)))),
          h("tbody", {}, ...Array.from(pressures, (value, k) => h("tr", {}, h("td", {}, linesOf(named, k)[0]?.name || String(k)), cell(value), cell(shears?.[k])))),
        ),
      ),
    );
  }

  async function readSummary(): Promise<void> {
    const { run } = app;
    const key = `${run.status} ${run.time}`;
    if (!run.has.summary || read === key) return;
    read = key;
    try {
      const answer = await app.source.json<Record<string, unknown>>(`${app.prefix}summary`);
      if (app.signal.aborted) return;
      const list = flatten(answer).filter(([name, value]) => value !== "" && !["title", "checksum"].includes(name));
      summary.replaceChildren(section("Summary", facts(list)));
    } catch (error) {
      summary.replaceChildren(section("Summary", h("p", { class: "hint" }, error instanceof Error ? error.message : String(error))));
    }
  }
  return { element, update };
}

/** "angle.mean" and its value, for numbers and texts at any depth. */
export function flatten(value: unknown, name = ""): [string, string][] {
  if (value !== null && typeof value === "object" && !Array.isArray(value)) {
    return Object.entries(value).flatMap(([key, inner]) => flatten(inner, name ? `${name}.${key}` : key));
  }
  const text = (one: unknown): string => (typeof one === "number" || one === null ? textOf(one as number | null, 5) : String(one));
  return [[name, Array.isArray(value) ? value.map((one) => (typeof one === "object" ? JSON.stringify(one) : text(one))).join(", ") : text(value)]];
}

export function avalanchePanel(app: App): { element: HTMLElement; update(): void } {
  const body = h("tbody", {});
  const unit = h("caption", {});
  const table = h(
    "table",
    { class: "clicks" },
    unit,
    h("thead", {}, h("tr", {}, ...["start", "duration", "size (grains)"].map((name) => h("th", { scope: "col" }, name)))),
    body,
  );
  const note = h("p", { class: "hint" });
  const element = h("div", { class: "panel" }, note, table);
  let count = -1;

  function update(): void {
    const list = app.run.avalanches;
    if (count !== list.length) {
      count = list.length;
      note.textContent = `${count} avalanches. The start of each opens the nearest frame.`;
      unit.textContent = `times in ${app.run.unit.time}`;
      body.replaceChildren(
        ...list.map((one) =>
          h(
            "tr",
            {},
            h("td", {}, button(textOf(one.start, 5), () => app.goToTime(one.start), { title: `Go to ${textOf(one.start, 5)}` })),
            h("td", {}, textOf(one.end - one.start, 4)),
            h("td", {}, textOf(one.size, 4)),
          ),
        ),
      );
    }
    const now = app.frame?.time ?? NaN;
    const rows = [...body.rows];
    list.forEach((one, i) => rows[i]?.classList.toggle("current", one.start <= now && now <= one.end));
  }
  return { element, update };
}
