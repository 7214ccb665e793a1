// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// How fast the page answers, in Chromium.
//
// usage: node test/measure.mjs PROGRAM
//
// Prints a table: from the command to the picture; from a move of the pointer to the part at its place with all
// conditions told; from a step of a slider to the new region. Each is the median and the greatest of some tens.
import { spawn } from "node:child_process";
import { mkdtempSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import puppeteer from "puppeteer-core";

const program = resolve(process.argv[2] ?? "../build/release/findspace");
const examples = join(new URL(".", import.meta.url).pathname, "../../examples");
const folder = mkdtempSync(join(tmpdir(), "findspace_measure_"));
const kFlags = ["--no-sandbox", "--disable-gpu", "--enable-unsafe-swiftshader", "--disable-quic", "--no-first-run", "--disable-background-networking", "--disable-component-update", "--disable-sync"];

const kHexagon = [[4, 0], [2, 3.5], [-2, 3.5], [-4, 0], [-2, -3.5], [2, -3.5]], kBox = [[-4, -3], [4, -3], [4, 3], [-4, 3]];
const kNotched = [[-3, -3], [3, -3], [3, -1], [0, -1], [0, 3], [-3, 3]], kSquare = [[-3, -3], [3, -3], [3, 3], [-3, 3]];

/// So many shapes in rows, and a part.
function obstacles(count, outline, part) {
  const columns = Math.ceil(Math.sqrt(count));
  const standing = [...Array(count).keys()].map((k) => {
    const x = 20 * (k % columns) + 10 + ((k * 37) % 70) / 10, y = 20 * Math.floor(k / columns) + 10 + ((k * 53) % 70) / 10;
    return { polygon: outline.map(([a, b]) => [Number((x + a).toFixed(1)), Number((y + b).toFixed(1))]) };
  });
  const scene = {
    findspace: 1, unit: "mm", moving: "part", where: "inside(part, sheet) and clear(part, standing, 1)",
    shapes: { sheet: { box: { min: [0, 0], max: [20 * columns + 20, 20 * columns + 20] } }, standing, part: { polygon: part } },
  };
  const path = join(folder, `obstacles-${count}.json`);
  writeFileSync(path, JSON.stringify(scene));
  return path;
}

const middle = (all) => [...all].sort((a, b) => a - b)[Math.floor(all.length / 2)];
const row = (what, times) => console.log(`| ${what} | ${times.length} | ${middle(times).toFixed(1)} | ${Math.max(...times).toFixed(1)} |`);

async function start(browser, path) {
  const begun = performance.now();
  const child = spawn(program, ["view", path, "--no-open"], { stdio: ["ignore", "pipe", "inherit"] });
  const link = await new Promise((done) => child.stdout.once("data", (d) => done(String(d).trim())));
  const page = await browser.newPage();
  await page.setViewport({ width: 1280, height: 800 });
  await page.goto(link, { waitUntil: "domcontentloaded" });
  await page.waitForFunction(() => document.getElementById("verdict").textContent !== "", { polling: "mutation", timeout: 240000 });
  return { child, page, took: performance.now() - begun, ended: new Promise((done) => child.once("exit", done)) };
}

async function drag(page) {
  await page.evaluate(() => {
    globalThis.took = [];
    let at = 0;
    addEventListener("pointermove", () => { at = performance.now(); }, { capture: true });
    // The conditions are told after the part is at its place.
    new MutationObserver(() => {
      if (at) globalThis.took.push(performance.now() - at);
      at = 0;
    }).observe(document.getElementById("atoms"), { childList: true });
  });
  const box = await page.$eval("#layer-part .part", (e) => { const b = e.getBoundingClientRect(); return [b.x, b.y, b.width, b.height]; });
  const x = box[0] + box[2] * 0.2, y = box[1] + box[3] * 0.9;
  await page.mouse.move(x, y);
  await page.mouse.down();
  for (let k = 1; k <= 40; ++k) {
    await page.mouse.move(x + 4 * k, y + 60 * Math.sin(k / 6));
    await page.waitForFunction((n) => globalThis.took.length >= n, {}, k);
  }
  await page.mouse.up();
  return page.evaluate(() => globalThis.took);
}

const slide = (page) => page.evaluate(async () => {
  const range = document.querySelector("#sliders input[type=range]"), took = [];
  for (let k = 1; k <= 30; ++k) {
    const begun = performance.now();
    await new Promise((done) => {
      const seen = new MutationObserver(() => { seen.disconnect(); done(); });
      seen.observe(document.getElementById("layer-region"), { childList: true });
      range.value = String(1 + 0.05 * k);
      range.dispatchEvent(new Event("input"));
    });
    took.push(performance.now() - begun);
    await new Promise((done) => setTimeout(done, 100));
  }
  return took;
});

const browser = await puppeteer.launch({ executablePath: "/usr/bin/chromium", args: kFlags });
const finish = async ({ page, ended }) => { await page.close(); await ended; };
console.log("| what | times | median ms | greatest ms |\n|---|---|---|---|");
for (const name of ["peg", "first", "door-leaf", "carts", "rooms"]) {
  const times = [];
  for (let k = 0; k < 3; ++k) {
    const opened = await start(browser, join(examples, name + ".json"));
    times.push(opened.took);
    await finish(opened);
  }
  row(`command to picture, examples/${name}.json`, times);
}
for (const [count, outline, part, what] of [[100, kHexagon, kNotched, "hexagons"], [10000, kBox, kSquare, "boxes"]]) {
  const opened = await start(browser, obstacles(count, outline, part));
  row(`command to picture, ${count} ${what}`, [opened.took]);
  row(`drag, ${count} ${what}`, await drag(opened.page));
  if (count === 100) row(`slider step, ${count} ${what}`, await slide(opened.page));
  await finish(opened);
}
await browser.close();
