// SPDX-License-Identifier: MIT
// The picture: renderer, camera and lights. Draws when something changed, not all the time.
import * as THREE from 'three';
import { OrbitControls } from 'three/examples/jsm/controls/OrbitControls.js';
import type { Ray } from './pick';

export interface Bounds {
  low: THREE.Vector3;
  high: THREE.Vector3;
}

export const viewDirections = {
  angled: new THREE.Vector3(0.35, 0.55, 1),
  front: new THREE.Vector3(0, 0, 1),
  back: new THREE.Vector3(0, 0, -1),
  side: new THREE.Vector3(1, 0, 0),
  top: new THREE.Vector3(0, 1, 0.001),
} as const;
export type ViewName = keyof typeof viewDirections;

export class Stage {
  readonly scene = new THREE.Scene();
  private readonly camera = new THREE.PerspectiveCamera(35, 1, 0.001, 10);
  private readonly renderer: THREE.WebGLRenderer;
  private readonly controls: OrbitControls;
  private readonly light = new THREE.DirectionalLight('#ffffff', 2.2);
  private readonly observer: ResizeObserver;
  private moved = false;  // by a person, since the last look
  private frameRequest = 0;
  private beforeDraw: (light: THREE.Vector3) => void = () => undefined;
  private afterResize: () => void = () => undefined;

  /// Throws when the browser has no WebGL 2.
  constructor(private readonly canvas: HTMLCanvasElement) {
    this.renderer = new THREE.WebGLRenderer({ canvas, antialias: true, alpha: true });
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio, 2));
    this.scene.add(new THREE.HemisphereLight('#ffffff', '#8a8078', 1.4), this.light);
    this.controls = new OrbitControls(this.camera, canvas);
    // One finger that sets out sideways turns and tilts; upwards it scrolls the page, which the picture may fill. Two move
    // and zoom.
    this.controls.touches = { ONE: THREE.TOUCH.ROTATE, TWO: THREE.TOUCH.DOLLY_PAN };
    canvas.style.touchAction = 'pan-y';
    this.controls.addEventListener('change', () => this.invalidate());
    this.controls.addEventListener('start', () => { this.moved = true; });
    this.observer = new ResizeObserver(() => this.resize());
    this.observer.observe(canvas.parentElement ?? canvas);
    this.resize();
  }

  onDraw(callback: (light: THREE.Vector3) => void): void {
    this.beforeDraw = callback;
  }

  /// `callback` is for a camera that no person has moved.
  onResize(callback: () => void): void {
    this.afterResize = callback;
  }

  invalidate(): void {
    if (this.frameRequest === 0) this.frameRequest = requestAnimationFrame(() => this.draw());
  }

  draw(): void {
    cancelAnimationFrame(this.frameRequest);
    this.frameRequest = 0;
    // Light over the viewer's left shoulder, wherever the viewer goes.
    const from = new THREE.Vector3(-0.45, 0.75, 0.7).applyQuaternion(this.camera.quaternion).normalize();
    this.light.position.copy(from);
    this.beforeDraw(from);
    this.renderer.render(this.scene, this.camera);
    this.canvas.dataset.drawn = String(Number(this.canvas.dataset.drawn ?? 0) + 1);
  }

  private resize(): void {
    const parent = this.canvas.parentElement ?? this.canvas;
    const [width, height] = [Math.max(parent.clientWidth, 1), Math.max(parent.clientHeight, 1)];
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    if (!this.moved) this.afterResize();
    this.invalidate();
  }

  /// Whether a person lets the camera alone, and not all of a box is in the picture.
  losesSight({ low, high }: Bounds): boolean {
    if (this.moved) return false;
    this.camera.updateMatrixWorld();
    for (let corner = 0; corner < 8; ++corner) {
      const at = new THREE.Vector3(corner & 1 ? high.x : low.x, corner & 2 ? high.y : low.y, corner & 4 ? high.z : low.z).project(this.camera);
      if (Math.max(Math.abs(at.x), Math.abs(at.y)) > 1) return true;
    }
    return false;
  }

  look(view: ViewName, { low, high }: Bounds): void {
    this.moved = false;
    const centre = low.clone().add(high).multiplyScalar(0.5);
    const towards = viewDirections[view].clone().normalize();
    const distance = this.distanceFor(towards, high.clone().sub(low).multiplyScalar(0.5));
    this.camera.near = distance / 200;
    this.camera.far = distance * 20;
    this.camera.position.copy(towards).multiplyScalar(distance).add(centre);
    this.camera.updateProjectionMatrix();
    this.controls.target.copy(centre);
    this.controls.update();
    this.invalidate();
  }

  /// From where a box of a half size is seen whole, in m from its centre.
  private distanceFor(towards: THREE.Vector3, half: THREE.Vector3): number {
    const right = new THREE.Vector3(0, 1, 0).cross(towards).normalize();
    const up = towards.clone().cross(right);
    const slope = Math.tan((this.camera.fov * Math.PI) / 360) / 1.12;  // with a margin
    let distance = 1e-3;
    for (let corner = 0; corner < 8; ++corner) {
      const sign = (bit: number): number => (corner & bit ? 1 : -1);
      const at = new THREE.Vector3(sign(1), sign(2), sign(4)).multiply(half);
      const needed = Math.max(Math.abs(at.dot(up)), Math.abs(at.dot(right)) / this.camera.aspect) / slope;
      distance = Math.max(distance, needed + at.dot(towards));
    }
    return distance;
  }

  /// Turns by angles in rad, or moves along by a factor: for keys.
  orbit(around: number, upwards: number, zoom: number): void {
    this.moved = true;
    const offset = this.camera.position.clone().sub(this.controls.target);
    const place = new THREE.Spherical().setFromVector3(offset);
    place.theta += around;
    place.phi = Math.min(Math.max(place.phi + upwards, 0.02), Math.PI - 0.02);
    place.radius *= zoom;
    this.camera.position.copy(this.controls.target).add(new THREE.Vector3().setFromSpherical(place));
    this.controls.update();
    this.invalidate();
  }

  /// Moves what is looked at by parts of the picture's height: for keys.
  pan(right: number, up: number): void {
    this.moved = true;
    const height = this.camera.position.distanceTo(this.controls.target) * 2 * Math.tan((this.camera.fov * Math.PI) / 360);
    const by = new THREE.Vector3(-right * height, -up * height, 0).applyQuaternion(this.camera.quaternion);
    this.camera.position.add(by);
    this.controls.target.add(by);
    this.controls.update();
    this.invalidate();
  }

  rayAt(clientX: number, clientY: number): Ray {
    const box = this.canvas.getBoundingClientRect();
    const at = new THREE.Vector2(((clientX - box.left) / box.width) * 2 - 1, 1 - ((clientY - box.top) / box.height) * 2);
    this.camera.updateMatrixWorld();  // else as of the last picture
    const caster = new THREE.Raycaster();
    caster.setFromCamera(at, this.camera);
    return { origin: caster.ray.origin.toArray(), direction: caster.ray.direction.toArray() };
  }

  /// The size of a pixel at distance 1, in m.
  get pixelSize(): number {
    return (2 * Math.tan((this.camera.fov * Math.PI) / 360)) / Math.max(this.canvas.clientHeight, 1);
  }

  picture(): Promise<Blob> {
    this.draw();
    return new Promise((resolve, reject) => {
      this.canvas.toBlob((blob) => (blob ? resolve(blob) : reject(new Error('the browser made no picture'))), 'image/png');
    });
  }

  dispose(): void {
    cancelAnimationFrame(this.frameRequest);
    this.observer.disconnect();
    this.controls.dispose();
    this.renderer.dispose();
  }
}
