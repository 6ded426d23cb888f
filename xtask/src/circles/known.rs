//! Circles that stay for a while, each with its reason.

/// A use of a file by another one that closes a circle and is allowed for now.
pub(crate) struct Known {
    /// The crate's folder.
    pub(crate) folder: &'static str,
    /// The two files, by their places under `src`.
    pub(crate) from: &'static str,
    pub(crate) to: &'static str,
    pub(crate) reason: &'static str,
}

/// The uses without which no file leads back to itself: none today.
pub(crate) const KNOWN: &[Known] = &[];
