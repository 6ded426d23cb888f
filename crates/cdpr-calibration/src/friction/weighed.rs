//! Numbers of a fit with their standard deviations.

use super::law::{Hung, Law};
use super::least_squares::Fit;
use super::plateaus::Plateau;
use super::solution::Figure;
use crate::autocorrelation::correlation_time;

/// Rows that are means already, from which on their order is asked whether their errors hang together.
const CORRELATED: usize = 30;

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
    pub(super) fn parameter(&self, place: usize) -> Option<Figure> {
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
