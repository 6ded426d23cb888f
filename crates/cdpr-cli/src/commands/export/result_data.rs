//! What a result holds, read from its folder or from a JSON answer.

use std::path::{Path, PathBuf};

use cdpr::identification::selection::Criterion;
use cdpr::reading::{Place, ReadError, Size, text_from_bytes};
use cdpr::robot::Robot;
use serde::Deserialize;
use serde_json::Value;

use super::csv_table::CsvTable;
use crate::failure::Failure;
use crate::files;

/// Everything that figures show.
pub(super) struct ResultData {
    /// Where it stands.
    pub(super) folder: PathBuf,
    pub(super) criterion: Criterion,
    /// The candidates, from simple to complex; none for an identification.
    pub(super) candidates: Vec<CandidateData>,
    pub(super) robot: Option<String>,
    pub(super) best: Option<String>,
    pub(super) recommended: Option<String>,
    /// The candidate that all other figures are about.
    pub(super) shown: Option<String>,
    pub(super) rank: usize,
    pub(super) parameters: Vec<ParameterData>,
    pub(super) singular_values: Vec<f64>,
    pub(super) convergence: Vec<f64>,
    /// Names and rows of the matrix.
    pub(super) correlations: Option<(Vec<String>, Vec<Vec<f64>>)>,
    pub(super) samples: Vec<SampleData>,
    /// Names of the cables, as figures show them.
    pub(super) cables: Vec<String>,
}

/// One candidate of `result.json`.
#[derive(Clone, Debug, Deserialize)]
pub(super) struct CandidateData {
    pub(super) name: String,
    pub(super) model: String,
    pub(super) free: String,
    pub(super) parameter_count: Option<usize>,
    #[serde(default)]
    pub(super) train: Value,
    pub(super) criterion: Option<f64>,
    pub(super) standard_error: Option<f64>,
    pub(super) rank: Option<usize>,
    pub(super) condition: Option<f64>,
    pub(super) failure: Option<String>,
}

/// One identified parameter.
#[derive(Clone, Debug, Deserialize)]
pub(super) struct ParameterData {
    pub(super) name: String,
    pub(super) unit: String,
    pub(super) start: Option<f64>,
    pub(super) value: Option<f64>,
    pub(super) sigma: Option<f64>,
    pub(super) prior_sigma: Option<f64>,
    pub(super) at_bound: bool,
}

/// Errors at one validation sample (SI); NaN where they are not known.
pub(super) struct SampleData {
    /// Number in the data, from 1.
    pub(super) sample: usize,
    /// Measured position (world, m).
    pub(super) position: [f64; 3],
    pub(super) position_error: f64,
    pub(super) position_vector: [f64; 3],
    pub(super) rotation_error: f64,
    /// Modelled minus recorded, per cable (m).
    pub(super) lengths: Vec<f64>,
}

/// The keys of a JSON answer that figures need; those of an identification stand at the top.
#[derive(Deserialize)]
struct ResultFile {
    #[serde(default)]
    candidates: Vec<CandidateData>,
    criterion: Option<String>,
    best: Option<String>,
    recommended: Option<String>,
    model: Option<String>,
    robot: Option<String>,
    rank: Option<usize>,
    #[serde(default)]
    parameters: Vec<ParameterData>,
    #[serde(default)]
    singular_values: Vec<Option<f64>>,
    #[serde(default)]
    history: Vec<Option<f64>>,
}

impl ResultData {
    /// Reads a folder with `result.json`, or a JSON file alone.
    pub(super) fn read(path: &Path) -> Result<Self, Failure> {
        let is_folder = path.is_dir();
        let file = if is_folder { path.join("result.json") } else { path.to_owned() };
        let help = "RESULT is a folder that `cdpr select --out` or `cdpr demo` wrote, or a file with a JSON answer";
        let bytes = files::read(&file, Size::Table).map_err(|failure| failure.with_help(help))?;
        let answer = parsed(&bytes, &file.display().to_string())?;
        let mut data = Self::of_answer(answer, file.parent().unwrap_or(Path::new("")).to_owned());
        if is_folder {
            data.read_tables(path)?;
        }
        Ok(data)
    }

    fn of_answer(answer: ResultFile, folder: PathBuf) -> Self {
        let shown = answer.recommended.clone().or_else(|| answer.best.clone()).or(answer.model);
        let own = answer.candidates.iter().find(|candidate| Some(&candidate.name) == shown.as_ref());
        let finite = |list: Vec<Option<f64>>| list.into_iter().map(|value| value.unwrap_or(f64::NAN)).collect();
        Self {
            folder,
            criterion: criterion(answer.criterion.as_deref()),
            rank: own.and_then(|candidate| candidate.rank).or(answer.rank).unwrap_or(0),
            robot: answer.robot,
            best: answer.best,
            recommended: answer.recommended,
            shown,
            parameters: answer.parameters,
            singular_values: finite(answer.singular_values),
            convergence: finite(answer.history),
            candidates: answer.candidates,
            correlations: None,
            samples: Vec::new(),
            cables: Vec::new(),
        }
    }

    fn read_tables(&mut self, folder: &Path) -> Result<(), Failure> {
        if let Some(table) = CsvTable::read(&folder.join("parameters.csv"))? {
            self.parameters = self.parameters_of(&table)?;
        }
        if let Some(table) = CsvTable::read(&folder.join("singular-values.csv"))? {
            self.singular_values = self.own_numbers(&table, "singular_value")?;
        }
        if let Some(table) = CsvTable::read(&folder.join("convergence.csv"))? {
            self.convergence = self.own_numbers(&table, "weighted_sum_of_squares")?;
        }
        if let Some(table) = CsvTable::read(&folder.join("correlations.csv"))? {
            let width = table.heading.len();
            let row = |row| (1..width).map(|column| table.number(row, column)).collect::<Result<Vec<f64>, _>>();
            let rows = table.rows.iter().map(row).collect::<Result<_, _>>()?;
            self.correlations = Some((table.heading.get(1..).unwrap_or_default().to_vec(), rows));
        }
        if let Some(table) = CsvTable::read(&folder.join("validation-errors.csv"))? {
            self.samples = samples(&table)?;
        }
        let count = self.samples.first().map_or(0, |sample| sample.lengths.len());
        self.cables = cable_names(folder, count)?;
        Ok(())
    }

    /// True for the rows of the candidate that is shown.
    fn is_own(&self, row: &(usize, Vec<String>), column: usize) -> bool {
        row.1.get(column) == self.shown.as_ref()
    }

    fn own_numbers(&self, table: &CsvTable, name: &str) -> Result<Vec<f64>, Failure> {
        let (candidate, value) = (table.column("candidate")?, table.column(name)?);
        let own = table.rows.iter().filter(|row| self.is_own(row, candidate));
        own.map(|row| table.number(row, value)).collect()
    }

    fn parameters_of(&self, table: &CsvTable) -> Result<Vec<ParameterData>, Failure> {
        let column = |name| table.column(name);
        let (candidate, name, unit) = (column("candidate")?, column("parameter")?, column("unit")?);
        let (start, value, sigma) = (column("start")?, column("value")?, column("sigma")?);
        let (prior_sigma, at_bound) = (column("prior_sigma")?, column("at_bound")?);
        let own = table.rows.iter().filter(|row| self.is_own(row, candidate));
        own.map(|row| {
            let text = |column: usize| row.1.get(column).cloned().unwrap_or_default();
            let number = |column| table.number(row, column).map(|value| Some(value).filter(|value| value.is_finite()));
            Ok(ParameterData {
                name: text(name),
                unit: text(unit),
                start: number(start)?,
                value: number(value)?,
                sigma: number(sigma)?,
                prior_sigma: number(prior_sigma)?,
                at_bound: text(at_bound) == "true",
            })
        })
        .collect()
    }
}

fn parsed(bytes: &[u8], file_name: &str) -> Result<ResultFile, Failure> {
    let text = text_from_bytes(bytes, Size::Table, file_name)?;
    serde_json::from_str(text).map_err(|error| {
        let line = text.lines().nth(error.line().saturating_sub(1)).unwrap_or_default();
        ReadError::new(file_name, "result::json", format!("this is no result: {error}"))
            .at(Place::on_line(line, error.line().max(1), error.column().max(1), 1))
            .with_help("a result is what `cdpr select`, `demo` or `identify` answer with --format json")
            .into()
    })
}

/// The criterion of its name in a result; position for an identification.
fn criterion(name: Option<&str>) -> Criterion {
    match name {
        Some("rotation") => Criterion::Rotation,
        Some("length") => Criterion::Length,
        Some("tension") => Criterion::Tension,
        _ => Criterion::Position,
    }
}

fn samples(table: &CsvTable) -> Result<Vec<SampleData>, Failure> {
    let sample = table.column("sample")?;
    let three = |names: [&str; 3]| -> Result<[usize; 3], Failure> {
        let [a, b, c] = names;
        Ok([table.column(a)?, table.column(b)?, table.column(c)?])
    };
    let (position, vector) = (three(["x_m", "y_m", "z_m"])?, three(["dx_m", "dy_m", "dz_m"])?);
    let (position_error, rotation_error) = (table.column("position_error_m")?, table.column("rotation_error_rad")?);
    let is_length = |(column, name): (usize, &String)| name.starts_with("length_error_m_").then_some(column);
    let lengths: Vec<usize> = table.heading.iter().enumerate().filter_map(is_length).collect();
    let mut rows = Vec::new();
    for row in &table.rows {
        let number = |column: usize| table.number(row, column);
        let [x, y, z] = position;
        let [dx, dy, dz] = vector;
        rows.push(SampleData {
            sample: number(sample)? as usize,
            position: [number(x)?, number(y)?, number(z)?],
            position_error: number(position_error)?,
            position_vector: [number(dx)?, number(dy)?, number(dz)?],
            rotation_error: number(rotation_error)?,
            lengths: lengths.iter().map(|&column| number(column)).collect::<Result<_, _>>()?,
        });
    }
    rows.sort_by_key(|row| row.sample);
    Ok(rows)
}

/// Names of the calibrated robot's cables with their numbers; numbers alone where there is none.
fn cable_names(folder: &Path, count: usize) -> Result<Vec<String>, Failure> {
    let path = folder.join("calibrated.toml");
    let robot = match files::read_if_there(&path, Size::Text)? {
        Some(bytes) => Some(Robot::from_toml_bytes(&bytes, &path.display().to_string())?),
        None => None,
    };
    let name = |index: usize| {
        let number = (index + 1).to_string();
        let name = robot.as_ref().and_then(|robot| robot.cables.get(index)).map(|cable| cable.name.as_str());
        match name {
            Some(name) if name != number => format!("cable {number}: {name}"),
            _ => format!("cable {number}"),
        }
    };
    Ok((0..count).map(name).collect())
}
