// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What a picture of a scene can do, in the plane (stage.ts) and in space (space.ts).
import type { AnyDrawing, Atom, Place, Summary } from "./engine";

export interface Pose { angle: number; time: number | null }

/// A copy of a shape where a placement put it; `turns`: it has an angle of its own. `rotation`: rows of a matrix instead.
export interface Placed { shape: string; copy: number; at: Place; angle: number; turns: boolean; rotation?: number[][]; colour?: string }

export interface Picture {
  at: Place;
  /// The part is dragged to a place; a drag has ended; the picture was clicked at a place.
  onDrag: (at: Place) => void;
  onDragged: () => void;
  onPick: (at: Place) => void;
  /// Scene units per pixel.
  readonly unit: number;
  setScene(summary: Summary, hidden: Set<string>): void;
  /// `own`: the set of one condition, below the region.
  setRegion(drawing: AnyDrawing | null, own?: boolean): void;
  place(at: Place): void;
  setPose(pose: Pose): void;
  setGhost(at: Place | null): void;
  setAtoms(good: boolean, atoms: Atom[]): void;
  /// Shapes elsewhere than they are drawn: a placement.
  /// `names`: of all that are placed, also of those without a position, which are not drawn.
  setPlaced(placed: Placed[], picked: number, names: string[]): void;
  /// One of these is dragged to a place, or clicked.
  onMovePlaced: (k: number, at: Place) => void;
  onPickPlaced: (k: number) => void;
  fit(): void;
  zoom(by: number): void;
  /// By steps to the right and upwards: the plane is shifted, space is turned.
  shift(right: number, up: number): void;
  /// To a tenth of a pixel, as a short decimal.
  rounded(at: Place): Place;
  /// Colours have changed.
  recolour(): void;
  svg(): string;
  png(): Promise<Blob>;
}

/// Whenever the element has another size, until the signal comes.
export function onResize(element: Element, until: AbortSignal, act: () => void): void {
  const sizes = new ResizeObserver(act);
  sizes.observe(element);
  until.addEventListener("abort", () => sizes.disconnect());
}

/// Of the picture's size, for a key.
export const kShift = 0.1;

/// The nearest decimals that a picture of `unit` scene units a pixel tells apart.
export function shortDecimals(at: Place, unit: number): Place {
  const places = Math.min(12, Math.max(0, Math.ceil(-Math.log10(unit)) + 1));
  return at.map((x) => Number(x.toFixed(places)));
}

export const shown = (value: number): string => Number(value.toPrecision(6)).toString().replace("-", "−");

/// 1, 2 or 5 times a power of ten, no more than `most`.
export function roundLength(most: number): number {
  const power = 10 ** Math.floor(Math.log10(most));
  return [5, 2, 1].map((k) => k * power).find((l) => l <= most) ?? power;
}

/// Where a shape is along its movement: linear between way points.
export function along<T>(times: number[], values: T[], time: number, mix: (a: T, b: T, part: number) => T): T {
  if (time <= times[0]!) return values[0]!;
  for (let k = 1; k < times.length; ++k) {
    if (time > times[k]!) continue;
    return mix(values[k - 1]!, values[k]!, (time - times[k - 1]!) / (times[k]! - times[k - 1]!));
  }
  return values[values.length - 1]!;
}
