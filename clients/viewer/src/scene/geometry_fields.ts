// SPDX-License-Identifier: MIT
// Fields of collider.proto and of the parts of scene.proto that say where and how things move.
import { choice, flag, group, list, mm, number, numbers, seconds, vector, whole, type Field } from './field';

const speed = { unit: 'm/s' };

const motion = list('Motion', 'keyframe', group('', {
  t: number('Time', 0, seconds),
  translation_m: vector('Translation', [0, 0, 0], mm),
  rotation_rad: vector('Rotation (axis × angle)', [0, 0, 0], { unit: 'rad' }),
}), { t: 0 });

export const collider: Field = group('', {
  plane: group('Plane', {
    point_m: vector('Point', [0, 0, 0], mm),
    normal: vector('Normal, to the free side', [0, 1, 0]),
  }),
  sphere: group('Sphere', { centre_m: vector('Centre', [0, 0, 0], mm), radius_m: number('Radius', 'required', mm) }),
  capsule: group('Capsule', {
    a_m: vector('One end', [0, 0, 0], mm),
    b_m: vector('Other end', [0, 0, 0], mm),
    radius_m: number('Radius', 'required', mm),
  }),
  box: group('Box', {
    centre_m: vector('Centre', [0, 0, 0], mm),
    half_size_m: vector('Half size', [0, 0, 0], mm),
    rotation_rad: vector('Rotation (axis × angle)', [0, 0, 0], { unit: 'rad' }),
  }),
  mesh: group('Mesh', {
    vertices_m: numbers('Vertices', 'x y z of every vertex, in m'),
    triangles: numbers('Triangles', 'three vertex indices each, counter-clockwise from outside'),
  }),
  friction_coefficient: number('Friction with the yarn', 0.3),
  motion,
  dynamic: group('Moves freely (spheres)', {
    mass_kg: number('Mass', 'required', { unit: 'g', scale: 1e-3 }),
    velocity_m_per_s: vector('Velocity at the start', [0, 0, 0], speed),
  }),
}, { label: 'Shape', keys: ['plane', 'sphere', 'capsule', 'box', 'mesh'] }, { label: 'Dynamic', keys: ['dynamic'], none: 'stands or follows its motion' });

const where: Field = group('Where', {
  corner: choice('Corner', ['BOTTOM_LEFT', 'BOTTOM_RIGHT', 'TOP_LEFT', 'TOP_RIGHT']),
  edge: choice('Edge', ['BOTTOM', 'TOP', 'LEFT', 'RIGHT']),
  stitches: group('Stitches', {
    first_course: whole('First course', 1),
    last_course: whole('Last course', 1),
    first_wale: whole('First wale', 1),
    last_wale: whole('Last wale', 1),
  }),
  yarn_point: group('Point of a yarn', { yarn: whole('Yarn', 0), point: whole('Point, negative from the end', 0) }),
  all: group('All nodes', {}),
}, { label: 'Place', keys: ['corner', 'edge', 'stitches', 'yarn_point', 'all'] });

export const handles = list('Holds', 'hold', group('', {
  where,
  fix_arc_length: flag('Yarn cannot slide there'),
  velocity_m_per_s: vector('Velocity', [0, 0, 0], speed),
  motion,
}), { where: { corner: 'TOP_LEFT' } });

export const loads = list('Loads', 'load', group('', {
  where,
  force_n: vector('Force', [0, 0, 0], { unit: 'mN', scale: 1e-3 }),
}), { where: { edge: 'BOTTOM' }, force_n: [0, -0.01, 0] });

export const initialVelocities = list('Velocities at the start', 'velocity', group('', {
  where,
  velocity_m_per_s: vector('Velocity', [0, 0, 0], speed),
}), { where: { all: {} } });

export const yarns = list('Bare yarns', 'yarn', group('', {
  points_m: numbers('Points', 'x y z of every point, in m'),
  prestretch: number('Prestretch', 1),
  arc_lengths_m: numbers('Rest arc lengths', 'one for each point, in m; empty: from the points'),
  velocity_m_per_s: vector('Velocity at the start', [0, 0, 0], speed),
}), { points_m: [0, 0, 0, 0.05, 0, 0, 0.1, 0, 0] });

export const guides = list('Guides', 'guide', group('', {
  yarn: whole('Yarn', 0),
  point: whole('Point', 0),
}), {});

export const crossings = list('Crossings', 'crossing', group('', {
  yarn_a: whole('Yarn a', 0),
  point_a: whole('Point a', 0),
  yarn_b: whole('Yarn b', 0),
  point_b: whole('Point b', 0),
}), {});
