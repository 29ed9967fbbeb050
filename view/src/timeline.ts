// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
// The bar of time: scrubber, steps, play and its speed, and the way back to the last frame of a running run.

import type { App } from "./app";
import { textOf } from "./colour";
import { button, h, icon, iconButton } from "./dom";
import { speeds, type Player } from "./player";

export function timeline(app: App, player: Player): { element: HTMLElement; update(): void } {
  const play = iconButton("play", "Play", () => player.toggle());
  const slider = h("input", {
    type: "range",
    min: 0,
    step: 1,
    class: "scrub",
    "aria-label": "Frame",
    input: () => {
      player.toggle(false);
      app.goTo(Number(slider.value));
    },
  });
  const time = h("output", { class: "time" });
  const count = h("span", { class: "count" });
  const speed = h(
    "select",
    { "aria-label": "Frames per second", title: "Frames per second", change: () => void (player.speed = Number(speed.value)) },
    ...speeds.map((value) => h("option", { value, ...(value === player.speed ? { selected: true } : {}) }, `${value}/s`)),
  );
  const live = button("live", () => app.store.set({ frame: "" }), { class: "text live", title: "Follow the last frame" });
  let shown = "";

  function update(): void {
    const frames = app.run.frames;
    const index = app.index();
    slider.max = String(Math.max(frames.length - 1, 0));
    slider.value = String(index);
    slider.disabled = frames.length < 2;
    const entry = frames[index];
    const moment = app.frame && app.frame.key === entry?.key ? app.frame.time : entry?.time;
    const text = entry ? `t = ${textOf(Number((moment ?? 0).toPrecision(6)), 6)} ${app.run.unit.time}` : "no frames yet";
    time.textContent = text;
    count.textContent = entry ? `${index + 1} / ${frames.length}` : "";
    slider.setAttribute("aria-valuetext", `${text}, frame ${index + 1} of ${frames.length}`);
    live.hidden = app.run.status !== "running";
    live.setAttribute("aria-pressed", String(app.store.get().frame === ""));
    const name = player.playing ? "pause" : "play";
    if (name !== shown) {
      shown = name;
      play.replaceChildren(icon(name));
      play.setAttribute("aria-label", player.playing ? "Pause" : "Play");
      play.title = `${player.playing ? "Pause" : "Play"} (space)`;
    }
  }

  const element = h(
    "div",
    { class: "timeline", role: "group", "aria-label": "Time" },
    h(
      "div",
      { class: "steps" },
      iconButton("first", "First frame (home)", () => player.step(-Infinity)),
      iconButton("back", "Frame before (left)", () => player.step(-1)),
      play,
      iconButton("next", "Next frame (right)", () => player.step(1)),
      iconButton("last", "Last frame (end)", () => player.step(Infinity)),
    ),
    slider,
    h("div", { class: "moment" }, time, count),
    speed,
    live,
  );
  return { element, update };
}
