// The robot in space: nominal against calibrated geometry, a measured pose, and where the errors point to.
import { Vector3 } from "three";
import { button, choice, element } from "../controls";
import type { PageData } from "../data";
import { models } from "../charts/quantities";
import { topOf } from "../charts/map";
import { STEPS } from "../charts/style";
import { colour, onThemeChange } from "../theme";
import { dashed, dispose, lines, markers } from "./drawing";
import { type Segment, errorVectors, largestShift, posed, roundMagnification, vector } from "./geometry";
import { Stage } from "./stage";

const WORDS =
  "The robot in three dimensions. Arrow keys turn it, plus and minus zoom. Errors and positions stand as numbers in the tables of the result folder.";

/** Fills the figure of the scene. */
export function showScene(data: PageData): void {
  const place = document.querySelector<HTMLElement>('figure[data-chart="scene"]');
  if (!place) return;
  place.hidden = data.samples.number.length === 0;
  if (place.hidden) return;
  const controls = element("div", "", "controls");
  const holder = element("div");
  place.prepend(controls, holder);
  try {
    new RobotScene(data, controls, new Stage(holder, WORDS));
  } catch (error) {
    holder.append(element("p", `The scene needs WebGL, which this browser does not offer (${String(error)}). The map above shows the same errors.`, "remark"));
  }
}

/** What is drawn, and the choices that change it. */
class RobotScene {
  private row = 0;
  private shift: () => number = () => 1;
  private error: () => number = () => 1;
  private readonly size: number;
  private readonly model;
  private readonly words = element("output", "", "pose-words");

  constructor(
    private readonly data: PageData,
    controls: HTMLElement,
    private readonly stage: Stage,
  ) {
    const points = [...this.fixedPoints(), ...data.samples.position_m.map(vector)];
    stage.frame(points);
    this.size = Math.max(...points.map((point) => point.distanceTo(points[0] as Vector3)), 1e-3);
    const redraw = () => this.build();
    this.model = choice(controls, "Errors of the model", models(data), redraw);
    this.error = this.magnifier(controls, "magnified", this.largestError(), 0.04, redraw);
    this.shift = this.magnifier(controls, "Anchor shifts magnified", largestShift(data.robot.cables), 0.06, redraw);
    this.poseSlider(controls);
    this.viewButtons(controls);
    onThemeChange(() => {
      this.build();
      this.stage.drawNow();
    });
    this.build();
    this.standardView();
    this.stage.drawNow();
  }

  private fixedPoints(): Vector3[] {
    return this.data.robot.cables.flatMap((cable) => [vector(cable.frame_anchor_nominal_m), vector(cable.frame_anchor_m)]);
  }

  private largestError(): number {
    const sizes = this.data.samples.calibrated.position_error_m.flatMap((error) => (error ? [Math.hypot(...error)] : []));
    return sizes.length > 0 ? topOf(sizes) : 0;
  }

  /** A choice of magnifications around the one that makes the largest vector this share of the scene. */
  private magnifier(controls: HTMLElement, label: string, largest: number, share: number, changed: () => void): () => number {
    if (largest <= 0) return () => 1;
    const best = roundMagnification((share * this.size) / largest);
    const list = [...new Set([best, 1, 10, 100, 1000])].sort((a, b) => (a === best ? -1 : b === best ? 1 : a - b));
    return choice(controls, label, list.map((value) => ({ label: `× ${value}`, value })), changed);
  }

  private poseSlider(controls: HTMLElement): void {
    const count = this.data.samples.number.length;
    if (count < 2) return;
    const slider = element("input");
    Object.assign(slider, { type: "range", min: "0", max: String(count - 1), value: "0" });
    slider.addEventListener("input", () => {
      this.row = Number(slider.value);
      this.build();
    });
    const label = element("label", "Pose ");
    label.append(slider, this.words);
    controls.append(label);
  }

  private viewButtons(controls: HTMLElement): void {
    const group = element("div", "", "buttons");
    group.setAttribute("role", "group");
    group.setAttribute("aria-label", "View");
    button(group, "Reset view", () => this.standardView());
    if (!this.data.robot.plane) {
      button(group, "Top", () => this.stage.lookFrom(new Vector3(0, -1e-3, 1), new Vector3(0, 0, 1)));
      button(group, "Front", () => this.stage.lookFrom(new Vector3(0, -1, 0), new Vector3(0, 0, 1)));
      button(group, "Side", () => this.stage.lookFrom(new Vector3(1, 0, 0), new Vector3(0, 0, 1)));
    }
    button(group, "Zoom in", () => this.stage.zoom(0.85));
    button(group, "Zoom out", () => this.stage.zoom(1 / 0.85));
    controls.append(group);
  }

  private standardView(): void {
    const plane = this.data.robot.plane;
    if (!plane) return this.stage.lookFrom(new Vector3(0.75, -1, 0.55), new Vector3(0, 0, 1));
    const [first, second] = [vector(plane.first), vector(plane.second)];
    this.stage.lookFrom(first.clone().cross(second), second);
  }

  private build(): void {
    const { stage, data } = this;
    dispose(stage.content);
    stage.content.clear();
    const nominal = posed(data, this.row, "nominal", 0);
    const calibrated = posed(data, this.row, "calibrated", this.shift());
    const [accent, muted] = [colour("accent"), colour("muted")];
    stage.content.add(
      lines(box(data), colour("line"), 1),
      dashed([...nominal.cables, ...nominal.edges], muted, 0.012 * this.size),
      markers([...nominal.frame, ...nominal.platform], muted, 11, false),
      lines(calibrated.cables, accent, 1.6),
      lines(calibrated.edges, accent, 2.6),
      markers([...calibrated.frame, ...calibrated.platform], accent, 8, true),
      ...this.errors(),
      this.axes(),
    );
    this.label(calibrated.frame);
    const position = data.samples.position_m[this.row] ?? [0, 0, 0];
    this.words.textContent = ` sample ${data.samples.number[this.row]}: ${position.map((value) => value.toFixed(3)).join(", ")} m`;
    stage.draw();
  }

  /** Vectors in six steps of colour, from the measured position. */
  private errors() {
    const vectors = errorVectors(this.data, this.model(), this.error());
    const top = topOf(vectors.map((one) => one.size));
    const step = (size: number) => Math.min(STEPS.length - 1, Math.floor((STEPS.length * size) / top));
    const steps = STEPS.map((_, index) => vectors.filter((one) => step(one.size) === index));
    return steps.flatMap((part, index) => {
      const shade = colour(`step-${index + 1}`);
      return [lines(part.map((one) => one.segment), shade, 2), markers(part.map((one) => one.segment[0]), shade, 4, true)];
    });
  }

  private corner(): Vector3 {
    const least = this.fixedPoints().reduce((corner, point) => corner.min(point), new Vector3(Infinity, Infinity, Infinity));
    return least;
  }

  private axes() {
    const from = this.corner();
    const arms = this.arms().map(({ direction }): Segment => [from, from.clone().addScaledVector(direction, 0.12 * this.size)]);
    return lines(arms, colour("ink"), 2);
  }

  private arms(): { name: string; direction: Vector3 }[] {
    const plane = this.data.robot.plane;
    if (plane) return [{ name: plane.names[0], direction: vector(plane.first) }, { name: plane.names[1], direction: vector(plane.second) }];
    return [{ name: "x", direction: new Vector3(1, 0, 0) }, { name: "y", direction: new Vector3(0, 1, 0) }, { name: "z", direction: new Vector3(0, 0, 1) }];
  }

  private label(anchors: Vector3[]): void {
    const cables = anchors.map((at, index) => ({ at, text: String(index + 1) }));
    const tip = (direction: Vector3) => this.corner().addScaledVector(direction, 0.12 * this.size);
    const axes = this.arms().map(({ name, direction }) => ({ at: tip(direction), text: name, className: "axis" }));
    this.stage.labels.set([...cables, ...axes]);
  }
}

/** The box of the poses that the fit saw. */
function box(data: PageData): Segment[] {
  const points = data.fit_position_m.map(vector);
  if (points.length === 0) return [];
  const low = points.reduce((corner, point) => corner.min(point), new Vector3(Infinity, Infinity, Infinity));
  const high = points.reduce((corner, point) => corner.max(point), new Vector3(-Infinity, -Infinity, -Infinity));
  const corner = (k: number) => new Vector3(k & 1 ? high.x : low.x, k & 2 ? high.y : low.y, k & 4 ? high.z : low.z);
  const found: Segment[] = [];
  for (let k = 0; k < 8; k++) for (const bit of [1, 2, 4]) if (!(k & bit)) found.push([corner(k), corner(k | bit)]);
  return found;
}
