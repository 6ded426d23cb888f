//! The differential hull of the reachable workspace: the motion of its boundary with any number of control model,
//! machine and winches.

use super::{Reachable, Requirements};
use crate::sensitivity::{Kind, ParameterDeviation, Side};
use cdpr_model::control::Control;
use cdpr_model::control::Driving;
use cdpr_model::control::History;
use cdpr_model::control::InputError;
use cdpr_model::geometry::Pose;
use cdpr_model::model::{Model, ModelError};
use cdpr_model::tension::Method;
use cdpr_workspace::Region;
use cdpr_workspace::differential::{Differences, Motion, motion};
use cdpr_workspace::hull::Hull;

/// Control model, machine and winches with one number changed.
pub struct Varied {
    control: Model,
    tension_method: Method,
    machine: Model,
    offsets: Vec<f64>,
    history: Option<History>,
    start: Pose,
    requirements: Requirements,
}

impl Varied {
    /// Control model, machine and winches of a reachable workspace, with a cause deviating by `by` (its unit); the
    /// winches keep their settings.
    ///
    /// An error for initial tensions: they are not a number of their own, but change with all winch offsets at once.
    pub fn new(reachable: &Reachable, cause: &ParameterDeviation, by: f64) -> Result<Self, InputError> {
        let driving = reachable.driving();
        let reason = "with a number that changes, its corrections would be those of another model";
        let tension_method = driving.control().clone().without_map("the differential reach", reason)?.tension_method;
        let mut offsets = driving.offsets().to_vec();
        match cause.kind {
            Kind::InitialTension => return Err(InputError::TensionsVaryTogether),
            Kind::WinchOffset => offsets[cause.cable] += by,
            _ => {}
        }
        let varied = |model: &Model, side: Side| -> Result<Model, ModelError> {
            let mut robot = model.robot().clone();
            if cause.side == side {
                cause.deviate(model, &mut robot, by);
            }
            Model::new(robot, model.composition())
        };
        Ok(Self {
            control: varied(&driving.control().model, Side::Control)?,
            tension_method,
            machine: varied(driving.machine(), Side::Machine)?,
            offsets,
            history: driving.history().map(|(history, _)| *history),
            start: driving.history().map_or_else(Pose::identity, |(_, start)| *start),
            requirements: reachable.requirements().clone(),
        })
    }

    /// Reachable workspace with the change; machines with history come to every pose on the same path as without it.
    pub fn reachable(&self) -> Result<Reachable, InputError> {
        let control = Control { tension_method: self.tension_method, ..Control::from(&self.control) };
        let driving = Driving::new(control, &self.machine, &self.offsets)?;
        Reachable::new(driving.with_history(self.history.as_ref(), &self.start), self.requirements.clone())
    }
}

/// Rate at which the end of each ray of a hull moves with a number, to first order (m per its unit).
///
/// `hull` is the hull of `reachable` in `region`.
pub fn differential_hull(
    reachable: &Reachable,
    region: &Region<'_>,
    hull: &Hull,
    cause: &ParameterDeviation,
) -> Result<Motion, InputError> {
    let step = cause.kind.difference_step();
    let [below, above] = [Varied::new(reachable, cause, -step)?, Varied::new(reachable, cause, step)?];
    let [less, more] = [below.reachable()?, above.reachable()?];
    let [below, above] = [region.with_criterion(&less), region.with_criterion(&more)];
    // margins are smooth over decimetres; solutions are exact to 1e-11 m
    let differences = Differences { parameter: step, radius: 1e-5 };
    Ok(motion(hull, region, [&below, &above], differences))
}
