// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// Forms of the picture of space: surfaces of convex faces, an arrow, a dot.
import { BufferGeometry, CanvasTexture, Float32BufferAttribute, Vector3 } from "three";
import type { Corner, SpaceDrawing } from "./engine";

/// Convex faces, each cut about its first corner.
export function surface(vertices: Corner[], faces: number[][]): BufferGeometry {
  const at: number[] = [];
  for (const f of faces) for (let k = 2; k < f.length; ++k) at.push(...vertices[f[0]!]!, ...vertices[f[k - 1]!]!, ...vertices[f[k]!]!);
  const made = new BufferGeometry();
  made.setAttribute("position", new Float32BufferAttribute(at, 3));
  made.computeVertexNormals();
  return made;
}

let dotMade: CanvasTexture | null = null;

/// A round dot.
export function dot(): CanvasTexture {
  if (dotMade) return dotMade;
  const canvas = document.createElement("canvas");
  canvas.width = canvas.height = 32;
  const context = canvas.getContext("2d")!;
  context.fillStyle = "#fff";
  context.arc(16, 16, 15, 0, 7);
  context.fill();
  return (dotMade = new CanvasTexture(canvas));
}

export const ofSheets = (sheets: Corner[][]): BufferGeometry => {
  const vertices = sheets.flat();
  let from = 0;
  return surface(vertices, sheets.map((s) => s.map(() => from++)));
};

/// About the z axis, by degrees.
export function aboutZ(degrees: number): number[][] {
  const [c, s] = [Math.cos((degrees * Math.PI) / 180), Math.sin((degrees * Math.PI) / 180)];
  return [[c, -s, 0], [s, c, 0], [0, 0, 1]];
}

/// By the rows of a matrix.
export function rotated(d: SpaceDrawing, rows: number[][]): SpaceDrawing {
  const turn = (p: Corner): Corner => rows.map((row) => row[0]! * p[0] + row[1]! * p[1] + row[2]! * p[2]) as Corner;
  return { vertices: d.vertices.map(turn), faces: d.faces, sheets: d.sheets.map((f) => f.map(turn)), curves: d.curves.map((l) => l.map(turn)), points: d.points.map(turn) };
}

/// A shaft and a tip along an axis, one long.
export function arrowGeometry(axis: Vector3): BufferGeometry {
  const [u, v] = [new Vector3(axis.y, axis.z, axis.x), new Vector3(axis.z, axis.x, axis.y)];
  const ring = (along: number, radius: number): Vector3[] =>
    [...Array(8).keys()].map((k) => axis.clone().multiplyScalar(along).add(u.clone().multiplyScalar(radius * Math.cos((k * Math.PI) / 4))).add(v.clone().multiplyScalar(radius * Math.sin((k * Math.PI) / 4))));
  const rings = [ring(0, 0.025), ring(0.78, 0.025), ring(0.78, 0.085), ring(1, 0)];
  const at: number[] = [];
  for (let r = 1; r < rings.length; ++r)
    for (let k = 0; k < 8; ++k) {
      const [a, b, c, d] = [rings[r - 1]![k]!, rings[r - 1]![(k + 1) % 8]!, rings[r]![k]!, rings[r]![(k + 1) % 8]!];
      for (const p of [a, b, d, a, d, c]) at.push(p.x, p.y, p.z);
    }
  const made = new BufferGeometry();
  made.setAttribute("position", new Float32BufferAttribute(at, 3));
  return made;
}
