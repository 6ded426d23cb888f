// The robot in space: nominal against calibrated geometry, a measured pose, and where the errors point to.
import { axesOf } from "../robot";
import { AmbientLight, DirectionalLight, type Object3D, Vector3 } from "three";
import { choice, element } from "../controls";
import type { ReportData } from "../data";
import { models } from "../charts/quantities";
import { topOf } from "../charts/map";
import { STEPS } from "../charts/style";
import { colour, onThemeChange } from "../theme";
import { offerDragging } from "./dragging";
import { dashed, dispose, handle, lines, markers } from "./drawing";
import { type Posed, type Segment, errorVectors, largestShift, posed, roundMagnification, vector } from "./geometry";
import { body, bounds, boxEdges, drum, floor, wheel } from "./solid";
import { Stage } from "./stage";
import { offerViews } from "./views";

const WORDS =
  "The robot in three dimensions. Arrow keys turn it, plus and minus zoom; the slider above walks through the samples. Errors and positions stand as numbers in the tables of the result folder.";

/** Fills the figure of the scene. */
export function showScene(data: ReportData): void {
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
  private readonly slider = element("input");
  private hovered = false;
  /** Corners of what the frame anchors and the platform take up. */
  private readonly box: [Vector3, Vector3];

  constructor(
    private readonly data: ReportData,
    controls: HTMLElement,
    private readonly stage: Stage,
  ) {
    this.box = this.room();
    const points = [...boxEdges(...this.box).flat(), ...this.drumEnds()];
    stage.frame(points);
    this.size = Math.max(...points.map((point) => point.distanceTo(points[0] as Vector3)), 1e-3);
    const redraw = () => this.build();
    this.model = choice(controls, "Errors of the model", models(data), redraw);
    this.error = this.magnifier(controls, "magnified", this.largestError(), 0.04, redraw);
    this.shift = this.magnifier(controls, "Anchor shifts magnified", largestShift(data), 0.06, redraw);
    this.poseSlider(controls);
    this.offerMoving();
    offerViews(controls, stage, data.robot.plane !== null, () => this.standardView());
    onThemeChange(() => {
      this.build();
      this.stage.drawNow();
    });
    this.build();
    this.standardView();
    this.stage.drawNow();
  }

  /** The box of the frame anchors, down to the lowest place of the platform: one that hangs has its floor there. */
  private room(): [Vector3, Vector3] {
    const { robot, samples } = this.data;
    const [low, high] = bounds([...this.fixedPoints(), ...samples.position_m.map(vector)]);
    const reach = Math.max(0, ...robot.cables.map((cable) => vector(cable.platform_anchor_m).length()));
    const lowest = Math.min(...samples.position_m.map((position) => position[2])) - reach;
    if (!robot.plane) low.z = Math.min(low.z, lowest);
    return [low, high];
  }

  private fixedPoints(): Vector3[] {
    return [this.data.given_robot, this.data.robot].flatMap(({ cables }) => cables.map((cable) => vector(cable.frame_anchor_m)));
  }

  private largestError(): number {
    const { calibrated, set_aside } = this.data.samples;
    const sizes = calibrated.position_error_m.flatMap((error, row) => (error && !set_aside[row] ? [Math.hypot(...error)] : []));
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
    const { slider } = this;
    Object.assign(slider, { type: "range", min: "0", max: String(count - 1), value: "0" });
    slider.addEventListener("input", () => {
      this.row = Number(slider.value);
      this.build();
    });
    const label = element("label", "Pose ");
    label.append(slider, this.words);
    controls.append(label);
  }

  /** The handle leads from sample to sample: to the one that is nearest as the reader sees it. */
  private offerMoving(): void {
    const { stage, data } = this;
    offerDragging(stage, {
      position: () => this.position,
      grips: () => [this.position, this.knob(posed(data, this.row, "calibrated", this.shift()))],
      moveTo: (at) => {
        const towards = stage.camera.getWorldDirection(new Vector3());
        const apart = data.samples.position_m.map((sample) => {
          const arm = vector(sample).sub(at);
          const depth = arm.dot(towards);
          return arm.lengthSq() - 0.98 * depth * depth;
        });
        const nearest = apart.reduce((best, one, row) => (one < (apart[best] as number) ? row : best), 0);
        if (nearest === this.row) return;
        this.row = nearest;
        this.slider.value = String(nearest);
        this.build();
      },
      normal: () => null,
      hover: (on) => {
        if (on === this.hovered) return;
        this.hovered = on;
        stage.canvas.style.cursor = on ? "grab" : "";
        this.build();
      },
    });
  }

  /** Where the handle is: above the platform, which it would hide. */
  private knob(robot: Posed): Vector3 {
    const reach = Math.max(...robot.platform.map((anchor) => anchor.distanceTo(this.position)));
    const { plane } = this.data.robot;
    return this.position.addScaledVector(plane ? vector(plane.second) : new Vector3(0, 0, 1), reach + 0.05 * this.size);
  }

  private get position(): Vector3 {
    return vector(this.data.samples.position_m[this.row] ?? [0, 0, 0]);
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
    const light = new DirectionalLight("#fff", 1.5);
    light.position.set(0.4, -1, 1.4);
    stage.content.add(
      new AmbientLight("#fff", 2.2),
      light,
      ...this.surroundings(),
      lines(box(data), colour("line"), 1),
      dashed([...nominal.cables, ...nominal.edges], muted, 0.012 * this.size),
      markers([...nominal.frame, ...nominal.platform], muted, 11, false),
      lines(calibrated.cables, accent, 1.6),
      body(calibrated.platform, this.size, { solid: colour("solid"), edge: accent, width: 2 }),
      markers([...calibrated.frame, ...calibrated.platform], accent, 8, true),
      ...this.pulleys(calibrated),
      ...this.drums(),
      ...this.errors(),
      this.axes(),
      lines([[this.position, this.knob(calibrated)]], colour("ink"), 1.5),
      handle(this.knob(calibrated), colour("ink"), colour("paper"), this.hovered),
    );
    this.label(calibrated.frame);
    this.words.textContent = ` sample ${data.samples.number[this.row]}: ${this.position.toArray().map((value) => value.toFixed(3).replace("-", "−")).join(", ")} m`;
    stage.draw();
  }

  /** Edges of the box, and its floor; in a plane the whole area of the frame. */
  private surroundings(): Object3D[] {
    const [low, high] = this.box;
    const plane = this.data.robot.plane;
    const arm = (direction: Vector3) => direction.multiplyScalar(high.clone().sub(low).dot(direction));
    const [first, second] = plane ? [vector(plane.first), vector(plane.second)] : [new Vector3(1, 0, 0), new Vector3(0, 1, 0)];
    const [across, ground] = [arm(first), arm(second)];
    const base: Segment = [low, low.clone().add(across)];
    return [floor(low, across, ground, colour("shade")), lines(boxEdges(low, high), colour("edge"), 1.2), ...(plane ? [lines([base], colour("edge"), 3)] : [])];
  }

  private pulleys(robot: Posed): Object3D[] {
    const look = { solid: colour("solid"), edge: colour("accent"), width: 1 };
    return this.data.robot.cables.flatMap(({ pulley }, cable) => {
      const [entry, end] = [robot.frame[cable], robot.platform[cable]];
      return pulley && entry && end ? [wheel(entry, end, vector(pulley.swivel_axis), pulley.radius_m, look)] : [];
    });
  }

  /** Drums, and the cables' ways from them to their first pulleys. */
  private drums(): Object3D[] {
    const look = { solid: colour("solid"), edge: colour("accent"), width: 1 };
    const stated = this.data.robot.cables.flatMap((cable) => cable.drum ?? []);
    const ways = stated.flatMap(({ way_m }): Segment[] => (way_m ? [[vector(way_m[0]), vector(way_m[1])]] : []));
    return [...stated.map((one) => drum(vector(one.from_m), vector(one.to_m), one.radius_m, look)), lines(ways, look.edge, 1.6)];
  }

  private drumEnds(): Vector3[] {
    return this.data.robot.cables.flatMap((cable) => (cable.drum ? [vector(cable.drum.from_m), vector(cable.drum.to_m)] : []));
  }

  /** Vectors in six steps of colour, from the measured position. */
  private errors() {
    const vectors = errorVectors(this.data, this.model(), this.error()).filter(({ row }) => !this.data.samples.set_aside[row]);
    const top = topOf(vectors.map((one) => one.size));
    const step = (size: number) => Math.min(STEPS.length - 1, Math.floor((STEPS.length * size) / top));
    const steps = STEPS.map((_, index) => vectors.filter((one) => step(one.size) === index));
    return steps.flatMap((part, index) => {
      const shade = colour(`step-${index + 1}`);
      return [lines(part.map((one) => one.segment), shade, 2), markers(part.map((one) => one.segment[0]), shade, 4, true)];
    });
  }

  private corner(): Vector3 {
    return this.box[0].clone();
  }

  private axes() {
    const from = this.corner();
    const arms = this.arms().map(({ direction }): Segment => [from, from.clone().addScaledVector(direction, 0.12 * this.size)]);
    return lines(arms, colour("ink"), 2);
  }

  private arms(): { name: string; direction: Vector3 }[] {
    return axesOf(this.data.robot).map(({ name, direction }) => ({ name, direction: vector(direction) }));
  }

  private label(anchors: Vector3[]): void {
    const cables = anchors.map((at, index) => ({ at, text: String(index + 1) }));
    const tip = (direction: Vector3) => this.corner().addScaledVector(direction, 0.12 * this.size);
    const axes = this.arms().map(({ name, direction }) => ({ at: tip(direction), text: name, className: "axis" }));
    this.stage.labels.set([...cables, ...axes]);
  }
}

/** The box of the poses that the fit saw. */
function box(data: ReportData): Segment[] {
  const points = data.fit_position_m.map(vector);
  if (points.length === 0) return [];
  return boxEdges(...bounds(points));
}
