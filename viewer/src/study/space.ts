// The errors of a spatial robot: its poses seen from above, from the front and from the side.
import * as Plot from "@observablehq/plot";
import { BAD, INK, SECOND, STEPS, frame } from "../charts/style";
import { choice, element } from "../controls";
import type { Draw, Figure } from "../figure";
import { tick } from "../number";
import { levelsOf } from "./contours";
import type { StudyData } from "../data";
import { anchorMarks } from "./anchors";
import { type Layer, arrow, mark, offerLayers, pin } from "./layers";
import { LARGEST, type Place, type Quantity, RESIDUAL, SMALLEST, TRACKING, errorsOf, hasResiduals, hasTensions, poses, tracksForces, words } from "./quantities";
import { MAGNIFICATIONS, apart, exactVectors, fitting, linearVectors, magnificationWords } from "./vectors";

const VIEWS: [string, [number, number]][] = [["from above", [0, 1]], ["from the front", [0, 2]], ["from the side", [1, 2]]];

interface SpaceLayers {
  commanded: Layer;
  emerging: Layer;
  exact: Layer;
  linear: Layer;
  anchors: Layer;
}

/** Three projections with one scale of colours. */
export function space(data: StudyData, figure: Figure, tell: (words: string) => void): Draw | null {
  const all = poses(data);
  if (data.robot.plane || all.length === 0) return null;
  const layer = (text: string, shown: boolean, picture: SVGElement[]): Layer => ({ words: text, shown, picture });
  const layers: SpaceLayers = {
    commanded: layer("commanded poses", true, mark("ring")),
    emerging: layer("emerging poses", false, mark("point")),
    exact: layer("exact vectors", true, arrow()),
    linear: layer("vectors by one linear step", false, pin(SECOND)),
    anchors: layer("frame anchors", false, mark("square")),
  };
  const quantity = choice(figure.controls, "Colour and size of poses", quantitiesOf(data).map((value) => ({ label: value.words, value })), figure.redraw);
  const magnified = choice(figure.controls, "Vectors magnified", MAGNIFICATIONS, figure.redraw);
  offerLayers(figure.controls, [["Poses and robot", [layers.commanded, layers.emerging, layers.anchors]], ["Error vectors", [layers.exact, layers.linear]]], figure.redraw);
  return (width) => {
    const magnification = magnified() ?? fitting(all, 0.8 * apart(all, 3));
    tell(layers.exact.shown || layers.linear.shown ? magnificationWords(magnification) : "");
    const shown = quantity();
    const values = all.map((place) => shown.of(place.points, place.at));
    const levels = levelsOf(values, STEPS.length - 1);
    const panels = element("div", "", "panels");
    const columns = width > 700 ? 2 : 1;
    panels.style.gridTemplateColumns = `repeat(${columns}, minmax(0, 1fr))`;
    const each = Math.floor((width - 16 * (columns - 1)) / columns);
    for (const [name, axes] of VIEWS) {
      const panel = element("div");
      // beside each other like the sides of a drawing: from above left, the others right
      if (columns > 1 && axes[1] === 1) panel.style.gridRow = "span 2";
      panel.append(element("p", `${name}: ${axes.map((axis) => data.robot.axes[axis]).join("–")}`, "panel-title"), view(data, { all, axes, shown, levels, magnification, layers, width: each }));
      panels.append(panel);
    }
    const whole = element("div");
    if (levels.length > 0 && layers.commanded.shown) whole.append(Plot.legend({ color: { type: "threshold", domain: levels, range: STEPS.slice(0, levels.length + 1) }, label: `${shown.words}, ${shown.unit}`, width: Math.min(width, 420), tickFormat: tick }));
    whole.append(panels);
    return whole;
  };
}

function quantitiesOf(data: StudyData): Quantity[] {
  const errors = errorsOf(data).flatMap(({ exact, linear, difference }) => [exact, linear, difference]);
  return [...errors, ...(hasTensions(data) ? [LARGEST, SMALLEST] : []), ...(tracksForces(data) ? [TRACKING] : []), ...(hasResiduals(data) ? [RESIDUAL] : [])];
}

interface View {
  all: Place[];
  axes: [number, number];
  shown: Quantity;
  levels: number[];
  magnification: number;
  layers: SpaceLayers;
  width: number;
}

function view(data: StudyData, { all, axes, shown, levels, magnification, layers, width }: View): Node {
  const [first, second] = axes;
  const value = (place: Place) => shown.of(place.points, place.at);
  // poses behind each other: small points last, upon the large ones
  const sorted = all.filter((place) => Number.isFinite(value(place))).sort((a, b) => value(b) - value(a));
  const silent = all.filter((place) => !Number.isFinite(value(place)));
  const places = { x: (place: Place) => place.commanded[first], y: (place: Place) => place.commanded[second] };
  return Plot.plot(
    frame(width, {
      aspectRatio: 1,
      marginTop: 22,
      x: { ticks: 6, label: `${data.robot.axes[first]}, m`, labelAnchor: "center", labelArrow: "none", grid: true, nice: true, inset: 16 },
      y: { label: `${data.robot.axes[second]}, m`, labelArrow: "none", grid: true, nice: true, inset: 16 },
      color: { type: "threshold", domain: levels.length > 0 ? levels : [0], range: STEPS.slice(0, levels.length + 1) },
      r: { domain: [0, Math.max(...levels, 1e-12)], range: [2.5, 8], clamp: true },
      marks: [
        ...anchorMarks(data, axes, layers.anchors.shown),
        layers.emerging.shown ? Plot.dot(all.filter((place) => place.emerging), { x: (place: Place) => place.emerging?.[first], y: (place: Place) => place.emerging?.[second], r: 2.6, fill: BAD, ariaDescription: "emerging poses" }) : null,
        Plot.dot(silent, { ...places, symbol: "times", r: 5, stroke: BAD, strokeWidth: 2 }),
        layers.commanded.shown ? Plot.dot(sorted, { ...places, fill: value, r: value, stroke: INK, strokeOpacity: 0.6, strokeWidth: 0.7, ariaDescription: "commanded poses" }) : null,
        ...(layers.exact.shown ? exactVectors(all, magnification, axes) : []),
        ...(layers.linear.shown ? linearVectors(all, magnification, axes) : []),
        // the keyboard goes through these
        Plot.dot(all, { ...places, r: 1, fill: "none", stroke: "none" }),
        Plot.tip(all, Plot.pointer({ ...places, title: (place: Place) => words(data, place), maxRadius: 60, lineWidth: 34, fontSize: 12 })),
      ],
    }),
  );
}
