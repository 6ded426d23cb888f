//! Plain names of candidates, for headlines and tables: "elastic · frame and platform anchors, offsets, stiffness, load (70)".

use super::Candidate;
use cdpr_model::model::{Composition, FreeParameters};

impl Candidate {
    /// Name in plain words, with the number of its parameters where that is known.
    pub fn label(&self, parameters: Option<usize>) -> String {
        plain_name(self.composition, &self.free, parameters)
    }
}

/// Effects and free parameters in plain words, with their number where it is known.
pub fn plain_name(composition: Composition, free: &FreeParameters, parameters: Option<usize>) -> String {
    let model = model_words(composition);
    let count = parameters.filter(|count| *count > 0).map_or_else(String::new, |count| format!(" ({count})"));
    match free.plain_words() {
        empty if empty.is_empty() => format!("{model} · as given"),
        free => format!("{model} · {free}{count}"),
    }
}

/// Effects in plain words, in their order along the cable.
fn model_words(composition: Composition) -> String {
    let words: Vec<String> = composition
        .effects()
        .map(|effect| match effect {
            "pulley" => "pulleys".to_owned(),
            "drum" => "drums".to_owned(),
            "catenary" => "sag".to_owned(),
            "finite-element" => "sag by finite elements".to_owned(),
            law => law.replace('-', " "),
        })
        .collect();
    if words.is_empty() { "rigid".to_owned() } else { words.join(", ") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn candidates_are_named_as_people_say_them() {
        for (name, count, expected) in [
            ("standard", Some(0), "rigid · as given"),
            ("standard:length-offset", Some(8), "rigid · offsets (8)"),
            ("pulley", None, "pulleys · as given"),
            (
                "elastic:frame-anchor,platform-anchor,length-offset,compliance,wrench",
                Some(70),
                "elastic · frame and platform anchors, offsets, stiffness, load (70)",
            ),
            ("pulley+elastic+catenary:compliance,wrench", None, "pulleys, elastic, sag · stiffness, load"),
        ] {
            let candidate: Candidate = name.parse().unwrap();
            assert_eq!(candidate.label(count), expected);
        }
    }

    /// Labels of the default ladder differ as the names do.
    #[test]
    fn no_two_candidates_of_a_ladder_share_a_label() {
        use crate::candidate::{KnownTensions, Ladder, PlatformAnchors, defaults};
        let robot =
            cdpr_model::robot::Robot::builtin("cablerobot-simulator-helicopter-elastostatic-calibrated").unwrap();
        let ladder =
            defaults(&robot, Ladder { tensions: KnownTensions::Recorded, platform_anchors: PlatformAnchors::Free });
        let labels: std::collections::BTreeSet<String> = ladder.iter().map(|own| own.label(None)).collect();
        assert_eq!(labels.len(), ladder.len(), "{labels:?}");
    }
}
