// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// How fast the page answers, in Chromium.
//
// usage: node test/measure.mjs PROGRAM
//
// Prints a table: from the command to the picture; from a move of the pointer to the part at its place with all
// conditions told; from a step of a slider to the new region. Each is the median and the greatest of some tens, and the
// processor time of one, of the program and of all of Chromium together: what a machine that does nothing else takes at
// the most.
import { spawn } from "node:child_process";
import { mkdtempSync, readdirSync, readFileSync, writeFileSync } from "node:fs";
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

/// Milliseconds that these processes and all that they began have run.
function ran(roots) {
  const children = new Map(), times = new Map();
  for (const id of readdirSync("/proc").filter((name) => /^[0-9]+$/.test(name))) {
    try {
      const text = readFileSync(`/proc/${id}/stat`, "utf8"), fields = text.slice(text.lastIndexOf(")") + 2).split(" ");
      children.set(fields[1], [...(children.get(fields[1]) ?? []), id]);
      times.set(id, 10 * (Number(fields[11]) + Number(fields[12]) + Number(fields[13]) + Number(fields[14])));
    } catch { /* it has ended */ }
  }
  const all = (id) => (times.get(id) ?? 0) + (children.get(id) ?? []).reduce((sum, k) => sum + all(k), 0);
  return roots.reduce((sum, id) => sum + all(String(id)), 0);
}

const middle = (all) => [...all].sort((a, b) => a - b)[Math.floor(all.length / 2)];
const row = (what, times, processor) => console.log(`| ${what} | ${times.length} | ${middle(times).toFixed(1)} | ${Math.max(...times).toFixed(1)} | ${(processor / times.length).toFixed(1)} |`);

/// The times that `act` gives, in a row, with the processor time of each.
async function measured(what, opened, act) {
  const roots = [opened.child.pid, browser.process().pid], before = ran(roots);
  const times = await act(opened.page);
  row(what, times, ran(roots) - before);
}

async function start(browser, path) {
  const begun = performance.now();
  const child = spawn(program, ["view", path, "--no-open"], { stdio: ["ignore", "pipe", "inherit"] });
  const link = await new Promise((done) => child.stdout.once("data", (d) => done(String(d).trim())));
  const page = await browser.newPage();
  page.setDefaultTimeout(600_000);
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
    await page.waitForFunction((n) => globalThis.took.length >= n, { polling: "mutation" }, k);
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
console.log("| what | times | median ms | greatest ms | processor ms |\n|---|---|---|---|---|");
for (const name of ["peg", "first", "door-leaf", "carts", "rooms"]) {
  const times = [];
  let processor = 0;
  for (let k = 0; k < 3; ++k) {
    const before = ran([browser.process().pid]);
    const opened = await start(browser, join(examples, name + ".json"));
    times.push(opened.took);
    processor += ran([opened.child.pid, browser.process().pid]) - before;
    await finish(opened);
  }
  row(`command to picture, examples/${name}.json`, times, processor);
}
for (const [count, outline, part, what] of [[100, kHexagon, kNotched, "hexagons"], [10000, kBox, kSquare, "boxes"]]) {
  const before = ran([browser.process().pid]), opened = await start(browser, obstacles(count, outline, part));
  row(`command to picture, ${count} ${what}`, [opened.took], ran([opened.child.pid, browser.process().pid]) - before);
  await measured(`drag, ${count} ${what}`, opened, drag);
  if (count === 100) await measured(`slider step, ${count} ${what}`, opened, slide);
  await finish(opened);
}
await browser.close();
