// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The picture of a layout in a strip; its parts are dragged, or moved by keys where they have the focus.
import type { PackedItem, PackingProblem, PackingState, Place, Point } from "./engine";
import { hueOf, keyedMove, nameOf, numberOf, placeOf } from "./layout";
import type { LayoutPicture } from "./layout";
import { kShift, roundLength, shortDecimals, shown } from "./picture";
import { element, pictureOf, pictureText } from "./svg";

export class StripPicture implements LayoutPicture {
  private readonly layer: SVGGElement;
  private readonly strip: SVGElement;
  private problem: PackingProblem | null = null;
  private length = 0;
  private items: PackedItem[] = [];
  private view: [number, number, number, number] = [0, 0, 1, 1];
  onGrab: (item: number) => void = () => {};
  onDrag: (item: number, at: Place) => void = () => {};
  onDrop: (item: number, at: Place) => void = () => {};

  constructor(private readonly svgElement: SVGSVGElement, private readonly bar: HTMLElement) {
    svgElement.replaceChildren();
    this.strip = element("rect", { class: "shape container", x: "0", y: "0", width: "1", height: "1" }, svgElement);
    this.layer = element("g", { id: "layer-items" }, svgElement) as SVGGElement;
    this.follow();
    new ResizeObserver(() => this.look()).observe(svgElement);
  }

  show(problem: PackingProblem, state: PackingState, items: PackedItem[]): void {
    Object.assign(this, { problem, items, length: state.length ?? 0 });
    const height = problem.height!;
    for (const [key, value] of Object.entries({ width: this.length, y: -height, height })) this.strip.setAttribute(key, `${value}`);
    const focused = document.activeElement?.getAttribute("data-item");
    this.layer.replaceChildren();
    items.forEach((item, k) => {
      const part = problem.parts.find((p) => p.name === item.part)!;
      const path = element("path", { class: "item", "data-item": `${k}`, tabindex: "0", role: "button", "aria-label": `${nameOf(item)}; arrow keys move it`, d: part.drawing as string, transform: this.transform(item, placeOf(item)) }, this.layer);
      (path as SVGPathElement).style.setProperty("--hue", String(hueOf(problem, item.part)));
      element("title", {}, path).textContent = nameOf(item);
    });
    if (focused) this.layer.querySelector<SVGElement>(`[data-item="${focused}"]`)?.focus();
  }

  showAt(item: number, at: Place, good: boolean): void {
    const path = this.layer.querySelector(`[data-item="${item}"]`);
    path?.setAttribute("transform", this.transform(this.items[item]!, at));
    path?.classList.toggle("wrong", !good);
  }

  private transform(item: PackedItem, [x, y]: Place): string {
    return `translate(${x} ${-y!}) rotate(${-numberOf(item.angle ?? 0)})` + (item.mirrored ? " scale(-1 1)" : "");
  }

  fit(): void {
    if (!this.length) return;
    const height = this.problem!.height!, margin = 0.05 * Math.max(this.length, height);
    this.view = [-margin, -height - margin, this.length + 2 * margin, height + 2 * margin];
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

  keyed(e: KeyboardEvent): { item: number; by: Place } | null {
    const item = (e.target as Element).getAttribute("data-item"), by = keyedMove(e, 2, this.unit);
    return item !== null && by ? { item: Number(item), by } : null;
  }

  private follow(): void {
    const svg = this.svgElement, under = (e: MouseEvent): DOMPoint => new DOMPoint(e.clientX, e.clientY).matrixTransform(svg.getScreenCTM()!.inverse());
    let hold: { id: number; from: DOMPoint; item: number; at: Place; to: Place | null } | null = null;
    const down = new Map<number, PointerEvent>();
    /// What the pointers that are down span: of one its place.
    const span = (): { size: number; middle: DOMPoint } => {
      const all = [...down.values()], [a, b] = [all[0]!, all[all.length - 1]!];
      return { size: Math.hypot(a.clientX - b.clientX, a.clientY - b.clientY), middle: under(new MouseEvent("", { clientX: (a.clientX + b.clientX) / 2, clientY: (a.clientY + b.clientY) / 2 })) };
    };
    svg.addEventListener("pointerdown", (e) => {
      const path = (e.target as Element).closest(".item");
      svg.setPointerCapture(e.pointerId);
      if (hold) return;
      if (!path || down.size) return void down.set(e.pointerId, e);
      const item = Number(path.getAttribute("data-item"));
      hold = { id: e.pointerId, from: under(e), item, at: placeOf(this.items[item]!), to: null };
      this.layer.append(path);
      this.onGrab(item);
    });
    svg.addEventListener("pointermove", (e) => {
      if (down.has(e.pointerId)) {
        const old = span();
        down.set(e.pointerId, e);
        const { size, middle } = span(), [x, y, w, h] = this.view;
        this.view = [x - middle.x + old.middle.x, y - middle.y + old.middle.y, w, h];
        this.zoom(down.size > 1 ? old.size / Math.max(size, 1) : 1, old.middle);
      }
      if (hold?.id !== e.pointerId) return;
      const p = under(e), by: Point = [p.x - hold.from.x, -(p.y - hold.from.y)];
      hold.to = shortDecimals(hold.at.map((x, k) => x + by[k]!), this.unit);
      this.layer.querySelector(`[data-item="${hold.item}"]`)?.setAttribute("transform", this.transform(this.items[hold.item]!, hold.to));
      this.onDrag(hold.item, hold.to);
    });
    const release = (e: PointerEvent) => {
      if (down.delete(e.pointerId) || hold?.id !== e.pointerId) return;
      this.onDrop(hold.item, hold.to ?? hold.at);
      hold = null;
    };
    svg.addEventListener("pointerup", release);
    svg.addEventListener("pointercancel", release);
    svg.addEventListener("wheel", (e) => {
      e.preventDefault();
      this.zoom(Math.exp(Math.sign(e.deltaY) * 0.15), under(e));
    }, { passive: false });
  }
}
