//! Kinds of dirt: the one table. A kind is a row here and a function in `spoil` that spoils a scene.

use crate::random::Random;
use crate::robots::RobotName::{self, Box, Camera, ElasticCamera};
use crate::scene::{Layout, Scene};
use crate::spoil::{frames, lengths, rows, setups, units};

/// Place of the dirt that a spoilt scene has.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Place {
    /// Cable, counted from 1.
    pub(crate) cable: Option<usize>,
    /// Lines of the data file; a finding at one of them is right. Empty without a place.
    pub(crate) lines: Vec<usize>,
}

/// Finding or refusal that names the dirt rightly.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Naming {
    /// Nothing is there to name: no caution.
    Clean,
    /// A finding of one of these kinds, the first of the answer.
    Kinds(&'static [&'static str]),
    /// The same, and the answer is to be trusted all the same: it is right.
    Trusted(&'static [&'static str]),
    /// The same, or a refusal with this code whose words hold one of these.
    Refusal(&'static [&'static str], &'static str, &'static [&'static str]),
    /// A warning or a refusal that names this column: a mistake for which no kind of finding stands.
    Column(&'static str),
}

/// When a file states the accuracies of its sensors.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Accuracies {
    /// With even seeds.
    Even,
    /// Always: the dirt shows beside them alone.
    Always,
}

/// A kind of dirt.
pub(crate) struct Kind {
    pub(crate) name: &'static str,
    pub(crate) naming: Naming,
    /// Robots whose records can have it.
    pub(crate) robots: &'static [RobotName],
    pub(crate) layout: Layout,
    pub(crate) accuracies: Accuracies,
    /// Kept for `soak`: no limit of the product is tuned on it, and no test runs it.
    pub(crate) kept: bool,
    pub(crate) spoil: fn(&mut Scene, &mut Random) -> Place,
}

impl Kind {
    pub(crate) fn is_clean(&self) -> bool {
        matches!(self.naming, Naming::Clean)
    }

    pub(crate) fn states_accuracies(&self, seed: u64) -> bool {
        self.accuracies == Accuracies::Always || seed.is_multiple_of(2)
    }
}

const ALL: &[RobotName] = RobotName::ALL;
const REDUNDANT: &[RobotName] = &[Camera, Box];
const TURNING: &[RobotName] = &[Box];
const STRETCHING: &[RobotName] = &[ElasticCamera];

/// A kind with rows anywhere, on whose numbers limits may be tuned.
const fn kind(
    name: &'static str,
    naming: Naming,
    robots: &'static [RobotName],
    spoil: fn(&mut Scene, &mut Random) -> Place,
) -> Kind {
    Kind { name, naming, robots, layout: Layout::Scattered, accuracies: Accuracies::Even, kept: false, spoil }
}

const fn clean(name: &'static str, layout: Layout, spoil: fn(&mut Scene, &mut Random) -> Place) -> Kind {
    Kind { layout, ..kind(name, Naming::Clean, ALL, spoil) }
}

const fn kept(kind: Kind) -> Kind {
    Kind { kept: true, ..kind }
}

use Naming::{Column, Kinds, Refusal, Trusted};

const MAGNITUDE: &str = "csv::magnitude";

/// All kinds; clean ones first.
pub(crate) const KINDS: &[Kind] = &[
    clean("clean", Layout::Scattered, setups::nothing),
    clean("clean-validation", Layout::Scattered, setups::validation),
    clean("clean-few", Layout::Few(30), setups::nothing),
    clean("clean-moving", Layout::Moving, setups::nothing),
    clean("clean-exact-file", Layout::Scattered, setups::exact_file),
    // units
    kind("metres-in-mm", Refusal(&["unit"], MAGNITUDE, &[" metre"]), ALL, units::metres_in_mm),
    kind("feet", Refusal(&["unit"], MAGNITUDE, &["feet", "foot"]), ALL, units::feet),
    kind("inches-in-one-column", Refusal(&["unit"], MAGNITUDE, &["inch", "0.0254"]), ALL, units::inches_in_one_column),
    kind("kilogram-force", Kinds(&["unit", "load"]), STRETCHING, units::kilogram_force),
    kind(
        "cables-from-0",
        Refusal(&["permutation"], "csv::cable-count", &["from 0", "from 1", "_0"]),
        ALL,
        units::cables_from_0,
    ),
    kind("set-words", Column("set"), ALL, units::set_words),
    // poses
    kind("mirrored-height", Kinds(&["mirror"]), ALL, frames::mirrored_height),
    kept(kind("scalar-first", Kinds(&["rotation-convention"]), TURNING, frames::scalar_first)),
    kept(kind("inverted-rotation", Kinds(&["rotation-convention"]), TURNING, frames::inverted)),
    kind("roll-pitch-yaw", Kinds(&["rotation-convention"]), TURNING, frames::roll_pitch_yaw),
    kind("marker-offset", Kinds(&["marker"]), TURNING, frames::marker_offset),
    kind("tracker-turned", Kinds(&["frame"]), ALL, frames::tracker_turned),
    kind("tracker-far", Trusted(&["frame"]), ALL, frames::tracker_far),
    kept(kind("tracker-bumped", Kinds(&["frame", "step"]), ALL, frames::tracker_bumped)),
    kept(Kind { layout: Layout::Moving, ..kind("late-clock", Kinds(&["clock"]), ALL, frames::late_clock) }),
    kept(kind("correlated-noise", Kinds(&["order"]), ALL, frames::correlated_noise)),
    // lengths
    kind("permuted-cables", Kinds(&["permutation"]), REDUNDANT, lengths::permuted),
    kind("re-clamped", Kinds(&["step"]), ALL, lengths::reclamped),
    kept(kind("drift", Kinds(&["drift"]), ALL, lengths::drift)),
    kind("stuck-encoder", Kinds(&["stuck"]), ALL, lengths::stuck),
    kept(Kind {
        layout: Layout::Moving,
        ..kind("dead-band", Kinds(&["dead-band", "backlash"]), ALL, lengths::dead_band)
    }),
    kept(kind("backlash", Kinds(&["backlash", "dead-band"]), ALL, lengths::backlash)),
    kind("slack-cable", Kinds(&["slack"]), REDUNDANT, lengths::slack),
    kept(kind("one-winch-scale", Kinds(&["scale"]), ALL, lengths::one_winch_scale)),
    Kind {
        // a search of every pose: with more rows it takes longer than all other cells of the test
        layout: Layout::Few(30),
        ..kind(
            "gear-without-poses",
            Refusal(&["unseen", "scale"], "data::", &["scale"]),
            REDUNDANT,
            lengths::gear_without_poses,
        )
    },
    // rows
    kind("pasted-rows", Kinds(&["repeat"]), ALL, rows::pasted),
    kind(
        "validation-is-training",
        Refusal(&["repeat"], "data::validation-is-training", &["training file"]),
        ALL,
        rows::validation_is_training,
    ),
    kind("outliers", Kinds(&["outlier"]), ALL, rows::outliers),
    Kind { layout: Layout::Corner, ..kind("corner", Kinds(&["coverage"]), ALL, setups::nothing) },
    // what is said besides
    kind("other-day-offsets", Kinds(&["offset"]), ALL, setups::other_day_offsets),
    kind("tripled-payload", Kinds(&["load"]), STRETCHING, setups::tripled_payload),
    kept(kind("wrong-stiffness", Kinds(&["stiffness"]), STRETCHING, setups::wrong_stiffness)),
    kind("mistyped-anchor", Trusted(&["anchor"]), ALL, setups::mistyped_anchor),
    Kind { accuracies: Accuracies::Always, ..kind("small-sigmas", Kinds(&["lack-of-fit"]), ALL, setups::small_sigmas) },
];

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;

    #[test]
    fn thirty_kinds_at_least_and_ten_kept() {
        let names: BTreeSet<&str> = KINDS.iter().map(|kind| kind.name).collect();
        assert_eq!(names.len(), KINDS.len());
        assert!(KINDS.iter().filter(|kind| !kind.is_clean()).count() >= 30);
        assert_eq!(KINDS.iter().filter(|kind| kind.kept).count(), 10);
        assert!(KINDS.iter().all(|kind| !kind.robots.is_empty()));
    }

    /// A word that the product does not have could never be said.
    #[test]
    fn words_of_kinds_are_the_products() {
        let source = concat!(env!("CARGO_MANIFEST_DIR"), "/../../crates/cdpr-model/src/finding.rs");
        let source = std::fs::read_to_string(source).unwrap();
        for kind in KINDS {
            let words = match kind.naming {
                Kinds(words) | Trusted(words) | Refusal(words, ..) => words,
                Naming::Clean | Column(_) => &[],
            };
            words.iter().for_each(|word| assert!(source.contains(&format!("= \"{word}\"")), "{}: {word}", kind.name));
        }
    }
}
