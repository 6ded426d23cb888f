//! Effects for which a robot's file has the keys.

use super::{Composition, Model, ModelError};
use crate::robot::{LAWS, Robot};

/// The effects that a robot's file supports, and the reasons that it does not support the others.
#[derive(Clone, Debug, PartialEq)]
pub struct Supported {
    /// All effects that the file supports together; of those that exclude each other, the one nearest to a real cable.
    pub richest: Composition,
    /// Further effects that the file supports, each with the effect of `richest` that it would replace.
    pub alternatives: Vec<(&'static str, &'static str)>,
    /// Effects that the file does not support, with the missing key.
    pub missing: Vec<(&'static str, ModelError)>,
}

impl Supported {
    /// The richest composition with an alternative in place of the effect that excludes it.
    pub fn with_alternative(&self, alternative: &str) -> Composition {
        self.richest.with(alternative).unwrap_or(self.richest)
    }
}

impl Composition {
    /// Names of all effects in order along the cable, in groups of which a model has at most one, the one nearest to a
    /// real cable first.
    fn alternatives() -> [Vec<&'static str>; 4] {
        let laws = LAWS.iter().rev().map(|law| law.word).collect();
        [vec!["pulley"], vec!["drum"], laws, vec!["catenary", "finite-element"]]
    }

    /// The effects that a robot's file supports; an error only if it does not even support the standard model.
    pub fn supported(robot: &Robot) -> Result<Supported, ModelError> {
        Model::new(robot.clone(), Self::STANDARD)?;
        let mut supported = Supported { richest: Self::STANDARD, alternatives: Vec::new(), missing: Vec::new() };
        for group in Self::alternatives() {
            let mut chosen = None;
            for effect in group {
                let with = supported.with_alternative(effect);
                match (Model::new(robot.clone(), with), chosen) {
                    (Err(reason), _) => supported.missing.push((effect, reason)),
                    (Ok(_), Some(stands_in)) => supported.alternatives.push((effect, stands_in)),
                    (Ok(_), None) => {
                        supported.richest = with;
                        chosen = Some(effect);
                    }
                }
            }
        }
        Ok(supported)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::SpanEffect;

    /// The built-in example has pulleys with a radius but without a swivel axis, and linear cables.
    #[test]
    fn what_a_file_lacks_is_named_by_its_key() {
        let mut robot = Robot::builtin("planar-example").unwrap();
        let supported = Composition::supported(&robot).unwrap();
        assert!(supported.richest.is_elastic() && supported.richest.span == SpanEffect::Straight, "{supported:?}");
        let reason = |effect: &str, supported: &Supported| {
            supported.missing.iter().find(|(word, _)| *word == effect).map(|(_, reason)| reason.to_string())
        };
        assert!(reason("catenary", &supported).unwrap().contains("linear_density_kg_per_m"));
        for cable in &mut robot.cables {
            cable.linear_density = Some(0.1);
        }
        let supported = Composition::supported(&robot).unwrap();
        assert!(supported.alternatives.contains(&("finite-element", "catenary")), "{supported:?}");
        assert_eq!(reason("catenary", &supported), None);
        let other = supported.with_alternative("finite-element");
        assert_eq!(other.to_string(), supported.richest.to_string().replace("catenary", "finite-element"));
    }

    #[test]
    fn a_robot_without_cables_supports_nothing() {
        let mut robot = Robot::builtin("planar-example").unwrap();
        robot.cables.clear();
        assert!(Composition::supported(&robot).is_err());
    }
}
