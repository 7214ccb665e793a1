// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A packing that goes on: its best layout as it is found, and parts that are dragged; the others make room for them.
import { call, Refusal } from "./engine";
import type { PackedItem, PackingProblem, PackingState, Point } from "./engine";
import { make } from "./panel";
import { shown } from "./picture";
import { element, pictureOf, pictureText } from "./svg";

const kOfPacking = { scene: "scene" };
const kBetweenLooks = 300;
const kWays: Record<string, Point> = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };

const numberOf = (text: string): number => {
  const [a, b] = text.split("/");
  return Number(a) / Number(b ?? 1);
};

export class PackingPage {
  private readonly layer: SVGGElement;
  private readonly strip: SVGElement;
  private problem: PackingProblem | null = null;
  private state: PackingState | null = null;
  private items: PackedItem[] = [];
  private shown = 0;
  private said = "";
  private held = false;
  private view: [number, number, number, number] = [0, 0, 1, 1];

  constructor(private readonly svg: SVGSVGElement, private readonly box: HTMLElement, private readonly verdict: (text: string, good: boolean | null) => void) {
    this.strip = element("rect", { class: "shape container", x: "0", y: "0", width: "1", height: "1" }, svg);
    this.layer = element("g", { id: "layer-items" }, svg) as SVGGElement;
  }

  async begin(): Promise<void> {
    this.controls();
    await this.start(false);
    this.show(await call<PackingState>("packing", { ...kOfPacking, since: 0 }));
    if (!this.state!.length) await this.start(true);
    this.follow();
    void this.watch();
  }

  private controls(): void {
    const row = make("div", this.box, "", "row");
    const button = (text: string, id: string, act: () => Promise<void>) => {
      const made = make("button", row, text);
      made.id = id;
      made.onclick = () => void act().catch((e: unknown) => this.verdict(e instanceof Error ? e.message : String(e), false));
    };
    button("Stop", "pack-stop", async () => this.show(await call<PackingState>("stop", kOfPacking)));
    button("Go on", "pack-go", () => this.start(true));
    button("Save layout", "pack-save", async () => {
      const state = await call<PackingState>("packing", { ...kOfPacking, since: 0 });
      const link = make("a", document.body);
      link.href = URL.createObjectURL(new Blob([JSON.stringify({ findspace: 1, layout: state.layout }, null, 1)], { type: "application/json" }));
      link.download = "layout.json";
      link.click();
      link.remove();
    });
    make("p", this.box, "", "facts").id = "pack-facts";
    make("p", this.box, "Drag a part, or move the one that has the focus by keys: the others make room, and the search goes on from there when you say so.", "hint");
  }

  private async start(search: boolean): Promise<void> {
    this.problem = await call<PackingProblem>("pack", { ...kOfPacking, drawing: true, search });
    document.title = `${this.problem.name || "packing"} – findspace`;
  }

  private async watch(): Promise<void> {
    for (;;) {
      if (!this.held) this.show(await call<PackingState>("packing", { ...kOfPacking, since: this.shown }));
      await new Promise((done) => setTimeout(done, kBetweenLooks));
    }
  }

  private show(state: PackingState): void {
    this.state = state;
    const density = (100 * state.density).toFixed(2);
    document.getElementById("pack-facts")!.textContent = state.length
      ? `Layout ${state.number}: length ${shown(state.length)}, density ${density} %, after ${state.seconds.toFixed(1)} s. No layout is shorter than ${shown(this.problem!.lower_bound)}.`
      : "";
    const said = state.failure ?? (state.running ? "Packing" : state.length ? "Stopped: the best layout is kept" : "Not begun");
    if (said !== this.said || state.number !== this.shown) this.verdict(said, state.failure ? false : state.running ? null : true);
    this.said = said;
    if (!state.layout || state.number === this.shown) return;
    const first = this.shown === 0;
    this.shown = state.number;
    this.items = state.layout.items;
    this.draw();
    if (first) this.fit();
  }

  private draw(): void {
    const { height, parts } = this.problem!;
    for (const [key, value] of Object.entries({ width: this.state!.length, y: -height, height })) this.strip.setAttribute(key, `${value}`);
    const focused = document.activeElement?.getAttribute("data-item");
    this.layer.replaceChildren();
    this.items.forEach((item, k) => {
      const which = parts.findIndex((p) => p.name === item.part);
      const path = element("path", { class: "item", "data-item": `${k}`, tabindex: "0", role: "button", "aria-label": `${item.part} ${item.copy}; arrow keys move it`, d: parts[which]!.drawing, transform: this.transform(item) }, this.layer);
      (path as SVGPathElement).style.setProperty("--hue", String((360 * which) / parts.length));
      element("title", {}, path).textContent = `${item.part} ${item.copy}`;
    });
    if (focused) this.layer.querySelector<SVGElement>(`[data-item="${focused}"]`)?.focus();
  }

  private transform(item: PackedItem, by: Point = [0, 0]): string {
    const [x, y] = item.at.map(numberOf) as Point;
    return `translate(${x + by[0]} ${-(y + by[1])}) rotate(${-numberOf(String(item.angle))})` + (item.mirrored ? " scale(-1 1)" : "");
  }

  fit(): void {
    if (!this.state?.length) return;
    const { length } = this.state, { height } = this.problem!, margin = 0.05 * Math.max(length, height);
    this.view = [-margin, -height - margin, length + 2 * margin, height + 2 * margin];
    this.look();
  }

  zoom(by: number, at?: DOMPoint): void {
    const [x, y, w, h] = this.view, cx = at?.x ?? x + w / 2, cy = at?.y ?? y + h / 2;
    this.view = [cx + (x - cx) * by, cy + (y - cy) * by, w * by, h * by];
    this.look();
  }

  svgText(): string { return pictureText([this.svg]); }
  png(): Promise<Blob> { return pictureOf(this.svgText(), this.svg); }

  private look(): void { this.svg.setAttribute("viewBox", this.view.join(" ")); }

  /// The item that has the focus, by keys.
  private onKey(e: KeyboardEvent): void {
    const way = kWays[e.key], item = (e.target as Element).getAttribute("data-item");
    if (!way || item === null) return;
    e.preventDefault();
    const step = (e.shiftKey ? 50 : e.altKey ? 1 : 5) / this.svg.getScreenCTM()!.a;
    this.repair(Number(item), [way[0] * step, way[1] * step]);
  }

  private repair(item: number, by: Point): void {
    const [x, y] = this.items[item]!.at.map(numberOf) as Point;
    this.held = true;
    this.verdict("The others make room", null);
    call<PackingState>("repair", { ...kOfPacking, item, at: [x + by[0], y + by[1]] })
      .then((state) => this.show(state), (e: unknown) => {
        this.verdict(e instanceof Refusal ? e.message : String(e), false);
        this.draw();
      })
      .finally(() => { this.held = false; });
  }

  private follow(): void {
    const under = (e: MouseEvent): DOMPoint => new DOMPoint(e.clientX, e.clientY).matrixTransform(this.svg.getScreenCTM()!.inverse());
    let hold: { from: DOMPoint; item: number; path: Element; by: Point } | null = null;
    this.svg.addEventListener("pointerdown", (e) => {
      const path = (e.target as Element).closest(".item");
      if (!path) return;
      this.held = true;
      hold = { from: under(e), item: Number(path.getAttribute("data-item")), path, by: [0, 0] };
      this.layer.append(path);
      this.svg.setPointerCapture(e.pointerId);
    });
    this.svg.addEventListener("pointermove", (e) => {
      if (!hold) return;
      const p = under(e);
      hold.by = [p.x - hold.from.x, -(p.y - hold.from.y)];
      hold.path.setAttribute("transform", this.transform(this.items[hold.item]!, hold.by));
    });
    this.svg.addEventListener("pointerup", () => {
      if (!hold) return;
      const { item, by } = hold;
      hold = null;
      this.repair(item, by);
    });
    this.svg.addEventListener("keydown", (e) => this.onKey(e));
    this.svg.addEventListener("wheel", (e) => {
      e.preventDefault();
      this.zoom(Math.exp(Math.sign(e.deltaY) * 0.15), under(e));
    }, { passive: false });
  }
}
