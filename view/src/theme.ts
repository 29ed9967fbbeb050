// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
// Light and dark: colours of the picture; those of the page are in page.css.

import type { Theme } from "./state";

export interface Inks {
  paper: string;
  ink: string;
  faint: string;
  plain: string;
  fixed: string;
  edge: string;
  push: string;
  pull: string;
  slide: string;
  wall: string;
  mark: string;
  /** Lines of series and theories, in this order. */
  lines: string[];
}

const light: Inks = {
  paper: "#ffffff",
  ink: "#1d2329",
  faint: "#8a8f94",
  plain: "#ece9e2",
  fixed: "#d3cec2",
  edge: "#b3ada0",
  push: "#14304d",
  pull: "#c2331f",
  slide: "#d97b00",
  wall: "#3a3f45",
  mark: "#c2331f",
  lines: ["#14588f", "#b8470f", "#23744d", "#8a3f8f", "#8b6a00", "#4d5963"],
};

const dark: Inks = {
  paper: "#12151a",
  ink: "#e4e1da",
  faint: "#868b92",
  plain: "#272c34",
  fixed: "#3a414b",
  edge: "#4b535f",
  push: "#f0e7d3",
  pull: "#ff7d66",
  slide: "#ffb84d",
  wall: "#b9bcc0",
  mark: "#ff7d66",
  lines: ["#6cb2ee", "#f0935a", "#62c796", "#d490d8", "#d9b84a", "#a9b4bf"],
};

const system = window.matchMedia("(prefers-color-scheme: dark)");

export function isDark(theme: Theme): boolean {
  return theme === "auto" ? system.matches : theme === "dark";
}

export function inksOf(theme: Theme): Inks {
  return isDark(theme) ? dark : light;
}

export function applyTheme(theme: Theme): void {
  document.documentElement.dataset["theme"] = isDark(theme) ? "dark" : "light";
}

export function onSystemTheme(call: () => void, signal: AbortSignal): void {
  system.addEventListener("change", call, { signal });
}

/** The other of light and dark; what the system has anyway is kept as "auto". */
export function nextTheme(theme: Theme): Theme {
  const next = isDark(theme) ? "light" : "dark";
  return (next === "dark") === system.matches ? "auto" : next;
}
