//! Doubts about a fit that belong beside its name: parameters at a bound, weak directions.

use super::{Estimate, Fit, Status};
use crate::loss::Loss;
use crate::verdict::{Doubt, DoubtKind};

/// Parameters that a sentence names before it only counts the rest.
const NAMED: usize = 3;

impl Fit {
    /// Parameters that ended at a bound.
    pub fn at_bound(&self) -> impl Iterator<Item = &Estimate> {
        self.parameters.iter().filter(|estimate| estimate.at_bound)
    }

    /// Reasons to doubt the parameters, a sentence each with its numbers; empty where there is none.
    pub fn cautions(&self) -> Vec<String> {
        let count = self.outliers.len();
        let outliers = (count > 0).then(|| format!("{count} of its samples lie beyond 8 robust standard deviations"));
        outliers.into_iter().chain(self.doubts().into_iter().map(|doubt| doubt.finding.text)).collect()
    }

    /// Doubt about the outliers.
    pub(crate) fn outlier_doubt(&self) -> Option<Doubt> {
        let kind = match self.loss {
            Loss::Squared => DoubtKind::OutliersCounted,
            _ => DoubtKind::OutliersLeftOut,
        };
        let farthest = self.outliers.iter().max_by(|a, b| a.residual_m.total_cmp(&b.residual_m));
        let mut doubt = Doubt::new(kind, self.outlier_warning.as_ref()?);
        doubt.finding.line = farthest.and_then(|outlier| outlier.line);
        doubt.finding = doubt.finding.of_size(farthest.map_or(f64::NAN, |outlier| outlier.residual_m), "m");
        Some(doubt)
    }

    /// Doubts without those about outliers, of which a warning of their own says more.
    pub(crate) fn doubts(&self) -> Vec<Doubt> {
        let analysis = &self.analysis;
        let mut doubts = Vec::new();
        let mut doubt = |kind: DoubtKind, words: String| doubts.push(Doubt::new(kind, words));
        match self.status {
            Status::Converged => {}
            Status::NotConverged => doubt(DoubtKind::NotConverged, "the fit did not converge".to_owned()),
            Status::NotIdentifiable => {
                let words = format!("the data determine {} of {} parameters", analysis.rank, self.parameters.len());
                doubt(DoubtKind::NotIdentifiable, words);
            }
            Status::NotPredictive => doubt(DoubtKind::NotPredictive, self.reason.clone()),
        }
        self.starts.doubts(self.noise_factor).into_iter().for_each(|words| doubt(DoubtKind::Starts, words));
        at_bounds(&self.parameters).into_iter().for_each(|words| doubt(DoubtKind::Bound, words));
        if analysis.weak_direction_count > 0 {
            let words = format!(
                "{}: {}, condition {}",
                directions(analysis.weak_direction_count),
                spread(analysis.weak_deviation),
                condition(analysis.condition)
            );
            doubt(DoubtKind::WeakDirection, words);
        }
        analysis.unknown_stiffness.iter().for_each(|words| doubt(DoubtKind::UnknownStiffness, words.clone()));
        doubts
    }

    /// [`Fit::cautions`] in a few words, for a table; empty where there is none.
    pub fn caution_words(&self) -> String {
        let bounds = self.at_bound().count();
        let weak = self.analysis.weak_direction_count;
        let outliers = self.outliers.len();
        let words = [
            (outliers > 0).then(|| format!("{outliers} {}", if outliers == 1 { "outlier" } else { "outliers" })),
            (self.status == Status::NotConverged).then(|| "not converged".to_owned()),
            (self.status == Status::NotIdentifiable).then(|| "not identifiable".to_owned()),
            (self.status == Status::NotPredictive).then(|| "no forward problem".to_owned()),
            (bounds > 0).then(|| format!("{bounds} at a bound")),
            (weak > 0).then(|| format!("{}, {}", directions(weak), spread(self.analysis.weak_deviation))),
            self.analysis.unknown_stiffness.is_some().then(|| "stiffness unknown".to_owned()),
        ];
        words.into_iter().flatten().collect::<Vec<_>>().join("; ")
    }
}

/// Parameters at a bound in words; `None` without any.
pub(super) fn at_bounds(estimates: &[Estimate]) -> Option<String> {
    let all: Vec<&Estimate> = estimates.iter().filter(|estimate| estimate.at_bound).collect();
    let named: Vec<String> =
        all.iter().take(NAMED).map(|estimate| format!("{} = {}", estimate.name, short(estimate.value))).collect();
    let rest = match all.len().saturating_sub(NAMED) {
        0 => String::new(),
        more => format!(" and {more} more"),
    };
    match all.len() {
        0 => None,
        1 => Some(format!("1 parameter lies at a bound: {}", named.join(", "))),
        count => Some(format!("{count} parameters lie at a bound: {}{rest}", named.join(", "))),
    }
}

/// Shortest number within 1e-6 of a value.
fn short(value: f64) -> f64 {
    format!("{value:.6e}").parse().unwrap_or(value)
}

fn directions(count: usize) -> String {
    if count == 1 { "1 weak direction".to_owned() } else { format!("{count} weak directions") }
}

fn spread(deviation: f64) -> String {
    match deviation.is_finite() {
        true => format!("σ up to {deviation:.2} m"),
        false => "σ unbounded".to_owned(),
    }
}

fn condition(number: f64) -> String {
    match number {
        infinite if !infinite.is_finite() => "∞".to_owned(),
        large if large >= 1e5 => format!("{large:.2e}"),
        number => format!("{number:.0}"),
    }
}
