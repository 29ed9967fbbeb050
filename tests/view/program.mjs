// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
// Runs, views and pages for the tests of the page of `repose view`, in Debian's Chromium.

import { spawn, spawnSync } from "node:child_process";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { createInterface } from "node:readline";

const require = createRequire(new URL("../../view/package.json", import.meta.url));
const { chromium } = require("playwright-core");

export const PROGRAM = process.env.REPOSE_PROGRAM;
if (!PROGRAM) throw new Error("REPOSE_PROGRAM names the program");

export const HEAP = `[base]
kind = "row"
half_width = 10
[source]
kind = "pour"
count = 60
rate = 1.0
height = 10
half_width = 2
[stop]
time = 120
[output]
frames = 10
`;

export function folder() {
  return mkdtempSync(join(tmpdir(), "repose-view-"));
}

/** Runs the program to its end in a folder. */
export function repose(place, ...words) {
  const result = spawnSync(PROGRAM, words, { cwd: place, encoding: "utf8" });
  if (result.status !== 0) throw new Error(`repose ${words.join(" ")}: ${result.stderr}`);
  return result.stdout;
}

/** Starts the program in a folder and goes on. */
export function start(place, ...words) {
  return spawn(PROGRAM, words, { cwd: place, stdio: ["ignore", "pipe", "inherit"] });
}

/** A finished run of a scene. */
export function run(scene) {
  const place = folder();
  writeFileSync(join(place, "scene.toml"), scene);
  repose(place, "run", "scene.toml", "--out", "out", "--quiet");
  return join(place, "out");
}

/** The address of a view of a folder, and what ends it. */
export async function view(place) {
  const process = start(".", "view", place, "--no-browser");
  const lines = createInterface({ input: process.stdout });
  const address = await new Promise((found) => lines.once("line", found));
  return { address, end: () => process.kill("SIGINT") };
}

let browser;

/** A page at an address, when it has drawn; it collects its own errors in `page.errors`. */
export async function open(address, options = {}) {
  browser ??= await chromium.launch({
    executablePath: "/usr/bin/chromium",
    args: ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"],
  });
  const page = await browser.newPage({ viewport: { width: 1280, height: 800 }, colorScheme: "light", ...options });
  page.errors = [];
  page.on("pageerror", (error) => page.errors.push(error.message));
  page.on("requestfailed", (request) => page.errors.push(`${request.url()} failed`));
  await page.goto(address);
  await page.waitForFunction(() => window.repose !== undefined);
  await page.evaluate(() => window.repose.ready);
  return page;
}

export async function close() {
  await browser?.close();
  browser = undefined;
}

export const state = (page) => page.evaluate(() => window.repose.state());

/** Waits until a state of the page holds, at most a minute. */
export async function until(page, holds) {
  const deadline = Date.now() + 60_000;
  for (;;) {
    const now = await state(page);
    if (holds(now)) return now;
    if (Date.now() > deadline) throw new Error(`not reached: ${holds}; the state is ${JSON.stringify(now)}`);
    await page.waitForTimeout(50);
  }
}

/** The colour of the pixel at a place of the page, as [red, green, blue]. */
export async function pixel(page, x, y) {
  const picture = await page.screenshot({ clip: { x: Math.round(x), y: Math.round(y), width: 1, height: 1 } });
  return page.evaluate(async (bytes) => {
    const image = await createImageBitmap(new Blob([new Uint8Array(bytes)], { type: "image/png" }));
    const canvas = new OffscreenCanvas(1, 1).getContext("2d");
    canvas.drawImage(image, 0, 0);
    return [...canvas.getImageData(0, 0, 1, 1).data.slice(0, 3)];
  }, [...picture]);
}

export const remove = (place) => rmSync(place, { recursive: true, force: true });
