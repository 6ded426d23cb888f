//! The tolerances that a required accuracy allows.

use crate::sensitivity::{Kind, ParameterDeviation, PoseSensitivity, Side};

/// Tolerances that a required accuracy allows.
#[derive(Clone, Debug, PartialEq)]
pub struct Allowed {
    /// Accuracy left for deviations at the pose with the largest error without them (m); not positive if no tolerance
    /// helps.
    pub budget: f64,
    /// Index of that pose, from 0.
    pub worst_pose: usize,
    /// Tolerances by kind; empty if no tolerance helps.
    pub kinds: Vec<Allowance>,
}

/// Tolerances of one kind, each in the unit of the kind.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Allowance {
    /// Side of the deviation: control model, machine or winches.
    pub side: Side,
    /// Kind of the deviation.
    pub kind: Kind,
    /// Unit of the kind.
    pub unit: &'static str,
    /// Standard deviation of each number if all others are exact; infinite for numbers without effect.
    pub alone: f64,
    /// Largest deviation of each number in the worst case if all others are exact.
    pub alone_worst_case: f64,
    /// Standard deviation of each number if all named kinds deviate, each by the same fraction of its own allowance;
    /// `None` for other kinds.
    pub joint: Option<f64>,
    /// Largest deviation of each number in the worst case, if all named kinds deviate; `None` for other kinds.
    pub joint_worst_case: Option<f64>,
}

/// Tolerances that an accuracy (m) allows at all poses: `coverage` times the root mean square of the deviation, or in
/// the worst case the deviation itself, must not exceed the accuracy minus the errors (m).
///
/// `errors` are those of the robot without deviations, or zeros if only deviations count. Jointly allowed tolerances
/// are those allowed alone, all reduced by the same factor; they are given for the kinds that `is_named` names.
pub fn allowed(
    causes: &[ParameterDeviation],
    poses: &[PoseSensitivity],
    errors: &[f64],
    accuracy: f64,
    coverage: f64,
    is_named: &dyn Fn(Side, Kind) -> bool,
    translations: usize,
) -> Allowed {
    let known: Vec<usize> = (0..poses.len()).filter(|&pose| poses[pose].derivatives.is_ok()).collect();
    let budgets: Vec<f64> = known.iter().map(|&pose| accuracy - errors[pose]).collect();
    let (place, budget) = least(&budgets);
    let worst_pose = known.get(place).copied().unwrap_or(0);
    // written so that NaN is refused too
    if !(budget > 0.0) {
        return Allowed { budget, worst_pose, kinds: Vec::new() };
    }
    let mut kinds: Vec<(Side, Kind)> = causes.iter().map(|cause| (cause.side, cause.kind)).collect();
    kinds.sort();
    kinds.dedup();
    let reached: Vec<Reached> = kinds
        .iter()
        .map(|&kind| Reached::of(kind, causes, known.iter().map(|&pose| &poses[pose]), translations))
        .collect();
    let alone = |ways: &[f64]| budgets.iter().zip(ways).map(|(budget, way)| budget / way).fold(f64::INFINITY, f64::min);
    let singles: Vec<[f64; 2]> =
        reached.iter().map(|reached| [alone(&reached.spread) / coverage, alone(&reached.sum)]).collect();
    let named: Vec<usize> = (0..kinds.len())
        .filter(|&kind| is_named(kinds[kind].0, kinds[kind].1) && singles[kind][0].is_finite())
        .collect();
    let fraction = |of: usize| {
        let ratio = |(place, budget): (usize, &f64)| {
            let ways = named.iter().map(|&kind| singles[kind][of] * reached[kind].ways(of)[place]);
            let all = if of == 0 { coverage * ways.map(|way| way * way).sum::<f64>().sqrt() } else { ways.sum() };
            budget / all
        };
        budgets.iter().enumerate().map(ratio).fold(f64::INFINITY, f64::min)
    };
    let fractions = [fraction(0), fraction(1)];
    let allowance = |(place, &(side, kind)): (usize, &(Side, Kind))| {
        let joint = |of: usize| named.contains(&place).then(|| fractions[of] * singles[place][of]);
        let [alone, alone_worst_case] = singles[place];
        Allowance {
            side,
            kind,
            unit: kind.unit(),
            alone,
            alone_worst_case,
            joint: joint(0),
            joint_worst_case: joint(1),
        }
    };
    Allowed { budget, worst_pose, kinds: kinds.iter().enumerate().map(allowance).collect() }
}

fn least(values: &[f64]) -> (usize, f64) {
    let first = (0, values.first().copied().unwrap_or(f64::NAN));
    values.iter().copied().enumerate().fold(first, |least, next| if next.1 < least.1 { next } else { least })
}

/// Displacement of the position by one unit of a kind, pose by pose.
struct Reached {
    /// Root of the sum of squares over the causes of the kind (m per unit).
    spread: Vec<f64>,
    /// Sum of the magnitudes (m per unit).
    sum: Vec<f64>,
}

impl Reached {
    fn of<'a>(
        kind: (Side, Kind),
        causes: &[ParameterDeviation],
        poses: impl Iterator<Item = &'a PoseSensitivity>,
        translations: usize,
    ) -> Self {
        let (mut spread, mut sum) = (Vec::new(), Vec::new());
        for derivatives in poses.filter_map(|at| at.derivatives.as_ref().ok()) {
            let of_kind = (0..causes.len()).filter(|&cause| (causes[cause].side, causes[cause].kind) == kind);
            let ways: Vec<f64> = of_kind.map(|cause| derivatives.position(translations, cause)).collect();
            spread.push(ways.iter().map(|way| way * way).sum::<f64>().sqrt());
            sum.push(ways.iter().sum());
        }
        Self { spread, sum }
    }

    fn ways(&self, of: usize) -> &[f64] {
        if of == 0 { &self.spread } else { &self.sum }
    }
}
