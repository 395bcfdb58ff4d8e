// SPDX-License-Identifier: MIT
// Fields of effects.proto, in the order in which the page shows them.
import { group, list, number, seconds, vector, type Field, type Json } from './field';
import { collider } from './geometry_fields';

export interface EffectEntry {
  name: string;
  label: string;
  about: string;
  needs?: string;
  fields: Readonly<Record<string, Field>>;
  /// What switching it on writes.
  fresh: Json;
}

const newton = { unit: 'N' };

export const effectEntries: readonly EffectEntry[] = [
  { name: 'inertia', label: 'Inertia', about: 'Mass. Off: every step finds a static equilibrium.', fresh: {},
    fields: { sliding_mass_fraction: number('Mass of sliding', 1e-6) } },
  { name: 'gravity', label: 'Gravity', about: 'Weight of the yarn.', fresh: {},
    fields: { acceleration_m_per_s2: vector('Acceleration', [0, -9.81, 0], { unit: 'm/s²' }) } },
  { name: 'stretch', label: 'Stretch', about: 'Stiffness along the yarn.', fresh: {}, fields: {} },
  { name: 'bending', label: 'Bending', about: 'Stiffness against bending, straight at rest.', fresh: {}, fields: {} },
  { name: 'bending_jamming', label: 'Bending jamming', needs: 'bending', fresh: {},
    about: 'Bending stiffens where the yarn curls tighter than its loop can.',
    fields: { max_factor: number('Largest stiffening', 1000), full_at: number('Full at (× jamming curvature)', 2) } },
  { name: 'wrapping', label: 'Wrapping', about: 'Keeps two interlaced loops wrapped around each other.', fresh: { alpha: 0.03 },
    fields: { alpha: number('Stiffness α (of EI / L²)', 1), stiffness_n: number('Stiffness', 'from α', newton),
      rest_angle_rad: number('Angle at rest', 'pi/2', { unit: 'rad' }) } },
  { name: 'sliding', label: 'Sliding', about: 'Yarn slides through its stitches.', fresh: {}, fields: {} },
  { name: 'sliding_friction', label: 'Sliding friction', needs: 'sliding', about: 'Stick-slip friction on sliding yarn.', fresh: {},
    fields: { coefficient: number('Coefficient', 0.3), stick_stiffness_n_per_m: number('Sticking spring', 100, { unit: 'N/m' }),
      normal_force_n: number('Normal force', 'estimated', newton) } },
  { name: 'contact_length', label: 'Contact length', needs: 'sliding', about: 'Keeps the yarn length inside a stitch contact.', fresh: {},
    fields: { stiffness_n: number('Stiffness', 'as yarn stretch', newton) } },
  { name: 'parallel_contact', label: 'Parallel contact', needs: 'sliding', about: 'Keeps neighbouring contacts of a yarn apart.', fresh: {},
    fields: { stiffness_n_per_m2: number('Stiffness', 'from the yarn', { unit: 'N/m²' }), rest_ratio: number('Distance (of the rest length)', 0.7) } },
  { name: 'damping', label: 'Damping', about: 'Viscous; rigid motion is not damped.',
    fresh: { bending_nm2s: 1.35e-8, wrapping_ns: 9e-3 },
    fields: { stretch_ns: number('Stretch', 0, { unit: 'N s' }), bending_nm2s: number('Bending', 0, { unit: 'N m² s' }),
      wrapping_ns: number('Wrapping', 0, { unit: 'N s' }), sliding_ns_per_m: number('Sliding', '1e-3', { unit: 'N s/m' }) } },
  { name: 'self_collision', label: 'Self-collision', about: 'Yarn does not pass through other parts of the fabric.', fresh: {},
    fields: { stiffness_n: number('Stiffness', 'stretch / 1000', newton) } },
  { name: 'colliders', label: 'Colliders', about: 'Rigid bodies that yarn cannot enter.',
    fresh: { colliders: [{ sphere: { centre_m: [0.02, -0.03, -0.02], radius_m: 0.012 } }] },
    fields: { colliders: list('Bodies', 'body', collider, { sphere: { centre_m: [0.02, -0.03, -0.02], radius_m: 0.012 } }),
      stiffness_n: number('Stiffness', 'stretch / 1000', newton),
      stick_stiffness_n_per_m: number('Sticking spring', 100, { unit: 'N/m' }) } },
  { name: 'air_drag', label: 'Air drag', needs: 'inertia', about: 'Drag of the air on the yarn.', fresh: {},
    fields: { linear_ns_per_m2: number('Linear', 0, { unit: 'N s/m²' }),
      quadratic_ns2_per_m3: number('Quadratic', 'of a cylinder', { unit: 'N s²/m³' }) } },
  { name: 'wind', label: 'Wind', needs: 'air_drag', about: 'Moves the air, with gusts.', fresh: { velocity_m_per_s: [0, 0, 1] },
    fields: { velocity_m_per_s: vector('Velocity', [0, 0, 0], { unit: 'm/s' }),
      gust_velocity_m_per_s: vector('Gust', [0, 0, 0], { unit: 'm/s' }), gust_period_s: number('Period of gusts', 1, seconds) } },
  { name: 'shrinkage', label: 'Shrinkage', needs: 'stretch', about: 'Yarn changes its length, as in blocking and fulling.',
    fresh: { keyframes: [{ t: 1, factor: 0.95 }] },
    fields: { keyframes: list('Keyframes', 'keyframe', group('', { t: number('Time', 0, seconds),
      factor: number('Rest length / arc length', 1) }), { t: 1, factor: 0.95 }) } },
  { name: 'plasticity', label: 'Plasticity', needs: 'bending', about: 'Bends keep a set.', fresh: {},
    fields: { yield_angle_rad: number('Yield angle', 0.5, { unit: 'rad' }), relaxation_time_s: number('Relaxation time', 1, seconds) } },
  { name: 'auto', label: 'Choose for me', fresh: {},
    about: 'Drops effects that make no difference, and adds those without parameters that do.',
    fields: { tolerance_m: number('Difference that does not matter', 'yarn radius', { unit: 'mm', scale: 1e-3 }),
      window_s: number('Time looked at', 'a tenth of the duration', seconds) } },
];

export const effectsField = group('Effects', Object.fromEntries(
  effectEntries.map((entry) => [entry.name, group(entry.label, { ...entry.fields })])));
