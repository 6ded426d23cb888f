//! Results of earlier pages, to lay over a new one.

use std::path::Path;

use cdpr_model::reading::Size;

use super::Arguments;
use crate::failure::Failure;
use crate::files;
use cdpr_reports::workspace_page::{Finding, findings_of};

/// The results of the pages to lay over the new one, to be read before a long computation.
pub(super) fn earlier(arguments: &Arguments) -> Result<Vec<Finding>, Failure> {
    if arguments.page.is_none() && !arguments.overlay.is_empty() {
        let help = "add --page FILE.html";
        return Err(Failure::input(
            "workspace::overlay",
            "--overlay lays results over a page, but no page is written",
            help,
        ));
    }
    let read: Result<Vec<Vec<Finding>>, Failure> = arguments.overlay.iter().map(|path| findings_in(path)).collect();
    Ok(read?.concat())
}

/// Results of a page that `cdpr workspace --page` wrote.
fn findings_in(path: &Path) -> Result<Vec<Finding>, Failure> {
    let page = files::read(path, Size::Table)?;
    let help = "give a page that `cdpr workspace --page` wrote";
    findings_of(&String::from_utf8_lossy(&page))
        .map_err(|error| Failure::refused(&path.display().to_string(), &error).with_help(help))
}
