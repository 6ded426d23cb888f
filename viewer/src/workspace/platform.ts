// Where the platform stands: one value that every part of the page shows and may change.
import { Quaternion, Vector3 } from "three";
import type { Vector } from "../robot";
import { type Segment, edgesOf, vector } from "../scene/geometry";
import type { WorkspaceData } from "../data";
import { type Reading, inside, read, snapped } from "./field";

/** The platform and what is known of it there. */
export class Platform {
  /** Along the axes of the grid (m). */
  coordinates: number[];
  reading: Reading;
  private snaps = false;
  private readonly rotation: Quaternion;
  private readonly listeners: (() => void)[] = [];

  constructor(readonly data: WorkspaceData) {
    this.rotation = new Quaternion(...data.start.quaternion_xyzw);
    this.coordinates = inside(data.grid, this.coordinatesOf(vector(data.start.position_m)));
    this.reading = read(data.grid, this.coordinates);
  }

  /** Calls back after every move. */
  onMove(listener: () => void): void {
    this.listeners.push(listener);
  }

  /** Moves to these coordinates, or as near as the grid reaches. */
  moveTo(coordinates: number[]): void {
    this.coordinates = this.snaps ? snapped(this.data.grid, coordinates) : inside(this.data.grid, coordinates);
    this.reading = read(this.data.grid, this.coordinates);
    for (const listener of this.listeners) listener();
  }

  /** Moves by so many steps of the grid along one of its axes; a step is a tenth of the grid's unless it snaps. */
  step(axis: number, steps: number): void {
    const size = (this.data.grid.axes[axis]?.step_m ?? 0) * (this.snaps ? 1 : 0.1);
    this.moveTo(this.coordinates.map((value, k) => (k === axis ? value + steps * size : value)));
  }

  /** Keeps to the nodes of the grid, or not. */
  snap(snaps: boolean): void {
    this.snaps = snaps;
    this.moveTo(this.coordinates);
  }

  /** The world position of coordinates along the grid's axes. */
  positionOf(coordinates: number[]): Vector3 {
    const { axes, base_m } = this.data.grid;
    return axes.reduce((point, axis, k) => point.addScaledVector(vector(axis.direction), coordinates[k] ?? 0), vector(base_m));
  }

  /** The coordinates of a world position along the grid's axes. */
  coordinatesOf(position: Vector3): number[] {
    return this.data.grid.axes.map((axis) => position.dot(vector(axis.direction)));
  }

  get position(): Vector3 {
    return this.positionOf(this.coordinates);
  }

  /** Where the cables leave the frame. */
  get frame(): Vector3[] {
    return this.data.robot.cables.map((cable) => vector(cable.frame_anchor_m));
  }

  /** Where they are fastened to the platform, in the world. */
  get anchors(): Vector3[] {
    const position = this.position;
    return this.data.robot.cables.map((cable) => vector(cable.platform_anchor_m).applyQuaternion(this.rotation).add(position));
  }

  /** Edges that show the platform's body. */
  get edges(): Segment[] {
    return edgesOf(this.anchors, this.position);
  }
}

/** A cable's name for people. */
export function cableName(data: WorkspaceData, index: number): string {
  return data.robot.cables[index]?.name ?? String(index + 1);
}

export function plain(point: Vector3): Vector {
  return [point.x, point.y, point.z];
}
