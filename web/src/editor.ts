// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The formula's text: a mistake underlined at its place, and words offered for what is being typed.
import type { Refusal } from "./engine";
import { make } from "./panel";

const kMostOffered = 8;

export class Editor {
  /// What formulas are written with: names of shapes, of distances, of predicates.
  words: string[] = [];
  onText: (formula: string) => void = () => {};
  onDone: () => void = () => {};
  private chosen = 0;

  constructor(private readonly box: HTMLTextAreaElement, private readonly marks: HTMLElement, private readonly mistake: HTMLElement, private readonly list: HTMLElement) {
    box.addEventListener("input", () => {
      this.offer();
      this.onText(box.value);
    });
    box.addEventListener("change", () => this.onDone());
    box.addEventListener("blur", () => setTimeout(() => this.close(), 150));
    box.addEventListener("keydown", (e) => this.onKey(e));
    box.addEventListener("scroll", () => { marks.scrollTop = box.scrollTop; });
  }

  get text(): string { return this.box.value; }
  set text(formula: string) { if (this.box.value !== formula) this.box.value = formula; }

  show(e: Refusal | null): void {
    this.mistake.textContent = e?.message.split("\n")[0] ?? "";
    this.box.setAttribute("aria-invalid", String(!!e));
    this.marks.replaceChildren();
    if (!e?.line || !e.column) return;
    const lines = this.text.split("\n");
    const start = lines.slice(0, e.line - 1).join("\n").length + (e.line > 1 ? 1 : 0) + e.column - 1;
    const length = Math.max(1, /^[\w.]*/.exec(this.text.slice(start))![0].length);
    this.marks.append(this.text.slice(0, start));
    make("mark", this.marks, this.text.slice(start, start + length) || " ");
    this.marks.append(this.text.slice(start + length));
  }

  private typed(): string { return /[\p{L}_][\p{L}\w.]*$/u.exec(this.text.slice(0, this.box.selectionStart))?.[0] ?? ""; }

  private offer(): void {
    const begun = this.typed().toLowerCase();
    const fits = begun ? this.words.filter((w) => w.toLowerCase().startsWith(begun) && w.toLowerCase() !== begun).slice(0, kMostOffered) : [];
    this.list.replaceChildren();
    this.chosen = 0;
    fits.forEach((word, k) => {
      const row = make("li", this.list, word);
      row.id = `word-${k}`;
      row.role = "option";
      row.onpointerdown = (e) => {
        e.preventDefault();
        this.take(word);
      };
    });
    this.list.hidden = !fits.length;
    this.box.setAttribute("aria-expanded", String(fits.length > 0));
    this.mark();
  }

  private mark(): void {
    [...this.list.children].forEach((row, k) => row.setAttribute("aria-selected", String(k === this.chosen)));
    if (this.list.hidden) this.box.removeAttribute("aria-activedescendant");
    else this.box.setAttribute("aria-activedescendant", `word-${this.chosen}`);
  }

  private close(): void {
    this.list.hidden = true;
    this.box.setAttribute("aria-expanded", "false");
    this.mark();
  }

  private take(word: string): void {
    const end = this.box.selectionStart, start = end - this.typed().length;
    this.box.setRangeText(/^[A-Za-z_]\w*$/.test(word) ? word : `"${word}"`, start, end, "end");
    this.close();
    this.onText(this.text);
  }

  private onKey(e: KeyboardEvent): void {
    if (this.list.hidden) return;
    const count = this.list.children.length;
    const acts: Record<string, () => void> = {
      ArrowDown: () => { this.chosen = (this.chosen + 1) % count; },
      ArrowUp: () => { this.chosen = (this.chosen + count - 1) % count; },
      Enter: () => this.take(this.list.children[this.chosen]!.textContent!),
      Tab: () => this.take(this.list.children[this.chosen]!.textContent!),
      Escape: () => this.close(),
    };
    const act = acts[e.key];
    if (!act) return;
    e.preventDefault();
    act();
    this.mark();
  }
}
