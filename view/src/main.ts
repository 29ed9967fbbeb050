// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
// Start: read what the folder is and show it; another member of a sweep is another page in the same document.

import type { Folder } from "./api";
import { button, h } from "./dom";
import { fromHash, toHash } from "./hash";
import { runPage, type Page } from "./run-page";
import { pageSource, type Source } from "./source";
import { initialState, Store, type ViewState } from "./state";
import { sweepPage } from "./sweep-page";
import { applyTheme, onSystemTheme } from "./theme";

interface Handle {
  ready: Promise<void>;
  state(): object;
  pixelOf(id: number): [number, number] | null;
  frameCount(): number;
  readonly drawn: number;
}

declare global {
  interface Window {
    repose: Handle;
  }
}

const forever = new AbortController().signal;
let page: Page | null = null;
let ending = new AbortController();
let folder: Folder | null = null;
const store = new Store(fromHash(location.hash));

function fail(error: unknown): void {
  const text = error instanceof Error ? error.message : String(error);
  const back = folder?.kind === "sweep" && store.get().member !== "" ? button("← sweep", () => move("")) : null;
  const again = button("try again", () => location.reload());
  document.body.replaceChildren(h("main", { class: "failed" }, h("h1", {}, "Repose"), h("p", { role: "alert" }, text), back, " ", again));
}

async function open(source: Source): Promise<void> {
  ending.abort();
  ending = new AbortController();
  const { signal } = ending;
  const { member } = store.get();
  const sweep = folder!.kind === "sweep";
  const next =
    sweep && member === ""
      ? await sweepPage(source, store, signal, (name) => move(name))
      : await runPage(source, member ? `api/members/${member.split("/").map(encodeURIComponent).join("/")}/` : "api/", store, signal, sweep ? () => move("") : null);
  if (signal.aborted) return;
  page = next;
  document.body.replaceChildren(next.element);
  await next.ready;
}

/** To a member of the sweep, or back to it: an entry in the history of the browser. */
function move(member: string): void {
  const { theme, measure, over } = store.get();
  location.hash = toHash({ ...initialState, theme, measure, over, member });
}

async function start(): Promise<void> {
  applyTheme(store.get().theme);
  onSystemTheme(() => applyTheme(store.get().theme), forever);
  const source = pageSource();
  folder = await source.json<Folder>("api/folder");
  document.title = `${folder.name} – Repose`;
  await open(source);

  let due = 0;
  let written = toHash(store.get());
  const write = (): void => {
    due = 0;
    written = toHash(store.get());
    if (location.protocol === "about:") return; // the page lies in a notebook, and has no address
    history.replaceState(null, "", written ? `#${written}` : location.pathname + location.search);
  };
  store.listen((state, changed) => {
    if (changed.has("theme")) applyTheme(state.theme);
    // Browsers limit how often the address may change.
    if (!due) due = window.setTimeout(write, 250);
  });
  if (due === 0) write();
  window.addEventListener("hashchange", () => {
    if (location.hash.replace(/^#/, "") === written) return;
    window.clearTimeout(due);
    const before = store.get().member;
    const state: ViewState = fromHash(location.hash);
    if (state.member !== before) ending.abort();
    store.set(state);
    if (state.member !== before) opened = open(source).catch(fail);
  });
}

let opened: Promise<void> = start().catch(fail);

window.repose = {
  get ready() {
    return opened;
  },
  state: () => page?.state() ?? {},
  pixelOf: (id) => page?.pixelOf(id) ?? null,
  frameCount: () => page?.frameCount() ?? 0,
  get drawn() {
    return page?.drawn() ?? 0;
  },
};
