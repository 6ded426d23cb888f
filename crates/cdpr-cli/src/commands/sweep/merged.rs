//! The joined rows of a sweep: read from their files.

use std::path::Path;

use cdpr::metamodel::sweep::Row;
use cdpr_reports::sweep_result::SweepResult;

use super::folder::{Plan, RowFile};
use crate::answer::Output;
use crate::failure::Failure;
use crate::files;

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
