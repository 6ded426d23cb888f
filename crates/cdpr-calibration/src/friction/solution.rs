//! Friction and loads that records tell of a winch.

use super::plateaus::{LeftOut, Plateau};
use super::quantity::Undetermined;
use crate::student::t_95;

/// A number with its standard deviation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Figure {
    /// The number.
    pub value: f64,
    /// Its standard deviation; `None` where no row is left to tell errors by.
    pub sigma: Option<f64>,
}

/// One load that hung from the winch.
#[derive(Clone, Debug, PartialEq)]
pub struct HangingLoad {
    /// First record with it, from 0.
    pub record: usize,
    /// Its torque as the records give it (N·m).
    pub given: Option<f64>,
    /// Its number in a column of masses (kg).
    pub mass: Option<f64>,
    /// Its torque by the fit (N·m).
    pub torque: Option<Figure>,
    /// Coulomb friction under it (N·m).
    pub coulomb: Option<Figure>,
    /// Plateaus with it.
    pub plateaus: usize,
    /// Coulomb friction while lifting and while lowering (N·m), if the given torque is exact; a fitted one takes their difference.
    pub if_exact: Option<[Figure; 2]>,
}

/// Friction per speed while lifting and while lowering (N·m·s/rad).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ByDirection {
    /// While lifting.
    pub lifting: Figure,
    /// While lowering.
    pub lowering: Figure,
    /// Their difference.
    pub difference: Figure,
}

/// A plateau beside the fit.
#[derive(Clone, Debug, PartialEq)]
pub struct Judged {
    /// The plateau.
    pub plateau: Plateau,
    /// Recorded minus fitted torque (N·m).
    pub residual: f64,
    /// True for a plateau that was left out, since it is none of the others.
    pub is_outlier: bool,
}

/// Friction and loads of a winch, with what the records leave open.
#[derive(Clone, Debug, PartialEq)]
pub struct Solution {
    /// The loads: ascending where their torques are given, in the order of the records where not.
    pub loads: Vec<HangingLoad>,
    /// a: fitted torque of loads per given torque.
    pub load_scale: Option<Figure>,
    /// b: fitted torque without load (N·m).
    pub load_offset: Option<Figure>,
    /// Coulomb friction (N·m): without load where friction grows with the load; see [`Solution::undetermined`] where it cannot be told.
    pub coulomb: Option<Figure>,
    /// Growth of Coulomb friction per torque of the load.
    pub coulomb_by_load: Option<Figure>,
    /// Friction per speed (N·m·s/rad).
    pub viscous: Option<Figure>,
    /// Standing friction (N·m), of the law's Stribeck part.
    pub standing: Option<Figure>,
    /// Stribeck speed (rad/s).
    pub stribeck_speed: Option<Figure>,
    /// Friction by speed of each direction.
    pub viscous_by_direction: Option<ByDirection>,
    /// Torque by which rows at rest were held beyond the load (N·m): standing friction is no less.
    pub break_away: Option<f64>,
    /// Root of the mean square of the residuals of plateaus (N·m).
    pub rms: f64,
    /// Degrees of freedom of 95 % intervals: plateaus beyond the numbers that were fitted, or blocks of samples where these tell the errors.
    pub freedom: usize,
    /// Lowest and highest speed of the plateaus (rad/s).
    pub speeds: Option<[f64; 2]>,
    /// Plateaus that lift, and that lower.
    pub directions: [usize; 2],
    /// Sliding plateaus, in the order of the records.
    pub plateaus: Vec<Judged>,
    /// Rows that were left out.
    pub left_out: LeftOut,
    /// Gain of Akaike's corrected criterion by the Stribeck part; `None` where too few plateaus ask for it.
    pub stribeck_gain: Option<f64>,
    /// Quantities that cannot be told, with the reason.
    pub undetermined: Vec<Undetermined>,
}

impl Solution {
    /// The 95 % interval of a number of the solution, by Student's t; `None` without a standard deviation.
    pub fn interval(&self, figure: &Figure) -> Option<[f64; 2]> {
        let half = t_95(self.freedom) * figure.sigma?;
        half.is_finite().then_some([figure.value - half, figure.value + half])
    }

    /// True where the answer to the question for load and friction is there.
    pub fn is_determined(&self) -> bool {
        self.coulomb.is_some() && self.loads.iter().any(|load| load.torque.is_some())
    }
}
