// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
// The panels as tabs: beside the picture, or on a phone as a sheet that opens below it.

import { h } from "./dom";

export interface Tab {
  name: string;
  label: string;
  element: HTMLElement;
}

export class Tabs {
  readonly element: HTMLElement;
  private readonly buttons = new Map<string, HTMLButtonElement>();
  private readonly holder = h("div", { class: "sheet" });
  private shown = "";

  constructor(private readonly tabs: Tab[], private readonly chosen: (name: string) => void) {
    const list = h("div", { class: "tabs", role: "tablist", "aria-label": "Panels", keydown: (event) => this.key(event as KeyboardEvent) });
    for (const tab of tabs) {
      const id = `tab-${tab.name}`;
      const one = h("button", { type: "button", role: "tab", id, "aria-controls": `panel-${tab.name}`, click: () => this.press(tab.name) }, tab.label);
      tab.element.id = `panel-${tab.name}`;
      tab.element.setAttribute("role", "tabpanel");
      tab.element.setAttribute("aria-labelledby", id);
      this.buttons.set(tab.name, one);
      list.append(one);
      this.holder.append(tab.element);
    }
    this.element = h("aside", { class: "side folded" }, list, this.holder);
  }

  show(name: string): void {
    const there = this.tabs.some((tab) => tab.name === name && !this.buttons.get(name)!.hidden) ? name : this.tabs[0]!.name;
    // On a phone, a tab that something else asks for opens the sheet; the usual one at the start does not.
    if (this.shown === "" ? there !== this.tabs[0]!.name : this.shown !== there) this.element.classList.remove("folded");
    this.shown = there;
    for (const tab of this.tabs) {
      const on = tab.name === there;
      tab.element.hidden = !on;
      const button = this.buttons.get(tab.name)!;
      button.setAttribute("aria-selected", String(on));
      button.tabIndex = on ? 0 : -1;
    }
  }

  allow(name: string, on: boolean): void {
    this.buttons.get(name)!.hidden = !on;
  }

  private press(name: string): void {
    if (name === this.shown) this.element.classList.toggle("folded");
    else {
      this.element.classList.remove("folded");
      this.chosen(name);
    }
  }

  private key(event: KeyboardEvent): void {
    const by = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
    if (!by) return;
    const open = this.tabs.filter((tab) => !this.buttons.get(tab.name)!.hidden);
    const at = open.findIndex((tab) => tab.name === this.shown);
    const next = open[(at + by + open.length) % open.length]!;
    this.chosen(next.name);
    this.buttons.get(next.name)!.focus();
    event.preventDefault();
  }
}
