//! Distance between the branches of a machine with history: the emerging pose depends on the path to it.

use cdpr_model::control::Control;
use cdpr_model::control::InputError;
use cdpr_model::control::Operation;
use cdpr_model::control::Outcome;
use cdpr_model::control::PoseErrorStatistics;
use cdpr_model::control::Status;
use cdpr_model::control::{CommandedPose, History, Reach};
use cdpr_model::geometry::Pose;
use cdpr_model::model::Model;

/// Distances between the outcomes of the same command after different paths, over the commanded poses, SI units.
#[derive(Clone, Debug, PartialEq)]
#[expect(non_snake_case, reason = "the fields are the keys of the answer, units included")]
pub struct Branches {
    /// Length of the detour along each translation, to either side (m).
    pub stroke_m: f64,
    /// Poses at which the platform comes to rest after every path; only these count.
    pub samples: usize,
    /// Count of paths to each pose: straight from the initial pose, and from both sides along each translation.
    pub ways: usize,
    /// Largest distance between two of the emerging positions (m).
    pub position_spread_m: PoseErrorStatistics,
    /// Largest angle between two of the emerging orientations (rad).
    pub rotation_spread_rad: PoseErrorStatistics,
    /// Largest difference of a cable's tension (N).
    pub tension_spread_N: PoseErrorStatistics,
}

/// The spread between branches at these poses: each is reached from the initial pose directly, and after a detour of
/// `stroke` (m) to either side along each translation of the pattern, always with cables that were never loaded before.
///
/// For a machine without history the spread is rounding.
pub fn branches(
    control: impl Into<Control>,
    machine: &Model,
    offsets: &[f64],
    history: &History,
    start: &Pose,
    poses: &[Pose],
    stroke: f64,
) -> Result<Branches, InputError> {
    let control = control.into();
    let history = History { reach: Reach::InOrder, ..*history };
    let detours = detours(machine, stroke);
    let (mut position, mut rotation, mut tension) = (Vec::new(), Vec::new(), Vec::new());
    for pose in poses {
        let mut ends = Vec::with_capacity(detours.len());
        for detour in &detours {
            let mut operation = Operation::new(control.clone(), machine, offsets)?.with_history(&history, start);
            if let Some(shift) = detour {
                let _ = operation.answer(&CommandedPose::at(Pose { position: pose.position + shift, ..*pose }));
            }
            ends.push(operation.answer(&CommandedPose::at(*pose)));
        }
        if ends.iter().all(|end| end.status == Status::Converged) {
            position.push(largest(&ends, |a, b| (a.pose.position - b.pose.position).norm()));
            rotation.push(largest(&ends, |a, b| a.pose.angle_to(&b.pose)));
            tension.push(largest(&ends, tension_difference));
        }
    }
    Ok(Branches {
        stroke_m: stroke,
        samples: position.len(),
        ways: detours.len(),
        position_spread_m: PoseErrorStatistics::of(&position),
        rotation_spread_rad: PoseErrorStatistics::of(&rotation),
        tension_spread_N: PoseErrorStatistics::of(&tension),
    })
}

/// Detours: none, and to either side along each translation.
fn detours(machine: &Model, stroke: f64) -> Vec<Option<nalgebra::Vector3<f64>>> {
    let sides = machine.axes().iter().flat_map(|axis| [Some(axis * stroke), Some(axis * -stroke)]);
    std::iter::once(None).chain(sides).collect()
}

fn largest(ends: &[Outcome], of: impl Fn(&Outcome, &Outcome) -> f64) -> f64 {
    let pairs = ends.iter().enumerate().flat_map(|(index, a)| ends[..index].iter().map(move |b| (a, b)));
    pairs.map(|(a, b)| of(a, b)).fold(0.0, f64::max)
}

fn tension_difference(a: &Outcome, b: &Outcome) -> f64 {
    let (Some(a), Some(b)) = (&a.tensions, &b.tensions) else { return 0.0 };
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}
