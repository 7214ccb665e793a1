// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The page that stands alone: one HTML file with the scene and its region in it, or with a layout, for mail and reports.
// It has no engine, so whether a position belongs is read off the picture.
import type { Drawing, PackingProblem, PackingState, Place, RegionMap, Summary } from "./engine";
import { shown } from "./picture";
import type { Stage } from "./stage";

export interface Alone { summary: Summary; map: RegionMap; at: Place }
export interface AlonePacking { problem: PackingProblem; state: PackingState }
interface Data { scene?: Alone; packing?: AlonePacking }

export function readAlone(): Data {
  return JSON.parse(document.getElementById("data")?.textContent || "null") ?? {};
}

/// `space`: the script that draws space, where the scene needs it.
export function alonePage(data: Data, space: string): string {
  const page = document.documentElement.cloneNode(true) as HTMLElement;
  page.querySelector("meta[name=findspace-token]")?.remove();
  page.querySelector("#data")!.textContent = JSON.stringify(data).replaceAll("<", "\\u003c");
  page.querySelector("#space-program")!.textContent = space.replaceAll("</script", "<\\/script");
  for (const list of page.querySelectorAll("#picture, #picture-over, #labels, #atoms, #sliders, #shapes, #poses, #views, #words, #why > div, #packing > div")) list.replaceChildren();
  page.querySelector("#placed")?.remove();
  for (const e of page.querySelectorAll("[nonce]")) e.removeAttribute("nonce");
  for (const e of page.querySelectorAll("script:not([id])")) e.remove();
  return "<!doctype html>\n" + page.outerHTML;
}

export function save(name: string, content: Blob): void {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(content);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}

/// Whether a position belongs, as far as the picture tells: to the pixel.
export function drawnAt(stage: Stage, map: RegionMap, y: "up" | "down"): (at: Place) => boolean {
  return (at) => {
    const [a, b] = at as [number, number];
    const p = new DOMPoint(a, y === "down" ? b : -b), near = 3 * stage.unit;
    return [...document.querySelectorAll<SVGGeometryElement>("#layer-region .face")].some((f) => f.isPointInFill(p)) ||
      [...document.querySelectorAll<SVGGeometryElement>("#layer-region .free, #layer-region .closed")].some((f) => f.isPointInStroke(p)) ||
      (map.drawing as Drawing).points.some((q) => Math.hypot(q[0] - p.x, q[1] - p.y) < near);
  };
}

export const placeText = (at: Place): string => `(${at.map(shown).join(", ")})`;
