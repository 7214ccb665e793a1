// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The slider of the angle, with the angles at which the part can stand where it is, and that of the time, with the
// instants at which the formula holds there.
import type { Interval, Place, Summary } from "./engine";
import { make } from "./panel";
import { shown } from "./picture";
import type { Pose } from "./picture";

export class Poses {
  pose: Pose = { angle: 0, time: null };
  onPose: (pose: Pose) => void = () => {};
  onDone: () => void = () => {};
  private track: HTMLElement | null = null;
  private range: HTMLInputElement | null = null;
  private number: HTMLInputElement | null = null;
  private over: "angles" | "instants" = "angles";
  private from = 0;
  private to = 360;

  constructor(private readonly box: HTMLElement) {}

  /// What the slider goes over, if there is one: the method that says where the formula holds along it.
  get method(): "angles" | "instants" | null { return this.track && this.over; }

  show(summary: Summary): void {
    this.box.replaceChildren();
    this.pose = { angle: 0, time: null };
    this.track = this.range = this.number = null;
    if (summary.dimension === 3 || !summary.moving.length) return;
    const time = summary.motion;
    this.over = time ? "instants" : "angles";
    [this.from, this.to] = time ? [time.start, time.end] : [0, 360];
    const label = make("label", this.box, "", "pose");
    make("span", label, time ? "Time" : "Angle");
    const range = (this.range = make("input", label)), number = (this.number = make("input", label));
    const step = time ? (this.to - this.from) / 200 : 1;
    Object.assign(range, { type: "range", min: `${this.from}`, max: `${this.to}`, step: `${step}`, value: `${this.from}`, ariaLabel: time ? "Time of the motion" : "Angle in degrees" });
    Object.assign(number, { inputMode: "decimal", ariaLabel: time ? "Time of the motion, as a number" : "Angle in degrees, as a number" });
    number.value = time ? "" : "0";
    number.placeholder = time ? "all" : "";
    this.track = make("div", this.box, "", "track");
    const set = (text: string) => {
      const value = Number(text);
      if (text.trim() === "" && time) this.pose = { angle: 0, time: null };
      else if (!Number.isFinite(value)) return;
      else this.pose = time ? { angle: 0, time: Math.min(this.to, Math.max(this.from, value)) } : { angle: value, time: null };
      this.onPose(this.pose);
    };
    range.oninput = () => {
      number.value = range.value;
      set(range.value);
    };
    range.onchange = () => this.onDone();
    number.onchange = () => {
      range.value = number.value;
      set(number.value);
      this.onDone();
    };
    if (time) make("button", label, "All").onclick = () => {
      number.value = "";
      set("");
      this.onDone();
    };
  }

  /// To an angle, or an instant.
  set(value: number): void {
    if (!this.range) return;
    this.pose = this.over === "angles" ? { angle: value, time: null } : { angle: 0, time: value };
    this.range.value = this.number!.value = String(value);
  }

  /// Not known for where the part is now.
  forget(): void {
    if (!this.track) return;
    this.track.replaceChildren();
    this.track.title = "Point here to see where it holds";
  }

  /// Where on the slider the formula holds.
  showIntervals(intervals: Interval[], at: Place): void {
    if (!this.track) return;
    this.track.replaceChildren();
    this.track.title = `Where it holds at (${at.map(shown).join(", ")})`;
    const size = this.to - this.from, share = (v: number) => Math.min(1, Math.max(0, (v - this.from) / size)) * 100;
    const put = (from: number, to: number) => {
      const mark = make("i", this.track!);
      mark.style.left = `${share(from)}%`;
      mark.style.width = `max(3px, ${share(to) - share(from)}%)`;
    };
    for (const i of intervals) {
      const [from, to] = [i.from ?? this.from, i.to ?? this.to];
      put(from, Math.min(to, this.to));
      if (to > this.to && this.to === 360) put(0, to - 360);
    }
  }
}
