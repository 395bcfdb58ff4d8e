// SPDX-License-Identifier: MIT
// The messages of proto/slipstitch/v1 as JSON. protobuf leaves out what has its zero value, so everything is optional.

export type JobState = 'STATE_UNSPECIFIED' | 'QUEUED' | 'RUNNING' | 'SUCCEEDED' | 'FAILED' | 'CANCELLED' | 'PAUSED';

export interface JobProgress {
  t?: number;
  duration_s?: number;
  frames?: number;
  num_frames?: number;
  steps?: string;
  newton_iterations?: string;
  current_step_s?: number;
  residual?: number;
  wall_s?: number;
  eta_s?: number;
  error_estimate_m?: number;
  share_done?: number;
  doing?: string;
  wall_by_phase_s?: Record<string, number>;
}

export type PredictionBasis = 'BASIS_UNSPECIFIED' | 'WHOLE_RUN' | 'FIRST_MOMENTS' | 'CANNED_RUN';

export interface PredictedRun {
  tolerance_m?: number;
  wall_s?: number;
  steps?: string;
  newton_iterations?: string;
  basis?: PredictionBasis;
  until_s?: number;
  basis_tolerance_m?: number;
}

export interface Prediction {
  unknowns?: number;
  matrix_entries?: string;
  memory_bytes?: string;
  as_it_is?: PredictedRun;
  to_tolerance?: PredictedRun[];
  run_fails?: string;
  chooses_effects?: boolean;
}

export interface StudyMessage {
  quick?: boolean;
  budget_s?: number;
}

export interface SimJob {
  name?: string;
  state?: JobState;
  revision?: string;
  scene_name?: string;
  threads?: number;
  create_time?: string;
  start_time?: string;
  end_time?: string;
  progress?: JobProgress;
  error?: StatusBody;
  summary_json?: string;
  cancel_requested?: boolean;
  study?: StudyMessage;  // one of the two
  simulate?: object;
  prediction?: Prediction;  // in answers to validate_only
}

export interface ListSimJobsResponse {
  jobs?: SimJob[];
  next_page_token?: string;
}

export interface Artefact {
  name?: string;
  size_bytes?: string;
}

export interface FieldViolation {
  field?: string;
  description?: string;
}

export interface StatusDetail {
  '@type'?: string;
  reason?: string;
  metadata?: Record<string, string>;
  field_violations?: FieldViolation[];
}

/// google.rpc.Status
export interface StatusBody {
  code?: number;
  message?: string;
  details?: StatusDetail[];
}

export interface StreamEnd {
  state?: JobState;
  frames_sent?: number;
  frame_count?: number;
  reason?: string;
}

export type SegmentKind = 'NONE' | 'FREE' | 'CONTACT';
export type StitchKind = 'KNIT' | 'PURL';

export interface StitchContactMessage {
  q0?: number; q1?: number; q2?: number; q3?: number; q4?: number; q5?: number;
  u_visit?: number[];
  v_visit?: number[];
  sign?: number;
  kind?: StitchKind;
  side?: 'LEFT_CLASP' | 'RIGHT_CLASP';
  stitch?: number;
}

export interface StitchMessage {
  course?: number;
  wale?: number;
  kind?: StitchKind;
  base_left?: number; base_right?: number; head_left?: number; head_right?: number;
  node?: number[];
}

export interface TopologyMessage {
  num_nodes?: number;
  yarn_first?: number[];
  visit_node?: number[];
  segment_kind?: SegmentKind[];
  rest_arc_m?: number[];
  contacts?: StitchContactMessage[];
  stitches?: StitchMessage[];
  num_courses?: number;
  num_wales?: number;
  num_bodies?: number;
}

export interface LengthKeyframe {
  t?: number;
  factor?: number;
}

export interface FrameHeaderMessage {
  topology?: TopologyMessage;
  yarn?: { radius_m?: number; linear_density_kg_per_m?: number; stretch_n?: number; bending_nm2?: number };
  frames_per_s?: number;
  num_frames?: number;
  shrinkage?: LengthKeyframe[];
}

export function jobId(job: SimJob): string {
  return (job.name ?? '').replace(/^simJobs\//, '');
}

export function hasEnded(state: JobState | undefined): boolean {
  return state === 'SUCCEEDED' || state === 'FAILED' || state === 'CANCELLED';
}
