//! Schema of the data blocks of pages.

use schemars::generate::SchemaSettings;
use schemars::{JsonSchema, Schema};

use crate::{report, run_page, study_page, workspace_page};

/// Data block of a page; null in a report without a candidate to show.
#[derive(JsonSchema)]
#[schemars(untagged)]
#[expect(dead_code, clippy::large_enum_variant, reason = "only the schema is made of it")]
enum PageData {
    Report(Option<report::page_data::PageData<'static>>),
    Run(run_page::page_data::PageData<'static>),
    Study(study_page::page_data::PageData<'static>),
    Workspace(workspace_page::page_data::PageData<'static>),
}

/// JSON Schema of the data blocks of all pages with charts of their own.
pub fn page_schema() -> Schema {
    SchemaSettings::draft2020_12().for_serialize().into_generator().into_root_schema_for::<PageData>()
}
