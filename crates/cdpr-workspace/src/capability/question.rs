//! The question: platform, load, limits, and the quantities that are asked for.

use nalgebra::{UnitQuaternion, Vector3};

use super::demand::{self, Absent, Demand, Quantity};
use super::face::Rows;
use crate::criterion::{check_limits, length_scale_of};
use crate::wrench_set::row_lengths;
use crate::{Point, WorkspaceError};
use cdpr_model::cable::winch::SpeedLimit;
use cdpr_model::geometry::{Pose, Wrench};
use cdpr_model::model::Model;
use cdpr_model::statics::Load;
use cdpr_model::tension::Limits;

/// Name in errors.
const NAME: &str = "capability";

/// Question of what a platform can do, with its load and limits.
#[derive(Clone, Debug)]
pub struct Capability<'a> {
    pub(super) model: &'a Model,
    pub(super) load: Load,
    pub(super) limits: Limits,
    rotation: UnitQuaternion<f64>,
    pub(super) row_lengths: Vec<f64>,
    pub(super) demands: Vec<Demand>,
    pub(super) speeds: Vec<Option<SpeedLimit>>,
    pub(super) absent: Vec<Absent>,
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
        check_limits(model, limits)?;
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

    /// Pose at a point.
    pub fn pose(&self, point: &Point) -> Pose {
        Pose { position: self.position(point), rotation: self.rotation }
    }

    pub(super) fn position(&self, point: &Point) -> Vector3<f64> {
        self.model.axes().iter().zip(point).map(|(axis, along)| axis * *along).sum()
    }

    /// Length by which moments are divided (m); 1 m for a robot without moments.
    pub(super) fn least_length(&self) -> f64 {
        self.row_lengths.iter().copied().last().unwrap_or(1.0)
    }

    /// A wrench in the rows of the structure matrix, those of moments divided by their lengths.
    pub(super) fn scaled(&self, wrench: &Wrench) -> Rows {
        let mut rows = Rows::zeros();
        for ((row, twist), length) in rows.iter_mut().zip(self.model.twist_basis()).zip(&self.row_lengths) {
            *row = twist.dot(wrench) / length;
        }
        rows
    }

    /// The normal in world axes whose product with a wrench is that of these rows with the scaled wrench.
    pub(super) fn normal(&self, rows: &Rows) -> Wrench {
        let parts = rows.iter().zip(self.model.twist_basis()).zip(&self.row_lengths);
        parts.map(|((row, twist), length)| twist * (row / length)).sum()
    }
}
