//! Criteria besides the one that decides, and the candidate that each of them chooses.

use super::settings::Settings;
use super::{JudgedCandidate, Judgement, SelectionCriterion};
use crate::likelihood::Information;
use crate::paired::as_good_as_best;

/// Differences of information criteria that say nothing (Burnham and Anderson 2002, section 2.6; Kass and Raftery 1995).
const NOTHING: f64 = 2.0;

/// Share by which a largest error has to be larger to be told from another.
const SAME_LARGEST: f64 = 0.1;

const MEANS: [(&str, SelectionCriterion); 4] = [
    ("position-mean", SelectionCriterion::Position),
    ("rotation-mean", SelectionCriterion::Rotation),
    ("length-mean", SelectionCriterion::Length),
    ("tension-mean", SelectionCriterion::Tension),
];

const LARGEST: [(&str, &str, SelectionCriterion); 2] = [
    ("position-max", "the largest position error", SelectionCriterion::Position),
    ("rotation-max", "the largest rotation error", SelectionCriterion::Rotation),
];

/// Errors below this are rounding (m, rad).
const ROUNDING: f64 = 1e-9;

/// Choice of one criterion: the simplest candidate that it cannot tell from its best.
#[derive(Clone, Debug, PartialEq)]
pub struct Preference {
    /// Name of the criterion.
    pub name: &'static str,
    /// The criterion in words, with what counts as no difference.
    pub words: String,
    /// Index of the chosen candidate.
    pub candidate: usize,
    /// Name of the chosen candidate.
    pub candidate_name: String,
    /// Its value (SI units).
    pub value: f64,
    /// Value of the recommended candidate, where that has one.
    pub of_recommended: Option<f64>,
    /// Values of all candidates, in their order; not a number where the criterion does not rate one.
    pub values: Vec<f64>,
}

/// Outcome of a comparison.
#[derive(Clone, Copy)]
pub(super) struct Outcome<'a> {
    pub(super) candidates: &'a [JudgedCandidate],
    pub(super) best: Option<usize>,
    pub(super) recommended: Option<usize>,
    /// A number for every sample of the data, the same for repeated poses; empty where no pose was measured.
    pub(super) groups: &'a [usize],
}

/// Candidates that may be chosen, with their indices.
fn compared(candidates: &[JudgedCandidate]) -> impl Iterator<Item = (usize, &Judgement)> {
    let judged = candidates.iter().enumerate().filter_map(|(index, one)| Some((index, one.outcome.as_ref().ok()?)));
    judged.filter(|(_, judgement)| judgement.disqualified.is_none() && judgement.has_converged())
}

/// A figure that rates candidates.
struct Figure {
    name: &'static str,
    words: String,
    /// Values of all candidates.
    values: Vec<f64>,
    /// Candidates that the figure does not tell from its best.
    as_good: Vec<bool>,
}

/// Choice of every criterion that rates at least one candidate, that of the comparison first.
pub(super) fn preferences(selection: Outcome<'_>, settings: &Settings) -> Vec<Preference> {
    let decided = decided(selection, settings);
    let rest = information(selection).into_iter().chain(regions(selection, settings)).chain(tasks(selection, settings));
    // a criterion that cannot rate the recommended candidate says nothing against it
    let rates = |preference: &Preference| selection.recommended.is_none() || preference.of_recommended.is_some();
    decided.into_iter().chain(rest.filter_map(|figure| figure.choice(selection)).filter(rates)).collect()
}

/// The rule that decides, and the least criterion without it.
fn decided(selection: Outcome<'_>, settings: &Settings) -> Vec<Preference> {
    let kind = settings.criterion;
    let values = of_compared(selection, |judgement| judgement.criterion);
    let figure = |name, words: String| Figure::within(name, words, values.clone(), 0.0);
    let by_rule = figure(
        "one-standard-error",
        format!("the {kind} as good as the best on the same samples (the rule that decides)"),
    );
    let least = figure("least-error", format!("the least {kind}"));
    let rule = selection.recommended.map(|index| by_rule.preference(selection, index));
    rule.into_iter().chain(least.choice(selection)).collect()
}

/// Information criteria on the rows of the recommended, else the best candidate.
fn information(selection: Outcome<'_>) -> Vec<Figure> {
    let own = |index: usize| selection.candidates[index].outcome.as_ref().ok()?.information;
    let Some(rows) = selection.recommended.or(selection.best).and_then(own) else { return Vec::new() };
    let read = |read: fn(&Information) -> f64| {
        of_compared(selection, |judgement| {
            let same =
                judgement.information.filter(|one| (one.rows, one.with_wrenches) == (rows.rows, rows.with_wrenches));
            same.as_ref().map_or(f64::NAN, read)
        })
    };
    let kind = if rows.with_wrenches { "wrenches and lengths" } else { "lengths" };
    let figure = |name, title, values| Figure::within(name, format!("{title} of {kind}"), values, NOTHING);
    vec![figure("aic", "AIC", read(|one| one.aicc)), figure("bic", "BIC", read(|one| one.bic))]
}

/// The criterion on regions that were left out.
fn regions(selection: Outcome<'_>, settings: &Settings) -> Option<Figure> {
    let read = |judgement: &Judgement| judgement.regions.map_or(f64::NAN, |held| held.criterion);
    let values = of_compared(selection, read);
    let mut series = vec![Vec::new(); selection.candidates.len()];
    for (index, judgement) in compared(selection.candidates) {
        series[index] = judgement.region_errors.as_ref().map_or_else(Vec::new, |errors| settings.criterion.of(errors));
    }
    let told = || series.iter().filter(|series| !series.is_empty());
    let samples = told().map(Vec::len).min().unwrap_or(0);
    let common: Vec<usize> = (0..samples).filter(|&sample| told().all(|series| series[sample].is_finite())).collect();
    let series: Vec<Vec<f64>> = series.iter().map(|own| at(own, &common)).collect();
    let (_, as_good) = as_good_as_best(&series, &common, settings.seed)?;
    let words = format!("the {} on regions left out", settings.criterion);
    Some(Figure { name: "leave-region-out", words, values, as_good })
}

/// Mean and largest errors of every kind, for tasks that ask for these.
fn tasks(selection: Outcome<'_>, settings: &Settings) -> Vec<Figure> {
    let mut figures = Vec::new();
    for (name, kind) in MEANS.into_iter().filter(|(_, kind)| *kind != settings.criterion) {
        let (series, groups) = common_series(selection, kind);
        let values: Vec<f64> = series.iter().map(|series| mean(series)).collect();
        let Some((_, as_good)) = as_good_as_best(&series, &groups, settings.seed) else { continue };
        figures.push(Figure { name, words: format!("the {kind}"), values, as_good });
    }
    for (name, words, kind) in LARGEST {
        let values: Vec<f64> = common_series(selection, kind).0.iter().map(|series| largest(series)).collect();
        let Some((_, value)) = least(&values) else { continue };
        figures.push(Figure::within(name, words.to_owned(), values, SAME_LARGEST * value));
    }
    figures.retain(|figure| figure.values.iter().any(|&value| value > ROUNDING));
    figures
}

/// Errors of every candidate on the validation samples that all compared ones answer and that some explain, empty for the others, and the numbers of the poses
/// of these samples.
fn common_series(selection: Outcome<'_>, kind: SelectionCriterion) -> (Vec<Vec<f64>>, Vec<usize>) {
    let mut series = vec![Vec::new(); selection.candidates.len()];
    for (index, judgement) in compared(selection.candidates) {
        let own = kind.of(&judgement.validation_errors);
        // tensions are rated among the candidates that know them
        if own.iter().any(|value| value.is_finite()) {
            series[index] = own;
        }
    }
    let set_aside = compared(selection.candidates).next().map_or(&[][..], |(_, judgement)| &judgement.set_aside);
    let told = || series.iter().filter(|series| !series.is_empty());
    let samples = told().map(Vec::len).min().unwrap_or(0);
    let is_common =
        |&sample: &usize| set_aside.binary_search(&sample).is_err() && told().all(|series| series[sample].is_finite());
    let common: Vec<usize> = (0..samples).filter(is_common).collect();
    let places = compared(selection.candidates).next().map_or(&[][..], |(_, own)| &own.validation_samples);
    let group = |place: &usize| selection.groups.get(*places.get(*place)?).copied();
    let groups = common.iter().map(|place| group(place).unwrap_or(*place)).collect();
    (series.iter().map(|own| at(own, &common)).collect(), groups)
}

/// The values at places; none of an empty series.
fn at(series: &[f64], places: &[usize]) -> Vec<f64> {
    if series.is_empty() { Vec::new() } else { places.iter().map(|&place| series[place]).collect() }
}

fn mean(series: &[f64]) -> f64 {
    series.iter().sum::<f64>() / series.len() as f64
}

fn largest(series: &[f64]) -> f64 {
    series.iter().copied().fold(f64::NAN, f64::max)
}

/// A value of every candidate; not a number for those that are not compared.
fn of_compared(selection: Outcome<'_>, read: impl Fn(&Judgement) -> f64) -> Vec<f64> {
    let mut values = vec![f64::NAN; selection.candidates.len()];
    compared(selection.candidates).for_each(|(index, judgement)| values[index] = read(judgement));
    values
}

/// Place and size of the least of the values that are numbers.
fn least(values: &[f64]) -> Option<(usize, f64)> {
    let finite = values.iter().copied().enumerate().filter(|(_, value)| value.is_finite());
    finite.min_by(|a, b| a.1.total_cmp(&b.1))
}

impl Figure {
    /// A figure that does not tell values from its least that lie within some room of it.
    fn within(name: &'static str, words: String, values: Vec<f64>, room: f64) -> Self {
        let limit = least(&values).map_or(f64::NAN, |(_, least)| least + if room.is_finite() { room } else { 0.0 });
        let as_good = values.iter().map(|value| *value <= limit).collect();
        Self { name, words, values, as_good }
    }

    /// The simplest candidate that is not told from the best.
    fn choice(self, selection: Outcome<'_>) -> Option<Preference> {
        let index = self.as_good.iter().position(|as_good| *as_good)?;
        Some(self.preference(selection, index))
    }

    fn preference(self, selection: Outcome<'_>, candidate: usize) -> Preference {
        let Self { name, words, values, .. } = self;
        Preference {
            name,
            words,
            candidate,
            candidate_name: selection.candidates[candidate].name.clone(),
            value: values[candidate],
            of_recommended: selection.recommended.map(|index| values[index]).filter(|value| value.is_finite()),
            values,
        }
    }
}
