// Where errors occur: samples in a plane of the workspace, with the box of the fit's poses. Size and colour both grow with the error.
import * as Plot from "@observablehq/plot";
import { choice, type Option } from "../controls";
import type { SampleErrors, ReportData } from "../data";
import { type Vector, axesOf } from "../robot";
import type { Draw, Figure } from "../figure";
import { finite, quantile, significant } from "../number";
import { models } from "./quantities";
import { BAD, INK, MUTED, STEPS, degrees, frame, mm } from "./style";

/** A projection of positions. */
export interface View {
  names: [string, string];
  first: Vector;
  second: Vector;
}

interface Quantity {
  words: string;
  unit: string;
  of(errors: SampleErrors, row: number): number;
}

interface Sample {
  x: number;
  y: number;
  error: number;
  number: number;
  outside: boolean;
  aside: boolean;
}

/** The plane of a planar robot; x–y, x–z and y–z of a spatial one. */
export function views(data: ReportData): Option<View>[] {
  const axes = axesOf(data.robot);
  const along = (a: number, b: number): View => {
    const [across, up] = [axes[a], axes[b]] as [(typeof axes)[number], (typeof axes)[number]];
    return { names: [across.name, up.name], first: across.direction, second: up.direction };
  };
  if (data.robot.plane) return [{ label: data.robot.axes.join("–"), value: along(0, 1) }];
  return ([[0, 1], [0, 2], [1, 2]] as const).map(([a, b]) => {
    const value = along(a, b);
    return { label: `${value.names.join("–")} (${["top", "front", "side"][a + b - 1]} view)`, value };
  });
}

/** The chart; both axes to one scale. */
export function map(data: ReportData, figure: Figure): Draw | null {
  const samples = data.samples;
  if (samples.number.length === 0) return null;
  const quantity = choice(figure.controls, "Show", quantities(data), figure.redraw);
  const view = choice(figure.controls, "in", views(data), figure.redraw);
  const model = choice(figure.controls, "of", models(data), figure.redraw);
  return (width) => {
    const { names, first, second } = view();
    const { words, unit, of } = quantity();
    const points: Sample[] = samples.position_m.map((position, row) => ({
      x: dot(position, first),
      y: dot(position, second),
      error: of(model(), row),
      number: samples.number[row] ?? 0,
      outside: samples.outside[row] ?? false,
      aside: samples.set_aside[row] ?? false,
    }));
    const known = points.filter((point) => Number.isFinite(point.error)).sort((a, b) => a.error - b.error);
    const [drawn, aside] = [known.filter((point) => !point.aside), known.filter((point) => point.aside)];
    const top = topOf(drawn.map((point) => point.error));
    const fit = data.fit_position_m.map((position) => [dot(position, first), dot(position, second)] as [number, number]);
    const box = boxOf(fit);
    const many = drawn.length > 400;
    const limits = STEPS.slice(1).map((_, index) => ((index + 1) * top) / STEPS.length);
    const bounds = boxOf([...known.map((point) => [point.x, point.y] as [number, number]), ...fit]);
    return Plot.plot(
      frame(fitting(width, bounds), {
        aspectRatio: 1,
        marginTop: 18,
        x: { label: `${names[0]}, m`, labelAnchor: "center", labelArrow: "none", grid: true, nice: true, inset: 10 },
        y: { label: `${names[1]}, m`, labelArrow: "none", grid: true, nice: true, inset: 10 },
        color: { type: "threshold", domain: limits, range: STEPS, legend: true, label: `${words}, ${unit}`, tickFormat: (value: number) => significant(value, 2) },
        r: { domain: [0, top], range: many ? [1.5, 6] : [2.5, 9], clamp: true },
        symbol: { domain: ["inside", "outside"], range: ["circle", "square"] },
        marks: [
          box ? Plot.rect([box], { x1: "x1", x2: "x2", y1: "y1", y2: "y2", stroke: MUTED, strokeDasharray: "6 4", fill: "none" }) : null,
          Plot.dot(thinned(fit), { x: "0", y: "1", symbol: "plus", r: 3, stroke: MUTED, strokeOpacity: 0.7, strokeWidth: 1 }),
          Plot.dot(drawn, { x: "x", y: "y", fill: "error", r: "error", symbol: (point: Sample) => (point.outside ? "outside" : "inside"), stroke: INK, strokeOpacity: many ? 0.2 : 0.55, strokeWidth: many ? 0.3 : 0.6 }),
          Plot.dot(aside, { x: "x", y: "y", symbol: "times", r: 4, stroke: BAD, strokeWidth: 2 }),
          Plot.tip([...drawn, ...aside], Plot.pointer({ x: "x", y: "y", title: (point: Sample) => `sample ${point.number}\n${words} ${significant(point.error, 3)} ${unit}${point.outside ? "\noutside the poses of the fit" : ""}${point.aside ? "\nset aside: no candidate explains it" : ""}` })),
        ],
      }),
    );
  };
}

/** Tallest plot (pixels): the whole map stands beside the ladder. */
const TALLEST = 270;

/** A width of the drawing at which the plot, both axes to one scale, is not too tall. */
function fitting(width: number, bounds: ReturnType<typeof boxOf>): number {
  if (!bounds) return Math.min(width, 720);
  const [across, up] = [bounds.x2 - bounds.x1, bounds.y2 - bounds.y1];
  // margins beside the plot; axes reach to round numbers
  return Math.max(260, Math.min(width, 720, 82 + TALLEST * Math.min(20, (across || 1e-9) / (up || 1e-9))));
}

function quantities(data: ReportData): Option<Quantity>[] {
  const position: Quantity = { words: "position error", unit: "mm", of: (errors, row) => lengthOf(errors.position_error_m[row]) };
  const rotation: Quantity = { words: "rotation error", unit: "°", of: (errors, row) => degrees(errors.rotation_error_rad[row]) };
  const length: Quantity = { words: "length error (rms over cables)", unit: "mm", of: (errors, row) => mm(rms(finite(errors.length_error_m[row] ?? []))) };
  const tension: Quantity = { words: "tension error (rms over cables)", unit: "N", of: (errors, row) => rms(finite(errors.tension_error_N?.[row] ?? [])) };
  const all = [position, ...(data.robot.turns ? [rotation] : []), length, ...(data.samples.calibrated.tension_error_N ? [tension] : [])];
  // samples whose poses nobody measured have no errors of poses
  const rows = data.samples.number.map((_, row) => row);
  const told = all.filter(({ of }) => models(data).some(({ value }) => rows.some((row) => Number.isFinite(of(value, row)))));
  return (told.length > 0 ? told : all).map((value) => ({ label: value.words, value }));
}

function lengthOf(vector: Vector | null | undefined): number {
  return vector ? mm(Math.hypot(...vector)) : Number.NaN;
}

function rms(values: number[]): number {
  return values.length === 0 ? Number.NaN : Math.sqrt(values.reduce((sum, value) => sum + value * value, 0) / values.length);
}

/** The largest error, unless few outliers would leave one colour to all others: then three times the 95 % quantile. */
export function topOf(errors: number[]): number {
  const sorted = [...errors].sort((a, b) => a - b);
  const [largest, p95] = [sorted[sorted.length - 1] ?? 1, quantile(sorted, 0.95)];
  return (largest > 3 * p95 && p95 > 0 ? 3 * p95 : largest) || 1;
}

function boxOf(points: [number, number][]): { x1: number; x2: number; y1: number; y2: number } | null {
  if (points.length === 0) return null;
  const [x, y] = [points.map((point) => point[0]), points.map((point) => point[1])];
  return { x1: Math.min(...x), x2: Math.max(...x), y1: Math.min(...y), y2: Math.max(...y) };
}

function thinned<T>(list: T[]): T[] {
  const step = Math.ceil(list.length / 400);
  return list.filter((_, index) => index % step === 0);
}

function dot(a: Vector, b: Vector): number {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
