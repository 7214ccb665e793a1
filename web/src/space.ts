// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: findspace contributors
//
// The picture of space, by three.js: shapes, the region as surfaces, sheets, curves and points, the moving solid with a
// handle along each axis, dimension lines, a section (section.ts). A script of its own (space.js): pages of the plane
// do without it.
import {
  AmbientLight, BackSide, Box3, BufferGeometry, Color, DirectionalLight, DoubleSide, EdgesGeometry, Float32BufferAttribute, Group, LineBasicMaterial,
  LineSegments, Material, Mesh, MeshBasicMaterial, MeshLambertMaterial, Object3D, PerspectiveCamera, Plane, Points, PointsMaterial, Raycaster, Scene,
  Side, Vector2, Vector3, WebGLRenderer,
} from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import { LineMaterial } from "three/examples/jsm/lines/LineMaterial.js";
import { LineSegments2 } from "three/examples/jsm/lines/LineSegments2.js";
import { LineSegmentsGeometry } from "three/examples/jsm/lines/LineSegmentsGeometry.js";
import type { AnyDrawing, Atom, Corner, Place, SpaceDrawing, Summary } from "./engine";
import { aboutZ, arrowGeometry, dot, ofSheets, rotated, surface } from "./forms";
import { Section } from "./section";
import { onResize, roundLength, shortDecimals, shown } from "./picture";
import type { Picture, Placed, Pose } from "./picture";

const kAxes = [new Vector3(1, 0, 0), new Vector3(0, 1, 0), new Vector3(0, 0, 1)];
const kClickPixels = 4, kTurn = Math.PI / 12;
const kAxisColours = ["#d0453a", "#2f8f4e", "#3a6fd0"];

/// One of the page's colours by its name, or any other.
const colour = (name: string): Color =>
  new Color(name.startsWith("--") ? getComputedStyle(document.documentElement).getPropertyValue(name).trim().slice(0, 7) : name);

/// Nothing is left in it, nor in the memory of the graphics.
function empty(group: Object3D): void {
  group.traverse((o) => {
    const { geometry, material } = o as Partial<Mesh>;
    geometry?.dispose();
    for (const m of material ? [material].flat() : []) m.dispose();
  });
  group.clear();
}

/// `cap`: how dense the faces are where a plane cuts the solid open; none: it is no solid to look at.
interface Style { fill: string; opacity: number; edges: string; side?: Side; cap?: number }

export class SpaceStage implements Picture {
  private readonly renderer: WebGLRenderer;
  private readonly scene = new Scene();
  private readonly camera = new PerspectiveCamera(35, 1, 0.01, 1e6);
  private readonly controls: OrbitControls;
  private readonly fixed = new Group();
  private readonly region = new Group();
  private readonly own = new Group();
  private readonly part = new Group();
  private readonly ghost = new Group();
  private readonly marks = new Group();
  private readonly handles: Mesh[] = [];
  private readonly labels: { e: HTMLElement; at: Vector3 }[] = [];
  private readonly section = new Section();
  private summary: Summary | null = null;
  private hidden = new Set<string>();
  private drawings: { region: SpaceDrawing | null; own: SpaceDrawing | null } = { region: null, own: null };
  private good = true;
  private atoms: Atom[] = [];
  private size = 1;
  private dirty = false;
  at: Place = [0, 0, 0];
  onDrag: (at: Place) => void = () => {};
  onDragged: () => void = () => {};
  onPick: (at: Place) => void = () => {};
  onMovePlaced: (k: number, at: Place) => void = () => {};
  onPickPlaced: (k: number) => void = () => {};
  onDragPlaced: (k: number, at: Place) => void = () => {};
  /// Whether what is not chosen turns with the rest when it is dragged: a click chooses it.
  turnsAll = false;
  private placed: { all: Placed[]; groups: Group[]; picked: number; names: string[] } = { all: [], groups: [], picked: -1, names: [] };

  /// `until`: as of the picture of the plane (stage.ts).
  constructor(private readonly canvas: HTMLCanvasElement, private readonly overlay: HTMLElement, private readonly bar: HTMLElement, private readonly unitName: string, private readonly until: AbortSignal) {
    this.renderer = new WebGLRenderer({ canvas, antialias: true, alpha: true, stencil: true });
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    this.renderer.localClippingEnabled = true;
    this.camera.up.set(0, 0, 1);
    this.scene.add(new AmbientLight(0xffffff, 1.6), this.fixed, this.region, this.own, this.part, this.ghost, this.marks, this.section.group, this.camera);
    const lamp = new DirectionalLight(0xffffff, 2);
    lamp.position.set(0.4, 0.8, 1);
    this.camera.add(lamp);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.addEventListener("change", () => this.draw());
    this.follow();
    onResize(canvas.parentElement!, until, () => this.resize());
    until.addEventListener("abort", () => this.end());
    this.resize();
  }

  private end(): void {
    this.controls.dispose();
    empty(this.scene);
    this.renderer.dispose();
  }

  get unit(): number {
    const far = this.camera.position.distanceTo(this.controls.target);
    return (2 * far * Math.tan((this.camera.fov * Math.PI) / 360)) / Math.max(1, this.canvas.clientHeight);
  }

  private resize(): void {
    const { clientWidth: w, clientHeight: h } = this.canvas.parentElement!;
    if (!w || !h) return;
    this.renderer.setSize(w, h, false);
    this.camera.aspect = w / h;
    this.camera.updateProjectionMatrix();
    this.draw();
  }

  private draw(): void {
    if (this.dirty) return;
    this.dirty = true;
    requestAnimationFrame(() => this.render());
  }

  private render(): void {
    this.dirty = false;
    if (this.until.aborted) return;
    const length = 70 * this.unit;
    for (const handle of this.handles) handle.parent!.scale.setScalar(length);
    this.section.face(this.camera);
    this.renderer.render(this.scene, this.camera);
    this.drawBar();
    const { clientWidth: w, clientHeight: h } = this.canvas;
    for (const { e, at } of this.labels) {
      const p = at.clone().project(this.camera);
      e.style.transform = `translate(${((p.x + 1) * w) / 2}px, ${((1 - p.y) * h) / 2}px) translate(-50%, -130%)`;
      e.style.visibility = p.z < 1 ? "" : "hidden";
    }
  }

  /// As long as it is at the middle of the scene.
  private drawBar(): void {
    const length = roundLength(140 * this.unit);
    this.bar.style.width = `${length / this.unit}px`;
    this.bar.firstElementChild!.textContent = `${shown(length)} ${this.unitName}`;
  }

  private material<T extends Material>(made: T): T {
    made.clippingPlanes = this.section.planes;
    return made;
  }

  /// Faces, edges and all below them, in one style.
  private show(into: Object3D, d: SpaceDrawing, style: Style): void {
    const fill = colour(style.fill), edge = colour(style.edges);
    const add = (geometry: BufferGeometry, opacity: number, side: Side) => {
      const clear = opacity < 1;
      const mesh = new Mesh(geometry, this.material(new MeshLambertMaterial({ color: fill, transparent: clear, opacity, depthWrite: !clear, side, flatShading: true, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 })));
      into.add(mesh);
      if (geometry.attributes["position"]!.count > 60000) return;
      into.add(new LineSegments(new EdgesGeometry(geometry, 25), this.material(new LineBasicMaterial({ color: edge, transparent: clear, opacity: clear ? 0.85 : 1 }))));
    };
    if (d.faces.length) add(surface(d.vertices, d.faces), style.opacity, style.side ?? DoubleSide);
    if (this.section.cutting) this.section.add(d, into, { fill: style.cap ? fill : null, opacity: style.cap ?? 0, line: edge }, this.bounds().getCenter(new Vector3()), 4 * this.size);
    if (d.sheets.length) add(ofSheets(d.sheets), Math.min(1, style.opacity + 0.25), DoubleSide);
    if (d.curves.length) {
      const lines = new LineSegmentsGeometry();
      lines.setPositions(d.curves.flatMap((c) => [...c[0]!, ...c[1]!]));
      into.add(new LineSegments2(lines, this.material(new LineMaterial({ color: edge, linewidth: 4 }))));
    }
    if (d.points.length) {
      const geometry = new BufferGeometry();
      geometry.setAttribute("position", new Float32BufferAttribute(d.points.flat(), 3));
      into.add(new Points(geometry, this.material(new PointsMaterial({ color: edge, size: 11, sizeAttenuation: false, map: dot(), alphaTest: 0.5, transparent: true }))));
    }
  }

  setScene(summary: Summary, hidden: Set<string>): void {
    this.summary = summary;
    this.hidden = hidden;
    this.build();
  }

  /// All objects anew, in the colours of now.
  private build(): void {
    if (!this.summary) return;
    for (const group of [this.fixed, this.part, this.ghost]) empty(group);
    this.section.clear();
    const shapes = this.summary.shapes.filter((s) => s.drawing);
    const boxes = new Map(shapes.map((s) => [s.name, new Box3().setFromArray((s.drawing as SpaceDrawing).vertices.flat())]));
    for (const s of shapes) {
      const drawing = s.drawing as SpaceDrawing;
      if (s.moving) {
        this.show(this.part, drawing, { fill: this.good ? "--part" : "--bad", opacity: 0.75, edges: this.good ? "--part" : "--bad", cap: 0.95 });
        this.show(this.ghost, drawing, { fill: "--ghost", opacity: 0.15, edges: "--ghost" });
      } else if (!this.hidden.has(s.name) && !this.placed.names.includes(s.name)) {
        const box = boxes.get(s.name)!;
        const around = s.holder || shapes.some((o) => o !== s && !this.hidden.has(o.name) && box.containsBox(boxes.get(o.name)!));
        this.show(this.fixed, drawing, around ? { fill: "--shape", opacity: 0.16, edges: "--edge", side: BackSide } : { fill: "--shape", opacity: 0.5, edges: "--edge", cap: 1 });
      }
    }
    this.handles.length = 0;
    const moving = new Box3();
    for (const name of this.summary.moving) if (boxes.has(name)) moving.union(boxes.get(name)!);
    this.addHandles(moving, this.part);
    this.showRegions();
    this.drawMarks();
    this.place(this.at);
  }

  /// On what is drawn as the box says in the group.
  private addHandles(box: Box3, to: Group): void {
    if (box.isEmpty()) return;
    const grip = new Group();
    grip.position.copy(box.getCenter(new Vector3()));
    to.add(grip);
    kAxes.forEach((axis, k) => {
      const material = new MeshBasicMaterial({ color: kAxisColours[k]!, depthTest: false, transparent: true });
      const arrow = new Mesh(arrowGeometry(axis), material);
      arrow.renderOrder = 10;
      arrow.userData["axis"] = k;
      grip.add(arrow);
      this.handles.push(arrow);
    });
  }

  setRegion(drawing: AnyDrawing | null, own = false): void {
    this.drawings[own ? "own" : "region"] = drawing as SpaceDrawing | null;
    if (this.section.cutting) this.build();
    else this.showRegions();
    this.draw();
  }

  private showRegions(): void {
    empty(this.region);
    empty(this.own);
    this.showPlaced();
    if (this.drawings.region) this.show(this.region, this.drawings.region, { fill: "--region", opacity: 0.32, edges: "--region", cap: 0.5 });
    if (this.drawings.own) this.show(this.own, this.drawings.own, { fill: "--ghost", opacity: 0.12, edges: "--ghost" });
    this.section.outline();
  }

  place(at: Place): void {
    this.at = at;
    this.part.position.set(at[0]!, at[1]!, at[2]!);
    this.section.outline();
    this.draw();
  }

  setPose(_pose: Pose): void {}

  setGhost(at: Place | null): void {
    this.ghost.visible = !!at;
    if (at) this.ghost.position.set(at[0]!, at[1]!, at[2]!);
    this.section.outline();
    this.draw();
  }

  setPlaced(placed: Placed[], picked: number, names: string[]): void {
    this.placed = { all: placed, groups: [], picked, names };
    this.build();
    this.draw();
  }

  private showPlaced(): void {
    this.placed.groups = this.placed.all.map((p, k) => {
      const group = new Group(), box = new Box3();
      group.position.set(...(p.at as Corner));
      for (const s of this.summary!.shapes) {
        if (!s.drawing || (s.name !== p.shape && !p.shape.split("+").includes(s.name))) continue;
        const turn = p.rotation ?? (p.angle ? aboutZ(p.angle) : null), drawing = turn ? rotated(s.drawing as SpaceDrawing, turn) : (s.drawing as SpaceDrawing);
        const fill = k === this.placed.picked ? "--ghost" : p.colour ?? "--part";
        this.show(group, drawing, { fill, opacity: !p.colour ? 0.6 : this.placed.picked < 0 || k === this.placed.picked ? 1 : 0.3, edges: p.colour ? "--ink" : "--part", cap: 0.95 });
        box.union(new Box3().setFromArray(drawing.vertices.flat()));
      }
      group.userData["box"] = box;
      if (k === this.placed.picked) this.addHandles(box, group);
      this.own.add(group);
      return group;
    });
  }

  /// One of them is drawn elsewhere, and as a bad one where it must not be.
  showPlacedAt(k: number, at: Place, good: boolean): void {
    const group = this.placed.groups[k];
    if (!group) return;
    group.position.set(...(at as Corner));
    const fill = colour(good ? "--ghost" : "--bad");
    for (const o of group.children) if (o instanceof Mesh && o.material instanceof MeshLambertMaterial) o.material.color = fill;
    this.draw();
  }

  setAtoms(good: boolean, atoms: Atom[]): void {
    this.atoms = atoms;
    const turned = good !== this.good;
    this.good = good;
    if (turned) this.build();
    else this.drawMarks();
    this.draw();
  }

  private addLabel(text: string, at: Vector3, style = ""): void {
    const e = document.createElement("span");
    e.textContent = text;
    e.className = style;
    this.overlay.append(e);
    this.labels.push({ e, at });
  }

  private drawMarks(): void {
    this.marks.clear();
    this.overlay.replaceChildren();
    this.labels.length = 0;
    for (const a of this.atoms) {
      const [p, q] = a.witness.points ?? [];
      if (!p || !q) continue;
      const lines = new LineSegmentsGeometry();
      lines.setPositions([...p, ...q]);
      this.marks.add(new LineSegments2(lines, new LineMaterial({ color: colour(a.true ? "--ink" : "--bad"), linewidth: 2, depthTest: false })));
      if (typeof a.value !== "number" || a.value === 0) continue;
      this.addLabel(`${shown(a.value)} ${this.unitName}`.trim(), new Vector3(p[0]! + q[0]!, p[1]! + q[1]!, p[2]! + q[2]!).divideScalar(2), a.true ? "" : "no");
    }
    for (const s of this.summary?.shapes ?? []) {
      if (!s.drawing || s.moving || s.holder || this.hidden.has(s.name) || this.placed.names.includes(s.name)) continue;
      const box = new Box3().setFromArray((s.drawing as SpaceDrawing).vertices.flat());
      this.addLabel(s.name, new Vector3((box.min.x + box.max.x) / 2, (box.min.y + box.max.y) / 2, box.max.z), "name");
    }
  }

  /// Cuts everything open: what lies between the eye and the plane at `at` across the axis is not drawn. No axis, no cut.
  setSection(axis: number | null, at: number): void {
    this.section.set(axis, at);
    this.build();
    this.draw();
  }

  /// From least to greatest, of what is drawn.
  range(axis: number): [number, number] {
    const box = this.bounds();
    return [box.min.getComponent(axis), box.max.getComponent(axis)];
  }

  private bounds(): Box3 {
    const box = new Box3();
    for (const s of this.summary?.shapes ?? []) {
      if (!s.drawing || this.hidden.has(s.name) || this.placed.names.includes(s.name)) continue;
      const own = new Box3().setFromArray((s.drawing as SpaceDrawing).vertices.flat());
      if (s.moving) own.translate(new Vector3(...(this.at as Corner)));
      box.union(own);
    }
    for (const group of this.placed.groups) box.union((group.userData["box"] as Box3).clone().translate(group.position));
    return box.isEmpty() ? new Box3(new Vector3(-1, -1, -1), new Vector3(1, 1, 1)) : box;
  }

  fit(): void {
    const box = this.bounds(), middle = box.getCenter(new Vector3());
    this.size = box.getSize(new Vector3()).length();
    this.controls.target.copy(middle);
    const far = (0.62 * this.size) / Math.tan((this.camera.fov * Math.PI) / 360) / Math.min(1, this.camera.aspect);
    this.camera.position.copy(middle).add(new Vector3(0.55, -0.75, 0.5).normalize().multiplyScalar(far));
    this.camera.near = this.size * 1e-3;
    this.camera.far = this.size * 100;
    this.camera.updateProjectionMatrix();
    this.controls.update();
    this.draw();
  }

  zoom(by: number): void {
    const target = this.controls.target;
    this.camera.position.sub(target).multiplyScalar(by).add(target);
    this.controls.update();
    this.draw();
  }

  /// About the middle, by a key's part of a turn.
  shift(right: number, up: number): void {
    const { target } = this.controls, eye = this.camera.position.sub(target).applyAxisAngle(kAxes[2]!, right * kTurn);
    const tilt = eye.angleTo(kAxes[2]!) - up * kTurn;
    if (tilt > 0.01 && tilt < Math.PI - 0.01) eye.applyAxisAngle(kAxes[2]!.clone().cross(eye).normalize(), -up * kTurn);
    eye.add(target);
    this.controls.update();
    this.draw();
  }

  rounded(at: Place): Place { return shortDecimals(at, this.unit); }

  recolour(): void { this.build(); }

  private follow(): void {
    const ray = new Raycaster();
    let hold: { axis: number; from: Vector3; at: Place; placed: number; to: Place } | null = null;
    let clicked: { placed: number; x: number; y: number } | null = null;
    const aim = (e: PointerEvent) => {
      const b = this.canvas.getBoundingClientRect();
      ray.setFromCamera(new Vector2(((e.clientX - b.left) / b.width) * 2 - 1, 1 - ((e.clientY - b.top) / b.height) * 2), this.camera);
    };
    // Along an axis: the point of the axis nearest to the ray; otherwise in the horizontal plane.
    const reach = (axis: number, through: Vector3): Vector3 | null => {
      if (axis < 0) return ray.ray.intersectPlane(new Plane(new Vector3(0, 0, 1), -through.z), new Vector3());
      const normal = kAxes[axis]!.clone().cross(ray.ray.direction).cross(kAxes[axis]!);
      if (normal.lengthSq() === 0) return null;
      const hit = ray.ray.intersectPlane(new Plane().setFromNormalAndCoplanarPoint(normal.normalize(), through), new Vector3());
      return hit && through.clone().add(kAxes[axis]!.clone().multiplyScalar(hit.sub(through).dot(kAxes[axis]!)));
    };
    const signal = this.until;
    this.canvas.addEventListener("pointerdown", (e) => {
      aim(e);
      const arrow = ray.intersectObjects(this.handles, false)[0];
      const seen = [...this.part.children, ...this.placed.groups.flatMap((g) => g.children)].filter((c) => c instanceof Mesh);
      const body = arrow ?? ray.intersectObjects(seen, false)[0];
      if (!body) return;
      const groups = this.placed.groups as Object3D[];
      const placed = groups.findIndex((g) => g === body.object.parent || g === body.object.parent?.parent);
      if (this.turnsAll && placed >= 0 && placed !== this.placed.picked) {
        clicked = { placed, x: e.clientX, y: e.clientY };
        return;
      }
      const from = reach(arrow ? (arrow.object.userData["axis"] as number) : -1, body.point.clone());
      if (!from) return;
      hold = { axis: arrow ? (arrow.object.userData["axis"] as number) : -1, from, at: placed < 0 ? this.at : this.placed.all[placed]!.at, placed, to: [] };
      this.controls.enabled = false;
      this.canvas.setPointerCapture(e.pointerId);
    }, { capture: true, signal });
    this.canvas.addEventListener("pointermove", (e) => {
      if (!hold) return;
      aim(e);
      const to = reach(hold.axis, hold.from.clone());
      if (!to) return;
      const by = to.sub(hold.from);
      const free = hold.axis < 0 ? [0, 1] : [hold.axis];
      const moved = this.rounded(hold.at.map((x, k) => x + by.getComponent(k)));
      hold.to = hold.at.map((x, k) => (free.includes(k) ? moved[k]! : x));
      if (hold.placed < 0) return this.onDrag(hold.to);
      this.placed.groups[hold.placed]!.position.set(...(hold.to as Corner));
      this.onDragPlaced(hold.placed, hold.to);
      this.draw();
    }, { signal });
    const release = (e: PointerEvent) => {
      if (clicked && e.type === "pointerup" && Math.hypot(e.clientX - clicked.x, e.clientY - clicked.y) < kClickPixels) this.onPickPlaced(clicked.placed);
      clicked = null;
      if (hold && hold.placed >= 0) {
        if (hold.to.length) this.onMovePlaced(hold.placed, hold.to);
        else this.onPickPlaced(hold.placed);
      } else if (hold) {
        this.onDragged();
      }
      hold = null;
      this.controls.enabled = true;
    };
    this.canvas.addEventListener("pointerup", release, { signal });
    this.canvas.addEventListener("pointercancel", release, { signal });
  }

  /// A picture of pixels in an SVG.
  svg(): string {
    this.render();
    const { clientWidth: w, clientHeight: h } = this.canvas;
    return `<svg xmlns="http://www.w3.org/2000/svg" width="${w}" height="${h}"><image width="${w}" height="${h}" href="${this.canvas.toDataURL("image/png")}"/></svg>`;
  }

  png(): Promise<Blob> {
    this.render();
    return new Promise((done, fail) => this.canvas.toBlob((b) => (b ? done(b) : fail(new Error("no picture"))), "image/png"));
  }
}

(globalThis as { findspaceSpace?: typeof SpaceStage }).findspaceSpace = SpaceStage;
