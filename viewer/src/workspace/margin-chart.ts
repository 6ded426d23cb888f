// The margin in a plane of the grid as contours, or the cable that limits, with the areas that were found: the drawing that the platform
// moves on.
import * as Plot from "@observablehq/plot";
import { INK, LINE, MUTED, frame } from "../charts/style";
import { significant } from "../number";
import { cableColour } from "./colouring";
import type { Grid, WorkspaceData } from "../data";
import { marginOf } from "./field";
import { patchesOfPlane } from "./patches";
import { cableName } from "./platform";
import type { ShownRegion } from "./regions";
import { drawn } from "./svg";

/** A plane of the grid: two of its axes, and the layer along the third. */
export interface Plane {
  across: number;
  up: number;
  /** Node along each axis; only that of the third counts. */
  layer: number[];
}

/** What the colours of a plane stand for. */
export type PlaneColouring = "margin" | "cable";

/** A chart and its scales. */
export interface MarginChart {
  whole: SVGSVGElement | HTMLElement;
  drawing: SVGSVGElement;
  /** From metres to pixels of the drawing. */
  x: Plot.Scale;
  y: Plot.Scale;
}

/** Colours of the bands between seven levels. */
export const SHADES = ["n4", "n3", "n2", "n1", "1", "2", "3", "4"].map((name) => `var(--diverging-${name})`);

/** Patches smaller than this share of the plane bear no name. */
const NAMED_PATCH = 0.015;

/** Contours of the margin, or cells in the colour of the cable that limits; where the margin fails there is a hatch too, and the limit is a
 * thick line. `also` must be seen as well. */
export function marginChart(data: WorkspaceData, plane: Plane, regions: ShownRegion[], also: [number, number][], width: number, colouring: PlaneColouring): MarginChart {
  const { grid, margin_unit, result } = data;
  const [across, up] = [axisOf(grid, plane.across), axisOf(grid, plane.up)];
  const values = layerOf(grid, plane);
  const levels = levelsOf(values);
  const lowest = Math.min(...values, levels[0] ?? 0) - 1;
  const box = { left: across.start_m, right: endOf(across), bottom: up.start_m, top: endOf(up) };
  // contours close at the edge of their values, which are therefore repeated beyond the box; Plot takes them as middles of cells
  const size = { width: across.count + 2, height: up.count + 2, x1: box.left - 1.5 * across.step_m, x2: box.right + 1.5 * across.step_m, y1: box.bottom - 1.5 * up.step_m, y2: box.top + 1.5 * up.step_m };
  const outlines = regions.filter((one) => one.shown).flatMap((one) => one.region.outlines_m.map((points) => ({ one, points: [...points, points[0] as [number, number]] })));
  const hatch = `hatch-${plane.across}${plane.up}`;
  const whole = Plot.plot(
    frame(width, {
      aspectRatio: 1,
      marginTop: 22,
      x: { label: `${across.name}, m`, labelAnchor: "center", labelArrow: "none", inset: 12, domain: extent([box.left, box.right, ...also.map((point) => point[0])]) },
      y: { label: `${up.name}, m`, labelArrow: "none", inset: 12, domain: extent([box.bottom, box.top, ...also.map((point) => point[1])]) },
      color: colouring === "cable" ? cableLegend(data, plane) : { type: "threshold", domain: levels, range: SHADES, legend: true, ...{ width: Math.min(width, 380) }, label: `margin of ${result.criterion}${margin_unit ? `, ${margin_unit}` : ""}`, tickFormat: (value: number) => significant(value, 2) },
      marks: [
        ...(colouring === "cable" ? cableCells(data, plane) : [Plot.contour(values, { ...size, fill: Plot.identity as never, thresholds: [lowest, ...levels] as never, stroke: "none" })]),
        Plot.contour(values.map((value) => -value), { ...size, thresholds: [1e-12] as never, fill: `url(#${hatch})`, stroke: "none" }),
        Plot.contour(values, { ...size, thresholds: [0] as never, fill: "none", stroke: INK, strokeWidth: 2 }),
        Plot.gridX({ stroke: LINE, strokeOpacity: 0.5 }),
        Plot.gridY({ stroke: LINE, strokeOpacity: 0.5 }),
        ...(colouring === "cable" ? cableNames(data, plane) : []),
        ...outlines.map(({ one, points }) => Plot.line(points, { stroke: `var(--${one.colour})`, strokeWidth: 3, strokeDasharray: one.dashes, clip: true })),
      ],
    }),
  );
  const drawing = whole instanceof SVGSVGElement ? whole : ([...whole.querySelectorAll("svg")].at(-1) as SVGSVGElement);
  const [x, y] = [whole.scale("x") as Plot.Scale, whole.scale("y") as Plot.Scale];
  drawing.prepend(definitions(hatch, { x: x.apply(box.left), y: y.apply(box.top), width: x.apply(box.right) - x.apply(box.left), height: y.apply(box.bottom) - y.apply(box.top) }));
  for (const contours of drawing.querySelectorAll('[aria-label="contour"]')) contours.setAttribute("clip-path", `url(#${hatch}-box)`);
  return { whole, drawing, x, y };
}

/** True where some node of the grid has a cable that limits it. */
export function knowsCables({ grid }: WorkspaceData): boolean {
  return grid.cable.some((cable) => cable >= 0);
}

/** The cables that limit nodes of a plane, with their names and colours. */
function cableLegend(data: WorkspaceData, plane: Plane): Plot.ScaleOptions & { legend: boolean } {
  const numbers = [...new Set(nodesOf(data.grid, plane).map((node) => data.grid.cable[node] as number))].sort((a, b) => a - b);
  return { type: "ordinal", domain: numbers, range: numbers.map((cable) => cableColour(cable + 1)), legend: true, label: "limiting cable", tickFormat: (cable: number) => (cable < 0 ? "none" : `limited by cable ${cableName(data, cable)}`) };
}

/** The nodes of a plane as cells in the colour of their cable. */
function cableCells({ grid }: WorkspaceData, plane: Plane): Plot.Markish[] {
  const [across, up] = [axisOf(grid, plane.across), axisOf(grid, plane.up)];
  const edges = (axis: Grid["axes"][number], index: number) => [Math.max(index - 0.5, 0), Math.min(index + 0.5, axis.count - 1)].map((place) => axis.start_m + place * axis.step_m) as [number, number];
  const cells = nodesOf(grid, plane).map((node, at) => ({ cable: grid.cable[node] as number, x: edges(across, at % across.count), y: edges(up, Math.floor(at / across.count)) }));
  return [Plot.rect(cells, { x1: (cell) => cell.x[0], x2: (cell) => cell.x[1], y1: (cell) => cell.y[0], y2: (cell) => cell.y[1], fill: (cell) => cell.cable, fillOpacity: 0.6, shapeRendering: "crispEdges", ariaDescription: "limiting cables" })];
}

/** The name of its cable upon each patch that is large enough. */
function cableNames(data: WorkspaceData, plane: Plane): Plot.Markish[] {
  const { grid } = data;
  const [across, up] = [axisOf(grid, plane.across), axisOf(grid, plane.up)];
  const cables = nodesOf(grid, plane).map((node) => grid.cable[node] as number);
  const named = patchesOfPlane(cables, across.count).filter(({ cable, cells }) => cable >= 0 && cells.length > NAMED_PATCH * cables.length);
  return [Plot.text(named, { x: ({ middle }) => across.start_m + (middle % across.count) * across.step_m, y: ({ middle }) => up.start_m + Math.floor(middle / across.count) * up.step_m, text: ({ cable }) => cableName(data, cable), fontSize: 16, fontWeight: 600, fill: INK, stroke: "var(--paper)", strokeWidth: 4, ariaDescription: "names of limiting cables" })];
}

/** The nodes of a plane, row by row from below. */
function nodesOf(grid: Grid, plane: Plane): number[] {
  const strides = grid.axes.map((_, k) => grid.axes.slice(0, k).reduce((product, axis) => product * axis.count, 1));
  const fixed = grid.axes.reduce((node, _, k) => (k === plane.across || k === plane.up ? node : node + (plane.layer[k] ?? 0) * (strides[k] as number)), 0);
  const [across, up] = [axisOf(grid, plane.across), axisOf(grid, plane.up)];
  const place = (at: number) => fixed + (at % across.count) * (strides[plane.across] as number) + Math.floor(at / across.count) * (strides[plane.up] as number);
  return Array.from({ length: across.count * up.count }, (_, at) => place(at));
}

function endOf(axis: Grid["axes"][number]): number {
  return axis.start_m + (axis.count - 1) * axis.step_m;
}

function extent(values: number[]): [number, number] {
  return [values.reduce((a, b) => Math.min(a, b)), values.reduce((a, b) => Math.max(a, b))];
}

function axisOf(grid: Grid, k: number): Grid["axes"][number] {
  return grid.axes[k] as Grid["axes"][number];
}

/** The margins of the plane, row by row from below, those of the edge twice; −∞ as the worst of the others, which contours can be drawn between. */
function layerOf(grid: Grid, plane: Plane): number[] {
  const nodes = nodesOf(grid, plane);
  const [across, up] = [axisOf(grid, plane.across), axisOf(grid, plane.up)];
  const values: number[] = [];
  const within = (index: number, count: number) => Math.max(0, Math.min(count - 1, index));
  for (let line = -1; line <= up.count; line++) {
    for (let place = -1; place <= across.count; place++) {
      const [row, column] = [within(line, up.count), within(place, across.count)];
      values.push(marginOf(grid, nodes[row * across.count + column] as number));
    }
  }
  const worst = values.filter(Number.isFinite).reduce((a, b) => Math.min(a, b), -1);
  return values.map((value) => Math.max(value, worst));
}

/** Seven round levels around zero, fit for the margins that hold. */
export function levelsOf(values: number[]): number[] {
  const best = values.reduce((a, b) => Math.max(a, b), 0);
  const worst = values.reduce((a, b) => Math.min(a, b), 0);
  const target = (best > 0 ? best : -worst || 1) / 4;
  const power = 10 ** Math.floor(Math.log10(target));
  const step = ([5, 2, 1].find((candidate) => candidate * power <= target) ?? 1) * power;
  return [-3, -2, -1, 0, 1, 2, 3].map((k) => k * step);
}

/** The hatch of what fails, and the box that contours keep to. */
function definitions(name: string, box: Record<string, number>): SVGElement {
  const pattern = drawn("pattern", { id: name, width: 7, height: 7, patternUnits: "userSpaceOnUse", patternTransform: "rotate(45)" });
  pattern.append(drawn("line", { x1: 0, y1: 0, x2: 0, y2: 7, stroke: MUTED, "stroke-width": 1, "stroke-opacity": 0.55 }));
  const clip = drawn("clipPath", { id: `${name}-box` });
  clip.append(drawn("rect", box));
  const made = drawn("defs", {});
  made.append(pattern, clip);
  return made;
}
