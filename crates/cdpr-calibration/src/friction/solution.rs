//! What records tell about a winch.

use super::ROUND_OFF;
use super::grouping::Grouping;
use super::law::{Hung, Law};
use super::least_squares::Fit;
use super::plateaus::{LeftOut, Plateau, Plateaus};
use super::reasons::{self, Undetermined};
use super::stribeck;
use crate::autocorrelation::correlation_time;
use crate::student::t_95;

/// Rows that are means already, from which on their order is asked whether their errors hang together.
const CORRELATED: usize = 30;

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
        half.is_finite().then(|| [figure.value - half, figure.value + half])
    }

    /// True where the answer to the question for load and friction is there.
    pub fn is_determined(&self) -> bool {
        self.coulomb.is_some() && self.loads.iter().any(|load| load.torque.is_some())
    }
}

/// A fit with the variance of its errors.
pub(super) struct Weighed<'a> {
    pub(super) fit: &'a Fit,
    /// Variance of a plateau's torque (N²·m²); `None` where nothing tells it.
    variance: Option<f64>,
    pub(super) freedom: usize,
}

impl<'a> Weighed<'a> {
    pub(super) fn of(fit: &'a Fit, plateaus: &[&Plateau]) -> Self {
        let freedom = plateaus.len().saturating_sub(fit.rank);
        let between = (freedom > 0).then(|| fit.squares() / freedom as f64 * together(fit, plateaus));
        let errors: Vec<f64> = plateaus.iter().filter_map(|plateau| plateau.standard_error).collect();
        let is_known = !errors.is_empty() && errors.len() == plateaus.len();
        let within = is_known.then(|| errors.iter().map(|error| error * error).sum::<f64>() / errors.len() as f64);
        // means of four blocks or more
        let by_blocks = 3 * errors.len();
        let (variance, freedom) = match (between, within) {
            (Some(between), Some(within)) if within > between => (Some(within), freedom.max(by_blocks)),
            (None, Some(within)) => (Some(within), by_blocks),
            (between, _) => (between, freedom),
        };
        Self { fit, variance, freedom }
    }

    /// A number with its derivatives by the parameters; `None` if the data leave it open.
    pub(super) fn figure(&self, value: f64, gradient: &[f64]) -> Option<Figure> {
        let variance = self.fit.variance(gradient)?;
        Some(Figure { value, sigma: self.variance.map(|own| (own * variance).sqrt()) })
    }

    /// A parameter.
    fn parameter(&self, place: usize) -> Option<Figure> {
        let mut gradient = vec![0.0; self.fit.law.count()];
        gradient[place] = 1.0;
        self.figure(self.fit.parameters[place], &gradient)
    }

    /// Torque of a load.
    pub(super) fn load(&self, hung: Hung) -> Option<Figure> {
        let mut gradient = vec![0.0; self.fit.law.count()];
        let value = self.fit.law.load(hung, &self.fit.parameters, &mut gradient);
        self.figure(value, &gradient)
    }

    /// Coulomb friction under a load, and its derivatives.
    pub(super) fn coulomb(&self, hung: Hung) -> (f64, Vec<f64>) {
        let mut gradient = vec![0.0; self.fit.law.count()];
        let law = Law { stribeck: false, by_direction: false, ..self.fit.law };
        let value = law.friction(hung, 0.0, &self.fit.parameters, &mut gradient);
        (value, gradient)
    }

    /// Friction under a load at a speed.
    pub(super) fn friction(&self, hung: Hung, speed: f64) -> Option<Figure> {
        let mut gradient = vec![0.0; self.fit.law.count()];
        let value = self.fit.law.friction(hung, speed, &self.fit.parameters, &mut gradient);
        self.figure(value, &gradient)
    }
}

/// By how much rows that hang together tell less than as many that do not.
fn together(fit: &Fit, plateaus: &[&Plateau]) -> f64 {
    let are_means = plateaus.iter().all(|plateau| plateau.samples == 1);
    if are_means && plateaus.len() >= CORRELATED { correlation_time(&fit.residuals) } else { 1.0 }
}

/// What was fitted: the plateaus, and the law without and with the Stribeck part.
pub(super) struct Fitted<'a> {
    /// Numbers of the plateaus among the sliding ones.
    pub(super) kept: &'a [usize],
    pub(super) base: &'a Fit,
    pub(super) judged: &'a stribeck::Judged,
}

/// The solution of what was fitted.
pub(super) fn assemble(grouping: &Grouping, all: &Plateaus, fitted: &Fitted<'_>) -> Solution {
    let Fitted { kept, base, judged } = *fitted;
    let plateaus: Vec<&Plateau> = kept.iter().map(|&row| &all.sliding[row]).collect();
    let fit = judged.fit.as_ref().unwrap_or(base);
    let law = fit.law;
    let weighed = Weighed::of(fit, &plateaus);
    let mut gradient = vec![0.0; law.count()];
    let is_kept = |row: &usize| kept.contains(row);
    let beside = all.sliding.iter().enumerate().map(|(row, plateau)| Judged {
        residual: plateau.torque - law.torque(plateau, &fit.parameters, &mut gradient),
        is_outlier: !is_kept(&row),
        plateau: plateau.clone(),
    });
    let beside: Vec<Judged> = beside.collect();
    let loads: Vec<HangingLoad> =
        (0..grouping.loads.len()).map(|group| load(&weighed, grouping, &plateaus, group)).collect();
    let counts = |is: fn(&Plateau) -> bool| plateaus.iter().filter(|plateau| is(plateau)).count();
    let directions = [counts(|own| own.speed > 0.0), counts(|own| own.speed < 0.0)];
    let sizes = || plateaus.iter().map(|plateau| plateau.speed.abs());
    let speeds = (!plateaus.is_empty()).then(|| [sizes().fold(f64::INFINITY, f64::min), sizes().fold(0.0, f64::max)]);
    let excess = law.excess().filter(|_| judged.is_told);
    let standing = excess.and_then(|place| {
        let mut gradient = vec![0.0; law.count()];
        (gradient[law.coulomb()], gradient[place]) = (1.0, 1.0);
        weighed.figure(fit.parameters[law.coulomb()] + fit.parameters[place], &gradient)
    });
    let stribeck_speed = excess.and_then(|place| {
        let logarithm = weighed.parameter(place + 1)?;
        let value = logarithm.value.exp();
        Some(Figure { value, sigma: logarithm.sigma.map(|sigma| sigma * value) })
    });
    let coulomb = weighed.parameter(law.coulomb()).or_else(|| reasons::mean_coulomb(&weighed, grouping, &plateaus));
    let squares: f64 = fit.squares();
    let mut solution = Solution {
        load_scale: law.is_scaled.then(|| weighed.parameter(0)).flatten(),
        load_offset: law.is_scaled.then(|| weighed.parameter(1)).flatten(),
        coulomb,
        coulomb_by_load: law.growth().and_then(|place| weighed.parameter(place)),
        viscous: weighed.parameter(law.viscous()),
        standing,
        stribeck_speed,
        viscous_by_direction: by_direction(fit, &plateaus),
        break_away: break_away(&loads, &all.resting),
        rms: (squares / plateaus.len().max(1) as f64).sqrt(),
        freedom: weighed.freedom,
        speeds,
        directions,
        plateaus: beside,
        left_out: all.left_out,
        stribeck_gain: judged.gain,
        undetermined: Vec::new(),
        loads,
    };
    solution.undetermined =
        reasons::Asked { solution: &solution, weighed: &weighed, grouping, plateaus: &plateaus, judged }.reasons();
    solution
}

/// One load by the fit.
fn load(weighed: &Weighed<'_>, grouping: &Grouping, plateaus: &[&Plateau], group: usize) -> HangingLoad {
    let hanging = grouping.loads[group];
    let hung = grouping.hung(group);
    let count = plateaus.iter().filter(|plateau| plateau.group == group).count();
    let torque = weighed.load(hung).filter(|_| count > 0);
    let (value, gradient) = weighed.coulomb(hung);
    let if_exact = hanging.torque.filter(|_| count > 0).and_then(|given| {
        let mut by_load = vec![0.0; weighed.fit.law.count()];
        let away = weighed.fit.law.load(hung, &weighed.fit.parameters, &mut by_load) - given;
        let along = |sign: f64| {
            let both: Vec<f64> = gradient.iter().zip(&by_load).map(|(own, load)| own + sign * load).collect();
            weighed.figure(value + sign * away, &both)
        };
        Some([along(1.0)?, along(-1.0)?])
    });
    HangingLoad {
        record: hanging.record,
        given: hanging.torque,
        mass: hanging.mass,
        torque,
        coulomb: weighed.figure(value, &gradient).filter(|_| count > 0),
        plateaus: count,
        if_exact,
    }
}

/// Friction by speed of each direction, by a law that lets them differ.
fn by_direction(fit: &Fit, plateaus: &[&Plateau]) -> Option<ByDirection> {
    let law = Law { by_direction: true, ..fit.law };
    let start = fit.parameters.iter().copied().chain([0.0]).collect();
    let own = Fit::of(law, plateaus, start);
    let weighed = Weighed::of(&own, plateaus);
    let place = law.difference()?;
    let (mean, half) = (own.parameters[law.viscous()], own.parameters[place]);
    let along = |sign: f64, by_mean: f64| {
        let mut gradient = vec![0.0; law.count()];
        (gradient[law.viscous()], gradient[place]) = (by_mean, sign);
        weighed.figure(by_mean * mean + sign * half, &gradient)
    };
    Some(ByDirection { lifting: along(1.0, 1.0)?, lowering: along(-1.0, 1.0)?, difference: along(2.0, 0.0)? })
}

/// Largest torque beyond the load at rest.
fn break_away(loads: &[HangingLoad], resting: &[Plateau]) -> Option<f64> {
    let beyond = resting.iter().filter_map(|plateau| {
        let load = loads[plateau.group].torque?;
        Some((plateau.torque - load.value).abs())
    });
    beyond.filter(|torque| *torque > ROUND_OFF).max_by(f64::total_cmp)
}
