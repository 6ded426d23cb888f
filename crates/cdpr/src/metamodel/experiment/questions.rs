//! Effects of deviations, and the best setting of the winches: the questions of an experiment that need no poses of its study.

use super::Experiment;
use crate::metamodel::initial_tension::Task;
use crate::metamodel::input_error::InputError;
use crate::metamodel::sensitivity::{Offsets, ParameterDeviation, Sensitivity, Setting, causes};
use crate::metamodel::winches::tensions_set;
use crate::tension::Limits;

impl Experiment {
    /// The tensions at which the winches were set (N); nothing where the study states offsets, or cables have none.
    pub fn initial_tensions(&self) -> Result<Option<Vec<f64>>, InputError> {
        let initial = &self.study.initial;
        match initial.offset.is_none() && initial.offset_m.is_none() {
            true => tensions_set(initial, self.set_with(), &self.machine, &self.start),
            false => Ok(None),
        }
    }

    /// The winches to be set anew, with the tensions that they have now; `limits` are what their tensions keep.
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

    /// How the winches were set, and what deviations do to it.
    pub(crate) fn setting(&self, offsets: Offsets) -> Setting<'_> {
        Setting { initial: &self.study.initial, pose: self.start, former: self.former.as_ref(), offsets }
    }

    /// Deviations of control model, machine and winches.
    pub fn causes(&self, offsets: Offsets) -> Vec<ParameterDeviation> {
        causes(&self.control, &self.machine, &self.setting(offsets))
    }

    /// How pose and tensions follow all that may deviate.
    pub(crate) fn sensitivity(&self, offsets: Offsets) -> Result<Sensitivity<'_>, InputError> {
        let setting = self.setting(offsets);
        let sensitivity = Sensitivity::new(self.controller()?, &self.machine, &self.offsets, &setting)?;
        Ok(sensitivity.with_history(self.history().as_ref(), &self.start))
    }
}
