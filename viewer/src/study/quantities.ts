// What colours and contours may show, and what stands in a tip.
import { degrees, mm } from "../charts/style";
import { significant } from "../number";
import type { CommandedSamples, StudyData, StudyRegion } from "../data";

/** Findings at every pose of a list. */
export type Points = CommandedSamples | StudyRegion;

/** A number at every pose or grid point; NaN where there is none. */
export interface Quantity {
  words: string;
  unit: string;
  of(points: Points, at: number): number;
}

/** An error: exact, by one linear step, and how far these two are apart. */
export interface ErrorQuantity {
  words: string;
  exact: Quantity;
  linear: Quantity;
  difference: Quantity;
}

export const POSITION = errorOf("position error", "mm", mm, "error_m", "linear_m");
export const ROTATION = errorOf("rotation error", "°", degrees, "error_rad", "linear_rad");
export const LARGEST: Quantity = { words: "largest tension", unit: "N", of: (points, at) => extreme(Math.max, points.tensions_N[at]) };
export const SMALLEST: Quantity = { words: "smallest tension", unit: "N", of: (points, at) => extreme(Math.min, points.tensions_N[at]) };

export const TRACKING: Quantity = { words: "largest tension error", unit: "N", of: (points, at) => points.tension_error_N[at] ?? Number.NaN };
export const RESIDUAL: Quantity = { words: "residual force", unit: "N", of: (points, at) => points.residual_N[at] ?? Number.NaN };

/** Errors that the robot can have. */
export function errorsOf(data: StudyData): ErrorQuantity[] {
  const turns = data.samples.error_rad.some((turn) => (turn?.length ?? 0) > 0);
  return turns ? [POSITION, ROTATION] : [POSITION];
}

export function hasTensions(data: StudyData): boolean {
  return data.samples.tensions_N.some((tensions) => tensions !== null);
}

/** True where control model and machine both know tensions. */
export function tracksForces(data: StudyData): boolean {
  return data.samples.tension_error_N.some((error) => error !== null);
}

export function hasResiduals(data: StudyData): boolean {
  return data.samples.residual_N.some((force) => force !== null);
}

function errorOf(words: string, unit: string, shown: (value: number) => number, exact: "error_m" | "error_rad", linear: "linear_m" | "linear_rad"): ErrorQuantity {
  const size = (vector: number[] | null | undefined) => (vector ? shown(Math.hypot(...vector)) : Number.NaN);
  return {
    words,
    exact: { words: `${words}, exact`, unit, of: (points, at) => size(points[exact][at]) },
    linear: { words: `${words}, one linear step`, unit, of: (points, at) => size(points[linear][at]) },
    difference: { words: `${words}, linear step beside exact`, unit, of: (points, at) => size(between(points[exact][at], points[linear][at])) },
  };
}

/** From the first vector to the second. */
export function between(from: number[] | null | undefined, to: number[] | null | undefined): number[] | null {
  return from && to ? to.map((value, k) => value - (from[k] ?? 0)) : null;
}

function extreme(of: (...values: number[]) => number, tensions: number[] | null | undefined): number {
  return tensions ? of(...tensions) : Number.NaN;
}

/** A place with everything known of it. */
export interface Place {
  title: string;
  /** Components of the commanded pose (m, rad). */
  commanded: number[];
  /** Components of the emerging pose, where they were written. */
  emerging: number[] | null;
  points: Points;
  at: number;
  reason: string | null;
}

/** The study's poses. */
export function poses(data: StudyData): Place[] {
  const { samples } = data;
  return samples.number.map((number, at) => ({
    title: `pose ${number}`,
    commanded: samples.commanded[at] as number[],
    emerging: samples.emerging[at] ?? null,
    points: samples,
    at,
    reason: samples.reason[at] ?? null,
  }));
}

/** Everything known of a place, line by line; lines are short, for tips stand in narrow drawings. */
export function words(data: StudyData, place: Place): string {
  const { axes, cables } = data.robot;
  const { points, at, commanded } = place;
  const error = points.error_m[at];
  const shift = (vector: number[]) => `${axes.map((axis, k) => `${axis} ${significant(mm(vector[k]), 3)}`).join(", ")} mm`;
  const lines = [place.title, ...poseWords("commanded", axes, commanded)];
  if (!error) return [...lines, `no answer${place.reason ? `: ${place.reason}` : ""}`].join("\n");
  lines.push(...poseWords("emerging", axes, place.emerging ?? commanded.map((value, k) => value + (error[k] ?? 0))));
  const turn = points.error_rad[at];
  const turned = turn && turn.length > 0 ? `, rotation error ${significant(degrees(Math.hypot(...turn)), 3)}°` : "";
  lines.push(`error ${shift(error)}`, `position error ${significant(POSITION.exact.of(points, at), 4)} mm${turned}`);
  const linear = points.linear_m[at];
  if (linear) lines.push(`linear step ${shift(linear)}`, `misses by ${significant(POSITION.difference.of(points, at), 3)} mm`);
  else lines.push("the linear step has no answer");
  const tensions = points.tensions_N[at]?.map((tension, k) => `${cables[k]?.name ?? k + 1}: ${tension.toFixed(0)} N`) ?? [];
  for (let from = 0; from < tensions.length; from += 4) lines.push(`${from === 0 ? "tensions " : ""}${tensions.slice(from, from + 4).join(", ")}`);
  const [tracking, residual] = [TRACKING.of(points, at), RESIDUAL.of(points, at)];
  if (Number.isFinite(tracking)) lines.push(`largest tension error ${significant(tracking, 3)} N`);
  if (Number.isFinite(residual)) lines.push(`residual force ${significant(residual, 3)} N`);
  return lines.join("\n");
}

/** E.g. "commanded x 1.2500, y −0.5000 m" and, where the platform is turned, "commanded angle 3.10°". */
function poseWords(name: string, axes: string[], components: number[]): string[] {
  const positions = `${name} ${axes.map((axis, k) => `${axis} ${fixed(components[k] ?? Number.NaN, 4)}`).join(", ")} m`;
  const angles = components.slice(axes.length);
  if (angles.every((angle) => angle === 0)) return [positions];
  const names = angles.length === 1 ? ["angle"] : ["rx", "ry", "rz"];
  return [positions, `${name} ${angles.map((angle, k) => `${names[k]} ${fixed(degrees(angle), 2)}°`).join(", ")}`];
}

function fixed(value: number, decimals: number): string {
  return value.toFixed(decimals).replace("-", "−");
}
