// What the page of a workspace is told: the JSON block that `workspace_page/page_data.rs` writes. SI units; names carry the unit.
import type { Vector } from "../data";

/** A direction of the grid and its nodes along it. */
export interface Axis {
  name: string;
  /** World, of length one. */
  direction: Vector;
  start_m: number;
  step_m: number;
  count: number;
}

/** What was computed at the nodes, the first axis running fastest. */
export interface Grid {
  axes: Axis[];
  /** What all nodes have in common across the axes: zero but for planar robots beside the origin. */
  base_m: Vector;
  /** Null for −∞: nothing could mend it. */
  margin: (number | null)[];
  /** The cable that limits, from 0; −1 for none. */
  cable: number[];
  /** Why a node fails: its words with § for each number; −1 where it holds. */
  reason: number[];
  sentences: string[];
  /** The numbers of every node's reason, joined by spaces. */
  numbers: string[];
  /** Null where no tensions keep the limits. */
  tensions_N: (number[] | null)[];
  /** Largest difference of interpolated from computed tensions in the middle of the cells, and how many cells that were. */
  interpolation: { cells: number; mean_N: number; largest_N: number } | null;
}

/** A result: a surface of triangles, or areas of a plane. */
export interface Region {
  name: string;
  measure: number;
  error_bound: number | null;
  unit: string;
  /** World, three numbers each. */
  vertices_m: number[];
  /** Three vertices each. */
  triangles: number[];
  /** How a surface was found. */
  method: string;
  /** At the vertices; empty where they are not known. */
  margin: number[];
  margin_unit: string;
  /** At the vertices: the cable's number from 1, or 0 for none; empty where it is not known. */
  limiting_cable: number[];
  /** Closed lines in the coordinates of the grid's two axes, of which an odd number encloses what belongs to the area. */
  outlines_m: [number, number][][];
}

export interface Cable {
  name: string;
  frame_anchor_m: Vector;
  platform_anchor_m: Vector;
  tension_min_N: number | null;
  tension_max_N: number | null;
}

export interface WorkspaceData {
  page: "workspace";
  robot: { name: string; planar: boolean; cables: Cable[] };
  criterion: { name: string; unit: string };
  /** Where the platform starts, and how it is turned everywhere. */
  start: { position_m: Vector; quaternion_xyzw: [number, number, number, number] };
  grid: Grid;
  regions: Region[];
}
