//! Which effects a model has.

use std::fmt;
use std::str::FromStr;

use thiserror::Error;

/// The effects of a model; without any it is the standard model of point outlets and rigid, straight cables.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Composition {
    /// Cables leave over swivelling pulleys.
    pub pulley: bool,
    /// Cables stretch (linear elasticity).
    pub elastic: bool,
}

impl Composition {
    /// Point outlets, rigid straight cables.
    pub const STANDARD: Self = Self { pulley: false, elastic: false };
    /// Swivelling pulleys, rigid straight cables.
    pub const PULLEY: Self = Self { pulley: true, elastic: false };
    /// Point outlets, elastic straight cables.
    pub const ELASTIC: Self = Self { pulley: false, elastic: true };
    /// Swivelling pulleys, elastic straight cables.
    pub const PULLEY_ELASTIC: Self = Self { pulley: true, elastic: true };

    /// Number of effects: the first measure of how complex a model is.
    pub fn effect_count(self) -> usize {
        usize::from(self.pulley) + usize::from(self.elastic)
    }
}

impl fmt::Display for Composition {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match (self.pulley, self.elastic) {
            (false, false) => "standard",
            (true, false) => "pulley",
            (false, true) => "elastic",
            (true, true) => "pulley+elastic",
        })
    }
}

/// A composition that cannot be understood.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum CompositionError {
    /// Not an effect.
    #[error("`{found}` is not a model effect; known are `standard`, `pulley` and `elastic`, joined by `+`")]
    Unknown {
        /// The word found.
        found: String,
    },
    /// An effect of the contract that this version does not have.
    #[error("the effect `{found}` is not part of this version; it has `standard`, `pulley` and `elastic`")]
    NotYet {
        /// The effect asked for.
        found: String,
    },
    /// `standard` joined with effects, or an effect twice.
    #[error("`{found}` does not fit the rest of the composition: `standard` stands alone, an effect stands once")]
    Misplaced {
        /// The word that does not fit.
        found: String,
    },
}

/// Effects of the command-line contract that later versions bring.
const LATER_EFFECTS: [&str; 5] = ["drum", "polynomial", "hysteresis", "catenary", "finite-element"];

impl FromStr for Composition {
    type Err = CompositionError;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let mut composition = Self::STANDARD;
        let words: Vec<&str> = text.split('+').map(str::trim).collect();
        for &word in &words {
            match word {
                "standard" if words.len() == 1 => {}
                "pulley" if !composition.pulley => composition.pulley = true,
                "elastic" if !composition.elastic => composition.elastic = true,
                "standard" | "pulley" | "elastic" => {
                    return Err(CompositionError::Misplaced { found: word.to_owned() });
                }
                later if LATER_EFFECTS.contains(&later) => {
                    return Err(CompositionError::NotYet { found: later.to_owned() });
                }
                unknown => return Err(CompositionError::Unknown { found: unknown.to_owned() }),
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
        for text in ["standard", "pulley", "elastic", "pulley+elastic"] {
            assert_eq!(text.parse::<Composition>().unwrap().to_string(), text);
        }
        // the order in which effects are named means nothing
        assert_eq!("elastic + pulley".parse(), Ok(Composition::PULLEY_ELASTIC));
    }

    #[test]
    fn what_cannot_be_composed_is_refused_by_name() {
        for text in ["", "pully", "standard+pulley", "pulley+pulley", "elastic+standard", "pulley+drum"] {
            assert!(text.parse::<Composition>().is_err(), "{text}");
        }
    }
}
