//! The list of all laws of stretch: one entry each.

use cdpr_core::cable::stretch::Stretch;

use super::numbers::LawNumber;
use super::{StretchError, hysteresis, linear, polynomial, two_piece};
use crate::robot::Cable;

/// How the cables of a model stretch.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum StretchEffect {
    /// Not at all.
    #[default]
    Rigid,
    /// In proportion to the tension.
    Linear,
    /// By two slopes that meet at a strain.
    TwoPiece,
    /// By a polynomial tension over strain.
    Polynomial,
    /// With loading and unloading branches and a memory.
    Hysteresis,
}

/// A law of stretch: all that is said of it once. A model has one at most.
#[derive(Debug)]
pub struct Law {
    /// Stretch of a composition that has it.
    pub effect: StretchEffect,
    /// Word in the name of a composition.
    pub word: &'static str,
    /// Tension as it makes it of the strain, in a few words.
    pub summary: &'static str,
    /// Keys of `[[cable]]` that state it, the one first that is missed where there is none.
    pub keys: &'static [&'static str],
    /// Further words about the missing key.
    pub hint: &'static str,
    /// Key of a table that has its keys, where they stand in one.
    pub table: Option<&'static str>,
    /// Numbers of it that are plain keys and parameters.
    pub numbers: &'static [LawNumber],
    /// True where tension depends on the strains before.
    pub remembers: bool,
    /// Data that it needs, in words.
    pub cost: &'static str,
    pub(super) law: fn(&Cable) -> Result<Option<Stretch>, StretchError>,
    pub(super) count: fn(&Cable) -> usize,
    pub(super) sample: fn(&mut Cable, f64),
}

/// All laws, simple ones first: each tells more of a real cable than those before it.
pub const LAWS: &[Law] = &[
    Law {
        effect: StretchEffect::Linear,
        word: "elastic",
        summary: "tension in proportion to the strain",
        keys: &["axial_stiffness_EA_N", "axial_compliance_per_N", "spring_constant_N_per_m", "stiffness_by"],
        hint: " (or axial_compliance_per_N, or spring_constant_N_per_m)",
        table: None,
        numbers: &[],
        remembers: false,
        cost: "a compliance per cable, and the load; a hidden length where the winch stands far from the outlet",
        law: linear::law,
        count: linear::count,
        sample: linear::sample,
    },
    Law {
        effect: StretchEffect::TwoPiece,
        word: "two-piece",
        summary: "two slopes of the tension that meet at a strain",
        keys: &["stiffness_below_knee_EA_N", "stiffness_above_knee_EA_N", "knee_strain"],
        hint: " with stiffness_above_knee_EA_N and knee_strain",
        table: None,
        numbers: &two_piece::NUMBERS,
        remembers: false,
        cost: "two stiffnesses and a strain per cable, and the load",
        law: two_piece::law,
        count: two_piece::count,
        sample: two_piece::sample,
    },
    Law {
        effect: StretchEffect::Polynomial,
        word: "polynomial",
        summary: "tension as a polynomial of the strain",
        keys: &["tension_of_strain_N"],
        hint: "",
        table: None,
        numbers: &[],
        remembers: false,
        cost: "the coefficients from a test bench, and the load",
        law: polynomial::law,
        count: polynomial::count,
        sample: polynomial::sample,
    },
    Law {
        effect: StretchEffect::Hysteresis,
        word: "hysteresis",
        summary: "loading and unloading branches and a memory",
        keys: &["hysteresis"],
        hint: " as a table, e.g. from a test bench",
        table: Some("hysteresis"),
        numbers: &[],
        remembers: true,
        cost: "both branches from a test bench, the load, and the order of the motions",
        law: hysteresis::law,
        count: hysteresis::count,
        sample: hysteresis::sample,
    },
];
