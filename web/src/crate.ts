// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The picture of a layout of solids, in the picture of space: upon a floor, or in containers side by side along x. A
// solid is chosen by a click or in a list, and dragged along an axis by its arrows, or moved by keys.
import type { Corner, PackedItem, PackingProblem, PackingState, Place, ShapeInfo, SpaceDrawing } from "./engine";
import { holderOf, hueOf, keyedHolder, keyedMove, nameOf, numberOf, placeOf, sizeOf } from "./layout";
import type { LayoutPicture } from "./layout";
import { make } from "./panel";
import type { SpaceStage } from "./space";

const kBetween = 0.15;  // containers, of the width of one

function boxOf([x, y, z]: Corner): SpaceDrawing {
  const vertices = [...Array(8).keys()].map((k): Corner => [k & 1 ? x : 0, k & 2 ? y : 0, k & 4 ? z : 0]);
  return { vertices, faces: [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]], sheets: [], curves: [], points: [] };
}

export class CratePicture implements LayoutPicture {
  private problem: PackingProblem | null = null;
  private items: PackedItem[] = [];
  private state: PackingState | null = null;
  private from: number[] = [0];  // of each container
  private picked = "";
  onGrab: (item: number) => void = () => {};
  onDrag: (item: number, at: Place, to: number) => void = () => {};
  onDrop: (item: number, at: Place, to: number) => void = () => {};
  onHover: (item: number | null) => void = () => {};
  still = false;

  constructor(private readonly stage: SpaceStage, private readonly list: HTMLElement) {
    stage.turnsAll = true;
    stage.onPickPlaced = (k) => this.pick(k);
    let held = -1;
    stage.onDragPlaced = (k, at) => {
      if (held !== k) this.onGrab(k);
      held = k;
      this.onDrag(k, this.within(k, at), holderOf(this.items[k]!));
    };
    stage.onMovePlaced = (k, at) => {
      held = -1;
      this.onDrop(k, this.within(k, at), holderOf(this.items[k]!));
    };
  }

  private get index(): number { return this.items.findIndex((i) => nameOf(i) === this.picked); }

  /// In its container.
  private within(k: number, [x, y, z]: Place): Place { return this.stage.rounded([x! - this.from[holderOf(this.items[k]!)]!, y!, z!]); }

  private drawnAt(item: PackedItem, [x, y, z]: Place): Place { return [x! + this.from[holderOf(item)]!, y!, z!]; }

  private pick(k: number): void {
    const name = nameOf(this.items[k]!);
    this.picked = name === this.picked ? "" : name;
    this.onHover(this.picked ? k : null);
    this.show(this.problem!, this.state!, this.items);
  }

  show(problem: PackingProblem, state: PackingState, items: PackedItem[]): void {
    Object.assign(this, { problem, state, items });
    const holders = this.holders(problem, state);
    const parts = problem.parts.map((p): ShapeInfo => ({ name: p.name, moving: false, used: true, drawing: p.drawing as SpaceDrawing }));
    this.stage.setScene({ dimension: 3, step: 0, y: "up", where: "", moving: [], shapes: [...holders, ...parts], words: [], free: "position", place: false }, new Set());
    const placed = items.map((i) => ({
      shape: i.part, copy: i.copy, angle: 0, turns: false, at: this.drawnAt(i, placeOf(i)), colour: `hsl(${hueOf(problem, i.part)}, 45%, 60%)`,
      ...(i.rotation ? { rotation: i.rotation.map((row) => row.map(numberOf)) } : {}),
    }));
    this.stage.setPlaced(placed, this.still ? -1 : this.index, problem.parts.map((p) => p.name));
    this.showList();
  }

  /// The floor up to the height that is needed, or the containers that are used.
  private holders(problem: PackingProblem, state: PackingState): ShapeInfo[] {
    const floor = [...(problem.floor ?? []), sizeOf(state)] as Corner;
    const used = problem.containers
      ? (state.layout?.container?.containers ?? []).map((name) => problem.containers!.find((c) => c.name === name)!)
      : [{ size: floor, drawing: boxOf(floor) }];
    this.from = [];
    let from = 0;
    return used.map(({ size, drawing: inside }, k) => {
      this.from.push(from);
      const left = from;
      from += (1 + kBetween) * size[0];
      const drawing = { ...inside, vertices: inside.vertices.map(([x, y, z]): Corner => [x + left, y, z]) };
      return { name: ` ${k}`, moving: false, used: true, holder: true, drawing };
    });
  }

  private showList(): void {
    const focused = [...this.list.querySelectorAll("button")].indexOf(document.activeElement as HTMLButtonElement);
    this.list.replaceChildren();
    this.items.forEach((item, k) => {
      const button = make("button", make("li", this.list), nameOf(item));
      button.ariaPressed = String(nameOf(item) === this.picked);
      if (!this.still) button.title = "Move it by its arrows, or by arrow keys, Page Up and Page Down; [ and ] move it to another container";
      button.onclick = () => this.pick(k);
    });
    if (focused >= 0) this.list.querySelectorAll("button")[focused]?.focus();
  }

  showAt(item: number, at: Place, good: boolean): void { this.stage.showPlacedAt(item, this.drawnAt(this.items[item]!, at), good); }

  keyed(e: KeyboardEvent): { item: number; by: Place; to: number } | null {
    if (e.key === "Escape" && this.picked) this.pick(this.index);
    if (this.index < 0) return null;
    const own = holderOf(this.items[this.index]!), to = keyedHolder(e, own, this.from.length);
    const by = keyedMove(e, 3, this.stage.unit) ?? (to === own ? null : [0, 0, 0]);
    return by && { item: this.index, by: this.stage.rounded(by), to };
  }

  fit(): void { this.stage.fit(); }
  zoom(by: number): void { this.stage.zoom(by); }
  shift(right: number, up: number): void { this.stage.shift(right, up); }
  recolour(): void { this.stage.recolour(); }
  svg(): string { return this.stage.svg(); }
  png(): Promise<Blob> { return this.stage.png(); }
}
