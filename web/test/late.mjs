// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Tests of run.mjs: other scenes and problems that are dropped on the page, and answers that come late.
import assert from "node:assert/strict";

const tile = { type: "simple_polygon", data: [[0, 0], [2, 0], [2, 2], [0, 2]] };
const strip = (name) => ({ name, strip_height: 2, items: [{ id: "a", demand: 2, shape: tile }] });
const kBlocks = { name: "blocks", container: { "size-x": 2, "size-y": 2 }, "item-types": [{ id: "block", demand: 2, shape: { box: { min: [0, 0, 0], max: [2, 2, 1] } } }] };
const kRoom = {
  findspace: 1, unit: "mm", moving: "part", where: "inside(part, room) and gap(part, block) >= 0",
  shapes: { room: { box: { min: [0, 0, 0], max: [20, 20, 20] } }, block: { box: { min: [5, 5, 0], max: [15, 15, 8] } }, part: { box: { min: [-2, -2, -2], max: [2, 2, 2] } } },
};

const wait = (milliseconds) => new Promise((done) => setTimeout(done, milliseconds));
const drop = (page, content) => page.evaluate((text) => {
  const data = new DataTransfer();
  data.items.add(new File([text], "dropped.json"));
  document.dispatchEvent(new DragEvent("drop", { dataTransfer: data }));
}, JSON.stringify(content));
const press = (page, id) => page.evaluate((id) => document.getElementById(id).click(), id);
const numberIn = (page, id) => page.$eval(`#${id}`, (e) => Number(e.value));

/// From now on answers of one method come so much later.
const delay = (page, method, milliseconds) => page.evaluate((method, milliseconds) => {
  const ask = globalThis.fetch;
  globalThis.fetch = async (where, how) => {
    const answer = await ask(where, how);
    if (how?.body?.includes(`"method":"${method}"`)) await new Promise((done) => setTimeout(done, milliseconds));
    return answer;
  };
}, method, milliseconds);

async function drag(page, [x, y], [right, down]) {
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + right, y + down, { steps: 4 });
}

/// `tools`: those of run.mjs.
export const lateTests = ({ open, close, scene, example, until, onScreen, pixelsSeen, slot }) => ({
  async "after another problem was dropped a part moves once, and one undo takes that back"() {
    const opened = await open(example("../tests/data/nesting/fu.json")), { page } = opened;
    await until(page, () => document.querySelectorAll("#layer-items .item").length === 12);
    for (const [problem, drawn] of [[strip("first"), "#layer-items .item"], [kBlocks, "#placed button"], [strip("second"), "#layer-items .item"]]) {
      await drop(page, problem);
      await until(page, (name, drawn) => document.title.startsWith(name) && document.querySelectorAll(drawn).length === 2, problem.name, drawn);
    }
    await press(page, "pack-stop");
    await until(page, () => /^Stopped|^No better/.test(document.getElementById("verdict").textContent));
    await wait(700);  // a layout that a search has found last is fitted into the picture
    for (let k = 0; k < 4; ++k) await press(page, "zoom-out");
    const standing = () => page.$$eval("#layer-items .item", (all) => all.map((e) => e.querySelector("title").textContent + e.getAttribute("transform")).sort().join());
    const before = await standing(), box = await (await page.$('[data-item="0"]')).boundingBox();
    let repairs = 0;
    page.on("request", (r) => { repairs += r.postData()?.includes('"method":"repair"') ? 1 : 0; });
    await drag(page, [box.x + box.width / 2, box.y + box.height / 2], [2.5 * box.width, 0]);
    await page.mouse.up();
    await until(page, () => !document.getElementById("undo").disabled);
    await wait(500);
    assert.equal(repairs, 1);
    assert.notEqual(await standing(), before);
    await press(page, "undo");
    await until(page, (layout) => [...document.querySelectorAll("#layer-items .item")].map((e) => e.querySelector("title").textContent + e.getAttribute("transform")).sort().join() === layout, before);
    assert.ok(await page.$eval("#undo", (b) => b.disabled));
    await close(opened);
  },
  async "a scene of the other dimension is dragged after it was dropped"() {
    const opened = await open(scene("slot12.json", slot)), { page } = opened;
    await drop(page, kRoom);
    await until(page, () => document.getElementById("atoms").textContent.includes("gap(part, block)"));
    const arrow = await pixelsSeen(page, "#3a6fd0"), canvas = await (await page.$("#space")).boundingBox(), z = await numberIn(page, "z");
    assert.ok(arrow.count > 20, "no arrow");
    await drag(page, [canvas.x + arrow.x, canvas.y + arrow.y], [0, -60]);
    await until(page, (z) => Number(document.getElementById("z").value) > z, z);
    await page.mouse.up();
    await until(page, () => !document.getElementById("undo").disabled);
    await press(page, "undo");
    await until(page, (z) => Number(document.getElementById("z").value) === z, z);
    await page.evaluate((z) => {
      document.getElementById("z").value = z;
      document.getElementById("z").dispatchEvent(new Event("change"));
    }, z + 30);
    await until(page, () => document.getElementById("verdict").className === "bad");
    // And in the plane again.
    await drop(page, slot);
    await until(page, () => document.getElementById("atoms").textContent.includes("gap(peg, block)"));
    assert.equal((await page.$$("#labels span")).length, 0);
    const [x, y] = [await numberIn(page, "x"), await numberIn(page, "y")], from = await onScreen(page, x, y), to = await onScreen(page, x + 3, y + 2);
    await drag(page, from, [to[0] - from[0], to[1] - from[1]]);
    await until(page, (x, y) => Math.hypot(document.getElementById("x").value - x, document.getElementById("y").value - y) < 1, x + 3, y + 2);
    await page.mouse.up();
    await until(page, () => !document.getElementById("undo").disabled);
    await press(page, "undo");
    await until(page, (x, y) => Number(document.getElementById("x").value) === x && Number(document.getElementById("y").value) === y, x, y);
    assert.ok(await page.$eval("#undo", (b) => b.disabled));
    await close(opened);
  },
  async "what a placement still finds is not shown in the scene that is dropped meanwhile"() {
    const opened = await open(example("components.json")), { page } = opened;
    await until(page, () => document.getElementById("verdict").textContent === "All 4 are placed");
    await delay(page, "place", 1000);
    await press(page, "place-again");
    await drop(page, slot);
    await until(page, () => document.getElementById("verdict").textContent === "Feasible");
    await wait(1500);
    assert.equal(await page.$eval("#verdict", (e) => e.textContent), "Feasible");
    assert.equal((await page.$$("#layer-placed path")).length, 0);
    await close(opened);
  },
  async "a slider keeps the last number where maps come late, and undo takes it back"() {
    const opened = await open(scene("slot13.json", slot)), { page } = opened;
    await delay(page, "map", 300);
    await page.evaluate(async () => {
      const range = document.querySelector("#sliders input[type=range]");
      for (const value of ["1", "2", "3"]) {
        range.value = value;
        range.dispatchEvent(new Event("input"));
        await new Promise((done) => setTimeout(done, 30));
      }
      range.dispatchEvent(new Event("change"));
    });
    await until(page, () => !document.getElementById("undo").disabled);
    const level = () => page.$eval("#sliders input[type=range]", (e) => e.value), where = () => page.$eval("#where", (e) => e.value);
    assert.deepEqual([await level(), await where()], ["3", slot.where.replace("0", "3")]);
    await press(page, "undo");
    await until(page, () => document.querySelector("#sliders input[type=range]").value === "0");
    assert.equal(await where(), slot.where);
    assert.ok(await page.$eval("#undo", (b) => b.disabled));
    await close(opened);
  },
  async "a value with one end, and what is missing, are said to be at least"() {
    const turning = {
      findspace: 1, unit: "mm", moving: "B", where: "sup eta2(B, A) <= 1",
      shapes: { A: { box: { min: [-5, -5], max: [5, 5] } }, B: { box: { min: [-1, -1], max: [1, 1] } } },
      motion: { time: [0, 1], B: { path: [[0, 0], [1, 0]], angles: [0, 30] } },
    };
    const opened = await open(scene("turning.json", turning)), { page } = opened;
    await until(page, () => /\(at least [\d.]+\)/.test(document.getElementById("atoms").textContent));
    assert.match(await page.$eval("#atoms", (e) => e.textContent), /off by at least [\d.]+ mm/);
    await close(opened);
  },
});
