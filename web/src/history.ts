// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What undo and redo go back to.
import type { Place } from "./engine";

export interface State { where: string; at: Place; moving: string[]; angle: number }

export class History {
  private back: State[] = [];
  private forth: State[] = [];
  private kept: State | null = null;

  constructor(private readonly undo: HTMLButtonElement, private readonly redo: HTMLButtonElement) {}

  /// The beginning.
  start(state: State): void {
    this.back = [];
    this.forth = [];
    this.kept = state;
    this.show();
  }

  /// After each act.
  keep(state: State): void {
    if (this.kept && JSON.stringify(state) !== JSON.stringify(this.kept)) {
      this.back.push(this.kept);
      this.forth = [];
    }
    this.kept = state;
    this.show();
  }

  /// The state to go to, if there is one.
  step(back: boolean): State | undefined {
    const [from, to] = back ? [this.back, this.forth] : [this.forth, this.back];
    const state = from.pop();
    if (state && this.kept) to.push(this.kept);
    if (state) this.kept = state;
    this.show();
    return state;
  }

  private show(): void { this.allow(this.back.length > 0, this.forth.length > 0); }

  /// For those that keep their steps themselves.
  allow(back: boolean, forth: boolean): void {
    this.undo.disabled = !back;
    this.redo.disabled = !forth;
  }
}
