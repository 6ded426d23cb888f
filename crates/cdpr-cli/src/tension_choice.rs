//! The tensions that a question about a pose is asked with.

use cdpr_model::equilibrium::distribution::{self, DistributionError};
use cdpr_model::geometry::Pose;
use cdpr_model::model::Model;
use cdpr_model::tension::{Limits, LimitsError};

use crate::failure::Failure;
use crate::inputs::load_of;
use crate::numbers::NumberList;
use crate::statics_failure::{has_no_path, refused};

/// Tensions, or why there are none.
pub(crate) enum Chosen {
    /// One per cable (N).
    Tensions(Vec<f64>),
    /// The status and reason of a negative answer.
    None { status: &'static str, reason: String },
}

/// The tensions given, not judged against limits; otherwise those that balance the load (that of `--wrench`, or the
/// robot's) within the robot's limits and lie nearest to the middle of these.
pub(crate) fn tensions_of(
    model: &Model,
    pose: &Pose,
    wrench: Option<&NumberList>,
    given: Option<&NumberList>,
) -> Result<Chosen, Failure> {
    if let Some(numbers) = given {
        return Ok(Chosen::Tensions(numbers.0.clone()));
    }
    let limits = limits_of(model)?;
    let load = load_of(model.robot(), wrench)?;
    let found = match distribution::solve(model, pose, &load, &limits) {
        Ok(found) => found,
        Err(DistributionError::Statics(error)) if has_no_path(&error) => {
            return Ok(Chosen::None { status: "singular", reason: error.to_string() });
        }
        Err(DistributionError::Statics(error)) => return Err(refused("--pose", &error)),
        Err(error) => return Err(Failure::numerical(format!("no tensions for this load: {error}"))),
    };
    Ok(match found.reason {
        None => Chosen::Tensions(found.tensions),
        Some(reason) => Chosen::None {
            status: reason.status(),
            reason: format!("{}; --tensions gives others, whatever the limits", reason),
        },
    })
}

/// The file's limits; what it lacks is named, with the way round it.
fn limits_of(model: &Model) -> Result<Limits, Failure> {
    Limits::of(model.robot(), None, None).map_err(|error| match error {
        LimitsError::MissingKey { robot, cable, name, key, .. } => Failure::input(
            "limits::missing-key",
            format!("ROBOT: without --tensions they are chosen within limits, and cable {cable} (\"{name}\") of \"{robot}\" has no {key}"),
            "add the key to its [[cable]] table, or give --tensions",
        ),
        error => Failure::refused("ROBOT", &error),
    })
}
