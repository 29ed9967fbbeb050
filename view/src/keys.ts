// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
// The keyboard, and the page of help that lists it.

import { h, iconButton } from "./dom";

export interface Action {
  /** As `KeyboardEvent.key`. */
  keys: string[];
  shown: string;
  text: string;
  do: () => void;
}

export function bindKeys(actions: Action[], signal: AbortSignal): void {
  window.addEventListener(
    "keydown",
    (event) => {
      if (event.ctrlKey || event.metaKey || event.altKey) return;
      if (document.querySelector("dialog[open]")) return;
      const target = event.target as HTMLElement;
      const tag = target.tagName;
      const types = tag === "INPUT" && (target as HTMLInputElement).type !== "checkbox" && (target as HTMLInputElement).type !== "range";
      if (types || tag === "SELECT" || tag === "TEXTAREA") return;
      if (event.key === " " && (tag === "BUTTON" || tag === "SUMMARY" || (target as HTMLInputElement).type === "checkbox")) return;
      if (/^(Arrow|Home|End)/.test(event.key) && (tag === "INPUT" || target.getAttribute("role") === "tab")) return;
      const action = actions.find((one) => one.keys.includes(event.key));
      if (!action) return;
      event.preventDefault();
      action.do();
    },
    { signal },
  );
}

export function helpDialog(actions: Action[]): { element: HTMLDialogElement; open(): void } {
  const element: HTMLDialogElement = h(
    "dialog",
    { class: "help", "aria-label": "Help", click: (event) => event.target === element && element.close() },
    h("header", {}, h("h2", {}, "Keys and gestures"), iconButton("close", "Close", () => element.close())),
    h(
      "dl",
      { class: "keys" },
      ...actions.flatMap((action) => [h("dt", {}, ...action.shown.split(" ").map((key) => h("kbd", {}, key))), h("dd", {}, action.text)]),
      h("dt", {}, "wheel, pinch"),
      h("dd", {}, "zoom to the pointer"),
      h("dt", {}, "drag"),
      h("dd", {}, "move the picture"),
      h("dt", {}, "click, tap"),
      h("dd", {}, "pick a grain"),
      h("dt", {}, "double click"),
      h("dd", {}, "fit the heap"),
    ),
    h("p", {}, "The address of the page holds the whole view: a copy of it shows the same picture."),
  );
  return { element, open: () => element.showModal() };
}
