//! Tables of laws: constants of a program without a heap, or allocated once and shared.

use core::fmt;
use core::ops::Deref;
#[cfg(feature = "std")]
use std::sync::Arc;

/// Entries that many cables read; a copy shares them.
#[derive(Clone)]
pub enum Table<T: 'static> {
    /// A constant of the program: generated code, control kernels.
    Constant(&'static [T]),
    /// Allocated once, when a robot was read.
    #[cfg(feature = "std")]
    Shared(Arc<[T]>),
}

impl<T> Deref for Table<T> {
    type Target = [T];

    #[inline]
    fn deref(&self) -> &[T] {
        match self {
            Self::Constant(entries) => entries,
            #[cfg(feature = "std")]
            Self::Shared(entries) => entries,
        }
    }
}

impl<T: fmt::Debug> fmt::Debug for Table<T> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.debug_list().entries(self.iter()).finish()
    }
}

impl<T: PartialEq> PartialEq for Table<T> {
    fn eq(&self, other: &Self) -> bool {
        **self == **other
    }
}

#[cfg(feature = "std")]
impl<T> FromIterator<T> for Table<T> {
    fn from_iter<I: IntoIterator<Item = T>>(entries: I) -> Self {
        Self::Shared(entries.into_iter().collect())
    }
}
