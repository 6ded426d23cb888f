// Error vectors: arrows as long as the error times a stated magnification.
import * as Plot from "@observablehq/plot";
import { INK, PAPER, SECOND } from "../charts/style";
import { type Option } from "../controls";
import type { Place } from "./quantities";

/** Choices of magnification; null for one that fits the drawing. */
export const MAGNIFICATIONS: Option<number | null>[] = [
  { label: "so that they fit", value: null },
  ...[1, 2, 5, 10, 20, 50, 100, 200, 500, 1000].map((value) => ({ label: `${value} ×`, value })),
];

/** Distance between neighbours among the poses (m): the median of the distances to the nearest one. */
export function apart(all: Place[], dimension: number): number {
  const some = all.slice(0, 300).map(({ commanded }) => commanded.slice(0, dimension));
  const nearest = some.map((one) => some.reduce((least, other) => {
    const distance = Math.hypot(...one.map((value, k) => value - (other[k] as number)));
    return distance > 1e-9 ? Math.min(least, distance) : least;
  }, Number.POSITIVE_INFINITY));
  const sorted = nearest.filter(Number.isFinite).sort((a, b) => a - b);
  return sorted[Math.floor(sorted.length / 2)] ?? 1;
}

/** A vector from `from` to `to` (m, in the drawing's two axes). */
interface Drawn {
  from: number[];
  to: number[];
}

/** The round magnification that makes long vectors about as long as places are apart (m). */
export function fitting(places: Place[], spacing: number): number {
  const size = ({ points, at }: Place) => Math.hypot(...(points.error_m[at] ?? [Number.NaN]));
  const lengths = places.map(size).filter(Number.isFinite).sort((a, b) => a - b);
  const long = lengths[Math.floor(0.95 * (lengths.length - 1))] ?? 0;
  const raw = long > 0 ? (1.05 * spacing) / long : 1;
  // the round number below: arrows must not cross their neighbours
  return MAGNIFICATIONS.reduce((best, { value }) => (value !== null && value <= raw ? value : best), 1);
}

/** E.g. "error vectors magnified 5 ×". */
export function magnificationWords(magnification: number): string {
  return magnification === 1 ? "error vectors to scale" : `error vectors magnified ${magnification} ×`;
}

/** Exact vectors, solid with a head. */
export function exactVectors(places: Place[], magnification: number, axes: number[]): Plot.Markish[] {
  const vectors = vectorsOf(places, "error_m", magnification, axes);
  const shape = { x1: (one: Drawn) => one.from[0], y1: (one: Drawn) => one.from[1], x2: (one: Drawn) => one.to[0], y2: (one: Drawn) => one.to[1] };
  return [
    Plot.link(vectors, { ...shape, stroke: PAPER, strokeWidth: 4.5, strokeOpacity: 0.6 }),
    Plot.arrow(vectors, { ...shape, headLength: 8, headAngle: 50, stroke: INK, strokeWidth: 1.8, ariaDescription: "exact error vectors" }),
  ];
}

/** Those of the linear step, dashed with a ring at the end. */
export function linearVectors(places: Place[], magnification: number, axes: number[]): Plot.Markish[] {
  const vectors = vectorsOf(places, "linear_m", magnification, axes);
  return [
    Plot.link(vectors, { x1: (one: Drawn) => one.from[0], y1: (one: Drawn) => one.from[1], x2: (one: Drawn) => one.to[0], y2: (one: Drawn) => one.to[1], stroke: SECOND, strokeWidth: 1.8, strokeDasharray: "5 3", ariaDescription: "error vectors of the linear step" }),
    Plot.dot(vectors, { x: (one: Drawn) => one.to[0], y: (one: Drawn) => one.to[1], r: 3, stroke: SECOND, strokeWidth: 1.6, fill: PAPER }),
  ];
}

function vectorsOf(places: Place[], key: "error_m" | "linear_m", magnification: number, axes: number[]): Drawn[] {
  return places.flatMap(({ points, at, commanded }) => {
    const error = points[key][at];
    if (!error) return [];
    const from = axes.map((axis) => commanded[axis] as number);
    return [{ from, to: axes.map((axis, k) => (from[k] as number) + magnification * (error[axis] ?? 0)) }];
  });
}
