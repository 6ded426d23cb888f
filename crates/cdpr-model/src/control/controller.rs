//! A control model as a controller uses it: from poses to lengths.

use super::input_error::InputError;
use super::operation_error::OperationError;
use crate::compensation::{Beyond, Compensation, Correction};
use crate::equilibrium::{State, distribution};
use crate::geometry::Pose;
use crate::measurement::Samples;
use crate::model::Model;
use crate::statics::{Load, StaticsError};
use crate::tension::{Limits, Method};

/// A control model with its method for choosing tensions. `Control::from` a model chooses those nearest to the middle
/// of the limits.
///
/// ```
/// use cdpr::control::Control;
/// use cdpr::tension::Method;
/// # use cdpr::model::{Composition, Model};
/// # let robot = cdpr::robot::Robot::builtin("planar-example").ok_or("unknown robot")?;
/// let model = Model::new(robot, "elastic".parse::<Composition>()?)?;
/// let low = Control { tension_method: Method::Minimum, ..Control::from(&model) };
/// assert_eq!(Control::from(&model).tension_method, Method::Qp);
/// # let _ = low;
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Control {
    /// The model.
    pub model: Model,
    /// Method that chooses the commanded tensions; no effect if lengths do not depend on tensions.
    pub tension_method: Method,
    /// Map that corrects its lengths; over the margin around the map's samples the correction fades to zero.
    pub compensation: Option<Compensation>,
}

impl<'a> From<&'a Model> for Control {
    fn from(model: &'a Model) -> Self {
        Self { model: model.clone(), tension_method: Method::default(), compensation: None }
    }
}

impl Control {
    /// Table for a controller: the lengths to send at poses, in the units of the model's encoders, with the tensions
    /// that belong to them, as samples, and the poses at which the map fades. The first pose without lengths is an
    /// error, and so is one beyond the map.
    pub fn table(&self, poses: &[Pose]) -> Result<(Samples, Beyond), OperationError> {
        let mut controller = Controller::new(self.clone())?;
        let mut state = State::at_home(&self.model);
        let mut table = Samples { cable_count: self.model.cable_count(), poses: poses.to_vec(), ..Samples::default() };
        let mut fractions = Vec::with_capacity(poses.len());
        for (place, pose) in poses.iter().enumerate() {
            let at_pose = |reason| OperationError::AtPose { pose: place + 1, reason: Box::new(reason) };
            let modelled = controller.modelled(pose, None, &mut state).map_err(at_pose)?;
            table.lengths.extend(match controller.correction(pose) {
                Some(correction) => {
                    let correction = correction.known().map_err(|unknown| at_pose(unknown.into()))?;
                    fractions.push(correction.fraction);
                    correction.added_to(&modelled)
                }
                None => modelled,
            });
            if let Some(tensions) = controller.tensions() {
                let recorded = tensions.iter().enumerate();
                let recorded = recorded.map(|(cable, &tension)| self.model.recorded_tension(cable, tension));
                table.tensions.get_or_insert_default().extend(recorded);
            }
        }
        Ok((table, Beyond::of(fractions.into_iter())))
    }
}

/// Solver, load and limits with which a control model chooses tensions.
#[derive(Clone, Debug)]
pub struct TensionChoice {
    /// Solver of the tension distribution.
    pub solver: distribution::Solver,
    /// Load of the control model.
    pub load: Load,
    /// Limits of the tensions (N).
    pub limits: Limits,
}

impl Control {
    /// Refuses a map for a task that cannot use one.
    pub fn without_map(self, question: &'static str, reason: &'static str) -> Result<Self, InputError> {
        match self.compensation {
            Some(_) => Err(InputError::Map { question, reason }),
            None => Ok(self),
        }
    }

    /// True if lengths depend on tensions, which it has to choose.
    pub fn chooses_tensions(&self) -> bool {
        self.model.needs_tensions()
    }

    /// The choice of tensions; `None` if lengths do not depend on tensions.
    pub fn tension_choice(&self) -> Result<Option<TensionChoice>, InputError> {
        if !self.chooses_tensions() {
            return Ok(None);
        }
        let Self { model, tension_method, .. } = self;
        let (limits, load) = (Limits::of(model.robot(), None, None)?, Load::of(model.robot())?);
        let solver = distribution::Solver::by(*tension_method, model, &load, &limits);
        Ok(Some(TensionChoice { solver, load, limits }))
    }
}

/// A control model that commands a machine.
#[derive(Clone, Debug)]
pub(super) struct Controller {
    model: Model,
    /// Map that corrects its lengths.
    compensation: Option<Compensation>,
    /// Solver of the tensions, if lengths depend on them.
    distribution: Option<distribution::Solver>,
    /// The last tensions (N); NaN if lengths do not depend on them.
    tensions: Vec<f64>,
}

impl Controller {
    pub(super) fn new(control: Control) -> Result<Self, InputError> {
        let distribution = control.tension_choice()?.map(|choice| choice.solver);
        let Control { model, compensation, .. } = control;
        let tensions = vec![f64::NAN; model.cable_count()];
        Ok(Self { model, compensation, distribution, tensions })
    }

    pub(super) fn model(&self) -> &Model {
        &self.model
    }

    /// The map that corrects its lengths.
    pub(super) fn compensation(&self) -> Option<&Compensation> {
        self.compensation.as_ref()
    }

    /// The controller without its map.
    pub(super) fn without_map(self) -> Self {
        Self { compensation: None, ..self }
    }

    /// The model, if its lengths do not depend on tensions and no map corrects them.
    pub(super) fn kinematic(&self) -> Option<&Model> {
        (self.distribution.is_none() && self.compensation.is_none()).then_some(&self.model)
    }

    /// Tensions of the last lengths (N), if lengths depend on them.
    pub(super) fn tensions(&self) -> Option<&[f64]> {
        self.distribution.is_some().then_some(self.tensions.as_slice())
    }

    /// Lengths for a pose in the units of the model's encoders (m), corrected by the map, with cables that start from
    /// the memories of the state. `tensions` (N), if given, replace its own choice where lengths depend on them.
    pub(super) fn lengths(
        &mut self,
        pose: &Pose,
        tensions: Option<&[f64]>,
        state: &mut State,
    ) -> Result<Vec<f64>, OperationError> {
        let modelled = self.modelled(pose, tensions, state)?;
        Ok(match self.correction(pose) {
            Some(correction) => correction.added_to(&modelled),
            None => modelled,
        })
    }

    /// Correction of its map at a pose; `None` without a map.
    fn correction(&self, pose: &Pose) -> Option<Correction> {
        self.compensation.as_ref().map(|map| map.at(pose))
    }

    /// [`Controller::lengths`] without the map.
    fn modelled(
        &mut self,
        pose: &Pose,
        tensions: Option<&[f64]>,
        state: &mut State,
    ) -> Result<Vec<f64>, OperationError> {
        let given = tensions.filter(|_| self.distribution.is_some());
        if let Some(given) = given {
            self.tensions = given.to_vec();
        } else if let Some(distribution) = &mut self.distribution {
            let found = distribution.solve(pose)?;
            if let Some(reason) = found.reason {
                return Err(OperationError::NoTensions(reason));
            }
            self.tensions = found.tensions;
        }
        Ok(self.model.inverse(pose, &self.tensions, state)?.recorded_lengths()?)
    }
}

/// Lengths with which a model's cables, never loaded before, have these tensions (N) at a pose, in the units of its
/// encoders (m).
pub fn lengths_at(model: &Model, pose: &Pose, tensions: &[f64]) -> Result<Vec<f64>, StaticsError> {
    model.inverse(pose, tensions, &mut State::at(model, pose))?.recorded_lengths()
}
