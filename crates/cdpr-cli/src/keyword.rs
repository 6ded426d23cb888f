//! Choices of the library by their names.

use cdpr_model::reading::Keyword;
use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};

/// A choice by its name.
pub(crate) fn keyword<T: Keyword + Send + Sync>() -> impl TypedValueParser<Value = T> {
    keyword_or_short(&[])
}

/// A choice by its name or a short one.
pub(crate) fn keyword_or_short<T: Keyword + Send + Sync>(
    short: &'static [(&'static str, T)],
) -> impl TypedValueParser<Value = T> {
    let possible = |choice: &T| {
        let own = short.iter().filter(|(_, of)| of.name() == choice.name()).map(|(name, _)| *name);
        PossibleValue::new(choice.name()).aliases(own)
    };
    let of_short = |text: &str| short.iter().find(|(name, _)| *name == text).map(|(_, choice)| *choice);
    PossibleValuesParser::new(T::ALL.iter().map(possible))
        .try_map(move |text| T::named(&text).or_else(|| of_short(&text)).ok_or("there is no such choice"))
}
