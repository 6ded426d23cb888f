// The machine as it moves: cables by tension, the platform, and the way that its origin has gone.
import { axesOf } from "../robot";
import { AmbientLight, DirectionalLight, Group, Quaternion, Vector3 } from "three";
import { dashed, dispose, lines, markers } from "../scene/drawing";
import { type Segment, vector } from "../scene/geometry";
import { body, bounds, boxEdges, floor } from "../scene/solid";
import { Stage } from "../scene/stage";
import { offerViews } from "../scene/views";
import { colour, onThemeChange } from "../theme";
import { LOOKS, type TensionScale } from "../workspace/tension-style";
import { type Clock, momentAt } from "./clock";
import type { RunData } from "../data";
import { isBroken } from "./breaks";

const WORDS = "The machine in three dimensions. Arrow keys turn it, plus and minus zoom; the slider above goes through the time. The table below holds the numbers.";

/** Seconds of the way that is drawn behind the platform, and the most points of it. */
const TRAIL_S = 5;
const TRAIL_POINTS = 300;

/** The scene; throws where the browser has no WebGL. */
export class MachineScene {
  private readonly stage: Stage;
  private readonly moving = new Group();
  private readonly standing = new Group();
  private readonly size: number;
  private readonly box: [Vector3, Vector3];
  private readonly frame: Vector3[];

  constructor(
    place: HTMLElement,
    controls: HTMLElement,
    private readonly data: RunData,
    private readonly scale: TensionScale,
    private readonly clock: Clock,
  ) {
    this.stage = new Stage(place, WORDS);
    this.frame = data.robot.cables.map((cable) => vector(cable.frame_anchor_m));
    this.box = this.room();
    const corners = boxEdges(...this.box).flat();
    this.size = Math.max(...corners.map((point) => point.distanceTo(corners[0] as Vector3)), 1e-3);
    this.stage.frame([...corners, this.corner()]);
    const light = new DirectionalLight("#fff", 1.8);
    light.position.set(0.4, -1, 1.4);
    this.stage.content.add(new AmbientLight("#fff", 2.1), light, this.standing, this.moving);
    offerViews(controls, this.stage, data.robot.plane !== null, () => this.standardView());
    onThemeChange(() => {
      this.stand();
      this.move();
    });
    clock.onChange(() => this.move());
    this.stand();
    this.move();
    this.standardView();
    this.stage.drawNow();
  }

  /** The box of the frame anchors and of the places of the platform, down to its lowest one. */
  private room(): [Vector3, Vector3] {
    const { robot, moments } = this.data;
    const positions = moments.position_m.map(vector);
    const reach = Math.max(0, ...robot.cables.map((cable) => vector(cable.platform_anchor_m).length()));
    const [low, high] = bounds([...this.frame, ...positions]);
    const lowest = positions.reduce((least, point) => Math.min(least, point.z), Number.POSITIVE_INFINITY) - reach;
    if (!robot.plane && Number.isFinite(lowest)) low.z = Math.min(low.z, lowest);
    return [low, high];
  }

  private standardView(): void {
    const plane = this.data.robot.plane;
    if (!plane) return this.stage.lookFrom(new Vector3(0.75, -1, 0.5), new Vector3(0, 0, 1));
    const [first, second] = [vector(plane.first), vector(plane.second)];
    this.stage.lookFrom(first.clone().cross(second), second);
  }

  /** Floor, frame and axes. */
  private stand(): void {
    dispose(this.standing);
    this.standing.clear();
    const [low, high] = this.box;
    const plane = this.data.robot.plane;
    const span = high.clone().sub(low);
    const arm = (direction: Vector3) => direction.clone().multiplyScalar(span.dot(direction));
    const axes = this.axes();
    const [across, ground] = [arm(axes[0]?.direction as Vector3), arm(axes[1]?.direction as Vector3)];
    const corner = this.corner();
    this.standing.add(
      floor(low, across, ground, colour("shade")),
      lines(boxEdges(low, high), colour("edge"), 1),
      ...(plane ? [lines([[low, low.clone().add(across)]], colour("edge"), 3)] : []),
      lines(axes.map(({ direction }): Segment => [corner, this.tip(direction)]), colour("ink"), 2),
      markers(this.frame, colour("ink"), 8, true),
    );
  }

  private axes(): { name: string; direction: Vector3 }[] {
    return axesOf(this.data.robot).map(({ name, direction }) => ({ name, direction: vector(direction) }));
  }

  /** Beside the lowest corner of the frame, clear of the label of the anchor there. */
  private corner(): Vector3 {
    const away = this.axes().slice(0, 2).reduce((sum, { direction }) => sum.sub(direction), new Vector3());
    return this.box[0].clone().addScaledVector(away, 0.07 * this.size);
  }

  private tip(direction: Vector3): Vector3 {
    return this.corner().addScaledVector(direction, 0.1 * this.size);
  }

  /** Platform and cables at the time of the clock. */
  private move(): void {
    dispose(this.moving);
    this.moving.clear();
    const { robot, moments } = this.data;
    const at = momentAt(moments.time_s, this.clock.time);
    const position = vector(moments.position_m[at] ?? [0, 0, 0]);
    const rotation = new Quaternion(...(moments.quaternion_xyzw[at] ?? [0, 0, 0, 1]));
    const anchors = robot.cables.map((cable) => vector(cable.platform_anchor_m).applyQuaternion(rotation).add(position));
    const broken = new Set(robot.cables.map((_, cable) => cable).filter((cable) => isBroken(this.data, cable, this.clock.time)));
    const tensions = moments.tensions_N[at] ?? [];
    const [taut, slack]: [Segment[][], Segment[]] = [LOOKS.map(() => []), []];
    robot.cables.forEach((_, cable) => {
      if (broken.has(cable)) return;
      const segment: Segment = [this.frame[cable] as Vector3, anchors[cable] as Vector3];
      const tension = tensions[cable] ?? 0;
      if (tension > 0) taut[this.scale.step(tension)]?.push(segment);
      else slack.push(segment);
    });
    LOOKS.forEach((look, step) => this.moving.add(lines(taut[step] as Segment[], colour(look.colour), look.width)));
    if (slack.length > 0) this.moving.add(dashed(slack, colour("bad"), 0.01 * this.size));
    this.moving.add(lines(this.trail(at), colour("muted"), 1.5), body(anchors, this.size, { solid: colour("solid"), edge: colour("ink"), width: 2 }));
    const words = (cable: number) => (broken.has(cable) ? `${robot.cables[cable]?.name}: broken` : `${robot.cables[cable]?.name}: ${(tensions[cable] ?? 0).toFixed(0)} N`);
    this.stage.labels.set([
      ...this.frame.map((point, cable) => ({ at: point, text: words(cable) })),
      ...this.axes().map(({ name, direction }) => ({ at: this.tip(direction), text: name, className: "axis" })),
    ]);
    this.stage.draw();
  }

  /** The way of the platform's origin up to now. */
  private trail(at: number): Segment[] {
    const { time_s, position_m } = this.data.moments;
    const from = momentAt(time_s, (time_s[at] ?? 0) - TRAIL_S);
    const step = Math.max(1, Math.ceil((at - from) / TRAIL_POINTS));
    const points: Vector3[] = [];
    for (let index = at; index >= from; index -= step) points.push(vector(position_m[index] ?? [0, 0, 0]));
    return points.slice(1).map((point, index): Segment => [points[index] as Vector3, point]);
  }
}
