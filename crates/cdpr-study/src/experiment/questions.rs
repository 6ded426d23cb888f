//! Effects of deviations, and the best setting of the winches: questions to an experiment that need no poses of its
//! study.

use super::Experiment;
use crate::sensitivity::{Offsets, ParameterDeviation, Sensitivity, Setting, causes};
use cdpr_calibration::{Candidates, PlanError};
use cdpr_model::control::CommandedPose;
use cdpr_model::control::InputError;
use cdpr_model::control::initial_tension::Task;
use cdpr_model::control::tensions_set;
use cdpr_model::measurement::SensorSigmas;
use cdpr_model::model::Model;
use cdpr_model::tension::Limits;

impl Experiment {
    /// The tensions at which the winches were set (N); `None` if the study states offsets, or cables have no tensions.
    pub fn initial_tensions(&self) -> Result<Option<Vec<f64>>, InputError> {
        let initial = &self.study.initial;
        match initial.offset.is_none() && initial.offset_m.is_none() {
            true => tensions_set(initial, self.set_with(), &self.machine, &self.start),
            false => Ok(None),
        }
    }

    /// The task of choosing new initial tensions for the winches within `limits`, starting from the present ones.
    pub fn initial_tension_task<'a>(&'a self, limits: &'a Limits) -> Result<Task<'a>, InputError> {
        let reason = "winches that are set anew leave other errors than those that it was made of";
        Ok(Task {
            control: self.controller()?.without_map("the search for initial tensions", reason)?,
            machine: &self.machine,
            set_with: self.set_with(),
            pose: self.start,
            limits,
            history: self.history(),
            now: self.initial_tensions()?,
        })
    }

    /// Poses that could be measured: commands that the controller reaches within its requirements (eq. 3.33), with the
    /// records that `model` predicts there at `levels` levels of tension under these accuracies.
    pub fn reachable_candidates(
        &self,
        model: &Model,
        commands: &[CommandedPose],
        levels: usize,
        sigmas: SensorSigmas,
    ) -> Result<Candidates, PlanError> {
        let reachable = self.reachable()?;
        let outcomes = self.assess(commands)?.outcomes;
        let judged = commands.iter().zip(&outcomes);
        let reasons = judged.map(|(command, outcome)| reachable.verdict(&command.pose, outcome).reason);
        Candidates::of_reachable(model, commands, reasons.collect(), levels, sigmas)
    }

    /// Description of how the winches were set, and of how deviations change the offsets.
    pub(crate) fn setting(&self, offsets: Offsets) -> Setting<'_> {
        Setting { initial: &self.study.initial, pose: self.start, former: self.former.as_ref(), offsets }
    }

    /// Deviations of control model, machine and winches.
    pub fn causes(&self, offsets: Offsets) -> Vec<ParameterDeviation> {
        causes(&self.control, &self.machine, &self.setting(offsets))
    }

    /// Derivatives of pose and tensions by every number that may deviate.
    pub fn sensitivity(&self, offsets: Offsets) -> Result<Sensitivity<'_>, InputError> {
        let setting = self.setting(offsets);
        let sensitivity = Sensitivity::new(self.controller()?, &self.machine, &self.offsets, &setting)?;
        Ok(sensitivity.with_history(self.history().as_ref(), &self.start))
    }
}
