//! Samples parted into those of the fits and those of the validation.

use cdpr_model::measurement::{DataError, Fold, InternalSamples, Samples, Split, SplitError};

/// Samples, folds and words for the way validation data were chosen.
pub struct DataDivision {
    /// All samples.
    pub samples: Samples,
    /// The samples where their poses are not measured.
    pub internal: Option<InternalSamples>,
    /// How many of the samples are of the first file.
    pub data_count: usize,
    /// Parts of the samples.
    pub folds: Vec<Fold>,
    /// How validation data were chosen.
    pub words: String,
}

impl DataDivision {
    /// Training and validation data from two files, the second with this name.
    pub fn of_two_files(train: &Samples, validation: &Samples, name: &str) -> Result<Self, DataError> {
        let samples = train.followed_by(validation)?;
        let fold = Fold {
            name: name.to_owned(),
            train: (0..train.len()).collect(),
            validation: (train.len()..samples.len()).collect(),
        };
        let words = format!("{} samples of {name}", validation.len());
        Ok(Self { samples, internal: None, data_count: train.len(), folds: vec![fold], words })
    }

    /// Training and validation data from one file: by the split asked for, else by the column `set` where it tells, else by five contiguous blocks.
    pub fn of_one_file(samples: Samples, split: Option<Split>, seed: u64) -> Result<Self, SplitError> {
        let split = Split::or_default(split, &samples);
        let folds = split.folds(&samples, seed)?;
        Ok(Self { data_count: samples.len(), internal: None, samples, folds, words: split.words() })
    }
}
