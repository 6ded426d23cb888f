// Correlations between the errors of all parameters: colour for the size, a sign in every strong cell.
import * as Plot from "@observablehq/plot";
import type { PageData } from "../data";
import type { Draw } from "../figure";
import { significant } from "../number";
import { frame } from "./style";

interface Cell {
  row: string;
  column: string;
  value: number;
}

const LIMITS = [-0.95, -0.7, -0.4, -0.1, 0.1, 0.4, 0.7, 0.95];
const COLOURS = [-4, -3, -2, -1, 0, 1, 2, 3, 4].map((step) => `var(--diverging-${step < 0 ? `n${-step}` : step})`);
/** More parameters than this have no room for their names. */
const MOST_NAMES = 48;

/** The lower triangle. */
export function correlation(data: PageData): Draw | null {
  const map = data.correlation;
  if (!map || map.names.length < 2) return null;
  const cells: Cell[] = map.lower.flatMap((values, row) =>
    values.flatMap((value, column) => (value === null ? [] : [{ row: map.names[row] as string, column: map.names[column] as string, value }])),
  );
  const strong = cells.filter((cell) => Math.abs(cell.value) >= 0.95 && cell.row !== cell.column);
  const named = map.names.length <= MOST_NAMES;
  const labelled = named ? map.names : firsts(map.names);
  const text = (name: string) => (named ? name : owner(name));
  return (width) => {
    const margin = named ? Math.min(150, 0.36 * width) : 70;
    const side = Math.min((width - margin - 10) / map.names.length, 26);
    const size = side * map.names.length;
    const fontSize = named ? Math.max(7, Math.min(11, side)) : 11;
    return Plot.plot(
      frame(margin + size + 10, {
        height: size + (named ? 120 : 64),
        marginLeft: margin,
        marginTop: 4,
        marginBottom: named ? 116 : 60,
        marginRight: 10,
        x: { type: "band", domain: map.names, ticks: labelled, tickRotate: -60, tickSize: 2, label: null, tickFormat: text, padding: 0 },
        y: { type: "band", domain: map.names, ticks: labelled, tickSize: 2, label: null, tickFormat: text, padding: 0 },
        color: { type: "threshold", domain: LIMITS, range: COLOURS },
        style: { fontSize: `${fontSize}px` },
        marks: [
          Plot.cell(cells, { x: "column", y: "row", fill: "value", inset: side > 8 ? 0.5 : 0 }),
          side >= 5 ? Plot.text(strong, { x: "column", y: "row", text: (cell: Cell) => (cell.value > 0 ? "+" : "−"), fill: "var(--on-strong)", fontWeight: 700, fontSize: Math.min(14, 1.2 * side) }) : null,
          Plot.tip(cells, Plot.pointer({ x: "column", y: "row", title: (cell: Cell) => `${cell.row}\n${cell.column}\ncorrelation ${significant(cell.value, 3)}`, fontSize: 12 })),
        ],
      }),
    );
  };
}

/** The first parameter of every cable, and of the wrench. */
function firsts(names: string[]): string[] {
  return names.filter((name, index) => index === 0 || owner(name) !== owner(names[index - 1] as string));
}

/** "cable 3" for frame-anchor[3].x, "wrench" for wrench.force_x. */
function owner(name: string): string {
  const cable = /\[(\d+)\]/.exec(name)?.[1];
  return cable ? `cable ${cable}` : (name.split(".")[0] ?? name);
}
