//! Check whether poses and lengths are of the robot's size, or fit it only in another unit.
//!
//! Lengths of point outlets at the recorded poses are compared with the recorded lengths, in the units of the file and
//! in others. Winch offsets and coarse anchors cause misfits of centimetres to decimetres; a wrong unit causes a
//! multiple of the robot's size, and the right one reduces the misfit by orders of magnitude.

use std::f64::consts::PI;

use super::columns::Quantity;
use super::{Samples, position_columns, three_digits};
use crate::geometry::{MotionPattern, Pose};
use crate::robot::Robot;

/// Fraction of the lengths below which a misfit is no question of units.
const IGNORED_SHARE: f64 = 0.02;
/// Largest fraction of the misfit that remains with another reading that is certain.
const CERTAIN: f64 = 0.1;
/// Largest fraction of the misfit that remains with another reading that deserves a notice.
const DOUBTFUL: f64 = 0.33;
/// Largest number of samples compared.
const LOOKED_AT: usize = 200;
/// Largest length or coordinate, as a multiple of the largest distance between frame anchors.
const FARTHEST: f64 = 50.0;

/// Verdict of the numbers on their units.
#[derive(Debug, PartialEq)]
pub(super) enum UnitVerdict {
    /// The units are plausible.
    Plausible,
    /// Another reading fits better, but is not certain.
    Doubtful(String),
    /// Another unit is certain; `quantity` is that of a wrong column.
    Wrong { quantity: Quantity, message: String, help: String },
}

/// Another reading of the file.
struct Alternative {
    quantity: Quantity,
    /// Factors on positions and lengths.
    position: f64,
    length: f64,
    rotation: Rotation,
    words: &'static str,
    /// Advice for the user; `{positions_mm}` stands for the columns of the robot's positions in mm.
    help: &'static str,
}

#[derive(Clone, Copy, PartialEq)]
enum Rotation {
    AsWritten,
    Degrees,
}

const fn lengths(position: f64, length: f64, words: &'static str, help: &'static str) -> Alternative {
    let quantity = if length == 1.0 { Quantity::Position(0) } else { Quantity::Length(0) };
    Alternative { quantity, position, length, rotation: Rotation::AsWritten, words, help }
}

const fn rotations(quantity: Quantity, rotation: Rotation, words: &'static str, help: &'static str) -> Alternative {
    Alternative { quantity, position: 1.0, length: 1.0, rotation, words, help }
}

const ALTERNATIVES: &[Alternative] = &[
    lengths(
        1.0,
        1e-3,
        "the cable lengths look like millimetres: the poses ask for a thousandth of them",
        "name the columns cable_length_mm_1 …, and they are converted",
    ),
    lengths(
        1.0,
        1e-2,
        "the cable lengths look like centimetres: the poses ask for a hundredth of them",
        "divide them by 100; m and mm are read",
    ),
    lengths(
        1e-3,
        1.0,
        "the positions look like millimetres: the cable lengths fit a thousandth of them",
        "name the columns {positions_mm}, and they are converted",
    ),
    lengths(
        1e-2,
        1.0,
        "the positions look like centimetres: the cable lengths fit a hundredth of them",
        "divide them by 100; m and mm are read",
    ),
    lengths(
        1e-3,
        1e-3,
        "positions and cable lengths look like millimetres: a thousandth of them fits the robot",
        "name the columns x_mm … and cable_length_mm_1 …, and they are converted",
    ),
    lengths(
        1e-2,
        1e-2,
        "positions and cable lengths look like centimetres: a hundredth of them fits the robot",
        "divide them by 100; m and mm are read",
    ),
    lengths(
        1e3,
        1e3,
        "the anchors of the robot file look like millimetres: positions and cable lengths fit them 1000 times larger",
        "divide the anchors of the robot file by 1000: its keys end in _m",
    ),
    rotations(
        Quantity::Euler(0),
        Rotation::Degrees,
        "the angles look like degrees: only so they fit the cable lengths",
        "name the columns rx_deg, ry_deg, rz_deg, and they are converted",
    ),
    rotations(
        Quantity::Angle,
        Rotation::Degrees,
        "the angles look like degrees: only so they fit the cable lengths",
        "name the column angle_deg, and it is converted",
    ),
];

/// Compares the samples with the robot; `angles` are those of the file (rad), empty if it has none.
pub(super) fn judge(robot: &Robot, samples: &Samples, angles: &[[f64; 3]]) -> UnitVerdict {
    let comparison = Comparison { robot, samples, angles };
    let as_written = comparison.misfit(&lengths(1.0, 1.0, "", ""));
    let best = ALTERNATIVES
        .iter()
        .filter(|alternative| comparison.is_possible(alternative))
        .map(|alternative| (comparison.misfit(alternative), alternative))
        .min_by(|one, other| one.0.total_cmp(&other.0));
    let Some((misfit, alternative)) = best else { return UnitVerdict::Plausible };
    let typical = comparison.typical_length(alternative);
    if as_written <= IGNORED_SHARE * typical || misfit.is_nan() || misfit > DOUBTFUL * as_written {
        return UnitVerdict::Plausible;
    }
    let words = format!(
        "{} (misfit {} m as written, {} m otherwise)",
        alternative.words,
        three_digits(as_written),
        three_digits(misfit)
    );
    if misfit > CERTAIN * as_written {
        return UnitVerdict::Doubtful(words);
    }
    let help = alternative.help.replace("{positions_mm}", &position_columns(robot, "mm").join(", "));
    UnitVerdict::Wrong { quantity: alternative.quantity, message: words, help }
}

/// The largest length or coordinate possible for this robot (m); infinite if its frame anchors coincide.
pub(super) fn farthest(robot: &Robot) -> f64 {
    let anchors = || robot.cables.iter().map(|cable| cable.frame_anchor);
    let extent = anchors().flat_map(|a| anchors().map(move |other| (a - other).norm())).fold(0.0, f64::max);
    if extent > 0.0 { FARTHEST * extent } else { f64::INFINITY }
}

struct Comparison<'a> {
    robot: &'a Robot,
    samples: &'a Samples,
    angles: &'a [[f64; 3]],
}

impl Comparison<'_> {
    fn is_possible(&self, alternative: &Alternative) -> bool {
        let pattern = self.robot.motion_pattern;
        let has_angles = !self.angles.is_empty();
        match alternative.quantity {
            Quantity::Angle => has_angles && pattern == MotionPattern::Planar,
            Quantity::Euler(_) => has_angles && pattern == MotionPattern::Spatial,
            _ => true,
        }
    }

    fn looked_at(&self) -> impl Iterator<Item = usize> {
        let stride = self.samples.len().div_ceil(LOOKED_AT).max(1);
        (0..self.samples.len()).step_by(stride)
    }

    /// Median over samples of the mean misfit of the cables (m).
    fn misfit(&self, alternative: &Alternative) -> f64 {
        median(self.looked_at().map(|sample| {
            let recorded = self.samples.lengths_of(sample);
            let modelled = self.lengths(alternative, sample);
            let misfits = recorded.iter().zip(modelled).map(|(q, model)| (alternative.length * q - model).abs());
            misfits.sum::<f64>() / recorded.len().max(1) as f64
        }))
    }

    /// Median over samples of the mean modelled length (m).
    fn typical_length(&self, alternative: &Alternative) -> f64 {
        let m = self.samples.cable_count.max(1) as f64;
        median(self.looked_at().map(|sample| self.lengths(alternative, sample).sum::<f64>() / m))
    }

    fn lengths(&self, alternative: &Alternative, sample: usize) -> impl Iterator<Item = f64> {
        let pose = self.pose(alternative, sample);
        self.robot.cables.iter().map(move |cable| {
            let length = (cable.frame_anchor - pose.position - pose.rotation * cable.platform_anchor).norm();
            cable.length_scale.unwrap_or(1.0) * length + cable.length_offset.unwrap_or(0.0)
        })
    }

    fn pose(&self, alternative: &Alternative, sample: usize) -> Pose {
        let pose = self.samples.poses[sample];
        let read = Pose { position: pose.position * alternative.position, ..pose };
        match alternative.rotation {
            Rotation::AsWritten => read,
            Rotation::Degrees => {
                let (pattern, plane) = (self.robot.motion_pattern, self.robot.plane);
                let mut components = pattern.pose_to_components(plane, &read);
                let translations = pattern.translations();
                for (component, angle) in components[translations..].iter_mut().zip(self.angles[sample]) {
                    *component = angle * PI / 180.0;
                }
                pattern.pose(plane, &components).unwrap_or(read)
            }
        }
    }
}

fn median(numbers: impl Iterator<Item = f64>) -> f64 {
    let mut numbers: Vec<f64> = numbers.collect();
    numbers.sort_by(f64::total_cmp);
    numbers.get(numbers.len() / 2).copied().unwrap_or(0.0)
}
