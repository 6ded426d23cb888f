// The candidates from simple to complex: criterion on validation data with one standard error.
import * as Plot from "@observablehq/plot";
import type { PageData } from "../data";
import type { Draw } from "../figure";
import { significant } from "../number";
import { ACCENT, BAD, INK, MUTED, PAPER, frame } from "./style";

interface Rung {
  row: number;
  name: string;
  value: number;
  low: number;
  high: number;
  chosen: boolean;
  failure: string | undefined;
}

/** A row for each candidate, its name above its bar; the dashed line is the best plus one standard error. */
export function ladder(data: PageData): Draw | null {
  const rungs = data.result.candidates.map((candidate, index) => rung(data, candidate, index));
  const values = rungs.filter((one) => Number.isFinite(one.value));
  if (rungs.length < 2 || values.length === 0) return null;
  const best = rungs.find((one) => one.name === data.result.best);
  const wide = Math.max(...values.map((one) => one.high));
  return (width) => {
    const letters = Math.floor((width - 90) / 6.6);
    return Plot.plot(
      frame(width, {
        height: 34 * rungs.length + 64,
        marginLeft: 34,
        marginTop: 10,
        x: { domain: [0, 1.02 * wide], label: `${data.criterion.words} on ${data.data_words}, ${data.criterion.unit}`, grid: true, labelAnchor: "center", labelArrow: "none" },
        y: { domain: [rungs.length + 0.5, 0.4], axis: null },
        marks: [
          Plot.rect(rungs.filter((one) => one.chosen), { x1: 0, x2: 1.02 * wide, y1: (one: Rung) => one.row - 0.5, y2: (one: Rung) => one.row + 0.5, fill: "var(--accent-shade)" }),
          // dashes beside the bars only: a line through the names would cross letters
          best ? Plot.ruleX(rungs, { x: best.high, y1: (one: Rung) => one.row - 0.08, y2: (one: Rung) => one.row + 0.42, stroke: BAD, strokeWidth: 1.5 }) : null,
          Plot.text(rungs, { x: 0, y: "row", text: (one: Rung) => String(one.row), dx: -8, textAnchor: "end", fill: MUTED }),
          Plot.text(rungs, { x: 0, y: "row", text: (one: Rung) => label(one, letters), dx: 4, dy: -9, textAnchor: "start", fontFamily: "var(--mono)", fontSize: 11, fill: INK, stroke: PAPER, strokeWidth: 4, title: "name" }),
          Plot.ruleY(values, { y: "row", x1: "low", x2: "high", stroke: (one: Rung) => (one.chosen ? ACCENT : MUTED), strokeWidth: 2, dy: 5 }),
          Plot.dot(values, { x: "value", y: "row", dy: 5, r: 5, symbol: (one: Rung) => (one.chosen ? "diamond" : "circle"), fill: (one: Rung) => (one.chosen ? ACCENT : MUTED), stroke: "var(--paper)" }),
          Plot.tip(values, Plot.pointerY({ x: "value", y: "row", title: (one: Rung) => tip(data, one) })),
        ],
      }),
    );
  };
}

function rung(data: PageData, candidate: PageData["result"]["candidates"][number], index: number): Rung {
  const factor = data.criterion.factor;
  const value = factor * (candidate.criterion ?? Number.NaN);
  const error = factor * (candidate.standard_error ?? 0);
  const chosen = data.result.recommended === candidate.name;
  return { row: index + 1, name: candidate.name, value, low: value - error, high: value + error, chosen, failure: candidate.failure };
}

function label(one: Rung, letters: number): string {
  const marks = `${one.chosen ? " ◆" : ""}${one.failure ? " (not identified)" : ""}`;
  const room = Math.max(12, letters - marks.length);
  const name = one.name.length > room ? `${one.name.slice(0, room - 1)}…` : one.name;
  return name + marks;
}

function tip(data: PageData, one: Rung): string {
  const half = 0.5 * (one.high - one.low);
  return `${one.name}\n${significant(one.value, 4)} ± ${significant(half, 2)} ${data.criterion.unit}`;
}
