// Numbers in axes and tips, written as the tables write them: a true minus sign, no more digits than they deserve.

/** A number with so many significant digits; "–" for none. */
export function significant(value: number | null | undefined, digits = 3): string {
  if (value === null || value === undefined || Number.isNaN(value)) return "–";
  if (!Number.isFinite(value)) return value > 0 ? "∞" : "−∞";
  if (value === 0) return "0";
  const size = Math.abs(value);
  const text = size >= 1e-4 && size < 1e7 ? plain(size, digits) : powers(size, digits);
  return value < 0 ? `−${text}` : text;
}

function plain(size: number, digits: number): string {
  const decimals = Math.max(0, digits - 1 - Math.floor(Math.log10(size)));
  return size.toFixed(Math.min(decimals, 20));
}

function powers(size: number, digits: number): string {
  const [mantissa, exponent] = size.toExponential(Math.max(0, digits - 1)).split("e");
  return `${mantissa} × 10${superscript(Number(exponent))}`;
}

/** The mean of numbers, no finer than the first digit of its standard error; "–" for none. */
export function meanWords(values: number[]): string {
  if (values.length < 2) return significant(values[0], 2);
  const mean = values.reduce((sum, value) => sum + value, 0) / values.length;
  const spread = Math.sqrt(values.reduce((sum, value) => sum + (value - mean) ** 2, 0) / (values.length - 1));
  const error = spread / Math.sqrt(values.length);
  if (!(error > 0)) return significant(mean, 3);
  const text = Math.abs(mean).toFixed(Math.min(20, Math.max(0, -Math.floor(Math.log10(error)))));
  return mean < 0 && Number(text) !== 0 ? `−${text}` : text;
}

/** A tick of an axis: as short as it is, without separators of thousands. */
export function tick(value: number): string {
  return String(Number(value.toPrecision(10))).replace("-", "−");
}

function superscript(value: number): string {
  const digits = "⁰¹²³⁴⁵⁶⁷⁸⁹";
  return String(value).replace(/-/, "⁻").replace(/\d/g, (digit) => digits[Number(digit)] ?? digit);
}

/** The p-quantile of sorted numbers. */
export function quantile(sorted: number[], p: number): number {
  return sorted[Math.min(sorted.length - 1, Math.floor((sorted.length - 1) * p))] ?? Number.NaN;
}

/** Finite numbers only. */
export function finite(values: Iterable<number | null | undefined>): number[] {
  return [...values].filter((value): value is number => typeof value === "number" && Number.isFinite(value));
}
