//! Reports, pages and figures of the answers of `cdpr`: values in, text out.
//!
//! Nothing here reads arguments, files or clocks, and nothing writes files: who asks (the command, a binding, a live page) does. What is
//! written is a function of the values given, to the byte.
//!
//! | module | what it makes |
//! |---|---|
//! | [`figures`] | single figures as SVG that stand alone and print well |
//! | [`report`] | the page of a comparison of models, or of an identification |
//! | [`firmware`] | configuration lines of printers' firmware |
//! | [`comparison`] | the files of a comparison: result, tables, calibrated robots, report |
//! | [`saved_result`] | a result read back from these files, and its figures |
//! | [`sensitivity`] | answer, tables and picture of sensitivities and tolerances |
//! | [`reachable`] | answer and picture of what a study reaches |
//! | [`sweep_progress`] | a sweep that is planned, or computed in parts |
//! | [`sweep_result`] | answer, table and drawing of a sweep |
//! | [`recording`] | the moments of a run, its broken limits, and its MCAP file |
//! | [`run_page`] | the page of a run, with playback |
//! | [`study_page`] | the page of a study: errors over its poses and the regions around them |
//! | [`workspace_page`] | the page of a workspace, in which the platform can be dragged |
//! | [`answers`] | results as JSON objects with units in their keys, and in words |
//! | [`explanations`] | a page for every error code |
//! | [`number_format`] | numbers for people |
//! | [`paragraphs`] | text for people that folds at the width of a terminal |
//! | [`table`] | tables for people, fitted to a width |

mod answer_keys;
mod answer_schema;
pub mod answers;
pub mod comparison;
pub mod cost_result;
mod error_code;
pub mod explanations;
pub mod figures;
pub mod firmware;
mod html_page;
mod keys;
mod named_file;
pub mod number_format;
mod page_schema;
pub mod paragraphs;
pub mod reachable;
pub mod recording;
pub mod report;
pub mod run_page;
pub mod saved_result;
pub mod sensitivity;
pub mod study_page;
pub mod sweep_progress;
pub mod sweep_result;
pub mod table;
pub mod workspace_page;

pub use answer_schema::AnswerSchemas;
pub use html_page::PageError;
pub use named_file::NamedFile;
pub use page_schema::page_schema;
