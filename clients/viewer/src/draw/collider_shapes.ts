// SPDX-License-Identifier: MIT
// The bodies of a scene as triangles around their centre, about which they turn.
import * as THREE from 'three';
import type { Json, JsonObject } from '../scene/field';
import { isObject } from '../scene/json_path';

export interface BodyShape {
  geometry: THREE.BufferGeometry;
  centre: THREE.Vector3;
  turned: THREE.Quaternion;  // at the start
  flat: boolean;             // a plane, without an end
}

function numbersOf(value: Json | undefined, fallback: number[]): number[] {
  return Array.isArray(value) && value.length > 0 ? value.map(Number) : fallback;
}

export function vectorOf(value: Json | undefined, fallback: number[] = [0, 0, 0]): THREE.Vector3 {
  const [x = 0, y = 0, z = 0] = numbersOf(value, fallback);
  return new THREE.Vector3(x, y, z);
}

export function rotationOf(axisAngle: THREE.Vector3): THREE.Quaternion {
  const angle = axisAngle.length();
  const axis = angle > 0 ? axisAngle.clone().divideScalar(angle) : new THREE.Vector3(0, 1, 0);
  return new THREE.Quaternion().setFromAxisAngle(axis, angle);
}

const upright = new THREE.Vector3(0, 1, 0);

function plane(shape: JsonObject, size: number): BodyShape {
  const normal = vectorOf(shape.normal, [0, 1, 0]).normalize();
  const geometry = new THREE.CircleGeometry(size, 64).rotateX(-Math.PI / 2);
  return { geometry, centre: vectorOf(shape.point_m), turned: new THREE.Quaternion().setFromUnitVectors(upright, normal), flat: true };
}

function capsule(shape: JsonObject): BodyShape {
  const [a, b] = [vectorOf(shape.a_m), vectorOf(shape.b_m)];
  const along = b.clone().sub(a);
  const geometry = new THREE.CapsuleGeometry(Number(shape.radius_m), along.length(), 12, 32);
  return { geometry, centre: a.add(b).multiplyScalar(0.5), turned: new THREE.Quaternion().setFromUnitVectors(upright, along.normalize()), flat: false };
}

function box(shape: JsonObject): BodyShape {
  const half = vectorOf(shape.half_size_m);
  return {
    geometry: new THREE.BoxGeometry(2 * half.x, 2 * half.y, 2 * half.z),
    centre: vectorOf(shape.centre_m),
    turned: rotationOf(vectorOf(shape.rotation_rad)),
    flat: false,
  };
}

function mesh(shape: JsonObject): BodyShape {
  const vertices = numbersOf(shape.vertices_m, []);
  const centre = new THREE.Vector3();
  const count = Math.max(vertices.length / 3, 1);
  for (let i = 0; i + 2 < vertices.length; i += 3) centre.add(new THREE.Vector3(vertices[i], vertices[i + 1], vertices[i + 2]));
  centre.divideScalar(count);
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute('position', new THREE.Float32BufferAttribute(vertices, 3).applyMatrix4(
    new THREE.Matrix4().makeTranslation(-centre.x, -centre.y, -centre.z)));
  geometry.setIndex(numbersOf(shape.triangles, []));
  const faceted = geometry.toNonIndexed();
  faceted.computeVertexNormals();
  return { geometry: faceted, centre, turned: new THREE.Quaternion(), flat: false };
}

/// `size`: how far a plane is drawn, in m. Undefined where the collider names no shape.
export function bodyShape(collider: JsonObject, size: number): BodyShape | undefined {
  if (isObject(collider.plane)) return plane(collider.plane, size);
  if (isObject(collider.capsule)) return capsule(collider.capsule);
  if (isObject(collider.box)) return box(collider.box);
  if (isObject(collider.mesh)) return mesh(collider.mesh);
  if (!isObject(collider.sphere)) return undefined;
  const geometry = new THREE.SphereGeometry(Number(collider.sphere.radius_m), 48, 32);
  return { geometry, centre: vectorOf(collider.sphere.centre_m), turned: new THREE.Quaternion(), flat: false };
}
