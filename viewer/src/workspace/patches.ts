// Patches of a plane of the grid that one cable limits: their cells with the cable's colour, and a place for its name.

/** Neighbouring cells that one cable limits. */
export interface CablePatch {
  /** From 0; −1 for none. */
  cable: number;
  /** Cells of the patch, row by row from below. */
  cells: number[];
  /** The cell farthest from the edge of the patch. */
  middle: number;
}

/** The patches of `columns` cells a row, each with the number of its cable. */
export function patchesOfPlane(cables: number[], columns: number): CablePatch[] {
  const neighbours = (cell: number) => [cell % columns > 0 ? cell - 1 : -1, cell % columns < columns - 1 ? cell + 1 : -1, cell - columns, cell + columns];
  const isEqual = (cell: number, other: number) => other >= 0 && cables[other] === cables[cell];
  const depths = depthsOf(cables, (cell) => neighbours(cell).filter((other) => isEqual(cell, other)));
  const met = cables.map(() => false);
  const patches: CablePatch[] = [];
  cables.forEach((cable, start) => {
    if (met[start]) return;
    met[start] = true;
    const cells = [start];
    for (let next = 0; next < cells.length; next++) {
      const cell = cells[next] as number;
      for (const other of neighbours(cell)) {
        if (!isEqual(cell, other) || met[other]) continue;
        met[other] = true;
        cells.push(other);
      }
    }
    patches.push({ cable, cells, middle: cells.reduce((best, cell) => ((depths[cell] as number) > (depths[best] as number) ? cell : best)) });
  });
  return patches;
}

/** Steps from each cell to the edge of its patch. */
function depthsOf(cables: number[], same: (cell: number) => number[]): number[] {
  const depths: number[] = cables.map((_, cell) => (same(cell).length < 4 ? 0 : -1));
  const queue = depths.flatMap((depth, cell) => (depth === 0 ? [cell] : []));
  for (let next = 0; next < queue.length; next++) {
    const cell = queue[next] as number;
    for (const other of same(cell)) {
      if (depths[other] !== -1) continue;
      depths[other] = (depths[cell] as number) + 1;
      queue.push(other);
    }
  }
  // a plane that one cable limits has no edge within
  return depths.map((depth) => Math.max(depth, 0));
}
