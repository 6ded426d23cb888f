//! The joined rows of a sweep: read from their files.

use std::path::Path;
use std::process::ExitCode;

use cdpr_reports::answers::Answer;
use cdpr_reports::cost_result::CostResult;
use cdpr_reports::sweep_result::SweepResult;
use cdpr_study::sweep::Row;

use super::folder::{Plan, RowFile};
use crate::answer::Output;
use crate::failure::Failure;
use crate::files;

/// Reads all rows, writes the result beside them and answers with it; refuses rows of other plans and gaps.
pub(super) fn merge(folder: &Path, plan: &Plan, output: &mut Output) -> Result<ExitCode, Failure> {
    let rows = all_rows(folder, plan)?;
    let parameters = plan.sweep.parameter.iter().map(|parameter| parameter.key.clone()).collect();
    let name = plan.fingerprint.clone();
    match &plan.sweep.calibration {
        Some(table) => {
            let mut merged = CostResult::new(name, parameters, table, rows);
            let figure = merged.figure();
            merged.files = names(figure.is_some());
            let csv = merged.csv();
            write(folder, (&merged, &merged.files), (csv, figure), output)?;
            output.answer(&merged)
        }
        None => {
            let most = plan.sweep.position_error_max_m.clone();
            let mut merged = SweepResult::new(name, plan.is_planar()?, parameters, most, rows);
            let figure = merged.figure();
            merged.files = names(figure.is_some());
            let csv = merged.csv();
            write(folder, (&merged, &merged.files), (csv, figure), output)?;
            output.answer(&merged)
        }
    }
}

/// Names of the files of a result.
fn names(has_figure: bool) -> Vec<String> {
    let all = [Some("result.json"), Some("result.csv"), has_figure.then_some("result.svg")];
    all.into_iter().flatten().map(str::to_owned).collect()
}

/// Writes the files of a result.
fn write(
    folder: &Path,
    (merged, names): (&impl Answer, &[String]),
    (csv, figure): (String, Option<String>),
    output: &Output,
) -> Result<(), Failure> {
    let json = output.file(merged, "result.json")?;
    let paths: Vec<_> = names.iter().map(|name| folder.join(name)).collect();
    let contents = [Some(json.into_bytes()), Some(csv.into_bytes()), figure.map(String::into_bytes)];
    let contents: Vec<Vec<u8>> = contents.into_iter().flatten().collect();
    let all: Vec<(&Path, &[u8])> =
        paths.iter().map(|path| path.as_path()).zip(contents.iter().map(Vec::as_slice)).collect();
    files::write_all(&all)
}

/// Rows of all points.
fn all_rows(folder: &Path, plan: &Plan) -> Result<Vec<Row>, Failure> {
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
    Ok(rows.into_iter().flatten().collect())
}
