// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
// The page of `repose view` as a reader uses it: what is drawn, picked, scrubbed, linked, and followed.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { close, HEAP, open, pixel, repose, run, state, until, view } from "./program.mjs";

let place;
let server;
let page;

before(async () => {
  place = run(HEAP);
  server = await view(place);
  page = await open(server.address);
});

after(async () => {
  server.end();
  await close();
});

/** A fresh page at a fragment of the address. */
const at = (hash, options) => open(`${server.address}#${hash}`, options);

/** Ids of moving grains, by their places in the last state. */
async function placesOf(id) {
  return page.evaluate((wanted) => window.repose.pixelOf(wanted), id);
}

test("the last moment is shown with all grains and frames, and nothing fails", async () => {
  const now = await state(page);
  const summary = JSON.parse(readFileSync(join(place, "summary.json"), "utf8"));
  assert.equal(now.status, "finished");
  assert.equal(now.frame, "last");
  assert.equal(now.grainCount, 60 + 21); // on the base of half-width 10
  assert.equal(now.frames, await page.evaluate(() => window.repose.frameCount()));
  assert.ok(now.frames >= 12 && Math.abs(now.time - summary.time) < 1e-3);
  assert.deepEqual(page.errors, []);
});

test("a grain has the colour of its value", async () => {
  // By id from 0 to 80: the last is at the high end of viridis, the one in the middle is in the middle.
  const coloured = await at("field=id&contacts=0&base=off");
  const colourOf = async (id) => pixel(coloured, ...(await coloured.evaluate((one) => window.repose.pixelOf(one), id)));
  for (const [id, wanted] of [[80, [253, 231, 37]], [40, [33, 145, 140]]]) {
    const found = await colourOf(id);
    const off = Math.max(...found.map((one, k) => Math.abs(one - wanted[k])));
    // The map has 48 stops of matplotlib's 256 colours, and the picked pixel is rounded.
    assert.ok(off <= 12, `grain ${id} is ${found}, not ${wanted}`);
  }
  await coloured.close();
});

test("contacts are lines between grains, and the threshold takes them away", async () => {
  const [first, second] = await strongContact();
  const middle = [(first[0] + second[0]) / 2, (first[1] + second[1]) / 2];
  const drawn = await at("grains=hidden&base=off");
  assert.ok(Math.max(...(await pixel(drawn, ...middle))) < 160, "a line is dark");
  await drawn.close();
  const without = await at("grains=hidden&base=off&contacts=0");
  assert.ok(Math.min(...(await pixel(without, ...middle))) > 225, "without lines the page is light");
  await without.close();
});

/** Arrays of the last frame, as the server sends them. */
async function lastFrame() {
  const text = await (await fetch(`${server.address}api/frame/last`)).arrayBuffer();
  const length = new DataView(text).getUint32(4, true);
  const header = JSON.parse(new TextDecoder().decode(new Uint8Array(text, 8, length)));
  const array = (name, Kind) => {
    const one = header.arrays[name];
    return new Kind(text, 8 + length + one.offset, one.shape.reduce((a, b) => a * b));
  };
  return { id: array("id", Uint32Array), flags: array("flags", Uint32Array), pair: array("pair", Uint32Array), force: array("normal_force", Float32Array) };
}

/** Places of the partners of the strongest contact between two moving grains, in a page without the base. */
async function strongContact() {
  const { id, flags, pair, force } = await lastFrame();
  let best = -1;
  force.forEach((value, k) => {
    const inside = pair[2 * k + 1] < id.length && !(flags[pair[2 * k]] & 1) && !(flags[pair[2 * k + 1]] & 1);
    if (inside && (best < 0 || value > force[best])) best = k;
  });
  const plain = await at("grains=hidden&base=off");
  const ends = await plain.evaluate((ids) => ids.map((one) => window.repose.pixelOf(one)), [id[pair[2 * best]], id[pair[2 * best + 1]]]);
  await plain.close();
  return ends;
}

test("a click picks a grain, and the address names it", async () => {
  const [x, y] = await placesOf(50);
  await page.mouse.click(x, y);
  const now = await until(page, (s) => s.picked >= 0);
  assert.equal(now.picked, 50);
  await page.waitForURL(/picked=50/);
  const inputs = await page.evaluate(() => [...document.querySelectorAll("input")].map((one) => one.value));
  assert.ok(inputs.includes("50"), `${inputs}`);
  const { id, pair } = await lastFrame();
  const contacts = pair.filter((row) => id[row] === 50).length;
  const rows = await page.locator("table", { hasText: "partner" }).locator("tbody tr").count();
  assert.ok(contacts > 1 && rows === contacts, `${rows} rows for ${contacts} contacts`);
});

test("keys and the slider move through the moments", async () => {
  await page.keyboard.press("Home");
  assert.equal((await until(page, (s) => s.index === 0)).time < 20, true);
  await page.keyboard.press("ArrowRight");
  await until(page, (s) => s.index === 1);
  const slider = page.locator('input[type="range"]').first();
  await slider.focus();
  await page.keyboard.press("End");
  const last = await until(page, (s) => s.index === s.frames - 1);
  assert.equal(last.frame, "last");
});

test("space plays and stops", async () => {
  await page.keyboard.press("Home");
  await until(page, (s) => s.index === 0);
  await page.locator("canvas").first().focus().catch(() => page.locator("body").focus());
  await page.keyboard.press("Space");
  await until(page, (s) => s.playing && s.index >= 2);
  await page.keyboard.press("Space");
  await until(page, (s) => !s.playing);
});

test("a link reproduces the picture", async () => {
  const first = await at("frame=000003&field=speed&threshold=0.5&picked=40&camera=1,3,20&theme=light");
  const again = await open(first.url());
  assert.deepEqual(await state(first), await state(again));
  assert.deepEqual(await first.screenshot(), await again.screenshot());
  assert.equal((await state(again)).threshold, 0.5);
  await first.close();
  await again.close();
});

test("a nonsensical link shows the run as usual", async () => {
  const odd = await at("frame=zzz&field=nope&range=a,b&camera=0,0,-1&threshold=NaN&picked=99999999&theme=pink&%E0%A4%A");
  assert.equal((await state(odd)).grainCount > 0, true);
  assert.deepEqual(odd.errors, []);
  await odd.close();
});

test("the wheel zooms to the pointer", async () => {
  const zoomed = await at("");
  const before = await zoomed.evaluate(() => window.repose.pixelOf(50));
  await zoomed.mouse.move(...before);
  await zoomed.mouse.wheel(0, -600);
  await until(zoomed, (s) => !s.fitted);
  const after = await zoomed.evaluate(() => window.repose.pixelOf(50));
  assert.ok(Math.hypot(after[0] - before[0], after[1] - before[1]) < 2, `${before} became ${after}`);
  await zoomed.close();
});

test("it fits a telephone, in the dark too", async () => {
  const small = await at("", { viewport: { width: 390, height: 844 }, colorScheme: "dark", hasTouch: true });
  const width = await small.evaluate(() => document.documentElement.scrollWidth);
  assert.ok(width <= 390, `the page is ${width} wide`);
  const back = await pixel(small, 20, 200);
  assert.ok(Math.max(...back) < 60, `the background is ${back}`);
  await small.close();
});

test("every control has a name", async () => {
  const nameless = await page.evaluate(() =>
    [...document.querySelectorAll("button, input, select")]
      .filter((one) => one.checkVisibility())
      .filter((one) => !(one.getAttribute("aria-label") || one.labels?.length || one.textContent.trim() || one.title))
      .map((one) => one.outerHTML));
  assert.deepEqual(nameless, []);
});

test("an exported page shows the same from disk, and asks nobody", async () => {
  repose(".", "export", place, "--to", "html", "--quiet");
  const asked = [];
  const file = await open(`file://${place}/export/html/run.html`);
  file.on("request", (request) => asked.push(request.url()));
  const fresh = await at("");
  const [now, there] = [await state(file), await state(fresh)];
  for (const key of ["frames", "grainCount", "contactCount", "status", "time"]) assert.equal(now[key], there[key], key);
  await file.keyboard.press("Home");
  await until(file, (s) => s.index === 0);
  assert.deepEqual(asked.filter((url) => url.startsWith("http")), []);
  assert.deepEqual(file.errors, []);
  await fresh.close();
  await file.close();
});
