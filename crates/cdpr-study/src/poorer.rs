//! Machines poorer than their control model: a study of one does not show the errors of effects that a control model
//! leaves out.

use cdpr_model::model::{Composition, SpanEffect};
use cdpr_model::robot::Law;

/// Effects of a control model that the machine lacks or has in a simpler form, in their order along the cable.
///
/// A law of stretch is richer than those before it in the list of all; catenaries and finite elements are two ways to
/// compute the same effect.
pub fn missing_effects(control: Composition, machine: Composition) -> Vec<&'static str> {
    let is_missing = |effect: &&str| match *effect {
        "pulley" => !machine.pulley,
        "drum" => !machine.drum,
        word if Law::named(word).is_some() => machine.stretch.richness() < control.stretch.richness(),
        _ => machine.span == SpanEffect::Straight,
    };
    control.effects().filter(is_missing).collect()
}

/// Remark on a machine that is poorer than its control model; `None` for others.
pub(crate) fn remark_on_poorer(control: Composition, machine: Composition) -> Option<String> {
    let missing = missing_effects(control, machine);
    let effects: Vec<String> = missing.iter().map(|effect| format!("`{effect}`")).collect();
    let (which, them) = match effects.len() {
        0 => return None,
        1 => ("the effect", "it"),
        _ => ("the effects", "them"),
    };
    Some(format!(
        "the machine `{machine}` is poorer than the control model `{control}`: it lacks {which} {}, so the errors are those of a \
         controller that corrects what is not there; give the machine {them} too if it stands for a real robot",
        effects.join(", ")
    ))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn missing(control: &str, machine: &str) -> Vec<&'static str> {
        missing_effects(control.parse().unwrap(), machine.parse().unwrap())
    }

    #[test]
    fn a_machine_as_rich_as_its_control_model_lacks_nothing() {
        for machine in Composition::all() {
            assert!(missing_effects(machine, machine).is_empty(), "{machine}");
            assert!(missing_effects(Composition::STANDARD, machine).is_empty(), "{machine}");
        }
        assert!(missing("elastic", "hysteresis").is_empty());
        assert!(missing("catenary", "finite-element").is_empty());
        assert_eq!(remark_on_poorer(Composition::STANDARD, Composition::ELASTIC), None);
    }

    #[test]
    fn what_a_poorer_machine_lacks_is_named() {
        assert_eq!(missing("pulley+drum+elastic+catenary", "standard"), ["pulley", "drum", "elastic", "catenary"]);
        assert_eq!(missing("hysteresis", "polynomial"), ["hysteresis"]);
        assert_eq!(missing("pulley+elastic", "elastic"), ["pulley"]);
        let remark = remark_on_poorer(Composition::PULLEY_ELASTIC, Composition::PULLEY).unwrap();
        assert!(remark.contains("lacks the effect `elastic`") && !remark.contains("`pulley`,"), "{remark}");
    }
}
