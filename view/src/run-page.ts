// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
// The page of one run: its parts, and which of them follow which change.

import type { Run } from "./api";
import { App } from "./app";
import { loadData } from "./data";
import { button, h, icon, iconButton } from "./dom";
import { rowOf } from "./frame";
import { bindKeys, helpDialog, type Action } from "./keys";
import { followRun } from "./live";
import { Notices } from "./notices";
import { grainPanel } from "./panel-grain";
import { picturePanel } from "./panel-picture";
import { avalanchePanel, runPanel } from "./panel-run";
import { seriesPanel } from "./panel-series";
import { Picture } from "./picture";
import { Player } from "./player";
import { Pointer } from "./pointer";
import { saveBlob } from "./save";
import type { Source } from "./source";
import type { Store } from "./state";
import { Tabs } from "./tabs";
import { timeline } from "./timeline";
import { nextTheme, onSystemTheme } from "./theme";

export interface Page {
  element: HTMLElement;
  /** When what it shows first is there. */
  ready: Promise<void>;
  /** For tests. */
  state(): object;
  pixelOf(id: number): [number, number] | null;
  frameCount(): number;
  drawn(): number;
}

export async function runPage(source: Source, prefix: string, store: Store, signal: AbortSignal, back: (() => void) | null): Promise<Page> {
  const run = await source.json<Run>(`${prefix}run`);
  const notices = new Notices();
  const app = new App(source, prefix, run, store, notices, signal);
  const picture = new Picture(app);
  const player = new Player(app, () => time.update());
  const time = timeline(app, player);
  const pointer = new Pointer(app, picture, () => ruler.setAttribute("aria-pressed", "false"));
  const centre = (row: number): void => {
    const [x, y] = [app.frame!.position[2 * row]!, app.frame!.position[2 * row + 1]!];
    store.set({ camera: { ...picture.camera(), x, y }, fitted: false });
  };

  const layers = picturePanel(app);
  const grain = grainPanel(app, centre);
  const series = seriesPanel(app);
  const about = runPanel(app);
  const avalanches = avalanchePanel(app);
  const tabs = new Tabs(
    [
      { name: "picture", label: "Picture", element: layers.element },
      { name: "grain", label: "Grain", element: grain.element },
      { name: "series", label: "Series", element: series.element },
      { name: "avalanches", label: "Avalanches", element: avalanches.element },
      { name: "run", label: "Run", element: about.element },
    ],
    (tab) => store.set({ tab }),
  );

  const title = h("h1", {});
  const status = h("span", { class: "status" });
  const measure = (): void => {
    const on = !pointer.measuring;
    if (store.get().line && on) {
      // The button first takes the old line away.
      store.set({ line: null });
    }
    pointer.measure(on);
    ruler.setAttribute("aria-pressed", String(on));
  };
  const ruler = iconButton("ruler", "Measure an angle (m): click two points", measure);
  ruler.setAttribute("aria-pressed", "false");
  const saving = h(
    "details",
    { class: "menu" },
    h("summary", { class: "icon", "aria-label": "Save the picture", title: "Save the picture as PNG" }),
    h("div", {}, ...[2, 3, 4].map((times) => button(`PNG, ${times}×`, () => void save(times)))),
  );
  saving.querySelector("summary")!.append(icon("save"));
  const save = async (times: number): Promise<void> => {
    saving.open = false;
    try {
      const moment = app.frame ? `-t${Number(app.frame.time.toPrecision(6))}` : "";
      saveBlob(await picture.image(times), `${(run.title || "repose").slice(0, 40).replace(/[^\p{L}\p{N}]+/gu, "-")}${moment}.png`);
    } catch (error) {
      notices.problem("save", error);
    }
  };
  window.addEventListener("pointerdown", (event) => saving.contains(event.target as Node) || (saving.open = false), { signal });
  const theme = (): void => store.set({ theme: nextTheme(store.get().theme) });
  const actions: Action[] = [
    { keys: [" "], shown: "space", text: "play, pause", do: () => player.toggle() },
    { keys: ["ArrowLeft", "ArrowRight"], shown: "← →", text: "frame before, next frame", do: () => undefined },
    { keys: ["Home"], shown: "home", text: "first frame", do: () => player.step(-Infinity) },
    { keys: ["End"], shown: "end", text: "last frame; follows a running run", do: () => player.step(Infinity) },
    { keys: ["f"], shown: "f", text: "fit the heap", do: () => picture.fitTo() },
    { keys: ["F"], shown: "shift f", text: "fit the whole box", do: () => picture.fitTo(true) },
    { keys: ["+", "="], shown: "+ −", text: "zoom", do: () => zoom(1.25) },
    { keys: ["-"], shown: "", text: "", do: () => zoom(0.8) },
    { keys: ["c"], shown: "c", text: "contacts on, off", do: () => store.set({ contacts: !store.get().contacts }) },
    { keys: ["m"], shown: "m", text: "measure an angle with two clicks", do: measure },
    { keys: ["t"], shown: "t", text: "light, dark", do: theme },
    { keys: ["Escape"], shown: "esc", text: "let go of the grain and the line", do: () => letGo() },
    { keys: ["?"], shown: "?", text: "this list", do: () => help.open() },
  ];
  const zoom = (factor: number): void => {
    const camera = picture.camera();
    picture.move();
    store.set({ camera: { ...camera, width: camera.width / factor }, fitted: false });
  };
  const letGo = (): void => {
    if (pointer.measuring) measure();
    store.set({ picked: -1, chase: false, line: null });
  };
  const help = helpDialog(actions.filter((action) => action.shown));
  bindKeys(
    [
      { keys: ["ArrowLeft"], shown: "", text: "", do: () => player.step(-1) },
      { keys: ["ArrowRight"], shown: "", text: "", do: () => player.step(1) },
      ...actions,
    ],
    signal,
  );

  const stage = h("div", { class: "stage" }, picture.canvas, picture.overlay);
  const element = h(
    "main",
    { class: "run" },
    h(
      "header",
      {},
      back ? button("← sweep", back, { class: "text back" }) : null,
      title,
      status,
      h(
        "div",
        { class: "tools", role: "toolbar", "aria-label": "Tools" },
        iconButton("fit", "Fit the heap (f)", () => picture.fitTo()),
        ruler,
        saving,
        iconButton("theme", "Light or dark (t)", theme),
        iconButton("help", "Keys and gestures (?)", () => help.open()),
      ),
    ),
    notices.element,
    stage,
    time.element,
    tabs.element,
    help.element,
  );

  const showHead = (): void => {
    title.textContent = app.run.title || "Run";
    title.title = app.run.title;
    document.title = `${app.run.title || "run"} – Repose`;
    status.textContent = app.run.status;
    status.dataset["status"] = app.run.status;
    tabs.allow("avalanches", app.run.avalanches.length > 0);
  };
  const activate = (): void => {
    tabs.show(store.get().tab);
    series.active(store.get().tab === "series");
  };

  app.on("frame", () => {
    picture.arrived();
    time.update();
    layers.update();
    grain.update();
    series.redraw();
    avalanches.update();
    player.ahead();
    const { frame } = app;
    if (frame) picture.canvas.setAttribute("aria-label", `Picture of ${frame.grains} grains at time ${frame.time}`);
  });
  app.on("run", () => {
    showHead();
    time.update();
    about.update();
    avalanches.update();
  });
  app.on("data", () => {
    if (store.get().fitted && app.frame && store.get().camera) picture.fitTo();
    layers.update();
    series.update();
    about.update();
    picture.ask();
  });
  const stop = store.listen((state, changed) => {
    if (changed.has("frame")) void app.show();
    if (changed.has("tab")) activate();
    if (changed.has("picked") || changed.has("tab") || changed.has("chase")) grain.update();
    if (changed.has("tab")) about.update();
    if (changed.has("series")) series.update();
    if (changed.has("theme")) recolour();
    if (changed.has("base") && state.fitted) picture.fitTo();
    if (changed.has("camera") && !state.camera && app.frame) picture.fitTo();
    layers.update();
    time.update();
    picture.ask();
  });
  const recolour = (): void => {
    series.update();
    grain.restyle();
    picture.ask();
  };
  signal.addEventListener("abort", stop);
  onSystemTheme(recolour, signal);
  const sizes = new ResizeObserver(() => {
    picture.resize(stage.clientWidth, stage.clientHeight);
  });
  sizes.observe(stage);
  let wide = 0;
  const widths = new ResizeObserver(() => {
    if (tabs.element.clientWidth === wide) return;
    wide = tabs.element.clientWidth;
    series.update();
    grain.restyle();
  });
  widths.observe(tabs.element);
  signal.addEventListener("abort", () => {
    sizes.disconnect();
    widths.disconnect();
    player.toggle(false);
  });

  showHead();
  time.update();
  layers.update();
  about.update();
  grain.update();
  activate();
  const ready = (async () => {
    await Promise.all([app.show(), loadData(app)]);
    followRun(app);
    await new Promise((done) => window.requestAnimationFrame(() => window.requestAnimationFrame(done)));
  })();

  return {
    element,
    ready,
    state: () => {
      const state = store.get();
      const { frame } = app;
      return {
        ...state,
        kind: "run",
        frame: frame?.key ?? null,
        time: frame?.time ?? null,
        index: app.index(),
        frames: app.run.frames.length,
        follow: state.frame === "",
        status: app.run.status,
        grainCount: frame?.grains ?? 0,
        contactCount: frame?.contacts ?? 0,
        playing: player.playing,
        measuring: pointer.measuring,
      };
    },
    pixelOf: (id) => {
      const row = app.frame ? rowOf(app.frame, id) : -1;
      if (row < 0) return null;
      const box = picture.canvas.getBoundingClientRect();
      const [x, y] = picture.pixelOf(app.frame!.position[2 * row]!, app.frame!.position[2 * row + 1]!);
      return [box.left + x, box.top + y];
    },
    frameCount: () => app.run.frames.length,
    drawn: () => picture.drawn,
  };
}
