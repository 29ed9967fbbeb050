// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
// The page of a sweep: a measure over a parameter, and the table of its members.

import type uPlot from "uplot";
import type { Sweep } from "./api";
import { labelled } from "./colour";
import { choice, h, iconButton, type Option } from "./dom";
import { bindKeys } from "./keys";
import { Notices } from "./notices";
import { shortName } from "./panel-series";
import { makePlot } from "./plot";
import type { Page } from "./run-page";
import type { Source } from "./source";
import type { Store } from "./state";
import { aligned, meanLines, shortKey, type MeanLine } from "./sweep-lines";
import { memberTable } from "./sweep-table";
import { inksOf, nextTheme, onSystemTheme } from "./theme";

export async function sweepPage(source: Source, store: Store, signal: AbortSignal, open: (member: string) => void): Promise<Page> {
  let sweep = await source.json<Sweep>("api/sweep");
  const notices = new Notices();
  const title = h("h1", {});
  const status = h("span", { class: "status" });
  const measure = choice("measure", [], (value) => store.set({ measure: value }));
  const over = choice("over", [], (value) => store.set({ over: value }));
  const holder = h("div", { class: "plots" });
  const legend = h("ul", { class: "legend" });
  const note = h("p", { class: "hint" });
  const theme = (): void => store.set({ theme: nextTheme(store.get().theme) });
  const table = memberTable(open);
  const element = h(
    "main",
    { class: "sweep" },
    h("header", {}, title, status, h("div", { class: "tools" }, iconButton("theme", "Light or dark (t)", theme))),
    notices.element,
    h("div", { class: "columns" }, h("div", { class: "chart" }, h("div", { class: "picks" }, measure.element, over.element), legend, holder, note), table.element),
  );
  let plot: uPlot | null = null;
  let drawn = 0;

  function chosen(): { measure: string; over: string; unit: string } {
    const state = store.get();
    const has = (name: string): boolean => sweep.means.some((mean) => Number.isFinite(mean[name]?.[0] ?? NaN));
    const names = sweep.measures.map((one) => one.name);
    const usual = names.find((name) => /angle.*mean/.test(name) && has(name)) ?? names.find(has) ?? names[0] ?? "";
    const wanted = names.includes(state.measure) ? state.measure : usual;
    const keys = sweep.parameters;
    const number = keys.find((key) => sweep.points.every((point) => typeof point.values[key] === "number"));
    return {
      measure: wanted,
      over: keys.includes(state.over) ? state.over : number ?? keys[0] ?? "",
      unit: sweep.measures.find((one) => one.name === wanted)?.unit ?? "",
    };
  }

  function update(): void {
    const count = (name: string): number => sweep.members.filter((member) => member.status === name).length;
    title.textContent = sweep.title || "Sweep";
    document.title = `${sweep.title || "sweep"} – Repose`;
    const running = count("running") + count("waiting");
    status.dataset["status"] = running > 0 ? "running" : count("failed") > 0 ? "failed" : "finished";
    const parts = ["finished", "running", "waiting", "failed"].filter((name) => count(name) > 0).map((name) => `${count(name)} ${name}`);
    status.textContent = parts.join(", ");
    status.title = status.textContent;
    const now = chosen();
    measure.options(sweep.measures.map((one): Option => [one.name, labelled(shortName(one.name), one.unit)]));
    over.options(sweep.parameters.map((key): Option => [key, shortKey(key, sweep.parameters)]));
    measure.show(now.measure);
    over.show(now.over);
    over.element.hidden = sweep.parameters.length < 2;
    table.update(sweep, now.measure, now.unit);
    draw();
  }

  function draw(): void {
    const now = chosen();
    const inks = inksOf(store.get().theme);
    const { lines, names } = meanLines(sweep, now.measure, now.over);
    plot?.destroy();
    plot = null;
    legend.replaceChildren(
      ...(lines.length > 1 ? lines : []).map((line, i) => {
        const swatch = h("span", { class: "swatch", "aria-hidden": "true" });
        swatch.style.background = inks.lines[i % inks.lines.length]!;
        return h("li", {}, swatch, line.label);
      }),
    );
    const any = lines.some((line) => line.points.length > 0);
    note.textContent = any ? "Means over the members of a point, with standard errors; faint: single members." : "No member has this measure yet.";
    if (!any) return;
    const { x, means } = aligned(lines);
    const bounds = lines.flatMap((line) => line.points.flatMap((one) => [one.mean - (one.error || 0), one.mean + (one.error || 0), ...one.values]));
    plot = makePlot(
      holder,
      x,
      lines.map((line, i) => ({ label: line.label, values: means[i] as (number | null)[], colour: inks.lines[i % inks.lines.length]!, points: true })),
      {
        width: Math.max(holder.clientWidth, 240),
        height: Math.max(Math.min(holder.clientWidth * 0.68, window.innerHeight - 220), 220),
        inks,
        xLabel: now.over,
        roomy: true,
        ...(names ? { xNames: names } : {}),
        include: [Math.min(...bounds), Math.max(...bounds)],
        over: (self) => drawErrors(self, lines, inks.lines),
      },
    );
    drawn++;
  }

  const stop = store.listen((_, changed) => {
    if (changed.has("measure") || changed.has("over") || changed.has("theme")) update();
  });
  signal.addEventListener("abort", () => {
    stop();
    plot?.destroy();
  });
  onSystemTheme(draw, signal);
  let width = 0;
  const sizes = new ResizeObserver(() => {
    if (holder.clientWidth !== width) draw();
    width = holder.clientWidth;
  });
  sizes.observe(holder);
  signal.addEventListener("abort", () => sizes.disconnect());
  bindKeys([{ keys: ["t"], shown: "t", text: "light, dark", do: theme }], signal);

  follow(source, signal, notices, (next) => {
    sweep = next;
    update();
  });
  update();

  return {
    element,
    ready: new Promise((done) => window.requestAnimationFrame(() => window.requestAnimationFrame(() => done()))),
    state: () => ({
      ...store.get(),
      ...chosen(),
      kind: "sweep",
      members: sweep.members.length,
      finished: sweep.members.filter((member) => member.status === "finished").length,
      running: sweep.members.filter((member) => member.status === "running").length,
      lines: meanLines(sweep, chosen().measure, chosen().over).lines.length,
    }),
    pixelOf: () => null,
    frameCount: () => 0,
    drawn: () => drawn,
  };
}

/** Read the sweep again when it changes, at most once a second. */
function follow(source: Source, signal: AbortSignal, notices: Notices, changed: (sweep: Sweep) => void): void {
  let due = 0;
  const read = async (): Promise<void> => {
    due = 0;
    try {
      const next = await source.json<Sweep>("api/sweep");
      if (signal.aborted) return;
      notices.clear("sweep");
      changed(next);
    } catch (error) {
      notices.problem("sweep", error);
    }
  };
  const stop = source.listen("api/events", {
    change: () => {
      if (!due) due = window.setTimeout(() => void read(), 1000);
    },
    gone: () => notices.say("gone", "The folder of this sweep has gone. What is loaded can still be viewed.", "banner"),
    connected: (there) => {
      if (there) notices.clear("connection");
      else notices.say("connection", "The connection to the program is lost; trying again.", "banner");
    },
    absent: () => {
      const timer = window.setInterval(() => void read(), 5000);
      signal.addEventListener("abort", () => window.clearInterval(timer));
    },
  });
  signal.addEventListener("abort", () => {
    window.clearTimeout(due);
    stop?.();
  });
}

function drawErrors(plot: uPlot, lines: MeanLine[], colours: string[]): void {
  const { ctx } = plot;
  const ratio = window.devicePixelRatio || 1;
  ctx.save();
  lines.forEach((line, i) => {
    ctx.strokeStyle = ctx.fillStyle = colours[i % colours.length]!;
    ctx.lineWidth = 1.3 * ratio;
    for (const point of line.points) {
      const x = plot.valToPos(point.x, "x", true);
      ctx.globalAlpha = 0.3;
      for (const value of point.values) {
        ctx.beginPath();
        ctx.arc(x, plot.valToPos(value, "y", true), 2 * ratio, 0, 2 * Math.PI);
        ctx.fill();
      }
      ctx.globalAlpha = 1;
      if (!(point.error > 0)) continue;
      const low = plot.valToPos(point.mean - point.error, "y", true);
      const high = plot.valToPos(point.mean + point.error, "y", true);
      ctx.beginPath();
      for (const y of [low, high]) {
        ctx.moveTo(x - 4 * ratio, y);
        ctx.lineTo(x + 4 * ratio, y);
      }
      ctx.moveTo(x, low);
      ctx.lineTo(x, high);
      ctx.stroke();
    }
  });
  ctx.restore();
}
