//! Payload, acceleration and speed that a robot has everywhere in a box of positions.
//!
//! At one pose the available wrench set W (see [`wrench_set`](crate::wrench_set)) answers the first two. Each of its
//! half-spaces n · w ≤ d leaves the load w₀ of the robot the room d − n · w₀; a quantity λ asks of it λ s(n), with s(n)
//! the largest n · w of what the unit of the quantity adds: the weight of 1 kg, or −\[m a; R c × m a\] for every
//! acceleration |a| ≤ 1 (Newton at rest: no turning, so no moment about the center of mass). So λ is the least
//! (d − n · w₀)/s(n) over all half-spaces with s(n) > 0, as the linear programme in λ and the tensions has it. The speed
//! is the least limit of a cable over the norm of its row of the length Jacobian by translations, in any direction.
//!
//! Over a box the least value is sought by branch and bound. A cell with the centre c has these bounds: for a corner v of
//! W(c) with the tensions f, W(r) contains −Aᵀ(r) f. A direction n in the normal cone of v is a sum of the normals nₖ of its
//! facets with factors of zero or more, so that W(r) contains w₀ + λ K if for every facet k
//!
//! ```text
//! nₖ · w₀ + λ s(nₖ) ≤ dₖ − sup nₖ · (Aᵀ(r) − Aᵀ(c)) f
//! ```
//!
//! with the supremum over positions r of the cell and tensions f of the facet: those of its cables that stand at a limit, and
//! any within limits of the others. Directions of cables are replaced by their first-order change with a bound of the second
//! derivative (`turning`), and what changes all columns alike is taken out before (`bound`). So the lower bound holds for
//! every position of the box, to rounding, and comes nearer to the value with the square of the size of a cell.

mod bound;
mod demand;
mod limit;
mod pose;
mod search;
#[cfg(test)]
mod tests;
mod turning;

use nalgebra::{UnitQuaternion, Vector3};

use crate::criterion::length_scale_of;
use crate::wrench_set::{CABLE_LIMIT, WrenchSetError, row_lengths};
use crate::{Point, WorkspaceError};
use cdpr_model::cable::winch::SpeedLimit;
use cdpr_model::geometry::Pose;
use cdpr_model::model::Model;
use cdpr_model::statics::Load;
use cdpr_model::tension::{InputError, Limits};

use demand::Demand;
pub use limit::{Limit, LimitedBy};
use pose::Place;
pub use search::{Found, NotHeld, Settings, Solution, Status};

/// Name in errors.
const NAME: &str = "capability";

/// Quantity that a robot can do so much of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Quantity {
    /// Mass that is added to the robot's own load (kg).
    Payload,
    /// Acceleration of the platform from rest in any direction (m/s²).
    Acceleration,
    /// Acceleration in both senses of the axis with this index (m/s²).
    AxisAcceleration(usize),
    /// Speed of the platform in any direction, without turning (m/s).
    Speed,
}

/// Quantity that the robot's file does not answer, and why.
#[derive(Clone, Debug, PartialEq)]
pub struct Absent {
    /// The quantity.
    pub quantity: Quantity,
    /// What is missing, in words.
    pub reason: String,
}

/// The platform, its load and limits, and what is asked of them.
#[derive(Clone, Debug)]
pub struct Capability<'a> {
    model: &'a Model,
    load: Load,
    limits: Limits,
    rotation: UnitQuaternion<f64>,
    row_lengths: Vec<f64>,
    demands: Vec<Demand>,
    speeds: Vec<Option<SpeedLimit>>,
    absent: Vec<Absent>,
}

impl<'a> Capability<'a> {
    /// The question for a model of straight cables whose platform keeps one orientation.
    ///
    /// The payload is added at the platform origin, or anywhere within ± `payload_place` (m) of it along each axis of the
    /// platform.
    pub fn new(
        model: &'a Model,
        load: &Load,
        limits: &Limits,
        rotation: UnitQuaternion<f64>,
        payload_place: f64,
    ) -> Result<Self, WorkspaceError> {
        let (expected, found) = (model.cable_count(), limits.cable_count());
        if expected != found {
            return Err(InputError::LimitCount { expected, found }.into());
        }
        if expected > CABLE_LIMIT {
            return Err(WrenchSetError::TooManyCables { found: expected }.into());
        }
        if !(payload_place >= 0.0 && payload_place.is_finite()) {
            let (setting, wanted) = ("place of the payload", "it is a finite distance of 0 or more (m)");
            return Err(WorkspaceError::Capability { setting, value: payload_place, wanted });
        }
        let row_lengths = row_lengths(model, length_scale_of(model, NAME)?);
        let cables = &model.robot().cables;
        let speeds = cables.iter().enumerate().map(|(cable, data)| {
            SpeedLimit::of(data).map_err(|error| WorkspaceError::Drum { cable: cable + 1, error })
        });
        let speeds = speeds.collect::<Result<_, _>>()?;
        let (load, limits) = (*load, limits.clone());
        let mut asked =
            Self { model, load, limits, rotation, row_lengths, demands: Vec::new(), speeds, absent: Vec::new() };
        let all = demand::all(model, rotation, payload_place).into_iter().chain([asked.speed_demand()]);
        for demand in all {
            match demand {
                Ok(demand) => asked.demands.push(demand),
                Err(absent) => asked.absent.push(absent),
            }
        }
        Ok(asked)
    }

    fn speed_demand(&self) -> Result<Demand, Absent> {
        match self.speeds.iter().any(Option::is_some) {
            true => Ok(Demand::Speed),
            false => Err(Absent {
                quantity: Quantity::Speed,
                reason: "no cable of the robot file states speed_max_m_s, and no drive motor_speed_max_rad_per_s"
                    .to_owned(),
            }),
        }
    }

    /// Quantities that are answered, in the order of all values.
    pub fn quantities(&self) -> Vec<Quantity> {
        self.demands.iter().map(Demand::quantity).collect()
    }

    /// Quantities that the robot's file does not answer.
    pub fn absent(&self) -> &[Absent] {
        &self.absent
    }

    /// Cables (from 0) without a limit of their speed, where others have one.
    pub fn without_speed_limit(&self) -> Vec<usize> {
        match self.speeds.iter().any(Option::is_some) {
            true => (0..self.speeds.len()).filter(|&cable| self.speeds[cable].is_none()).collect(),
            false => Vec::new(),
        }
    }

    /// Value of each quantity at a point (see [`Capability::quantities`]); `None` if the robot does not hold its own
    /// load there.
    pub fn values(&self, point: &Point) -> Option<Vec<f64>> {
        self.judge(&Place::pose(*point)).ok().map(|judged| judged.values)
    }

    /// Pose at a point.
    pub fn pose(&self, point: &Point) -> Pose {
        Pose { position: self.position(point), rotation: self.rotation }
    }

    fn position(&self, point: &Point) -> Vector3<f64> {
        self.model.axes().iter().zip(point).map(|(axis, along)| axis * *along).sum()
    }
}
