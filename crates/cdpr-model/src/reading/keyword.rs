//! Names of choices in options, files and results.

/// A choice from a short list, with a name in options, files and results.
///
/// ```
/// use cdpr::calibration::Loss;
/// use cdpr::reading::Keyword;
///
/// assert_eq!(Loss::named("huber"), Some(Loss::Huber));
/// assert_eq!(Loss::ALL.iter().map(|loss| loss.name()).collect::<Vec<_>>(), ["auto", "squared", "huber", "cauchy"]);
/// ```
pub trait Keyword: Copy + 'static {
    /// All choices, in the order in which they are listed.
    const ALL: &'static [Self];

    /// The name of the choice.
    fn name(self) -> &'static str;

    /// The choice with this name; `None` if there is none.
    fn named(name: &str) -> Option<Self> {
        Self::ALL.iter().copied().find(|choice| choice.name() == name)
    }
}

/// Names the choices of a type, in the order in which they are listed.
#[macro_export]
#[doc(hidden)]
macro_rules! keywords {
    ($choices:ty: $($choice:ident = $name:literal),+ $(,)?) => {
        impl $crate::reading::Keyword for $choices {
            const ALL: &'static [Self] = &[$(Self::$choice),+];

            fn name(self) -> &'static str {
                match self {
                    $(Self::$choice => $name),+
                }
            }
        }
    };
}

#[doc(hidden)]
pub use keywords;
