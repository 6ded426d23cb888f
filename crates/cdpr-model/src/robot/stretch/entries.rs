//! The list of all laws of stretch: one entry each.

use cdpr_core::cable::stretch::Stretch;

use super::numbers::LawNumber;
use super::{StretchError, hysteresis, linear, polynomial, two_piece};
use crate::robot::Cable;

/// Law of stretch of a model's cables.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum StretchEffect {
    /// No stretch.
    #[default]
    Rigid,
    /// Strain in proportion to the tension.
    Linear,
    /// Two slopes that meet at a knee.
    TwoPiece,
    /// Tension as a polynomial of the strain.
    Polynomial,
    /// Loading and unloading branches with a memory.
    Hysteresis,
}

/// A law of stretch with its properties. A model has at most one.
#[derive(Debug)]
pub struct Law {
    /// Effect of a composition with this law.
    pub effect: StretchEffect,
    /// Name of the effect in a composition.
    pub word: &'static str,
    /// Tension as a function of the strain, in a few words.
    pub summary: &'static str,
    /// Keys of `[[cable]]` for it; the first is named in an error if all are missing.
    pub keys: &'static [&'static str],
    /// Advice in the error about the missing key.
    pub hint: &'static str,
    /// Key of the table that contains its keys, if they are in one.
    pub table: Option<&'static str>,
    /// Its numbers that are plain keys and parameters.
    pub numbers: &'static [LawNumber],
    /// True if the tension depends on earlier strains.
    pub remembers: bool,
    /// Data needed for its numbers, in words.
    pub cost: &'static str,
    pub(super) law: fn(&Cable) -> Result<Option<Stretch>, StretchError>,
    pub(super) count: fn(&Cable) -> usize,
    pub(super) sample: fn(&mut Cable, f64),
}

/// All laws, simple ones first: each describes a real cable more closely than those before it.
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
