// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The page that stands alone: one HTML file with the scene and its region in it, for mail and reports. It has no
// engine, so whether a position belongs is read off the picture.
import type { RegionMap, Summary } from "./engine";

export interface Alone { summary: Summary; map: RegionMap; at: [number, number] }

export function readAlone(): Alone | null {
  return JSON.parse(document.getElementById("data")?.textContent || "null") as Alone | null;
}

export function alonePage(data: Alone): string {
  const page = document.documentElement.cloneNode(true) as HTMLElement;
  page.querySelector("meta[name=findspace-token]")?.remove();
  page.querySelector("#data")!.textContent = JSON.stringify(data).replaceAll("<", "\\u003c");
  for (const list of page.querySelectorAll("#picture, #atoms, #sliders, #shapes, #why > div")) list.replaceChildren();
  for (const e of page.querySelectorAll("[nonce]")) e.removeAttribute("nonce");
  return "<!doctype html>\n" + page.outerHTML;
}

export function save(name: string, type: string, content: string): void {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([content], { type }));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}

/// The picture with the colours that it has now.
export function pictureSvg(svg: SVGSVGElement): string {
  const copy = svg.cloneNode(true) as SVGSVGElement;
  const shapes = svg.querySelectorAll("path, line, text"), copies = copy.querySelectorAll("path, line, text");
  shapes.forEach((shape, k) => {
    const style = getComputedStyle(shape);
    for (const key of ["fill", "fill-rule", "stroke", "stroke-width", "stroke-dasharray", "stroke-linecap", "vector-effect", "font-family", "text-anchor", "paint-order"])
      copies[k]!.setAttribute(key, style.getPropertyValue(key));
  });
  const { width, height } = svg.getBoundingClientRect();
  for (const [key, value] of Object.entries({ xmlns: "http://www.w3.org/2000/svg", width, height })) copy.setAttribute(key, `${value}`);
  copy.style.background = getComputedStyle(document.body).backgroundColor;
  return copy.outerHTML;
}
