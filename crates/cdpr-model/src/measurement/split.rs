//! Parts of a data set for fitting and validation.

use std::fmt;
use std::str::FromStr;

use rand::SeedableRng;
use rand::seq::SliceRandom;
use rand_chacha::ChaCha8Rng;
use thiserror::Error;

use super::Samples;

/// One division of samples into training and validation; the two share no sample.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fold {
    /// Name of the fold.
    pub name: String,
    /// Indices of the training samples.
    pub train: Vec<usize>,
    /// Indices of the validation samples.
    pub validation: Vec<usize>,
}

/// Method of dividing samples.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Split {
    /// By the column `set`: `train` against `validation` (or `test`).
    Column,
    /// Contiguous blocks in file order, each held out in turn: suited to trajectories.
    Blocks(usize),
    /// Random parts, each held out in turn: suited to independent samples.
    KFold(usize),
    /// Regions of the workspace, each held out in turn: tests the extrapolation of a model.
    Region(usize),
}

/// A split that is not possible.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum SplitError {
    /// Text that cannot be read as a split.
    #[error(
        "cannot read the split `{text}`: write column, blocks:K, kfold:K or region:K with K of 2 or more, e.g. blocks:5"
    )]
    Syntax {
        /// The text.
        text: String,
    },
    /// The data have no column `set`.
    #[error("the data have no column `set` to split by; use blocks:K, kfold:K or region:K, or add the column")]
    NoColumn,
    /// A set name other than `train`, `validation` and `test`.
    #[error("sample {sample}: the set `{name}` is neither `train` nor `validation` (or `test`)")]
    SetName {
        /// Number of the sample, from 1.
        sample: usize,
        /// The name.
        name: String,
    },
    /// One side is empty.
    #[error("the column `set` names no {missing} samples")]
    EmptySide {
        /// Name of the empty side.
        missing: &'static str,
    },
    /// More folds than samples.
    #[error("{folds} folds need at least {folds} samples, there are {samples}")]
    TooManyFolds {
        /// Folds requested.
        folds: usize,
        /// Samples of the data.
        samples: usize,
    },
}

impl FromStr for Split {
    type Err = SplitError;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let syntax = || SplitError::Syntax { text: text.to_owned() };
        let (kind, count) = match text.split_once(':') {
            Some((kind, count)) => (kind, count.parse().ok().filter(|&count: &usize| count >= 2)),
            None => (text, Some(0)),
        };
        let [column, blocks, kfold, region] = Self::KINDS;
        match count {
            Some(0) if kind == column => Ok(Self::Column),
            Some(count) if count > 0 && kind == blocks => Ok(Self::Blocks(count)),
            Some(count) if count > 0 && kind == kfold => Ok(Self::KFold(count)),
            Some(count) if count > 0 && kind == region => Ok(Self::Region(count)),
            _ => Err(syntax()),
        }
    }
}

impl fmt::Display for Split {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Column => f.write_str("column"),
            Self::Blocks(count) => write!(f, "blocks:{count}"),
            Self::KFold(count) => write!(f, "kfold:{count}"),
            Self::Region(count) => write!(f, "region:{count}"),
        }
    }
}

impl Split {
    /// Words of the column `set`: the part that is fitted, and two for the part that is held out.
    pub const SETS: [&'static str; 3] = ["train", "validation", "test"];

    /// Names of the methods; a colon and the number of parts follow all but the first.
    pub const KINDS: [&'static str; 4] = ["column", "blocks", "kfold", "region"];

    /// The given split; by default by the column `set` if it has both sides, otherwise up to five contiguous blocks.
    pub fn or_default(split: Option<Self>, samples: &Samples) -> Self {
        let by_column = || Self::Column.folds(samples, 0).is_ok().then_some(Self::Column);
        split.or_else(by_column).unwrap_or(Self::Blocks(samples.len().clamp(2, 5)))
    }

    /// The split in words, for a sentence.
    pub fn words(self) -> String {
        match self {
            Self::Column => "the rows that the column `set` names".to_owned(),
            Self::Blocks(count) => format!("{count} contiguous blocks, each held out in turn"),
            Self::KFold(count) => format!("{count} random parts, each held out in turn"),
            Self::Region(count) => format!("{count} regions of the workspace, each held out in turn"),
        }
    }

    /// The folds of a data set. `seed` is used by [`Split::KFold`] only.
    pub fn folds(self, samples: &Samples, seed: u64) -> Result<Vec<Fold>, SplitError> {
        let count = samples.len();
        let parts = match self {
            Self::Column => return Ok(vec![by_column(samples)?]),
            Self::Blocks(folds) => {
                check_count(folds, count)?;
                cut((0..count).collect(), folds)
            }
            Self::KFold(folds) => {
                check_count(folds, count)?;
                let mut order: Vec<usize> = (0..count).collect();
                order.shuffle(&mut ChaCha8Rng::seed_from_u64(seed));
                cut(order, folds)
            }
            Self::Region(folds) => {
                check_count(folds, count)?;
                let mut parts = Vec::new();
                regions(samples, (0..count).collect(), folds, &mut parts);
                parts
            }
        };
        let word = if matches!(self, Self::Region(_)) { "region" } else { "fold" };
        Ok((0..parts.len()).map(|held| hold_out(word, held, &parts, count)).collect())
    }
}

fn check_count(folds: usize, samples: usize) -> Result<(), SplitError> {
    if folds <= samples { Ok(()) } else { Err(SplitError::TooManyFolds { folds, samples }) }
}

/// Cuts a list into contiguous parts whose sizes differ by at most one.
fn cut(list: Vec<usize>, parts: usize) -> Vec<Vec<usize>> {
    let bound = |part: usize| part * list.len() / parts;
    (0..parts).map(|part| list[bound(part)..bound(part + 1)].to_vec()).collect()
}

fn hold_out(word: &str, held: usize, parts: &[Vec<usize>], count: usize) -> Fold {
    let mut validation = parts[held].clone();
    validation.sort_unstable();
    let mut is_held = vec![false; count];
    validation.iter().for_each(|&sample| is_held[sample] = true);
    let train = (0..count).filter(|&sample| !is_held[sample]).collect();
    Fold { name: format!("{word} {} of {}", held + 1, parts.len()), train, validation }
}

/// Cuts at the median of the widest axis until there are enough regions, with about equally many samples.
fn regions(samples: &Samples, members: Vec<usize>, count: usize, parts: &mut Vec<Vec<usize>>) {
    if count == 1 {
        parts.push(members);
        return;
    }
    let position = |sample: usize| samples.poses[sample].position;
    let axis = (0..3)
        .max_by(|&a, &b| {
            let extent = |axis: usize| {
                let values = || members.iter().map(|&sample| position(sample)[axis]);
                values().fold(f64::NEG_INFINITY, f64::max) - values().fold(f64::INFINITY, f64::min)
            };
            extent(a).total_cmp(&extent(b))
        })
        .unwrap_or(0);
    let mut sorted = members;
    // equal positions keep file order, so that equal data give equal regions
    sorted.sort_by(|&a, &b| position(a)[axis].total_cmp(&position(b)[axis]).then(a.cmp(&b)));
    let low = count / 2;
    let rest = sorted.split_off(sorted.len() * low / count);
    regions(samples, sorted, low, parts);
    regions(samples, rest, count - low, parts);
}

fn by_column(samples: &Samples) -> Result<Fold, SplitError> {
    let set = samples.set.as_ref().ok_or(SplitError::NoColumn)?;
    let mut fold = Fold { name: "column set".to_owned(), train: Vec::new(), validation: Vec::new() };
    for (sample, name) in set.iter().enumerate() {
        match Split::SETS.iter().position(|word| word == name) {
            Some(0) => fold.train.push(sample),
            Some(_) => fold.validation.push(sample),
            None => return Err(SplitError::SetName { sample: sample + 1, name: name.clone() }),
        }
    }
    match (fold.train.is_empty(), fold.validation.is_empty()) {
        (true, _) => Err(SplitError::EmptySide { missing: "training" }),
        (_, true) => Err(SplitError::EmptySide { missing: "validation" }),
        _ => Ok(fold),
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::Vector3;
    use proptest::prelude::*;

    use super::*;
    use crate::geometry::Pose;
    use cdpr_testing::property;

    fn samples_at(positions: &[f64]) -> Samples {
        let pose = |&x: &f64| Pose { position: Vector3::new(x, -x * x, 0.0), ..Pose::identity() };
        Samples {
            poses: positions.iter().map(pose).collect(),
            lengths: vec![1.0; positions.len()],
            cable_count: 1,
            ..Samples::default()
        }
    }

    proptest! {
        #![proptest_config(property::cases(256))]

        #[test]
        fn every_sample_is_validated_once_and_never_by_its_own_fit(
            positions in proptest::collection::vec(-1.0..1.0_f64, 8..60),
            folds in 2..8_usize,
            seed in any::<u64>(),
        ) {
            let samples = samples_at(&positions);
            for split in [Split::Blocks(folds), Split::KFold(folds), Split::Region(folds)] {
                let mut seen = vec![0; positions.len()];
                for fold in split.folds(&samples, seed).unwrap() {
                    prop_assert!(!fold.validation.is_empty());
                    prop_assert_eq!(fold.train.len() + fold.validation.len(), positions.len());
                    for &sample in &fold.validation {
                        seen[sample] += 1;
                        prop_assert!(!fold.train.contains(&sample));
                    }
                }
                prop_assert!(seen.iter().all(|&count| count == 1));
            }
        }
    }

    #[test]
    fn splits_survive_the_round_trip_and_nonsense_is_refused() {
        for text in ["column", "blocks:5", "kfold:10", "region:4"] {
            assert_eq!(text.parse::<Split>().unwrap().to_string(), text);
        }
        for text in ["", "blocks", "blocks:", "blocks:1", "blocks:-2", "column:3", "thirds:3"] {
            assert!(text.parse::<Split>().is_err(), "{text}");
        }
    }

    #[test]
    fn a_column_that_does_not_part_the_data_is_refused() {
        let mut samples = samples_at(&[0.0, 1.0]);
        assert_eq!(Split::Column.folds(&samples, 0), Err(SplitError::NoColumn));
        let named = |a: &str, b: &str| Some(vec![a.to_owned(), b.to_owned()]);
        samples.set = named("train", "train");
        assert_eq!(Split::Column.folds(&samples, 0), Err(SplitError::EmptySide { missing: "validation" }));
        samples.set = named("train", "wild");
        assert_eq!(Split::Column.folds(&samples, 0), Err(SplitError::SetName { sample: 2, name: "wild".to_owned() }));
        samples.set = named("train", "validation");
        assert_eq!(Split::Column.folds(&samples, 0).unwrap()[0].validation, vec![1]);
    }
}
