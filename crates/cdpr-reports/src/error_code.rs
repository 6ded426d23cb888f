//! Stable short names of what this crate refuses; `cdpr explain` has a page for each.

use cdpr_model::reading::ErrorCode;

use crate::comparison::UnwritableFile;
use crate::firmware::FirmwareError;
use crate::html_page::PageError;
#[cfg(feature = "recording")]
use crate::recording::McapError;
use crate::study_page::StudyPageError;
use crate::workspace_page::OverlayError;

impl ErrorCode for PageError {
    fn code(&self) -> &'static str {
        "numerical::unwritable"
    }
}

#[cfg(feature = "recording")]
impl ErrorCode for McapError {
    fn code(&self) -> &'static str {
        "numerical::unwritable"
    }
}

impl ErrorCode for UnwritableFile {
    fn code(&self) -> &'static str {
        "numerical::unwritable"
    }
}

impl ErrorCode for StudyPageError {
    fn code(&self) -> &'static str {
        match self {
            Self::Experiment(error) => error.code(),
            Self::Region(error) => error.code(),
            Self::Pose(error) => error.code(),
            Self::Page(error) => error.code(),
        }
    }
}

impl ErrorCode for OverlayError {
    fn code(&self) -> &'static str {
        "workspace::overlay"
    }
}

impl ErrorCode for FirmwareError {
    fn code(&self) -> &'static str {
        "export::firmware"
    }
}
