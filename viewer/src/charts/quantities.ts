// What can be asked of the samples: residuals of which quantity, of which model, against what.
import type { SampleErrors, ReportData } from "../data";
import type { Option } from "../controls";
import { mm } from "./style";

/** A residual of every cable in every sample. */
export interface Residual {
  words: string;
  unit: string;
  /** Value of a cable in a row, in the unit; NaN where there is none. */
  of(errors: SampleErrors, row: number, cable: number): number;
}

const LENGTH: Residual = {
  words: "cable length, modelled − recorded",
  unit: "mm",
  of: (errors, row, cable) => mm(errors.length_error_m[row]?.[cable]),
};

const TENSION: Residual = {
  words: "tension, predicted − recorded",
  unit: "N",
  of: (errors, row, cable) => errors.tension_error_N?.[row]?.[cable] ?? Number.NaN,
};

/** Lengths always; tensions only where the calibrated model predicts them and the data have them. */
export function residuals(data: ReportData): Option<Residual>[] {
  const all = [{ label: "cable length", value: LENGTH }];
  return data.samples.calibrated.tension_error_N ? [...all, { label: "tension", value: TENSION }] : all;
}

/** The models that can be looked at. */
export function models(data: ReportData): Option<SampleErrors>[] {
  const { calibrated, as_given } = data.samples;
  const own = { label: data.given === null && (data.result.candidates[data.shown]?.parameter_count ?? 0) === 0 ? "as given" : "calibrated", value: calibrated };
  return as_given ? [own, { label: "as given", value: as_given }] : [own];
}

/** What residuals are drawn against. */
export interface Abscissa {
  label: string;
  /** NaN where a sample has none. */
  of(row: number, cable: number): number;
  /** Reeling in and paying out are told apart. */
  direction: boolean;
}

/** Sample number, length and direction of motion; time where it was recorded. */
export function abscissae(data: ReportData): Option<Abscissa>[] {
  const samples = data.samples;
  const of = (label: string, abscissa: Abscissa) => ({ label, value: abscissa });
  const all = [
    of("sample number", { label: "sample number", of: (row) => samples.number[row] ?? Number.NaN, direction: false }),
    of("cable length", { label: "recorded length, m", of: (row, cable) => samples.recorded_length_m[row]?.[cable] ?? Number.NaN, direction: false }),
    of("direction of motion", {
      label: "length change since the sample before, mm (− reeling in, + paying out)",
      of: (row, cable) => mm(samples.length_change_m[row]?.[cable]),
      direction: true,
    }),
  ];
  const time = samples.time_s;
  return time ? [...all, of("time", { label: "time, s", of: (row) => time[row] ?? Number.NaN, direction: false })] : all;
}
