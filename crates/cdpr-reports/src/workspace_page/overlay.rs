//! Results of an earlier page, to lay them over new ones.

use serde::Deserialize;
use thiserror::Error;

use super::Finding;
use super::page_data::RegionData;

const BLOCK: &str = r#"<script type="application/json" id="cdpr-data">"#;

/// Reasons why a page has no results to lay over another one.
#[derive(Debug, Error)]
pub enum OverlayError {
    /// No page of cdpr.
    #[error("it holds no results of cdpr")]
    NoResults,
    /// Results that cannot be read.
    #[error("its results cannot be read: {0}")]
    Unreadable(#[from] serde_json::Error),
    /// A page about something else.
    #[error("it is a page about {0}, not about a workspace")]
    OtherPage(String),
    /// A surface whose triangles have corners that do not exist.
    #[error("a hull in it names vertices that are not there")]
    NoVertices,
}

#[derive(Deserialize)]
struct Block {
    page: String,
    regions: Vec<RegionData>,
}

/// Results that a page of a workspace shows.
pub fn findings_of(page: &str) -> Result<Vec<Finding>, OverlayError> {
    let block = page.split_once(BLOCK).and_then(|(_, rest)| rest.split_once("</script>"));
    let (json, _) = block.ok_or(OverlayError::NoResults)?;
    let block: Block = serde_json::from_str(json)?;
    if block.page != "workspace" {
        return Err(OverlayError::OtherPage(block.page));
    }
    let findings: Option<Vec<Finding>> = block.regions.into_iter().map(RegionData::finding).collect();
    findings.ok_or(OverlayError::NoVertices)
}
