//! Which effects a robot's file has the keys for.

use super::{Composition, Model, ModelError};
use crate::robot::{LAWS, Robot};

/// The effects that a robot's file supports, and why it does not support the others.
#[derive(Clone, Debug, PartialEq)]
pub struct Supported {
    /// As many effects as the file supports at once; of those that exclude each other the one nearest to a real cable.
    pub richest: Composition,
    /// Effects that the file supports too, each with the effect of the richest composition that stands in its place.
    pub alternatives: Vec<(&'static str, &'static str)>,
    /// Effects that the file does not support, with what is missing.
    pub missing: Vec<(&'static str, ModelError)>,
}

impl Supported {
    /// The composition with an alternative in place of the effect that excludes it.
    pub fn with_alternative(&self, alternative: &str) -> Composition {
        self.richest.with(alternative).unwrap_or(self.richest)
    }
}

impl Composition {
    /// Words of all effects in order along the cable, those together of which a model has one at most, the one nearest to a real cable first.
    fn alternatives() -> [Vec<&'static str>; 4] {
        let laws = LAWS.iter().rev().map(|law| law.word).collect();
        [vec!["pulley"], vec!["drum"], laws, vec!["catenary", "finite-element"]]
    }

    /// The effects that a robot's file supports; an error only for a robot that no composition fits.
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

    /// The built-in example has pulleys of a radius but without a swivel axis, and linear cables.
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
