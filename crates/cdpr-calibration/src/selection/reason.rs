//! Words for the outcome of a comparison.

use super::comparison::Compared;
use super::{JudgedCandidate, Judgement, SelectionCriterion};

/// The reason where no candidate can be compared.
pub(super) fn nobody(
    judged: &[(usize, &Judgement)],
    names: &[JudgedCandidate],
    criterion: SelectionCriterion,
) -> String {
    let obstacle = |own: &Judgement| {
        let early = (!own.has_converged()).then(|| "its fit did not converge".to_owned());
        own.disqualified.clone().or(early)
    };
    let first = judged.iter().find_map(|(index, judgement)| Some((index, obstacle(judgement)?)));
    let why = first.map_or_else(String::new, |(index, why)| format!("; `{}`: {why}", names[*index].name));
    let instead = match criterion {
        SelectionCriterion::Tension => {
            "that takes a model whose tensions follow from its lengths, and recorded tensions"
        }
        SelectionCriterion::Length => "check the poses of the data",
        _ => {
            "the error of the cable lengths at the measured poses needs no predicted pose and can be the criterion instead"
        }
    };
    format!("no candidate can be judged by its {}{why}; {instead}", criterion)
}

/// Words for the outcome.
pub(super) struct Reason<'a> {
    pub(super) names: &'a [JudgedCandidate],
    pub(super) criterion: SelectionCriterion,
    pub(super) compared: Compared,
    pub(super) best: usize,
    /// Mean of the errors by which the best one is compared.
    pub(super) best_mean: f64,
}

impl Reason<'_> {
    pub(super) fn for_choice(&self, index: usize, judgement: &Judgement, judged: &[(usize, &Judgement)]) -> String {
        let name = |index: usize| &self.names[index].name;
        let value = self.value(judgement);
        let mut text = match index == self.best {
            true => format!(
                "`{}` has the smallest {} on validation data ({value}), and no simpler candidate is as good on the same samples",
                name(index),
                self.words()
            ),
            false => format!(
                "`{}` is the simplest candidate that is as good as the best, `{}`, on the same validation samples: {value}; its {} is {} than that \
                 of the best",
                name(index),
                name(self.best),
                self.words(),
                self.difference(judgement)
            ),
        };
        let simpler = judged.iter().rev().find(|(other, _)| *other < index);
        if let Some((other, rejected)) = simpler {
            let why = match self.is_near(rejected) {
                true if rejected.unsound.is_some() => "but nobody should rely on its parameters",
                true => "but breaks a requirement",
                false => "",
            };
            let has = match &rejected.disqualified {
                Some(why) => format!("cannot be judged: {why}"),
                None if !rejected.has_converged() => "did not converge".to_owned(),
                None => format!("has {} {why}", self.value(rejected)),
            };
            let has = match rejected.disqualified.is_none() && rejected.has_converged() && why.is_empty() {
                true => format!("{}, {} than the best", has.trim_end(), self.difference(rejected)),
                false => has,
            };
            text.push_str(format!("; the next simpler one, `{}`, {has}", name(*other)).trim_end());
        }
        let ended_early = |(_, other): &&(usize, &Judgement)| !other.has_converged() && self.is_near(other);
        if let Some((other, early)) = judged.iter().find(ended_early) {
            let value = self.value(early);
            text.push_str(&format!(
                "; `{}` has {value}, but its fit did not converge, so that it is not recommended",
                name(*other)
            ));
        }
        if index + 1 == self.names.len() && index > 0 {
            text.push_str("; the list of candidates ends here, so that a richer one may be better still");
        }
        if let Some((_, other)) = judged.iter().find(|(other, _)| index != self.best && *other == self.best) {
            let doubts = other.fit.cautions();
            if !doubts.is_empty() {
                text.push_str(&format!(". Of the best one: {}", doubts.join("; ")));
            }
        }
        text
    }

    pub(super) fn for_none(&self, judged: &[(usize, &Judgement)]) -> String {
        let best = judged.iter().find(|(index, _)| *index == self.best);
        let broken = best.into_iter().flat_map(|(_, judgement)| &judgement.requirements).filter(|r| !r.met);
        let broken: Vec<String> = broken.map(ToString::to_string).collect();
        let value = best.map_or_else(String::new, |(_, judgement)| format!(" ({})", self.value(judgement)));
        format!(
            "no candidate that is as good as the best, `{}`{value}, on the same samples meets the requirements; it breaks: {}",
            self.names[self.best].name,
            if broken.is_empty() { "none itself".to_owned() } else { broken.join(", ") }
        )
    }

    /// The error by which candidates are compared, in words.
    fn words(&self) -> String {
        match self.compared {
            Compared::Criterion(criterion) => criterion.to_string(),
            Compared::Pose(_) => "mean pose error (distance and turn of the platform anchors together)".to_owned(),
        }
    }

    /// The criterion of a candidate with its standard error.
    fn value(&self, judgement: &Judgement) -> String {
        self.criterion.format_with_error(judgement.criterion, judgement.standard_error)
    }

    /// The difference of a candidate to the best, which is never less than nothing by much.
    fn difference(&self, judgement: &Judgement) -> String {
        judgement.difference.map_or_else(String::new, |found| {
            format!("{} larger", self.criterion.format_with_error(found.mean, found.standard_error))
        })
    }

    fn is_near(&self, judgement: &Judgement) -> bool {
        judgement.difference.is_some_and(|found| found.is_none(self.best_mean))
    }
}
