//! Derivatives at commanded poses.

use super::memories::remembers;
use super::{PoseSensitivity, Sensitivity, remembering};
use cdpr_model::control::CommandedPose;
use cdpr_model::control::InputError;
use cdpr_model::control::OperationError;

impl Sensitivity<'_> {
    /// The derivatives at poses that are commanded in this order.
    ///
    /// For machines with hysteresis they are differences with an estimate of their error where the path is not smooth
    /// ([`Differentiation`](super::Differentiation)).
    pub fn along(&mut self, commands: &[CommandedPose]) -> Result<Vec<PoseSensitivity>, InputError> {
        match remembers(self.machine) {
            true => remembering::along(self, commands),
            false => commands.iter().map(|command| self.at(command)).collect(),
        }
    }

    /// The derivatives at a commanded pose; for machines with hysteresis, as the first pose of its path.
    pub fn at(&mut self, command: &CommandedPose) -> Result<PoseSensitivity, InputError> {
        if remembers(self.machine) {
            let mut alone = remembering::along(self, std::slice::from_ref(command))?;
            return alone.pop().ok_or(InputError::NoPoses);
        }
        let outcome = self.operation.answer(command);
        match outcome.at_rest().and_then(|()| self.derivatives(command, &outcome)) {
            Err(OperationError::Input(error)) => Err(error),
            derivatives => Ok(PoseSensitivity { outcome, derivatives }),
        }
    }
}
