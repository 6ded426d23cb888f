// The errors of a planar robot over its plane, of a spatial one over slices: contours, vectors, poses, workspaces and anchors, each a layer of its own.
import { alongAxes } from "../robot";
import * as Plot from "@observablehq/plot";
import { BAD, INK, LINE, PAPER, SECOND, STEPS, frame } from "../charts/style";
import { choice } from "../controls";
import type { Draw, Figure } from "../figure";
import { tick } from "../number";
import { drawn } from "../workspace/svg";
import { type Labelled, type Raster, contourBands, contourLines, ends, levelsOf, veil, writeValues } from "./contours";
import type { StudyData, StudyRegion } from "../data";
import { anchorMarks } from "./anchors";
import { type Layer, type Look, arrow, line, mark, offerLayers, pin } from "./layers";
import { type ErrorQuantity, LARGEST, type Place, type Quantity, RESIDUAL, SMALLEST, TRACKING, errorsOf, hasResiduals, hasTensions, poses, tracksForces, words } from "./quantities";
import { MAGNIFICATIONS, apart, exactVectors, fitting, linearVectors, magnificationWords } from "./vectors";

const EXACT: Look = { stroke: INK, width: 1, dashes: "none" };
const LINEAR: Look = { stroke: SECOND, width: 1.8, dashes: "8 4" };
const DIFFERENCE: Look = { stroke: "var(--region-4)", width: 2, dashes: "2 3" };
const LARGE: Look = { stroke: "var(--region-1)", width: 1.8, dashes: "12 3 2 3" };
const SMALL: Look = { stroke: "var(--region-1)", width: 1.6, dashes: "4 2 1 2 1 2" };
const TRACKED: Look = { stroke: "var(--region-2)", width: 1.8, dashes: "6 2 2 2" };
const RESIDUALS: Look = { stroke: "var(--region-4)", width: 1.6, dashes: "1 2" };
const PHYSICAL: Look = { stroke: INK, width: 3, dashes: "none" };
const REACHABLE: Look = { stroke: "var(--region-3)", width: 3.5, dashes: "10 5" };
const REACHED_LINEARLY: Look = { stroke: "var(--region-3)", width: 2, dashes: "3 3" };

/** More poses than this are drawn small, and vectors begin at grid points, which are fewer. */
const MANY = 300;
/** Poses nearer to a slice than this (m) lie on it. */
const NEAR_SLICE = 1e-3;
/** Vectors at the poses of a slice are kept shorter: they point in all directions, over the edge too. */
const IN_SPACE = 0.6;
/** Columns of vectors over a region. */
const VECTOR_COLUMNS = 17;

interface PlaneLayers {
  contours: { layer: Layer; look: Look; name: string; of(error: ErrorQuantity): Quantity }[];
  exact: Layer;
  linear: Layer;
  commanded: Layer;
  emerging: Layer;
  anchors: Layer;
  physical: Layer;
  reachable: Layer;
  reachedLinearly: Layer;
}

/** The drawing; null for a robot without regions. */
export function plane(data: StudyData, figure: Figure, tell: (words: string) => void): Draw | null {
  if (data.regions.length === 0) return null;
  const layers = layersOf(data);
  const errors = errorsOf(data);
  const region = choice(figure.controls, data.robot.plane ? "Region" : "Slice", data.regions.map((value) => ({ label: value.name, value })), figure.redraw);
  const error = choice(figure.controls, "Error", errors.map((value) => ({ label: value.words, value })), figure.redraw);
  const places = [{ label: "the poses", value: false }, { label: "grid points", value: true }];
  const isMany = data.samples.number.length > MANY || data.regions.some((one) => posesOn(data, one).length === 0);
  const at = choice(figure.controls, "Vectors at", isMany ? places.reverse() : places, figure.redraw);
  const magnified = choice(figure.controls, "Vectors magnified", MAGNIFICATIONS, figure.redraw);
  offerLayers(figure.controls, groups(data, layers), figure.redraw);
  return (width) => {
    const shown = region();
    const all = posesOn(data, shown);
    const vectors = at() ? thinned(data, shown) : all;
    const magnification = magnified() ?? fitting(vectors, at() ? spacing(shown) : (data.robot.plane ? 1 : IN_SPACE) * apart(all, data.robot.axes.length));
    tell(layers.exact.shown || layers.linear.shown ? magnificationWords(magnification) : "");
    return draw(data, { layers, region: shown, error: error(), poses: all, vectors, magnification, width });
  };
}

function layersOf(data: StudyData): PlaneLayers {
  const layer = (words: string, shown: boolean, picture: SVGElement[]): Layer => ({ words, shown, picture });
  const contour = (words: string, shown: boolean, look: Look, name: string, of: (error: ErrorQuantity) => Quantity) => ({ layer: layer(words, shown, line(look)), look, name, of });
  const tensions = hasTensions(data)
    ? [contour("largest tension, N", false, LARGE, "contours of the largest tension", () => LARGEST), contour("smallest tension, N", false, SMALL, "contours of the smallest tension", () => SMALLEST)]
    : [];
  const tracking = tracksForces(data) ? [contour("largest tension error, N", false, TRACKED, "contours of the largest tension error", () => TRACKING)] : [];
  const residuals = hasResiduals(data) ? [contour("residual force, N", false, RESIDUALS, "contours of the residual force", () => RESIDUAL)] : [];
  return {
    contours: [
      contour("exact error", true, EXACT, "contours of the exact error", (error) => error.exact),
      contour("error by one linear step", false, LINEAR, "contours of the linear error", (error) => error.linear),
      contour("difference of both", false, DIFFERENCE, "contours of the difference", (error) => error.difference),
      ...tensions,
      ...tracking,
      ...residuals,
    ],
    exact: layer("exact vectors", true, arrow()),
    linear: layer("vectors by one linear step", false, pin(SECOND)),
    commanded: layer("commanded poses", true, mark("ring")),
    emerging: layer("emerging poses", true, mark("point")),
    anchors: layer("frame anchors", data.robot.plane !== null, mark("square")),
    physical: layer("physical workspace", true, line(PHYSICAL)),
    reachable: layer("reachable workspace", true, line(REACHABLE)),
    reachedLinearly: layer("reachable by one linear step", false, line(REACHED_LINEARLY)),
  };
}

function groups(data: StudyData, layers: PlaneLayers): [string, Layer[]][] {
  const has = (key: "physical" | "reachable" | "linear") => data.regions.some((region) => region[key] !== null);
  return [
    ["Contours", layers.contours.map(({ layer }) => layer)],
    ["Error vectors", [layers.exact, layers.linear]],
    ["Poses and robot", [layers.commanded, layers.emerging, ...(data.robot.plane ? [layers.anchors] : [])]],
    ["Boundaries", [...(has("physical") ? [layers.physical] : []), ...(has("reachable") ? [layers.reachable] : []), ...(has("linear") ? [layers.reachedLinearly] : [])]],
  ];
}

interface Scene {
  layers: PlaneLayers;
  region: StudyRegion;
  error: ErrorQuantity;
  poses: Place[];
  vectors: Place[];
  magnification: number;
  width: number;
}

function draw(data: StudyData, scene: Scene): Node {
  const { layers, region, error, width } = scene;
  const [[left, right], [bottom, top]] = region.axes.map(ends) as [[number, number], [number, number]];
  const [first, second] = region.plane;
  const isWhole = data.robot.plane !== null && region === data.regions[0];
  const anchors = isWhole && layers.anchors.shown ? data.robot.cables.map((cable) => alongAxes(data.robot, cable.frame_anchor_m)) : [];
  const contours = layers.contours.filter(({ layer }) => layer.shown).map((one) => {
    const quantity = one.of(error);
    const raster = rasterOf(region, quantity);
    // both errors by the same levels, or they could not be compared
    const scale = quantity === error.linear ? error.exact : quantity;
    // and all slices
    const compared = data.robot.plane ? [region] : data.regions;
    return { ...one, quantity, raster, levels: levelsOf(compared.flatMap((other) => within(other, rasterOf(other, scale).values)), STEPS.length - 1) };
  });
  const bands = contours.find(({ look, levels }) => look === EXACT && levels.length > 0);
  const outlines = [{ one: layers.physical, look: PHYSICAL, margins: region.physical, name: "physical workspace" }, { one: layers.reachable, look: REACHABLE, margins: region.reachable, name: "reachable workspace" }, { one: layers.reachedLinearly, look: REACHED_LINEARLY, margins: region.linear, name: "reachable by one linear step" }];
  const isInside = (position: number[]) => [[left, right], [bottom, top]].every(([low, high], k) => (position[region.plane[k] as number] ?? 0) >= (low as number) && (position[region.plane[k] as number] ?? 0) <= (high as number));
  const visible = scene.poses.filter(({ commanded }) => isInside(commanded));
  const tipped = [...visible, ...gridPlaces(region)];
  const size = visible.length > MANY ? 0.5 : 1;
  const whole = Plot.plot(
    frame(Math.min(width, data.robot.plane ? 1000 : 760), {
      aspectRatio: 1,
      marginTop: 26,
      x: { label: `${data.robot.axes[first]}, m`, labelAnchor: "center", labelArrow: "none", ticks: 10, inset: 12, domain: extent([left, right, ...anchors.map((anchor) => anchor[0] as number)]) },
      y: { label: `${data.robot.axes[second]}, m`, labelArrow: "none", ticks: 12, inset: 12, domain: extent([bottom, top, ...anchors.map((anchor) => anchor[1] as number)]) },
      ...(bands ? { color: { type: "threshold", domain: bands.levels, range: STEPS.slice(0, bands.levels.length + 1), legend: true, ...{ width: Math.min(width, 420) }, label: `${bands.quantity.words}, ${bands.quantity.unit}`, tickFormat: tick } } : {}),
      marks: [
        bands ? contourBands(bands.raster, bands.levels) : null,
        Plot.gridX({ stroke: LINE, strokeOpacity: 0.5 }),
        Plot.gridY({ stroke: LINE, strokeOpacity: 0.5 }),
        ...contours.map(({ raster, levels, look, name }) => contourLines(raster, levels, look, name)),
        layers.physical.shown && region.physical ? veil(marginsOf(region, region.physical)) : null,
        ...outlines.map(({ one, look, margins, name }) => (one.shown && margins ? contourLines(marginsOf(region, margins), [0], look, name) : null)),
        ...anchorMarks(data, region.plane, isWhole && layers.anchors.shown),
        ...(layers.exact.shown ? exactVectors(scene.vectors, scene.magnification, region.plane) : []),
        ...(layers.linear.shown ? linearVectors(scene.vectors, scene.magnification, region.plane) : []),
        layers.emerging.shown ? Plot.dot(visible.filter((place) => place.emerging), { x: (place: Place) => place.emerging?.[first], y: (place: Place) => place.emerging?.[second], r: 2.6 * size, fill: BAD, ariaDescription: "emerging poses" }) : null,
        layers.commanded.shown ? Plot.dot(visible, { x: (place: Place) => place.commanded[first], y: (place: Place) => place.commanded[second], r: 3.5 * size, stroke: INK, strokeWidth: 1.3 * size, fill: PAPER, fillOpacity: 0.35, ariaDescription: "commanded poses" }) : null,
        // the keyboard goes through these
        Plot.dot(visible, { x: (place: Place) => place.commanded[first], y: (place: Place) => place.commanded[second], r: 1, fill: "none", stroke: "none" }),
        Plot.tip(tipped, Plot.pointer({ x: (place: Place) => place.commanded[first], y: (place: Place) => place.commanded[second], title: (place: Place) => words(data, place), maxRadius: 60, lineWidth: 34, fontSize: 12 })),
      ],
    }),
  );
  finish(whole, region, contours.map(({ name, levels, look, quantity }) => ({ name, levels, unit: quantity.unit, colour: look.stroke })));
  return whole;
}

/** Keeps contours to their box, and writes their values where the machine can be held. */
function finish(whole: SVGSVGElement | HTMLElement, region: StudyRegion, lines: Labelled[]): void {
  const drawing = whole instanceof SVGSVGElement ? whole : ([...whole.querySelectorAll("svg")].at(-1) as SVGSVGElement);
  const scales = whole as unknown as Plot.Plot;
  const [x, y] = [scales.scale("x") as Plot.Scale, scales.scale("y") as Plot.Scale];
  const [[left, right], [bottom, top]] = [ends(region.axes[0]).map((end) => x.apply(end)), ends(region.axes[1]).map((end) => y.apply(end))] as [[number, number], [number, number]];
  const clip = drawn("clipPath", { id: "study-box" });
  clip.append(drawn("rect", { x: left, y: top, width: right - left, height: bottom - top }));
  const definitions = drawn("defs", {});
  definitions.append(clip);
  drawing.prepend(definitions);
  for (const contours of drawing.querySelectorAll('[aria-label="contour"]')) contours.setAttribute("clip-path", "url(#study-box)");
  const [columns, rows] = region.axes.map((axis) => axis.count - 1) as [number, number];
  const node = (across: number, up: number) => Math.round(((up - bottom) / (top - bottom)) * rows) * (columns + 1) + Math.round(((across - left) / (right - left)) * columns);
  writeValues(drawing, lines, { left, right, top, bottom }, (across, up) => !region.physical || (region.physical[node(across, up)] ?? -1) >= 0);
}

function rasterOf(region: StudyRegion, quantity: Quantity): Raster {
  return { axes: region.axes, values: region.error_m.map((_, at) => quantity.of(region, at)) };
}

/** Margins with NaN for −∞. */
function marginsOf({ axes }: StudyRegion, margins: (number | null)[]): Raster {
  return { axes, values: margins.map((margin) => margin ?? Number.NaN) };
}

/** The values where the machine can be held; all where that is unknown or nowhere. */
function within(region: StudyRegion, values: number[]): number[] {
  const held = values.filter((_, at) => (region.physical?.[at] ?? -1) >= 0);
  return held.length > 8 ? held : values;
}

function extent(values: number[]): [number, number] {
  return [values.reduce((a, b) => Math.min(a, b)), values.reduce((a, b) => Math.max(a, b))];
}

/** The grid points of a region. */
function gridPlaces(region: StudyRegion): Place[] {
  const [across, up] = region.axes;
  return region.error_m.map((_, at) => ({
    title: "grid point",
    commanded: positionOn(region, across.start_m + (at % across.count) * across.step_m, up.start_m + Math.floor(at / across.count) * up.step_m),
    emerging: null,
    points: region,
    at,
    reason: null,
  }));
}

/** Coordinates of a point of the plane, or of the slice. */
function positionOn({ plane: [first, second], level_m }: StudyRegion, across: number, up: number): number[] {
  const position: number[] = level_m === null ? [] : [level_m, level_m, level_m];
  position[first] = across;
  position[second] = up;
  return position;
}

/** The poses that lie on a slice, or all in a plane. */
function posesOn(data: StudyData, { plane, level_m }: StudyRegion): Place[] {
  const axis = [0, 1, 2].find((one) => !plane.includes(one)) as number;
  return poses(data).filter(({ commanded }) => level_m === null || Math.abs((commanded[axis] as number) - level_m) < NEAR_SLICE);
}

/** Grid points for vectors: evenly spaced, inside the physical workspace where it is known. */
function thinned(data: StudyData, region: StudyRegion): Place[] {
  const [across] = region.axes;
  const stride = strideOf(region);
  const offset = Math.floor(stride / 2);
  const isChosen = (at: number) => (at % across.count) % stride === offset && Math.floor(at / across.count) % stride === offset;
  const places = gridPlaces(region).filter(({ at }) => isChosen(at));
  const held = places.filter(({ at }) => (region.physical?.[at] ?? -1) >= 0);
  return data.regions.some(({ physical }) => physical) && held.length > 0 ? held : places;
}

function strideOf({ axes: [across, up] }: StudyRegion): number {
  return Math.max(1, Math.ceil(Math.max(across.count, up.count) / VECTOR_COLUMNS));
}

/** Distance of the vectors over a region (m). */
function spacing(region: StudyRegion): number {
  return strideOf(region) * Math.max(...region.axes.map((axis) => axis.step_m));
}
