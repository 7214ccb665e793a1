// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The lists beside the picture: conditions with their values, what the explanation says, sliders.
import type { Atom, Between, Change, Explanation, Feature, Place, ShapeInfo } from "./engine";
import { numbersOf, withNumber } from "./formula";
import { shown } from "./picture";

export function make<K extends keyof HTMLElementTagNameMap>(name: K, parent: Element, text = "", style = ""): HTMLElementTagNameMap[K] {
  const made = document.createElement(name);
  made.textContent = text;
  if (style) made.className = style;
  parent.append(made);
  return made;
}

export const withUnit = (value: number, unit: string): string => (unit ? `${shown(value)} ${unit}` : shown(value));

const valueText = (value: number | string | null, unit: string): string =>
  value === null ? "undefined" : typeof value === "number" ? withUnit(value, unit) : value === "-inf" ? "−∞" : value;

/// What a value lies between, where its digits do not say it.
const endsText = (a: Atom): string => {
  if (a.exact !== false) return "";
  const [low, high] = [a.lower, a.upper].map((end) => (typeof end === "number" ? shown(end) : ""));
  return low === high ? "" : !high ? ` (at least ${low})` : !low ? ` (at most ${high})` : ` (from ${low} to ${high})`;
};

/// "off by at least 2 mm" where the value has one end only.
const lacksText = (a: Atom, lacks: number, unit: string): string => {
  const ends = [a.lower, a.upper].filter((end) => typeof end === "number").length;
  return `off by ${a.exact === false && ends === 1 ? "at least " : ""}${withUnit(lacks, unit)}`;
};

/// `picked`: the condition whose own set is shown.
export function showAtoms(list: Element, atoms: Atom[], unit: string, picked: string, pick: (text: string) => void): void {
  const focused = [...list.querySelectorAll("button")].indexOf(document.activeElement as HTMLButtonElement);
  list.replaceChildren();
  for (const a of atoms) {
    const row = make("li", list, "", a.true ? "yes" : "no");
    const button = make("button", row);
    make("code", button, a.text);
    button.title = "Show the set of this condition alone";
    button.ariaPressed = String(a.text === picked);
    button.onclick = () => pick(a.text === picked ? "" : a.text);
    make("span", row, valueText(a.value, unit) + endsText(a));
    if (!a.true) make("small", row, a.lacks === undefined ? "does not hold" : lacksText(a, a.lacks, unit));
  }
  if (focused >= 0) list.querySelectorAll("button")[focused]?.focus();
}

const changeWords = (c: Change, unit: string, slack: boolean): string => {
  if (c.refused) return `not computed: ${c.refused}`;
  if (c.to === null) return c.free ? "can be as tight as you like" : "no level of it alone makes room";
  if (c.by === 0) return slack ? "no slack" : "beyond its level, by as little as you like";
  const to = typeof c.to === "number" ? withUnit(c.to, unit) : c.to;
  const known = c.proven === false && c.lower !== undefined && c.upper !== undefined ? ` (it is between ${shown(c.lower)} and ${shown(c.upper)})` : "";
  return `${slack ? "slack" : "change by"} ${withUnit(c.by ?? 0, unit)}, to ${c.reached ? "" : slack ? "just before " : "just beyond "}${to}${known}`;
};

/// `pose`: to an angle, or an instant.
export interface WhyActions { go(at: Place): void; pose(value: number): void; replace(text: string, by: string): void; canReplace(text: string): boolean }

export function showWhy(box: Element, e: Explanation, unit: string, actions: WhyActions): void {
  box.replaceChildren();
  if (e.conflict) {
    make("p", box, e.conflict.length === 1 ? "This condition contradicts itself:" : "These conditions contradict each other:", "clash");
    const clash = make("ul", box);
    for (const text of e.conflict) make("code", make("li", clash, "", "clash"), text);
  }
  const slack = e.feasible, changes = (slack ? e.slack : e.relax) ?? [];
  if (changes.length) make("p", box, slack ? "How far each level can be tightened:" : "The least change of one level that makes room:");
  const list = make("ul", box);
  for (const c of changes) {
    const row = make("li", list);
    make("code", row, c.text);
    make("div", row, changeWords(c, unit, slack));
    const { at, becomes } = c, pose = c.angle ?? c.time;
    if (!slack && becomes && actions.canReplace(c.text)) make("button", row, "Change").onclick = () => actions.replace(c.text, becomes);
    if (at) make("button", row, slack ? "Last position" : "Position").onclick = () => actions.go(at);
    else if (pose !== undefined) make("button", row, c.time === undefined ? `${shown(pose)}°` : `Time ${shown(pose)}`).onclick = () => actions.pose(pose);
  }
  if (e.relax_all && e.relax_all.upper !== null)
    make("p", box, `All levels together: between ${shown(e.relax_all.lower)} and ${withUnit(e.relax_all.upper, unit)}.`);
}

const featureWords = (f: Feature): string => `${f.vertex ? "a corner" : f.arc ? "an arc" : "an edge"} of ${f.shape}`;

export function showBetween(box: Element, b: Between, unit: string): void {
  box.textContent = `${withUnit(b.distance, unit)} from ${featureWords(b.from)} to ${featureWords(b.to)}`;
}

/// Which shapes are shown, and which one moves.
export function showShapes(list: Element, shapes: ShapeInfo[], hidden: Set<string>, fixed: boolean, changed: () => void, move: (name: string) => void): void {
  list.replaceChildren();
  for (const s of shapes) {
    const row = make("li", list);
    make("span", row, s.name);
    const [seen, moves] = ["shown", "moves"].map((text) => {
      const label = make("label", row);
      const input = make("input", label);
      input.type = text === "shown" ? "checkbox" : "radio";
      label.append(" " + text);
      return input;
    }) as [HTMLInputElement, HTMLInputElement];
    seen.checked = !hidden.has(s.name);
    seen.disabled = s.moving;
    seen.ariaLabel = `${s.name} is shown`;
    seen.onchange = () => {
      if (seen.checked) hidden.delete(s.name);
      else hidden.add(s.name);
      changed();
    };
    moves.name = "moves";
    moves.checked = s.moving;
    moves.disabled = fixed;
    moves.ariaLabel = `${s.name} moves`;
    moves.onchange = () => move(s.name);
  }
}

/// A slider for each number; `moved` gets the whole formula.
export function showSliders(box: Element, formula: string, moved: (formula: string) => void, done: () => void): void {
  box.replaceChildren();
  for (const n of numbersOf(formula)) {
    const label = make("label", box);
    const around = formula.slice(Math.max(0, n.start - 26), n.start).replace(/^.*\b(?:and|or)\b/, "");
    make("span", label, around.trim());
    const range = make("input", label), number = make("input", label);
    Object.assign(range, { type: "range", min: `${n.low}`, max: `${n.high}`, step: `${n.step}`, value: `${n.value}`, ariaLabel: `${around} level` });
    Object.assign(number, { inputMode: "decimal", value: n.text, ariaLabel: `${around} level, as a number` });
    range.oninput = () => {
      number.value = range.value;
      moved(withNumber(formula, n, Number(range.value)));
    };
    range.onchange = done;
    number.onchange = () => {
      moved(formula.slice(0, n.start) + number.value.trim() + formula.slice(n.end));
      done();
    };
  }
}
