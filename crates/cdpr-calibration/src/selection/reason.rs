//! Words for the outcome of a comparison.

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
    pub(super) best: usize,
    pub(super) limit: f64,
}

impl Reason<'_> {
    pub(super) fn for_choice(&self, index: usize, judgement: &Judgement, judged: &[(usize, &Judgement)]) -> String {
        let name = |index: usize| &self.names[index].name;
        let (words, value) = (self.criterion.to_string(), self.value(judgement));
        let limit = self.limit(judged);
        let mut text = match index == self.best {
            true => format!(
                "`{}` has the smallest {words} on validation data, {value}, and no simpler candidate comes within one \
                 standard error of it ({limit})",
                name(index)
            ),
            false => format!(
                "`{}` is the simplest candidate whose {words} on validation data, {value}, lies within one standard error \
                 ({limit}) of the best, `{}`",
                name(index),
                name(self.best)
            ),
        };
        let simpler = judged.iter().rev().find(|(other, _)| *other < index);
        if let Some((other, rejected)) = simpler {
            let why = if rejected.criterion <= self.limit { "but breaks a requirement" } else { "" };
            let has = match &rejected.disqualified {
                Some(why) => format!("cannot be judged: {why}"),
                None if !rejected.has_converged() => "did not converge".to_owned(),
                None => format!("has {} {why}", self.value(rejected)),
            };
            text.push_str(format!("; the next simpler one, `{}`, {has}", name(*other)).trim_end());
        }
        let ended_early = |(_, other): &&(usize, &Judgement)| !other.has_converged() && other.criterion <= self.limit;
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
        format!(
            "no candidate within one standard error of the best, `{}` ({}), meets the requirements; it breaks: {}",
            self.names[self.best].name,
            self.limit(judged),
            if broken.is_empty() { "none itself".to_owned() } else { broken.join(", ") }
        )
    }

    /// The criterion of a candidate with its standard error.
    fn value(&self, judgement: &Judgement) -> String {
        self.criterion.format_with_error(judgement.criterion, judgement.standard_error)
    }

    /// The limit, to the digits of the best candidate's standard error, out of which it is made.
    fn limit(&self, judged: &[(usize, &Judgement)]) -> String {
        let best = judged.iter().find(|(index, _)| *index == self.best);
        let error = best.map_or(f64::NAN, |(_, judgement)| judgement.standard_error);
        self.criterion.format_within(self.limit, error)
    }
}
