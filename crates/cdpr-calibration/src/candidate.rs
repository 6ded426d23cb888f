//! Control models to choose from.

mod label;

pub use label::plain_name;

use std::fmt;
use std::str::FromStr;

use thiserror::Error;

use crate::fit::Prior;
use crate::residual::balance::start::follow_from_statics;
use cdpr_model::cable::elasticity::linear_elasticity;
use cdpr_model::measurement::Samples;
use cdpr_model::model::{Composition, CompositionError, FreeParameters, Model, ParameterError, SpanEffect};
use cdpr_model::robot::{ParameterKind, Robot};

/// A composition of effects with the parameters that identification frees.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Candidate {
    /// The effects.
    pub composition: Composition,
    /// Free parameters.
    pub free: FreeParameters,
}

/// A candidate that cannot be understood.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum CandidateError {
    /// The part before the colon.
    #[error("candidate `{text}`: {reason}")]
    Composition {
        /// The candidate.
        text: String,
        /// Mistake in the effects.
        reason: CompositionError,
    },
    /// The part after the colon.
    #[error("candidate `{text}`: {reason}")]
    Parameters {
        /// The candidate.
        text: String,
        /// Mistake in the parameters.
        reason: ParameterError,
    },
    /// Nothing between separators.
    #[error("there is no candidate in `{text}`: write MODEL or MODEL:FREE, separated by semicolons")]
    Empty {
        /// The list.
        text: String,
    },
}

impl FromStr for Candidate {
    type Err = CandidateError;

    /// Reads `MODEL` or `MODEL:FREE`.
    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let (composition, free) = text.split_once(':').unwrap_or((text, ""));
        let composition = composition
            .trim()
            .parse()
            .map_err(|reason| CandidateError::Composition { text: text.to_owned(), reason })?;
        let free = free.parse().map_err(|reason| CandidateError::Parameters { text: text.to_owned(), reason })?;
        Ok(Self { composition, free })
    }
}

impl fmt::Display for Candidate {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.free.is_empty() {
            true => write!(f, "{}", self.composition),
            false => write!(f, "{}:{}", self.composition, self.free),
        }
    }
}

/// Reads `MODEL[:FREE];…`, from simple to complex.
pub fn parse_list(text: &str) -> Result<Vec<Candidate>, CandidateError> {
    let items: Vec<&str> = text.split(';').map(str::trim).filter(|item| !item.is_empty()).collect();
    if items.is_empty() {
        return Err(CandidateError::Empty { text: text.to_owned() });
    }
    items.into_iter().map(str::parse).collect()
}

/// Conditions that decide which rungs the default ladder has.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Ladder {
    /// How tensions are known: elastic models join where they are and the robot's file states stiffness.
    pub tensions: KnownTensions,
    /// Platform anchors that may be free.
    pub platform_anchors: PlatformAnchors,
}

/// How the tensions of samples are known.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum KnownTensions {
    /// Not at all.
    #[default]
    Unknown,
    /// By recorded columns.
    Recorded,
    /// By the known load that no more cables than degrees of freedom hold; the load is not free then.
    ByStatics,
}

impl KnownTensions {
    /// Those of samples of a robot.
    pub fn of(robot: &Robot, samples: &Samples) -> Self {
        match Model::new(robot.clone(), Composition::STANDARD) {
            _ if samples.tensions.is_some() => Self::Recorded,
            Ok(model) if follow_from_statics(&model, samples) => Self::ByStatics,
            _ => Self::Unknown,
        }
    }
}

/// Rungs of the default ladder that free platform anchors.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum PlatformAnchors {
    /// None.
    #[default]
    Held,
    /// The largest elastic models, with a prior that is assumed ([`assumed_prior`]).
    Elastic,
    /// The largest rigid and elastic models, with a prior that is given.
    Free,
}

/// Share of the platform's radius by which its anchors are assumed to lie off the file, and the least and most of it (m).
const ASSUMED_SHARE: f64 = 0.1;
const ASSUMED_RANGE: (f64, f64) = (5e-3, 0.1);

/// Prior of platform anchors that the default ladder assumes where none is given: a tenth of the platform's radius, from 5 to 100 mm; `None` for platforms
/// that do not turn, whose anchors repeat those of the frame.
pub fn assumed_prior(model: &Model) -> Option<Prior> {
    let sigma = (ASSUMED_SHARE * model.platform_radius()).clamp(ASSUMED_RANGE.0, ASSUMED_RANGE.1);
    let turns = model.robot().motion_pattern.has_rotation();
    turns.then_some(Prior { kind: ParameterKind::PlatformAnchor, sigma })
}

/// The default ladder for a robot, from simple to complex: as given, offsets, offsets and scales, anchors, anchors with
/// offsets, with both, frame and platform anchors; then elastic models as given, with compliance and wrench, with offsets and with anchors too. Every
/// rung also with pulleys where the robot's file describes them, and every elastic one with sag where it states the weight of
/// the cables.
///
/// Scales join no platform anchors: data hardly tell the two apart. Platform anchors join rungs as [`Ladder::platform_anchors`] says: where the
/// orientation varies little, they only repeat the frame anchors, and a prior keeps them near the file.
pub fn defaults(robot: &Robot, ladder: Ladder) -> Vec<Candidate> {
    use ParameterKind::{Compliance, FrameAnchor, LengthOffset, LengthScale, PlatformAnchor, PulleyRadius, Wrench};
    let has_pulleys =
        robot.cables.iter().all(|cable| cable.pulley_swivel_axis().is_some() && cable.pulley_radius().is_some());
    let is_elastic = robot.cables.iter().all(|cable| linear_elasticity(cable).is_some_and(|law| !law.is_rigid()));
    let has_weight = robot.gravity.is_some() && robot.cables.iter().all(|cable| cable.linear_density.is_some());
    let rigid: [(&[ParameterKind], &[&[ParameterKind]]); 8] = [
        (&[], &[&[], &[PulleyRadius]]),
        (&[LengthOffset], &[&[LengthOffset], &[LengthOffset, PulleyRadius]]),
        (&[LengthOffset, LengthScale], &[&[LengthOffset, LengthScale]]),
        (&[FrameAnchor], &[&[FrameAnchor]]),
        (&[FrameAnchor, LengthOffset], &[&[FrameAnchor, LengthOffset]]),
        (&[FrameAnchor, LengthOffset, LengthScale], &[&[FrameAnchor, LengthOffset, LengthScale]]),
        (&[FrameAnchor, PlatformAnchor], &[&[FrameAnchor, PlatformAnchor]]),
        (&[FrameAnchor, PlatformAnchor, LengthOffset], &[&[FrameAnchor, PlatformAnchor, LengthOffset]]),
    ];
    let elastic: [&[ParameterKind]; 7] = [
        &[],
        &[Compliance, Wrench],
        &[LengthOffset, Compliance, Wrench],
        &[FrameAnchor, Compliance, Wrench],
        &[FrameAnchor, LengthOffset, Compliance, Wrench],
        &[FrameAnchor, PlatformAnchor, Compliance, Wrench],
        &[FrameAnchor, PlatformAnchor, LengthOffset, Compliance, Wrench],
    ];
    let candidate = |composition, free: &[ParameterKind]| Candidate { composition, free: FreeParameters::of(free) };
    let is_held = |free: &[ParameterKind], is_elastic: bool| {
        let may_be_free = match ladder.platform_anchors {
            PlatformAnchors::Held => false,
            PlatformAnchors::Elastic => is_elastic,
            PlatformAnchors::Free => true,
        };
        free.contains(&PlatformAnchor) && !may_be_free
    };
    let mut rungs = Vec::new();
    for (standard, pulley) in rigid {
        if is_held(standard, false) {
            continue;
        }
        rungs.push(candidate(Composition::STANDARD, standard));
        rungs.extend(pulley.iter().filter(|_| has_pulleys).map(|free| candidate(Composition::PULLEY, free)));
    }
    if ladder.tensions != KnownTensions::Unknown && is_elastic {
        for free in elastic {
            if is_held(free, true) {
                continue;
            }
            let is_free = |kind: &&ParameterKind| ladder.tensions == KnownTensions::Recorded || **kind != Wrench;
            let free: Vec<ParameterKind> = free.iter().filter(is_free).copied().collect();
            let free = free.as_slice();
            rungs.push(candidate(Composition::ELASTIC, free));
            rungs.extend(has_pulleys.then(|| candidate(Composition::PULLEY_ELASTIC, free)));
            // a cable that weighs something is worth one try for each set of parameters, over pulleys where there are any
            let base = if has_pulleys { Composition::PULLEY_ELASTIC } else { Composition::ELASTIC };
            let sagging = Composition { span: SpanEffect::Catenary, ..base };
            rungs.extend(has_weight.then(|| candidate(sagging, free)));
        }
    }
    rungs
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn candidates_survive_the_round_trip() {
        let text = "standard;standard:length-offset;pulley:pulley-radius[1,2],frame-anchor";
        let list = parse_list(text).unwrap();
        let again: Vec<String> = list.iter().map(ToString::to_string).collect();
        assert_eq!(again.join(";"), text);
    }

    #[test]
    fn platform_anchors_are_free_where_they_have_a_prior() {
        let robot = Robot::builtin("cablerobot-simulator-helicopter-elastostatic-calibrated").unwrap();
        let rungs = |platform_anchors| defaults(&robot, Ladder { tensions: KnownTensions::Recorded, platform_anchors });
        let freeing = |platform_anchors| -> Vec<String> {
            let rungs = rungs(platform_anchors).into_iter();
            let frees = rungs.filter(|candidate| candidate.free.names(ParameterKind::PlatformAnchor));
            frees.map(|candidate| candidate.to_string()).collect()
        };
        assert!(freeing(PlatformAnchors::Held).is_empty());
        let (assumed, given) = (freeing(PlatformAnchors::Elastic), freeing(PlatformAnchors::Free));
        assert!(given.contains(&"standard:frame-anchor,platform-anchor".to_owned()), "{given:?}");
        assert!(!assumed.is_empty() && assumed.iter().all(|name| name.contains("elastic")), "{assumed:?}");
        assert_eq!(rungs(PlatformAnchors::Free).len(), rungs(PlatformAnchors::Held).len() + given.len());
    }

    /// A tenth of the radius, from 5 to 100 mm; a point has no anchors on a platform.
    #[test]
    fn platform_anchors_are_assumed_within_a_tenth_of_the_radius() {
        let prior = |scale: f64, name: &str| {
            let mut robot = Robot::builtin(name).unwrap();
            robot.cables.iter_mut().for_each(|cable| cable.platform_anchor *= scale);
            let model = Model::new(robot, Composition::STANDARD).unwrap();
            (model.platform_radius(), assumed_prior(&model).map(|prior| prior.sigma))
        };
        let (radius, sigma) = prior(0.1, "cogiro");
        assert_eq!(sigma, Some((0.1 * radius).max(5e-3)), "{radius}");
        assert_eq!(prior(1e-3, "cogiro").1, Some(5e-3));
        assert_eq!(prior(100.0, "cogiro").1, Some(0.1));
        assert_eq!(prior(1.0, "planar-example").1, None);
    }

    #[test]
    fn nonsense_is_refused_with_the_candidate_named() {
        for text in ["", ";", "standart", "standard:frame", "standard:"] {
            match parse_list(text) {
                Err(error) => assert!(!error.to_string().is_empty()),
                Ok(list) => assert_eq!(text, "standard:", "{list:?}"),
            }
        }
    }
}
