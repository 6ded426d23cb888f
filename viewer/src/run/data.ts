// What the page of a run is told: the JSON block that `run_page/page_data.rs` writes. SI units; names carry the unit.
import type { Vector } from "../data";

export interface RunCable {
  name: string;
  frame_anchor_m: Vector;
  platform_anchor_m: Vector;
  tension_min_N: number | null;
  tension_max_N: number | null;
}

/** The state of the machine at the moments that the page holds, in order of time. */
export interface Moments {
  time_s: number[];
  position_m: Vector[];
  quaternion_xyzw: [number, number, number, number][];
  /** Per cable. */
  tensions_N: number[][];
}

/** A stretch of time in which something is not as it should be. */
export interface Violation {
  from_s: number;
  to_s: number;
  words: string;
}

export interface RunData {
  page: "run";
  robot: { name: string; plane: { names: [string, string]; first: Vector; second: Vector } | null; cables: RunCable[] };
  moments: Moments;
  events: { time_s: number; words: string; cable: number | null; breaks: boolean }[];
  violations: Violation[];
}

/** True after an event that took the cable away. */
export function isBroken(data: RunData, cable: number, time: number): boolean {
  return data.events.some((event) => event.breaks && event.cable === cable && event.time_s < time);
}
