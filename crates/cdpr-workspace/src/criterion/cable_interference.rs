//! Cables that keep a distance from each other.

use super::cables::{named, not_negative, per_cable, straight};
use super::clearance::Segment;
use super::{Criterion, Verdict};
use crate::WorkspaceError;
use cdpr_model::geometry::Pose;
use cdpr_model::model::Model;

/// The free parts of any two cables keep apart: the distance of their axes is at least half of both diameters
/// (`diameter_m`) plus the clearance (Merlet 2004; Perreault et al. 2010).
///
/// Cables are straight lines from outlet to platform anchor, without sag. Two that share a frame anchor or a platform
/// anchor meet there by design and are not compared. The margin (m) is the least distance left. Cables of a planar
/// robot count as lying in one plane; if two cross, the margin is minus the length by which they have to be pulled
/// apart.
#[derive(Clone, Debug)]
pub(crate) struct CableInterference<'a> {
    model: &'a Model,
    pairs: Vec<Pair>,
    clearance: f64,
}

/// Two cables (from 0) and the least distance between their axes (m).
#[derive(Clone, Copy, Debug)]
struct Pair {
    cables: [usize; 2],
    radii: f64,
}

const NAME: &str = "cable-interference";

impl<'a> CableInterference<'a> {
    /// The criterion for a clearance between the cables' surfaces (m), with one diameter for all cables (m) or else
    /// those of the file.
    pub(crate) fn new(model: &'a Model, clearance: f64, diameter: Option<f64>) -> Result<Self, WorkspaceError> {
        let robot = model.robot();
        not_negative(NAME, "clearance", clearance, "it is a finite length of 0 or more (m)")?;
        let diameters = per_cable(robot, NAME, "diameter_m", diameter, |cable| cable.diameter)?;
        for &diameter in &diameters {
            not_negative(NAME, "diameter", diameter, "it is a finite length of 0 or more (m)")?;
        }
        let mut pairs = Vec::new();
        for (first, a) in robot.cables.iter().enumerate() {
            for (second, b) in robot.cables.iter().enumerate().skip(first + 1) {
                if a.frame_anchor != b.frame_anchor && a.platform_anchor != b.platform_anchor {
                    let radii = 0.5 * (diameters[first] + diameters[second]);
                    pairs.push(Pair { cables: [first, second], radii });
                }
            }
        }
        Ok(Self { model, pairs, clearance })
    }

    fn distance(&self, cables: &[Segment], pair: &Pair) -> f64 {
        let [a, b] = pair.cables.map(|cable| cables[cable]);
        match self.model.robot().motion_pattern.is_planar() {
            true => a.distance_in_plane(&b),
            false => a.distance(&b),
        }
    }
}

impl Criterion for CableInterference<'_> {
    fn name(&self) -> &str {
        NAME
    }

    fn unit(&self) -> &str {
        "m"
    }

    fn judge(&self, pose: &Pose) -> Verdict {
        let cables = match straight(self.model, pose) {
            Ok(cables) => cables,
            Err(verdict) => return verdict,
        };
        let left = |pair: &Pair| self.distance(&cables, pair) - pair.radii - self.clearance;
        let margins = self.pairs.iter().map(|pair| (left(pair), pair));
        let Some((margin, pair)) = margins.min_by(|a, b| a.0.total_cmp(&b.0)) else {
            // every two cables share an anchor
            return Verdict::held(f64::MAX, None);
        };
        let [first, second] = pair.cables;
        if margin >= 0.0 {
            return Verdict::held(margin, Some(first));
        }
        let [one, other] = [first, second].map(|cable| named(self.model.robot(), cable));
        let (distance, needed) = (1e3 * self.distance(&cables, pair), 1e3 * (pair.radii + self.clearance));
        let words = match distance < 0.0 {
            true => format!("{one} and {other} cross"),
            false => format!(
                "{one} and {other} come within {distance:.1} mm of each other; half diameters and clearance are {needed:.1} mm"
            ),
        };
        Verdict::failed(margin, words, Some(first))
    }
}
