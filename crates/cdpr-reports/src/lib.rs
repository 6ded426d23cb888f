//! Reports, pages and figures of the answers of [`cdpr`]: values in, text out.
//!
//! Nothing here reads arguments, files or clocks, and nothing writes files: who asks (the command, a binding, a live page) does. What is
//! written is a function of the values given, to the byte.
//!
//! | module | what it makes |
//! |---|---|
//! | [`figures`] | single figures as SVG that stand alone and print well |
//! | [`report`] | the page of a comparison of models, or of an identification |
//! | [`study_page`] | the page of a study: errors over its poses and the regions around them |
//! | [`workspace_page`] | the page of a workspace, in which the platform can be dragged |
//! | [`answers`] | results as JSON objects with units in their keys |
//! | [`number_format`] | numbers for people |

pub mod answers;
mod error_code;
pub mod figures;
mod html_page;
pub mod number_format;
pub mod report;
pub mod study_page;
pub mod workspace_page;

pub use html_page::PageError;
