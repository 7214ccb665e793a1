// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The picture: shapes, region, the moving part, dimension lines; panning and zooming. The picture's own coordinates are
// the scene's with y down, so path data of the engine stand as they are.
import type { Atom, Drawing, Point, Summary } from "./engine";

const kSvg = "http://www.w3.org/2000/svg";

export function element(name: string, attributes: Record<string, string>, parent?: Element): SVGElement {
  const made = document.createElementNS(kSvg, name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  parent?.append(made);
  return made;
}

const dots = (points: Point[]): string => points.map(([x, y]) => `M${x} ${y}h0`).join("");

export const shown = (value: number): string => Number(value.toPrecision(6)).toString().replace("-", "−");

const around = (b: DOMRect, o: DOMRect): boolean =>
  b.x <= o.x && b.y <= o.y && b.x + b.width >= o.x + o.width && b.y + b.height >= o.y + o.height;

export class Stage {
  private readonly layers: Record<"shapes" | "own" | "region" | "ghost" | "part" | "marks", SVGElement>;
  private box = { x: 0, y: 0, w: 1, h: 1 };
  private all = { x: 0, y: 0, w: 1, h: 1 };
  private names: { x: number; y: number; text: string }[] = [];
  private atoms: Atom[] = [];
  at: Point = [0, 0];
  onDrag: (at: Point) => void = () => {};
  onDragged: () => void = () => {};

  constructor(readonly svg: SVGSVGElement, private readonly bar: HTMLElement) {
    const layer = (id: string) => element("g", { id }, svg);
    this.layers = { shapes: layer("layer-shapes"), own: layer("layer-own"), region: layer("layer-region"), ghost: layer("layer-ghost"), part: layer("layer-part"), marks: layer("layer-marks") };
    this.follow();
    new ResizeObserver(() => this.show()).observe(svg);
  }

  /// Scene units per pixel.
  get unit(): number {
    const { width, height } = this.svg.getBoundingClientRect();
    return Math.max(this.box.w / Math.max(width, 1), this.box.h / Math.max(height, 1));
  }

  setScene(summary: Summary, hidden: Set<string>): void {
    this.layers.shapes.replaceChildren();
    this.layers.part.replaceChildren();
    this.layers.ghost.replaceChildren();
    this.names = [];
    const fixed: { path: SVGGraphicsElement; b: DOMRect }[] = [];
    for (const s of summary.shapes) {
      const d = s.drawing.faces + s.drawing.free + dots(s.drawing.points);
      if (s.moving) {
        element("path", { class: "part", d }, this.layers.part);
        element("path", { class: "ghost", d }, this.layers.ghost);
        continue;
      }
      if (hidden.has(s.name)) continue;
      const path = element("path", { class: "shape", d }, this.layers.shapes) as SVGGraphicsElement;
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
    element("path", { class: "pole", d: "M0 0h0" }, this.layers.part);
    this.place(this.at);
  }

  /// `own`: the set of one condition, below the region.
  setRegion(d: Drawing | null, own = false): void {
    const g = own ? this.layers.own : this.layers.region;
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

  place(at: Point): void {
    this.at = at;
    this.layers.part.setAttribute("transform", `translate(${at[0]} ${-at[1]})`);
  }

  setGhost(at: Point | null): void {
    this.layers.ghost.toggleAttribute("hidden", !at);
    this.layers.ghost.style.display = at ? "" : "none";
    if (at) this.layers.ghost.setAttribute("transform", `translate(${at[0]} ${-at[1]})`);
  }

  setAtoms(good: boolean, atoms: Atom[]): void {
    this.layers.part.classList.toggle("bad", !good);
    this.atoms = atoms;
    this.drawMarks();
  }

  /// Around all that has a bound: shapes and the part at its position.
  fit(): void {
    const boxes = [this.layers.shapes, this.layers.part].map((g) => (g as unknown as SVGGraphicsElement).getBBox()).filter((b) => b.width || b.height);
    const [px, py] = [this.at[0], -this.at[1]];
    const part = boxes.pop();
    const shifted = part ? [{ x: part.x + px, y: part.y + py, width: part.width, height: part.height }] : [];
    const every = [...boxes, ...shifted];
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

  /// A pointer's place in the picture.
  private under(e: { clientX: number; clientY: number }): Point {
    const matrix = this.svg.getScreenCTM()!.inverse();
    const p = new DOMPoint(e.clientX, e.clientY).matrixTransform(matrix);
    return [p.x, p.y];
  }

  private follow(): void {
    const svg = this.svg;
    let hold: { from: Point; at: Point; part: boolean } | null = null;
    svg.addEventListener("pointerdown", (e) => {
      const part = (e.target as Element).classList.contains("part");
      hold = { from: this.under(e), at: this.at, part };
      svg.setPointerCapture(e.pointerId);
    });
    svg.addEventListener("pointermove", (e) => {
      if (!hold) return;
      const [x, y] = this.under(e);
      const dx = x - hold.from[0], dy = y - hold.from[1];
      if (hold.part) this.onDrag(this.rounded([hold.at[0] + dx, hold.at[1] - dy]));
      else {
        this.box.x -= dx;
        this.box.y -= dy;
        this.show();
      }
    });
    const release = () => {
      if (hold?.part) this.onDragged();
      hold = null;
    };
    svg.addEventListener("pointerup", release);
    svg.addEventListener("pointercancel", release);
    svg.addEventListener("wheel", (e) => {
      e.preventDefault();
      this.zoom(Math.exp(Math.sign(e.deltaY) * 0.15), this.under(e));
    }, { passive: false });
  }

  /// To a tenth of a pixel, as a short decimal.
  rounded([x, y]: Point): Point {
    const places = Math.min(12, Math.max(0, Math.ceil(-Math.log10(this.unit)) + 1));
    return [Number(x.toFixed(places)), Number(y.toFixed(places))];
  }

  private show(): void {
    const { x, y, w, h } = this.box;
    this.svg.setAttribute("viewBox", `${x} ${y} ${w} ${h}`);
    this.drawMarks();
    this.drawBar();
  }

  private drawMarks(): void {
    const g = this.layers.marks, unit = this.unit;
    g.replaceChildren();
    const text = (style: string, x: number, y: number, content: string) => {
      const t = element("text", { class: style, x: `${x}`, y: `${y}`, "font-size": `${12 * unit}`, "stroke-width": `${3 * unit}` }, g);
      t.textContent = content;
    };
    for (const n of this.names) text("name", n.x, n.y + 11 * unit, n.text);
    for (const a of this.atoms) {
      const [p, q] = a.witness.points ?? [];
      if (!p || !q) continue;
      const style = a.true ? "" : " no";
      element("line", { class: "dimension" + style, x1: `${p[0]}`, y1: `${-p[1]}`, x2: `${q[0]}`, y2: `${-q[1]}` }, g);
      if (typeof a.value === "number" && a.value !== 0) text("label" + style, (p[0] + q[0]) / 2, -(p[1] + q[1]) / 2 - 5 * unit, `${shown(a.value)} ${this.bar.dataset["unit"] ?? ""}`.trim());
    }
  }

  private drawBar(): void {
    const most = 140 * this.unit, power = 10 ** Math.floor(Math.log10(most));
    const length = [5, 2, 1].map((k) => k * power).find((l) => l <= most) ?? power;
    this.bar.style.width = `${length / this.unit}px`;
    this.bar.firstElementChild!.textContent = `${shown(length)} ${this.bar.dataset["unit"] ?? ""}`;
  }
}
