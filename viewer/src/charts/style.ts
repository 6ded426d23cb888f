// What all charts share: colours as CSS variables, so that light, dark and print are one drawing.
import type { PlotOptions } from "@observablehq/plot";

export const INK = "var(--ink)";
export const MUTED = "var(--muted)";
export const LINE = "var(--line)";
export const ACCENT = "var(--accent)";
export const SECOND = "var(--second)";
export const BAD = "var(--bad)";
export const PAPER = "var(--paper)";

/** Six steps from small to large. */
export const STEPS = [1, 2, 3, 4, 5, 6].map((step) => `var(--step-${step})`);

/** Options of every plot. */
export function frame(width: number, options: PlotOptions): PlotOptions {
  return {
    width,
    marginLeft: 62,
    marginRight: 20,
    marginBottom: 44,
    ...options,
    style: { background: "transparent", color: INK, fontSize: "12px", overflow: "visible", ...(options.style as object) },
  };
}

/** Metres as millimetres. */
export const mm = (value: number | null | undefined): number => (value ?? Number.NaN) * 1e3;

/** Radians as degrees. */
export const degrees = (value: number | null | undefined): number => ((value ?? Number.NaN) * 180) / Math.PI;

/** A range that contains 0 in its middle and all of the values. */
export function symmetric(values: number[]): [number, number] {
  const largest = values.reduce((most, value) => Math.max(most, Math.abs(value)), 0) || 1;
  return [-1.05 * largest, 1.05 * largest];
}
