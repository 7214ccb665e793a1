// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The page: what the user does becomes requests, and answers become the picture and the lists.
import { alonePage, pictureSvg, readAlone, save } from "./alone";
import { call, latest, Refusal, stayOpen } from "./engine";
import type { Check, Explanation, Nearest, Point, RegionMap, Summary } from "./engine";
import { make, showAtoms, showSliders, showWhy, withUnit } from "./panel";
import { Stage } from "./stage";

const get = <T extends Element = HTMLElement>(id: string): T => document.getElementById(id) as unknown as T;
const kSnapPixels = 9;

interface State { where: string; at: Point; moving: string[] }

const alone = readAlone();
const stage = new Stage(get<SVGSVGElement>("picture"), get("scale"));
const where = get<HTMLTextAreaElement>("where"), hidden = new Set<string>();
let picked = "", summary: Summary, map: RegionMap | null = null, empty = false;
let undo: State[] = [], redo: State[] = [], kept: State;

const unit = (): string => summary.unit ?? "";
const now = (): State => ({ where: summary.where, at: stage.at, moving: summary.moving });

function verdict(text: string, good: boolean | null): void {
  get("verdict").textContent = text;
  get("verdict").className = good === null ? "" : good ? "good" : "bad";
}

function showPlace(): void {
  get<HTMLInputElement>("x").value = String(stage.at[0]);
  get<HTMLInputElement>("y").value = String(stage.at[1]);
}

/// What is true at the part's position; `snap`: within so many units it goes to the nearest feasible one.
const check = latest(async (at: Point, snap: number) => {
  const answer = await call<Check>("check", { at, nearest: true, snap });
  stage.place(answer.at);
  showPlace();
  stage.setAtoms(answer.true, answer.atoms);
  stage.setGhost(answer.nearest_feasible?.at ?? null);
  showAtoms(get("atoms"), answer.atoms, unit(), picked, (text) => void pick(text));
  if (empty) return;
  const off = answer.nearest_feasible;
  const wrong = answer.atoms.filter((a) => !a.true).map((a) => a.text);
  verdict(answer.true ? "Feasible" : `Not feasible${off ? `, ${withUnit(off.distance, unit())} away` : ""}${wrong.length ? `: ${wrong.join(", ")}` : ""}`, answer.true);
});

/// The set of one condition alone, or of none.
async function pick(text: string): Promise<void> {
  picked = text;
  stage.setRegion(text ? (await call<RegionMap>("map", { drawing: true, where: text })).drawing : null, true);
  await check(stage.at, 0);
}

const explain = latest(async () => {
  const answer = await call<Explanation>("explain");
  get("why").hidden = false;
  showWhy(get("why").querySelector("div")!, answer, unit(), {
    go: (at) => void moveTo(at).then(keep),
    canReplace: (text) => summary.where.includes(text),
    replace: (text, by) => void setWhere(summary.where.replace(text, () => by)).then(() => { sliders(); keep(); }),
  });
});

async function solve(): Promise<void> {
  map = await call<RegionMap>("map", { drawing: true });
  await showMap(map);
}

async function showMap(map: RegionMap): Promise<void> {
  empty = map.empty;
  stage.setRegion(map.drawing);
  if (empty) {
    verdict("No position is feasible", false);
    await explain();
  } else {
    get("why").hidden = true;
  }
  await (picked ? pick("") : check(stage.at, 0));
}

function caret(e: Refusal | null): void {
  get("mistake").textContent = e?.message.split("\n")[0] ?? "";
  const box = get("caret");
  box.replaceChildren();
  if (!e?.line || !e.column) return;
  const lines = where.value.split("\n");
  const start = lines.slice(0, e.line - 1).join("\n").length + (e.line > 1 ? 1 : 0) + e.column - 1;
  const length = Math.max(1, /^[\w.]*/.exec(where.value.slice(start))![0].length);
  box.append(where.value.slice(0, start));
  make("mark", box, where.value.slice(start, start + length) || " ");
  box.append(where.value.slice(start + length));
}

const setWhere = latest(async (formula: string) => {
  if (where.value !== formula) where.value = formula;
  try {
    summary = { ...(await call<Summary>("set", { where: formula })), shapes: summary.shapes };
    caret(null);
    await solve();
  } catch (e) {
    if (!(e instanceof Refusal)) throw e;
    caret(e);
  }
});

const moveTo = (at: Point, snap = 0): Promise<void> => check(at, snap);

function sliders(): void {
  showSliders(get("sliders"), summary.where, (formula) => void setWhere(formula), () => setTimeout(() => { sliders(); keep(); }, 50));
}

function buttons(): void {
  get<HTMLButtonElement>("undo").disabled = !undo.length;
  get<HTMLButtonElement>("redo").disabled = !redo.length;
}

/// After each act: what undo goes back to.
function keep(): void {
  const state = now();
  if (JSON.stringify(state) === JSON.stringify(kept)) return;
  undo.push(kept);
  redo = [];
  kept = state;
  buttons();
}

async function restore(from: State[], to: State[]): Promise<void> {
  const state = from.pop();
  if (!state) return;
  to.push(now());
  stage.at = state.at;
  if (JSON.stringify(state.moving) !== JSON.stringify(summary.moving)) await setMoving(state.moving);
  await setWhere(state.where);
  sliders();
  kept = now();
  buttons();
}

async function setMoving(moving: string[]): Promise<void> {
  try {
    await call("set", { moving });
  } catch (e) {
    if (!(e instanceof Refusal)) throw e;
    caret(e);
  }
  summary = await call<Summary>("scene", { drawing: true });
  showScene();
  await solve();
}

function showScene(): void {
  stage.setScene(summary, hidden);
  document.title = `${summary.moving.join(", ")} – findspace`;
  const list = get("shapes");
  list.replaceChildren();
  for (const s of summary.shapes) {
    const row = make("li", list);
    make("span", row, s.name);
    const [seen, moves] = ["shown", "moves"].map((text) => {
      const label = make("label", row);
      const input = make("input", label);
      input.type = text === "shown" ? "checkbox" : "radio";
      label.append(" " + text);
      return input;
    }) as [HTMLInputElement, HTMLInputElement];
    seen.checked = !hidden.has(s.name);
    seen.disabled = s.moving;
    seen.onchange = () => {
      if (seen.checked) hidden.delete(s.name);
      else hidden.add(s.name);
      stage.setScene(summary, hidden);
    };
    moves.name = "moves";
    moves.checked = s.moving;
    moves.disabled = !!alone;
    moves.onchange = () => void setMoving([s.name]).then(keep);
  }
}

async function toNearest(): Promise<void> {
  const { nearest_feasible } = await call<{ nearest_feasible: Nearest | null }>("nearest", { at: stage.at });
  if (nearest_feasible) await check(nearest_feasible.at, 1e-9 * Math.max(1, ...nearest_feasible.at.map(Math.abs)));
  keep();
}

function onKey(e: KeyboardEvent): void {
  const typing = (e.target as Element).closest("input, textarea");
  if ((e.ctrlKey || e.metaKey) && e.key.toLowerCase() === "z" && !typing) {
    e.preventDefault();
    void (e.shiftKey ? restore(redo, undo) : restore(undo, redo));
    return;
  }
  if (typing || e.ctrlKey || e.metaKey || alone) return;
  const step = stage.rounded([(e.shiftKey ? 50 : e.altKey ? 1 : 5) * stage.unit, 0])[0];
  const ways: Record<string, Point> = { ArrowLeft: [-step, 0], ArrowRight: [step, 0], ArrowUp: [0, step], ArrowDown: [0, -step] };
  const way = ways[e.key];
  if (way) {
    e.preventDefault();
    void moveTo(stage.rounded([stage.at[0] + way[0], stage.at[1] + way[1]])).then(keep);
    return;
  }
  const keys: Record<string, () => void> = { n: () => void toNearest(), e: () => void explain(), "+": () => stage.zoom(0.8), "-": () => stage.zoom(1.25), "0": () => stage.fit() };
  keys[e.key]?.();
}

function connect(): void {
  stage.onDrag = (at) => void moveTo(at, kSnapPixels * stage.unit);
  stage.onDragged = () => setTimeout(keep, 80);
  where.oninput = () => void setWhere(where.value);
  where.onchange = () => { sliders(); keep(); };
  for (const id of ["x", "y"]) get<HTMLInputElement>(id).onchange = () => {
    const at = ["x", "y"].map((k) => Number(get<HTMLInputElement>(k).value)) as Point;
    if (at.every(Number.isFinite)) void moveTo(at).then(keep);
  };
  get("nearest").onclick = () => void toNearest();
  get("explain").onclick = () => void explain();
  get("undo").onclick = () => void restore(undo, redo);
  get("redo").onclick = () => void restore(redo, undo);
  get("save-page").onclick = () => { if (map) save("findspace.html", "text/html", alonePage({ summary, map, at: stage.at })); };
  document.addEventListener("keydown", onKey);
  document.addEventListener("dragover", (e) => e.preventDefault());
  document.addEventListener("drop", (e) => {
    e.preventDefault();
    const file = e.dataTransfer?.files[0];
    if (file) void file.text().then(openScene).catch((fault: unknown) => caret(fault instanceof Refusal ? fault : null));
  });
}

/// Another scene in place of this one.
async function openScene(text: string): Promise<void> {
  await call("load", { text });
  hidden.clear();
  undo = [];
  redo = [];
  await showLoaded();
}

/// What the engine has loaded.
async function showLoaded(): Promise<void> {
  summary = alone?.summary ?? (await call<Summary>("scene", { drawing: true }));
  where.value = summary.where;
  get("unit").textContent = unit();
  get("scale").dataset["unit"] = unit();
  for (const s of summary.shapes) if (!s.used && !s.moving) hidden.add(s.name);
  showScene();
  map = alone?.map ?? (await call<RegionMap>("map", { drawing: true }));
  stage.place(alone?.at ?? firstPlace());
  if (alone) stage.setRegion(map.drawing);
  else await showMap(map);
  stage.fit();
  if (alone) return;
  sliders();
  kept = now();
  buttons();
}

/// The picture answers, to the pixel.
function connectAlone(): void {
  for (const id of ["actions", "place", "save-page", "sliders"]) get(id).remove();
  where.readOnly = true;
  const belongs = ([x, y]: Point): boolean => {
    const p = new DOMPoint(x, -y);
    const tolerance = 3 * stage.unit;
    return [...document.querySelectorAll<SVGGeometryElement>("#layer-region .face")].some((f) => f.isPointInFill(p)) ||
      (map?.isolated ?? []).some(([a, b]) => Math.hypot(a - x, b - y) < tolerance);
  };
  const show = (at: Point): void => {
    stage.place(at);
    const good = belongs(at);
    stage.setAtoms(good, []);
    stage.setGhost(null);
    verdict(`${good ? "Feasible" : "Not feasible"} at (${at[0]}, ${at[1]}), as drawn`, good);
  };
  stage.onDrag = show;
  show(stage.at);
}

/// In the region, if it has a point that says so; else where the part is drawn.
function firstPlace(): Point {
  return map?.isolated[0] ?? map?.components[0]?.sample ?? [0, 0];
}

async function begin(): Promise<void> {
  const theme = matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light";
  document.documentElement.dataset["theme"] = theme;
  get("theme").onclick = () => { document.documentElement.dataset["theme"] = document.documentElement.dataset["theme"] === "dark" ? "light" : "dark"; };
  get("save-svg").onclick = () => save("findspace.svg", "image/svg+xml", pictureSvg(get<SVGSVGElement>("picture")));
  get("zoom-in").onclick = () => stage.zoom(0.8);
  get("zoom-out").onclick = () => stage.zoom(1.25);
  get("fit").onclick = () => stage.fit();
  if (!alone) stayOpen((gone) => { if (gone) verdict("The program has ended", false); });
  await showLoaded();
  if (alone) connectAlone();
  else connect();
}

begin().catch((e: unknown) => verdict(e instanceof Error ? e.message : String(e), false));
