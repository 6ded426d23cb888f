//! Check whether poses and lengths are of the robot's size, or fit it only in another unit.
//!
//! Lengths of point outlets at the recorded poses are compared with the recorded lengths, in the units of the file and
//! in others: at the poses as they are, and with the frames of a tracker and a marker that fit best, which change no
//! distance between poses. Winch offsets and coarse anchors cause misfits of centimetres to decimetres; a wrong unit
//! causes a multiple of the robot's size, and the right one reduces the misfit by orders of magnitude.

mod alternatives;
#[cfg(test)]
mod tests;

use alternatives::{Alternative, alternatives};

use super::columns::Quantity;
use super::comparison::Data;
use super::comparison::frames::Framed;
use super::{Samples, three_digits};
use crate::geometry::Pose;
use crate::robot::Robot;

/// Fraction of the lengths below which a misfit is no question of units.
const IGNORED_SHARE: f64 = 0.02;
/// The same of the changes of the lengths.
const IGNORED_OF_CHANGES: f64 = 0.05;
/// Largest fraction of the misfit that remains with another reading that is certain.
const CERTAIN: f64 = 0.1;
/// Largest fraction of the misfit that remains with another reading that deserves a notice.
const DOUBTFUL: f64 = 0.33;
/// Least number of samples whose changes are compared; of fewer the lengths themselves are.
const FEWEST: usize = 8;
/// Largest number of samples to which frames are fitted.
const FRAMED: usize = 40;
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

/// Compares the samples with the robot; `factor` is that from a column's unit to SI.
pub(super) fn judge(robot: &Robot, samples: &Samples, factor: &dyn Fn(Quantity) -> f64) -> UnitVerdict {
    let data = Data::of(robot, samples);
    let as_written = absolute_misfit(&data, &data.poses);
    if as_written <= IGNORED_SHARE * typical_length(&data, &data.poses) {
        return UnitVerdict::Plausible;
    }
    let all = alternatives(robot, samples.angles.is_some(), factor);
    if data.poses.len() < FEWEST {
        return by_lengths(&data, &all, as_written);
    }
    let few = data.thinned(FRAMED);
    let as_written = Framed::of(&few).misfit(&few.poses) / few.spread();
    if !(as_written > IGNORED_OF_CHANGES) {
        return UnitVerdict::Plausible;
    }
    // a reading that leaves more than a tenth of the changes explains nothing, however bad the other is
    let certain = CERTAIN * as_written.min(1.0);
    let unmoved = |alternative: &Alternative| {
        let read = alternative.read(&data);
        read.misfit(&read.poses) / read.spread()
    };
    let plain = best_of(&all, unmoved);
    if let Some((left, alternative)) = plain
        && left <= certain
    {
        return alternative.verdict(as_written, left, "of the changes of the lengths", CERTAIN);
    }
    let in_frames = |alternative: &Alternative| {
        let read = alternative.read(&few);
        Framed::of(&read).misfit(&read.poses) / read.spread()
    };
    match best_of(&all, in_frames) {
        Some((left, alternative)) if left <= certain => {
            let of = "of the changes of the lengths, with the frames of tracker and marker that fit best";
            alternative.verdict(as_written, left, of, CERTAIN)
        }
        _ => plain
            .filter(|(left, _)| *left <= IGNORED_OF_CHANGES)
            .map_or(UnitVerdict::Plausible, |(left, alternative)| {
                alternative.verdict(as_written, left, "of the changes of the lengths", DOUBTFUL)
            }),
    }
}

/// The verdict of few samples, by lengths with the offsets of the file.
fn by_lengths(data: &Data<'_>, all: &[Alternative], as_written: f64) -> UnitVerdict {
    let misfit = |alternative: &Alternative| {
        let read = alternative.read(data);
        absolute_misfit(&read, &read.poses)
    };
    let Some((left, alternative)) = best_of(all, misfit) else { return UnitVerdict::Plausible };
    let read = alternative.read(data);
    if !(left <= DOUBTFUL * as_written) || left > CERTAIN * typical_length(&read, &read.poses) {
        return UnitVerdict::Plausible;
    }
    alternative.verdict(as_written, left, "m", CERTAIN)
}

/// The alternative with the least misfit, the first of equal ones.
fn best_of(all: &[Alternative], misfit: impl Fn(&Alternative) -> f64) -> Option<(f64, &Alternative)> {
    let misfits = all.iter().map(|alternative| (misfit(alternative), alternative));
    misfits.filter(|(left, _)| left.is_finite()).min_by(|one, other| one.0.total_cmp(&other.0))
}

impl Alternative {
    /// The verdict with this as the best reading.
    fn verdict(&self, as_written: f64, left: f64, of: &str, certain: f64) -> UnitVerdict {
        let is_certain = left <= CERTAIN * as_written;
        if !is_certain && left > certain * as_written {
            return UnitVerdict::Plausible;
        }
        let share = |misfit: f64| if of == "m" { three_digits(misfit) } else { format!("{:.3}", misfit) };
        let message =
            format!("{} (misfit {} {of} as written, {} otherwise)", self.words, share(as_written), share(left));
        if !is_certain {
            return UnitVerdict::Doubtful(message);
        }
        UnitVerdict::Wrong { quantity: self.quantity, message, help: self.help.clone() }
    }
}

/// The largest length or coordinate possible for this robot (m); infinite if its frame anchors coincide.
pub(super) fn farthest(robot: &Robot) -> f64 {
    let anchors = || robot.cables.iter().map(|cable| cable.frame_anchor);
    let extent = anchors().flat_map(|a| anchors().map(move |other| (a - other).norm())).fold(0.0, f64::max);
    if extent > 0.0 { FARTHEST * extent } else { f64::INFINITY }
}

/// Median over samples of the mean misfit of the cables, with the offsets and scales of the file (m).
fn absolute_misfit(data: &Data<'_>, poses: &[Pose]) -> f64 {
    of_samples(data, poses, |modelled, recorded| (recorded - modelled).abs())
}

/// Median over samples of the mean modelled length (m).
fn typical_length(data: &Data<'_>, poses: &[Pose]) -> f64 {
    of_samples(data, poses, |modelled, _| modelled)
}

/// Median over samples of the mean over cables of a number of modelled and recorded length.
fn of_samples(data: &Data<'_>, poses: &[Pose], number: impl Fn(f64, f64) -> f64) -> f64 {
    let mut sums = vec![0.0; poses.len()];
    for (cable, recorded) in data.recorded.iter().enumerate() {
        let part = &data.robot.cables[cable];
        for ((sum, length), recorded) in sums.iter_mut().zip(data.lengths(cable, poses)).zip(recorded) {
            let modelled = part.length_scale.unwrap_or(1.0) * length + part.length_offset.unwrap_or(0.0);
            *sum += number(modelled, *recorded) / data.recorded.len() as f64;
        }
    }
    sums.sort_by(f64::total_cmp);
    sums.get(sums.len() / 2).copied().unwrap_or(0.0)
}
