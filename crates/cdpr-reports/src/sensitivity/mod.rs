//! Sensitivities and tolerances of a study: answer, tables and picture.

mod answer;
mod map;
pub mod tables;
mod words;

use cdpr_model::robot::ParameterKind;
use cdpr_study::sensitivity::Kind;

pub use answer::{
    AllowedAnswer, DifferencePose, Linear, ParameterAnswer, SameError, SensitivityAnswer, ToleranceAnswer,
};
pub use map::map;
pub(crate) use words::amount;

/// A step that people think in: what it is in the unit of the kind, and its words.
pub fn step(kind: Kind) -> (f64, &'static str) {
    match (kind, kind.unit()) {
        (Kind::Parameter(ParameterKind::LengthScale), _) => (1e-4, "0.01 %"),
        (_, "m") => (1e-3, "1 mm"),
        (_, "1") => (1e-2, "1 %"),
        (_, "rad") => (std::f64::consts::PI / 180.0, "1°"),
        (_, "N") => (10.0, "10 N"),
        (_, "N·m") => (10.0, "10 N·m"),
        _ => (1.0, "1 kg"),
    }
}
