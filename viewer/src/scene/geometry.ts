// Points and segments of the robot for the scene: no physics, only rotations of given points and magnified differences.
import { Quaternion, Vector3 } from "three";
import type { Cable, SampleErrors, ReportData } from "../data";
import type { Vector } from "../robot";

/** A line from one point to another. */
export type Segment = [Vector3, Vector3];

/** The robot at a pose: anchors in the world, and the edges that show its platform. */
export interface Posed {
  frame: Vector3[];
  platform: Vector3[];
  cables: Segment[];
  edges: Segment[];
}

/** Which of the two robots. */
export type Which = "nominal" | "calibrated";

/** The robot at a measured pose. Differences of the calibrated anchors from the nominal ones are multiplied. */
export function posed(data: ReportData, row: number, which: Which, magnification: number): Posed {
  const position = vector(data.samples.position_m[row] ?? [0, 0, 0]);
  const rotation = new Quaternion(...(data.samples.quaternion_xyzw[row] ?? [0, 0, 0, 1]));
  const factor = which === "nominal" ? 0 : magnification;
  const nominal = (index: number) => data.given_robot.cables[index] as Cable;
  const frame = data.robot.cables.map((cable, index) => between(nominal(index).frame_anchor_m, cable.frame_anchor_m, factor));
  const platform = data.robot.cables.map((cable, index) =>
    between(nominal(index).platform_anchor_m, cable.platform_anchor_m, factor).applyQuaternion(rotation).add(position),
  );
  const cables = frame.map((anchor, cable): Segment => [anchor, platform[cable] as Vector3]);
  return { frame, platform, cables, edges: edgesOf(platform, position) };
}

/** Every anchor of the platform joined to its two nearest neighbours and to the origin: a body without asking for its hull. */
export function edgesOf(platform: Vector3[], origin: Vector3): Segment[] {
  const found = new Map<string, Segment>();
  platform.forEach((point, index) => {
    const near = platform
      .map((other, at) => ({ other, at, distance: other.distanceTo(point) }))
      .filter(({ at, distance }) => at !== index && distance > 1e-9)
      .sort((a, b) => a.distance - b.distance)
      .slice(0, 3);
    for (const { other, at } of near) found.set([Math.min(index, at), Math.max(index, at)].join(), [point, other]);
    if (point.distanceTo(origin) > 1e-9) found.set(`origin ${index}`, [origin, point]);
  });
  return [...found.values()];
}

/** Error vectors at the measured positions, multiplied. */
export function errorVectors(data: ReportData, errors: SampleErrors, magnification: number): { segment: Segment; size: number; row: number }[] {
  return data.samples.position_m.flatMap((position, row) => {
    const error = errors.position_error_m[row];
    if (!error) return [];
    const from = vector(position);
    return [{ segment: [from, from.clone().addScaledVector(vector(error), magnification)] as Segment, size: Math.hypot(...error), row }];
  });
}

/** Largest distance of a calibrated anchor from its nominal place (m). */
export function largestShift({ robot, given_robot }: ReportData): number {
  const shift = (a: Vector, b: Vector) => vector(a).distanceTo(vector(b));
  const shifts = robot.cables.flatMap((cable, index) => {
    const given = given_robot.cables[index] as Cable;
    return [shift(cable.frame_anchor_m, given.frame_anchor_m), shift(cable.platform_anchor_m, given.platform_anchor_m)];
  });
  return Math.max(0, ...shifts);
}

/** 1, 2, 5, 10, 20, …: the largest that is not above the number. */
export function roundMagnification(value: number): number {
  if (!Number.isFinite(value) || value <= 1) return 1;
  const power = 10 ** Math.floor(Math.log10(value));
  const step = [5, 2, 1].find((candidate) => candidate * power <= value) ?? 1;
  return step * power;
}

export function vector([x, y, z]: Vector): Vector3 {
  return new Vector3(x, y, z);
}

function between(nominal: Vector, calibrated: Vector, factor: number): Vector3 {
  return vector(nominal).lerp(vector(calibrated), factor);
}
