//! Everything a reader has to know before using a choice: the one list that text, JSON and page tell.

use super::{Judgement, Selection, worse};
use crate::evaluation::ErrorBlocks;
use crate::fit::{Estimate, Fit, Prior};
use crate::outliers::set_aside_warning;
use crate::plausibility::Distrust;
use crate::verdict::{Doubt, DoubtKind, Verdict};
use cdpr_model::finding::{Finding, FindingKind, Severity};
use cdpr_model::measurement::{Samples, three_digits};

/// Warnings in the order in which they are told: doubts about the outcome itself, which stand before it, then remarks about data and fit.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Warnings {
    /// Doubts, of which the outcome's [`Verdict`](crate::Verdict) is made.
    pub doubts: Vec<Doubt>,
    /// The others.
    pub remarks: Vec<String>,
}

impl Warnings {
    /// All of them in words.
    pub fn list(&self) -> Vec<String> {
        self.doubts.iter().map(|doubt| &doubt.finding.text).chain(&self.remarks).cloned().collect()
    }

    /// Adds a doubt, behind those that are there.
    pub fn doubt(&mut self, kind: DoubtKind, words: Option<String>) {
        self.doubts.extend(words.map(|words| Doubt::new(kind, words)));
    }
}

/// The name of the model as given, its errors and those of the fitted one.
type Comparison<'a> = (&'a str, [&'a ErrorBlocks; 2]);

impl Fit {
    /// Warnings about this fit alone: rules of plausibility that its errors break, the model as given by name with its errors and
    /// those of the fitted one, and what those warn of who read the samples.
    pub fn warnings_with(&self, distrust: &Distrust, today: Comparison<'_>, of_data: &Warnings) -> Warnings {
        self.gathered(distrust, Some(today), Vec::new(), of_data)
    }

    /// The same where nothing compares it with the model as given.
    pub fn own_warnings(&self, distrust: &Distrust, of_data: &Warnings) -> Warnings {
        self.gathered(distrust, None, Vec::new(), of_data)
    }

    /// Everything that a fit and its data are warned of: mistakes of the data stand first, for they explain the doubts that follow from them.
    fn gathered(
        &self,
        distrust: &Distrust,
        today: Option<Comparison<'_>>,
        of_comparison: Vec<Doubt>,
        of_data: &Warnings,
    ) -> Warnings {
        let own: Vec<Doubt> = distrust
            .reasons
            .iter()
            .cloned()
            .chain(self.outlier_doubt())
            .chain(of_comparison)
            .chain(self.doubts())
            .collect();
        let is_distrusted = of_data.doubts.iter().chain(&own).any(|doubt| doubt.finding.severity == Severity::Distrust);
        let mut doubts: Vec<Doubt> = of_data.doubts.iter().map(|doubt| as_cause(doubt, is_distrusted)).collect();
        doubts.extend(own);
        let worse = today.and_then(|(name, [before, after])| worse_than(name, before, after));
        doubts.extend(worse.map(|words| Doubt::new(DoubtKind::WorseThanGiven, words)));
        // the worst stands first; of equal ones a mistake of the data before what follows from it
        doubts.sort_by_key(|doubt| std::cmp::Reverse(doubt.finding.severity));
        let mut remarks: Vec<String> = Vec::new();
        for remark in of_data.remarks.iter().chain(&self.warnings) {
            if !remarks.contains(remark) && doubts.iter().all(|doubt| doubt.words() != remark) {
                remarks.push(remark.clone());
            }
        }
        Warnings { doubts, remarks }
    }
}

/// A mix-up that explains most of a misfit, and a frame that poses need, is the cause of an answer that nobody should trust, and weighs as much as what follows from it.
fn as_cause(doubt: &Doubt, is_distrusted: bool) -> Doubt {
    let explains = doubt.finding.explains.is_some_and(|fraction| fraction > 0.5);
    let is_cause = explains || doubt.kind == DoubtKind::Frames;
    match is_distrusted && is_cause && doubt.finding.severity == Severity::Caution {
        true => Doubt::from(Finding { severity: Severity::Distrust, ..doubt.finding.clone() }),
        false => doubt.clone(),
    }
}

impl Judgement {
    /// Verdict on the candidate, recommended or not.
    pub fn verdict(&self) -> Verdict {
        let fit = &self.fit;
        let doubts: Vec<Doubt> =
            self.distrust.reasons.iter().cloned().chain(fit.outlier_doubt()).chain(fit.doubts()).collect();
        let doubts = [doubts, self.unsound.iter().cloned().map(Doubt::from).collect()].concat();
        Verdict::of_fit(&doubts)
    }
}

fn worse_than(today: &str, before: &ErrorBlocks, after: &ErrorBlocks) -> Option<String> {
    let worse = worse::worse(before, after);
    (!worse.is_empty())
        .then(|| format!("worse than with `{today}` as given, which the robot runs today: {}", worse.join("; ")))
}

impl Selection {
    /// Index of the candidate that an answer is about: the recommended one, else the best, else the first that could be identified.
    pub fn shown(&self) -> Option<usize> {
        let judged = |index: &usize| self.candidates.get(*index).is_some_and(|candidate| candidate.outcome.is_ok());
        self.recommended.or(self.best).filter(judged).or_else(|| (0..self.candidates.len()).find(judged))
    }

    /// Warnings about the candidate of [`Selection::shown`]; `of_data` is what those warn of who read the samples.
    pub fn warnings(&self, samples: &Samples, of_data: &Warnings) -> Warnings {
        let judged = |index: usize| self.candidates[index].outcome.as_ref().ok();
        let Some(judgement) = self.shown().and_then(judged) else {
            return of_data.clone();
        };
        let given = self.as_given().filter(|_| self.recommended.is_some());
        let today = given.and_then(|given| {
            Some((self.candidates[given].name.as_str(), [&judged(given)?.validation, &judgement.validation]))
        });
        let mut of_data = of_data.clone();
        of_data.doubt(DoubtKind::Frames, self.frames.clone());
        of_data.doubt(DoubtKind::Clocks, self.clock.clone());
        of_data.doubts.extend(self.findings.iter().cloned().map(Doubt::from));
        of_data.doubts.extend(self.failed().map(Doubt::from));
        of_data.doubts.extend(self.unsound(judgement));
        for prior in &self.assumed {
            of_data.doubt(DoubtKind::Prior, beyond(prior, &judgement.fit));
        }
        of_data.remarks.extend(unanswered(judgement));
        of_data.remarks.extend(self.assumed.iter().filter_map(|prior| assumption(prior, &judgement.fit)));
        judgement.fit.gathered(&judgement.distrust, today, of_comparison(judgement, samples), &of_data)
    }
}

impl Selection {
    /// Candidates that could not be judged, in one finding; `None` if all were.
    fn failed(&self) -> Option<Finding> {
        let failures = || self.candidates.iter().filter_map(|one| Some((&one.name, one.outcome.as_ref().err()?)));
        let (name, reason) = failures().next()?;
        let (count, all) = (failures().count(), self.candidates.len());
        let others = if count > 1 { format!(" and {} others", count - 1) } else { String::new() };
        let words = format!("{count} of {all} candidates could not be judged, `{name}`{others}: {reason}");
        Some(Finding::new(FindingKind::Unsettled, Severity::Caution, words))
    }

    /// The reason why nobody should rely on a candidate, with the best one that is sound beside it.
    fn unsound(&self, judgement: &Judgement) -> Option<Doubt> {
        let finding = judgement.unsound.clone()?;
        let judged = self.candidates.iter().filter_map(|one| Some((&one.name, one.outcome.as_ref().ok()?)));
        let sound = judged.filter(|(_, own)| {
            own.unsound.is_none()
                && own.has_converged()
                && own.compared_mean.is_finite()
                && own.distrust.reasons.is_empty()
        });
        let best = sound.min_by(|a, b| a.1.compared_mean.total_cmp(&b.1.compared_mean));
        let text = match best {
            Some((name, own)) => format!(
                "{}; the best sound candidate is `{name}`, with a mean position error of {} mm",
                finding.text,
                three_digits(1e3 * own.validation.position_error_m.mean)
            ),
            None => format!("{}; no candidate is sound", finding.text),
        };
        Some(Doubt::from(Finding { text, ..finding }))
    }
}

/// A prior that nobody stated, where parameters of a fit have it.
fn assumption(prior: &Prior, fit: &Fit) -> Option<String> {
    let has_it = fit.parameters.iter().any(|estimate| estimate.parameter.kind == prior.kind);
    let (kind, unit) = (prior.kind, prior.kind.unit());
    has_it.then(|| {
        format!(
            "assumed: the {kind} parameters lie around the file's values with a standard deviation of {:.3} {unit} (a tenth of the platform's radius, 5 to \
             100 mm); a prior of your own takes its place",
            prior.sigma
        )
    })
}

/// Standard deviations of an assumed prior that a parameter may lie off the file without a word.
const FAR: f64 = 3.0;

/// Parameters that lie farther from the file than an assumed prior lets expect, in words; `None` without any.
fn beyond(prior: &Prior, fit: &Fit) -> Option<String> {
    let of_kind = fit.parameters.iter().filter(|estimate| estimate.parameter.kind == prior.kind);
    let far: Vec<&Estimate> = of_kind.filter(|estimate| estimate.change.abs() > FAR * prior.sigma).collect();
    let farthest = far.iter().max_by(|a, b| a.change.abs().total_cmp(&b.change.abs()))?;
    let (count, verb) = (far.len(), if far.len() == 1 { "parameter lies" } else { "parameters lie" });
    Some(format!(
        "{count} {} {verb} more than {FAR} standard deviations of the assumed prior from the file, {} by {:.1}: the file is farther off than assumed, or \
         the model lacks something",
        prior.kind,
        farthest.name,
        (farthest.change / prior.sigma).abs()
    ))
}

/// Samples that no candidate explains, and those that not all answer.
fn of_comparison(judgement: &Judgement, samples: &Samples) -> Vec<Doubt> {
    let places: Vec<usize> = judgement.set_aside.iter().map(|&place| judgement.validation_samples[place]).collect();
    let aside = set_aside_warning(&places, judgement.validation_samples.len(), samples);
    let (compared, all) = (judgement.compared_samples, judgement.validation.samples);
    let is_part = judgement.disqualified.is_none() && compared > 0 && compared < all;
    let partly = is_part
        .then(|| format!("compared on the {compared} of {all} validation samples that all judged candidates answer"));
    let aside = aside.map(|words| Doubt::new(DoubtKind::OutliersLeftOut, words));
    aside.into_iter().chain(partly.map(|words| Doubt::new(DoubtKind::PartlyCompared, words))).collect()
}

/// Samples without a pose, with the reason of the first.
fn unanswered(judgement: &Judgement) -> Option<String> {
    let missing = &judgement.validation_errors.not_converged;
    let (row, reason) = missing.first()?;
    let sample = judgement.validation_samples.get(*row).unwrap_or(row) + 1;
    Some(format!(
        "the forward problem of {} of {} validation samples has no answer, so that they have no error of the pose; the first is sample \
         {sample}: {reason}",
        missing.len(),
        judgement.validation_samples.len()
    ))
}
