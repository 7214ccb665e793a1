// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The engine behind the page: requests of docs/protocol.md over HTTP, and the answers as types.

/// A position: as many numbers as the scene has dimensions.
export type Place = number[];
export type Point = [number, number];
export type Corner = [number, number, number];

/// Path data with y down.
export interface Drawing { faces: string; closed: string; open: string; free: string; points: Point[]; full: Point[]; hollow: Point[] }
export interface SpaceDrawing { vertices: Corner[]; faces: number[][]; sheets: Corner[][]; curves: Corner[][]; points: Corner[] }
export type AnyDrawing = Drawing | SpaceDrawing;
/// `holder`: what others lie in.
export interface ShapeInfo { name: string; moving: boolean; used: boolean; drawing?: AnyDrawing; holder?: boolean }
export interface Movement { shape: string; path: Point[]; times: number[]; angles: number[] }
export interface Summary {
  dimension: 2 | 3; unit?: string; step: number; y: "up" | "down"; clockwise?: boolean; where: string; moving: string[]; shapes: ShapeInfo[]; words: string[];
  free: "position" | "line" | "angle" | "time" | "pose"; about?: Point; angles?: number[]; place: boolean;
  motion?: { start: number; end: number; movements: Movement[] };
}
export interface RegionMap {
  empty?: boolean; sample?: Place | null; isolated?: Place[]; components?: { sample: Place }[]; drawing: AnyDrawing; outer_drawing?: Drawing;
  intervals?: Interval[]; on_lines?: string;
}
export interface Interval { from: number | null; to: number | null; from_in: boolean; to_in: boolean }
export interface Atom { text: string; value: number | string | null; exact?: boolean; lower?: number | string | null; upper?: number | string | null; true: boolean; lacks?: number; witness: { points?: Place[] } }
export interface Nearest { at: Place; distance: number; attained: boolean }
export interface Check { at: Place; true: boolean; atoms: Atom[]; nearest_feasible?: Nearest }
export interface Change { text: string; to: number | string | null; by?: number; reached?: boolean; becomes?: string; at?: Place; angle?: number; time?: number; free?: boolean; refused?: string; proven?: boolean; lower?: number; upper?: number }
export interface Explanation {
  feasible: boolean; conflict?: string[]; relax?: Change[]; slack?: Change[];
  relax_all?: { lower: number; upper: number | null; at?: Place };
}
export interface Feature { shape: string; vertex?: Point; edge?: [Point, Point]; arc?: { center: Point; radius: number } }
export interface Between { from: Feature; to: Feature; distance: number; points?: [Point, Point] }
export interface Placement { positions: { shape: string; at: Place | null; angle?: number; copy?: number }[]; proven: boolean; reason?: string }
export interface PackedPart { name: string; demand: number; drawing: string | SpaceDrawing }
/// `drawing`, `zones`: path data about the lower left corner.
export interface PackingSheet { name: string; count: number; drawing: string; zones: string }
/// `height`: of a strip; `floor` or `containers`: of solids.
export interface PackingProblem {
  name: string; dimension: 2 | 3; height?: number; box?: boolean; sheets?: PackingSheet[]; floor?: Point; containers?: { name: string; size: Corner; drawing: SpaceDrawing }[]; lower_bound: number; items: number;
  parts: PackedPart[];
}
/// `angle`, `mirrored`, `sheet`: of the plane; `rotation`, `container`: of space.
export interface PackedItem { part: string; copy: number; angle?: number | string; mirrored?: boolean; rotation?: (number | string)[][]; sheet?: number; container?: number; at: string[] }
/// `length`: of a strip or box, of the last sheet what is used; `height`: of solids.
export interface PackingState {
  running: boolean; number: number; seconds: number; length?: number; height?: number; density: number; failure?: string;
  layout?: {
    items: PackedItem[]; left_out?: { part: string; copies: number; why: string }[]; lower_bound?: string; proven: boolean;
    container?: { box?: string; sheets?: string[]; containers?: string[] };
  };
}
export interface Verdict { verdict: { feasible: boolean; faults: { of: string[]; text: string }[] } }

/// What the engine says of a mistake; `line` and `column` of one in the formula.
export class Refusal extends Error {
  constructor(message: string, readonly line?: number, readonly column?: number) { super(message); }
}

const token = document.querySelector<HTMLMetaElement>("meta[name=findspace-token]")?.content ?? "";
const headers = { "Content-Type": "application/json", "X-Findspace-Token": token };

/// This page's own copy of the scene: several pages do not disturb each other.
export const kOwn = `page-${Math.random().toString(36).slice(2)}`;

export async function call<T>(method: string, params: object = {}): Promise<T> {
  const answer = await fetch("/rpc", { method: "POST", headers, body: JSON.stringify({ jsonrpc: "2.0", id: 1, method, params: { scene: kOwn, ...params } }) });
  if (!answer.ok) throw new Refusal(`the program answers ${answer.status}`);
  const { result, error } = await answer.json();
  if (error) throw new Refusal(error.message, error.data?.line, error.data?.column);
  return result as T;
}

/// The part of the page that draws space, which pages of the plane do without.
export async function spaceScript(): Promise<string> {
  const answer = await fetch("/space.js", { headers });
  if (!answer.ok) throw new Refusal("the program has no page for space");
  return answer.text();
}

/// The program ends when no page keeps such a connection.
export function stayOpen(lost: (gone: boolean) => void): void {
  const open = new EventSource(`/open?token=${encodeURIComponent(token)}`);
  open.onerror = () => lost(true);
  open.onopen = () => lost(false);
  addEventListener("pagehide", () => {
    void fetch("/rpc", { method: "POST", headers, keepalive: true, body: JSON.stringify({ jsonrpc: "2.0", id: 1, method: "unload", params: { scene: kOwn } }) });
  });
}

/// Runs the last of what is asked while another run goes on, and drops those between.
export function latest<A extends unknown[]>(run: (...args: A) => Promise<void>): (...args: A) => Promise<void> {
  let going: Promise<void> | null = null, next: A | null = null;
  return async (...args: A) => {
    next = args;
    while (going) await going.catch(() => {});
    if (next !== args) return;
    next = null;
    going = run(...args).finally(() => { going = null; });
    await going;
  };
}
