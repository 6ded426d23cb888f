//! Options that say what a fit makes small.

use cdpr_calibration::{Minimize, Objective, fit};
use cdpr_model::reading::Keyword;
use clap::Args;

use crate::keyword::keyword;
use crate::numbers::positive_length;

/// Residuals and cost of a fit.
#[derive(Clone, Debug, Args)]
pub(crate) struct ObjectiveArguments {
    /// Residuals that are made small: of the lengths at the measured poses, of the poses that the model predicts from the recorded lengths (of
    /// elastic models with the tensions), or of both in their stated accuracies, the poses unknown (rigid models).
    #[arg(long, value_name = "OBJECTIVE", default_value = Objective::default().name(), value_parser = keyword::<Objective>())]
    objective: Objective,

    /// Cost of all samples: the sum of squares, the mean of the norms, or the largest norm.
    #[arg(long, value_name = "COST", default_value = Minimize::default().name(), value_parser = keyword::<Minimize>())]
    minimize: Minimize,

    /// Length by which rotations count beside positions with `--objective pose` (m). Default: the ratio of the stated accuracies of position and
    /// rotation, else the root mean square of the platform anchors' distances.
    #[arg(long, value_name = "METRES", value_parser = positive_length)]
    rotation_length: Option<f64>,
}

impl ObjectiveArguments {
    /// Settings of a fit with these residuals and this cost.
    pub(crate) fn of(&self, settings: fit::Settings) -> fit::Settings {
        let Self { objective, minimize, rotation_length } = *self;
        fit::Settings { objective, minimize, rotation_length, ..settings }
    }

    /// The options that are not at their default, with their values as they are written.
    pub(crate) fn written(&self) -> [(&'static str, String); 3] {
        let unless_default = |name: &str, default: &str| if name == default { String::new() } else { name.to_owned() };
        [
            ("objective", unless_default(self.objective.name(), Objective::default().name())),
            ("minimize", unless_default(self.minimize.name(), Minimize::default().name())),
            ("rotation-length", self.rotation_length.map(|length| length.to_string()).unwrap_or_default()),
        ]
    }
}
