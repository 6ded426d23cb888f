// What the page of a study is told: the JSON block that `study_page/page_data.rs` writes. SI units; names carry the unit.

/** What was found at every pose of a list, along the axes of the robot; null where nothing was. */
export interface Points {
  error_m: (number[] | null)[];
  /** Empty for a point; the angle of a planar platform; a rotation vector in space. */
  error_rad: (number[] | null)[];
  linear_m: (number[] | null)[];
  linear_rad: (number[] | null)[];
  /** Per cable. */
  tensions_N: (number[] | null)[];
  /** Largest difference of a tension from the commanded one; empty where none are commanded. */
  tension_error_N: (number | null)[];
  /** Residual force of the cables held at the commanded pose; empty for a rigid machine. */
  residual_N: (number | null)[];
}

export interface Samples extends Points {
  /** Poses of the study; more than are listed where the list was thinned out. */
  total: number;
  /** From 1. */
  number: number[];
  /** Position (m), then angles (rad). */
  commanded: number[][];
  emerging: (number[] | null)[];
  /** Why there is no answer. */
  reason: (string | null)[];
}

export interface Nodes {
  start_m: number;
  step_m: number;
  count: number;
}

/** A regular grid in the plane of a planar robot or on a slice through space, the first axis running fastest. */
export interface StudyRegion extends Points {
  name: string;
  axes: [Nodes, Nodes];
  /** Axes of the robot that these run along. */
  plane: [number, number];
  /** Where a slice lies along the third axis; null in a plane. */
  level_m: number | null;
  /** Margins: where they are zero a workspace ends. Null for −∞. */
  physical: (number | null)[] | null;
  reachable: (number | null)[] | null;
  /** The same as one linear step tells. */
  linear: (number | null)[] | null;
}

export interface StudyData {
  page: "study";
  name: string;
  robot: { name: string; axes: string[]; planar: boolean; cables: { name: string; frame_anchor_m: number[] }[] };
  samples: Samples;
  /** The whole workspace first; slices of a spatial robot. */
  regions: StudyRegion[];
}
