// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
// Lines above the page: what failed, and that a folder has gone. One line for each subject.

import { h, icon } from "./dom";

export class Notices {
  readonly element = h("div", { class: "notices", role: "status", "aria-live": "polite" });
  private readonly lines = new Map<string, HTMLElement>();

  say(subject: string, text: string, kind: "problem" | "banner" = "problem"): void {
    const close = h("button", { type: "button", class: "icon", "aria-label": "Dismiss", click: () => this.clear(subject) }, icon("close"));
    const line = h("p", { class: kind }, h("span", {}, text), close);
    const old = this.lines.get(subject);
    if (old) old.replaceWith(line);
    else this.element.append(line);
    this.lines.set(subject, line);
  }

  problem(subject: string, error: unknown): void {
    this.say(subject, error instanceof Error ? error.message : String(error));
  }

  clear(subject: string): void {
    this.lines.get(subject)?.remove();
    this.lines.delete(subject);
  }
}
