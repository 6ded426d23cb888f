//! The reachable workspace (eq. 3.33): poses that a control model can command on a machine without breaking limits.
//!
//! The *model* workspace (eq. 3.31) is where the control model itself is wrench-feasible, the *physical* one (eq. 3.32)
//! where the machine is; both are [`cdpr_workspace::criterion::WrenchFeasible`]. The reachable workspace depends on
//! both models and on the winch offsets: [`Reachable`] is a [`Criterion`], so that every method of [`cdpr_workspace`]
//! can measure it.

mod census;
mod differential;
mod emerging;
mod linear;
mod refined;
#[cfg(test)]
mod tests;

pub use census::{Cell, Census};
pub use differential::{Varied, differential_hull};
pub use emerging::{Image, emerging_size, image_of};
pub use refined::{ByCensus, CountedCells};

use cdpr_model::control::CommandedPose;
use cdpr_model::control::Driving;
use cdpr_model::control::Emerged;
use cdpr_model::control::InputError;
use cdpr_model::control::MapEffect;
use cdpr_model::control::Outcome;
use cdpr_model::control::Status;
use cdpr_model::equilibrium::elastostatics;
use cdpr_model::geometry::Pose;
use cdpr_model::tension::Limits;
use cdpr_workspace::criterion::Criterion;
use cdpr_workspace::{Point, Region, Verdict};

/// Requirements that a commanded pose must keep to count as reached.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Requirements {
    /// Limits of the emerging tensions (N); a rigid machine has no tensions to judge.
    pub tensions: Option<Limits>,
    /// Largest distance between commanded and emerging position, Δx_max (m).
    pub position_error_max: Option<f64>,
    /// Largest angle between commanded and emerging orientation (rad).
    pub rotation_error_max: Option<f64>,
    /// Largest difference between an emerging and its commanded tension (N).
    pub tension_error_max: Option<f64>,
}

/// Poses at which the machine comes to rest within the requirements if the control model commands them.
///
/// The forward problem starts from the commanded pose: equilibria that only other starts would find do not count. The
/// margin is dimensionless: the least of (f − f_min)/(f_max − f_min) and (f_max − f)/(f_max − f_min) over cables and of
/// 1 − error/largest error of position, rotation and tensions.
pub struct Reachable {
    driving: Driving,
    requirements: Requirements,
}

impl Reachable {
    /// Reachable workspace of a driven machine; an error if no requirement applies, such as tension limits for a rigid
    /// machine.
    pub fn new(driving: Driving, requirements: Requirements) -> Result<Self, InputError> {
        let machine = driving.machine();
        let Requirements { tensions, position_error_max, rotation_error_max, tension_error_max } = &requirements;
        let (is_elastic, commands) = (machine.needs_tensions(), driving.control().chooses_tensions());
        if tension_error_max.is_some() && !(is_elastic && commands) {
            return Err(InputError::NoCommandedTensions { commands });
        }
        let errors = [position_error_max, rotation_error_max, tension_error_max];
        if errors.iter().all(|largest| largest.is_none()) && !(is_elastic && tensions.is_some()) {
            return Err(InputError::NoRequirement { is_elastic });
        }
        if let Some(limits) = tensions.as_ref().filter(|limits| limits.cable_count() != machine.cable_count()) {
            let (expected, found) = (machine.cable_count(), limits.cable_count());
            return Err(InputError::Count { key: "tension limits", expected, found });
        }
        Ok(Self { driving: driving.without_restarts(), requirements })
    }

    /// Control model, machine and winches.
    pub(crate) fn driving(&self) -> &Driving {
        &self.driving
    }

    /// Effect of the map that corrects the control model: the points outside its samples, and the size of the workspace
    /// without it; `None` if there is no map.
    pub fn map_effect<T>(
        &self,
        region: &Region<'_>,
        points: &[Point],
        size: impl FnOnce(&Region<'_>) -> T,
    ) -> Option<MapEffect<T>> {
        let alone = Self { driving: self.driving.without_map()?, requirements: self.requirements.clone() };
        let operation = self.driving.operation();
        let rotation = region.orientations().first().copied().unwrap_or_default();
        let pose = |point: &Point| Pose { position: region.position(point), rotation };
        let beyond = operation.beyond_map(points.iter().map(pose));
        Some(MapEffect { beyond, without: size(&region.with_criterion(&alone)) })
    }

    /// Requirements on a pose.
    pub fn requirements(&self) -> &Requirements {
        &self.requirements
    }

    /// The verdict on an outcome.
    pub fn verdict(&self, commanded: &Pose, outcome: &Outcome) -> Verdict {
        if outcome.status != Status::Converged {
            let reason = outcome.reason.as_deref().unwrap_or("nothing emerges");
            return Verdict::impossible(reason, None);
        }
        let forces = Forces::of(outcome);
        let errors = Errors::of(commanded, &outcome.pose, forces);
        let decisive =
            self.margins(&errors, forces.emerging).into_iter().flatten().min_by(|a, b| a.margin.total_cmp(&b.margin));
        match decisive {
            Some(Decisive { margin, cable, .. }) if margin >= 0.0 => Verdict::held(margin, cable),
            Some(decisive) => Verdict::failed(decisive.margin, self.words(&decisive, &errors, outcome), decisive.cable),
            None => Verdict::held(f64::INFINITY, None),
        }
    }

    fn margins(&self, errors: &Errors, emerging: Option<&[f64]>) -> [Option<Decisive>; 4] {
        let Requirements { tensions, position_error_max, rotation_error_max, tension_error_max } = &self.requirements;
        let of_error = |kind, error: f64, largest: f64| Decisive { kind, margin: 1.0 - error / largest, cable: None };
        [
            tension_error_max.zip(errors.tension).map(|(largest, (error, cable))| Decisive {
                cable: Some(cable),
                ..of_error(Kind::Tracking, error, largest)
            }),
            position_error_max.map(|largest| of_error(Kind::Position, errors.position, largest)),
            rotation_error_max.map(|largest| of_error(Kind::Rotation, errors.rotation, largest)),
            tensions.as_ref().zip(emerging).map(|(limits, tensions)| {
                let (margin, cable) = tension_margin(limits, tensions);
                Decisive { kind: Kind::Tension, margin, cable: Some(cable) }
            }),
        ]
    }

    /// Text for the requirement that is broken.
    fn words(&self, decisive: &Decisive, errors: &Errors, outcome: &Outcome) -> String {
        let Requirements { tensions, position_error_max, rotation_error_max, tension_error_max } = &self.requirements;
        match decisive.kind {
            Kind::Tracking => {
                let (error, cable) = errors.tension.unwrap_or((f64::NAN, 0));
                let most = tension_error_max.unwrap_or(f64::NAN);
                format!(
                    "the tension of cable {} misses the commanded one by {error:.1} N, {most:.1} N are allowed",
                    cable + 1
                )
            }
            Kind::Position => {
                let (error, most) = (1e3 * errors.position, 1e3 * position_error_max.unwrap_or(f64::NAN));
                format!(
                    "the platform comes to rest {error:.3} mm beside the commanded position, {most:.3} mm are allowed"
                )
            }
            Kind::Rotation => {
                let (error, most) = (errors.rotation.to_degrees(), rotation_error_max.unwrap_or(f64::NAN).to_degrees());
                format!("the platform comes to rest turned by {error:.4}°, {most:.4}° are allowed")
            }
            Kind::Tension => {
                let cable = decisive.cable.unwrap_or(0);
                let tension = outcome.tensions.as_ref().map_or(f64::NAN, |tensions| tensions[cable]);
                let range = tensions.as_ref().map(|limits| [limits.minimum()[cable], limits.maximum()[cable]]);
                let [low, high] = range.unwrap_or([f64::NAN; 2]);
                match tension < low {
                    true => {
                        format!("cable {} has {tension:.1} N, less than its least tension of {low:.1} N", cable + 1)
                    }
                    false => {
                        format!("cable {} has {tension:.1} N, more than its largest tension of {high:.1} N", cable + 1)
                    }
                }
            }
        }
    }
}

/// Tensions of one command (N), as far as they are known.
#[derive(Clone, Copy)]
struct Forces<'t> {
    emerging: Option<&'t [f64]>,
    commanded: Option<&'t [f64]>,
}

/// Errors of position and orientation (m, rad), and the largest difference of a tension from the commanded one (N) with
/// its cable.
struct Errors {
    position: f64,
    rotation: f64,
    tension: Option<(f64, usize)>,
}

impl Errors {
    fn of(commanded: &Pose, emerging: &Pose, forces: Forces<'_>) -> Self {
        let position = (emerging.position - commanded.position).norm();
        Self { position, rotation: emerging.angle_to(commanded), tension: forces.largest_error() }
    }
}

impl<'t> Forces<'t> {
    fn of(outcome: &'t Outcome) -> Self {
        Self { emerging: outcome.tensions.as_deref(), commanded: outcome.commanded_tensions.as_deref() }
    }

    fn largest_error(&self) -> Option<(f64, usize)> {
        let (emerging, commanded) = self.emerging.zip(self.commanded)?;
        let errors = emerging.iter().zip(commanded).map(|(f, wanted)| (f - wanted).abs());
        errors.enumerate().map(|(cable, error)| (error, cable)).max_by(|a, b| a.0.total_cmp(&b.0))
    }
}

/// A requirement with its margin.
struct Decisive {
    kind: Kind,
    margin: f64,
    cable: Option<usize>,
}

enum Kind {
    Position,
    Rotation,
    Tension,
    Tracking,
}

/// Distance of the tensions from their limits as a fraction of the range, and the nearest cable.
///
/// An empty range counts as one of 1 N. A limit missed by rounding is kept: a force controller commands many poses with
/// tensions at their limits.
fn tension_margin(limits: &Limits, tensions: &[f64]) -> (f64, usize) {
    let mut least = (f64::INFINITY, 0);
    for (cable, &tension) in tensions.iter().enumerate() {
        let (low, high) = (limits.minimum()[cable], limits.maximum()[cable]);
        let range = if high > low { high - low } else { 1.0 };
        let margin = f64::min(tension - low, high - tension) / range;
        if margin < least.0 {
            least = (margin, cable);
        }
    }
    let is_rounding = least.0 < 0.0 && least.0 >= -ROUNDING;
    if is_rounding { (0.0, least.1) } else { least }
}

/// Tolerance of the forward problem, as a fraction of a tension's range: far above its rounding, far below any load
/// cell.
const ROUNDING: f64 = 1e-8;

impl Criterion for Reachable {
    fn name(&self) -> &str {
        "reachable"
    }

    fn unit(&self) -> &str {
        "1"
    }

    fn effort(&self) -> f64 {
        let machine = self.driving.machine();
        let is_together = machine.has_forward_batch() && machine.needs_tensions();
        // measured with four and eight cables
        match (self.driving.history(), is_together, self.driving.control().chooses_tensions()) {
            (Some(_), ..) => 10_000.0,
            (None, true, false) => 5.0,
            (None, true, true) => 50.0,
            (None, false, _) => 500.0,
        }
    }

    fn judge(&self, pose: &Pose) -> Verdict {
        self.verdict(pose, &self.driving.outcome(pose))
    }

    fn holds(&self, pose: &Pose) -> bool {
        self.is_kept(pose, &self.driving.outcome(pose))
    }

    fn holds_all(&self, poses: &[Pose], answers: &mut [bool]) {
        let kept = self.of_emerging(poses, self.needs_all_taut(), |commanded, emerging, forces| {
            self.keeps(commanded, emerging, forces)
        });
        answers.iter_mut().zip(kept).for_each(|(answer, kept)| *answer = kept == Some(true));
    }
}

impl Reachable {
    /// True if [`Reachable::verdict`] holds, without words.
    fn is_kept(&self, commanded: &Pose, outcome: &Outcome) -> bool {
        outcome.status == Status::Converged && self.keeps(commanded, &outcome.pose, Forces::of(outcome))
    }

    fn keeps(&self, commanded: &Pose, emerging: &Pose, forces: Forces<'_>) -> bool {
        let margins = self.margins(&Errors::of(commanded, emerging, forces), forces.emerging);
        margins.iter().flatten().all(|decisive| decisive.margin >= 0.0)
    }

    /// True if any slack cable breaks a limit.
    fn needs_all_taut(&self) -> bool {
        self.requirements.tensions.as_ref().is_some_and(|limits| limits.minimum().iter().all(|&least| least > 0.0))
    }

    /// Applies `of` to commanded pose, emerging pose and tensions of each of many commands, in batches if the machine
    /// supports them; `None` if the machine has no answer. With `only_taut`, commands in which a cable hangs slack may
    /// be left out, since they take ten times as long.
    fn of_emerging<T>(
        &self,
        poses: &[Pose],
        only_taut: bool,
        of: impl Fn(&Pose, &Pose, Forces<'_>) -> T,
    ) -> Vec<Option<T>> {
        let mut found: Vec<Option<T>> = poses.iter().map(|_| None).collect();
        let mut tensions = vec![0.0; self.driving.machine().cable_count()];
        let mut operation = self.driving.operation();
        match operation.answer_all(poses, only_taut) {
            Some(Emerged { commanded, solutions, commanded_tensions }) => {
                let cables = tensions.len();
                let settled = |item: &usize| solutions.status(*item) == elastostatics::Status::Converged;
                for item in (0..commanded.len()).filter(settled) {
                    tensions.iter_mut().enumerate().for_each(|(cable, f)| *f = solutions.tension(cable, item));
                    let index = commanded[item];
                    let wanted = commanded_tensions.get(item * cables..(item + 1) * cables);
                    let forces = Forces { emerging: Some(&tensions), commanded: wanted };
                    found[index] = Some(of(&poses[index], &solutions.pose(item), forces));
                }
            }
            None => {
                for (pose, found) in poses.iter().zip(&mut found) {
                    let outcome = operation.answer(&CommandedPose::at(*pose));
                    let is_settled = outcome.status == Status::Converged;
                    *found = is_settled.then(|| of(pose, &outcome.pose, Forces::of(&outcome)));
                }
            }
        }
        found
    }

    /// Emerging positions, as points of a region; `None` if the machine has no answer.
    pub(crate) fn emerging_positions(&self, region: &Region<'_>, commanded: &[Pose]) -> Vec<Option<Point>> {
        self.of_emerging(commanded, false, |_, emerging, _| region.point(&emerging.position))
    }
}
