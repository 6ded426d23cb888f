//! Effects and parameters that no candidate of a comparison has.

use crate::candidate::Candidate;
use cdpr_model::model::{Composition, Model, SpanEffect, StretchEffect, missing_effect};
use cdpr_model::robot::{ParameterKind, Robot};

/// An effect of cables: its name, how to see it in a composition, and the simplest composition that has it.
type Effect = (&'static str, fn(&Composition) -> bool, Composition);

const EFFECTS: [Effect; 3] = [
    ("pulleys", |composition| composition.pulley, Composition::PULLEY),
    ("elasticity", |composition| composition.stretch != StretchEffect::Rigid, Composition::ELASTIC),
    (
        "sag",
        |composition| composition.span != SpanEffect::Straight,
        Composition { span: SpanEffect::Catenary, ..Composition::ELASTIC },
    ),
];

/// Each in words, with the reason where robot file or data forbid it.
pub(super) fn untried(robot: &Robot, candidates: &[Candidate], has_tensions: bool) -> Vec<String> {
    let has = |effect: &Effect| candidates.iter().any(|candidate| effect.1(&candidate.composition));
    let mut words: Vec<String> =
        EFFECTS.iter().filter(|effect| !has(effect)).map(|effect| effect_words(robot, has_tensions, effect)).collect();
    let frees = |kind: &ParameterKind| candidates.iter().any(|candidate| candidate.free.names(*kind));
    let belongs = |kind: &ParameterKind| {
        let is_read = |of: Composition| (of.drum || !kind.needs_motor_angles()) && !kind.needs_swivels();
        let is_of = |of: Composition| missing_effect(*kind, of).is_none() && is_read(of);
        candidates.iter().any(|candidate| is_of(candidate.composition))
    };
    // a free wrench is the whole load
    let repeats_wrench = |kind: &ParameterKind| kind.is_of_load() && frees(&ParameterKind::Wrench);
    let is_untried = |kind: &ParameterKind| belongs(kind) && !frees(kind) && !repeats_wrench(kind);
    let kinds = ParameterKind::IDENTIFIED.into_iter().filter(is_untried);
    let kinds: Vec<String> = kinds.map(|kind| format!("`{kind}`")).collect();
    if !kinds.is_empty() {
        words.push(format!("{} as free parameters", kinds.join(", ")));
    }
    words
}

fn effect_words(robot: &Robot, has_tensions: bool, (name, _, composition): &Effect) -> String {
    match Model::new(robot.clone(), *composition) {
        Err(error) => format!("{name} ({error})"),
        Ok(_) if composition.needs_tensions() && !has_tensions => {
            format!("{name} (the data have no tensions)")
        }
        Ok(_) => (*name).to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::candidate::parse_list;

    #[test]
    fn what_the_file_lacks_what_the_data_lack_and_what_nobody_freed_are_named() {
        let words = |robot: &str, candidates: &str, has_tensions| {
            untried(&Robot::builtin(robot).unwrap(), &parse_list(candidates).unwrap(), has_tensions)
        };
        let planar = words("planar-example", "standard;standard:length-offset", false);
        assert!(planar[0].starts_with("pulleys (") && planar[0].contains("pulley_swivel_axis"), "{planar:?}");
        assert_eq!(planar[1], "elasticity (the data have no tensions)");
        assert_eq!(planar.last().unwrap(), "`frame-anchor`, `platform-anchor`, `length-scale` as free parameters");
        let elastic = words("planar-example", "standard;elastic:frame-anchor,compliance,wrench", true);
        assert!(!elastic.iter().any(|words| words.starts_with("elasticity")), "{elastic:?}");
        assert!(elastic.last().unwrap().contains("`hidden-length`"), "{elastic:?}");
    }
}
