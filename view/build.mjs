// SPDX-FileCopyrightText: 2026 The Repose developers
// SPDX-License-Identifier: BSD-3-Clause
// Bundle the page into one file, dist/page.html: script and style inlined, no address outside of it.
//
//   node build.mjs            write it
//   node build.mjs --check    exit 1 unless it is what the sources give

import { build, transform } from "esbuild";
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { gzipSync } from "node:zlib";

const here = new URL("./", import.meta.url);
const limit = 150_000;

const bundle = await build({
  entryPoints: [new URL("src/main.ts", here).pathname],
  absWorkingDir: here.pathname,
  bundle: true,
  minify: true,
  format: "iife",
  target: ["es2022"],
  charset: "utf8",
  legalComments: "none",
  write: false,
});
const plain = (name) => readFileSync(new URL(name, here), "utf8");
const style = await transform(plain("node_modules/uplot/dist/uPlot.min.css") + plain("src/page.css"), { loader: "css", minify: true, target: ["es2022"], charset: "utf8" });
const uplot = JSON.parse(plain("node_modules/uplot/package.json"));
const notice =
  "<!-- SPDX-FileCopyrightText: 2026 The Repose developers\n" +
  `SPDX-License-Identifier: BSD-3-Clause\nBuilt by view/build.mjs. Colour maps are those of matplotlib (CC0). Holds uPlot ${uplot.version}:\n\n` +
  `${plain("node_modules/uplot/LICENSE").replaceAll("\r", "").trim()} -->\n`;
// The text "</script" would end the script element.
const script = bundle.outputFiles[0].text.trim().replaceAll("</script", "<\\/script");
const page = plain("src/page.html")
  .replace("<head>", () => `${notice}<head>`)
  .replace("/* style */", () => style.code.trim())
  .replace("/* script */", () => script);
if (page.split("<!-- repose-data -->").length !== 2) throw new Error("the place for data must be there exactly once");

const packed = gzipSync(page, { level: 9 }).length;
if (packed > limit) throw new Error(`dist/page.html: ${packed} bytes gzipped, more than ${limit}`);
const file = new URL("dist/page.html", here);
if (process.argv.includes("--check")) {
  let there = "";
  try {
    there = readFileSync(file, "utf8");
  } catch {
    // Not built yet.
  }
  if (there !== page) {
    console.error("view/dist/page.html is not what view/src gives: run `npm run build` in view/");
    process.exit(1);
  }
  console.log("view/dist/page.html is fresh");
} else {
  mkdirSync(new URL("dist", here), { recursive: true });
  writeFileSync(file, page);
  console.log(`dist/page.html: ${page.length} characters, ${packed} bytes gzipped`);
}
