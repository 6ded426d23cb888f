// Robots of pages: labels of their cables, and vectors along their axes.
import type { Robot } from "./data";

/** World components. */
export type Vector = [number, number, number];

/** A cable's number, with its name where that is another. */
export function cableLabel({ cables }: Robot, index: number): string {
  const [number, name] = [String(index + 1), cables[index]?.name];
  return name === undefined || name === number ? `cable ${number}` : `cable ${number}: ${name}`;
}

/** Axes of the robot: two in a plane. */
export function axesOf({ axes, plane }: Robot): { name: string; direction: Vector }[] {
  const directions: Vector[] = plane ? [plane.first, plane.second] : [[1, 0, 0], [0, 1, 0], [0, 0, 1]];
  return directions.map((direction, k) => ({ name: axes[k] ?? "", direction }));
}

/** Components of a world vector along the axes of the robot. */
export function alongAxes(robot: Robot, vector: Vector): number[] {
  return axesOf(robot).map(({ direction }) => direction[0] * vector[0] + direction[1] * vector[1] + direction[2] * vector[2]);
}
