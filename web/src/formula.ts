// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The numbers of a formula, each a slider.

export interface FormulaNumber { start: number; end: number; text: string; value: number; low: number; high: number; step: number }

/// A number that is no part of a name, with a sign that belongs to it.
const kNumber = /(?<![\w.γδημ])(?<sign>(?<=[(,=<>]\s*)-)?\d+(?:\.\d+)?/gu;

export function numbersOf(formula: string): FormulaNumber[] {
  return [...formula.matchAll(kNumber)].map((m) => {
    const value = Number(m[0]), size = Math.max(Math.abs(value), 1);
    const step = 10 ** (Math.floor(Math.log10(size)) - 2);
    const low = value < 0 ? -4 * size : value === 0 ? -10 : 0;
    return { start: m.index, end: m.index + m[0].length, text: m[0], value, low, high: value === 0 ? 10 : value < 0 ? 0 : 4 * size, step };
  });
}

/// The formula with another number there.
export function withNumber(formula: string, n: FormulaNumber, value: number): string {
  const places = Math.max(0, -Math.round(Math.log10(n.step)));
  return formula.slice(0, n.start) + String(Number(value.toFixed(places))) + formula.slice(n.end);
}
