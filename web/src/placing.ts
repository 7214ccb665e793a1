// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A placement that goes on: what stands is shown as it is found, stop keeps it, and a part that is moved takes its new
// place while the others stay as near to theirs as they can.
import { call } from "./engine";
import type { Place, Placement } from "./engine";
import { make } from "./panel";
import type { Picture, Placed } from "./picture";

const kFirstLook = 0.3, kLastLook = 600;

interface Near { shape: string; copy: number; at: Place; angle?: number }

export class Placing {
  private placed: Placed[] = [];
  private names: string[] = [];
  private run = 0;
  private picked = -1;
  private readonly past: Placed[][] = [];
  private readonly future: Placed[][] = [];
  private readonly list: HTMLElement;

  constructor(private readonly picture: Picture, box: HTMLElement, private readonly verdict: (text: string, good: boolean | null) => void, private readonly kept: (back: boolean, forth: boolean) => void) {
    const row = make("div", box, "", "row");
    const button = (text: string, id: string, act: () => void) => {
      const made = make("button", row, text);
      made.id = id;
      made.onclick = act;
    };
    button("Place again", "place-again", () => void this.begin());
    button("Stop", "place-stop", () => this.stop());
    this.list = make("ul", box);
    this.list.id = "placed";
    make("p", box, "Drag a part, or choose one and move it by keys: the others make room.", "hint");
    picture.onMovePlaced = (k, at) => void this.move(k, at);
    picture.onPickPlaced = (k) => this.pick(k);
  }

  /// All anew, in the order of the scene.
  async begin(): Promise<void> {
    await this.place([]);
    this.picture.fit();
  }

  /// What is still being looked for is not shown.
  end(): void { this.run += 1; }

  stop(): void {
    this.end();
    this.verdict(`Stopped: ${this.placed.length} are placed`, null);
  }

  get chosen(): boolean { return this.picked >= 0; }

  /// The one that is chosen, by so much along an axis.
  nudge(axis: number, by: number): void {
    const { at } = this.placed[this.picked]!;
    void this.move(this.picked, at.map((c, k) => (k === axis ? c + by : c)));
  }

  step(back: boolean): void {
    const [from, to] = back ? [this.past, this.future] : [this.future, this.past];
    const before = from.pop();
    if (!before) return;
    this.end();
    to.push(this.placed);
    this.show(before);
    this.verdict(`${before.length} are placed`, true);
  }

  private async move(k: number, at: Place): Promise<void> {
    const near = (p: Placed, place: Place): Near => ({ shape: p.shape, copy: p.copy, at: place, ...(p.turns ? { angle: p.angle } : {}) });
    await this.place([near(this.placed[k]!, at), ...this.placed.filter((_, i) => i !== k).map((p) => near(p, p.at))]);
  }

  private pick(k: number): void {
    this.picked = k === this.picked ? -1 : k;
    this.show(this.placed);
  }

  /// Looks again after twice the time until all stand, or no more time helps.
  private async place(near: Near[]): Promise<void> {
    const run = (this.run += 1), before = this.placed;
    this.verdict(near.length ? "The others make room" : "Placing", null);
    try {
      for (let seconds = kFirstLook; ; seconds *= 2) {
        const found = await call<Placement>("place", { seconds, ...(near.length ? { near } : {}) });
        if (run !== this.run) return;
        this.names = found.positions.flatMap((p) => [p.shape, ...p.shape.split("+")]);
        const stand = found.positions.filter((p) => p.at), all = stand.length === found.positions.length;
        const late = !found.proven && !!found.reason?.includes("time limit") && seconds < kLastLook;
        if (all || !near.length || !late) this.show(stand.map((p) => ({ shape: p.shape, copy: p.copy ?? 0, at: p.at!, angle: p.angle ?? 0, turns: p.angle !== undefined })));
        if (all || !late) {
          if (before.length) this.past.push(before);
          this.future.length = 0;
          this.show(this.placed);
          return this.verdict(all ? `All ${stand.length} are placed` : `${stand.length} of ${found.positions.length} are placed${found.reason ? `: ${found.reason}` : ""}`, all);
        }
        this.verdict(`Placing: ${stand.length} of ${found.positions.length} stand`, null);
      }
    } catch (e) {
      if (run !== this.run) return;
      this.verdict(e instanceof Error ? e.message : String(e), false);
      this.show(before);
    }
  }

  private show(placed: Placed[]): void {
    const chosen = this.placed[this.picked];
    if (placed !== this.placed && chosen) this.picked = placed.findIndex((p) => p.shape === chosen.shape && p.copy === chosen.copy);
    this.placed = placed;
    this.picture.setPlaced(placed, this.picked, this.names);
    this.kept(this.past.length > 0, this.future.length > 0);
    const focused = [...this.list.querySelectorAll("button")].indexOf(document.activeElement as HTMLButtonElement);
    this.list.replaceChildren();
    placed.forEach((p, k) => {
      const button = make("button", make("li", this.list), p.copy ? `${p.shape} ${p.copy}` : p.shape);
      button.ariaPressed = String(k === this.picked);
      button.title = "Move it by keys";
      button.onclick = () => this.pick(k);
    });
    if (focused >= 0) this.list.querySelectorAll("button")[focused]?.focus();
  }
}
