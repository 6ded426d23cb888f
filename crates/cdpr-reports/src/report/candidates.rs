//! The ladder of candidates as table and chart.

use cdpr_calibration::ErrorBlocks;
use cdpr_calibration::selection::Judgement;
use minijinja::Value;

use super::table::{Cell, Table};
use super::{Purpose, ReportPage, criterion};
use crate::answers::SelectionAnswer;
use crate::number_format as number;

/// Every candidate with its figures.
pub(super) fn table(page: &ReportPage<'_>) -> Value {
    let unit = page.answer.criterion.unit();
    let judged = if page.report.is_held_out { "validation" } else { "judged" };
    let (train, validation) = (format!("#fit, {unit}"), format!("#{judged}, {unit}"));
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
    let caption = format!(
        "Candidates from simple to complex; {} on the data of the fit and on {}",
        page.answer.criterion,
        page.report.data_words()
    );
    let mut table = Table::new(caption, &columns);
    for (index, candidate) in page.answer.candidates.iter().enumerate() {
        let number = Cell::number((index + 1).to_string());
        let name = Cell::code(candidate.name);
        match candidate.judged {
            Some(judgement) => {
                let class = if page.answer.places.recommended == Some(index) { "chosen" } else { "" };
                let mut cells = vec![number, name];
                cells.extend(figures(page, judgement));
                cells.push(Cell::text(remarks(page, index, judgement)));
                table.push(class, cells);
            }
            None => {
                let reason = candidate.failure.as_deref().unwrap_or_default();
                let reason = Cell::text(format!("not identified: {reason}")).spanning(columns.len() - 2);
                table.push("failed", vec![number, name, reason]);
            }
        }
    }
    table.into_value()
}

fn figures(page: &ReportPage<'_>, judgement: &Judgement) -> [Cell; 6] {
    let (value, error) =
        criterion::value_and_error(page.answer.criterion, judgement.criterion, judgement.standard_error);
    let train = page.answer.criterion.in_unit(page.answer.criterion.of_blocks(&judgement.train));
    let (analysis, count) = (&judgement.fit.analysis, judgement.fit.parameters.len());
    let none = || number::NONE.to_owned();
    [
        count.to_string(),
        number::significant(train, 3),
        value,
        if error.is_empty() { none() } else { error },
        if count == 0 { none() } else { format!("{} of {count}", analysis.rank) },
        if count == 0 { none() } else { number::condition(analysis.condition) },
    ]
    .map(Cell::number)
}

fn remarks(page: &ReportPage<'_>, index: usize, judgement: &Judgement) -> String {
    let SelectionAnswer { candidates, places, .. } = &page.answer;
    let mut remarks = Vec::new();
    if places.recommended == Some(index) && candidates.len() > 1 {
        remarks.push(if page.report.purpose == Purpose::Selection { "recommended" } else { "identified" }.to_owned());
    }
    if places.best == Some(index) && candidates.len() > 1 {
        remarks.push("smallest error".to_owned());
    } else if candidates.len() > 1 && judgement.compared_error().is_some_and(|compared| compared.is_as_good) {
        remarks.push("as good as the best".to_owned());
    }
    remarks.extend(Some(judgement.fit.caution_words()).filter(|words| !words.is_empty()));
    let broken = judgement.requirements.iter().filter(|requirement| !requirement.met);
    remarks.extend(broken.map(|requirement| format!("breaks {}", requirement.metric)));
    if judgement.validation.not_converged > 0 {
        let ErrorBlocks { not_converged, samples, .. } = judgement.validation;
        remarks.push(format!("no pose for {not_converged} of {samples} samples"));
    }
    if judgement.disqualified.is_some() {
        remarks.push("not judged".to_owned());
    }
    remarks.join("; ")
}
