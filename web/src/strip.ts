// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The picture of a layout in a strip, in a box, or on sheets beside each other; its parts are dragged, or moved by keys
// where they have the focus.
import type { PackedItem, PackingProblem, PackingState, Place, Point } from "./engine";
import { holderOf, hueOf, keyedHolder, keyedMove, nameOf, numberOf, placeOf } from "./layout";
import type { LayoutPicture } from "./layout";
import { kShift, onResize, roundLength, shortDecimals, shown } from "./picture";
import { element, pictureOf, pictureText } from "./svg";

const kBetween = 0.06;  // sheets, of the width of all

/// A sheet in the picture: what it looks like, and where it stands.
interface Holder { title: string; path: string; zones: string; from: number; width: number; height: number }

export class StripPicture implements LayoutPicture {
  private readonly holderLayer: SVGGElement;
  private readonly layer: SVGGElement;
  private holders: Holder[] = [];
  private items: PackedItem[] = [];
  private view: [number, number, number, number] = [0, 0, 1, 1];
  onGrab: (item: number) => void = () => {};
  onDrag: (item: number, at: Place, to: number) => void = () => {};
  onDrop: (item: number, at: Place, to: number) => void = () => {};
  onHover: (item: number | null) => void = () => {};
  still = false;

  /// `until`: as of the picture of a scene (stage.ts).
  constructor(private readonly svgElement: SVGSVGElement, private readonly bar: HTMLElement, private readonly until: AbortSignal) {
    svgElement.replaceChildren();
    this.holderLayer = element("g", { id: "layer-holders" }, svgElement) as SVGGElement;
    this.layer = element("g", { id: "layer-items" }, svgElement) as SVGGElement;
    this.follow();
    onResize(svgElement, until, () => this.look());
  }

  show(problem: PackingProblem, state: PackingState, items: PackedItem[]): void {
    this.items = items;
    this.showHolders(problem, state);
    const focused = document.activeElement?.getAttribute("data-item");
    this.layer.replaceChildren();
    items.forEach((item, k) => {
      const part = problem.parts.find((p) => p.name === item.part)!;
      const path = element("path", { class: "item", "data-item": `${k}`, tabindex: "0", role: "button", "aria-label": nameOf(item) + (this.still ? "" : this.holders.length > 1 ? "; arrow keys move it, [ and ] to another sheet" : "; arrow keys move it"), d: part.drawing as string, transform: this.transform(item, placeOf(item), holderOf(item)) }, this.layer);
      (path as SVGPathElement).style.setProperty("--hue", String(hueOf(problem, item.part)));
      element("title", {}, path).textContent = nameOf(item);
    });
    if (focused) this.layer.querySelector<SVGElement>(`[data-item="${focused}"]`)?.focus();
  }

  /// The strip, the box, or the sheets that are used.
  private showHolders(problem: PackingProblem, state: PackingState): void {
    this.holderLayer.replaceChildren();
    const { box, sheets } = state.layout?.container ?? {};
    if (problem.sheets) {
      const used = (sheets ?? []).map((name) => problem.sheets!.find((s) => s.name === name)!);
      this.holders = used.map((s, k) => ({ title: `sheet ${k + 1}: ${s.name}`, path: s.drawing, zones: s.zones, from: 0, width: 0, height: 0 }));
    } else {
      const width = state.length ?? 0, height = problem.height ?? numberOf(box ?? 0);
      this.holders = [{ title: "", path: `M0,0H${width}V${-height}H0z`, zones: "", from: 0, width: 0, height: 0 }];
    }
    const drawn = this.holders.map((h) => {
      const path = element("path", { class: "shape container", d: h.path }, this.holderLayer) as SVGPathElement;
      if (h.title) element("title", {}, path).textContent = h.title;
      ({ width: h.width, height: h.height } = path.getBBox());
      return path;
    });
    const between = kBetween * this.holders.reduce((sum, h) => sum + h.width, 0);
    let from = 0;
    this.holders.forEach((h, k) => {
      h.from = from;
      from += h.width + between;
      drawn[k]!.setAttribute("transform", `translate(${h.from} 0)`);
      if (h.zones) element("path", { class: "zone", d: h.zones, transform: `translate(${h.from} 0)` }, this.holderLayer);
    });
  }

  /// The sheet in which an item is dragged to the right by so much from its own, and its place there.
  private dropped(item: number, at: Place, [x, y]: Place, pointer: number): { at: Place; to: number } {
    const away = this.holders.map((h) => Math.max(h.from - pointer, pointer - h.from - h.width));
    const to = away.indexOf(Math.min(...away)), by = this.holders[holderOf(this.items[item]!)]!.from - this.holders[to]!.from;
    return { at: shortDecimals([at[0]! + x! + by, at[1]! + y!], this.unit), to };
  }

  showAt(item: number, at: Place, good: boolean, to: number): void {
    const path = this.layer.querySelector(`[data-item="${item}"]`);
    path?.setAttribute("transform", this.transform(this.items[item]!, at, to));
    path?.classList.toggle("wrong", !good);
  }

  private transform(item: PackedItem, [x, y]: Place, to: number): string {
    return `translate(${x! + this.holders[to]!.from} ${-y!}) rotate(${-numberOf(item.angle ?? 0)})` + (item.mirrored ? " scale(-1 1)" : "");
  }

  fit(): void {
    const last = this.holders[this.holders.length - 1], width = last ? last.from + last.width : 0;
    if (!width) return;
    const height = Math.max(...this.holders.map((h) => h.height)), margin = 0.05 * Math.max(width, height);
    this.view = [-margin, -height - margin, width + 2 * margin, height + 2 * margin];
    this.look();
  }

  zoom(by: number, at?: DOMPoint): void {
    const [x, y, w, h] = this.view, cx = at?.x ?? x + w / 2, cy = at?.y ?? y + h / 2;
    this.view = [cx + (x - cx) * by, cy + (y - cy) * by, w * by, h * by];
    this.look();
  }

  shift(right: number, up: number): void {
    const [x, y, w, h] = this.view;
    this.view = [x + kShift * right * w, y - kShift * up * h, w, h];
    this.look();
  }

  recolour(): void {}
  svg(): string { return pictureText([this.svgElement]); }
  png(): Promise<Blob> { return pictureOf(this.svg(), this.svgElement); }

  /// Units a pixel.
  private get unit(): number { return 1 / this.svgElement.getScreenCTM()!.a; }

  private look(): void {
    this.svgElement.setAttribute("viewBox", this.view.join(" "));
    const length = roundLength(140 * this.unit);
    this.bar.style.width = `${length / this.unit}px`;
    this.bar.firstElementChild!.textContent = shown(length);
  }

  keyed(e: KeyboardEvent): { item: number; by: Place; to: number } | null {
    const item = (e.target as Element).getAttribute("data-item");
    if (item === null) return null;
    const own = holderOf(this.items[Number(item)]!), to = keyedHolder(e, own, this.holders.length);
    const by = keyedMove(e, 2, this.unit) ?? (to === own ? null : [0, 0]);
    return by && { item: Number(item), by, to };
  }

  private follow(): void {
    const svg = this.svgElement, signal = this.until, under = (e: MouseEvent): DOMPoint => new DOMPoint(e.clientX, e.clientY).matrixTransform(svg.getScreenCTM()!.inverse());
    let hold: { id: number; from: DOMPoint; item: number; at: Place; to: number; moved: Place | null } | null = null;
    const down = new Map<number, PointerEvent>();
    /// What the pointers that are down span: of one its place.
    const span = (): { size: number; middle: DOMPoint } => {
      const all = [...down.values()], [a, b] = [all[0]!, all[all.length - 1]!];
      return { size: Math.hypot(a.clientX - b.clientX, a.clientY - b.clientY), middle: under(new MouseEvent("", { clientX: (a.clientX + b.clientX) / 2, clientY: (a.clientY + b.clientY) / 2 })) };
    };
    svg.addEventListener("pointerdown", (e) => {
      const path = this.still ? null : (e.target as Element).closest(".item");
      svg.setPointerCapture(e.pointerId);
      if (hold) return;
      if (!path || down.size) return void down.set(e.pointerId, e);
      const item = Number(path.getAttribute("data-item"));
      hold = { id: e.pointerId, from: under(e), item, at: placeOf(this.items[item]!), to: holderOf(this.items[item]!), moved: null };
      this.layer.append(path);
      this.onGrab(item);
    }, { signal });
    svg.addEventListener("pointermove", (e) => {
      if (down.has(e.pointerId)) {
        const old = span();
        down.set(e.pointerId, e);
        const { size, middle } = span(), [x, y, w, h] = this.view;
        this.view = [x - middle.x + old.middle.x, y - middle.y + old.middle.y, w, h];
        this.zoom(down.size > 1 ? old.size / Math.max(size, 1) : 1, old.middle);
      }
      if (!hold && !down.size) {
        const over = (e.target as Element).closest(".item")?.getAttribute("data-item");
        this.onHover(over ? Number(over) : null);
      }
      if (hold?.id !== e.pointerId) return;
      const p = under(e), by: Point = [p.x - hold.from.x, -(p.y - hold.from.y)];
      const { at, to } = this.dropped(hold.item, hold.at, by, p.x);
      Object.assign(hold, { moved: at, to });
      this.layer.querySelector(`[data-item="${hold.item}"]`)?.setAttribute("transform", this.transform(this.items[hold.item]!, at, to));
      this.onDrag(hold.item, at, to);
    }, { signal });
    const release = (e: PointerEvent) => {
      if (down.delete(e.pointerId) || hold?.id !== e.pointerId) return;
      this.onDrop(hold.item, hold.moved ?? hold.at, hold.to);
      hold = null;
    };
    svg.addEventListener("pointerup", release, { signal });
    svg.addEventListener("pointercancel", release, { signal });
    svg.addEventListener("wheel", (e) => {
      e.preventDefault();
      this.zoom(Math.exp(Math.sign(e.deltaY) * 0.15), under(e));
    }, { passive: false, signal });
  }
}
