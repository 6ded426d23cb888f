// A hull or another surface in space: transparent, painted, with a plane that may cut it, and the line of the cut.
import { BufferAttribute, BufferGeometry, Color, DoubleSide, Mesh, MeshLambertMaterial, Plane, Vector3 } from "three";
import type { Segment } from "../scene/geometry";
import { type Piece, placeOf } from "./colouring";
import type { WorkspaceRegion } from "../data";

/** The surface as three.js keeps it (world, m). */
export function geometryOf(region: WorkspaceRegion): BufferGeometry {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(new Float32Array(region.vertices_m), 3));
  geometry.setIndex(region.triangles);
  geometry.computeVertexNormals();
  return geometry;
}

/** The surface, from both sides; `paint` or `paintEach` and `dress` give it its looks. */
export type Surface = Mesh<BufferGeometry, MeshLambertMaterial>;

export function surface(region: WorkspaceRegion): Surface {
  return new Mesh(geometryOf(region), new MeshLambertMaterial({ side: DoubleSide }));
}

/** One colour for all of it. */
export function paint({ material }: Surface, color: string): void {
  material.vertexColors = false;
  material.color.set(color);
}

/** A colour for each triangle of this geometry, whose triangles have corners of their own. */
export function paintEach({ material }: Surface, geometry: BufferGeometry, colours: string[]): void {
  const known = new Map([...new Set(colours)].map((name) => [name, new Color(name)]));
  const values = new Float32Array(9 * colours.length);
  colours.forEach((name, triangle) => {
    for (const corner of [0, 1, 2]) known.get(name)?.toArray(values, 9 * triangle + 3 * corner);
  });
  geometry.setAttribute("color", new BufferAttribute(values, 3));
  material.vertexColors = true;
  material.color.set("#fff");
}

/** The pieces of a surface, each corner with the mean normal of its vertices. */
export function geometryOfPieces(region: WorkspaceRegion, pieces: Piece[], normals: ArrayLike<number>): BufferGeometry {
  const corners = pieces.flatMap((piece) => piece.corners);
  const normal = (corner: number[]) => corner.reduce((sum, vertex) => sum.add(new Vector3(normals[3 * vertex], normals[3 * vertex + 1], normals[3 * vertex + 2])), new Vector3()).normalize();
  const geometry = new BufferGeometry();
  const flat = (of: (corner: number[]) => Vector3) => new BufferAttribute(new Float32Array(corners.flatMap((corner) => of(corner).toArray())), 3);
  geometry.setAttribute("position", flat((corner) => placeOf(region, corner)));
  geometry.setAttribute("normal", flat(normal));
  return geometry;
}

/** Transparency and the plane that cuts it, if any. */
export function dress({ material }: Surface, opacity: number, clip: Plane | null): void {
  Object.assign(material, { opacity, transparent: opacity < 1, depthWrite: opacity >= 1, clippingPlanes: clip ? [clip] : [] });
  material.needsUpdate = true;
}

/** Where the surface meets a plane. */
export function cut(region: WorkspaceRegion, plane: Plane): Segment[] {
  const point = (index: number) => new Vector3().fromArray(region.vertices_m, 3 * index);
  const found: Segment[] = [];
  for (let k = 0; k + 2 < region.triangles.length; k += 3) {
    const corners = [0, 1, 2].map((corner) => point(region.triangles[k + corner] as number));
    const heights = corners.map((corner) => plane.distanceToPoint(corner));
    const crossings = [0, 1, 2].flatMap((from) => {
      const to = (from + 1) % 3;
      const [a, b] = [heights[from] as number, heights[to] as number];
      return a < 0 === b < 0 ? [] : [(corners[from] as Vector3).clone().lerp(corners[to] as Vector3, a / (a - b))];
    });
    if (crossings.length === 2) found.push(crossings as Segment);
  }
  return found;
}

/** The highest vertex that the plane leaves, where the hull's letter stands; null where it leaves none. */
export function top(region: WorkspaceRegion, clip: Plane | null): Vector3 | null {
  let best: Vector3 | null = null;
  for (let k = 0; k + 2 < region.vertices_m.length; k += 3) {
    const vertex = new Vector3().fromArray(region.vertices_m, k);
    if (clip && clip.distanceToPoint(vertex) < 0) continue;
    if (!best || vertex.z > best.z) best = vertex;
  }
  return best;
}
