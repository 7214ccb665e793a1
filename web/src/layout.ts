// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What a picture of a layout can do, in the plane (strip.ts) and of solids (crate.ts).
import type { PackedItem, PackingProblem, PackingState, Place } from "./engine";

export interface LayoutPicture {
  /// An item is taken in hand, is dragged to a place, and is put there: on the sheet or in the container `to`, counted from 0.
  onGrab: (item: number) => void;
  onDrag: (item: number, at: Place, to: number) => void;
  onDrop: (item: number, at: Place, to: number) => void;
  /// The pointer is over an item, or over none.
  onHover: (item: number | null) => void;
  /// Nothing can be moved.
  still: boolean;
  show(problem: PackingProblem, state: PackingState, items: PackedItem[]): void;
  /// An item is drawn elsewhere, and as a bad one where it must not be.
  showAt(item: number, at: Place, good: boolean, to: number): void;
  fit(): void;
  zoom(by: number): void;
  /// As picture.ts.
  shift(right: number, up: number): void;
  recolour(): void;
  svg(): string;
  png(): Promise<Blob>;
  /// The item that keys move, if there is one, by how much along which axis this one moves it, and onto which sheet or
  /// into which container.
  keyed(e: KeyboardEvent): { item: number; by: Place; to: number } | null;
}

/// "17/3"
export const numberOf = (text: string | number): number => {
  const [a, b] = String(text).split("/");
  return Number(a) / Number(b ?? 1);
};

export const placeOf = (item: PackedItem): Place => item.at.map(numberOf);
export const holderOf = (item: PackedItem): number => item.sheet ?? item.container ?? 0;
export const nameOf = (item: PackedItem): string => `${item.part} ${item.copy}`;
export const sizeOf = (state: PackingState): number => state.length ?? state.height ?? 0;
export const hueOf = (problem: PackingProblem, part: string): number => (360 * problem.parts.findIndex((p) => p.name === part)) / problem.parts.length;

const kWays: Record<string, [number, number]> = { ArrowLeft: [0, -1], ArrowRight: [0, 1], ArrowDown: [1, -1], ArrowUp: [1, 1], PageDown: [2, -1], PageUp: [2, 1] };

/// The sheet or container, of so many, to which a key moves from one of them.
export const keyedHolder = (e: KeyboardEvent, from: number, count: number): number => (e.key === "[" ? Math.max(0, from - 1) : e.key === "]" ? Math.min(count - 1, from + 1) : from);

/// By how much a key moves along the axes; `unit`: units a pixel.
export function keyedMove(e: KeyboardEvent, dimension: number, unit: number): Place | null {
  const way = kWays[e.key];
  if (!way || way[0] >= dimension) return null;
  const step = (e.shiftKey ? 50 : e.altKey ? 1 : 5) * unit;
  return Array.from({ length: dimension }, (_, k) => (k === way[0] ? way[1] * step : 0));
}
