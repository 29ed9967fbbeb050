// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
// Elements and the few kinds of controls that the panels are made of. Every control has a name for screen readers.

type Child = Node | string | null | undefined;
type Attributes = Record<string, string | number | boolean | ((event: Event) => void) | undefined>;

/** An element: attributes by name, functions as listeners ("click"), then its children. */
export function h<Tag extends keyof HTMLElementTagNameMap>(tag: Tag, attributes: Attributes = {}, ...children: Child[]): HTMLElementTagNameMap[Tag] {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (typeof value === "function") element.addEventListener(name, value);
    else if (value === true) element.setAttribute(name, "");
    else if (value !== undefined && value !== false) element.setAttribute(name, String(value));
  }
  for (const child of children) if (child !== null && child !== undefined) element.append(child);
  return element;
}

export function byId(id: string): HTMLElement {
  return document.getElementById(id)!;
}

const paths: Record<string, string> = {
  play: "M7 4.5v15l12-7.5z",
  pause: "M7 5h3.5v14H7zM13.5 5H17v14h-3.5z",
  back: "M15.5 5v14L6 12z",
  next: "M8.5 5v14l9.5-7z",
  first: "M6 5h2v14H6zM18 5v14l-9-7z",
  last: "M16 5h2v14h-2zM6 5v14l9-7z",
  fit: "M4 9V4h5v2H6v3zM15 4h5v5h-2V6h-3zM4 15h2v3h3v2H4zM18 15h2v5h-5v-2h3z",
  ruler: "M4 20 20 4v16zm8.2-2H18v-5.8z",
  save: "M11 3h2v9l3-3 1.4 1.4L12 16l-5.4-5.6L8 9l3 3zM5 18h14v2H5z",
  theme: "M12 3a9 9 0 1 0 0 18zm1 0v18a9 9 0 0 0 0-18z",
  link: "M10 7H7a5 5 0 0 0 0 10h3v-2H7a3 3 0 0 1 0-6h3zm4 0h3a5 5 0 0 1 0 10h-3v-2h3a3 3 0 0 0 0-6h-3zM8 11h8v2H8z",
  help: "M11 17h2v2h-2zM12 5a4 4 0 0 1 4 4c0 2.5-3 3-3 6h-2c0-4 3-4.3 3-6a2 2 0 0 0-4 0H8a4 4 0 0 1 4-4z",
  close: "M6.4 5 5 6.4 10.6 12 5 17.6 6.4 19 12 13.4 17.6 19 19 17.6 13.4 12 19 6.4 17.6 5 12 10.6z",
};

export function icon(name: string): SVGSVGElement {
  const svg = document.createElementNS("http://www.w3.org/2000/svg", "svg");
  svg.setAttribute("viewBox", "0 0 24 24");
  svg.setAttribute("aria-hidden", "true");
  const path = document.createElementNS("http://www.w3.org/2000/svg", "path");
  path.setAttribute("d", paths[name] ?? "");
  svg.append(path);
  return svg;
}

export function iconButton(name: string, label: string, click: () => void): HTMLButtonElement {
  return h("button", { type: "button", class: "icon", "aria-label": label, title: label, click }, icon(name));
}

export function button(label: string, click: () => void, more: Attributes = {}): HTMLButtonElement {
  return h("button", { type: "button", class: "text", click, ...more }, label);
}

export interface Control<T> {
  element: HTMLElement;
  /** Shows the value, without calling back. */
  show(value: T): void;
}

export type Option = [value: string, label: string];

export function choice(label: string, options: Option[], change: (value: string) => void): Control<string> & { options(list: Option[]): void } {
  const select = h("select", { change: () => change(select.value) });
  let wanted = "";
  const put = (list: Option[]): void => {
    select.replaceChildren(...list.map(([value, name]) => h("option", { value }, name)));
    select.value = wanted;
  };
  put(options);
  return {
    element: h("label", { class: "row" }, h("span", {}, label), select),
    show: (value) => {
      wanted = value;
      select.value = value;
    },
    options: put,
  };
}

export function checkbox(label: string, change: (value: boolean) => void): Control<boolean> {
  const box = h("input", { type: "checkbox", change: () => change(box.checked) });
  return { element: h("label", { class: "check" }, box, h("span", {}, label)), show: (value) => void (box.checked = value) };
}

export function slider(
  label: string,
  [low, high, step]: [number, number, number],
  text: (value: number) => string,
  change: (value: number) => void,
): Control<number> {
  const output = h("output", {});
  const input = h("input", {
    type: "range",
    min: low,
    max: high,
    step,
    input: () => {
      output.textContent = text(Number(input.value));
      input.setAttribute("aria-valuetext", output.textContent);
      change(Number(input.value));
    },
  });
  return {
    element: h("label", { class: "row slide" }, h("span", {}, label), input, output),
    show: (value) => {
      input.value = String(value);
      output.textContent = text(value);
      input.setAttribute("aria-valuetext", output.textContent);
    },
  };
}

/** Two numbers, low and high, with a button that returns to the automatic range. */
export function rangeInputs(change: (range: [number, number] | null) => void): Control<{ range: [number, number]; fixed: boolean }> {
  const one = (name: string): HTMLInputElement => h("input", { type: "number", step: "any", "aria-label": name, change: commit });
  const automatic = button("auto", () => change(null), { title: "Automatic range", "aria-pressed": "true" });
  function commit(): void {
    const pair: [number, number] = [Number(low.value), Number(high.value)];
    if (low.value !== "" && high.value !== "" && pair[0] < pair[1]) change(pair);
  }
  const low = one("lowest value of the range");
  const high = one("highest value of the range");
  return {
    element: h("div", { class: "row range" }, h("span", {}, "range"), low, high, automatic),
    show: ({ range, fixed }) => {
      const put = (input: HTMLInputElement, value: number): void => {
        if (document.activeElement !== input) input.value = String(Number(value.toPrecision(5)));
      };
      put(low, range[0]);
      put(high, range[1]);
      automatic.setAttribute("aria-pressed", String(!fixed));
    },
  };
}

/** A list of names and values. */
export function facts(list: [string, string | Node][]): HTMLElement {
  return h("dl", { class: "facts" }, ...list.flatMap(([name, value]) => [h("dt", {}, name), h("dd", {}, value)]));
}

/** A section of a panel. */
export function section(title: string, ...children: Child[]): HTMLElement {
  return h("section", {}, h("h2", {}, title), ...children);
}
