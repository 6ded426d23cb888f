//! Laws of stretch by their effect and name, and their numbers.

use cdpr_core::cable::stretch::Stretch;

use super::StretchError;
pub use super::entries::{LAWS, Law, StretchEffect};
pub use super::numbers::LawNumber;
use crate::robot::Cable;

impl Law {
    /// The law with this name.
    pub fn named(word: &str) -> Option<&'static Self> {
        LAWS.iter().find(|law| law.word == word)
    }

    /// The law with the numbers of a cable; `None` if its file states none of them.
    pub(crate) fn of(&self, cable: &Cable) -> Result<Option<Stretch>, StretchError> {
        (self.law)(cable)
    }

    /// Number of values that it needs for a cable, from identification or a test bench.
    pub fn number_count(&self, cable: &Cable) -> usize {
        (self.count)(cable)
    }

    /// Gives a cable plausible numbers of the law, from an axial stiffness (N), for tests of every law on one robot.
    pub fn exemplify(&self, cable: &mut Cable, stiffness: f64) {
        (self.sample)(cable, stiffness);
    }
}

impl StretchEffect {
    /// All effects, simple ones first.
    pub(crate) fn all() -> impl Iterator<Item = Self> {
        std::iter::once(Self::Rigid).chain(LAWS.iter().map(|law| law.effect))
    }

    /// Its law; `None` for rigid cables.
    pub(crate) fn law(self) -> Option<&'static Law> {
        LAWS.iter().find(|law| law.effect == self)
    }

    /// Rank in the list of laws, which describe real cables ever more closely; 0 for rigid cables.
    pub fn richness(self) -> usize {
        LAWS.iter().position(|law| law.effect == self).map_or(0, |place| place + 1)
    }

    /// True if tensions depend on earlier strains.
    pub fn remembers(self) -> bool {
        self.law().is_some_and(|law| law.remembers)
    }
}

/// Names of all laws in a list, the last one after this conjunction.
pub fn law_words(conjunction: &str) -> String {
    let words: Vec<String> = LAWS.iter().map(|law| format!("`{}`", law.word)).collect();
    match words.split_last() {
        Some((last, [])) => last.clone(),
        Some((last, others)) => format!("{} {conjunction} {last}", others.join(", ")),
        None => String::new(),
    }
}

/// Numbers of all laws that are plain keys of a cable.
#[cfg(any(feature = "files", test))]
pub(crate) fn law_numbers() -> impl Iterator<Item = &'static LawNumber> {
    LAWS.iter().flat_map(|law| law.numbers)
}

/// A number of a law of stretch that is a parameter of every cable, by the indices of the law and of the number in it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct StretchNumber {
    law: usize,
    place: usize,
}

impl StretchNumber {
    /// Total number of numbers of all laws.
    pub(crate) const COUNT: usize = {
        let (mut count, mut law) = (0, 0);
        while law < LAWS.len() {
            count += LAWS[law].numbers.len();
            law += 1;
        }
        count
    };

    /// The number at an index below [`StretchNumber::COUNT`] among those of all laws.
    pub(crate) const fn at(mut place: usize) -> Self {
        let mut law = 0;
        while place >= LAWS[law].numbers.len() {
            place -= LAWS[law].numbers.len();
            law += 1;
        }
        Self { law, place }
    }

    /// The law of the number.
    pub(crate) fn law(self) -> &'static Law {
        &LAWS[self.law]
    }

    /// Index among the numbers of its law, from 0.
    pub(crate) fn place(self) -> usize {
        self.place
    }

    /// Name, key and unit.
    pub fn entry(self) -> &'static LawNumber {
        &self.law().numbers[self.place]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Names and keys are unique, and the numbers of every law are found by their index.
    #[test]
    fn every_law_has_a_word_keys_and_numbers_of_its_own() {
        for law in LAWS {
            assert_eq!(Law::named(law.word).unwrap().effect, law.effect);
            assert!(law.effect.law().is_some() && !law.keys.is_empty(), "{}", law.word);
            assert!(law.numbers.iter().all(|number| law.keys.contains(&number.key)), "{}", law.word);
        }
        let mut keys: Vec<&str> = LAWS.iter().flat_map(|law| law.keys.iter().copied()).collect();
        let count = keys.len();
        keys.sort_unstable();
        keys.dedup();
        assert_eq!(keys.len(), count);
        for (place, number) in law_numbers().enumerate() {
            let found = StretchNumber::at(place);
            assert_eq!((found.entry(), &found.law().numbers[found.place()]), (number, number));
        }
        assert_eq!(StretchEffect::Rigid.richness(), 0);
        assert!(StretchEffect::Hysteresis.richness() > StretchEffect::Linear.richness());
    }

    /// The sample of a law gives a cable that law, and the error for a robot without it names its first key.
    #[test]
    fn a_cable_has_the_law_whose_numbers_it_is_given() {
        for law in LAWS {
            let mut cable = Cable::default();
            assert_eq!(law.of(&cable), Ok(None), "{}", law.word);
            law.exemplify(&mut cable, 1e6);
            let stretch = law.of(&cable).unwrap().unwrap();
            let (strain, slope) = stretch.strain(2000.0);
            assert!(strain > 0.0 && slope > 0.0 && !stretch.is_rigid(), "{}", law.word);
            assert!(law.number_count(&cable) > 0);
            assert_eq!(stretch.memory().is_some(), law.remembers);
        }
    }
}
