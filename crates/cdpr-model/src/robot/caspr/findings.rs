//! Elements of a model that the robot lacks.

use crate::reading::{Element, keywords};

/// Part of an element that the robot lacks: all that acts on it, a part of that, or only parts without effect.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Loss {
    /// The element acts on the platform in CASPR, and not in the robot.
    LeftOut,
    /// The element was imported, but without a property that acts.
    Simplified,
    /// Only parts without effect were lost.
    Ignored,
}

keywords!(Loss: LeftOut = "left-out", Simplified = "simplified", Ignored = "ignored");

/// An element that the robot lacks wholly or in part.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Finding {
    /// Lost part of the element.
    pub loss: Loss,
    /// Name of the XML element.
    pub element: String,
    /// Its name in the model, if it has one.
    pub name: Option<String>,
    /// The file.
    pub file: String,
    /// Line in the file, from 1.
    pub line: usize,
    /// Lost part, with the reason.
    pub why: String,
}

impl std::fmt::Display for Finding {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Self { element, file, line, why, .. } = self;
        match &self.name {
            Some(name) => write!(formatter, "{file}:{line}: <{element}> `{name}`: {why}"),
            None => write!(formatter, "{file}:{line}: <{element}>: {why}"),
        }
    }
}

/// Findings of an import in progress.
#[derive(Debug, Default)]
pub(super) struct Findings(pub(super) Vec<Finding>);

impl Findings {
    /// Records the lost part of an element.
    pub(super) fn add(&mut self, loss: Loss, element: &Element<'_, '_>, why: impl Into<String>) {
        self.0.push(Finding {
            loss,
            element: element.name().to_owned(),
            name: element.attribute("name").map(str::to_owned),
            file: element.file_name().to_owned(),
            line: element.line(),
            why: why.into(),
        });
    }

    /// Records the unknown elements inside an element.
    pub(super) fn add_unknown_inside(&mut self, element: &Element<'_, '_>, known: &[&str]) {
        for inner in element.elements().filter(|inner| !known.contains(&inner.name())) {
            self.add(Loss::Ignored, &inner, format!("unknown in <{}>", element.name()));
        }
    }
}
