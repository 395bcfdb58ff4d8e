// SPDX-License-Identifier: MIT
// Bodies where they are at a time: by their motion, or by the frame where they move freely.
import * as THREE from 'three';
import type { Fabric, Frame } from '../fabric/fabric';
import type { Json, JsonObject } from '../scene/field';
import { isObject, valueAt } from '../scene/json_path';
import { bodyShape, rotationOf, vectorOf, type BodyShape } from './collider_shapes';

interface Body {
  shape: BodyShape;
  mesh: THREE.Mesh;
  keyframes: JsonObject[];
  dynamicIndex: number;  // -1: it follows its keyframes
}

export interface Colliders {
  group: THREE.Group;
  bodies: Body[];
}

export interface Pose {
  translation: THREE.Vector3;
  rotation: THREE.Vector3;  // axis * angle
}

/// Linear in between, held before the first and after the last.
export function poseAt(keyframes: readonly JsonObject[], t: number): Pose {
  const poses = keyframes.map((key) => ({ t: Number(key.t ?? 0), translation: vectorOf(key.translation_m), rotation: vectorOf(key.rotation_rad) }));
  if (poses.length === 0) return { translation: new THREE.Vector3(), rotation: new THREE.Vector3() };
  const next = poses.findIndex((pose) => pose.t > t);
  if (next === 0) return poses[0];
  if (next < 0) return poses[poses.length - 1];
  const [a, b] = [poses[next - 1], poses[next]];
  const part = (t - a.t) / (b.t - a.t);
  return { translation: a.translation.clone().lerp(b.translation, part), rotation: a.rotation.clone().lerp(b.rotation, part) };
}

function material(flat: boolean): THREE.Material {
  return flat
    ? new THREE.MeshLambertMaterial({ color: '#8f9aa6', transparent: true, opacity: 0.35, side: THREE.DoubleSide, depthWrite: false })
    : new THREE.MeshStandardMaterial({ color: '#7d93a8', roughness: 0.75, metalness: 0 });
}

/// `scene`: the job's scene.json. `size`: of the fabric, in m.
export function makeColliders(scene: Json, size: number): Colliders {
  const group = new THREE.Group();
  const bodies: Body[] = [];
  const listed = valueAt(scene, 'effects.colliders.colliders');
  let numDynamic = 0;
  for (const collider of Array.isArray(listed) ? listed.filter(isObject) : []) {
    const dynamicIndex = isObject(collider.dynamic) ? numDynamic++ : -1;
    const shape = bodyShape(collider, 2 * size);
    if (!shape) continue;
    const mesh = new THREE.Mesh(shape.geometry, material(shape.flat));
    group.add(mesh);
    const keyframes = Array.isArray(collider.motion) ? collider.motion.filter(isObject) : [];
    bodies.push({ shape, mesh, keyframes, dynamicIndex });
  }
  return { group, bodies };
}

export function moveColliders(colliders: Colliders, fabric: Fabric, frame: Frame): void {
  for (const { shape, mesh, keyframes, dynamicIndex } of colliders.bodies) {
    if (dynamicIndex >= 0 && dynamicIndex < fabric.numBodies) {
      mesh.position.fromArray(frame.q, 3 * (fabric.numNodes - fabric.numBodies + dynamicIndex));
      continue;
    }
    const pose = poseAt(keyframes, frame.t);
    mesh.position.copy(shape.centre).add(pose.translation);
    mesh.quaternion.copy(rotationOf(pose.rotation)).multiply(shape.turned);
  }
}

export function disposeColliders(colliders: Colliders): void {
  for (const { mesh } of colliders.bodies) {
    mesh.geometry.dispose();
    (mesh.material as THREE.Material).dispose();
  }
}
