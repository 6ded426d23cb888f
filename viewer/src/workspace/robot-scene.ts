// The robot in space: cables by tension, the platform that follows the pointer, and the hulls with their clip plane.
import { AmbientLight, BoxGeometry, DirectionalLight, EdgesGeometry, Group, type Plane, Vector3 } from "three";
import { button, choice, element } from "../controls";
import { dashed, dispose, lines, markers } from "../scene/drawing";
import { offerDragging } from "../scene/dragging";
import type { Segment } from "../scene/geometry";
import { Stage } from "../scene/stage";
import { colour, onThemeChange } from "../theme";
import { type ClipChoice, offerClip } from "./clip";
import { type Surface, cut, dress, surface, top } from "./hull";
import { type Platform, cableName } from "./platform";
import type { ShownRegion } from "./regions";
import type { TensionScale } from "./tension-style";

const WORDS =
  "The robot in three dimensions. Arrow keys turn it, plus and minus zoom. Shift with the arrow keys, Page Up and Page Down move the platform. The table holds the same numbers.";

const KEYS: Record<string, [number, number]> = { ArrowLeft: [0, -1], ArrowRight: [0, 1], ArrowDown: [1, -1], ArrowUp: [1, 1], PageDown: [2, -1], PageUp: [2, 1] };

interface Label {
  at: Vector3;
  text: string;
  className?: string;
}

/** The scene; `place` gets the canvas, `controls` the choices. Throws where the browser has no WebGL. */
export class RobotScene {
  readonly stage: Stage;
  private readonly robot = new Group();
  private readonly hulls = new Group();
  private readonly cuts = new Group();
  private readonly surfaces: Surface[];
  private readonly size: number;
  private letters: Label[] = [];
  private opacity = 0.35;
  private clip: ClipChoice = () => null;
  private hovered = false;
  private normal: () => Vector3 | null = () => null;

  constructor(
    place: HTMLElement,
    controls: HTMLElement,
    private readonly platform: Platform,
    private readonly regions: ShownRegion[],
    private readonly scale: TensionScale,
  ) {
    this.stage = new Stage(place, WORDS);
    const points = [...platform.frame, ...platform.anchors, ...this.boxCorners()];
    this.stage.frame(points);
    this.size = Math.max(...points.map((point) => point.distanceTo(points[0] as Vector3)), 1e-3);
    this.surfaces = regions.map(({ region }) => surface(region));
    this.hulls.add(...this.surfaces);
    const light = new DirectionalLight("#fff", 2.4);
    light.position.set(0.4, -1, 0.8);
    this.stage.content.add(new AmbientLight("#fff", 1.9), light, this.hulls, this.cuts, this.robot);
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
    this.buildHulls();
    this.buildRobot();
  }

  private offerControls(controls: HTMLElement): void {
    const axes = this.platform.data.grid.axes;
    this.normal = choice(controls, "Drag the platform", [
      { label: "in the plane of the screen", value: null as Vector3 | null },
      { label: "horizontally", value: new Vector3(0, 0, 1) },
      { label: "in the x–z plane", value: new Vector3(0, 1, 0) },
      { label: "in the y–z plane", value: new Vector3(1, 0, 0) },
    ], () => {});
    const views = element("div", "", "buttons");
    views.setAttribute("role", "group");
    views.setAttribute("aria-label", "View");
    button(views, "Reset view", () => this.standardView());
    button(views, "Top", () => this.stage.lookFrom(new Vector3(0, -1e-3, 1), new Vector3(0, 0, 1)));
    button(views, "Front", () => this.stage.lookFrom(new Vector3(0, -1, 0), new Vector3(0, 0, 1)));
    button(views, "Side", () => this.stage.lookFrom(new Vector3(1, 0, 0), new Vector3(0, 0, 1)));
    button(views, "Zoom in", () => this.stage.zoom(0.85));
    button(views, "Zoom out", () => this.stage.zoom(1 / 0.85));
    controls.append(views);
    if (this.regions.length === 0) return;
    this.offerOpacity(controls);
    this.clip = offerClip(controls, axes, () => this.build());
  }

  private offerOpacity(controls: HTMLElement): void {
    const slider = element("input");
    Object.assign(slider, { type: "range", min: "0.05", max: "1", step: "0.05", value: String(this.opacity) });
    slider.addEventListener("input", () => {
      this.opacity = slider.valueAsNumber;
      this.build();
    });
    const label = element("label", "Opacity of the hull ");
    label.append(slider);
    controls.append(label);
  }

  private offerMoving(): void {
    const { platform, stage } = this;
    offerDragging(stage, {
      position: () => platform.position,
      grips: () => [platform.position, ...platform.anchors],
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
    const { frame, anchors, edges, position } = platform;
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
      lines(edges, colour("ink"), this.hovered ? 3.5 : 2.2),
      markers(frame, colour("ink"), 8, true),
      markers([position], colour("ink"), this.hovered ? 20 : 15, false),
      this.axes(),
    );
    this.stage.labels.set([...this.letters, ...this.axisLabels(), ...frame.map((at, index) => ({ at, text: this.words(index, tensions) }))]);
    this.stage.draw();
  }

  private words(index: number, tensions: number[] | null): string {
    const name = cableName(this.platform.data, index);
    const tension = tensions?.[index];
    return tension === undefined ? name : `${name}: ${tension.toFixed(0)} N`;
  }

  private buildHulls(): void {
    const { cuts } = this;
    const clip = this.clip();
    dispose(cuts);
    cuts.clear();
    this.letters = [];
    this.regions.forEach(({ region, shown, colour: name, letter, dashes }, index) => {
      const hull = this.surfaces[index] as Surface;
      hull.visible = shown;
      hull.renderOrder = index;
      if (!shown) return;
      dress(hull, colour(name), this.opacity, clip);
      if (clip) cuts.add(dashes === "none" ? lines(cut(region, clip), colour(name), 3) : dashed(cut(region, clip), colour(name), 0.01 * this.size));
      const at = top(region, clip);
      if (at) this.letters.push({ at, text: letter, className: "letter" });
    });
    if (clip) cuts.add(lines(this.clipFrame(clip), colour("muted"), 1));
    this.stage.draw();
  }

  private boxCorners(): Vector3[] {
    const { axes } = this.platform.data.grid;
    const ends = axes.map((axis) => [axis.start_m, axis.start_m + (axis.count - 1) * axis.step_m]);
    return [...Array(1 << axes.length).keys()].map((k) => this.platform.positionOf(ends.map((pair, axis) => pair[(k >> axis) & 1] as number)));
  }

  /** The rectangle that the clip plane cuts out of the grid's box. */
  private clipFrame(clip: Plane): Segment[] {
    const corners = this.boxCorners();
    const [low, high] = [corners[0] as Vector3, corners.at(-1) as Vector3];
    const size = high.clone().sub(low);
    const box = new EdgesGeometry(new BoxGeometry(size.x, size.y, size.z)).getAttribute("position");
    const middle = low.clone().lerp(high, 0.5);
    const flat = (index: number) => clip.projectPoint(new Vector3().fromBufferAttribute(box, index).add(middle), new Vector3());
    return [...Array(box.count / 2).keys()].map((k): Segment => [flat(2 * k), flat(2 * k + 1)]);
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
