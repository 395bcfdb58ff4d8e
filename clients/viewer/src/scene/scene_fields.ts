// SPDX-License-Identifier: MIT
// Fields of scene.proto and knit.proto. A test compares all of this with the .proto files.
import { effectsField } from './effect_fields';
import { choice, flag, group, list, mm, number, seconds, text, vector, whole, type GroupField } from './field';
import { crossings, guides, handles, initialVelocities, loads, yarns } from './geometry_fields';

const rows = list('Rows', 'row', text('Row'), 'KK');

export const knitField = group('Knit', {
  chart: group('Chart', { rows }),
  preset: group('Preset', {
    name: text('Name', 'stockinette, reverse_stockinette, garter, rib or seed'),
    courses: whole('Courses', 'required'),
    wales: whole('Wales', 'required'),
    rib_knits: whole('Rib: knit wales', 1),
    rib_purls: whole('Rib: purl wales', 1),
  }),
  worked_rows: group('Worked rows', { rows }),
  in_the_round: flag('Knitted in the round', false, 'off: flat, turning after every row'),
  gauge: group('Gauge', {
    course_spacing_m: number('Stitch width', 'give both or the yarn', mm),
    wale_spacing_m: number('Stitch height', 'give both or the yarn', mm),
    yarn_per_stitch_m: number('Yarn in a stitch', 'or both spacings', mm),
  }),
  placement: group('Placement', {
    origin_m: vector('Lower left corner', [0, 0, 0], mm),
    course_direction: vector('Course direction', [1, 0, 0]),
    wale_direction: vector('Wale direction', [0, 1, 0]),
  }),
  relax_repeat: flag('Start relaxed', true, 'off: from the drawn loops'),
  noise_m: number('Noise of the start', 0, mm),
  noise_seed: whole('Seed of the noise', 0),
  ends_woven_in: flag('Ends woven in', false, 'off: the yarn begins and ends in tails'),
  refine: whole('Extra nodes a free segment', 0),
}, { label: 'Pattern', keys: ['chart', 'preset', 'worked_rows'] });

export const yarnField = group('Yarn', {
  radius_m: number('Radius', 0.524e-3, mm),
  linear_density_kg_per_m: number('Linear density', 0.077e-3, { unit: 'g/m', scale: 1e-3 }),
  stretch_n: number('Stretch stiffness EA', 68, { unit: 'N' }),
  bending_nm2: number('Bending stiffness EI', 4.5e-8, { unit: 'N m²' }),
});

export const timeFields = group('Time', {
  duration_s: number('Duration', 1, seconds),
  frames_per_s: number('Frames', 30, { unit: '1/s' }),
});

export const numericsField = group('Accuracy', {
  fixed: group('Chosen by hand', {
    time_step_s: number('Largest step', '1/240', { unit: 'ms', scale: 1e-3 }),
    velocity_tolerance_m_per_s: number('Tolerance (moving)', 1e-4, { unit: 'm/s' }),
    force_tolerance_n: number('Tolerance (static)', 1e-9, { unit: 'N' }),
    max_newton_iterations: whole('Newton iterations a step', 200),
    smallest_step_s: number('Smallest step', 1e-7, seconds),
    integrator: choice('Integrator', ['IMPLICIT_EULER', 'BDF2', 'SDIRK2', 'IMPLICIT_MIDPOINT', 'LINEARISED_EULER']),
  }),
  accuracy: group('Chosen by the run', {
    tolerance_m: number('Error of positions', 'required', mm),
    budget_s: number('Wall time', 'required', seconds),
  }, { label: 'Goal', keys: ['tolerance_m', 'budget_s'] }),
}, { label: 'Numerics', keys: ['fixed', 'accuracy'], none: 'defaults' });

export const sceneField: GroupField = group('Scene', {
  name: text('Name', 'for people'),
  knit: knitField,
  yarn: yarnField,
  effects: effectsField,
  handles, loads,
  initial_velocities: initialVelocities,
  yarns, guides, crossings,
  ...timeFields.fields,
  ...numericsField.fields,
}, { label: 'Numerics', keys: ['fixed', 'accuracy'], none: 'defaults' });

