// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The page: what the user does becomes requests, and answers become the picture and the lists.
import { alonePage, drawnAt, placeText, readAlone, save } from "./alone";
import { CratePicture } from "./crate";
import { Editor } from "./editor";
import { call, kOwn, latest, Refusal, spaceScript, stayOpen } from "./engine";
import type { Between, Check, Drawing, Explanation, Interval, Nearest, Place, RegionMap, SpaceDrawing, Summary } from "./engine";
import { History } from "./history";
import type { State } from "./history";
import { PackingPage } from "./packing";
import { make, showAtoms, showBetween, showShapes, showSliders, showWhy, withUnit } from "./panel";
import type { Picture } from "./picture";
import { Placing } from "./placing";
import { Poses } from "./poses";
import type { SpaceStage } from "./space";
import { Stage } from "./stage";
import { StripPicture } from "./strip";
import { showOperations, showSection } from "./views";

const get = <T extends Element = HTMLElement>(id: string): T => document.getElementById(id) as unknown as T;
const kSnapPixels = 9, kManyFaces = 500, kManyLetters = 200_000, kSlowTurns = 300;

const { scene: alone, packing: alonePacking } = readAlone();
const hidden = new Set<string>();
const editor = new Editor(get<HTMLTextAreaElement>("where"), get("caret"), get("mistake"), get("words"));
const history = new History(get<HTMLButtonElement>("undo"), get<HTMLButtonElement>("redo"));
const poses = new Poses(get("poses"));
let picture: Picture, stage: Stage | null = null, spaceText = "", pictureEnd = new AbortController();
let summary: Summary, map: RegionMap | null = null, empty = false, roomy = false, picked = "", operation = "";
let measuring: Place[] | null = null, placing: Placing | null = null, turnsTook = 0;

const unit = (): string => summary.unit ?? "";
const state = (): State => ({ where: summary.where, at: picture.at, moving: summary.moving, angle: poses.pose.angle });
const keep = (): void => history.keep(state());
const typedPlace = (): Place => coordinates().map((k) => Number(get<HTMLInputElement>(k).value));
const coordinates = (): string[] => ["x", "y", "z"].slice(0, summary.dimension);

/// The angle or the instant that requests are about.
function poseOf(withTime: boolean): { angle?: number; time?: number } {
  const { angle, time } = poses.pose;
  return { ...(angle ? { angle } : {}), ...(withTime && time !== null ? { time } : {}) };
}

function verdict(text: string, good: boolean | null): void {
  get("verdict").textContent = text;
  get("verdict").className = good === null ? "" : good ? "good" : "bad";
}

const fault = (e: unknown): void => verdict(e instanceof Error ? e.message : String(e), false);

function showPlace(): void {
  coordinates().forEach((k, i) => { get<HTMLInputElement>(k).value = String(picture.at[i]); });
}

/// What is true at the part's position; `snap`: within so many units it goes to a corner, an edge, or the nearest feasible position.
const check = latest(async (at: Place, snap: number) => {
  const answer = await call<Check>("check", { at, nearest: true, snap, ...poseOf(true) });
  picture.place(answer.at);
  showPlace();
  picture.setAtoms(answer.true, answer.atoms);
  picture.setGhost(answer.nearest_feasible?.at ?? null);
  showAtoms(get("atoms"), answer.atoms, unit(), picked, (text) => void pick(text));
  if (empty && !poses.pose.time) return;
  const off = answer.nearest_feasible;
  const wrong = answer.atoms.filter((a) => !a.true).map((a) => a.text);
  verdict(answer.true ? "Feasible" : `Not feasible${off ? `, ${withUnit(off.distance, unit())} away` : ""}${wrong.length ? `: ${wrong.join(", ")}` : ""}`, answer.true);
});

/// The answer to what the last drag asked for. A drag is kept for undo once it is answered, and before the next act begins.
let dragged: Promise<void> = Promise.resolve();

/// The same of the last formula that was asked for, and its levels.
let asked: Promise<void> = Promise.resolve();
const askWhere = (formula: string): void => { asked = setWhere(formula).catch(fault); };
function keepWhere(): void {
  const last = asked;
  // Of two acts in one answer the second one is kept.
  void last.then(() => {
    if (last !== asked) return;
    sliders();
    keep();
  });
}

/// Where on the slider of angles or of time the formula holds.
const turns = latest(async () => {
  const method = poses.method;
  if (!method) return;
  const begun = performance.now();
  const { intervals } = await call<{ intervals: Interval[] }>(method, { at: picture.at });
  turnsTook = performance.now() - begun;
  poses.showIntervals(intervals, picture.at);
});
/// Where that takes long, only while the pointer or the focus is at the slider: a drag is not to wait for it.
function showTurns(asked = false): void {
  const seen = asked || get("poses").matches(":hover, :focus-within");
  if (!seen && (turnsTook > kSlowTurns || isIntricate())) return poses.forget();
  void turns().catch(() => poses.showIntervals([], picture.at));
}

/// Of so many edges that angles take long.
function isIntricate(): boolean {
  return summary.dimension === 2 && summary.shapes.reduce((sum, s) => sum + ((s.drawing as Drawing | undefined)?.faces.length ?? 0), 0) > kManyLetters;
}

/// The set of one condition alone, or of none.
async function pick(text: string): Promise<void> {
  picked = text;
  picture.setRegion(text ? (await call<RegionMap>("map", { brief: true, where: text, ...poseOf(false) })).drawing : null, true);
  await check(picture.at, 0);
}

/// Of all positions; with `over` of all angles or instants where the part is.
const explain = latest(async (over: "angles" | "instants" | null) => {
  const answer = await call<Explanation>("explain", over ? { over, at: picture.at } : poseOf(false));
  if (!over) roomy = answer.feasible;
  const box = get("why").querySelector("div")!;
  get("why").hidden = false;
  showWhy(box, answer, unit(), {
    go: (at) => void moveTo(at).then(keep),
    pose: (value) => { poses.set(value); void setPose().then(keep); },
    canReplace: (text) => summary.where.includes(text),
    replace: (text, by) => {
      askWhere(summary.where.replace(text, () => by));
      keepWhere();
    },
  });
  if (over) box.prepend(make("p", box, `Where the part is, at ${over === "angles" ? "any angle" : "any instant"}:`));
  const other = over ? null : poses.method;
  if (over || other) make("button", box, over ? "At all positions" : `Here, at any ${other === "angles" ? "angle" : "instant"}`).onclick = () => void explain(other).catch(fault);
});

async function solve(): Promise<void> {
  if (!summary.moving.length) return;
  map = await call<RegionMap>("map", { brief: true, ...(operation ? { apply: operation } : {}), ...poseOf(false) });
  await showMap(map);
}

/// So that an explanation would take long, and has to be asked for.
function isLarge(): boolean {
  const faces = summary.dimension === 3 ? summary.shapes.map((s) => (s.drawing as SpaceDrawing | undefined)?.faces.length ?? 0) : [];
  return faces.reduce((a, b) => a + b, 0) > kManyFaces;
}

async function showMap(found: RegionMap): Promise<void> {
  empty = found.empty ?? found.intervals?.length === 0;
  picture.setRegion(found.drawing);
  stage?.setOuter(found.outer_drawing ?? null);
  if (empty && !found.outer_drawing) {
    verdict(found.on_lines ? "No position was found on the lines of the map" : "No position is feasible", false);
    roomy = false;
    const told = !summary.motion && !isLarge() && (await explain(null).then(() => true, () => false));
    // Lines may miss what an explanation finds.
    if (roomy) empty = false;
    else if (told) verdict("No position is feasible", false);
  } else {
    get("why").hidden = true;
  }
  await (picked ? pick("") : check(picture.at, 0));
}

const setWhere = latest(async (formula: string) => {
  editor.text = formula;
  try {
    summary = { ...(await call<Summary>("set", { where: formula })), shapes: summary.shapes };
    editor.show(null);
    await solve();
  } catch (e) {
    if (!(e instanceof Refusal)) throw e;
    editor.show(e);
  }
});

const setPose = latest(async () => {
  picture.setPose(poses.pose);
  await (poses.pose.time === null && !summary.motion ? solve() : check(picture.at, 0));
});

async function moveTo(at: Place, snap = 0): Promise<void> {
  await check(at, snap);
  showTurns();
}

function sliders(): void {
  showSliders(get("sliders"), summary.where, askWhere, keepWhere);
}

async function restore(back: boolean): Promise<void> {
  if (placing && !summary.moving.length) return placing.step(back);
  await dragged;
  await asked;
  const to = history.step(back);
  if (!to) return;
  picture.at = to.at;
  if (to.angle !== poses.pose.angle) {
    poses.set(to.angle);
    picture.setPose(poses.pose);
  }
  if (JSON.stringify(to.moving) !== JSON.stringify(summary.moving)) await setMoving({ moving: to.moving, where: to.where });
  else await setWhere(to.where);
  sliders();
}

/// With another formula at once: each of the two may be refused without the other.
async function setMoving(to: { moving: string[]; where?: string }): Promise<void> {
  try {
    await call("set", to);
    if (to.where !== undefined) {
      editor.text = to.where;
      editor.show(null);
    }
  } catch (e) {
    if (!(e instanceof Refusal)) throw e;
    editor.show(e);
  }
  summary = await call<Summary>("scene", { drawing: true });
  showScene();
  await solve();
}

function showScene(): void {
  picture.setScene(summary, hidden);
  document.title = `${summary.moving.join(", ") || summary.shapes[0]?.name || "scene"} – findspace`;
  editor.words = [...summary.shapes.map((s) => s.name), ...summary.words, "and", "or", "not"];
  showShapes(get("shapes"), summary.shapes, hidden, !!alone, () => picture.setScene(summary, hidden), (name) => void setMoving({ moving: [name] }).then(keep));
}

async function toNearest(): Promise<void> {
  await dragged;
  const { nearest_feasible } = await call<{ nearest_feasible: Nearest | null }>("nearest", { at: picture.at, ...poseOf(false) });
  if (nearest_feasible) await check(nearest_feasible.at, 1e-9 * Math.max(1, ...nearest_feasible.at.map(Math.abs)));
  keep();
}

/// Two clicks, and the distance of the features there.
function measure(on: boolean): void {
  measuring = on ? [] : null;
  get("measure").ariaPressed = String(on);
  get("between").textContent = on ? "Click the first feature, or go to it by arrow keys and press Enter" : "";
  stage?.setBetween(null);
  stage?.moveCross(null);
}

async function pickFeature(at: Place): Promise<void> {
  if (!measuring || !stage) return;
  measuring.push(at);
  if (measuring.length < 2) return void (get("between").textContent = "Click the second feature");
  const [from, to] = measuring;
  measuring = [];
  const answer = await call<Between>("between", { from, to, at: picture.at, ...poseOf(false) });
  stage.setBetween(answer);
  showBetween(get("between"), answer, unit());
}

const kUps: Record<string, [number, number]> = { ArrowLeft: [0, -1], ArrowRight: [0, 1], ArrowUp: [1, 1], ArrowDown: [1, -1], PageUp: [2, 1], PageDown: [2, -1] };

/// Closer, farther, all of it; with Ctrl and arrows the picture of the plane is shifted, that of space turned.
function viewKey(e: KeyboardEvent, view: Pick<Picture, "zoom" | "fit" | "shift">): boolean {
  const way = kUps[e.key];
  if (e.ctrlKey || e.metaKey) {
    if (!way || way[0] > 1) return false;
    view.shift(way[0] === 0 ? way[1] : 0, way[0] === 1 ? way[1] : 0);
    return true;
  }
  const keys: Record<string, () => void> = { "+": () => view.zoom(0.8), "-": () => view.zoom(1.25), "0": () => view.fit() };
  keys[e.key]?.();
  return e.key in keys;
}

function onKey(e: KeyboardEvent): void {
  const typing = (e.target as Element).closest("input, textarea, select");
  if ((e.ctrlKey || e.metaKey) && e.key.toLowerCase() === "z" && !typing) {
    e.preventDefault();
    void restore(!e.shiftKey);
    return;
  }
  if (typing) return;
  if (viewKey(e, picture)) return e.preventDefault();
  if (e.ctrlKey || e.metaKey) return;
  const step = picture.rounded([(e.shiftKey ? 50 : e.altKey ? 1 : 5) * picture.unit])[0]!;
  const way = kUps[e.key];
  if (way && way[0] < 2 && measuring && stage) {
    e.preventDefault();
    return stage.moveCross([0, 1].map((axis) => (axis === way[0] ? (axis === 1 && summary.y === "down" ? -way[1] : way[1]) * step : 0)));
  }
  if (e.key === "Enter" && measuring && stage?.cross) {
    e.preventDefault();
    void pickFeature(stage.cross).catch(fault);
    return;
  }
  if (way && way[0] < summary.dimension && placing?.chosen) {
    e.preventDefault();
    placing.nudge(way[0], (way[0] === 1 && summary.y === "down" ? -way[1] : way[1]) * step);
    return;
  }
  if (way && way[0] < summary.dimension && summary.moving.length) {
    e.preventDefault();
    const axis = way[0], sign = axis === 1 && summary.y === "down" ? -way[1] : way[1];
    void moveTo(picture.rounded(picture.at.map((c, k) => (k === axis ? c + sign * step : c)))).then(keep);
    return;
  }
  const turn = (by: number) => {
    if (poses.method !== "angles") return;
    poses.set((poses.pose.angle + by + 360) % 360);
    void setPose().then(keep);
  };
  const keys: Record<string, () => void> = {
    n: () => void toNearest(), e: () => void explain(null).catch(fault), m: () => measure(!measuring), r: () => turn(15), R: () => turn(-15),
    Escape: () => measure(false),
  };
  keys[e.key]?.();
}

/// What is done in a picture.
function follow(made: Picture): void {
  made.onDrag = (at) => { dragged = check(at, kSnapPixels * made.unit).catch(fault); };
  made.onDragged = () => void dragged.then(() => { keep(); showTurns(); });
  made.onPick = (at) => void pickFeature(at).catch(fault);
}

function connect(): void {
  for (const at of ["pointerenter", "focusin"]) get("poses").addEventListener(at, () => showTurns(true));
  editor.onText = askWhere;
  editor.onDone = keepWhere;
  poses.onPose = () => void setPose().catch(fault);
  poses.onDone = keep;
  for (const id of ["x", "y", "z"]) get<HTMLInputElement>(id).onchange = () => {
    if (typedPlace().every(Number.isFinite)) void moveTo(typedPlace()).then(keep);
  };
  const clicks: Record<string, () => void> = {
    nearest: () => void toNearest(), explain: () => void explain(null).catch(fault), measure: () => measure(!measuring),
    undo: () => void restore(true), redo: () => void restore(false),
  };
  for (const [id, act] of Object.entries(clicks)) get(id).onclick = act;
  get("save-scene").onclick = () => void call<{ text: string }>("source").then(({ text }) => save("scene.json", new Blob([text], { type: "application/json" })), fault);
  document.addEventListener("keydown", onKey);
  onDropped((text) => openScene(text).catch((e: unknown) => (e instanceof Refusal ? editor.show(e) : fault(e))));
}

/// A file that is dropped anywhere on the page.
function onDropped(open: (text: string) => Promise<void>): void {
  document.addEventListener("dragover", (e) => e.preventDefault());
  document.addEventListener("drop", (e) => {
    e.preventDefault();
    const file = e.dataTransfer?.files[0];
    if (file) void file.text().then(open).catch(fault);
  });
}

/// Another scene in place of this one.
async function openScene(text: string): Promise<void> {
  await dragged;  // what is still asked is about the scene before
  await asked;
  const loaded = await call<Summary>("load", { text, drawing: true });
  placing?.end();
  hidden.clear();
  picked = operation = "";
  measure(false);
  await choosePicture(loaded);
  await showLoaded(loaded);
}

/// What the engine has loaded.
async function showLoaded(loaded: Summary): Promise<void> {
  summary = loaded;
  editor.text = summary.where;
  get("unit").textContent = unit();
  get("scale").dataset["unit"] = unit();
  get("z").parentElement!.hidden = summary.dimension === 2;
  for (const s of summary.shapes) if (!s.used && !s.moving && !summary.place && summary.moving.length) hidden.add(s.name);
  const moving = summary.moving.length > 0;
  for (const id of ["place", "formula"]) get(id).hidden = !moving;
  get("nearest").hidden = !moving;
  get("explain").hidden = !moving;
  get("measure").hidden = summary.dimension === 3;
  poses.show(summary);
  showScene();
  views();
  if (moving) {
    map = alone?.map ?? (await call<RegionMap>("map", { brief: true }));
    picture.place(alone?.at ?? firstPlace());
    if (alone) picture.setRegion(map.drawing);
    else await showMap(map);
  } else {
    verdict(summary.place ? "A placement" : "Choose a shape that moves", null);
  }
  picture.fit();
  if (alone) return;
  sliders();
  history.start(state());
  showTurns();
  if (placing) await placing.begin();
}

function views(): void {
  const box = get("views");
  box.replaceChildren();
  if (!alone && summary.moving.length) showOperations(box, (chosen) => {
    operation = chosen;
    void solve().catch(fault);
  });
  if (summary.dimension === 3) showSection(box, picture as unknown as SpaceStage, unit());
  get("placing").hidden = !summary.place || !!alone;
  const body = get("placing").querySelector("div")!;
  body.replaceChildren();
  placing = summary.place && !alone ? new Placing(picture, body, verdict, (back, forth) => history.allow(back, forth)) : null;
}

function connectAlone(): void {
  for (const id of ["actions", "save-page", "save-scene", "sliders"]) get(id).remove();
  get<HTMLTextAreaElement>("where").readOnly = true;
  const belongs = stage ? drawnAt(stage, map!, summary.y) : null;
  const show = (at: Place): void => {
    picture.place(at);
    showPlace();
    picture.setGhost(null);
    if (!belongs) return verdict(`At ${placeText(at)}`, null);
    const good = belongs(at);
    picture.setAtoms(good, []);
    verdict(`${good ? "Feasible" : "Not feasible"} at ${placeText(at)}, as drawn`, good);
  };
  picture.onDrag = show;
  document.addEventListener("keydown", (e) => {
    if ((e.target as Element).closest("input, textarea, select")) return;
    const way = kUps[e.key], step = picture.rounded([(e.shiftKey ? 50 : e.altKey ? 1 : 5) * picture.unit])[0]!;
    if (viewKey(e, picture)) return e.preventDefault();
    if (!way || way[0] >= summary.dimension || e.ctrlKey || e.metaKey) return;
    e.preventDefault();
    show(picture.rounded(picture.at.map((c, k) => (k === way[0] ? c + (k === 1 && summary.y === "down" ? -way[1] : way[1]) * step : c))));
  });
  for (const id of coordinates()) get<HTMLInputElement>(id).onchange = () => {
    if (typedPlace().every(Number.isFinite)) show(typedPlace());
  };
  if (stage && belongs) stage.onHover = (at) => { get("hover").textContent = `${placeText(at)} ${unit()} ${belongs(at) ? "feasible" : "not feasible"}`; };
  show(picture.at);
}

/// In the region, if it has a point that says so; else where the part is drawn.
function firstPlace(): Place {
  if (summary.free === "angle" || summary.free === "time") return [0, 0];
  return map?.sample ?? map?.isolated?.[0] ?? map?.components?.[0]?.sample ?? Array<number>(summary.dimension).fill(0);
}

/// The canvas of space, or the elements of the plane, empty. The picture that they had hears nothing more; the next one
/// hears until the signal comes.
function showCanvas(space: boolean): AbortSignal {
  pictureEnd.abort();
  pictureEnd = new AbortController();
  get("space").toggleAttribute("hidden", !space);
  for (const id of ["picture", "picture-over"]) get(id).toggleAttribute("hidden", space);
  for (const id of ["picture", "picture-over", "labels", "hover"]) get(id).replaceChildren();
  return pictureEnd.signal;
}

async function choosePicture(loaded: Summary): Promise<void> {
  const space = loaded.dimension === 3;
  const until = showCanvas(space);
  stage = space ? null : new Stage(get<SVGSVGElement>("picture"), get<SVGSVGElement>("picture-over"), get("scale"), until);
  if (stage) stage.onHover = (at) => { get("hover").textContent = `${placeText(at)} ${loaded.unit ?? ""}`; };
  picture = stage ?? (await newSpace(loaded.unit ?? "", until));
  if (!alone) follow(picture);
}

async function newSpace(unit: string, until: AbortSignal): Promise<SpaceStage> {
  const program = globalThis as { findspaceSpace?: typeof SpaceStage };
  if (!program.findspaceSpace) {
    spaceText = alone || alonePacking ? get("space-program").textContent! : await spaceScript();
    const script = document.createElement("script");
    script.nonce = document.querySelector<HTMLElement>("#program")!.nonce ?? "";
    script.textContent = spaceText;
    document.body.append(script);
  }
  return new program.findspaceSpace!(get<HTMLCanvasElement>("space"), get("labels"), get("scale"), unit, until);
}

const showTheme = (theme: string): void => { document.documentElement.dataset["theme"] = theme; };
const changeTheme = (): void => showTheme(document.documentElement.dataset["theme"] === "dark" ? "light" : "dark");

function buttons(): void {
  showTheme(matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light");
  get("theme").onclick = () => {
    changeTheme();
    picture?.recolour();
  };
  get("save-svg").onclick = () => save("findspace.svg", new Blob([picture.svg()], { type: "image/svg+xml" }));
  get("save-png").onclick = () => void picture.png().then((png) => save("findspace.png", png), fault);
  get("save-page").onclick = () => { if (map) save("findspace.html", new Blob([alonePage({ scene: { summary, map, at: picture.at } }, spaceText)], { type: "text/html" })); };
  const moves: Record<string, () => void> = { "zoom-in": () => picture.zoom(0.8), "zoom-out": () => picture.zoom(1.25), fit: () => picture.fit() };
  for (const [id, act] of Object.entries(moves)) get(id).onclick = act;
}

async function beginPacking(): Promise<void> {
  for (const id of ["place", "nearest", "explain", "measure", "between", "formula", "poses", "shapes", "save-scene"]) get(id).hidden = true;
  document.querySelectorAll("aside > h2").forEach((e) => e.remove());
  get("packing").hidden = false;
  for (const id of ["picture", "space"]) get(id).setAttribute("aria-label", "The layout");
  const box = get("packing").querySelector("div")!, list = make("ul", get("packing"));
  list.id = "placed";
  const savePage = async () => save("findspace.html", new Blob([alonePage({ packing: await page.taken() }, spaceText)], { type: "text/html" }));
  const page = new PackingPage(async (problem) => {
    const space = problem.dimension === 3, until = showCanvas(space);
    list.replaceChildren();
    get("views").replaceChildren();
    if (!space) return new StripPicture(get<SVGSVGElement>("picture"), get("scale"), until);
    const made = await newSpace("", until);
    showSection(get("views"), made, "");
    return new CratePicture(made, list);
  }, box, verdict, (text) => { get("hover").textContent = text; }, history);
  if (alonePacking) {
    for (const id of ["actions", "save-page", "save-scene"]) get(id).remove();
    await page.beginAlone(alonePacking);
  } else {
    await page.begin();
  }
  document.addEventListener("keydown", (e) => {
    if ((e.target as Element).closest("input, textarea, select")) return;
    if ((!alonePacking && page.key(e)) || viewKey(e, page.view)) e.preventDefault();
  });
  const clicks: Record<string, () => void> = {
    "zoom-in": () => page.view.zoom(0.8), "zoom-out": () => page.view.zoom(1.25), fit: () => page.view.fit(),
    ...(alonePacking ? {} : { undo: () => page.step(true), redo: () => page.step(false), "save-page": () => void savePage().catch(fault) }),
    "save-svg": () => save("findspace.svg", new Blob([page.view.svg()], { type: "image/svg+xml" })),
    "save-png": () => void page.view.png().then((png) => save("findspace.png", png), fault),
    theme: () => { changeTheme(); page.view.recolour(); },
  };
  for (const [id, act] of Object.entries(clicks)) get(id).onclick = act;
  if (!alonePacking) onDropped((text) => page.open(text));
}

async function begin(): Promise<void> {
  buttons();
  if (alonePacking) return beginPacking();
  if (!alone) stayOpen((gone) => { if (gone) verdict("The program has ended", false); });
  if (!alone && document.querySelector<HTMLMetaElement>("meta[name=findspace-kind]")?.content === "packing") return beginPacking();
  const loaded = alone?.summary ?? (await call<Summary>("copy", { scene: "scene", as: kOwn, drawing: true }));
  await choosePicture(loaded);
  await showLoaded(loaded);
  if (alone) connectAlone();
  else connect();
}

begin().catch(fault).finally(() => { document.documentElement.dataset["ready"] = "true"; });
