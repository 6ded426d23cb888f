// The robot in space: cables by tension, the platform that follows the pointer, and the hulls with their clip plane.
import { AmbientLight, DirectionalLight, Group, Vector3 } from "three";
import { choice } from "../controls";
import { dashed, dispose, handle, lines, markers } from "../scene/drawing";
import { offerDragging } from "../scene/dragging";
import type { Segment } from "../scene/geometry";
import type { Label } from "../scene/labels";
import { body } from "../scene/solid";
import { Stage } from "../scene/stage";
import { offerViews } from "../scene/views";
import { colour, onThemeChange } from "../theme";
import { type Platform, cableName } from "./platform";
import type { ShownRegion } from "./regions";
import { Surfaces, boxCorners } from "./surfaces";
import type { TensionScale } from "./tension-style";

const WORDS =
  "The robot in three dimensions. Arrow keys turn it, plus and minus zoom. Shift with the arrow keys, Page Up and Page Down move the platform. The table holds the same numbers.";

const KEYS: Record<string, [number, number]> = { ArrowLeft: [0, -1], ArrowRight: [0, 1], ArrowDown: [1, -1], ArrowUp: [1, 1], PageDown: [2, -1], PageUp: [2, 1] };

/** The scene; `place` gets the canvas, `controls` the choices. Throws where the browser has no WebGL. */
export class RobotScene {
  readonly stage: Stage;
  private readonly robot = new Group();
  private readonly surfaces: Surfaces;
  private readonly size: number;
  private hovered = false;
  private normal: () => Vector3 | null = () => null;

  constructor(
    place: HTMLElement,
    controls: HTMLElement,
    private readonly platform: Platform,
    regions: ShownRegion[],
    private readonly scale: TensionScale,
  ) {
    this.stage = new Stage(place, WORDS);
    const points = [...platform.frame, ...platform.anchors, ...boxCorners(platform)];
    this.stage.frame(points);
    this.size = Math.max(...points.map((point) => point.distanceTo(points[0] as Vector3)), 1e-3);
    this.surfaces = new Surfaces(platform, regions, this.size);
    const light = new DirectionalLight("#fff", 2.4);
    light.position.set(0.4, -1, 0.8);
    this.stage.content.add(new AmbientLight("#fff", 1.9), light, this.surfaces.group, this.robot);
    this.stage.labels.isHidden = (point) => this.surfaces.hides(this.stage.camera.position, point);
    this.offerControls(controls);
    this.offerMoving();
    onThemeChange(() => this.build());
    platform.onMove(() => this.buildRobot());
    this.build();
    this.standardView();
    this.stage.drawNow();
  }

  /** Draws everything again, e.g. after a result was hidden. */
  build(): void {
    this.surfaces.build();
    this.buildRobot();
  }

  /** What the colours of surfaces mean. */
  get legend(): HTMLElement {
    return this.surfaces.legend;
  }

  private offerControls(controls: HTMLElement): void {
    this.normal = choice(controls, "Drag the platform", [
      { label: "in the plane of the screen", value: null as Vector3 | null },
      { label: "horizontally", value: new Vector3(0, 0, 1) },
      { label: "in the x–z plane", value: new Vector3(0, 1, 0) },
      { label: "in the y–z plane", value: new Vector3(1, 0, 0) },
    ], () => {});
    offerViews(controls, this.stage, false, () => this.standardView());
    this.surfaces.offer(controls, () => this.build());
  }

  private offerMoving(): void {
    const { platform, stage } = this;
    offerDragging(stage, {
      position: () => platform.position,
      grips: () => [this.knob, platform.position, ...platform.anchors],
      moveTo: (position) => platform.moveTo(platform.coordinatesOf(position)),
      normal: () => this.normal(),
      hover: (on) => this.hover(on),
    });
    stage.canvas.addEventListener("keydown", (event) => {
      const step = KEYS[event.key];
      if (!step || (!event.shiftKey && step[0] < 2)) return;
      event.preventDefault();
      event.stopImmediatePropagation(); // or the scene would turn
      platform.step(step[0], step[1] * 2);
    }, { capture: true });
  }

  private hover(on: boolean): void {
    if (on === this.hovered) return;
    this.hovered = on;
    this.stage.canvas.style.cursor = on ? "grab" : "";
    this.buildRobot();
  }

  private standardView(): void {
    this.stage.lookFrom(new Vector3(0.75, -1, 0.45), new Vector3(0, 0, 1));
  }

  private buildRobot(): void {
    const { platform, robot } = this;
    dispose(robot);
    robot.clear();
    const { frame, anchors, position } = platform;
    const { tensions } = platform.reading;
    const cables = frame.map((anchor, index): Segment => [anchor, anchors[index] as Vector3]);
    cables.forEach((cable, index) => {
      const tension = tensions?.[index];
      if (tension === undefined) return;
      const look = this.scale.look(tension);
      robot.add(lines([cable], colour(look.colour), look.width));
    });
    if (!tensions) robot.add(dashed(cables, colour("muted"), 0.012 * this.size));
    robot.add(
      body(anchors, this.size, { solid: colour("solid"), edge: colour("ink"), width: this.hovered ? 3 : 2 }),
      markers(frame, colour("ink"), 8, true),
      lines([[position, this.knob]], colour("ink"), 1.5),
      handle(this.knob, colour("ink"), colour("paper"), this.hovered),
      this.axes(),
    );
    this.stage.labels.set([...this.surfaces.labels, ...this.axisLabels(), ...frame.map((at, index) => ({ at, text: this.words(index, tensions) }))]);
    this.stage.draw();
  }

  /** Where the handle is: above the platform, which it would hide. */
  private get knob(): Vector3 {
    const { position, anchors } = this.platform;
    const reach = Math.max(...anchors.map((anchor) => anchor.distanceTo(position)));
    return position.clone().addScaledVector(new Vector3(0, 0, 1), reach + 0.04 * this.size);
  }

  private words(index: number, tensions: number[] | null): string {
    const name = cableName(this.platform.data, index);
    const tension = tensions?.[index];
    return tension === undefined ? name : `${name}: ${tension.toFixed(0)} N`;
  }

  /** Beside the lowest corner of the frame, clear of the label of the anchor there. */
  private corner(): Vector3 {
    const least = this.platform.frame.reduce((corner, point) => corner.min(point), new Vector3(Infinity, Infinity, Infinity));
    return least.addScaledVector(new Vector3(-0.8, -0.6, 0), 0.13 * this.size);
  }

  private tips(): { name: string; at: Vector3 }[] {
    const directions: [string, Vector3][] = [["x", new Vector3(1, 0, 0)], ["y", new Vector3(0, 1, 0)], ["z", new Vector3(0, 0, 1)]];
    return directions.map(([name, direction]) => ({ name, at: this.corner().addScaledVector(direction, 0.1 * this.size) }));
  }

  private axes() {
    return lines(this.tips().map(({ at }): Segment => [this.corner(), at]), colour("ink"), 2);
  }

  private axisLabels(): Label[] {
    return this.tips().map(({ name, at }) => ({ at, text: name, className: "axis" }));
  }
}
