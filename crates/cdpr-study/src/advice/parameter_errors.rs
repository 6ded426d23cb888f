//! Errors of a control model's numbers, which come on top of what it leaves out.

use crate::sensitivity::{Kind, Offsets, Sensitivity, Setting, Side, counted_as, rank_kinds};
use crate::tolerance::allowed;
use cdpr_model::control::{CommandedPose, Control, History, Initial, InputError, tension_model, winch_offsets};
use cdpr_model::geometry::Pose;
use cdpr_model::model::{Composition, Model};
use cdpr_model::tension::Method;

/// Standard deviations that an allowed one keeps within the accuracy.
const COVERAGE: f64 = 2.0;

/// Errors of one kind of number, each once, to first order over the poses of a task.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ParameterError {
    /// Side under whose name the error counts.
    pub side: Side,
    /// Kind of the numbers.
    pub kind: Kind,
    /// Root mean square over the poses of the displacement of the platform by errors of one standard deviation in all numbers of the kind (m per unit).
    pub position_rms: f64,
    /// The same at the worst pose (m per unit).
    pub position_max: f64,
    /// Standard deviation up to which two of them stay within the required accuracy if all else is exact, in the unit of the kind; `None` if the
    /// error without deviations uses up the accuracy.
    pub allowed: Option<f64>,
}

/// Task and machine that numbers are judged by.
pub(super) struct Judged<'a> {
    pub(super) machine: &'a Model,
    pub(super) home: &'a Pose,
    /// Poses that the control model reaches.
    pub(super) poses: &'a [Pose],
    /// Largest position error (m).
    pub(super) accuracy: f64,
}

impl Judged<'_> {
    /// Errors of the numbers of a control model on the machine, the kinds with an effect; none where no pose is reached.
    pub(super) fn errors(&self, control: Composition, method: Method) -> Result<Vec<ParameterError>, InputError> {
        if self.poses.is_empty() {
            return Ok(Vec::new());
        }
        let model = Model::new(self.machine.robot().clone(), control)?;
        let control = Control { tension_method: method, ..Control::from(&model) };
        let initial = initial(&control, self.machine);
        let offsets = winches(&control, self.machine, self.home)?;
        let setting = Setting { initial: &initial, pose: *self.home, former: None, offsets: Offsets::Kept };
        let history = History::of(self.machine, None);
        let commanded: Vec<CommandedPose> = self.poses.iter().map(|pose| CommandedPose::at(*pose)).collect();
        let mut sensitivity =
            Sensitivity::new(control, self.machine, &offsets, &setting)?.with_history(history.as_ref(), self.home);
        let found = sensitivity.along(&commanded)?;
        let causes = sensitivity.causes();
        let translations = self.machine.robot().motion_pattern.translations();
        let known: Vec<_> = found.iter().filter_map(|at| at.derivatives.as_ref().ok()).collect();
        let errors: Vec<f64> =
            found.iter().zip(self.poses).map(|(at, pose)| (at.outcome.pose.position - pose.position).norm()).collect();
        let counts = |side, kind| counted_as(side, kind, causes).is_none();
        let allowed = allowed(causes, &found, &errors, self.accuracy, COVERAGE, &counts, translations);
        let kinds = rank_kinds(causes, &known, translations).into_iter();
        let of_kind = kinds.filter(|one| counts(one.side, one.kind) && one.position_max > 0.0).map(|one| {
            let own = allowed.kinds.iter().find(|kind| (kind.side, kind.kind) == (one.side, one.kind));
            ParameterError {
                side: one.side,
                kind: one.kind,
                position_rms: one.position_rms,
                position_max: one.position_max,
                allowed: own.map(|kind| kind.alone),
            }
        });
        Ok(of_kind.collect())
    }
}

/// Setting of the winches with a control model.
fn initial(control: &Control, machine: &Model) -> Initial {
    Initial {
        tension_method: Some(Method::Qp),
        offset: tension_model(&control.model, machine).is_none().then(|| "none".to_owned()),
        ..Initial::default()
    }
}

/// Winch offsets with which a control model's lengths lead home (m).
pub(super) fn winches(control: &Control, machine: &Model, home: &Pose) -> Result<Vec<f64>, InputError> {
    winch_offsets(&initial(control, machine), &control.model, machine, home)
}
