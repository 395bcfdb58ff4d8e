// SPDX-License-Identifier: MIT
import * as THREE from 'three';
import type { Fabric, Frame } from '../fabric/fabric';
import { colourTable } from './colour_map';
import { planCurves, type CurvePlan } from './curve_plan';
import { makeCurveBuffers, pointLengths, pointThickness, traceCurves, visitOfPoint, type CurveBuffers } from './curves';
import { tubeFragmentShader, tubeVertexShader } from './tube_shader';

export interface Tubes {
  mesh: THREE.Mesh;
  plan: CurvePlan;
  buffers: CurveBuffers;
  material: THREE.ShaderMaterial;
  sequential: THREE.DataTexture;
  diverging: THREE.DataTexture;
  points: THREE.InstancedInterleavedBuffer;
  marks: THREE.InstancedBufferAttribute;  // per point: 1 where it is picked
}

/// Quadrilaterals across the visible half of a tube: fewer where there are many tubes, and each is small.
function columnsFor(numPoints: number): number {
  return numPoints > 30_000 ? 4 : 6;
}

/// x from -1 to 1 across, y 0 or 1 along.
function crossSection(geometry: THREE.InstancedBufferGeometry, columns: number): void {
  const positions: number[] = [];
  const indices: number[] = [];
  for (let i = 0; i <= columns; ++i) {
    const x = (2 * i) / columns - 1;
    positions.push(x, 0, 0, x, 1, 0);
    if (i === columns) break;
    const a = 2 * i;
    indices.push(a, a + 1, a + 2, a + 2, a + 1, a + 3);
  }
  geometry.setAttribute('position', new THREE.Float32BufferAttribute(positions, 3));
  geometry.setIndex(indices);
}

function colourTexture(diverging: boolean): THREE.DataTexture {
  const texture = new THREE.DataTexture(colourTable(diverging), 256, 1, THREE.RGBAFormat);
  texture.minFilter = texture.magFilter = THREE.LinearFilter;
  texture.needsUpdate = true;
  return texture;
}

function tubeMaterial(radius: number): THREE.ShaderMaterial {
  return new THREE.ShaderMaterial({
    glslVersion: THREE.GLSL3,
    vertexShader: tubeVertexShader,
    fragmentShader: tubeFragmentShader,
    side: THREE.DoubleSide,
    uniforms: {
      radius: { value: radius },
      lowest: { value: 0 },
      highest: { value: 1 },
      colours: { value: null },
      useColours: { value: 0 },
      yarnColour: { value: new THREE.Color('#d9b98a') },
      lightFrom: { value: new THREE.Vector3(0.3, 0.8, 0.5).normalize() },
    },
  });
}

/// All yarns as one instanced mesh over one buffer of points, which is all that changes from frame to frame.
export function makeTubes(fabric: Fabric, first: Frame): Tubes {
  const plan = planCurves(fabric);
  const buffers = makeCurveBuffers(plan);
  traceCurves(fabric, plan, first.q, new Float64Array(fabric.numVisits).fill(NaN), buffers);

  const geometry = new THREE.InstancedBufferGeometry();
  crossSection(geometry, columnsFor(plan.numPoints));
  const points = new THREE.InstancedInterleavedBuffer(buffers.points, 4, 1);
  points.setUsage(THREE.DynamicDrawUsage);
  ['before', 'start', 'finish', 'behind'].forEach((name, index) => {
    geometry.setAttribute(name, new THREE.InterleavedBufferAttribute(points, 4, 4 * index));
  });
  const lengths = pointLengths(plan, buffers.points);
  geometry.setAttribute('lengthHere', new THREE.InstancedBufferAttribute(lengths.slice(1), 1));
  const thickness = pointThickness(plan);
  geometry.setAttribute('thickHere', new THREE.InstancedBufferAttribute(thickness.slice(1), 1));
  geometry.setAttribute('thickNext', new THREE.InstancedBufferAttribute(thickness.slice(2), 1));
  const marks = new THREE.InstancedBufferAttribute(new Float32Array(Math.max(plan.numPoints, 1)), 1);
  geometry.setAttribute('mark', marks);
  geometry.instanceCount = Math.max(plan.numPoints - 3, 0);
  const material = tubeMaterial(fabric.radius);
  const mesh = new THREE.Mesh(geometry, material);
  mesh.frustumCulled = false;
  return { mesh, plan, buffers, material, points, marks, sequential: colourTexture(false), diverging: colourTexture(true) };
}

export interface Colouring {
  values: Float64Array;  // per visit
  range: readonly [number, number];
  diverging: boolean;
  on: boolean;
}

export function updateTubes(tubes: Tubes, fabric: Fabric, frame: Frame, colouring: Colouring): void {
  traceCurves(fabric, tubes.plan, frame.q, colouring.values, tubes.buffers);
  tubes.points.needsUpdate = true;
  const { uniforms } = tubes.material;
  uniforms.lowest.value = colouring.range[0];
  uniforms.highest.value = colouring.range[1];
  uniforms.useColours.value = colouring.on ? 1 : 0;
  uniforms.colours.value = colouring.diverging ? tubes.diverging : tubes.sequential;
}

export function markTubes(tubes: Tubes, isMarked: (visit: number) => boolean): void {
  const { array } = tubes.marks;
  for (let instance = 0; instance + 3 < tubes.plan.numPoints; ++instance) {
    array[instance] = isMarked(visitOfPoint(tubes.plan, instance + 1)) ? 1 : 0;
  }
  tubes.marks.needsUpdate = true;
}

export function disposeTubes(tubes: Tubes): void {
  tubes.mesh.geometry.dispose();
  tubes.material.dispose();
  tubes.sequential.dispose();
  tubes.diverging.dispose();
}
