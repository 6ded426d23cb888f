//! Remarks about the optimum of an elastic model.

use super::BalanceResidual;
use crate::fit::answer::Estimate;
use crate::fit::warnings;
use crate::identifiability::Analysis;
use crate::residual::Remarks;
use cdpr_model::equilibrium::elastostatics;
use cdpr_model::model::Model;
use cdpr_model::robot::ParameterKind;
use cdpr_model::statics::Load;

/// Prior and data contradict each other when the parameters moved this many times farther than the prior lets expect.
const CONFLICT: f64 = 2.0;

impl BalanceResidual<'_> {
    /// Remarks about noise, priors and stiffness; stiffness that the data leave open is a weak direction of the analysis.
    pub(super) fn all_remarks(
        &self,
        calibrated: &Model,
        estimates: &[Estimate],
        noise: f64,
        analysis: &mut Analysis,
    ) -> Remarks {
        analysis.unknown_stiffness = unknown_stiffness(estimates, analysis);
        analysis.weak_directions.extend(analysis.unknown_stiffness.clone());
        let of_noise = if self.has_row_weights() { Vec::new() } else { self.noise_warnings(noise, estimates.len()) };
        let objection = without_forward_problem(calibrated, estimates);
        Remarks { of_noise, of_priors: prior_conflicts(estimates), objection }
    }

    /// Warnings about accuracies, stated or assumed.
    fn noise_warnings(&self, noise_factor: f64, parameter_count: usize) -> Vec<String> {
        if self.is_stated {
            let assumed = warnings::of_assumptions(&self.samples.sigmas, self.mean_tension());
            return warnings::of_noise(noise_factor, parameter_count).into_iter().chain(assumed).collect();
        }
        let told = match noise_factor.is_finite() {
            true => format!("multiplied by {noise_factor:.2} to agree with the residuals"),
            false => "taken as they are, since there are as many parameters as rows".to_owned(),
        };
        let words = format!(
            "no sensor accuracy is known (a sidecar file DATA.meta.toml or --sigma tells it): 1 mm for lengths and 1 % of the mean for \
         tensions are assumed and {told}"
        );
        (parameter_count > 0).then_some(words).into_iter().collect()
    }
}

/// The reason where a fit has made more cables rigid than there are degrees of freedom, with its likely cause.
fn without_forward_problem(calibrated: &Model, estimates: &[Estimate]) -> Option<String> {
    let load = Load::of(calibrated.robot()).ok()?;
    let refusal = elastostatics::Solver::new(calibrated, &load, &elastostatics::Settings::default()).err()?;
    let of = |kind: ParameterKind| estimates.iter().filter(move |estimate| estimate.parameter.kind == kind);
    let rigid: Vec<String> =
        of(ParameterKind::Compliance).filter(|e| e.at_bound).map(|e| (e.parameter.cable + 1).to_string()).collect();
    if rigid.is_empty() {
        return None;
    }
    let cause = match of(ParameterKind::LengthOffset).next() {
        None => {
            "the recorded lengths leave no room for stretch, which offsets of the winches in the record would explain: free              `length-offset` too"
        }
        Some(_) => {
            "the recorded lengths do not follow the recorded tensions: check their units, signs and order of the cables"
        }
    };
    Some(format!(
        "the fit drives the compliance of cables {} to 0, so that the calibrated model predicts no poses ({refusal}). Likely cause: \
         {cause}",
        rigid.join(", ")
    ))
}

/// Cables whose compliance has a 95 % interval wider than ± a quarter of it: too little for a controller that relies on it.
fn unknown_stiffness(estimates: &[Estimate], analysis: &Analysis) -> Option<String> {
    let mut cables = Vec::new();
    for Estimate { parameter, sigma, value, .. } in estimates {
        if parameter.kind == ParameterKind::Compliance
            && sigma.is_none_or(|sigma| analysis.quantile_95 * sigma > 0.25 * value)
        {
            let deviation = sigma.map_or("not determined at all".to_owned(), |sigma| format!("± {:.0}", 1e9 * sigma));
            cables.push(format!("{} (compliance {:.0} {deviation} 1/GN)", parameter.cable + 1, 1e9 * value));
        }
    }
    (!cables.is_empty()).then(|| {
        format!(
            "the stiffness of cables {} is unknown, not even to ± 25 %: record tension tests (shorten single cables)",
            cables.join(", ")
        )
    })
}

/// Kinds whose parameters moved farther than their prior lets expect: prior and data contradict each other.
///
/// Under the prior, Σ (change/σ_prior)² is in the mean the number of directions that the data determine, Σ (1 − σ²/σ_prior²).
fn prior_conflicts(estimates: &[Estimate]) -> Vec<String> {
    let mut found = Vec::new();
    for kind in ParameterKind::IDENTIFIED {
        let with_prior = || {
            let of_kind = estimates.iter().filter(move |e| e.parameter.kind == kind);
            of_kind.filter_map(|e| Some((e.change, e.sigma.unwrap_or(f64::INFINITY), e.prior_sigma?)))
        };
        let squares: f64 = with_prior().map(|(change, _, prior)| (change / prior).powi(2)).sum();
        let expected: f64 = with_prior().map(|(_, sigma, prior)| (1.0 - (sigma / prior).powi(2)).max(0.0)).sum();
        let ratio = (squares / expected).sqrt();
        if expected > 0.5 && ratio > CONFLICT {
            let count = with_prior().count();
            let rms = (with_prior().map(|(change, _, _)| change * change).sum::<f64>() / count as f64).sqrt();
            let prior = with_prior().next().map_or(f64::NAN, |(_, _, prior)| prior);
            let unit = kind.unit();
            found.push(format!(
                "prior conflict: the {kind} parameters moved by {rms:.3} {unit} rms against a prior of {prior:.3} {unit}, {ratio:.1} \
                 times farther than it lets expect; the data contradict the prior, so intervals of all parameters are too narrow: \
                 widen the prior or mend the start values"
            ));
        }
    }
    found
}
