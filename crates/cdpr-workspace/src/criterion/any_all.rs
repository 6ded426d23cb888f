//! Criteria joined by and, and by or.

use nalgebra::Vector3;

use super::{Criterion, Spans, Verdict};
use crate::WorkspaceError;
use cdpr_model::geometry::Pose;

/// Holds if all of its criteria hold.
///
/// The margin is the least one, in its own unit; the reason is that of the first criterion that fails.
pub struct All<'a> {
    joined: Joined<'a>,
}

/// Holds if any of its criteria holds.
///
/// The margin is the largest one, in its own unit; the reason lists those of all criteria.
pub struct Any<'a> {
    joined: Joined<'a>,
}

struct Joined<'a> {
    criteria: Vec<Box<dyn Criterion + 'a>>,
    name: String,
    unit: String,
}

impl<'a> Joined<'a> {
    fn new(criteria: Vec<Box<dyn Criterion + 'a>>, word: &str) -> Result<Self, WorkspaceError> {
        let first = criteria.first().ok_or(WorkspaceError::NoCriterion)?;
        let same = criteria.iter().all(|criterion| criterion.unit() == first.unit());
        let unit = if same { first.unit().to_owned() } else { "mixed".to_owned() };
        let names: Vec<&str> = criteria.iter().map(|criterion| criterion.name()).collect();
        let name = names.join(word);
        Ok(Self { criteria, name, unit })
    }

    fn verdicts(&self, pose: &Pose) -> Vec<Verdict> {
        self.criteria.iter().map(|criterion| criterion.judge(pose)).collect()
    }

    fn effort(&self) -> f64 {
        self.criteria.iter().map(|criterion| criterion.effort()).sum()
    }

    /// The spans of all criteria; `None` if any of them has none.
    fn spans(&self, start: &Pose, direction: &Vector3<f64>, length: f64) -> Option<Vec<Spans>> {
        self.criteria.iter().map(|criterion| criterion.holds_along(start, direction, length)).collect()
    }

    /// Reason of a criterion, after its name if there are several criteria.
    fn reason(&self, index: usize, verdict: &Verdict) -> Option<String> {
        let reason = verdict.reason.as_ref()?;
        match self.criteria.len() {
            1 => Some(reason.clone()),
            _ => Some(format!("{}: {reason}", self.criteria[index].name())),
        }
    }

    /// Asks each criterion about the poses that all earlier ones answered with `undecided`.
    fn holds_all(&self, poses: &[Pose], answers: &mut [bool], undecided: bool) {
        answers.fill(undecided);
        let mut open: Vec<usize> = (0..poses.len()).collect();
        let (mut asked, mut said) = (Vec::new(), Vec::new());
        for criterion in &self.criteria {
            asked.clear();
            asked.extend(open.iter().map(|&index| poses[index]));
            said.clear();
            said.resize(open.len(), false);
            criterion.holds_all(&asked, &mut said);
            open.iter().zip(&said).for_each(|(&index, &holds)| answers[index] = holds);
            open.retain(|&index| answers[index] == undecided);
        }
    }
}

impl<'a> All<'a> {
    /// A criterion that requires all of these; an error if there are none.
    pub fn new(criteria: Vec<Box<dyn Criterion + 'a>>) -> Result<Self, WorkspaceError> {
        Ok(Self { joined: Joined::new(criteria, " and ")? })
    }
}

impl<'a> Any<'a> {
    /// A criterion that requires one of these; an error if there are none.
    pub fn new(criteria: Vec<Box<dyn Criterion + 'a>>) -> Result<Self, WorkspaceError> {
        Ok(Self { joined: Joined::new(criteria, " or ")? })
    }
}

impl Criterion for All<'_> {
    fn name(&self) -> &str {
        &self.joined.name
    }

    fn unit(&self) -> &str {
        &self.joined.unit
    }

    fn effort(&self) -> f64 {
        self.joined.effort()
    }

    fn judge(&self, pose: &Pose) -> Verdict {
        let verdicts = self.joined.verdicts(pose);
        let margin = verdicts.iter().map(|verdict| verdict.margin).fold(f64::INFINITY, f64::min);
        let failed = verdicts.iter().position(|verdict| !verdict.holds());
        let limiting = failed.or_else(|| verdicts.iter().position(|verdict| verdict.margin == margin));
        let reason = failed.and_then(|index| self.joined.reason(index, &verdicts[index]));
        Verdict { margin, reason, cable: limiting.and_then(|index| verdicts[index].cable) }
    }

    fn holds(&self, pose: &Pose) -> bool {
        self.joined.criteria.iter().all(|criterion| criterion.holds(pose))
    }

    fn holds_all(&self, poses: &[Pose], answers: &mut [bool]) {
        self.joined.holds_all(poses, answers, true);
    }

    fn holds_along(&self, start: &Pose, direction: &Vector3<f64>, length: f64) -> Option<Spans> {
        let spans = self.joined.spans(start, direction, length)?;
        Some(spans.iter().fold(Spans::whole(length), |all, spans| all.and(spans)))
    }
}

impl Criterion for Any<'_> {
    fn name(&self) -> &str {
        &self.joined.name
    }

    fn unit(&self) -> &str {
        &self.joined.unit
    }

    fn effort(&self) -> f64 {
        self.joined.effort()
    }

    fn judge(&self, pose: &Pose) -> Verdict {
        let verdicts = self.joined.verdicts(pose);
        let margin = verdicts.iter().map(|verdict| verdict.margin).fold(f64::NEG_INFINITY, f64::max);
        let limiting = verdicts.iter().find(|verdict| verdict.margin == margin);
        let reasons: Vec<String> =
            verdicts.iter().enumerate().filter_map(|(index, verdict)| self.joined.reason(index, verdict)).collect();
        let reason = (margin < 0.0).then(|| reasons.join("; "));
        Verdict { margin, reason, cable: limiting.and_then(|verdict| verdict.cable) }
    }

    fn holds(&self, pose: &Pose) -> bool {
        self.joined.criteria.iter().any(|criterion| criterion.holds(pose))
    }

    fn holds_all(&self, poses: &[Pose], answers: &mut [bool]) {
        self.joined.holds_all(poses, answers, false);
    }

    fn holds_along(&self, start: &Pose, direction: &Vector3<f64>, length: f64) -> Option<Spans> {
        let spans = self.joined.spans(start, direction, length)?;
        Some(spans.iter().fold(Spans::default(), |any, spans| any.or(spans)))
    }
}
