//! The solution of a fit.

use super::grouping::Grouping;
use super::law::{Law, ROUND_OFF};
use super::least_squares::Fit;
use super::plateaus::{Plateau, Plateaus};
use super::reasons;
use super::solution::{ByDirection, Figure, HangingLoad, Judged, Solution};
use super::stribeck;
use super::weighed::Weighed;

/// Fitted plateaus, and the law without and with the Stribeck part.
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
