//! Other starts around values that a file states: points of a scrambled Sobol sequence.

use std::f64::consts::PI;

use sobol_burley::{NUM_DIMENSIONS, sample};

use crate::fit::{Settings, prior_sigma};
use cdpr_model::robot::{Parameter, ParameterKind};

/// Way of other starts from the file's anchors, and from lengths, in every direction (m).
const LENGTH_RANGE: f64 = 0.5;
/// Factor of compliances, up or down.
const COMPLIANCE_RANGE: f64 = 10.0 / 3.0;
/// Factor of radii, pitches and masses, up or down.
const RADIUS_RANGE: f64 = 1.5;
/// Change of ratios near 1.
const RATIO_RANGE: f64 = 0.1;
/// Turn of axes (rad).
const TURN_RANGE: f64 = 0.2;
/// Way and turn of a recording's frames, which closed forms bring near (m, rad).
const FRAME_RANGE: f64 = 0.05;
/// Share of the mean tension by which forces change.
const TENSION_RANGE: f64 = 0.5;
/// Standard deviations of a prior.
const PRIOR_RANGE: f64 = 3.0;

/// Parameters that are identified together, apart from those of other parts.
pub(crate) struct Part {
    pub(crate) parameters: Vec<Parameter>,
    /// Values that the file states.
    pub(crate) start: Vec<f64>,
    /// Metres that one unit of each parameter is worth.
    pub(crate) scale: Vec<f64>,
}

/// Distance of other starts from a file's value.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Range {
    Added(f64),
    Times(f64),
}

/// Starts around values that a file states.
pub(super) struct Drawing<'a> {
    settings: &'a Settings,
    /// Mean recorded tension (N).
    tension: f64,
}

impl<'a> Drawing<'a> {
    pub(super) fn new(settings: &'a Settings, tension: f64) -> Self {
        Self { settings, tension }
    }

    /// Change of the file's values at a start, whose parameters are dimensions of the sequence from this one on.
    pub(super) fn change(&self, start: u32, part: &Part, first: usize) -> Vec<f64> {
        let numbered = part.parameters.iter().zip(&part.start).enumerate();
        let change = |(k, (parameter, &value)): (usize, (&Parameter, &f64))| {
            let amount = 2.0 * self.number(start, first + k) - 1.0;
            let moved = match self.range(parameter.kind) {
                Range::Added(range) => value + range * amount,
                Range::Times(factor) => value * factor.powf(amount),
            };
            let (low, high) = parameter.bounds();
            moved.clamp(low, high) - value
        };
        numbered.map(change).collect()
    }

    /// A number in [0, 1): one dimension of one point, the same for all that come after more starts.
    fn number(&self, start: u32, dimension: usize) -> f64 {
        let seed = self.settings.seed;
        let dimension = dimension as u32;
        let set = dimension / NUM_DIMENSIONS;
        sample(start - 1, dimension % NUM_DIMENSIONS, (seed ^ (seed >> 32)) as u32 ^ set.rotate_left(16)).into()
    }

    fn range(&self, kind: ParameterKind) -> Range {
        let prior = prior_sigma(self.settings, kind).map(|sigma| Range::Added(PRIOR_RANGE * sigma));
        match kind {
            ParameterKind::Compliance | ParameterKind::Stretch(_) => Range::Times(COMPLIANCE_RANGE),
            kind if kind.is_anchor() => Range::Added(LENGTH_RANGE),
            kind => prior.unwrap_or_else(|| self.own_range(kind)),
        }
    }

    fn own_range(&self, kind: ParameterKind) -> Range {
        match kind {
            ParameterKind::PulleyRadius
            | ParameterKind::DrumRadius
            | ParameterKind::DrumPitch
            | ParameterKind::SpoolBuildUp
            | ParameterKind::LinearDensity
            | ParameterKind::Mass => Range::Times(RADIUS_RANGE),
            ParameterKind::LengthScale | ParameterKind::TensionScale => Range::Added(RATIO_RANGE),
            ParameterKind::DrumAxis | ParameterKind::SwivelAxis => Range::Added(TURN_RANGE),
            ParameterKind::StartAngle => Range::Added(PI),
            kind if kind.is_of_recording() => Range::Added(FRAME_RANGE),
            ParameterKind::SwivelOffset => Range::Added(PI / 4.0),
            ParameterKind::TensionOffset | ParameterKind::Wrench => Range::Added(TENSION_RANGE * self.tension),
            _ => Range::Added(LENGTH_RANGE),
        }
    }

    /// How far starts are from the file's values, kind by kind.
    pub(super) fn words(&self, parts: &[Part]) -> Vec<String> {
        let mut kinds: Vec<ParameterKind> = Vec::new();
        for parameter in parts.iter().flat_map(|part| &part.parameters) {
            if !kinds.contains(&parameter.kind) {
                kinds.push(parameter.kind);
            }
        }
        let words = |kind: &ParameterKind| {
            let range = match self.range(*kind) {
                Range::Added(range) => format!("± {} {}", three_digits(range), kind.unit()),
                Range::Times(factor) => format!("× or ÷ {}", three_digits(factor)),
            };
            format!("{} {}", kind.name(), range.trim_end())
        };
        kinds.iter().map(words).collect()
    }
}

/// Shortest number with three significant digits.
fn three_digits(number: f64) -> f64 {
    format!("{number:.2e}").parse().unwrap_or(number)
}
