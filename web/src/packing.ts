// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A packing that goes on, in the plane or of solids: its best layout as it is found, and parts that are dragged; the
// others make room for them. Undo goes back to the layouts before each act. Without an engine: a layout to look at.
import { placeText, save } from "./alone";
import type { AlonePacking } from "./alone";
import { call, latest, Refusal } from "./engine";
import type { PackedItem, PackingProblem, PackingState, Place, Verdict } from "./engine";
import type { History } from "./history";
import { holderOf, nameOf, numberOf, placeOf, sizeOf } from "./layout";
import type { LayoutPicture } from "./layout";
import { make } from "./panel";
import { shown } from "./picture";

const kOfPacking = { scene: "scene" };
const kBetweenLooks = 300;

/// A layout as a file has it.
const textOf = (state: PackingState): string => JSON.stringify({ findspace: 1, layout: state.layout }, null, 1);

export class PackingPage {
  private picture: LayoutPicture | null = null;
  private problem: PackingProblem | null = null;
  private state: PackingState | null = null;
  private items: PackedItem[] = [];
  private shown = 0;
  private said = "";
  private held = 0;
  private searched = false;  // when the state was last shown: the last layout of a search comes after it
  private looked = false;  // somebody has turned or moved the picture
  private stopped: Promise<void> = Promise.resolve();
  private past: string[] = [];
  private future: string[] = [];

  /// `make`: a picture of the problem; `hover`: where it is said what the pointer is over.
  constructor(
    private readonly makePicture: (problem: PackingProblem) => Promise<LayoutPicture>, private readonly box: HTMLElement,
    private readonly verdict: (text: string, good: boolean | null) => void, private readonly hover: (text: string) => void, private readonly history: History,
  ) {}

  /// What a page that stands alone needs.
  async taken(): Promise<AlonePacking> { return { problem: this.problem!, state: await this.ask("packing", { since: 0 }) }; }

  /// A layout to look at.
  async beginAlone({ problem, state }: AlonePacking): Promise<void> {
    make("p", this.box, "", "facts").id = "pack-facts";
    this.problem = problem;
    await this.picturePut();
    this.picture!.still = true;
    this.show({ ...state, running: false });
    this.verdict("A layout, proved where it was found", null);
  }

  async begin(): Promise<void> {
    this.controls();
    this.allow();
    for (const at of ["pointerdown", "wheel"]) document.getElementById("stage")!.addEventListener(at, () => { this.looked = true; }, { capture: true, passive: true });
    await this.load({ search: false });
    this.show(await this.ask("packing", { since: 0 }));
    if (!sizeOf(this.state!)) await call<PackingProblem>("pack", { ...kOfPacking, search: true });
    void this.watch();
  }

  /// The problem that the engine has then, and its picture.
  private async load(asked: object): Promise<void> {
    this.problem = await call<PackingProblem>("pack", { ...kOfPacking, drawing: true, ...asked });
    await this.picturePut();
    this.picture!.onGrab = () => this.grab();
    this.picture!.onDrag = (item, at, to) => void this.check(nameOf(this.items[item]!), at, to);
    this.picture!.onDrop = (item, at, to) => void this.drop(nameOf(this.items[item]!), at, to);
  }

  private async picturePut(): Promise<void> {
    this.picture = await this.makePicture(this.problem!);
    this.shown = 0;
    this.picture.onHover = (item) => this.hover(item === null ? "" : this.about(this.items[item]!));
    document.title = `${this.problem!.name || "packing"} – findspace`;
  }

  private about(item: PackedItem): string {
    const holders = this.state?.layout?.container, turned = numberOf(item.angle ?? 0);
    const where = (holders?.sheets ?? holders?.containers)?.[holderOf(item)];
    const how = [placeText(placeOf(item)), ...(turned ? [`${shown(turned)}°`] : []), ...(item.mirrored ? ["mirrored"] : []), ...(where ? [`${where} ${holderOf(item) + 1}`] : [])];
    return `${nameOf(item)}: ${how.join(", ")}`;
  }

  get view(): LayoutPicture { return this.picture!; }

  private ask(method: string, params: object = {}): Promise<PackingState> { return call<PackingState>(method, { ...kOfPacking, ...params }); }

  private fault(e: unknown): void { this.verdict(e instanceof Error ? e.message : String(e), false); }

  private controls(): void {
    const row = make("div", this.box, "", "row");
    const button = (text: string, id: string, act: () => Promise<void>) => {
      const made = make("button", row, text);
      made.id = id;
      made.onclick = () => void act().catch((e: unknown) => this.fault(e));
    };
    button("Stop", "pack-stop", async () => this.show(await this.ask("stop")));
    button("Go on", "pack-go", async () => {
      this.remember();
      await call<PackingProblem>("pack", kOfPacking);
    });
    button("Save layout", "pack-save", async () => save("layout.json", new Blob([textOf(await this.ask("packing", { since: 0 }))], { type: "application/json" })));
    make("p", this.box, "", "facts").id = "pack-facts";
    make("p", this.box, "Drag a part, or move the one that is chosen by keys: the others make room, and the search goes on from there when you say so. A layout or a problem is opened when it is dropped here.", "hint");
  }

  private async watch(): Promise<void> {
    for (;;) {
      try {
        if (!this.held) this.show(await this.ask("packing", { since: this.shown }));
      } catch (e) {
        this.fault(e);
      }
      await new Promise((done) => setTimeout(done, kBetweenLooks));
    }
  }

  private show(state: PackingState): void {
    this.state = state.layout || !this.state ? state : { ...state, ...(this.state.layout ? { layout: this.state.layout } : {}) };
    document.getElementById("pack-facts")!.textContent = sizeOf(state) ? this.facts() : "";
    const said = state.failure ?? (state.running ? "Packing" : this.isBest() ? "No better layout is possible" : sizeOf(state) ? "Stopped: the best layout is kept" : "Not begun");
    if (said !== this.said || state.number !== this.shown) this.verdict(said, state.failure ? false : state.running ? null : true);
    this.said = said;
    const searched = this.searched || state.running;
    this.searched = state.running;
    if (!state.layout || state.number === this.shown) return;
    const fits = this.shown === 0 || (searched && !this.looked);
    this.shown = state.number;
    this.items = state.layout.items;
    this.picture!.show(this.problem!, this.state, this.items);
    if (fits) this.picture!.fit();
  }

  private get bound(): number { return Math.max(this.problem!.lower_bound, Number(this.state?.layout?.lower_bound ?? 0)); }

  /// Whether sheets or containers are counted, not a length.
  private get holders(): boolean { return !!(this.problem!.sheets ?? this.problem!.containers); }

  private isBest(): boolean { return !this.holders && !this.problem!.box && sizeOf(this.state!) > 0 && sizeOf(this.state!) <= this.bound; }

  private facts(): string {
    const { number, density, seconds, layout } = this.state!, size = shown(sizeOf(this.state!)), space = this.problem!.dimension === 3;
    const { box, sheets, containers } = layout?.container ?? {}, holders = (sheets ?? containers)?.length ?? 0, kind = sheets ? "sheet" : "container";
    const what = holders ? `${holders} ${kind}${holders === 1 ? "" : "s"}, ${size} of the last` : box ? `${size} × ${shown(numberOf(box))}` : `${space ? "height" : "length"} ${size}`;
    const bound = this.holders ? (this.bound > 1 ? ` No layout of all parts takes fewer than ${shown(this.bound)} ${kind}s.` : "") : this.problem!.box ? ` No box has a smaller area than ${shown(this.bound)}.` : ` No layout is ${space ? "lower" : "shorter"} than ${shown(this.bound)}.`;
    const left = (layout?.left_out ?? []).reduce((sum, out) => sum + out.copies, 0);
    return `Layout ${number}: ${what}, density ${(100 * density).toFixed(2)} %, after ${seconds.toFixed(1)} s.${bound}${left ? ` ${left} left out.` : ""}`;
  }

  /// Keys move the chosen item, undo and redo.
  key(e: KeyboardEvent): boolean {
    if ((e.ctrlKey || e.metaKey) && e.key.toLowerCase() === "z") {
      this.step(!e.shiftKey);
      return true;
    }
    const move = e.ctrlKey || e.metaKey ? null : this.picture!.keyed(e);
    if (!move) return false;
    const item = this.items[move.item]!;
    this.grab();
    void this.drop(nameOf(item), placeOf(item).map((x, k) => x + move.by[k]!), move.to);
    return true;
  }

  /// What is dropped on the page: a layout of this problem, or another problem.
  async open(text: string): Promise<void> {
    const file = JSON.parse(text) as { layout?: unknown };
    if (file.layout !== undefined) {
      this.remember();
      await call("pack", { ...kOfPacking, start: text, search: false });
    } else {
      await this.load({ text });
      this.past = this.future = [];
      this.allow();
    }
    this.show(await this.ask("packing", { since: 0 }));
  }

  private allow(): void { this.history.allow(this.past.length > 0, this.future.length > 0); }

  private remember(): void {
    if (!this.state?.layout) return;
    this.past.push(textOf(this.state));
    this.future = [];
    this.allow();
  }

  step(back: boolean): void {
    const [from, to] = back ? [this.past, this.future] : [this.future, this.past];
    const start = from.pop();
    if (!start) return;
    to.push(textOf(this.state!));
    this.allow();
    this.hold(async () => {
      await call("pack", { ...kOfPacking, start, search: false });
      this.show(await this.ask("packing", { since: 0 }));
    });
  }

  /// Nothing else is shown until it is done.
  private hold(act: () => Promise<void>): void {
    this.held += 1;
    void act().catch((e: unknown) => this.fault(e)).finally(() => { this.held -= 1; });
  }

  /// The search ends, so that the layout stays the one that is seen.
  private grab(): void {
    this.held += 1;
    this.stopped = this.ask("stop").then((state) => {
      if (state.number !== this.shown) this.show(state);
    });
  }

  /// Whether the part may stand there as the others do.
  private readonly check = latest(async (name: string, at: Place, to: number) => {
    await this.stopped;
    const item = this.items.findIndex((i) => nameOf(i) === name);
    const { verdict } = await call<Verdict>("verify", { ...kOfPacking, item, at, ...this.holder(to) });
    if (!this.held) return;
    this.picture!.showAt(item, at, verdict.feasible, to);
    this.verdict(verdict.feasible ? "Free there" : verdict.faults[0]!.text, verdict.feasible);
    this.said = "";
  });

  /// The sheet or container as requests name it.
  private holder(to: number): object { return this.problem!.sheets ? { sheet: to } : this.problem!.containers ? { container: to } : {}; }

  private async drop(name: string, at: Place, to: number): Promise<void> {
    try {
      await this.stopped;
      const item = this.items.findIndex((i) => nameOf(i) === name), before = textOf(this.state!);
      this.verdict("The others make room", null);
      this.show(await this.ask("repair", { item, at, ...this.holder(to) }));
      this.past.push(before);
      this.future = [];
      this.allow();
    } catch (e) {
      this.verdict(e instanceof Refusal ? e.message : String(e), false);
      this.picture!.show(this.problem!, this.state!, this.items);
    } finally {
      this.held -= 1;
    }
  }
}
