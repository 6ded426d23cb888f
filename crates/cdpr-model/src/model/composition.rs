//! Effects of a model.

use std::fmt;
use std::str::FromStr;

use thiserror::Error;

pub use crate::robot::StretchEffect;
use crate::robot::stretch::registry::law_words;
use crate::robot::{LAWS, Law};

/// The effects of a model; without any it is the standard model with point outlets and rigid, straight cables.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Composition {
    /// Cables leave over swivelling pulleys.
    pub pulley: bool,
    /// Cables are wound on drums with grooves, commanded by motor angles.
    pub drum: bool,
    /// Law of stretch of the cables.
    pub stretch: StretchEffect,
    /// Shape of the cables between outlet and platform.
    pub span: SpanEffect,
}

/// Shape of the cables of a model between outlet and platform.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum SpanEffect {
    /// Straight: cables without weight.
    #[default]
    Straight,
    /// Elastic catenaries.
    Catenary,
    /// Chains of finite elements, with the weight at their nodes.
    FiniteElement,
}

/// Laws that the cables of a model obey, grouped by the method that solves them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Cables {
    /// Straight and rigid: lengths and directions follow from the pose alone.
    Rigid,
    /// Straight and linear: lengths follow from pose and tensions in closed form, and tensions from lengths.
    Linear,
    /// Straight with another law of stretch, solved cable by cable.
    Stretching,
    /// With weight: directions depend on the tensions too.
    Sagging,
}

impl Cables {
    /// True if the pose alone determines the directions of all pulls, so that the balance is linear in the tensions.
    pub fn has_fixed_directions(self) -> bool {
        self != Self::Sagging
    }
}

impl Composition {
    /// Point outlets, rigid straight cables.
    pub const STANDARD: Self =
        Self { pulley: false, drum: false, stretch: StretchEffect::Rigid, span: SpanEffect::Straight };
    /// Swivelling pulleys, rigid straight cables.
    pub const PULLEY: Self = Self { pulley: true, ..Self::STANDARD };
    /// Point outlets, linearly elastic straight cables.
    pub const ELASTIC: Self = Self { stretch: StretchEffect::Linear, ..Self::STANDARD };
    /// Swivelling pulleys, linearly elastic straight cables.
    pub const PULLEY_ELASTIC: Self = Self { pulley: true, ..Self::ELASTIC };

    /// All compositions, simple ones first.
    pub fn all() -> impl Iterator<Item = Self> {
        use SpanEffect::{Catenary, FiniteElement, Straight};
        let switches = [(false, false), (true, false), (false, true), (true, true)];
        [Straight, Catenary, FiniteElement].into_iter().flat_map(move |span| {
            StretchEffect::all().flat_map(move |stretch| {
                switches.into_iter().map(move |(pulley, drum)| Self { pulley, drum, stretch, span })
            })
        })
    }

    /// Number of effects, as a measure of a model's complexity.
    pub fn effect_count(self) -> usize {
        self.effects().count()
    }

    /// True if cables stretch.
    pub fn is_elastic(self) -> bool {
        self.stretch != StretchEffect::Rigid
    }

    /// Laws that the cables obey.
    pub fn cables(self) -> Cables {
        match (self.span, self.stretch) {
            (SpanEffect::Straight, StretchEffect::Rigid) => Cables::Rigid,
            (SpanEffect::Straight, StretchEffect::Linear) => Cables::Linear,
            (SpanEffect::Straight, _) => Cables::Stretching,
            (SpanEffect::Catenary | SpanEffect::FiniteElement, _) => Cables::Sagging,
        }
    }

    /// True if controlled lengths depend on tensions: lengths for winches then need chosen tensions, and limits and
    /// initial values of tensions apply.
    pub fn needs_tensions(self) -> bool {
        self.cables() != Cables::Rigid
    }

    /// Names of the effects on the command line, in their order along the cable.
    pub fn effects(self) -> impl Iterator<Item = &'static str> {
        let stretch = self.stretch.law().map(|law| law.word);
        let span = match self.span {
            SpanEffect::Straight => None,
            SpanEffect::Catenary => Some("catenary"),
            SpanEffect::FiniteElement => Some("finite-element"),
        };
        [self.pulley.then_some("pulley"), self.drum.then_some("drum"), stretch, span].into_iter().flatten()
    }

    /// This composition with one more effect, which replaces an alternative to it; `None` if the word is no effect.
    pub(super) fn with(mut self, word: &str) -> Option<Self> {
        match word {
            "pulley" => self.pulley = true,
            "drum" => self.drum = true,
            "catenary" => self.span = SpanEffect::Catenary,
            "finite-element" => self.span = SpanEffect::FiniteElement,
            _ => self.stretch = Law::named(word)?.effect,
        }
        Some(self)
    }

    /// This composition without one of its effects.
    pub fn without(self, word: &str) -> Self {
        self.effects()
            .filter(|effect| *effect != word)
            .fold(Self::STANDARD, |rest, effect| rest.with(effect).expect("the words of a composition are effects"))
    }
}

impl fmt::Display for Composition {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if *self == Self::STANDARD {
            return f.write_str("standard");
        }
        for (index, word) in self.effects().enumerate() {
            write!(f, "{}{word}", if index > 0 { "+" } else { "" })?;
        }
        Ok(())
    }
}

/// A text that is no composition.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum CompositionError {
    /// An unknown effect.
    #[error("`{found}` is not a model effect; known are {}, joined by `+`", known_effects())]
    Unknown {
        /// The word found.
        found: String,
    },
    /// `standard` joined with effects, a repeated effect, or two that exclude each other.
    #[error(
        "`{found}` does not fit the rest of the composition: `standard` stands alone, an effect stands once, and of {}, as of \
         `catenary` and `finite-element`, one at most",
        law_words("and")
    )]
    Misplaced {
        /// The word that does not fit.
        found: String,
    },
}

/// List of all words of a composition, for messages.
fn known_effects() -> String {
    let laws = LAWS.iter().map(|law| format!("`{}`, ", law.word)).collect::<String>();
    format!("`standard`, `pulley`, `drum`, {laws}`catenary` and `finite-element`")
}

impl FromStr for Composition {
    type Err = CompositionError;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let mut composition = Self::STANDARD;
        let words: Vec<&str> = text.split('+').map(str::trim).collect();
        for &word in &words {
            if word == "standard" && words.len() == 1 {
                break;
            }
            match composition.with(word) {
                // every effect that fits increases the number of effects
                Some(more) if more.effect_count() > composition.effect_count() => composition = more,
                None if word != "standard" => return Err(CompositionError::Unknown { found: word.to_owned() }),
                _ => return Err(CompositionError::Misplaced { found: word.to_owned() }),
            }
        }
        Ok(composition)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn compositions_are_read_and_written() {
        assert_eq!("standard".parse(), Ok(Composition::STANDARD));
        let all: Vec<Composition> = Composition::all().collect();
        assert_eq!(all.len(), 12 * (1 + LAWS.len()));
        for composition in all {
            assert_eq!(composition.to_string().parse(), Ok(composition));
        }
        // the order in which effects are named does not matter
        assert_eq!("elastic + pulley".parse(), Ok(Composition::PULLEY_ELASTIC));
    }

    #[test]
    fn what_cannot_be_composed_is_refused_by_name() {
        for text in [
            "",
            "pully",
            "standard+pulley",
            "pulley+pulley",
            "elastic+standard",
            "elastic+polynomial",
            "catenary+finite-element",
        ] {
            assert!(text.parse::<Composition>().is_err(), "{text}");
        }
        for law in LAWS {
            let reason = "pully".parse::<Composition>().unwrap_err().to_string();
            assert!(reason.contains(&format!("`{}`", law.word)), "{reason}");
        }
    }

    #[test]
    fn an_effect_can_be_left_out() {
        let full: Composition = "pulley+hysteresis+catenary".parse().unwrap();
        assert_eq!(full.without("hysteresis").to_string(), "pulley+catenary");
        assert_eq!(full.without("drum"), full);
    }
}
