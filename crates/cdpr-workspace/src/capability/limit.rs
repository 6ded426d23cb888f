//! Which limit of which cable fails first.

use nalgebra::Vector3;

use super::demand::{Demand, along};
use super::face::Face;
use super::question::Capability;
use crate::Point;

/// Kind of a limit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Limit {
    /// A cable's largest tension.
    TensionMax,
    /// A cable's least tension, above zero or where others pull.
    TensionMin,
    /// The load alone acts in this direction, since cables cannot push: gravity.
    Gravity,
    /// No tensions of zero or more act in this direction.
    NoWrenchClosure,
    /// The speed of a cable.
    CableSpeed,
    /// The speed of a cable's drive.
    DriveSpeed,
    /// The cable has no path.
    NoPath,
}

impl Limit {
    /// Name in answers, e.g. `tension-max`.
    pub fn name(self) -> &'static str {
        match self {
            Self::TensionMax => "tension-max",
            Self::TensionMin => "tension-min",
            Self::Gravity => "gravity",
            Self::NoWrenchClosure => "no-wrench-closure",
            Self::CableSpeed => "cable-speed",
            Self::DriveSpeed => "drive-speed",
            Self::NoPath => "no-path",
        }
    }
}

/// Limit that stands in the way of more.
#[derive(Clone, Debug, PartialEq)]
pub struct LimitedBy {
    /// Kind of the limit.
    pub limit: Limit,
    /// Cable (from 0) whose limit counts most, per newton of it; `None` where no cable acts.
    pub cable: Option<usize>,
    /// Cables (from 0) at their largest tension there.
    pub at_largest: Vec<usize>,
    /// Cables (from 0) at their least tension there.
    pub at_least: Vec<usize>,
    /// Direction of the acceleration that fails first (world, length 1); `None` for other quantities.
    pub direction: Option<Vector3<f64>>,
}

impl LimitedBy {
    /// The same limit of one cable, without tensions.
    pub(super) fn of_cable(limit: Limit, cable: usize) -> Self {
        Self { limit, cable: Some(cable), at_largest: Vec::new(), at_least: Vec::new(), direction: None }
    }
}

/// A pose at which the robot does not hold its own load.
#[derive(Clone, Debug, PartialEq)]
pub struct NotHeld {
    /// The point.
    pub at: Point,
    /// Force that lacks (N), moments divided by the platform radius; ∞ where a cable has no path.
    pub lacking: f64,
    /// Limit that fails.
    pub limited_by: LimitedBy,
    /// Why there is no path, in words.
    pub reason: Option<String>,
}

impl Capability<'_> {
    /// Limit that a half-space of a pose is; `demand` asks for more, the load itself if `None`.
    pub(super) fn limit_of(&self, face: &Face, point: &Point, demand: Option<&Demand>) -> LimitedBy {
        let pose = self.pose(point);
        // pull per newton of a cable along the normal
        let share = |cable: &usize| match self.model.path(*cable, &pose) {
            Ok((path, arm)) => along(&face.normal, &arm).dot(&Vector3::from(path.direction)).abs(),
            Err(_) => 0.0,
        };
        let cables = |bits: u64| (0..self.model.cable_count()).filter(|cable| bits & (1 << cable) != 0).collect();
        let (at_largest, at_least): (Vec<usize>, Vec<usize>) = (cables(face.at_largest), cables(face.at_least));
        let all = || at_largest.iter().chain(&at_least);
        let cable = all().copied().max_by(|a, b| share(a).total_cmp(&share(b)));
        let only_slack = at_largest.is_empty() && at_least.iter().all(|&cable| self.limits.minimum()[cable] == 0.0);
        let limit = match (only_slack, demand) {
            (true, None) => Limit::NoWrenchClosure,
            (true, Some(_)) if at_least.is_empty() => Limit::NoWrenchClosure,
            (true, Some(_)) => Limit::Gravity,
            (false, _) if cable.is_some_and(|cable| at_largest.contains(&cable)) => Limit::TensionMax,
            (false, _) => Limit::TensionMin,
        };
        let direction = demand.and_then(|demand| demand.direction(&face.normal));
        LimitedBy { limit, cable, at_largest, at_least, direction }
    }
}
