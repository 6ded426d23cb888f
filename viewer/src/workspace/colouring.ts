// What the colours of surfaces tell: which result, which cable limits, or the margin. Patches of a cable bear its name.
import { Vector3 } from "three";
import type { WorkspaceRegion } from "../data";
import { SHADES } from "./margin-chart";

/** What colours stand for. */
export type Colouring = "result" | "cable" | "margin";

/** Colours of cables (CSS variables); further cables begin anew, and their names tell them apart. */
const CABLE_COLOURS = 8;

/** The colour of a cable by its number from 1; 0 is none. */
export function cableColour(cable: number): string {
  return cable === 0 ? "var(--muted)" : `var(--cable-${((cable - 1) % CABLE_COLOURS) + 1})`;
}

/** The colour of a margin between the levels. */
export function marginColour(margin: number, levels: number[]): string {
  return SHADES[levels.filter((level) => margin >= level).length] as string;
}

/** True where the surface knows what the colours should tell. */
export function isKnown(region: WorkspaceRegion, colouring: Colouring): boolean {
  if (colouring === "result") return true;
  return (colouring === "cable" ? region.limiting_cable : region.margin).length * 3 === region.vertices_m.length;
}

/** The mean margin of every triangle's corners. */
export function marginsOf(region: WorkspaceRegion): number[] {
  const { triangles, margin } = region;
  const at = (index: number) => margin[triangles[index] as number] as number;
  return Array.from({ length: triangles.length / 3 }, (_, k) => (at(3 * k) + at(3 * k + 1) + at(3 * k + 2)) / 3);
}

/** A corner of a piece: the mean of these vertices. */
type Corner = number[];

/** A triangle that one cable limits. */
export interface Piece {
  corners: [Corner, Corner, Corner];
  cable: number;
}

/** The triangles of a surface, cut half-way between vertices that different cables limit, and the lines of these cuts. */
export function piecesOf({ triangles, limiting_cable }: WorkspaceRegion): { pieces: Piece[]; borders: [Corner, Corner][] } {
  const pieces: Piece[] = [];
  const borders: [Corner, Corner][] = [];
  const add = (vertex: number, ...corners: [Corner, Corner, Corner]) => pieces.push({ corners, cable: limiting_cable[vertex] as number });
  for (let k = 0; k + 2 < triangles.length; k += 3) {
    const corners = [0, 1, 2].map((corner) => triangles[k + corner] as number) as [number, number, number];
    const cables = corners.map((vertex) => limiting_cable[vertex]);
    const kinds = new Set(cables).size;
    if (kinds === 1) add(corners[0], [corners[0]], [corners[1]], [corners[2]]);
    else if (kinds === 2) {
      const alone = cables.findIndex((cable) => cables.indexOf(cable) === cables.lastIndexOf(cable));
      const [a, b, c] = [0, 1, 2].map((step) => corners[(alone + step) % 3]) as [number, number, number];
      add(a, [a], [a, b], [a, c]);
      add(b, [a, b], [b], [c]);
      add(b, [a, b], [c], [a, c]);
      borders.push([[a, b], [a, c]]);
    } else {
      corners.forEach((a, step) => {
        const [b, c] = [corners[(step + 1) % 3] as number, corners[(step + 2) % 3] as number];
        add(a, [a], [a, b], corners);
        add(a, [a], corners, [a, c]);
        borders.push([[a, b], corners]);
      });
    }
  }
  return { pieces, borders };
}

/** The place of a corner. */
export function placeOf(region: WorkspaceRegion, corner: Corner): Vector3 {
  return corner.reduce((sum, vertex) => sum.add(point(region, vertex)), new Vector3()).divideScalar(corner.length);
}

/** Area of a piece (m²). */
export function areaOf(region: WorkspaceRegion, { corners }: Piece): number {
  const [a, b, c] = corners.map((corner) => placeOf(region, corner)) as [Vector3, Vector3, Vector3];
  return 0.5 * b.sub(a).cross(c.sub(a)).length();
}

/** Neighbouring vertices that one cable limits, with some of them where its name may stand. */
export interface Patch {
  cable: number;
  /** Share of all vertices of the surface. */
  share: number;
  places: { at: Vector3; normal: Vector3 }[];
}

/** Places that a patch offers for its name. */
const PLACES = 24;

/** The patches of a surface; `normals` are those of its vertices, three numbers each. */
export function patchesOf(region: WorkspaceRegion, normals: ArrayLike<number>): Patch[] {
  const count = region.limiting_cable.length;
  const neighbours: number[][] = Array.from({ length: count }, () => []);
  const edges = new Array<number>(count).fill(0);
  region.triangles.forEach((from, k) => {
    const to = region.triangles[k % 3 === 2 ? k - 2 : k + 1] as number;
    edges[from] = (edges[from] ?? 0) + 1;
    edges[to] = (edges[to] ?? 0) + 1;
    if (region.limiting_cable[from] !== region.limiting_cable[to]) return;
    neighbours[from]?.push(to);
    neighbours[to]?.push(from);
  });
  return joined(neighbours).map((vertices) => {
    const stride = Math.ceil(vertices.length / PLACES);
    // away from the edge every edge of the surface stays within the patch, and each is met from both of its triangles
    const inner = vertices.filter((vertex) => (neighbours[vertex]?.length ?? 0) === edges[vertex]);
    const chosen = (inner.length > 0 ? inner : vertices).filter((_, k) => k % stride === 0);
    const places = chosen.map((vertex) => ({ at: point(region, vertex), normal: new Vector3(normals[3 * vertex], normals[3 * vertex + 1], normals[3 * vertex + 2]) }));
    return { cable: region.limiting_cable[vertices[0] as number] as number, share: vertices.length / count, places };
  });
}

/** Vertices that hang together, list by list. */
function joined(neighbours: number[][]): number[][] {
  const met = neighbours.map(() => false);
  const groups: number[][] = [];
  neighbours.forEach((_, start) => {
    if (met[start]) return;
    met[start] = true;
    const group = [start];
    for (let next = 0; next < group.length; next++) {
      for (const other of neighbours[group[next] as number] as number[]) {
        if (met[other]) continue;
        met[other] = true;
        group.push(other);
      }
    }
    groups.push(group);
  });
  return groups;
}

function point(region: WorkspaceRegion, index: number): Vector3 {
  return new Vector3().fromArray(region.vertices_m, 3 * index);
}
