//! Control models to choose from.

use std::fmt;
use std::str::FromStr;

use thiserror::Error;

use cdpr_model::cable::elasticity::linear_elasticity;
use cdpr_model::model::{Composition, CompositionError, FreeParameters, ParameterError, SpanEffect};
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
    /// The data have recorded tensions: elastic models join where the robot's file states stiffness.
    pub with_tensions: bool,
    /// Platform anchors have a prior: the largest rigid and the elastic models may free them.
    pub with_platform_anchors: bool,
}

/// The default ladder for a robot, from simple to complex: as given, offsets, offsets and scales, anchors, anchors with
/// offsets, with both, frame and platform anchors; then elastic models as given, with compliance and wrench, with offsets and with anchors too. Every
/// rung also with pulleys where the robot's file describes them, and every elastic one with sag where it states the weight of
/// the cables.
///
/// Scales join no platform anchors: data hardly tell the two apart. Platform anchors stay out of it unless they have a prior
/// ([`Ladder::with_platform_anchors`]): where the orientation varies little, they only repeat the frame
/// anchors.
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
    let candidate = |composition, free| Candidate { composition, free: FreeParameters::of(free) };
    let needs_prior = |free: &[ParameterKind]| free.contains(&PlatformAnchor) && !ladder.with_platform_anchors;
    let mut rungs = Vec::new();
    for (standard, pulley) in rigid {
        if needs_prior(standard) {
            continue;
        }
        rungs.push(candidate(Composition::STANDARD, standard));
        rungs.extend(pulley.iter().filter(|_| has_pulleys).map(|free| candidate(Composition::PULLEY, free)));
    }
    if ladder.with_tensions && is_elastic {
        for free in elastic {
            if needs_prior(free) {
                continue;
            }
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
        let robot = Robot::builtin("cogiro").unwrap();
        let rungs = |with_platform_anchors| defaults(&robot, Ladder { with_tensions: false, with_platform_anchors });
        let frees = |candidate: &&Candidate| candidate.free.names(ParameterKind::PlatformAnchor);
        assert_eq!(rungs(false).iter().filter(frees).count(), 0);
        let names: Vec<String> = rungs(true).iter().filter(frees).map(ToString::to_string).collect();
        assert!(names.contains(&"standard:frame-anchor,platform-anchor".to_owned()), "{names:?}");
        assert_eq!(rungs(true).len(), rungs(false).len() + names.len());
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
