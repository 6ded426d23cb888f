//! The joined rows of a sweep: read from their files, and in words.

use std::path::Path;

use cdpr::metamodel::sweep::Row;
use cdpr_reports::number_format::significant;
use cdpr_reports::sweep_result::{SweepPoint, SweepResult};

use super::folder::{Plan, RowFile};
use crate::answer::{Answer, Output};
use crate::failure::Failure;
use crate::files;
use crate::table::Table;

/// Reads all rows and writes the result beside them; refuses rows of other plans and gaps.
pub(super) fn merge(folder: &Path, plan: &Plan, output: &Output) -> Result<SweepResult, Failure> {
    let strangers = RowFile::strangers(folder, plan)?;
    if strangers > 0 {
        let message =
            format!("{strangers} rows in {} belong to another plan: it was changed between shards", folder.display());
        return Err(Failure::input(
            "sweep::plan-changed",
            message,
            "merge only what was computed with the plan of this folder",
        ));
    }
    let rows: Vec<Option<Row>> =
        (0..plan.points.len()).map(|point| RowFile::read(folder, plan, point)).collect::<Result<_, _>>()?;
    let missing = rows.iter().filter(|row| row.is_none()).count();
    if missing > 0 {
        let message = format!("{missing} of {} points are not computed", rows.len());
        let help = format!("compute them: cdpr sweep run {}", folder.display());
        return Err(Failure::input("sweep::incomplete", message, help));
    }
    let parameters = plan.sweep.parameter.iter().map(|parameter| parameter.key.clone()).collect();
    let most = plan.sweep.position_error_max_m.clone();
    let mut merged = SweepResult::new(plan.fingerprint.clone(), parameters, most, rows.into_iter().flatten().collect());
    merged.files = vec!["result.json".to_owned(), "result.csv".to_owned()];
    let figure = merged.figure();
    if figure.is_some() {
        merged.files.push("result.svg".to_owned());
    }
    let json = output.file(&merged, "result.json")?;
    let csv = merged.csv();
    let paths: Vec<_> = merged.files.iter().map(|name| folder.join(name)).collect();
    let contents = [Some(json.into_bytes()), Some(csv.into_bytes()), figure.map(String::into_bytes)];
    let contents: Vec<Vec<u8>> = contents.into_iter().flatten().collect();
    let all: Vec<(&Path, &[u8])> =
        paths.iter().map(|path| path.as_path()).zip(contents.iter().map(Vec::as_slice)).collect();
    files::write_all(&all)?;
    Ok(merged)
}

impl Answer for SweepResult {
    fn is_negative(&self) -> bool {
        self.reason.is_some()
    }

    fn words(&self) -> String {
        let mut heading = self.parameters.clone();
        heading.push("any error".to_owned());
        heading.extend(self.position_error_max_m.iter().map(|most| format!("{} mm", significant(1e3 * most, 3))));
        let mut table = Table::with_heading(heading);
        let percent =
            |share: &Option<f64>| share.map_or_else(|| "–".to_owned(), |share| format!("{:.1} %", 100.0 * share));
        for SweepPoint { row, share, share_by_accuracy } in &self.rows {
            let mut cells: Vec<String> = row.values.iter().map(|value| significant(*value, 5)).collect();
            cells.push(percent(share));
            cells.extend(
                (0..self.position_error_max_m.len())
                    .map(|index| percent(&share_by_accuracy.get(index).copied().flatten())),
            );
            table.row(cells);
        }
        let mut text = format!("reached share of the physical workspace\n\n{}", table.text());
        if let Some(remark) = &self.remark {
            text.push_str(&format!("\n{remark}\n"));
        }
        if let Some(reason) = self.rows.iter().find_map(|row| row.row.reason.as_ref()) {
            let failed = self.rows.iter().filter(|row| row.row.reason.is_some()).count();
            text.push_str(&format!("\n{failed} points have no answer, the first because {reason}\n"));
        }
        text.push_str(&format!("\nwrote {}\n", self.files.join(", ")));
        text
    }
}
