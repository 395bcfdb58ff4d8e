// SPDX-License-Identifier: MIT
// A job's fabric on the stage: what to show is handed in, nothing is decided here.
import * as THREE from 'three';
import type { Fabric, Frame } from '../fabric/fabric';
import type { Json } from '../scene/field';
import { disposeColliders, makeColliders, moveColliders, type Colliders } from './colliders';
import { pointLengths, visitOfPoint } from './curves';
import { pickPoint } from './pick';
import { Stage, type Bounds, type ViewName } from './stage';
import { disposeTubes, makeTubes, markTubes, updateTubes, type Colouring, type Tubes } from './tubes';

export class FabricView {
  private readonly stage: Stage;
  private readonly tubes: Tubes;
  private readonly lengths: Float32Array;
  private colliders: Colliders | undefined;
  private shown: Frame;
  private view: ViewName = 'angled';

  constructor(canvas: HTMLCanvasElement, private readonly fabric: Fabric, first: Frame) {
    this.stage = new Stage(canvas);
    this.tubes = makeTubes(fabric, first);
    this.lengths = pointLengths(this.tubes.plan, this.tubes.buffers.points);
    this.shown = first;
    this.stage.scene.add(this.tubes.mesh);
    this.stage.onDraw((light) => (this.tubes.material.uniforms.lightFrom.value as THREE.Vector3).copy(light));
    this.stage.onResize(() => this.look(this.view));
    this.look('angled');
  }

  setScene(scene: Json): void {
    if (this.colliders) {
      this.stage.scene.remove(this.colliders.group);
      disposeColliders(this.colliders);
    }
    const { low, high } = this.bounds();
    this.colliders = makeColliders(scene, high.distanceTo(low));
    this.stage.scene.add(this.colliders.group);
    moveColliders(this.colliders, this.fabric, this.shown);
    this.look(this.view);
  }

  show(frame: Frame, colouring: Colouring): void {
    this.shown = frame;
    updateTubes(this.tubes, this.fabric, frame, colouring);
    if (this.colliders) moveColliders(this.colliders, this.fabric, frame);
    if (this.stage.losesSight(this.bounds())) this.look(this.view);
    this.stage.invalidate();
  }

  mark(stitch: number): void {
    markTubes(this.tubes, (visit) => stitch >= 0 && this.fabric.stitchOfVisit[visit] === stitch);
    this.stage.invalidate();
  }

  setYarnColour(colour: string): void {
    (this.tubes.material.uniforms.yarnColour.value as THREE.Color).set(colour);
    this.stage.invalidate();
  }

  look(view: ViewName): void {
    this.view = view;
    this.stage.look(view, this.bounds());
  }

  orbit(around: number, upwards: number, zoom: number): void {
    this.stage.orbit(around, upwards, zoom);
  }

  pan(right: number, up: number): void {
    this.stage.pan(right, up);
  }

  /// The visit drawn at a place of the window, -1: none.
  visitAt(clientX: number, clientY: number): number {
    const slack = 3 * this.stage.pixelSize;
    const point = pickPoint(this.tubes.buffers.points, this.lengths, this.stage.rayAt(clientX, clientY), this.fabric.radius, slack);
    return point < 0 ? -1 : visitOfPoint(this.tubes.plan, point);
  }

  picture(): Promise<Blob> {
    return this.stage.picture();
  }

  dispose(): void {
    disposeTubes(this.tubes);
    if (this.colliders) disposeColliders(this.colliders);
    this.stage.dispose();
  }

  /// Of the yarn in the frame shown and of bodies, as far as they are near it.
  private bounds(): Bounds {
    const box = new THREE.Box3();
    const { q } = this.shown;
    const point = new THREE.Vector3();
    for (const node of this.fabric.visitNode) box.expandByPoint(point.fromArray(q, 3 * node));
    const near = box.clone().expandByScalar(0.5 * box.getSize(point).length());
    for (const body of this.colliders?.bodies ?? []) {
      if (!body.shape.flat) box.union(new THREE.Box3().setFromObject(body.mesh).intersect(near));
    }
    if (box.isEmpty()) box.setFromCenterAndSize(new THREE.Vector3(), new THREE.Vector3(0.01, 0.01, 0.01));
    box.expandByScalar(this.fabric.radius);
    return { low: box.min, high: box.max };
  }
}
