// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Elements of SVG, and pictures to take away: as text that needs no style sheet, and as pixels.
const kSvg = "http://www.w3.org/2000/svg", kDrawn = "path, line, text, rect";
const kKept = ["display", "fill", "fill-rule", "fill-opacity", "stroke", "stroke-width", "stroke-dasharray", "stroke-linecap", "vector-effect", "font-family", "text-anchor", "paint-order"];

export function element(name: string, attributes: Record<string, string>, parent?: Element): SVGElement {
  const made = document.createElementNS(kSvg, name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  parent?.append(made);
  return made;
}

/// Elements that lie above each other in one place, as one.
export function pictureText(all: SVGSVGElement[]): string {
  const first = all[0]!, copy = first.cloneNode(true) as SVGSVGElement;
  for (const other of all.slice(1)) for (const g of other.children) copy.append(g.cloneNode(true));
  const copies = copy.querySelectorAll(kDrawn);
  all.flatMap((e) => [...e.querySelectorAll(kDrawn)]).forEach((shape, k) => {
    const style = getComputedStyle(shape);
    for (const key of kKept) copies[k]!.setAttribute(key, style.getPropertyValue(key));
  });
  const { width, height } = first.getBoundingClientRect();
  for (const [key, value] of Object.entries({ xmlns: kSvg, width, height })) copy.setAttribute(key, `${value}`);
  copy.style.background = getComputedStyle(document.body).backgroundColor;
  return copy.outerHTML;
}

/// As large as the element, in pixels.
export async function pictureOf(text: string, of: Element): Promise<Blob> {
  const { width, height } = of.getBoundingClientRect(), sharp = Math.max(2, devicePixelRatio);
  const image = new Image();
  image.src = "data:image/svg+xml;charset=utf-8," + encodeURIComponent(text);
  await image.decode();
  const canvas = document.createElement("canvas");
  canvas.width = width * sharp;
  canvas.height = height * sharp;
  const context = canvas.getContext("2d")!;
  context.fillStyle = getComputedStyle(document.body).backgroundColor;
  context.fillRect(0, 0, canvas.width, canvas.height);
  context.drawImage(image, 0, 0, canvas.width, canvas.height);
  return new Promise((done, fail) => canvas.toBlob((b) => (b ? done(b) : fail(new Error("no picture"))), "image/png"));
}
