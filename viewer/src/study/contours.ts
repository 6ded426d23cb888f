// Contours through values on a regular grid, with their values written beside the lines.
import * as Plot from "@observablehq/plot";
import { tick } from "../number";
import { drawn } from "../workspace/svg";
import type { Look } from "./layers";
import type { Nodes } from "../data";

/** A regular grid of numbers; NaN where there is none. */
export interface Raster {
  axes: [Nodes, Nodes];
  values: number[];
}

/** The ends of a grid along an axis (m). */
export function ends({ start_m, step_m, count }: Nodes): [number, number] {
  return [start_m, start_m + (count - 1) * step_m];
}

/** Lines at these levels. Contours close at the edge of their values, which are therefore repeated beyond the box. */
export function contourLines(raster: Raster, levels: number[], look: Look, name: string): Plot.Markish {
  const { stroke, width: strokeWidth, dashes: strokeDasharray } = look;
  return Plot.contour(padded(raster), { ...placed(raster), thresholds: levels as never, fill: "none", stroke, strokeWidth, strokeDasharray, ariaDescription: name });
}

/** Covers what a margin below zero leaves out, so that the rest stands out. */
export function veil(raster: Raster): Plot.Markish {
  const outside = padded(raster).map((margin) => (Number.isFinite(margin) ? -margin : 1e9));
  return Plot.contour(outside, { ...placed(raster), thresholds: [1e-12] as never, fill: "var(--paper)", fillOpacity: 0.5, stroke: "none" });
}

/** Bands between these levels, and what lies below and above them; nothing where there is no value. */
export function contourBands(raster: Raster, levels: number[]): Plot.Markish {
  return Plot.contour(padded(raster), { ...placed(raster), thresholds: [Number.NEGATIVE_INFINITY, ...levels].map((level) => Math.max(level, -1e300)) as never, fill: Plot.identity as never, fillOpacity: 0.75, stroke: "none" });
}

/** Plot takes values as middles of cells. */
function placed({ axes: [across, up] }: Raster): object {
  const [[left, right], [bottom, top]] = [ends(across), ends(up)];
  return {
    width: across.count + 2,
    height: up.count + 2,
    x1: left - 1.5 * across.step_m,
    x2: right + 1.5 * across.step_m,
    y1: bottom - 1.5 * up.step_m,
    y2: top + 1.5 * up.step_m,
  };
}

function padded({ axes: [across, up], values }: Raster): number[] {
  const within = (index: number, count: number) => Math.max(0, Math.min(count - 1, index));
  const all: number[] = [];
  for (let row = -1; row <= up.count; row++) {
    for (let column = -1; column <= across.count; column++) all.push(values[within(row, up.count) * across.count + within(column, across.count)] ?? Number.NaN);
  }
  return all;
}

/** Round levels, about `count` of them up to the 95 % quantile of the values. */
export function levelsOf(values: number[], count: number): number[] {
  const sorted = values.filter(Number.isFinite).sort((a, b) => a - b);
  if (sorted.length === 0) return [];
  const at = (p: number) => sorted[Math.floor(p * (sorted.length - 1))] as number;
  const [low, high] = [at(0.02), at(0.95)];
  // values that reach down to nothing are counted from nothing
  const from = low < 0.5 * high ? 0 : low;
  const step = roundStep((high - from) / count) || roundStep(Math.abs(high) / count) || 1;
  const first = Math.floor(from / step) + 1;
  return Array.from({ length: count }, (_, k) => Number(((first + k) * step).toPrecision(10))).filter((level) => level < (sorted.at(-1) as number));
}

/** The nearest round number that is not smaller. */
export function roundStep(raw: number): number {
  if (!(raw > 0) || !Number.isFinite(raw)) return 0;
  const power = 10 ** Math.floor(Math.log10(raw));
  return ([1, 1.5, 2, 2.5, 3, 4, 5, 6, 8, 10].find((candidate) => candidate * power >= raw * 0.999) ?? 10) * power;
}

type Pixel = [number, number];

/** Contour lines whose values are to be written. */
export interface Labelled {
  name: string;
  levels: number[];
  unit: string;
  colour: string;
}

/** Writes the values of contours into a drawing, clear of each other, of the edge of `box` (pixels) and of where they are not wanted. */
export function writeValues(drawing: SVGSVGElement, lines: Labelled[], box: Box, isWanted: (x: number, y: number) => boolean): void {
  const layer = drawn("g", {});
  const taken: Pixel[] = [];
  for (const { name, levels, unit, colour } of lines) {
    const paths = [...drawing.querySelectorAll(`[aria-description="${name}"] path`)];
    paths.forEach((path, index) => {
      const places = ringsOf(path.getAttribute("d") ?? "").flatMap((ring) => labelPlaces(ring.filter(([x, y]) => isWanted(x, y)), taken, box));
      for (const at of places) {
        layer.append(drawn("text", { x: at[0], y: at[1], fill: colour, class: "contour-value" }, `${tick(levels[index] as number)} ${unit}`.replace(" °", "°")));
      }
    });
  }
  const tips = drawing.querySelector('[aria-label="tip"]');
  if (tips) tips.before(layer);
  else drawing.append(layer);
}

function ringsOf(path: string): Pixel[][] {
  return path.split("M").slice(1).map((ring) => ring.replace("Z", "").split("L").map((point) => point.split(",").map(Number) as Pixel));
}

interface Box {
  left: number;
  right: number;
  top: number;
  bottom: number;
}

/** Points of a line that lie clear of other labels, as many as its length needs; they are added to `taken`. */
function labelPlaces(ring: Pixel[], taken: Pixel[], box: Box): Pixel[] {
  const inside = ring.filter(([x, y]) => x > box.left + 26 && x < box.right - 26 && y > box.top + 10 && y < box.bottom - 10);
  const found: Pixel[] = [];
  const wanted = Math.min(4, Math.floor(lengthOf(inside) / 320) + 1);
  while (found.length < wanted) {
    const at = clearest(inside, taken, found);
    if (!at) break;
    found.push(at);
    taken.push(at);
  }
  return found;
}

/** Length of a line (pixels); jumps over what was left out do not count. */
function lengthOf(points: Pixel[]): number {
  const steps = points.slice(1).map(([x, y], k) => Math.hypot(x - (points[k] as Pixel)[0], y - (points[k] as Pixel)[1]));
  return steps.filter((step) => step < 60).reduce((sum, step) => sum + step, 0);
}

/** The point of a line that is farthest from labels; null where none is far enough or the line is short. */
function clearest(points: Pixel[], taken: Pixel[], own: Pixel[]): Pixel | null {
  if (lengthOf(points) < 45) return null;
  // labels are wider than high; equal ones need not stand near each other
  const apart = ([x, y]: Pixel, others: Pixel[], most: number) => others.reduce((least, [left, top]) => Math.min(least, Math.hypot(0.5 * (x - left), y - top)), most);
  const clear = points.filter((point) => apart(point, taken, 400) > 24 && apart(point, own, 400) > 90);
  const score = (point: Pixel) => apart(point, taken, 200);
  return clear.length > 0 ? clear.reduce((a, b) => (score(b) > score(a) ? b : a)) : null;
}
