//! Records that tell no frequency response.

use thiserror::Error;

/// A record, or settings, that no frequency response can be estimated with.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum InputError {
    /// Series of different lengths.
    #[error(
        "{times} times, {input} values of the input and {output} of the output: there has to be one of each per row"
    )]
    Lengths {
        /// Number of times.
        times: usize,
        /// Number of values of the input.
        input: usize,
        /// Number of values of the output.
        output: usize,
    },
    /// A value that is not finite.
    #[error("row {row}: a value is not finite; remove the row")]
    NotFinite {
        /// Row, from 1.
        row: usize,
    },
    /// Too few rows to cut windows from.
    #[error("{found} rows are too few for a frequency response; at least {needed} are needed: record longer")]
    TooFewRows {
        /// Rows.
        found: usize,
        /// Rows needed.
        needed: usize,
    },
    /// Time that stands still or runs back.
    #[error(
        "row {row}: the time {after} s does not lie behind that of the row before, {before} s: rows are out of order or repeated"
    )]
    TimeOrder {
        /// Row, from 1.
        row: usize,
        /// Time of the row before (s).
        before: f64,
        /// Time of the row (s).
        after: f64,
    },
    /// Rows that are not evenly spaced.
    #[error(
        "row {row}: {gap:.6} s lie between this row and the one before it, {usual:.6} s between others: the sampling is uneven; record at an even rate, cut the record at the gap, or put rows onto an even grid first"
    )]
    Uneven {
        /// Row, from 1.
        row: usize,
        /// Worst gap (s).
        gap: f64,
        /// Usual distance of rows (s).
        usual: f64,
    },
    /// A series that does not vary.
    #[error("the {what} does not vary: there is no response to estimate; is it the right column?")]
    NoRange {
        /// `input` or `output`.
        what: &'static str,
    },
    /// Windows so long that too few fit into the record.
    #[error(
        "windows of {window} s fit {found} times into the record, and {needed} are needed to tell coherence: at most {longest:.3} s"
    )]
    TooFewWindows {
        /// Length asked for (s).
        window: f64,
        /// Windows that fit, each overlapping the next by half.
        found: usize,
        /// Windows needed.
        needed: usize,
        /// Longest window (s).
        longest: f64,
    },
    /// A record that holds no steps of a sine, where they were asked for.
    #[error(
        "the input holds {found} steps of one frequency over {percent:.0} % of the record; a stepped sine has 4 or more, of 5 cycles or more each, over 80 %: take the method `h1` for sweeps, noise and sums of sines"
    )]
    NoSteps {
        /// Steps found.
        found: usize,
        /// Part of the record that they cover (%).
        percent: f64,
    },
    /// A setting out of its range.
    #[error("{what} is {value}, it has to be {range}")]
    Setting {
        /// Name of the setting.
        what: &'static str,
        /// Its value.
        value: f64,
        /// Values that it may have.
        range: &'static str,
    },
}
