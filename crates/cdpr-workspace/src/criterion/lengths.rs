//! Cable lengths within limits.

use nalgebra::Vector3;

use super::cables::{limits, named, paths};
use super::{Criterion, Spans, Verdict};
use crate::WorkspaceError;
use cdpr_model::geometry::Pose;
use cdpr_model::model::Model;
use cdpr_model::robot::Cable;

/// Every geometric cable length q, wrapped part included, keeps q_min ≤ q ≤ q_max (`length_min_m`, `length_max_m`).
///
/// The margin (m) is the least distance of a length from its limits. Between point outlets and anchors, without
/// pulleys, drums and sag, the limits are spheres: the parts of a straight line on which they hold follow from
/// quadratic equations.
#[derive(Clone, Debug)]
pub struct LengthLimits<'a> {
    model: &'a Model,
    limits: Vec<[f64; 2]>,
}

const NAME: &str = "cable-length";

impl<'a> LengthLimits<'a> {
    /// The criterion with these limits for all cables (m), or else those of the robot's file.
    ///
    /// A limit that is neither given nor in the file for any cable is absent; one of both is required.
    pub fn new(model: &'a Model, minimum: Option<f64>, maximum: Option<f64>) -> Result<Self, WorkspaceError> {
        let (keys, of) =
            (["length_min_m", "length_max_m"], [|cable: &Cable| cable.length_min, |cable: &Cable| cable.length_max]);
        Ok(Self { model, limits: limits(model.robot(), NAME, keys, [minimum, maximum], of)? })
    }
}

impl Criterion for LengthLimits<'_> {
    fn name(&self) -> &str {
        NAME
    }

    fn unit(&self) -> &str {
        "m"
    }

    fn judge(&self, pose: &Pose) -> Verdict {
        let lengths = match paths(self.model, pose) {
            Ok(paths) => paths.into_iter().map(|(path, _)| path.length),
            Err(verdict) => return verdict,
        };
        nearest_limit(lengths, &self.limits, |cable, length, limit| {
            let (name, side) = (named(self.model.robot(), cable), if length > limit { "at most" } else { "at least" });
            format!("{name} would be {length:.4} m long, it may be {side} {limit} m")
        })
    }

    fn holds_along(&self, start: &Pose, direction: &Vector3<f64>, length: f64) -> Option<Spans> {
        if self.model.composition().drum {
            return None;
        }
        let mut spans = Spans::whole(length);
        for ((frame_anchor, platform_anchor), [least, largest]) in self.model.straight_lines()?.zip(&self.limits) {
            let way = start.transform(platform_anchor) - frame_anchor;
            if largest.is_finite() {
                spans = in_sphere(&way, direction, *largest).map_or_else(Spans::default, |inside| spans.within(inside));
            }
            if *least > 0.0
                && let Some(inside) = in_sphere(&way, direction, *least)
            {
                spans = spans.without(inside);
            }
        }
        Some(spans)
    }
}

/// Interval of ρ (m) with |way + ρ direction| ≤ radius: |way|² + 2 ρ way · direction + ρ² ≤ radius²; `None` if it is
/// empty.
fn in_sphere(way: &Vector3<f64>, direction: &Vector3<f64>, radius: f64) -> Option<[f64; 2]> {
    let nearest = -way.dot(direction);
    // the distance of the line, without a difference of large squares
    let away = (way + direction * nearest).norm();
    (away <= radius).then(|| ((radius - away) * (radius + away)).sqrt()).map(|half| [nearest - half, nearest + half])
}

/// The verdict of the cable nearest to its limits, or furthest beyond them; `words` describes cable, number and limit.
pub(super) fn nearest_limit(
    numbers: impl Iterator<Item = f64>,
    limits: &[[f64; 2]],
    words: impl Fn(usize, f64, f64) -> String,
) -> Verdict {
    let mut worst = (f64::MAX, 0, 0.0);
    for (cable, (number, [least, largest])) in numbers.zip(limits).enumerate() {
        let margin = (number - least).min(largest - number);
        if margin < worst.0 {
            worst = (margin, cable, number);
        }
    }
    let (margin, cable, number) = worst;
    match margin < 0.0 {
        true => {
            let [least, largest] = limits[cable];
            let limit = if number > largest { largest } else { least };
            Verdict::failed(margin, words(cable, number, limit), Some(cable))
        }
        false => Verdict::held(margin, Some(cable)),
    }
}
