//! Results of an earlier page, to lay them over new ones.

use std::path::Path;

use serde::Deserialize;

use super::Finding;
use super::page_data::RegionData;
use crate::failure::Failure;
use crate::files;
use cdpr::reading::Size;

const BLOCK: &str = r#"<script type="application/json" id="cdpr-data">"#;

#[derive(Deserialize)]
struct Block {
    page: String,
    regions: Vec<RegionData>,
}

/// The results that a page of `cdpr workspace --page` shows.
pub(crate) fn findings_of(path: &Path) -> Result<Vec<Finding>, Failure> {
    let bytes = files::read(path, Size::Table)?;
    let refuse = |why: String| {
        Failure::input(
            "workspace::overlay",
            format!("{}: {why}", path.display()),
            "give a page that `cdpr workspace --page` wrote",
        )
    };
    let text = String::from_utf8_lossy(&bytes);
    let block = text.split_once(BLOCK).and_then(|(_, rest)| rest.split_once("</script>"));
    let (json, _) = block.ok_or_else(|| refuse("it holds no results of cdpr".to_owned()))?;
    let block: Block =
        serde_json::from_str(json).map_err(|error| refuse(format!("its results cannot be read: {error}")))?;
    if block.page != "workspace" {
        return Err(refuse(format!("it is a page about {}, not about a workspace", block.page)));
    }
    let findings: Option<Vec<Finding>> = block.regions.into_iter().map(RegionData::finding).collect();
    findings.ok_or_else(|| refuse("a hull in it names vertices that are not there".to_owned()))
}
