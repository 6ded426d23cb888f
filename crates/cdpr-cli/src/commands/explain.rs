//! `cdpr explain`: what an error code means and how the mistake is mended.

use std::process::ExitCode;

use cdpr_model::reading::did_you_mean;
use clap::Args;
use schemars::JsonSchema;
use serde::Serialize;

use crate::answer::{Answer, Output};
use crate::failure::Failure;
use cdpr_reports::explanations::{self, Explanation};
use cdpr_reports::table::Table;

const EXAMPLES: &str = "\
Examples:
  cdpr explain csv::ragged-row
  cdpr explain ragged-row
  cdpr explain";

/// Explain an error code: what happened, usual causes, how to mend it, an example. Without a code, list all.
///
/// Every error shows its code in brackets, and as `code` in its JSON object. Codes stay the same from version to version.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    /// The code, or the part after `::` where it is unique.
    #[arg(value_name = "CODE")]
    code: Option<String>,
}

/// Explanation of a code.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "Explanation")]
pub(super) struct Explained {
    code: &'static str,
    /// The explanation (Markdown).
    explanation: &'static str,
}

/// All codes that are explained.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "CodeList")]
pub(super) struct Listed {
    /// The codes.
    codes: Vec<Entry>,
}

/// A code in a line.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "CodeEntry")]
pub(super) struct Entry {
    code: &'static str,
    /// Subject in a line.
    summary: String,
}

impl Answer for Explained {
    fn words(&self, _width: Option<usize>) -> String {
        format!("{}\n\n{}\n", self.code, unwrapped(self.explanation.trim_end()))
    }
}

/// A page whose paragraphs are lines of their own, as they fold at the width of the terminal; what is indented stays as it is.
fn unwrapped(page: &str) -> String {
    let begins =
        |line: &str| line.is_empty() || [" ", "Causes:", "Mend:"].iter().any(|beginning| line.starts_with(beginning));
    let (mut text, mut before) = (String::new(), "");
    for line in page.lines() {
        let goes_on = !begins(line) && !before.is_empty() && !before.starts_with(' ');
        if !text.is_empty() {
            text.push(if goes_on { ' ' } else { '\n' });
        }
        text.push_str(line);
        before = line;
    }
    text
}

impl Answer for Listed {
    fn words(&self, width: Option<usize>) -> String {
        let mut table = Table::new(["code", "what happened"]).left_column(1);
        self.codes.iter().for_each(|entry| table.row(vec![entry.code.to_owned(), entry.summary.clone()]));
        table.text(width)
    }
}

pub(crate) fn run(arguments: Arguments, output: &mut Output) -> Result<ExitCode, Failure> {
    let Some(wanted) = arguments.code else {
        let entry = |explanation: Explanation| Entry { code: explanation.code, summary: explanation.summary() };
        return output.answer(&Listed { codes: explanations::all().map(entry).collect() });
    };
    let Explanation { code, text } = find(&wanted)?;
    output.answer(&Explained { code, explanation: text })
}

/// The explanation of a code, or of the only code with this last part.
fn find(wanted: &str) -> Result<Explanation, Failure> {
    let is_wanted =
        |explanation: &Explanation| explanation.code == wanted || explanation.code.rsplit("::").next() == Some(wanted);
    let found: Vec<Explanation> = explanations::all().filter(is_wanted).collect();
    if let [only] = found.as_slice() {
        return Ok(*only);
    }
    let help = match did_you_mean(wanted, explanations::all().map(|explanation| explanation.code)) {
        _ if !found.is_empty() => {
            format!("which of {}?", found.iter().map(|one| one.code).collect::<Vec<_>>().join(", "))
        }
        Some(meant) => format!("did you mean `{meant}`? `cdpr explain` lists all codes"),
        None => "`cdpr explain` lists all codes".to_owned(),
    };
    Err(Failure::input("usage::unknown-code", format!("there is no single code `{wanted}`"), help))
}
