//! How far an answer may be relied on: one word for text, JSON, page, written file and exit code.

use cdpr_model::finding::{Finding, FindingKind, Severity};

/// How far an answer may be relied on, from best to worst; the worst that any of its doubts makes of it counts.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Verdict {
    /// Nothing speaks against it.
    Sound,
    /// To be used after reading the doubts.
    WithCaution,
    /// The data leave parameters open.
    NotIdentifiable,
    /// Errors are beyond what data and model explain.
    NotTrusted,
    /// The optimum is a model without a forward problem.
    NotPredictive,
    /// The search ended before the optimum, or poses have no prediction.
    NotConverged,
}

/// Kind of a reason to doubt an answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum DoubtKind {
    /// The search of a fit ended before the optimum.
    NotConverged,
    /// The fit ended at a model without a forward problem.
    NotPredictive,
    /// The data do not determine all parameters.
    NotIdentifiable,
    /// Less than half of the poses are predicted.
    FewPoses,
    /// Errors above a hundredth of the robot's size.
    Gross,
    /// Errors far beyond the stated accuracy.
    BeyondAccuracy,
    /// Outliers that count as any other sample.
    OutliersCounted,
    /// Outliers that count less or not at all.
    OutliersLeftOut,
    /// Finding of data, numbers or statics, which says how much it weighs.
    Found(Severity),
    /// Poses that need the frame of a tracker or a marker.
    Frames,
    /// Clocks of poses and lengths that differ.
    Clocks,
    /// Candidates compared on a part of the validation data.
    PartlyCompared,
    /// Other optima that are as good, or found more often.
    Starts,
    /// Parameters at a bound.
    Bound,
    /// Parameters that lie farther from the file than an assumed prior lets expect.
    Prior,
    /// Parameters that the data hold weakly.
    WeakDirection,
    /// Cables whose stiffness the data leave open.
    UnknownStiffness,
    /// Errors larger than those of the model as given.
    WorseThanGiven,
    /// A law of stretch that is not that of its record.
    Law,
    /// A record without a rising polynomial.
    NoPolynomial,
    /// An output that its input explains over less than half of the frequencies.
    Coherence,
    /// Frequencies of a record that do not reach what is asked of them, or do not resolve it.
    Band,
    /// A transfer function that no machine at rest has, or that its points hold weakly.
    Shape,
}

impl DoubtKind {
    /// The table of what a doubt makes of an answer.
    pub const fn verdict(self) -> Verdict {
        match self {
            Self::NotConverged => Verdict::NotConverged,
            Self::NotPredictive => Verdict::NotPredictive,
            Self::FewPoses
            | Self::Gross
            | Self::BeyondAccuracy
            | Self::OutliersCounted
            | Self::Law
            | Self::Coherence => Verdict::NotTrusted,
            Self::NotIdentifiable | Self::Band => Verdict::NotIdentifiable,
            Self::Found(Severity::Remark) => Verdict::Sound,
            Self::Found(Severity::Distrust) => Verdict::NotTrusted,
            Self::Found(Severity::Caution)
            | Self::OutliersLeftOut
            | Self::Frames
            | Self::Clocks
            | Self::PartlyCompared
            | Self::Starts
            | Self::Bound
            | Self::Prior
            | Self::WeakDirection
            | Self::UnknownStiffness
            | Self::WorseThanGiven
            | Self::NoPolynomial
            | Self::Shape => Verdict::WithCaution,
        }
    }
}

impl DoubtKind {
    /// Returns the kind of the finding that answers write for a doubt.
    const fn finding(self) -> FindingKind {
        match self {
            Self::NotConverged | Self::NotPredictive | Self::Starts => FindingKind::Unsettled,
            Self::NotIdentifiable | Self::WeakDirection => FindingKind::WeakDirection,
            Self::OutliersCounted | Self::OutliersLeftOut => FindingKind::Outlier,
            Self::Frames => FindingKind::Frame,
            Self::Clocks => FindingKind::Clock,
            Self::PartlyCompared | Self::Band => FindingKind::Coverage,
            Self::Bound => FindingKind::Bound,
            Self::Prior => FindingKind::Anchor,
            Self::UnknownStiffness => FindingKind::Stiffness,
            Self::FewPoses
            | Self::Gross
            | Self::BeyondAccuracy
            | Self::WorseThanGiven
            | Self::Law
            | Self::NoPolynomial
            | Self::Coherence
            | Self::Shape
            | Self::Found(_) => FindingKind::LackOfFit,
        }
    }

    const fn severity(self) -> Severity {
        match self.verdict() {
            Verdict::Sound => Severity::Remark,
            Verdict::WithCaution => Severity::Caution,
            _ => Severity::Distrust,
        }
    }
}

/// A reason to doubt an answer.
#[derive(Clone, Debug, PartialEq)]
pub struct Doubt {
    /// Its kind, which says how much it weighs.
    pub kind: DoubtKind,
    /// The reason in a sentence, with its place and its numbers.
    pub finding: Finding,
}

impl Doubt {
    /// A doubt of a kind in words.
    pub fn new(kind: DoubtKind, words: impl Into<String>) -> Self {
        Self { kind, finding: Finding::new(kind.finding(), kind.severity(), words) }
    }

    /// The reason in a sentence.
    pub fn words(&self) -> &str {
        &self.finding.text
    }
}

impl From<Finding> for Doubt {
    fn from(finding: Finding) -> Self {
        Self { kind: DoubtKind::Found(finding.severity), finding }
    }
}

impl Verdict {
    /// Verdict on identified parameters, or on a law of stretch.
    pub fn of_fit(doubts: &[Doubt]) -> Self {
        doubts.iter().map(|doubt| doubt.kind.verdict()).max().unwrap_or(Self::Sound)
    }

    /// Verdict on a recommended candidate: parameters that the data leave open are a caution where predictions are good.
    pub fn of_choice(doubts: &[Doubt]) -> Self {
        match Self::of_fit(doubts) {
            Self::NotIdentifiable => Self::WithCaution,
            Self::NotPredictive | Self::NotConverged => Self::NotTrusted,
            other => other,
        }
    }

    /// Verdict on predictions, all of which have an answer or not.
    pub fn of_predictions(doubts: &[Doubt], is_complete: bool) -> Self {
        if is_complete { Self::of_fit(doubts) } else { Self::NotConverged }
    }

    /// False for an answer that nobody should work with.
    pub fn is_trusted(self) -> bool {
        self < Self::NotTrusted
    }

    /// True for an answer that is a no.
    pub fn is_negative(self) -> bool {
        self > Self::WithCaution
    }

    /// True for a no that a user may overrule: the answer is there, only not to be relied on.
    pub fn may_be_accepted(self) -> bool {
        matches!(self, Self::NotTrusted | Self::NotConverged)
    }

    /// Status of identified parameters and of predictions.
    pub fn fit_status(self) -> &'static str {
        match self {
            Self::Sound => "converged",
            Self::WithCaution => "converged-with-caution",
            Self::NotIdentifiable => "not-identifiable",
            Self::NotTrusted => "not-trusted",
            Self::NotPredictive => "not-predictive",
            Self::NotConverged => "not-converged",
        }
    }

    /// Status of a recommendation.
    pub fn choice_status(self) -> &'static str {
        match self {
            Self::Sound => "recommended",
            Self::WithCaution => "recommended-with-caution",
            _ => "not-trusted",
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The worst doubt decides, whatever stands beside it.
    #[test]
    fn the_worst_doubt_decides() {
        let of = |kinds: &[DoubtKind]| {
            let doubts: Vec<Doubt> = kinds.iter().map(|kind| Doubt::new(*kind, "why")).collect();
            (Verdict::of_fit(&doubts), Verdict::of_choice(&doubts))
        };
        assert_eq!(of(&[]), (Verdict::Sound, Verdict::Sound));
        assert_eq!(of(&[DoubtKind::Bound, DoubtKind::Starts]), (Verdict::WithCaution, Verdict::WithCaution));
        let open = of(&[DoubtKind::NotIdentifiable, DoubtKind::Bound]);
        assert_eq!(open, (Verdict::NotIdentifiable, Verdict::WithCaution));
        let gross = of(&[DoubtKind::Bound, DoubtKind::Gross, DoubtKind::NotIdentifiable]);
        assert_eq!(gross, (Verdict::NotTrusted, Verdict::NotTrusted));
        assert_eq!(of(&[DoubtKind::NotConverged, DoubtKind::Gross]).0, Verdict::NotConverged);
        let negative = [Verdict::NotIdentifiable, Verdict::NotTrusted, Verdict::NotPredictive, Verdict::NotConverged];
        assert!(negative.iter().all(|verdict| verdict.is_negative()));
        assert!(!Verdict::WithCaution.is_negative() && Verdict::NotIdentifiable.is_trusted());
        assert!(negative[1..].iter().all(|verdict| !verdict.is_trusted()));
    }
}
