//! Ranking of deviations: magnitudes of their effects over the poses, by cause and by kind.

use super::{Derivatives, Kind, ParameterDeviation, Side};

/// Influence of one unit of a cause over the poses.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Influence {
    /// The cause.
    pub cause: ParameterDeviation,
    /// Mean distance that the platform moves (m per unit).
    pub position_mean: f64,
    /// Largest distance (m per unit).
    pub position_max: f64,
    /// Mean angle that the platform turns (rad per unit).
    pub rotation_mean: f64,
    /// Largest angle (rad per unit).
    pub rotation_max: f64,
    /// Mean over the poses of the largest change of a tension (N per unit); `None` for a rigid machine.
    pub tension_mean: Option<f64>,
    /// Largest over the poses (N per unit); `None` for a rigid machine.
    pub tension_max: Option<f64>,
}

/// Influence of a kind of deviation over the poses: the root of the sum of squares over its causes, which is the
/// displacement by independent deviations of one standard deviation each.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct KindInfluence {
    /// Side of the deviation: control model, machine or winches.
    pub side: Side,
    /// Kind of the deviation.
    pub kind: Kind,
    /// Number of causes.
    pub count: usize,
    /// Unit of the kind.
    pub unit: &'static str,
    /// Root mean square over the poses (m per unit).
    pub position_rms: f64,
    /// Value at the worst pose (m per unit).
    pub position_max: f64,
}

/// Influence of every cause, in the order of the causes.
pub fn rank(causes: &[ParameterDeviation], derivatives: &[&Derivatives], translations: usize) -> Vec<Influence> {
    let one = |(column, &cause): (usize, &ParameterDeviation)| {
        let position = Spread::of(derivatives.iter().map(|at| at.position(translations, column)));
        let rotation = Spread::of(derivatives.iter().map(|at| at.rotation(translations, column)));
        let largest = |at: &&Derivatives| at.tensions.as_ref().map(|tensions| tensions.column(column).amax());
        let tensions: Option<Vec<f64>> = derivatives.iter().map(largest).collect();
        let tension = tensions.filter(|all| !all.is_empty()).map(|all| Spread::of(all.into_iter()));
        Influence {
            cause,
            position_mean: position.mean,
            position_max: position.max,
            rotation_mean: rotation.mean,
            rotation_max: rotation.max,
            tension_mean: tension.as_ref().map(|spread| spread.mean),
            tension_max: tension.as_ref().map(|spread| spread.max),
        }
    };
    causes.iter().enumerate().map(one).collect()
}

/// Influence of every kind.
pub fn rank_kinds(
    causes: &[ParameterDeviation],
    derivatives: &[&Derivatives],
    translations: usize,
) -> Vec<KindInfluence> {
    let mut kinds: Vec<(Side, Kind)> = causes.iter().map(|cause| (cause.side, cause.kind)).collect();
    kinds.sort();
    kinds.dedup();
    let one = |(side, kind): (Side, Kind)| {
        let columns: Vec<usize> =
            (0..causes.len()).filter(|&column| (causes[column].side, causes[column].kind) == (side, kind)).collect();
        let squares = |at: &&Derivatives| -> f64 {
            columns.iter().map(|&column| at.position(translations, column).powi(2)).sum()
        };
        let spread = Spread::of(derivatives.iter().map(squares));
        KindInfluence {
            side,
            kind,
            count: columns.len(),
            unit: kind.unit(),
            position_rms: spread.mean.sqrt(),
            position_max: spread.max.sqrt(),
        }
    };
    kinds.into_iter().map(one).collect()
}

/// Mean and largest of some numbers; NaN if there are none.
struct Spread {
    mean: f64,
    max: f64,
}

impl Spread {
    fn of(values: impl Iterator<Item = f64>) -> Self {
        let (mut count, mut sum, mut max) = (0_u32, 0.0, f64::NAN);
        for value in values {
            (count, sum, max) = (count + 1, sum + value, f64::max(max, value));
        }
        Self { mean: sum / f64::from(count), max }
    }
}
