// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The picture of the plane: shapes, region, the moving part, dimension lines; panning and zooming. What moves has an
// element of its own above the rest, so that a drag draws nothing else anew. Its own coordinates
// are those of the engine's path data: the scene's, with y down.
import type { AnyDrawing, Atom, Between, Drawing, Movement, Place, Point, Summary } from "./engine";
import { along, kShift, onResize, roundLength, shortDecimals, shown } from "./picture";
import type { Picture, Placed, Pose } from "./picture";
import { element, pictureOf, pictureText } from "./svg";

const dots = (points: Point[]): string => points.map(([x, y]) => `M${x} ${y}h0`).join("");
const lookOf = (d: Drawing): string => d.faces + d.free + dots(d.points);

const around = (b: DOMRect, o: DOMRect): boolean =>
  b.x <= o.x && b.y <= o.y && b.x + b.width >= o.x + o.width && b.y + b.height >= o.y + o.height;

const placeAlong = (m: Movement, time: number): Point =>
  along(m.times, m.path, time, (a, b, t) => [a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])] as Point);

const kLayers = ["shapes", "outer", "own", "region", "ghost", "placed", "part", "marks"] as const;
const kOver = new Set<string>(["ghost", "placed", "part", "marks"]);

const numberOf = (placed: Element): number => Number(placed.getAttribute("data-placed"));

export class Stage implements Picture {
  private readonly layers = {} as Record<(typeof kLayers)[number], SVGGraphicsElement>;
  private box = { x: 0, y: 0, w: 1, h: 1 };
  private all = { x: 0, y: 0, w: 1, h: 1 };
  private names: { x: number; y: number; text: string }[] = [];
  private atoms: Atom[] = [];
  private between: Between | null = null;
  private summary: Summary | null = null;
  private pose: Pose = { angle: 0, time: null };
  private moved = new Map<string, SVGElement>();
  private ghost: Place | null = null;
  at: Place = [0, 0];
  cross: Place | null = null;
  onDrag: (at: Place) => void = () => {};
  onDragged: () => void = () => {};
  onPick: (at: Place) => void = () => {};
  onHover: (at: Place) => void = () => {};
  onMovePlaced: (k: number, at: Place) => void = () => {};
  onPickPlaced: (k: number) => void = () => {};
  private placed: Placed[] = [];

  /// It hears nothing more once `until` says so: another picture comes to the same elements.
  constructor(readonly element: SVGSVGElement, private readonly over: SVGSVGElement, private readonly bar: HTMLElement, private readonly until: AbortSignal) {
    // Lines that do not scale by themselves are laid out and drawn anew at every change anywhere.
    element.classList.add("scaled");
    for (const id of kLayers) this.layers[id] = layer(id, kOver.has(id) ? over : element);
    this.follow();
    onResize(element, until, () => this.show());
  }

  get unit(): number {
    const { width, height } = this.element.getBoundingClientRect();
    return Math.max(this.box.w / Math.max(width, 1), this.box.h / Math.max(height, 1));
  }

  /// 1 where the scene's y axis runs downwards, else -1.
  private get down(): number { return this.summary?.y === "down" ? 1 : -1; }

  /// The angle of an element, in degrees.
  private turn(angle: number): number { return this.summary?.clockwise ? angle : -angle; }

  setScene(summary: Summary, hidden: Set<string>): void {
    this.summary = summary;
    for (const g of [this.layers.shapes, this.layers.part, this.layers.ghost, this.layers.placed]) g.replaceChildren();
    this.names = [];
    this.moved.clear();
    const fixed: { path: SVGGraphicsElement; b: DOMRect }[] = [];
    for (const s of summary.shapes) {
      if (!s.drawing) continue;
      const d = lookOf(s.drawing as Drawing);
      if (s.moving) {
        element("path", { class: "part", d }, this.layers.part);
        element("path", { class: "ghost", d }, this.layers.ghost);
        continue;
      }
      if (hidden.has(s.name)) continue;
      const path = element("path", { class: "shape", d }, this.layers.shapes) as SVGGraphicsElement;
      this.moved.set(s.name, path);
      const b = path.getBBox();
      this.names.push({ x: b.x + b.width / 2, y: b.y, text: s.name });
      fixed.push({ path, b });
    }
    // What lies around other shapes is drawn below them, and lighter.
    fixed.sort((p, q) => q.b.width * q.b.height - p.b.width * p.b.height);
    for (const { path, b } of fixed) {
      this.layers.shapes.append(path);
      if (fixed.some((o) => o.path !== path && around(b, o.b))) path.classList.add("container");
    }
    if (summary.moving.length) element("path", { class: "pole", d: "M0 0h0" }, this.layers.part);
    this.setPose(this.pose);
  }

  setRegion(drawing: AnyDrawing | null, own = false): void {
    this.draw(own ? this.layers.own : this.layers.region, drawing as Drawing | null);
  }

  /// Positions that only possibly belong.
  setOuter(drawing: Drawing | null): void { this.draw(this.layers.outer, drawing); }

  private draw(g: SVGElement, d: Drawing | null): void {
    g.replaceChildren();
    if (!d) return;
    const add = (style: string, data: string) => { if (data) element("path", { class: style, d: data }, g); };
    add("face", d.faces);
    add("closed", d.closed);
    add("open", d.open);
    add("free", d.free);
    add("full", dots(d.full));
    add("hollow", dots(d.hollow));
    add("hollow-core", dots(d.hollow));
    add("points", dots(d.points));
  }

  place(at: Place): void {
    this.at = at;
    const moving = this.summary?.moving[0];
    this.layers.part.setAttribute("transform", this.transform(at, this.pose.angle, moving ? this.movementOf(moving) : null));
  }

  private movementOf(shape: string): Movement | null {
    return (this.pose.time !== null && this.summary?.motion?.movements.find((m) => m.shape === shape)) || null;
  }

  private transform(at: Place, angle: number, movement: Movement | null): string {
    let [x, y] = at as Point;
    let turn = angle;
    const [cx, cy] = movement ? [0, 0] : this.summary?.about ?? [0, 0];
    if (movement) {
      const time = this.pose.time!, [dx, dy] = placeAlong(movement, time);
      x += dx;
      y += dy;
      turn = along(movement.times, movement.angles, time, (a, b, t) => a + t * (b - a));
    }
    return `translate(${x} ${this.down * y})` + (turn ? ` rotate(${this.turn(turn)} ${cx} ${this.down * cy})` : "");
  }

  setPose(pose: Pose): void {
    this.pose = pose;
    for (const [name, path] of this.moved) {
      const movement = this.movementOf(name);
      if (movement) path.setAttribute("transform", this.transform([0, 0], 0, movement));
      else path.removeAttribute("transform");
    }
    this.place(this.at);
    this.setGhost(this.ghost);
    this.drawMarks();
  }

  setGhost(at: Place | null): void {
    this.ghost = at;
    this.layers.ghost.style.display = at ? "" : "none";
    if (at) this.layers.ghost.setAttribute("transform", this.transform(at, this.pose.angle, null));
  }

  setPlaced(placed: Placed[], picked: number, all: string[]): void {
    this.placed = placed;
    this.layers.placed.replaceChildren();
    const of = (p: Placed) => this.summary!.shapes.filter((s) => s.name === p.shape || (s.drawing && p.shape.split("+").includes(s.name)));
    const names = new Set(all);
    for (const [name, path] of this.moved) path.style.display = names.has(name) ? "none" : "";
    this.names = this.names.filter((n) => !names.has(n.text));
    placed.forEach((p, k) => {
      const d = of(p).map((s) => lookOf(s.drawing as Drawing)).join("");
      const path = element("path", { class: k === picked ? "placed picked" : "placed", "data-placed": `${k}`, d, transform: this.standing(p) }, this.layers.placed);
      element("title", {}, path).textContent = p.copy ? `${p.shape} ${p.copy}` : p.shape;
    });
  }

  private standing(p: Placed, by: Point = [0, 0]): string {
    const [x, y] = p.at as Point;
    return `translate(${x + by[0]} ${this.down * (y + by[1])}) rotate(${this.turn(p.angle)})`;
  }

  setAtoms(good: boolean, atoms: Atom[]): void {
    this.layers.part.classList.toggle("bad", !good);
    this.atoms = atoms;
    this.drawMarks();
  }

  setBetween(between: Between | null): void {
    this.between = between;
    this.drawMarks();
  }

  /// Around all that has a bound: shapes and the part at its position.
  fit(): void {
    const boxes = [this.layers.shapes, this.layers.placed].map((g) => g.getBBox());
    const part = this.layers.part.getBBox();
    const [px, py] = this.at as Point;
    boxes.push(new DOMRect(part.x + px, part.y + this.down * py, part.width, part.height));
    const every = boxes.filter((b) => b.width || b.height);
    if (!every.length) return;
    const x = Math.min(...every.map((b) => b.x)), y = Math.min(...every.map((b) => b.y));
    const w = Math.max(...every.map((b) => b.x + b.width)) - x, h = Math.max(...every.map((b) => b.y + b.height)) - y;
    const margin = 0.08 * Math.max(w, h);
    this.all = { x: x - margin, y: y - margin, w: w + 2 * margin, h: h + 2 * margin };
    this.box = { ...this.all };
    this.show();
  }

  zoom(by: number, at?: Point): void {
    const [cx, cy] = at ?? [this.box.x + this.box.w / 2, this.box.y + this.box.h / 2];
    const width = this.box.w * by;
    if (width > this.all.w * 1e3 || width < this.all.w * 1e-6) return;
    this.box = { x: cx + (this.box.x - cx) * by, y: cy + (this.box.y - cy) * by, w: width, h: this.box.h * by };
    this.show();
  }

  shift(right: number, up: number): void {
    this.box.x += kShift * right * this.box.w;
    this.box.y -= kShift * up * this.box.h;
    this.show();
  }

  /// A cross that keys move instead of a pointer, from the middle of the picture; nothing takes it away.
  moveCross(by: Place | null): void {
    const [x, y] = this.cross ?? [this.box.x + this.box.w / 2, this.down * (this.box.y + this.box.h / 2)];
    this.cross = by && this.rounded([x! + by[0]!, y! + by[1]!]);
    this.drawMarks();
  }

  /// A pointer's place in the picture.
  private under(e: { clientX: number; clientY: number }): Point {
    const p = new DOMPoint(e.clientX, e.clientY).matrixTransform(this.element.getScreenCTM()!.inverse());
    return [p.x, p.y];
  }

  private inScene([x, y]: Point): Place { return this.rounded([x, this.down * y]); }

  private follow(): void {
    const down = new Map<number, PointerEvent>();
    let hold: { from: Point; at: Place; part: boolean; far: boolean; placed: Element | null; by: Point } | null = null;
    const spread = (): { size: number; middle: Point } => {
      const [a, b] = [...down.values()] as [PointerEvent, PointerEvent];
      return { size: Math.hypot(a.clientX - b.clientX, a.clientY - b.clientY), middle: this.under({ clientX: (a.clientX + b.clientX) / 2, clientY: (a.clientY + b.clientY) / 2 }) };
    };
    const begin = (e: PointerEvent) => {
      down.set(e.pointerId, e);
      const part = (e.target as Element).classList.contains("part") && down.size === 1;
      const placed = down.size === 1 ? (e.target as Element).closest("[data-placed]") : null;
      hold = { from: this.under(e), at: this.at, part, far: false, placed, by: [0, 0] };
      this.element.setPointerCapture(e.pointerId);
    };
    const pan = ([x, y]: Point, from: Point) => {
      this.box.x -= x - from[0];
      this.box.y -= y - from[1];
      this.show();
    };
    const move = (e: PointerEvent) => {
      const before = down.get(e.pointerId);
      if (!before || !hold) return this.onHover(this.inScene(this.under(e)));
      if (down.size === 2) {
        const old = spread();
        down.set(e.pointerId, e);
        const { size, middle } = spread();
        pan(middle, old.middle);
        this.zoom(old.size / Math.max(size, 1), middle);
        return;
      }
      down.set(e.pointerId, e);
      const [x, y] = this.under(e);
      hold.far ||= Math.hypot(x - hold.from[0], y - hold.from[1]) > 4 * this.unit;
      if (hold.placed) {
        hold.by = [x - hold.from[0], this.down * (y - hold.from[1])];
        hold.placed.setAttribute("transform", this.standing(this.placed[numberOf(hold.placed)]!, hold.by));
        return;
      }
      if (!hold.part) return pan([x, y], hold.from);
      if (hold.far) this.onDrag(this.rounded([hold.at[0]! + x - hold.from[0], hold.at[1]! + this.down * (y - hold.from[1])]));
    };
    const release = (e: PointerEvent) => {
      down.delete(e.pointerId);
      if (hold && !hold.far && e.type === "pointerup") this.onPick(this.inScene(this.under(e)));
      if (hold?.placed && e.type === "pointerup") {
        const k = numberOf(hold.placed), { at } = this.placed[k]!;
        if (hold.far) this.onMovePlaced(k, this.rounded(at.map((c, i) => c + hold!.by[i]!)));
        else this.onPickPlaced(k);
      }
      if (hold?.part) this.onDragged();
      hold = null;
    };
    const signal = this.until;
    for (const element of [this.element, this.over]) {
      element.addEventListener("pointerdown", begin, { signal });
      element.addEventListener("pointermove", move, { signal });
      element.addEventListener("pointerup", release, { signal });
      element.addEventListener("pointercancel", release, { signal });
      element.addEventListener("wheel", (e) => {
        e.preventDefault();
        this.zoom(Math.exp(Math.sign(e.deltaY) * 0.15), this.under(e));
      }, { passive: false, signal });
    }
  }

  rounded(at: Place): Place { return shortDecimals(at, this.unit); }

  recolour(): void {}

  private show(): void {
    const { x, y, w, h } = this.box;
    for (const element of [this.element, this.over]) element.setAttribute("viewBox", `${x} ${y} ${w} ${h}`);
    const unit = `${this.unit}`;
    if (this.element.style.getPropertyValue("--px") !== unit) this.element.style.setProperty("--px", unit);
    this.drawMarks();
    this.drawBar();
  }

  private drawMarks(): void {
    const g = this.layers.marks, unit = this.unit, name = this.bar.dataset["unit"] ?? "";
    g.replaceChildren();
    const text = (style: string, x: number, y: number, content: string) => {
      const t = element("text", { class: style, x: `${x}`, y: `${y}`, "font-size": `${12 * unit}`, "stroke-width": `${3 * unit}` }, g);
      t.textContent = content;
    };
    const dimension = (style: string, p: Place, q: Place, value: number | null) => {
      const [x1, y1, x2, y2] = [p[0]!, this.down * p[1]!, q[0]!, this.down * q[1]!];
      element("line", { class: "dimension" + style, x1: `${x1}`, y1: `${y1}`, x2: `${x2}`, y2: `${y2}` }, g);
      if (value) text("label" + style, (x1 + x2) / 2, (y1 + y2) / 2 - 5 * unit, `${shown(value)} ${name}`.trim());
    };
    for (const n of this.names) {
      const movement = this.movementOf(n.text), [dx, dy] = movement ? placeAlong(movement, this.pose.time!) : [0, 0];
      text("name", n.x + dx, n.y + this.down * dy + 11 * unit, n.text);
    }
    for (const a of this.atoms) {
      const [p, q] = a.witness.points ?? [];
      if (p && q) dimension(a.true ? "" : " no", p, q, typeof a.value === "number" ? a.value : null);
    }
    if (this.cross) {
      const [x, y] = [this.cross[0]!, this.down * this.cross[1]!], r = 9 * unit;
      for (const [dx, dy] of [[r, 0], [0, r]] as Point[]) element("line", { class: "dimension between cross", x1: `${x - dx}`, y1: `${y - dy}`, x2: `${x + dx}`, y2: `${y + dy}` }, g);
    }
    if (this.between?.points) dimension(" between", ...this.between.points, this.between.distance);
  }

  private drawBar(): void {
    const length = roundLength(140 * this.unit);
    this.bar.style.width = `${length / this.unit}px`;
    this.bar.firstElementChild!.textContent = `${shown(length)} ${this.bar.dataset["unit"] ?? ""}`;
  }

  /// The picture with the colours that it has now.
  svg(): string { return pictureText([this.element, this.over]); }

  png(): Promise<Blob> { return pictureOf(this.svg(), this.element); }
}

function layer(id: string, parent: Element): SVGGraphicsElement {
  return element("g", { id: `layer-${id}` }, parent) as SVGGraphicsElement;
}
