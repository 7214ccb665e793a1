// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The engine behind the page: requests of docs/protocol.md over HTTP, and the answers as types.

export type Point = [number, number];

export interface Drawing { faces: string; closed: string; open: string; free: string; points: Point[]; full: Point[]; hollow: Point[] }
export interface ShapeInfo { name: string; moving: boolean; used: boolean; drawing: Drawing }
export interface Summary { unit?: string; step: number; where: string; moving: string[]; shapes: ShapeInfo[] }
export interface RegionMap { empty: boolean; isolated: Point[]; components: { sample: Point }[]; drawing: Drawing }
export interface Atom { text: string; value: number | string | null; true: boolean; lacks?: number; witness: { points?: Point[] } }
export interface Nearest { at: Point; distance: number; attained: boolean }
export interface Check { at: Point; true: boolean; atoms: Atom[]; nearest_feasible?: Nearest }
export interface Change { text: string; to: number | string | null; by?: number; reached?: boolean; becomes?: string; at?: Point; free?: boolean; refused?: string }
export interface Explanation {
  feasible: boolean; conflict?: string[]; relax?: Change[]; slack?: Change[];
  relax_all?: { lower: number; upper: number | null; at?: Point };
}

/// What the engine says of a mistake; `line` and `column` of one in the formula.
export class Refusal extends Error {
  constructor(message: string, readonly line?: number, readonly column?: number) { super(message); }
}

const token = document.querySelector<HTMLMetaElement>("meta[name=findspace-token]")?.content ?? "";

export async function call<T>(method: string, params: object = {}): Promise<T> {
  const answer = await fetch("/rpc", {
    method: "POST", headers: { "Content-Type": "application/json", "X-Findspace-Token": token },
    body: JSON.stringify({ jsonrpc: "2.0", id: 1, method, params }),
  });
  if (!answer.ok) throw new Refusal(`the program answers ${answer.status}`);
  const { result, error } = await answer.json();
  if (error) throw new Refusal(error.message, error.data?.line, error.data?.column);
  return result as T;
}

/// The program ends when no page keeps such a connection.
export function stayOpen(lost: (gone: boolean) => void): void {
  const open = new EventSource(`/open?token=${encodeURIComponent(token)}`);
  open.onerror = () => lost(true);
  open.onopen = () => lost(false);
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
