//! The ladder of candidates as table and chart.

use cdpr::identification::fit::Status;
use cdpr::identification::selection::{Judged, Judgement};
use minijinja::Value;

use super::chart::{Ladder, Rung};
use super::table::{Cell, Table};
use super::{Purpose, Report, criterion, number};

/// Every candidate with its figures.
pub(super) fn table(report: &Report<'_>) -> Value {
    let unit = report.criterion.unit();
    let (train, validation) = (format!("#fit, {unit}"), format!("#validation, {unit}"));
    let error = format!("#± standard error, {unit}");
    let columns = [
        ("#", ""),
        ("candidate", "def-candidate"),
        ("#free parameters", "def-parameter"),
        (&train, "def-data"),
        (&validation, "def-criterion"),
        (&error, "def-standard-error"),
        ("#rank", "def-rank"),
        ("#condition", "def-condition"),
        ("remark", ""),
    ];
    let caption = format!("Candidates from simple to complex; {} on the data of the fit and on validation data", {
        report.criterion.words()
    });
    let mut table = Table::new(caption, &columns);
    for (index, candidate) in report.selection.candidates.iter().enumerate() {
        let number = Cell::number((index + 1).to_string());
        let name = Cell::code(&candidate.name);
        match &candidate.outcome {
            Ok(judgement) => {
                let class = if report.selection.recommended == Some(index) { "chosen" } else { "" };
                let mut cells = vec![number, name];
                cells.extend(figures(report, judgement));
                cells.push(Cell::text(remarks(report, index, judgement)));
                table.push(class, cells);
            }
            Err(reason) => {
                let reason = Cell::text(format!("not identified: {reason}")).spanning(columns.len() - 2);
                table.push("failed", vec![number, name, reason]);
            }
        }
    }
    table.into_value()
}

fn figures(report: &Report<'_>, judgement: &Judgement) -> [Cell; 6] {
    let (value, error) = criterion::number_and_error(report.criterion, judgement.criterion, judgement.standard_error);
    let train = report.criterion.in_unit(report.criterion.of_blocks(&judgement.train));
    let (analysis, count) = (&judgement.fit.analysis, judgement.fit.parameters.len());
    let none = || number::NONE.to_owned();
    [
        count.to_string(),
        number::significant(train, 4),
        value,
        if error.is_empty() { none() } else { error },
        if count == 0 { none() } else { format!("{} of {count}", analysis.rank) },
        if count == 0 { none() } else { number::significant(analysis.condition, 3) },
    ]
    .map(Cell::number)
}

fn remarks(report: &Report<'_>, index: usize, judgement: &Judgement) -> String {
    let selection = report.selection;
    let mut remarks = Vec::new();
    if selection.recommended == Some(index) && selection.candidates.len() > 1 {
        remarks.push(if report.purpose == Purpose::Selection { "recommended" } else { "identified" }.to_owned());
    }
    if selection.best == Some(index) && selection.candidates.len() > 1 {
        remarks.push("smallest error".to_owned());
    }
    match judgement.fit.status {
        Status::Converged => {}
        Status::NotIdentifiable => remarks.push("not identifiable".to_owned()),
        _ => remarks.push("fit not converged".to_owned()),
    }
    let weak = judgement.fit.analysis.weak_directions.len();
    if weak > 0 && judgement.fit.status == Status::Converged {
        remarks.push("weakly determined".to_owned());
    }
    let broken = judgement.requirements.iter().filter(|requirement| !requirement.met);
    remarks.extend(broken.map(|requirement| format!("breaks {}", requirement.metric)));
    if judgement.validation.not_converged > 0 {
        remarks.push(format!("no pose found for {} samples", judgement.validation.not_converged));
    }
    remarks.join("; ")
}

/// The chart; `None` for a single candidate or without any value.
pub(super) fn chart(report: &Report<'_>) -> Option<String> {
    let selection = report.selection;
    if selection.candidates.len() < 2 {
        return None;
    }
    let judgement = |candidate: &'_ Judged| candidate.outcome.as_ref().ok().map(|j| (j.criterion, j.standard_error));
    let shown = |value: f64| report.criterion.in_unit(value);
    let rung = |(index, candidate): (usize, &Judged)| {
        let (value, error) = judgement(candidate).unwrap_or((f64::NAN, f64::NAN));
        Rung {
            name: candidate.name.clone(),
            value: shown(value),
            standard_error: shown(error),
            words: format!("{}: {}", candidate.name, criterion::with_error(report.criterion, value, error)),
            recommended: selection.recommended == Some(index),
        }
    };
    let best = selection.best.and_then(|best| judgement(&selection.candidates[best]));
    let limit = best.map_or(f64::NAN, |(value, error)| value + if error.is_finite() { error } else { 0.0 });
    let ladder = Ladder {
        rungs: selection.candidates.iter().enumerate().map(rung).collect(),
        limit: shown(limit),
        axis_label: format!("{} on validation data in {}", report.criterion.words(), report.criterion.unit()),
    };
    ladder.svg()
}
