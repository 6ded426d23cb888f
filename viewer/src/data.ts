// What the page is told: the JSON block that `report/page_data.rs` writes. SI units; names carry the unit.
import type { RunData } from "./run/data";
import type { StudyData } from "./study/data";
import type { WorkspaceData } from "./workspace/data";

/** Statistics of position (m) or rotation errors (rad). */
export interface PoseError {
  mean: number | null;
  rms: number | null;
  median: number | null;
  p95: number | null;
  max: number | null;
}

export interface ErrorBlocks {
  samples: number;
  position_error_m: PoseError;
  rotation_error_rad: PoseError;
  not_converged: number;
}

export interface Estimate {
  name: string;
  unit: string;
  start: number;
  value: number;
  sigma: number | null;
  change: number;
  at_bound: boolean;
}

/** A candidate as in result.json; the figures are missing where it could not be identified. */
export interface Candidate {
  name: string;
  failure?: string;
  criterion?: number | null;
  standard_error?: number | null;
  parameter_count?: number;
  parameters?: Estimate[];
  train?: ErrorBlocks;
  validation?: ErrorBlocks;
}

/** One component of the pose: where the fit saw it, and where the model was judged. */
export interface PoseRange {
  name: string;
  unit: "m" | "rad";
  fit_min: number;
  fit_max: number;
  validation_min: number;
  validation_max: number;
}

/** result.json without wall times. */
export interface Result {
  criterion: string;
  candidates: Candidate[];
  best: string | null;
  recommended: string | null;
  coverage?: { ranges: PoseRange[]; validation: number; outside: number };
}

export type Vector = [number, number, number];

export interface Cable {
  name: string;
  frame_anchor_nominal_m: Vector;
  frame_anchor_m: Vector;
  platform_anchor_nominal_m: Vector;
  platform_anchor_m: Vector;
  /** Null where the file states no whole pulley. */
  pulley: { radius_m: number; swivel_axis: Vector } | null;
  /** Null where the file does not state where the drum stands. */
  drum: Drum | null;
}

/** A drum: the ends of its axis between which cable lies, and the cable's way to its first pulley where it leaves the drum at the start angle. */
export interface Drum {
  radius_m: number;
  from_m: Vector;
  to_m: Vector;
  /** Null behind a guide. */
  way_m: [Vector, Vector] | null;
}

export interface Robot {
  /** Letters and world directions of the two axes of a planar robot. */
  plane: { names: [string, string]; first: Vector; second: Vector } | null;
  /** False for a point. */
  turns: boolean;
  cables: Cable[];
}

/** Errors of one model, row by row as the samples; predicted minus measured, modelled minus recorded. */
export interface Errors {
  position_error_m: (Vector | null)[];
  rotation_error_rad: (number | null)[];
  length_error_m: (number | null)[][];
  tension_error_N: (number | null)[][] | null;
}

/** Samples that the models were judged by, in the order of the data. */
export interface Samples {
  /** Rows of the data; more than are listed where the list was thinned out. */
  total: number;
  number: number[];
  time_s: number[] | null;
  position_m: Vector[];
  quaternion_xyzw: [number, number, number, number][];
  recorded_length_m: number[][];
  /** Recorded length minus that of the sample before; null for the first of the data. */
  length_change_m: (number[] | null)[];
  outside: boolean[];
  /** Explained by no candidate: no figure counts these. */
  set_aside: boolean[];
  calibrated: Errors;
  as_given: Errors | null;
}

export interface PageData {
  result: Result;
  /** Index of the candidate that the details are about. */
  shown: number;
  /** Index of the robot as given, if that is another candidate. */
  given: number | null;
  criterion: { words: string; unit: string; factor: number };
  /** "validation data", or "the data of the fit" where nothing was held out. */
  data_words: string;
  selection: boolean;
  robot: Robot;
  samples: Samples;
  fit_position_m: Vector[];
  correlation: { names: string[]; lower: (number | null)[][] } | null;
}

/** The block of the page; null where no candidate could be identified. A page that is no report says what it is. */
export function readData(): PageData | RunData | StudyData | WorkspaceData | null {
  const text = document.getElementById("cdpr-data")?.textContent;
  return text ? (JSON.parse(text) as PageData | RunData | StudyData | WorkspaceData | null) : null;
}
