// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// A plane that cuts the picture of space open: what lies between it and the eye is not drawn, and solids that it cuts
// are closed by caps with their outline. A cap is drawn where more back faces than front faces lie behind the plane:
// these are counted in the stencil buffer, for one solid after the other.
import {
  AlwaysStencilFunc, BackSide, BufferGeometry, Camera, Color, DecrementWrapStencilOp, DoubleSide, FrontSide, Group, IncrementWrapStencilOp, Mesh,
  MeshBasicMaterial, NotEqualStencilFunc, Object3D, Plane, PlaneGeometry, ReplaceStencilOp, Side, StencilOp, Vector3,
} from "three";
import { LineMaterial } from "three/examples/jsm/lines/LineMaterial.js";
import { LineSegments2 } from "three/examples/jsm/lines/LineSegments2.js";
import { LineSegmentsGeometry } from "three/examples/jsm/lines/LineSegmentsGeometry.js";
import type { Corner, SpaceDrawing } from "./engine";
import { surface } from "./forms";

/// Nothing to fill: the outline alone, as of a container.
export interface CapStyle { fill: Color | null; opacity: number; line: Color }

interface Cut { solid: SpaceDrawing; moves: Object3D; line: Color; outline: LineSegments2 | null }

/// Where a plane across an axis cuts convex faces: the ends of segments.
export function cutFaces({ vertices, faces }: SpaceDrawing, axis: number, at: number): number[] {
  const out: number[] = [];
  for (const face of faces) {
    const ends: Corner[] = [];
    face.forEach((v, k) => {
      const a = vertices[v]!, b = vertices[face[(k + 1) % face.length]!]!, [h, g] = [a[axis]! - at, b[axis]! - at];
      if (h < 0 === g < 0) return;
      const t = h / (h - g);
      ends.push([0, 1, 2].map((i) => a[i]! + t * (b[i]! - a[i]!)) as Corner);
    });
    if (ends.length === 2) out.push(...ends[0]!, ...ends[1]!);
  }
  return out;
}

export class Section {
  readonly group = new Group();
  /// What materials are clipped by.
  readonly planes: Plane[] = [];
  private readonly plane = new Plane();
  private axis: number | null = null;
  private at = 0;
  private cuts: Cut[] = [];
  private order = 0;

  get cutting(): boolean { return this.axis !== null; }

  set(axis: number | null, at: number): void {
    this.axis = axis;
    this.at = at;
    this.planes.length = 0;
    if (axis !== null) this.planes.push(this.plane);
  }

  clear(): void {
    this.group.clear();
    this.cuts = [];
    this.order = 0;
  }

  /// Away from the eye.
  face(eye: Camera): void {
    if (this.axis === null) return;
    const beyond = eye.position.getComponent(this.axis) > this.at;
    this.plane.normal.set(0, 0, 0).setComponent(this.axis, beyond ? -1 : 1);
    this.plane.constant = beyond ? this.at : -this.at;
  }

  /// Closes a solid that is drawn in `moves`; the plane is drawn `size` wide about a point.
  add(solid: SpaceDrawing, moves: Object3D, style: CapStyle, about: Vector3, size: number): void {
    if (this.axis === null || !solid.faces.length) return;
    this.cuts.push({ solid, moves, line: style.line, outline: null });
    if (!style.fill) return;
    const geometry = surface(solid.vertices, solid.faces), order = (this.order += 1);
    for (const [side, op] of [[BackSide, IncrementWrapStencilOp], [FrontSide, DecrementWrapStencilOp]] as [Side, StencilOp][]) {
      const counted = new Mesh(geometry, new MeshBasicMaterial({
        side, depthWrite: false, depthTest: false, colorWrite: false, transparent: true, clippingPlanes: this.planes,
        stencilWrite: true, stencilFunc: AlwaysStencilFunc, stencilFail: op, stencilZFail: op, stencilZPass: op,
      }));
      counted.renderOrder = order;
      moves.add(counted);
    }
    const cap = new Mesh(new PlaneGeometry(size, size) as BufferGeometry, new MeshBasicMaterial({
      color: style.fill, transparent: true, opacity: style.opacity, side: DoubleSide, stencilWrite: true, stencilRef: 0,
      stencilFunc: NotEqualStencilFunc, stencilFail: ReplaceStencilOp, stencilZFail: ReplaceStencilOp, stencilZPass: ReplaceStencilOp,
    }));
    cap.lookAt(new Vector3().setComponent(this.axis, 1));
    cap.position.copy(about).setComponent(this.axis, this.at);
    cap.renderOrder = order + 0.5;
    cap.onAfterRender = (renderer) => renderer.clearStencil();
    this.group.add(cap);
  }

  /// The outlines where the solids are now.
  outline(): void {
    if (this.axis === null) return;
    for (const cut of this.cuts) {
      if (cut.outline) this.group.remove(cut.outline);
      cut.outline?.geometry.dispose();
      cut.outline = null;
      const ends = cut.moves.visible ? cutFaces(cut.solid, this.axis, this.at - cut.moves.position.getComponent(this.axis)) : [];
      if (!ends.length) continue;
      cut.outline = new LineSegments2(new LineSegmentsGeometry().setPositions(ends), new LineMaterial({ color: cut.line, linewidth: 2 }));
      cut.outline.position.copy(cut.moves.position);
      cut.outline.renderOrder = 1000;
      this.group.add(cut.outline);
    }
  }
}
