// A hull in space: a transparent surface that a plane may cut, and the line of the cut.
import { BufferAttribute, BufferGeometry, DoubleSide, Mesh, MeshLambertMaterial, Plane, Vector3 } from "three";
import type { Segment } from "../scene/geometry";
import type { Region } from "./data";

/** The surface as three.js keeps it (world, m). */
export function geometryOf(region: Region): BufferGeometry {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(new Float32Array(region.vertices_m), 3));
  geometry.setIndex(region.triangles);
  geometry.computeVertexNormals();
  return geometry;
}

/** The surface, from both sides; `dress` gives it its looks. */
export type Surface = Mesh<BufferGeometry, MeshLambertMaterial>;

export function surface(region: Region): Surface {
  return new Mesh(geometryOf(region), new MeshLambertMaterial({ side: DoubleSide }));
}

/** Colour, transparency and the plane that cuts it, if any. */
export function dress({ material }: Surface, color: string, opacity: number, clip: Plane | null): void {
  material.color.set(color);
  Object.assign(material, { opacity, transparent: opacity < 1, depthWrite: opacity >= 1, clippingPlanes: clip ? [clip] : [] });
  material.needsUpdate = true;
}

/** Where the surface meets a plane. */
export function cut(region: Region, plane: Plane): Segment[] {
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
export function top(region: Region, clip: Plane | null): Vector3 | null {
  let best: Vector3 | null = null;
  for (let k = 0; k + 2 < region.vertices_m.length; k += 3) {
    const vertex = new Vector3().fromArray(region.vertices_m, k);
    if (clip && clip.distanceToPoint(vertex) < 0) continue;
    if (!best || vertex.z > best.z) best = vertex;
  }
  return best;
}
