// The page of a workspace: the robot, its platform to drag, and what the grid says there.
import { button, choice, element } from "../controls";
import { save, svg } from "../saving";
import { onThemeChange } from "../theme";
import type { WorkspaceData } from "../data";
import { png, stl } from "./download";
import { tensionLegend } from "./legend";
import { type MarginChart, type Plane, type PlaneColouring, knowsCables, marginChart } from "./margin-chart";
import { placePlatform } from "./plane-robot";
import { Platform } from "./platform";
import { offerPosition } from "./position-controls";
import { showReadout } from "./readout";
import { type ShownRegion, offerRegions, regionsOf } from "./regions";
import { RobotScene } from "./robot-scene";
import { TensionScale, hasTensions } from "./tension-style";

/** Fills the places of the page that the command wrote. */
export function showWorkspace(data: WorkspaceData): void {
  const place = document.querySelector<HTMLElement>("[data-workspace]");
  if (!place) return;
  const [platform, regions, scale] = [new Platform(data), regionsOf(data), new TensionScale(data.robot.cables, data.grid.tensions_N)];
  const [controls, picture, side] = [element("div", "", "controls"), element("div", "", "picture"), element("div", "", "side")];
  const [canvas, legends] = [element("div", "", "canvas"), element("div", "", "legends")];
  picture.append(canvas, legends);
  place.prepend(controls, picture, side);
  if (hasTensions(data)) legends.append(tensionLegend(scale));
  showReadout(side, platform, scale);
  offerPosition(side, platform);
  const redraw = data.robot.plane ? showPlanar(canvas, controls, platform, regions, scale) : showSpatial(canvas, controls, legends, platform, regions, scale);
  offerRegions(legends, regions, redraw);
}

function showPlanar(canvas: HTMLElement, controls: HTMLElement, platform: Platform, regions: ShownRegion[], scale: TensionScale): () => void {
  const plane: Plane = { across: 0, up: 1, layer: [] };
  const anchors = platform.frame.map((anchor) => platform.coordinatesOf(anchor) as [number, number]);
  const colouring = offerColouring(controls, platform.data, () => chart.redraw());
  const chart = followed(canvas, platform, scale, (width) => ({ plane, chart: marginChart(platform.data, plane, regions, anchors, width, colouring()) }));
  button(controls, "Save as SVG", () => save(chart.now() && svg((chart.now() as MarginChart).drawing), `${platform.data.robot.name}-workspace.svg`));
  return chart.redraw;
}

function showSpatial(canvas: HTMLElement, controls: HTMLElement, legends: HTMLElement, platform: Platform, regions: ShownRegion[], scale: TensionScale): () => void {
  const { name } = platform.data.robot;
  showSlices(platform, regions);
  try {
    const scene = new RobotScene(canvas, controls, platform, regions, scale);
    const group = element("div", "", "buttons");
    button(group, "Save as PNG", async () => save(await png(canvas), `${name}-workspace.png`));
    legends.append(scene.legend);
    const solid = regions.filter(({ region }) => region.triangles.length > 0);
    for (const one of solid) button(group, solid.length > 1 ? `Save ${one.letter} as STL` : `Save ${one.region.method === "hull" ? "hull" : "surface"} as STL`, () => save(stl([one]), `${name}-workspace-${one.letter}.stl`));
    controls.append(group);
    return () => scene.build();
  } catch (error) {
    canvas.append(element("p", `The scene needs WebGL, which this browser does not offer (${String(error)}). The slice below shows the same margins.`, "remark"));
    return () => {};
  }
}

/** The slice through the platform; it follows the platform from layer to layer of the grid. */
function showSlices(platform: Platform, regions: ShownRegion[]): void {
  const place = document.querySelector<HTMLElement>('figure[data-chart="slice"]');
  if (!place) return;
  const [controls, canvas] = [element("div", "", "controls"), element("div", "", "canvas")];
  place.prepend(controls, canvas);
  const { axes } = platform.data.grid;
  const pairs: [number, number][] = [[0, 2], [1, 2], [0, 1]];
  const pair = choice(controls, "Slice", pairs.map((value) => ({ label: value.map((k) => axes[k]?.name).join("–"), value })), () => chart.redraw());
  const colouring = offerColouring(controls, platform.data, () => chart.redraw());
  const words = element("output", "", "pose-words");
  controls.append(words);
  const planeNow = (): Plane => {
    const [across, up] = pair();
    const layer = axes.map((axis, k) => Math.max(0, Math.min(axis.count - 1, Math.round(((platform.coordinates[k] ?? 0) - axis.start_m) / (axis.step_m || 1)))));
    return { across, up, layer };
  };
  const third = () => [0, 1, 2].find((k) => !pair().includes(k)) as number;
  let drawn = -1;
  const chart = followed(canvas, platform, null, (width) => {
    const plane = planeNow();
    drawn = plane.layer[third()] as number;
    const axis = axes[third()] as (typeof axes)[number];
    words.textContent = `at the grid's layer ${axis.name} = ${(axis.start_m + drawn * axis.step_m).toFixed(2)} m, the nearest to the platform`;
    return { plane, chart: marginChart(platform.data, plane, regions.map((one) => ({ ...one, shown: false })), [], Math.min(width, 640), colouring()) };
  });
  platform.onMove(() => {
    if (planeNow().layer[third()] !== drawn) chart.redraw();
  });
  button(controls, "Save as SVG", () => save(chart.now() && svg((chart.now() as MarginChart).drawing), `${platform.data.robot.name}-slice.svg`));
}

/** What colours tell, where the page knows more than the margin. */
function offerColouring(controls: HTMLElement, data: WorkspaceData, changed: () => void): () => PlaneColouring {
  if (!knowsCables(data)) return () => "margin";
  const options: { label: string; value: PlaneColouring }[] = [{ label: "margin", value: "margin" }, { label: "limiting cable", value: "cable" }];
  return choice(controls, "Colours of the plane", options, changed);
}

/** A margin chart that keeps to the width of its place and shows the platform where it is. */
function followed(
  canvas: HTMLElement,
  platform: Platform,
  scale: TensionScale | null,
  make: (width: number) => { plane: Plane; chart: MarginChart },
): { redraw: () => void; now: () => MarginChart | null } {
  let shown: MarginChart | null = null;
  let follow = () => {};
  let width = 0;
  const redraw = () => {
    const hadFocus = canvas.contains(document.activeElement);
    const { plane, chart } = make(width);
    shown = chart;
    follow = placePlatform(chart, plane, platform, scale);
    canvas.replaceChildren(chart.whole);
    if (hadFocus) chart.drawing.querySelector<SVGElement>(".handle")?.focus({ preventScroll: true });
  };
  new ResizeObserver(() => {
    const now = Math.round(Math.min(canvas.clientWidth, 860));
    if (now === width || now < 100) return;
    width = now;
    redraw();
  }).observe(canvas);
  width = Math.round(Math.min(canvas.clientWidth || 640, 860));
  redraw();
  platform.onMove(() => follow());
  onThemeChange(redraw);
  return { redraw, now: () => shown };
}
