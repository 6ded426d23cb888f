//! Quantities of the recording that the data ask for: frames of tracker and marker, and the offset of the clocks.

use super::judge::{Problem, Richest};
use crate::candidate::Candidate;
use crate::clock::synchronised_within;
use crate::cross_validation::reported_part;
use crate::evaluation::evaluate_fitted;
use crate::fit::{Fit, Status};
use crate::likelihood::information;
use crate::loss::Loss;
use cdpr_model::model::{Model, RecordingParameter};

/// Reduction of AIC from which on a quantity is free: the data say much more than that it is not zero.
const MUCH: f64 = 50.0;
/// Share of the length residuals that it must explain besides.
const EXPLAINED: f64 = 0.1;
/// Noise, in units of stated accuracies, up to which nothing is left to explain.
const NOTHING_LEFT: f64 = 1.1;

/// Quantities that the data ask for.
pub(super) struct Needed {
    pub(super) freed: Vec<RecordingParameter>,
    /// The richest candidate with them free.
    pub(super) richest: Richest,
    /// The reason in words.
    pub(super) words: String,
}

/// A fit with its length residuals (rms, m).
struct Trial {
    freed: Vec<RecordingParameter>,
    fit: Fit,
    length_rms: f64,
}

/// The richest candidate with the part of the data that is reported.
struct Asked<'a> {
    problem: &'a Problem<'a>,
    candidate: &'a Candidate,
    model: Model,
    part: Vec<usize>,
    loss: Loss,
}

/// Quantities without which the richest candidate fits much worse, each on top of those before it; `None` if there are none.
pub(super) fn needed(problem: &Problem<'_>, richest: &Richest, candidates: &[Candidate]) -> Option<Needed> {
    let (candidate, fit) = (&candidates[richest.place], &richest.fit);
    let is_explained = fit.rows.as_ref()?.absolute && !(fit.noise_factor > NOTHING_LEFT);
    if problem.settings.fit.is_other_objective() || is_explained {
        return None;
    }
    let asked = Asked {
        problem,
        candidate,
        model: Model::new(problem.robot.clone(), candidate.composition).ok()?,
        part: reported_part(problem.samples, problem.folds),
        loss: fit.loss,
    };
    let mut open: Vec<RecordingParameter> =
        RecordingParameter::ALL.into_iter().filter(|quantity| asked.may_free(*quantity)).collect();
    let mut here = asked.rated(&[], fit.clone(), &asked.part)?;
    let (before, mut gained) = (here.length_rms, 0.0);
    while !open.is_empty() {
        let tried = open.iter().filter_map(|&quantity| asked.better(&here, quantity));
        let Some((trial, gain)) = tried.max_by(|a, b| a.1.total_cmp(&b.1)) else { break };
        (here, gained) = (trial, gained + gain);
        open.retain(|quantity| !here.freed.contains(quantity));
    }
    let Trial { freed, fit, length_rms } = here;
    let names: Vec<String> = freed.iter().map(|own| format!("`{}`", own.name())).collect();
    let words = format!(
        "recording: the lengths fit `{candidate}` to {:.1} mm rms with {} free and to {:.1} mm without (AIC lower by {gained:.0}): free in every \
         candidate, and the calibrated robot stays in the frame and on the clock of its own",
        1e3 * length_rms,
        names.join(" and "),
        1e3 * before
    );
    (!freed.is_empty()).then_some(Needed { freed, richest: Richest { place: richest.place, fit }, words })
}

impl Asked<'_> {
    /// Whether a quantity can be told by data and candidate, and nobody holds it.
    fn may_free(&self, quantity: RecordingParameter) -> bool {
        let Self { problem, candidate, .. } = self;
        let is_possible = match quantity {
            RecordingParameter::ClockOffset => problem.samples.time.is_some(),
            RecordingParameter::MarkerFrame => problem.robot.motion_pattern.has_rotation(),
            RecordingParameter::TrackerFrame => true,
        };
        let is_settled =
            candidate.free.names_recording(quantity) || problem.settings.fit.hold.names_recording(quantity);
        is_possible && !is_settled
    }

    /// The fit with one more quantity free, and by how much its AIC is less; `None` where it is not much better.
    fn better(&self, here: &Trial, quantity: RecordingParameter) -> Option<(Trial, f64)> {
        let freed: Vec<RecordingParameter> = here.freed.iter().copied().chain([quantity]).collect();
        let trial = self.trial(&freed, &self.part)?;
        // poses beyond the record at another time have no part in the fit: both are compared without them
        let again = match (trial.fit.clock_offset, quantity) {
            (Some(clock), RecordingParameter::ClockOffset) => {
                let (_, kept) = synchronised_within(&self.problem.samples.subset(&self.part), clock.seconds);
                let part: Vec<usize> = kept.into_iter().map(|place| self.part[place]).collect();
                Some(self.trial(&here.freed, &part)?)
            }
            _ => None,
        };
        let before = again.as_ref().unwrap_or(here);
        let samples = |trial: &Trial| trial.fit.rows.as_ref().map(|rows| rows.series.first().map_or(0, Vec::len));
        if samples(before) != samples(&trial) {
            return None;
        }
        let both = information(self.problem.robot, &[&before.fit, &trial.fit], self.loss);
        let gain = both[0]?.aic - both[1]?.aic;
        let is_much = gain > MUCH && trial.length_rms < (1.0 - EXPLAINED) * before.length_rms;
        is_much.then_some((trial, gain))
    }

    fn trial(&self, freed: &[RecordingParameter], part: &[usize]) -> Option<Trial> {
        let Self { problem, candidate, model, loss, .. } = self;
        let candidate = Candidate { free: candidate.free.with_recording(freed), ..(*candidate).clone() };
        self.rated(freed, problem.fit_silently(model, &candidate, part, *loss).ok()?, part)
    }

    fn rated(&self, freed: &[RecordingParameter], fit: Fit, part: &[usize]) -> Option<Trial> {
        let errors = evaluate_fitted(&fit.model, &fit.as_fitted(&self.problem.samples.subset(part))).ok()?;
        let length_rms = errors.blocks().length_error_m.rms;
        let is_found = fit.status != Status::NotConverged && length_rms.is_finite();
        is_found.then(|| Trial { freed: freed.to_vec(), fit, length_rms })
    }
}
