//! Derivatives of the winch offsets by deviations: zero if they are kept, or those of setting the winches again.

use nalgebra::DVector;

use super::cause::{Kind, ParameterDeviation, Side};
use super::choice::Choice;
use super::command::{at_tensions, by_tensions};
use super::offsets::Offsets;
use super::windings::Windings;
use cdpr_model::control::Initial;
use cdpr_model::control::InputError;
use cdpr_model::control::OperationError;
use cdpr_model::control::lengths_at;
use cdpr_model::control::{aim, initial_tensions, tension_model, winch_offsets};
use cdpr_model::geometry::Pose;
use cdpr_model::model::Model;
use cdpr_model::statics::Load;
use cdpr_model::tension::Method;

/// Description of how the winches were set.
#[derive(Clone, Copy, Debug)]
pub struct Setting<'a> {
    /// Table `[initial]` of the study.
    pub initial: &'a Initial,
    /// The initial pose.
    pub pose: Pose,
    /// The model in use when they were set; `None` if it was the control model.
    pub former: Option<&'a Model>,
    /// Effect of deviations on the offsets.
    pub offsets: Offsets,
}

impl<'a> Setting<'a> {
    /// The model in use when the winches were set.
    pub(crate) fn set_with<'b>(&self, control: &'b Model) -> &'b Model
    where
        'a: 'b,
    {
        self.former.unwrap_or(control)
    }

    /// True if the offsets follow from initial tensions or geometry, and are neither "none" nor given numbers.
    pub(crate) fn has_computed_offsets(&self) -> bool {
        self.initial.offset.is_none() && self.initial.offset_m.is_none()
    }

    /// Changes of the winch offsets (m) per unit of each cause.
    pub(super) fn by_causes(
        &self,
        control: &'a Model,
        machine: &'a Model,
        causes: &[ParameterDeviation],
    ) -> Result<Vec<DVector<f64>>, InputError> {
        let m = machine.cable_count();
        let at = if self.has_computed_offsets() { Some(AtInitial::new(self, control, machine)?) } else { None };
        let one = |cause: &ParameterDeviation| match (cause.kind, &at) {
            (Kind::WinchOffset, _) => Ok(DVector::from_fn(m, |cable, _| f64::from(u8::from(cable == cause.cable)))),
            (Kind::InitialTension, Some(at)) => Ok(at.by_initial_tension(cause)),
            (_, Some(at)) if self.offsets == Offsets::SetAnew => at.by_cause(cause),
            _ => Ok(DVector::zeros(m)),
        };
        causes.iter().map(one).collect()
    }
}

/// The state at which the winches were set.
struct AtInitial<'a> {
    setting: &'a Setting<'a>,
    control: &'a Model,
    machine: &'a Model,
    set_with: &'a Model,
    tensions: Vec<f64>,
    /// Side whose model determines the tensions; `None` if neither has any.
    carries: Option<Side>,
    /// Windings between the model in use and the machine.
    windings: Windings<'a>,
    /// Derivatives of the tensions by their reference; `None` for rigid robots, and if the structure matrix is
    /// rank-deficient.
    as_they_are: Option<Choice<'a>>,
    /// Derivatives of the tensions chosen by the study's method; `None` if it has none.
    chosen: Option<Choice<'a>>,
    /// Change of the lengths per tension (m/N) for machine and model in use.
    stretch: [DVector<f64>; 2],
}

impl<'a> AtInitial<'a> {
    fn new(setting: &'a Setting<'a>, control: &'a Model, machine: &'a Model) -> Result<Self, InputError> {
        let (set_with, pose, m) = (setting.set_with(control), &setting.pose, machine.cable_count());
        let elastic = tension_model(set_with, machine);
        let carries = elastic.map(|elastic| if std::ptr::eq(elastic, machine) { Side::Machine } else { Side::Control });
        let tensions = match elastic {
            Some(elastic) => initial_tensions(setting.initial, elastic, pose)?,
            None => vec![0.0; m],
        };
        let sent = lengths_at(set_with, pose, &tensions)?;
        let offsets = winch_offsets(setting.initial, set_with, machine, pose)?;
        let wanted: Vec<f64> = sent.iter().zip(&offsets).map(|(sent, offset)| sent + offset).collect();
        let windings = Windings::at(set_with, machine, &wanted).map_err(|error| match error {
            OperationError::Input(error) => error,
            other => InputError::NotBalanced { reason: other.to_string() },
        })?;
        let (mut as_they_are, mut chosen) = (None, None);
        if let Some(elastic) = elastic {
            as_they_are = Choice::nearest(elastic, pose, &tensions, &tensions)?.ok();
            chosen = choice(setting.initial, elastic, pose, &tensions)?;
        }
        let stretch = [by_tensions(machine, pose, &tensions)?, by_tensions(set_with, pose, &tensions)?];
        Ok(Self { setting, control, machine, set_with, tensions, carries, windings, as_they_are, chosen, stretch })
    }

    /// Change of the offsets (m) with the tensions of all cables: the machine's change of length, in the units of the
    /// model in use, minus that of the model in use.
    fn by_tension_change(&self, tensions: &DVector<f64>) -> DVector<f64> {
        let [machine, set_with] = self.stretch.each_ref().map(|stretch| stretch.component_mul(tensions));
        self.windings.sent(&machine) - set_with
    }

    fn by_initial_tension(&self, cause: &ParameterDeviation) -> DVector<f64> {
        match &self.as_they_are {
            Some(choice) => self.by_tension_change(&choice.by_reference(cause.cable)),
            None => DVector::zeros(self.tensions.len()),
        }
    }

    fn by_cause(&self, cause: &ParameterDeviation) -> Result<DVector<f64>, InputError> {
        let model = match cause.side {
            Side::Machine => self.machine,
            Side::Control if self.setting.former.is_none() => self.set_with,
            _ => return Ok(DVector::zeros(self.tensions.len())),
        };
        let tensions = match (self.carries == Some(cause.side), &self.chosen) {
            (false, _) => DVector::zeros(self.tensions.len()),
            (true, Some(choice)) => choice.by_cause(cause)?,
            (true, None) => return self.by_differences(cause),
        };
        let own = at_tensions(model, &self.setting.pose, &self.tensions, cause)?;
        let mut machine = DVector::zeros(self.tensions.len());
        machine[cause.cable] -= self.windings.by_cause(cause);
        let mut change = self.by_tension_change(&tensions);
        match cause.side {
            Side::Machine => machine += own,
            _ => change -= own,
        }
        Ok(change + self.windings.sent(&machine))
    }

    /// Central differences, for tensions without a derivative.
    fn by_differences(&self, cause: &ParameterDeviation) -> Result<DVector<f64>, InputError> {
        let step = cause.kind.difference_step();
        let offsets = |by: f64| {
            let deviating = |model: &Model| {
                let mut robot = model.robot().clone();
                cause.deviate(model, &mut robot, by);
                Model::new(robot, model.composition())
            };
            let Setting { initial, pose, former, .. } = self.setting;
            let found = match cause.side {
                Side::Machine => winch_offsets(initial, self.set_with, &deviating(self.machine)?, pose)?,
                _ if former.is_none() => winch_offsets(initial, &deviating(self.control)?, self.machine, pose)?,
                _ => return Ok(DVector::zeros(self.tensions.len())),
            };
            Ok::<_, InputError>(DVector::from_vec(found))
        };
        Ok((offsets(step)? - offsets(-step)?) / (2.0 * step))
    }
}

/// Derivatives of the tensions that a study requests, by the model; `None` if there are none.
fn choice<'a>(
    initial: &Initial,
    model: &'a Model,
    pose: &Pose,
    tensions: &[f64],
) -> Result<Option<Choice<'a>>, InputError> {
    let found = match (&initial.tensions_N, initial.tension_method) {
        (Some(reference), _) => Choice::nearest(model, pose, tensions, reference)?,
        (None, None) => return Ok(None),
        (None, Some(Method::ClosedForm)) => {
            let limits = aim(initial, model)?;
            let middle: Vec<f64> = (0..model.cable_count()).map(|cable| limits.middle(cable)).collect();
            Choice::nearest(model, pose, tensions, &middle)?
        }
        (None, Some(method)) => {
            Choice::by(method, model, pose, &Load::of(model.robot())?, &aim(initial, model)?, tensions)?
        }
    };
    Ok(found.ok())
}
