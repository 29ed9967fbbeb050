// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
// The page beside a run that grows, is killed, and vanishes, and beside a sweep.

import assert from "node:assert/strict";
import { existsSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { after, test } from "node:test";
import { close, folder, HEAP, open, remove, repose, start, state, until, view } from "./program.mjs";

after(close);

async function exists(path) {
  const deadline = Date.now() + 60_000;
  while (!existsSync(path)) {
    if (Date.now() > deadline) throw new Error(`${path} does not appear`);
    await new Promise((next) => setTimeout(next, 50));
  }
}

test("a growing heap is followed, unless the reader looked back; its end and its loss are said", async () => {
  const place = folder();
  writeFileSync(join(place, "scene.toml"), HEAP.replace("time = 120", "time = 1e7"));
  const growing = start(place, "run", "scene.toml", "--out", "out", "--quiet");
  await exists(join(place, "out/run.h5"));
  const server = await view(join(place, "out"));
  const page = await open(server.address);
  const first = await state(page);
  assert.equal(first.status, "running");
  const later = await until(page, (s) => s.frames > 3);
  assert.ok(later.follow && later.time >= first.time);
  await page.keyboard.press("Home");
  const back = await until(page, (s) => s.index === 0 && !s.follow && s.time < 20);
  await until(page, (s) => s.frames > later.frames + 1);
  assert.equal((await state(page)).time, back.time);
  growing.kill("SIGKILL");
  remove(join(place, "out"));
  await page.getByText(/folder|gone|vanished/i).first().waitFor({ timeout: 60_000 });
  await page.keyboard.press("ArrowRight");
  assert.ok((await state(page)).grainCount > 0);
  await page.close();
  server.end();
  remove(place);
});

test("a sweep lists its members, plots their means and opens one", async () => {
  const place = folder();
  writeFileSync(join(place, "heap.toml"), HEAP.replace("time = 120", "time = 60"));
  writeFileSync(join(place, "sweep.toml"), 'scene = "heap.toml"\nseeds = 2\n[vary]\nbase.spacing = [1.0, 1.1]\n');
  repose(place, "sweep", "sweep.toml", "--out", "out", "--quiet");
  const server = await view(join(place, "out"));
  const page = await open(server.address);
  assert.equal((await state(page)).kind, "sweep");
  const text = await page.locator("body").innerText();
  assert.equal(text.match(/finished/g)?.length >= 4, true);
  await page.getByText("seed-2").first().click().catch(() => page.locator("tbody tr").nth(1).click());
  const member = await until(page, (s) => s.kind === "run" && s.grainCount > 0);
  assert.match(member.member, /seed-/);
  await page.close();
  server.end();
  remove(place);
});
