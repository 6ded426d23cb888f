// How residuals and errors are distributed: histogram, and quantiles against those of a normal distribution.
import { cableLabel } from "../robot";
import * as Plot from "@observablehq/plot";
import { choice, element, type Option } from "../controls";
import type { SampleErrors, ReportData } from "../data";
import type { Draw, Figure } from "../figure";
import { finite, meanWords, quantile, tick } from "../number";
import { models, residuals } from "./quantities";
import { ACCENT, BAD, MUTED, degrees, frame, mm } from "./style";

interface Quantity {
  label: string;
  unit: string;
  values(errors: SampleErrors): number[];
  /** True for magnitudes, which no normal distribution has. */
  magnitude: boolean;
}

/** Histogram and Q–Q side by side, or one below the other. */
export function distribution(data: ReportData, figure: Figure): Draw | null {
  if (data.samples.number.length < 2) return null;
  const quantity = choice(figure.controls, "Distribution of", options(data), figure.redraw);
  const model = choice(figure.controls, "of the model", models(data), figure.redraw);
  return (width) => {
    const chosen = quantity();
    const values = finite(chosen.values(model())).sort((a, b) => a - b);
    const grid = element("div", "", "panels");
    if (values.length < 2) {
      grid.append(element("p", "This model has no such values."));
      return grid;
    }
    const both = !chosen.magnitude;
    const columns = both && width > 560 ? 2 : 1;
    grid.style.gridTemplateColumns = `repeat(${columns}, minmax(0, 1fr))`;
    const each = Math.floor((width - 16 * (columns - 1)) / columns);
    grid.append(titled(`${values.length} values, mean ${meanWords(values)} ${chosen.unit}`, histogram(values, chosen, each)));
    if (both) grid.append(titled("against a normal distribution", quantiles(values, chosen, each)));
    return grid;
  };
}

function options(data: ReportData): Option<Quantity>[] {
  const rows = data.samples.number.map((_, row) => row).filter((row) => !data.samples.set_aside[row]);
  const cables = data.robot.cables;
  const found: Quantity[] = [];
  for (const { label, value } of residuals(data)) {
    const of = (chosen: number[]) => (errors: SampleErrors) => rows.flatMap((row) => chosen.map((cable) => value.of(errors, row, cable)));
    found.push({ label: `${label} residual, all cables`, unit: value.unit, magnitude: false, values: of(cables.map((_, index) => index)) });
    cables.forEach((_, index) => found.push({ label: `${label} residual, ${cableLabel(data.robot, index)}`, unit: value.unit, magnitude: false, values: of([index]) }));
  }
  const length = (errors: SampleErrors) => rows.map((row) => errors.position_error_m[row]).map((error) => (error ? mm(Math.hypot(...error)) : Number.NaN));
  found.push({ label: "position error", unit: "mm", magnitude: true, values: length });
  if (data.robot.turns) found.push({ label: "rotation error", unit: "°", magnitude: true, values: (errors) => rows.map((row) => degrees(errors.rotation_error_rad[row])) });
  // samples whose poses nobody measured have no errors of poses
  const told = found.filter(({ values }) => models(data).some(({ value }) => finite(values(value)).length > 0));
  return (told.length > 0 ? told : found).map((value) => ({ label: value.label, value }));
}

function titled(title: string, plot: Element): HTMLElement {
  const made = element("div");
  made.append(element("p", title, "panel-title"), plot);
  return made;
}

function histogram(values: number[], quantity: Quantity, width: number): Element {
  const bins = Math.max(6, Math.min(40, Math.ceil(2 * Math.cbrt(values.length))));
  return Plot.plot(
    frame(width, {
      height: 230,
      marginTop: 18,
      x: { tickFormat: tick, label: `${quantity.label}, ${quantity.unit}`, labelAnchor: "center", labelArrow: "none", ...(quantity.magnitude ? { zero: true } : {}) },
      y: { tickFormat: tick, label: "count", labelArrow: "none", grid: true },
      marks: [
        Plot.rectY(values, { ...Plot.binX({ y: "count" }, { x: { value: (value: number) => value, thresholds: bins } }), fill: ACCENT, fillOpacity: 0.65, inset: 0.5 }),
        Plot.ruleY([0], { stroke: MUTED }),
        Plot.ruleX([mean(values)], { stroke: BAD, strokeWidth: 2, strokeDasharray: "5 4" }),
      ],
    }),
  );
}

function quantiles(values: number[], quantity: Quantity, width: number): Element {
  const count = values.length;
  const step = Math.max(1, Math.floor(count / 600));
  const points = values
    .map((value, index) => ({ x: normalQuantile((index + 0.5) / count), y: value }))
    .filter((_, index) => index % step === 0 || index === count - 1);
  // the line through the quartiles: outliers do not turn it
  const [q1, q3] = [quantile(values, 0.25), quantile(values, 0.75)];
  const slope = (q3 - q1) / (2 * 0.67449);
  const middle = 0.5 * (q1 + q3);
  const edge = normalQuantile(0.5 / count);
  return Plot.plot(
    frame(width, {
      height: 230,
      marginTop: 18,
      x: { label: "quantile of the normal distribution (σ)", labelAnchor: "center", labelArrow: "none", ticks: 7 },
      y: { label: `residual, ${quantity.unit}`, labelArrow: "none", grid: true },
      marks: [
        Plot.line([edge, -edge], { x: (x: number) => x, y: (x: number) => middle + slope * x, stroke: BAD, strokeWidth: 1.5, strokeDasharray: "5 4" }),
        Plot.dot(points, { x: "x", y: "y", r: 2, fill: ACCENT }),
      ],
    }),
  );
}

function mean(values: number[]): number {
  return values.reduce((sum, value) => sum + value, 0) / values.length;
}

/** Quantile of the standard normal distribution (Acklam 2003; relative error below 1.2e-9). */
export function normalQuantile(p: number): number {
  if (p > 0.5) return -normalQuantile(1 - p);
  if (p < 0.02425) {
    const q = Math.sqrt(-2 * Math.log(p));
    return polynomial(q, [-0.007784894002430293, -0.3223964580411365, -2.400758277161838, -2.549732539343734, 4.374664141464968, 2.938163982698783])
      / polynomial(q, [0.007784695709041462, 0.3224671290700398, 2.445134137142996, 3.754408661907416, 1]);
  }
  const q = p - 0.5;
  const r = q * q;
  return (q * polynomial(r, [-39.69683028665376, 220.9460984245205, -275.9285104469687, 138.357751867269, -30.66479806614716, 2.506628277459239]))
    / polynomial(r, [-54.47609879822406, 161.5858368580409, -155.6989798598866, 66.80131188771972, -13.28068155288572, 1]);
}

function polynomial(x: number, coefficients: number[]): number {
  return coefficients.reduce((sum, coefficient) => sum * x + coefficient, 0);
}
