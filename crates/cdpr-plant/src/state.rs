//! State of a machine in time: pose, motion, cables and winches.

use nalgebra::Vector3;

use super::cable_motion::CableMotion;
use super::friction::Friction;
use super::momentum::{Inertia, Momentum};
use super::plant::Plant;
use super::pulls::Pulls;
use cdpr_model::geometry::{Pose, Twist, Wrench};

/// State of a machine, owned by the caller: a clone is a snapshot, and continuing from it gives the same bits again.
#[derive(Clone, Debug, PartialEq)]
pub struct PlantState {
    /// Time since the start (s).
    pub time: f64,
    /// Platform pose.
    pub pose: Pose,
    /// Momentum of the platform.
    pub(super) momentum: Momentum,
    /// Cables and winches.
    pub cables: Vec<CableMotion>,
    /// Inertia of the platform with all loads that it took up.
    pub inertia: Inertia,
    /// Loads taken up since the start.
    pub(super) added: Added,
    /// Current friction of the drums; empty for ideal winches.
    pub(super) friction: Vec<Friction>,
    /// Further wrench on the platform (world axes, moment about the platform origin; N, N·m).
    pub external: Wrench,
    /// Pulls of the cables at the pose.
    pub(super) pulls: Pulls,
}

/// Loads taken up by a platform: their mass (kg) and first moment (platform frame, kg·m).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Added {
    pub(super) mass: f64,
    pub(super) moment: Vector3<f64>,
}

impl PlantState {
    /// Twist \[v; ω\] of the platform (world axes, about the platform origin; m/s, rad/s).
    pub fn twist(&self) -> Twist {
        self.inertia.twist(&self.pose, &self.momentum)
    }

    /// Sets the twist of the platform.
    pub fn set_twist(&mut self, twist: &Twist) {
        self.momentum = self.inertia.momentum(&self.pose, twist);
    }

    /// Moves the platform; winches, memories and twist are unchanged.
    pub fn set_pose(&mut self, pose: Pose) {
        let twist = self.twist();
        self.pose = pose;
        self.set_twist(&twist);
        self.pulls.is_current = false;
    }

    /// Wrench of load, added loads and further wrench on the platform (world axes, about its origin; N, N·m).
    #[inline]
    pub(super) fn load(&self, plant: &Plant) -> Wrench {
        let mut wrench = plant.load.wrench(&self.pose) + self.external;
        if self.added.mass != 0.0 {
            let force = plant.gravity * self.added.mass;
            let moment = (self.pose.rotation * self.added.moment).cross(&plant.gravity);
            wrench += Wrench::new(force.x, force.y, force.z, moment.x, moment.y, moment.z);
        }
        wrench
    }

    /// True if every number is finite.
    pub(super) fn is_finite(&self) -> bool {
        let momentum = self.momentum.linear.iter().chain(self.momentum.angular.iter());
        self.pose.is_finite() && momentum.into_iter().all(|x| x.is_finite())
    }
}
