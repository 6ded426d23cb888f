//! Rows that are looked at before anything is fitted: those that repeat others, and those of a sensor that stands still.

use std::collections::HashMap;

use cdpr_model::finding::{Finding, FindingKind, Severity};
use cdpr_model::measurement::{Samples, three_digits};
use cdpr_model::robot::Robot;

/// Fewest consecutive rows with one value that a sensor does not give by chance.
const STUCK: usize = 5;
/// Least change of the cable's length over these rows by the measured poses, as a fraction of the diagonal of the anchors' box and in multiples of the
/// accuracy of lengths.
const MOVED: f64 = 2e-3;
const MOVED_ACCURACIES: f64 = 10.0;
/// Fraction of rows before which an earlier one stands, from which on rows are shuffled and not several recordings.
const SHUFFLED: f64 = 0.1;

/// Rows that are used, and what was found in the others.
#[derive(Clone, Debug, PartialEq)]
pub struct Screened {
    /// The samples that are used, in the order of their times where the rows were shuffled.
    pub samples: Samples,
    /// Findings about the others.
    pub findings: Vec<Finding>,
}

/// The samples without rows that repeat others exactly and without those where a cable's sensor stands still while the platform moves.
///
/// Shuffled rows are sorted by time, since tests of order and parts held out rely on it. The robot gives the lengths by which cables move.
pub fn screened(robot: &Robot, samples: &Samples) -> Screened {
    let mut findings = Vec::new();
    let mut kept: Vec<usize> = (0..samples.len()).collect();
    if let Some(order) = time_order(samples) {
        kept = order;
        findings.push(Finding::new(
            FindingKind::Order,
            Severity::Remark,
            "the rows are not in the order of their times (t_s): they are taken in it",
        ));
    }
    let repeats = repeats(samples);
    if let Some(first) = repeats.first() {
        let text = format!(
            "{} of {} rows repeat others exactly, the first in {}: each counts once",
            repeats.len(),
            samples.len(),
            place(samples, *first)
        );
        let found = Finding::new(FindingKind::Repeat, Severity::Remark, text).of_size(repeats.len() as f64, "rows");
        findings.push(at(samples, *first, found));
    }
    let mut left_out = repeats;
    let stuck = stuck(robot, samples);
    let mut spoilt: Vec<usize> = stuck.iter().flat_map(|stuck| stuck.first..stuck.end).collect();
    spoilt.sort_unstable();
    spoilt.dedup();
    // winches that stand still for most of a record are no fault of a row
    let are_left_out = 2 * spoilt.len() < samples.len();
    findings.extend(stuck.iter().map(|stuck| stuck.finding(samples, are_left_out)));
    if are_left_out {
        left_out.extend(spoilt);
    }
    left_out.sort_unstable();
    kept.retain(|sample| left_out.binary_search(sample).is_err());
    let samples =
        if kept.len() == samples.len() && findings.is_empty() { samples.clone() } else { samples.subset(&kept) };
    Screened { samples, findings }
}

/// Indices of the samples of one data set that repeat a sample of another exactly.
pub fn repeated_of(samples: &Samples, other: &Samples) -> Vec<usize> {
    let known: HashMap<Vec<u64>, ()> = (0..other.len()).map(|sample| (row(other, sample), ())).collect();
    (0..samples.len()).filter(|&sample| known.contains_key(&row(samples, sample))).collect()
}

/// The bits of a row's pose, lengths and tensions.
fn row(samples: &Samples, sample: usize) -> Vec<u64> {
    let pose = &samples.poses[sample];
    let cables = samples.cable_count;
    let recorded = samples.motor_angles.as_ref().unwrap_or(&samples.lengths);
    let tensions = samples.tensions.iter().flat_map(|all| &all[sample * cables..][..cables]);
    pose.position
        .iter()
        .chain(pose.rotation.coords.iter())
        .chain(&recorded[sample * cables..][..cables])
        .chain(tensions)
        .map(|value| value.to_bits())
        .collect()
}

/// Samples that repeat an earlier one exactly.
fn repeats(samples: &Samples) -> Vec<usize> {
    let mut first_of = HashMap::new();
    (0..samples.len()).filter(|&sample| *first_of.entry(row(samples, sample)).or_insert(sample) != sample).collect()
}

/// The order of the times where rows are shuffled; `None` where they are in order, or are several recordings one behind the other.
fn time_order(samples: &Samples) -> Option<Vec<usize>> {
    let time = samples.time.as_deref()?;
    let back = time.windows(2).filter(|pair| pair[1] < pair[0]).count();
    if back <= 3 || (back as f64) < SHUFFLED * time.len() as f64 {
        return None;
    }
    let mut order: Vec<usize> = (0..time.len()).collect();
    order.sort_by(|&a, &b| time[a].total_cmp(&time[b]).then(a.cmp(&b)));
    Some(order)
}

/// Consecutive rows in which a cable's sensor has one value.
struct Stuck {
    cable: usize,
    first: usize,
    end: usize,
    /// Change of the cable's length by the measured poses (m).
    moved: f64,
}

impl Stuck {
    fn finding(&self, samples: &Samples, is_left_out: bool) -> Finding {
        let value = samples.lengths_of(self.first)[self.cable];
        let text = format!(
            "cable {} reads {:.4} m in all rows from {} to {} though the poses move its anchors by {} mm: {}",
            self.cable + 1,
            value,
            place(samples, self.first),
            place(samples, self.end - 1),
            three_digits(1e3 * self.moved),
            if is_left_out {
                "a stuck sensor; these rows are left out"
            } else {
                "a sensor that does not work, or winches that stand still"
            }
        );
        let found = Finding::new(FindingKind::Stuck, Severity::Caution, text).of_cable(self.cable).of_size(value, "m");
        at(samples, self.first, found)
    }
}

fn stuck(robot: &Robot, samples: &Samples) -> Vec<Stuck> {
    let least = (MOVED * robot.anchor_diagonal()).max(MOVED_ACCURACIES * samples.sigmas.length.unwrap_or(0.0));
    let mut found = Vec::new();
    for (cable, anchors) in robot.cables.iter().enumerate().take(samples.cable_count) {
        let recorded = |sample: usize| samples.lengths_of(sample)[cable];
        let straight =
            |sample: usize| (anchors.frame_anchor - samples.poses[sample].transform(&anchors.platform_anchor)).norm();
        let mut first = 0;
        while first < samples.len() {
            let same = (first..samples.len()).take_while(|&sample| recorded(sample) == recorded(first)).count();
            let rows = first..first + same.max(1);
            let (low, high) = rows
                .clone()
                .map(straight)
                .fold((f64::INFINITY, 0.0_f64), |(low, high), length| (low.min(length), high.max(length)));
            if same >= STUCK && high - low > least {
                found.push(Stuck { cable, first, end: rows.end, moved: high - low });
            }
            first = rows.end;
        }
    }
    found
}

/// A sample's place in words: its line where that is known.
pub(crate) fn place(samples: &Samples, sample: usize) -> String {
    samples.lines.as_ref().map_or_else(|| format!("sample {}", sample + 1), |lines| format!("line {}", lines[sample]))
}

/// A finding with the line of a sample, where that is known.
pub(crate) fn at(samples: &Samples, sample: usize, finding: Finding) -> Finding {
    match &samples.lines {
        Some(lines) => finding.at_line(lines[sample]),
        None => finding,
    }
}

#[cfg(test)]
mod tests {
    use cdpr_model::geometry::Pose;
    use nalgebra::Vector3;

    use super::*;

    /// A planar robot on a circle, its lengths to the millimetre.
    fn samples(robot: &Robot, count: usize) -> Samples {
        let pose = |at: usize| {
            let angle = 0.37 * at as f64;
            Pose { position: Vector3::new(4.0 + 1.5 * angle.cos(), 0.0, 4.0 + 1.2 * angle.sin()), ..Pose::identity() }
        };
        let poses: Vec<Pose> = (0..count).map(pose).collect();
        let length = |pose: &Pose, cable: usize| {
            let own = &robot.cables[cable];
            (own.frame_anchor - pose.transform(&own.platform_anchor)).norm()
        };
        let cables = robot.cables.len();
        let lengths = poses.iter().flat_map(|pose| (0..cables).map(move |cable| length(pose, cable))).collect();
        let lines = Some((2..count + 2).collect());
        Samples { poses, lengths, cable_count: cables, lines, ..Samples::default() }
    }

    #[test]
    fn clean_rows_are_all_kept() {
        let robot = Robot::builtin("planar-example").unwrap();
        let clean = samples(&robot, 40);
        assert_eq!(screened(&robot, &clean), Screened { samples: clean, findings: Vec::new() });
    }

    #[test]
    fn rows_that_repeat_others_count_once() {
        let robot = Robot::builtin("planar-example").unwrap();
        let clean = samples(&robot, 40);
        let pasted = clean.subset(&(0..120).map(|at| at % 40).collect::<Vec<usize>>());
        let found = screened(&robot, &pasted);
        assert_eq!(found.samples, clean);
        assert!(found.findings[0].text.starts_with("80 of 120 rows repeat others exactly"), "{:?}", found.findings);
        assert_eq!(repeated_of(&pasted, &clean).len(), 120);
        assert_eq!(repeated_of(&samples(&robot, 41), &clean), (0..40).collect::<Vec<usize>>());
    }

    #[test]
    fn a_stuck_sensor_is_named_with_its_rows() {
        let robot = Robot::builtin("planar-example").unwrap();
        let mut spoilt = samples(&robot, 40);
        let cables = spoilt.cable_count;
        (10..20).for_each(|sample| spoilt.lengths[sample * cables + 1] = spoilt.lengths[10 * cables + 1]);
        let found = screened(&robot, &spoilt);
        let finding = &found.findings[0];
        assert_eq!((finding.kind, finding.cable, finding.line), (FindingKind::Stuck, Some(1), Some(12)));
        assert_eq!(found.samples.len(), 30);
        assert!(finding.text.contains("line 12 to line 21"), "{}", finding.text);
    }

    #[test]
    fn shuffled_rows_are_taken_in_the_order_of_their_times() {
        let robot = Robot::builtin("planar-example").unwrap();
        let mut clean = samples(&robot, 40);
        clean.time = Some((0..40).map(f64::from).collect());
        let shuffled = clean.subset(&(0..40).map(|at| at * 17 % 40).collect::<Vec<usize>>());
        assert_eq!(screened(&robot, &shuffled).samples, clean);
        // two recordings, one behind the other, are no shuffle
        clean.time = Some((0..40).map(|at| f64::from(at % 20)).collect());
        assert_eq!(screened(&robot, &clean).findings, Vec::new());
    }
}
