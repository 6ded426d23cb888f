//! Parts of a data set.

/// One way to part samples into training and validation.
#[derive(Clone, Debug, PartialEq)]
pub struct Fold {
    /// Name for people.
    pub name: String,
    /// Indices of the samples to fit.
    pub train: Vec<usize>,
    /// Indices of the samples to judge by.
    pub validation: Vec<usize>,
}
