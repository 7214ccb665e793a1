// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// What is shown of the answer: the region or what an operation makes of it; in space a plane that cuts it open.
import { make } from "./panel";
import { shown } from "./picture";

const kOperations = ["", "interior", "closure", "boundary", "regularize", "complement"];

function choice(box: HTMLElement, label: string, texts: string[], chosen: (k: number) => void): HTMLSelectElement {
  const row = make("label", box, "", "choice");
  make("span", row, label);
  const select = make("select", row);
  texts.forEach((text, k) => { make("option", select, text).value = String(k); });
  select.onchange = () => chosen(Number(select.value));
  return select;
}

export function showOperations(box: HTMLElement, apply: (operation: string) => void): HTMLSelectElement {
  const select = choice(box, "Region", ["as it is", "its interior", "its closure", "its boundary", "regularized", "its complement"], (k) => apply(kOperations[k]!));
  select.id = "operation";
  return select;
}

export interface Cuts { setSection(axis: number | null, at: number): void; range(axis: number): [number, number] }

export function showSection(box: HTMLElement, cuts: Cuts, unit: string): void {
  const select = choice(box, "Section", ["none", "across x", "across y", "across z"], (k) => {
    range.hidden = k === 0;
    if (k === 0) return cuts.setSection(null, 0);
    const [low, high] = cuts.range(k - 1);
    Object.assign(range, { min: `${low}`, max: `${high}`, step: `${(high - low) / 400}`, value: `${low + 0.55 * (high - low)}` });
    cut();
  });
  select.id = "section";
  const range = make("input", box), value = make("output", box);
  Object.assign(range, { type: "range", id: "section-at", ariaLabel: "Where the section is" });
  range.hidden = true;
  const cut = () => {
    value.textContent = `${shown(Number(range.value))} ${unit}`;
    cuts.setSection(Number(select.value) - 1, Number(range.value));
  };
  range.oninput = cut;
}
