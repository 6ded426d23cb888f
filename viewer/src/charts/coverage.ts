// What the poses of the fit cover, and how far the model was judged: one bar for each component of the pose.
import * as Plot from "@observablehq/plot";
import type { ReportData, PoseRange } from "../data";
import type { Draw } from "../figure";
import { significant } from "../number";
import { element } from "../controls";
import { ACCENT, BAD, frame } from "./style";

/** Positions and angles have their own scales. */
export function coverage(data: ReportData): Draw | null {
  const ranges = data.result.coverage.ranges;
  if (ranges.length === 0) return null;
  return (width) => {
    const grid = element("div", "", "panels");
    const groups = [part(ranges, "m", 1, "m"), part(ranges, "rad", 180 / Math.PI, "°")].filter((group) => group.ranges.length > 0);
    const columns = groups.length > 1 && width > 560 ? 2 : 1;
    grid.style.gridTemplateColumns = `repeat(${columns}, minmax(0, 1fr))`;
    const each = Math.floor((width - 16 * (columns - 1)) / columns);
    for (const group of groups) grid.append(bars(group, each));
    return grid;
  };
}

/** Ends of a component; NaN where there are no samples. */
interface Ends {
  name: string;
  fit_min: number;
  fit_max: number;
  validation_min: number;
  validation_max: number;
}

interface Group {
  unit: string;
  ranges: Ends[];
}

function part(ranges: PoseRange[], unit: string, factor: number, shown: string): Group {
  const scaled = (value: number | null) => factor * (value ?? Number.NaN);
  const own = ranges.filter((range) => range.unit === unit).map((range) => ({
    name: range.name,
    fit_min: scaled(range.fit_min),
    fit_max: scaled(range.fit_max),
    validation_min: scaled(range.validation_min),
    validation_max: scaled(range.validation_max),
  }));
  return { unit: shown, ranges: own };
}

function bars({ unit, ranges }: Group, width: number): Element {
  const beyond = ranges.flatMap((range) => [
    ...(range.validation_min < range.fit_min ? [{ name: range.name, x: range.validation_min }] : []),
    ...(range.validation_max > range.fit_max ? [{ name: range.name, x: range.validation_max }] : []),
  ]);
  return Plot.plot(
    frame(width, {
      height: 40 * ranges.length + 60,
      marginTop: 8,
      marginLeft: 52,
      x: { label: unit === "m" ? "position, m" : "rotation, °", labelAnchor: "center", labelArrow: "none", grid: true, nice: true, ticks: 6 },
      y: { type: "band", domain: ranges.map((range) => range.name), label: null, padding: 0.35, tickSize: 0 },
      marks: [
        Plot.barX(ranges, { y: "name", x1: "fit_min", x2: "fit_max", fill: ACCENT, fillOpacity: 0.35 }),
        Plot.ruleY(ranges, { y: "name", x1: "validation_min", x2: "validation_max", stroke: "var(--ink)", strokeWidth: 3 }),
        Plot.dot(beyond, { x: "x", y: "name", symbol: "times", r: 5, stroke: BAD, strokeWidth: 2.5 }),
        Plot.tip(ranges, Plot.pointerY({ y: "name", x: "fit_max", title: (range: Ends) => words(range, unit) })),
      ],
    }),
  );
}

function words(range: Ends, unit: string): string {
  const of = (low: number, high: number) => `${significant(low, 3)} … ${significant(high, 3)} ${unit}`;
  return `${range.name}\nfit ${of(range.fit_min, range.fit_max)}\nvalidation ${of(range.validation_min, range.validation_max)}`;
}
