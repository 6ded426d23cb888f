// Values between the nodes of the grid. Nothing is computed here but means of what the block states.
import type { Grid } from "../data";

/** What is known at a point of the grid's box. */
export interface Reading {
  /** All nodes around it hold, all fail, or some do. */
  verdict: "holds" | "fails" | "between";
  margin: number;
  /** Per cable (N); null where the nodes have none. */
  tensions: number[] | null;
  /** Interpolated between all nodes around, or those of the nearest one. */
  from: "interpolated" | "nearest";
  /** Of the nearest node that fails; null where all hold. */
  reason: string | null;
  /** The limiting cable of the nearest node, from 0. */
  cable: number | null;
}

interface Corner {
  node: number;
  weight: number;
}

/** The values at coordinates along the grid's axes (m), which are moved into its box. */
export function read(grid: Grid, coordinates: number[]): Reading {
  const corners = around(grid, coordinates);
  const nearest = corners[0] as Corner;
  const failing = corners.filter(({ node }) => !holds(grid, node));
  const tensions = tensionsOf(grid, corners);
  return {
    verdict: failing.length === 0 ? "holds" : failing.length === corners.length ? "fails" : "between",
    margin: corners.reduce((sum, { node, weight }) => sum + weight * marginOf(grid, node), 0),
    tensions: tensions ?? grid.tensions_N[nearest.node] ?? null,
    from: tensions ? "interpolated" : "nearest",
    reason: failing[0] ? reasonOf(grid, failing[0].node) : null,
    cable: cableOf(grid, (failing[0] ?? nearest).node),
  };
}

/** The coordinates moved into the box of the grid. */
export function inside(grid: Grid, coordinates: number[]): number[] {
  return grid.axes.map((axis, k) => {
    const last = axis.start_m + (axis.count - 1) * axis.step_m;
    return Math.min(last, Math.max(axis.start_m, coordinates[k] ?? axis.start_m));
  });
}

/** The coordinates of the nearest node. */
export function snapped(grid: Grid, coordinates: number[]): number[] {
  return inside(grid, coordinates).map((value, k) => {
    const { start_m, step_m } = grid.axes[k] as Grid["axes"][number];
    return step_m > 0 ? start_m + Math.round((value - start_m) / step_m) * step_m : start_m;
  });
}

/** The margin at a node; −∞ where nothing could mend it. */
export function marginOf(grid: Grid, node: number): number {
  return grid.margin[node] ?? Number.NEGATIVE_INFINITY;
}

function holds(grid: Grid, node: number): boolean {
  return marginOf(grid, node) >= 0;
}

/** The nodes around a point with their shares, the nearest first; nodes without a share are left out. */
function around(grid: Grid, coordinates: number[]): Corner[] {
  let corners: Corner[] = [{ node: 0, weight: 1 }];
  let stride = 1;
  inside(grid, coordinates).forEach((value, k) => {
    const { start_m, step_m, count } = grid.axes[k] as Grid["axes"][number];
    const at = step_m > 0 ? (value - start_m) / step_m : 0;
    const low = Math.max(0, Math.min(count - 2, Math.floor(at)));
    // a node hit to rounding is that node
    const share = Math.abs(at - Math.round(at)) < 1e-9 ? Math.round(at) - low : at - low;
    corners = corners.flatMap(({ node, weight }) => [
      { node: node + low * stride, weight: weight * (1 - share) },
      { node: node + Math.min(low + 1, count - 1) * stride, weight: weight * share },
    ]).filter(({ weight }) => weight > 0);
    stride *= count;
  });
  return corners.sort((a, b) => b.weight - a.weight);
}

/** Null where a node around has none. */
function tensionsOf(grid: Grid, corners: Corner[]): number[] | null {
  const known = corners.map(({ node, weight }) => ({ weight, tensions: grid.tensions_N[node] ?? null }));
  const first = known[0]?.tensions;
  if (!first || known.some(({ tensions }) => tensions === null)) return null;
  return first.map((_, cable) => known.reduce((sum, { weight, tensions }) => sum + weight * (tensions?.[cable] ?? 0), 0));
}

function reasonOf(grid: Grid, node: number): string | null {
  const sentence = grid.sentences[grid.reason[node] ?? -1];
  if (sentence === undefined) return null;
  const numbers = (grid.numbers[node] ?? "").split(" ");
  let next = 0;
  return sentence.replace(/§/g, () => numbers[next++] ?? "");
}

function cableOf(grid: Grid, node: number): number | null {
  const cable = grid.cable[node] ?? -1;
  return cable < 0 ? null : cable;
}
