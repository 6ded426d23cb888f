// Residuals of every cable as small multiples on one scale.
import { cableLabel } from "../robot";
import * as Plot from "@observablehq/plot";
import { choice, element } from "../controls";
import type { ReportData } from "../data";
import type { Draw, Figure } from "../figure";
import { finite, meanWords, quantile, significant, tick } from "../number";
import { abscissae, models, residuals as quantities } from "./quantities";
import { BAD, MUTED, frame, symmetric } from "./style";

interface Point {
  x: number;
  y: number;
}

/** One panel for each cable; quantity, model and abscissa can be chosen. */
export function residuals(data: ReportData, figure: Figure): Draw | null {
  if (data.samples.number.length === 0) return null;
  const quantity = choice(figure.controls, "Residual of", quantities(data), figure.redraw);
  const against = choice(figure.controls, "against", abscissae(data), figure.redraw);
  const model = choice(figure.controls, "of the model", models(data), figure.redraw);
  return (width) => {
    const rows = data.samples.number.map((_, row) => row);
    const series = data.robot.cables.map((_, cable) =>
      rows.map((row): Point => ({ x: against().of(row, cable), y: quantity().of(model(), row, cable) })).filter(isFinitePoint),
    );
    // the scale is that of the samples that count; what was set aside lies on its edge
    const counted = rows.filter((row) => !data.samples.set_aside[row]);
    const domain = symmetric(finite(data.robot.cables.flatMap((_, cable) => counted.map((row) => quantity().of(model(), row, cable)))));
    const columns = width > 560 ? 2 : 1;
    const grid = element("div", "", "panels");
    grid.style.gridTemplateColumns = `repeat(${columns}, minmax(0, 1fr))`;
    const each = Math.floor((width - 16 * (columns - 1)) / columns);
    series.forEach((points, cable) => {
      grid.append(panel(each, cableLabel(data.robot, cable), points, domain, {
        x: against().label,
        y: `residual, ${quantity().unit}`,
        unit: quantity().unit,
        direction: against().direction,
      }));
    });
    return grid;
  };
}

interface Labels {
  x: string;
  y: string;
  unit: string;
  direction: boolean;
}

function panel(width: number, name: string, points: Point[], domain: [number, number], labels: Labels): HTMLElement {
  const made = element("div");
  made.append(element("p", `${name}: ${words(points, labels)}`, "panel-title"));
  const radius = points.length > 400 ? 1.2 : 2.2;
  made.append(
    Plot.plot(
      frame(width, {
        height: 170,
        marginTop: 18,
        x: { label: labels.x, tickFormat: tick, labelAnchor: "center", labelArrow: "none", ticks: Math.max(3, Math.floor(width / 80)), nice: !labels.direction, ...(labels.direction ? { domain: motionDomain(points) , clamp: true } : {}) },
        y: { domain, clamp: true, tickFormat: tick, label: labels.y, labelArrow: "none", grid: true, ticks: 5 },
        marks: [
          Plot.ruleY([0], { stroke: MUTED }),
          labels.direction ? Plot.ruleX([0], { stroke: MUTED, strokeDasharray: "2 3" }) : null,
          specks(points, radius),
          labels.direction ? means(points) : null,
        ],
      }),
    ),
  );
  return made;
}

/** All points as one path: thousands of them stay quick. */
function specks(points: Point[], radius: number): Plot.Markish {
  return Plot.dot(points, {
    x: "x",
    y: "y",
    r: radius,
    render(index, _scales, values) {
      const path = document.createElementNS("http://www.w3.org/2000/svg", "path");
      const [x, y] = [values.x as ArrayLike<number>, values.y as ArrayLike<number>];
      path.setAttribute("d", Array.from(index, (i) => `M${(x[i] as number).toFixed(1)},${(y[i] as number).toFixed(1)}h0`).join(""));
      path.setAttribute("class", "specks");
      path.setAttribute("stroke-width", String(2 * radius));
      path.setAttribute("data-points", String(index.length));
      return path;
    },
  });
}

/** Mean residual while reeling in and while paying out: friction and backlash show as a step between them. */
function means(points: Point[]): Plot.Markish {
  const [least, most] = motionDomain(points);
  const of = (part: Point[], x1: number, x2: number) =>
    part.length === 0 ? [] : [{ x1, x2, y: part.reduce((sum, point) => sum + point.y, 0) / part.length }];
  const lines = [...of(points.filter((p) => p.x < 0), least, 0), ...of(points.filter((p) => p.x > 0), 0, most)];
  return Plot.ruleY(lines, { y: "y", x1: "x1", x2: "x2", stroke: BAD, strokeWidth: 2 });
}

/** 98 % of the changes: a jump between two recordings would hide them. */
function motionDomain(points: Point[]): [number, number] {
  const sizes = points.map((point) => Math.abs(point.x)).sort((a, b) => a - b);
  const most = quantile(sizes, 0.98) || sizes[sizes.length - 1] || 1;
  return [-most, most];
}

function words(points: Point[], labels: Labels): string {
  const values = finite(points.map((point) => point.y));
  if (values.length === 0) return "no values";
  const rms = Math.sqrt(values.reduce((sum, value) => sum + value * value, 0) / values.length);
  if (!labels.direction) return `mean ${meanWords(values)} ${labels.unit}, rms ${significant(rms, 3)} ${labels.unit}`;
  const side = (part: Point[]) => meanWords(part.map((point) => point.y));
  return `mean ${side(points.filter((p) => p.x < 0))} ${labels.unit} reeling in, ${side(points.filter((p) => p.x > 0))} ${labels.unit} paying out`;
}

function isFinitePoint(point: Point): boolean {
  return Number.isFinite(point.x) && Number.isFinite(point.y);
}

