// The robot as a light solid: its platform, its pulleys, the floor below it and the edges of its frame.
import { BufferGeometry, CylinderGeometry, DoubleSide, EdgesGeometry, Float32BufferAttribute, Group, Mesh, MeshBasicMaterial, MeshLambertMaterial, type Object3D, Quaternion, SphereGeometry, Vector3 } from "three";
import { ConvexGeometry } from "three/examples/jsm/geometries/ConvexGeometry.js";
import type { Segment } from "./geometry";
import { lines } from "./drawing";

/** Colours of a body and of its edges. */
export interface Look {
  solid: string;
  edge: string;
  width: number;
}

/** The convex body of a platform's anchors (world); a flat one gets a thickness, a point a ball. `size` is that of the scene (m). */
export function body(anchors: Vector3[], size: number, look: Look): Object3D {
  const shape = hull(anchors, size);
  const made = new Group();
  made.add(new Mesh(shape, new MeshLambertMaterial({ color: look.solid, side: DoubleSide, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 })));
  if (!(shape instanceof SphereGeometry)) made.add(lines(edgesOf(shape), look.edge, look.width));
  return made;
}

function hull(anchors: Vector3[], size: number): BufferGeometry {
  const centre = anchors.reduce((sum, point) => sum.add(point), new Vector3()).divideScalar(Math.max(1, anchors.length));
  const arms = anchors.map((point) => point.clone().sub(centre));
  const first = arms.reduce((longest, arm) => (arm.length() > longest.length() ? arm : longest), new Vector3());
  const normal = arms.map((arm) => first.clone().cross(arm)).reduce((largest, cross) => (cross.length() > largest.length() ? cross : largest), new Vector3());
  const extent = first.length();
  if (normal.length() < 1e-3 * Math.max(extent * extent, 1e-6 * size * size)) return new SphereGeometry(Math.max(0.012 * size, extent), 24, 16).translate(centre.x, centre.y, centre.z);
  normal.normalize();
  const height = Math.max(...arms.map((arm) => Math.abs(arm.dot(normal))));
  const half = height > 0.02 * extent ? 0 : 0.04 * extent;
  const points = half === 0 ? anchors : anchors.flatMap((point) => [half, -half].map((shift) => point.clone().addScaledVector(normal, shift)));
  return new ConvexGeometry(points);
}

function edgesOf(shape: BufferGeometry): Segment[] {
  const edges = new EdgesGeometry(shape, 12);
  const at = edges.getAttribute("position");
  const point = (index: number) => new Vector3().fromBufferAttribute(at, index);
  const found = Array.from({ length: at.count / 2 }, (_, edge): Segment => [point(2 * edge), point(2 * edge + 1)]);
  edges.dispose();
  return found;
}

/** A drum between the ends of its axis. */
export function drum(from: Vector3, to: Vector3, radius: number, look: Look): Object3D {
  const shape = new CylinderGeometry(radius, radius, from.distanceTo(to), 32);
  const made = new Group();
  made.add(new Mesh(shape, new MeshLambertMaterial({ color: look.solid, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 })), lines(edgesOf(shape), look.edge, look.width));
  made.quaternion.copy(new Quaternion().setFromUnitVectors(new Vector3(0, 1, 0), to.clone().sub(from).normalize()));
  made.position.copy(from).add(to).multiplyScalar(0.5);
  return made;
}

/** A wheel that the cable to `end` turns around; `entry` is where the cable enters it, `swivel` the axis that it swivels about. */
export function wheel(entry: Vector3, end: Vector3, swivel: Vector3, radius: number, look: Look): Object3D {
  const axis = swivel.clone().normalize();
  const arm = end.clone().sub(entry);
  const towards = arm.addScaledVector(axis, -arm.dot(axis)).normalize();
  const shape = new CylinderGeometry(radius, radius, 0.3 * radius, 32);
  const mesh = new Mesh(shape, new MeshLambertMaterial({ color: look.solid, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 }));
  const rims = lines(edgesOf(shape), look.edge, 1);
  const made = new Group();
  made.add(mesh, rims);
  made.quaternion.copy(new Quaternion().setFromUnitVectors(new Vector3(0, 1, 0), towards.clone().cross(axis).normalize()));
  made.position.copy(entry).addScaledVector(towards, radius);
  return made;
}

/** The ground, or in a plane the area of the frame: a parallelogram from a corner. */
export function floor(corner: Vector3, first: Vector3, second: Vector3, color: string): Object3D {
  const [a, b, c, d] = [corner, corner.clone().add(first), corner.clone().add(first).add(second), corner.clone().add(second)];
  const shape = new BufferGeometry();
  shape.setAttribute("position", new Float32BufferAttribute([a, b, c, a, c, d].flatMap((point) => point.toArray()), 3));
  const made = new Mesh(shape, new MeshBasicMaterial({ color, side: DoubleSide, depthWrite: false }));
  made.renderOrder = -1; // below everything
  return made;
}

/** The twelve edges of a box, without those that have no length. */
export function boxEdges(low: Vector3, high: Vector3): Segment[] {
  const corner = (k: number) => new Vector3(k & 1 ? high.x : low.x, k & 2 ? high.y : low.y, k & 4 ? high.z : low.z);
  const all = [0, 1, 2, 3, 4, 5, 6, 7].flatMap((k) => [1, 2, 4].filter((bit) => !(k & bit)).map((bit): Segment => [corner(k), corner(k | bit)]));
  return all.filter(([from, to]) => from.distanceTo(to) > 1e-9);
}

/** Least and largest coordinates. */
export function bounds(points: Vector3[]): [Vector3, Vector3] {
  const low = points.reduce((corner, point) => corner.min(point), new Vector3(Infinity, Infinity, Infinity));
  const high = points.reduce((corner, point) => corner.max(point), new Vector3(-Infinity, -Infinity, -Infinity));
  return [low, high];
}
