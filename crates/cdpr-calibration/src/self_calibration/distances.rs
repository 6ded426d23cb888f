//! The one distance that, measured, narrows the bands of predicted poses most.

use nalgebra::{DVector, Vector3};

use super::predicted_band::{At, Information, PredictedBand};
use cdpr_model::measurement::three_digits;
use cdpr_model::robot::ParameterKind;

/// Accuracy of a measured distance (m).
const ACCURACY: f64 = 1e-3;

/// End of a distance.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum End {
    /// Sampled pose.
    Pose(usize),
    /// Frame anchor of a cable.
    Anchor(usize),
}

/// Distance between two points of the robot or the record, with the band of the poses once it is measured.
#[derive(Clone, Debug)]
pub(super) struct Distance {
    ends: [End; 2],
    metres: f64,
    /// Squares of the bands that it takes away, summed over the samples (m²).
    gain: f64,
    samples: usize,
}

impl Distance {
    /// Returns the distance that narrows the band most, of two frame anchors, of the sampled poses farthest apart, or of one of these and a frame anchor; `None` if none
    /// narrows it.
    pub(super) fn best(at: &At<'_, '_>, information: &Information) -> Option<Self> {
        let anchors: Vec<End> = (0..at.model.cable_count()).map(End::Anchor).collect();
        let poses = farthest(at).map_or_else(Vec::new, |pair| pair.map(End::Pose).to_vec());
        let all: Vec<End> = anchors.into_iter().chain(poses).collect();
        let pairs = (0..all.len()).flat_map(|a| (0..a).map(move |b| (b, a)));
        let told = pairs.filter_map(|(a, b)| Self::of(at, information, [all[a], all[b]]));
        told.max_by(|a, b| a.gain.total_cmp(&b.gain)).filter(|best| best.gain > 0.0)
    }

    fn of(at: &At<'_, '_>, information: &Information, ends: [End; 2]) -> Option<Self> {
        let [first, second] = ends.map(|end| place(at, end));
        let metres = (first - second).norm();
        let along = (first - second) / metres;
        let gradient = derivative(at, information, ends[0], &along) - derivative(at, information, ends[1], &along);
        let own = at.inflation * at.question.sensing.length_sigma();
        let poses = ends.iter().filter(|end| matches!(end, End::Pose(_))).count() as f64;
        let told = &information.covariance * &gradient;
        let variance = gradient.dot(&told) + ACCURACY * ACCURACY + poses * own * own;
        let gain = (&information.fields * told).norm_squared() / variance;
        gain.is_finite().then_some(Self { ends, metres, gain, samples: information.samples() })
    }

    /// Words for the distance, and for the band that is left with it.
    pub(super) fn words(&self, at: &At<'_, '_>, band: &PredictedBand) -> String {
        let after = (band.band_m * band.band_m - self.gain / self.samples as f64).max(0.0).sqrt();
        let lines = at.question.internal.samples.lines.as_ref();
        let name = |end: End| match end {
            End::Anchor(cable) => format!("the frame anchor of cable {}", cable + 1),
            End::Pose(sample) => match lines.and_then(|lines| lines.get(sample)) {
                Some(line) => format!("the pose of line {line}"),
                None => format!("the pose of sample {}", sample + 1),
            },
        };
        let how = match self.ends {
            [End::Anchor(a), End::Anchor(b)] => format!("--known distance[{},{}]=…", a + 1, b + 1),
            [End::Pose(_), End::Pose(_)] => {
                "as their positions in the columns of the pose, those of the other rows left empty".to_owned()
            }
            _ => "as the position in the columns of the pose, those of the other rows left empty".to_owned(),
        };
        let [first, second] = self.ends.map(name);
        format!(
            "measure the distance from {first} to {second}, {} m ({how}): known to {} mm, it narrows the band of predicted poses from {} to {} mm",
            three_digits(self.metres),
            1e3 * ACCURACY,
            three_digits(1e3 * band.band_m),
            three_digits(1e3 * after)
        )
    }
}

/// The two sampled poses farthest apart; `None` if all are at one place.
fn farthest(at: &At<'_, '_>) -> Option<[usize; 2]> {
    let apart = |[a, b]: [usize; 2]| (at.poses[a].position - at.poses[b].position).norm();
    // the farthest from one of them, and the farthest from that one again, are nearly as far apart as any
    let from = |a: usize| (0..at.poses.len()).max_by(|b, c| apart([a, *b]).total_cmp(&apart([a, *c])));
    let mut first = from(0)?;
    let mut second = from(first)?;
    for _ in 0..3 {
        first = from(second)?;
        std::mem::swap(&mut first, &mut second);
    }
    let pair = [first.min(second), first.max(second)];
    (apart(pair) > 0.0).then_some(pair)
}

fn place(at: &At<'_, '_>, end: End) -> Vector3<f64> {
    match end {
        End::Pose(sample) => at.poses[sample].position,
        End::Anchor(cable) => at.model.robot().cables[cable].frame_anchor,
    }
}

/// Derivative of an end's coordinate along a direction by every column.
fn derivative(at: &At<'_, '_>, information: &Information, end: End, along: &Vector3<f64>) -> DVector<f64> {
    match end {
        End::Pose(sample) => information.displacements.fixed_rows::<3>(3 * sample).tr_mul(along),
        End::Anchor(cable) => {
            let axes = at.model.axes();
            let of_column = information.columns.iter().map(|column| {
                let own = column
                    .iter()
                    .filter(|(parameter, _)| parameter.kind == ParameterKind::FrameAnchor && parameter.cable == cable);
                own.map(|(parameter, change)| change * axes[parameter.axis].dot(along)).sum::<f64>()
            });
            DVector::from_iterator(information.columns.len(), of_column)
        }
    }
}
