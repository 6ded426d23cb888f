//! `cdpr man`: the help of every command as man pages.

use std::io;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::{Args, Command, CommandFactory};
use clap_mangen::Man;
use schemars::JsonSchema;
use serde::Serialize;

use crate::CommandLine;
use crate::answer::{Answer, Output};
use crate::failure::Failure;
use crate::{files, option_headings};
use cdpr_reports::answers::PROGRAM;

const EXAMPLES: &str = "\
Examples:
  cdpr man --out ~/.local/share/man/man1
  man cdpr-select
  cdpr man > cdpr.1";

/// Write the man pages of all commands, or print that of `cdpr` itself.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    /// Folder for one page per command: cdpr.1, cdpr-ik.1, …
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
}

/// Manual pages.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "ManualPages")]
pub(super) struct Written {
    /// Names of the pages.
    pages: Vec<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    out: Option<String>,
    /// Text of the page, where one was asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    page: Option<String>,
}

impl Answer for Written {
    fn words(&self, _width: Option<usize>) -> String {
        match (&self.page, &self.out) {
            (Some(page), _) => page.clone(),
            (None, out) => {
                format!("{} man pages written to {}\n", self.pages.len(), out.as_deref().unwrap_or_default())
            }
        }
    }

    fn is_verbatim(&self) -> bool {
        self.page.is_some()
    }
}

pub(crate) fn run(arguments: Arguments, output: &mut Output) -> Result<ExitCode, Failure> {
    let mut root = option_headings::under_headings(CommandLine::command());
    root.build();
    let Some(folder) = arguments.out else {
        let page = String::from_utf8_lossy(&page(&root)).into_owned();
        return output.answer(&Written { pages: vec![page_name(&root)], out: None, page: Some(page) });
    };
    let mut pages = Vec::new();
    collect(&root, &mut pages);
    files::make_folder(&folder)?;
    let paths: Vec<PathBuf> = pages.iter().map(|(name, _)| folder.join(name)).collect();
    let pairs: Vec<(&Path, &[u8])> =
        paths.iter().map(PathBuf::as_path).zip(pages.iter().map(|(_, text)| &text[..])).collect();
    files::write_all(&pairs)?;
    let pages = pages.into_iter().map(|(name, _)| name).collect();
    output.answer(&Written { pages, out: Some(folder.display().to_string()), page: None })
}

/// The pages of a command and of those below it.
fn collect(command: &Command, pages: &mut Vec<(String, Vec<u8>)>) {
    pages.push((page_name(command), page(command)));
    command
        .get_subcommands()
        .filter(|inner| !inner.is_hide_set() && inner.get_name() != "help")
        .for_each(|inner| collect(inner, pages));
}

fn page_name(command: &Command) -> String {
    format!("{}.1", command.get_display_name().unwrap_or_else(|| command.get_name()))
}

fn page(command: &Command) -> Vec<u8> {
    let mut page = Vec::new();
    // writing to memory does not fail
    let _ = write_page(command, &mut page);
    page
}

fn write_page(command: &Command, page: &mut Vec<u8>) -> io::Result<()> {
    let man = Man::new(command.clone()).source(PROGRAM).manual("cdpr");
    man.render_title(page)?;
    man.render_name_section(page)?;
    man.render_synopsis_section(page)?;
    man.render_description_section(page)?;
    man.render_options_section(page)?;
    if command.has_subcommands() {
        man.render_subcommands_section(page)?;
    }
    if let Some(examples) = command.get_after_help() {
        page.extend_from_slice(verbatim("EXAMPLES", &examples.to_string()).as_bytes());
    }
    Ok(())
}

/// A section whose lines stay as they are; its first line, the heading of the help, is left out.
fn verbatim(heading: &str, text: &str) -> String {
    let escaped = |line: &str| {
        let line = line.replace('\\', "\\e").replace('-', "\\-");
        if line.starts_with(['.', '\'']) { format!("\\&{line}") } else { line }
    };
    let lines: Vec<String> = text.lines().skip(1).map(escaped).collect();
    format!(".SH {heading}\n.nf\n{}\n.fi\n", lines.join("\n"))
}
