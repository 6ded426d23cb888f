//! The joined rows of a plan: read from their files.

use std::path::Path;
use std::process::ExitCode;

use cdpr_reports::answers::Answer;
use cdpr_reports::cost_result::CostResult;
use cdpr_reports::sweep_result::SweepResult;
use cdpr_study::sweep::Row;
use serde::Deserialize;
use serde_json::value::RawValue;

use super::command_plan::{CommandPlan, Finished};
use super::planned::{Planned, RowFile};
use super::sweep_plan::SweepPlan;
use crate::answer::Output;
use crate::failure::Failure;
use crate::files;

/// Reads all rows, writes the result beside them and answers with it; refuses rows of other plans and gaps.
pub(super) fn merge(folder: &Path, plan: &Planned, output: &mut Output) -> Result<ExitCode, Failure> {
    let rows = all_rows(folder, plan)?;
    match plan {
        Planned::Sweep(sweep) => merge_sweep(folder, sweep, &rows, output),
        Planned::Command(command) => merge_command(folder, command, &rows, output),
    }
}

/// A part of a command in its row.
#[derive(Deserialize)]
struct PartRow {
    part: Box<RawValue>,
}

/// Goes on with a command behind its parts; what it writes goes into the folder.
fn merge_command(
    folder: &Path,
    plan: &CommandPlan,
    rows: &[Box<RawValue>],
    output: &Output,
) -> Result<ExitCode, Failure> {
    let part = |row: &RawValue| Ok(of_row::<PartRow>(row)?.part.get().as_bytes().to_vec());
    let parts = rows.iter().map(|row| part(row)).collect::<Result<_, Failure>>()?;
    let Finished { exit, out, err, written } = plan.answer(parts, output.format_word())?;
    let paths: Vec<_> = written.keys().map(|path| folder.join(path)).collect();
    for parent in paths.iter().filter_map(|path| path.parent()) {
        files::make_folder(parent)?;
    }
    let all: Vec<(&Path, &[u8])> =
        paths.iter().map(|path| path.as_path()).zip(written.values().map(Vec::as_slice)).collect();
    files::write_all(&all)?;
    output.pass_on(&out, &err)?;
    Ok(exit)
}

/// A row that was read before, in full.
fn of_row<'a, T: Deserialize<'a>>(row: &'a RawValue) -> Result<T, Failure> {
    serde_json::from_str(row.get()).map_err(|error| {
        let message = format!("a row is none of this plan: {error}");
        Failure::input("sweep::plan-changed", message, "remove the rows and run the shards again")
    })
}

fn merge_sweep(
    folder: &Path,
    plan: &SweepPlan,
    rows: &[Box<RawValue>],
    output: &mut Output,
) -> Result<ExitCode, Failure> {
    let rows: Vec<Row> = rows.iter().map(|row| of_row(row)).collect::<Result<_, _>>()?;
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

/// Rows of all points, as JSON.
fn all_rows(folder: &Path, plan: &Planned) -> Result<Vec<Box<RawValue>>, Failure> {
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
    let rows: Vec<Option<Box<RawValue>>> =
        (0..plan.count()).map(|point| RowFile::read(folder, plan, point)).collect::<Result<_, _>>()?;
    let missing = rows.iter().filter(|row| row.is_none()).count();
    if missing > 0 {
        let message = format!("{missing} of {} points are not computed", rows.len());
        let help = format!("compute them: cdpr sweep run {}", folder.display());
        return Err(Failure::input("sweep::incomplete", message, help));
    }
    Ok(rows.into_iter().flatten().collect())
}
