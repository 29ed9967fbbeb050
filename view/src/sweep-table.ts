// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
// The members of a sweep: what each varies, how far it is, and its measure. A click on the name opens it.

import type { Sweep } from "./api";
import { labelled, textOf } from "./colour";
import { button, h } from "./dom";
import { shortName } from "./panel-series";
import { shortKey, valueText } from "./sweep-lines";

export function memberTable(open: (member: string) => void): { element: HTMLElement; update(sweep: Sweep, measure: string, unit: string): void } {
  const head = h("tr", {});
  const body = h("tbody", {});
  const element = h("div", { class: "members", tabindex: 0, role: "region", "aria-label": "Members of the sweep" }, h("table", {}, h("thead", {}, head), body));
  let shown = "";

  function update(sweep: Sweep, measure: string, unit: string): void {
    const key = JSON.stringify([sweep.members, measure]);
    if (key === shown) return;
    shown = key;
    const points = new Map(sweep.points.map((point) => [point.name, point]));
    const columns = ["member", ...sweep.parameters.map((name) => shortKey(name, sweep.parameters)), "seed", "status", labelled(shortName(measure), unit)];
    head.replaceChildren(...columns.map((name) => h("th", { scope: "col" }, name)));
    body.replaceChildren(
      ...sweep.members.map((member) => {
        const values = points.get(member.point)?.values ?? {};
        const started = member.status !== "waiting";
        return h(
          "tr",
          {},
          h("td", {}, started ? button(member.name, () => open(member.name), { title: `Open ${member.name}` }) : member.name),
          ...sweep.parameters.map((name) => h("td", {}, valueText(values[name]))),
          h("td", {}, String(member.seed)),
          h("td", { title: member.message }, h("span", { class: "status", "data-status": member.status }, member.status)),
          h("td", {}, textOf(member.measures[measure], 4)),
        );
      }),
    );
  }
  return { element, update };
}
