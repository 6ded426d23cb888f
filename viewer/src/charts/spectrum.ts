// Singular values of the Jacobian, and the course of the fit: two logarithmic curves.
import * as Plot from "@observablehq/plot";
import type { Candidate } from "../data";
import type { Draw } from "../figure";
import { powerOfTen, significant } from "../number";
import { ACCENT, BAD, PAPER, frame } from "./style";

interface Value {
  index: number;
  value: number;
  determined: boolean;
}

/** Singular values from large to small; those beyond the rank are open squares at the lower edge. */
export function spectrum(candidate: Candidate): Draw | null {
  const all = candidate.singular_values ?? [];
  const rank = candidate.rank ?? all.length;
  if (all.length === 0 || !((all[0] ?? 0) > 0)) return null;
  const least = Math.min(...all.slice(0, Math.max(1, rank)).filter((value) => value > 0));
  const floor = rank < all.length ? least / 10 : least;
  const values: Value[] = all.map((value, k) => ({ index: k + 1, value: Math.max(value, floor), determined: k < rank }));
  return (width) =>
    Plot.plot(
      frame(width, {
        height: 254,
        marginTop: 26,
        x: { label: "number of the singular value", labelAnchor: "center", labelArrow: "none", ticks: counting(values.length), tickFormat: "d" },
        y: logarithmic("singular value (SI units)", floor, all[0] as number),
        marks: [
          Plot.line(values, { x: "index", y: "value", stroke: ACCENT, strokeOpacity: 0.4 }),
          Plot.dot(values.filter((value) => value.determined), { x: "index", y: "value", r: 3.5, fill: ACCENT }),
          Plot.dot(values.filter((value) => !value.determined), { x: "index", y: "value", r: 4.5, symbol: "square", fill: PAPER, stroke: BAD, strokeWidth: 2 }),
          Plot.tip(values, Plot.pointerX({ x: "index", y: "value", title: (value: Value) => `no. ${value.index}: ${value.determined ? significant(value.value, 3) : "not determined"}` })),
        ],
      }),
    );
}

/** The cost after each step. */
export function convergence(candidate: Candidate): Draw | null {
  const history = (candidate.history ?? []).map((cost, step) => ({ step, cost })).filter((one) => one.cost > 0);
  if (history.length < 2) return null;
  const costs = history.map((one) => one.cost);
  return (width) =>
    Plot.plot(
      frame(width, {
        height: 234,
        marginTop: 26,
        x: { label: "step", labelAnchor: "center", labelArrow: "none", ticks: counting(history.length), tickFormat: "d" },
        y: logarithmic("cost (no unit)", Math.min(...costs), Math.max(...costs)),
        marks: [
          Plot.line(history, { x: "step", y: "cost", stroke: ACCENT, strokeWidth: 1.5 }),
          Plot.dot(history, { x: "step", y: "cost", r: 3, fill: ACCENT }),
          Plot.tip(history, Plot.pointerX({ x: "step", y: "cost", title: (one: { step: number; cost: number }) => `step ${one.step}: ${significant(one.cost, 5)}` })),
        ],
      }),
    );
}

function counting(count: number): number {
  return Math.min(10, count);
}

/** A logarithmic axis with ticks at whole powers of ten, at most eight. */
function logarithmic(label: string, low: number, high: number) {
  const from = Math.floor(Math.log10(low));
  const to = Math.max(from + 1, Math.ceil(Math.log10(high)));
  const step = Math.ceil((to - from) / 8);
  const ticks: number[] = [];
  for (let exponent = from; exponent <= to; exponent += step) ticks.push(10 ** exponent);
  return {
    type: "log" as const,
    domain: [10 ** from, 10 ** to],
    grid: true,
    ticks,
    tickFormat: (value: number) => powerOfTen(Math.round(Math.log10(value))),
    label,
    labelAnchor: "top" as const,
    labelArrow: "none" as const,
  };
}
