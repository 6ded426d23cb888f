// How a tension looks: five steps between the limits, each with a colour and a width of its own, so that neither is needed.
import { significant } from "../number";
import type { WorkspaceData } from "../data";

/** Names of the colours (CSS variables) and widths (pixels) of the steps. */
export const LOOKS = [1, 2, 3, 4, 5].map((step) => ({ colour: `tension-${step}`, width: 0.4 + 1.1 * step }));

/** False where the command was asked about something without tensions. */
export function hasTensions(data: WorkspaceData): boolean {
  return data.robot.cables.some((cable) => cable.tension_max_N !== null);
}

/** A cable whose limits may be unknown. */
export interface Limited {
  tension_min_N: number | null;
  tension_max_N: number | null;
}

/** Steps of tension (N), and where a tension stands between the limits of its cable. */
export class TensionScale {
  readonly least: number;
  readonly largest: number;

  /** Between the limits of the cables, or over the tensions that are known where a limit is not. */
  constructor(cables: Limited[], tensions: (number[] | null)[]) {
    const known = tensions.flatMap((all) => all ?? []);
    const limits = (pick: keyof Limited) => cables.flatMap((cable) => cable[pick] ?? []);
    this.least = least(limits("tension_min_N")) ?? least(known) ?? 0;
    this.largest = Math.max(largest(limits("tension_max_N")) ?? largest(known) ?? 1, this.least + 1e-9);
  }

  /** The step of a tension, from 0. */
  step(tension: number): number {
    const share = (tension - this.least) / (this.largest - this.least);
    return Math.max(0, Math.min(LOOKS.length - 1, Math.floor(LOOKS.length * share)));
  }

  look(tension: number): { colour: string; width: number } {
    return LOOKS[this.step(tension)] as { colour: string; width: number };
  }

  /** The range of a step, e.g. "1000–2600 N". */
  words(step: number): string {
    const at = (k: number) => significant(this.least + ((this.largest - this.least) * k) / LOOKS.length, 3);
    return `${at(step)}–${at(step + 1)} N`;
  }
}

/** A tension's place within its limits, in a word; "" where a limit is unknown or none is near. */
export function limitWords(tension: number, least: number | null, largest: number | null): string {
  if (least === null || largest === null) return "";
  const near = 0.005 * (largest - least);
  if (tension <= least + near) return "▼ at its least";
  return tension >= largest - near ? "▲ at its largest" : "";
}

function least(values: number[]): number | null {
  return values.length === 0 ? null : values.reduce((a, b) => Math.min(a, b));
}

function largest(values: number[]): number | null {
  return values.length === 0 ? null : values.reduce((a, b) => Math.max(a, b));
}
