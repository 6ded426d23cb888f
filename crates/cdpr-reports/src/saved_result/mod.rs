//! A result read back from its JSON answer and the tables of its folder, and its figures as drawings or as numbers.

mod csv_table;
mod drawings;
mod numbers;
mod tables;

use cdpr_calibration::selection::SelectionCriterion;
use cdpr_model::reading::{ReadError, Size, TextPlace, text_from_bytes};
use cdpr_model::robot::Robot;
use serde::Deserialize;

use crate::NamedFile;
use csv_table::CsvTable;
use numbers::{AXES, CandidateData, ParameterData, SampleData};
pub use numbers::{FigureFile, SavedResult};

/// The keys of a JSON answer that figures need; those of an identification stand at the top.
#[derive(Deserialize)]
struct ResultFile {
    #[serde(default)]
    candidates: Vec<CandidateData>,
    criterion: Option<SelectionCriterion>,
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

impl SavedResult {
    /// Result of a JSON answer.
    pub fn from_json(file: &NamedFile) -> Result<Self, ReadError> {
        Ok(Self::of_answer(parsed(&file.content, &file.name)?))
    }

    /// Drawings as SVG.
    pub fn drawings(&self) -> Vec<FigureFile> {
        drawings::all(self)
    }

    /// Numbers behind the drawings as CSV.
    pub fn tables(&self) -> Vec<FigureFile> {
        tables::all(self)
    }

    fn of_answer(answer: ResultFile) -> Self {
        let shown = answer.recommended.clone().or(answer.best).or(answer.model);
        let own = answer.candidates.iter().find(|candidate| Some(&candidate.name) == shown.as_ref());
        let finite = |list: Vec<Option<f64>>| list.into_iter().map(|value| value.unwrap_or(f64::NAN)).collect();
        Self {
            criterion: answer.criterion.unwrap_or_default(),
            rank: own.and_then(|candidate| candidate.rank).or(answer.rank).unwrap_or(0),
            robot: answer.robot,
            recommended: answer.recommended,
            shown,
            parameters: answer.parameters,
            singular_values: finite(answer.singular_values),
            convergence: finite(answer.history),
            candidates: answer.candidates,
            correlations: None,
            samples: Vec::new(),
            axes: vec![0, 1, 2],
            cables: Vec::new(),
        }
    }

    /// Adds the tables of the result's folder; `read` gives a file of the folder by its name there, or none where it is absent.
    pub fn read_tables<E: From<ReadError>>(
        &mut self,
        mut read: impl FnMut(&str) -> Result<Option<NamedFile>, E>,
    ) -> Result<(), E> {
        let mut table = |name: &str| -> Result<Option<CsvTable>, E> { Ok(read(name)?.map(CsvTable::of).transpose()?) };
        if let Some(table) = table("parameters.csv")? {
            self.parameters = self.parameters_of(&table)?;
        }
        if let Some(table) = table("singular-values.csv")? {
            self.singular_values = self.own_numbers(&table, "singular_value")?;
        }
        if let Some(table) = table("convergence.csv")? {
            self.convergence = self.own_numbers(&table, "weighted_sum_of_squares")?;
        }
        if let Some(table) = table("correlations.csv")? {
            self.correlations = Some(correlations(&table)?);
        }
        if let Some(table) = table("validation-errors.csv")? {
            self.axes = axes(&table);
            self.samples = samples(&table, &self.axes)?;
        }
        let count = self.samples.first().map_or(0, |sample| sample.lengths.len());
        let robot = read("calibrated.toml")?;
        let robot = robot.map(|file| Robot::from_toml_bytes(&file.content, &file.name)).transpose()?;
        self.cables = cable_names(robot.as_ref(), count);
        Ok(())
    }

    /// True for the rows of the candidate that is shown.
    fn is_own(&self, row: &(usize, Vec<String>), column: usize) -> bool {
        row.1.get(column) == self.shown.as_ref()
    }

    fn own_numbers(&self, table: &CsvTable, name: &str) -> Result<Vec<f64>, ReadError> {
        let (candidate, value) = (table.column("candidate")?, table.column(name)?);
        let own = table.rows.iter().filter(|row| self.is_own(row, candidate));
        own.map(|row| table.number(row, value)).collect()
    }

    fn parameters_of(&self, table: &CsvTable) -> Result<Vec<ParameterData>, ReadError> {
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

fn parsed(bytes: &[u8], file_name: &str) -> Result<ResultFile, ReadError> {
    let text = text_from_bytes(bytes, Size::Table, file_name)?;
    serde_json::from_str(text).map_err(|error| {
        let line = text.lines().nth(error.line().saturating_sub(1)).unwrap_or_default();
        ReadError::new(file_name, "result::json", format!("this is no result: {error}"))
            .at(TextPlace::on_line(line, error.line().max(1), error.column().max(1), 1))
            .with_help("a result is what `cdpr select`, `demo` or `identify` answer with --format json")
    })
}

/// Names of the parameters, and the rows of the matrix.
fn correlations(table: &CsvTable) -> Result<(Vec<String>, Vec<Vec<f64>>), ReadError> {
    let row = |row| (1..table.heading.len()).map(|column| table.number(row, column)).collect::<Result<Vec<f64>, _>>();
    let rows = table.rows.iter().map(row).collect::<Result<_, _>>()?;
    Ok((table.heading.get(1..).unwrap_or_default().to_vec(), rows))
}

/// Axes whose columns a table of errors has: all, or the two of a plane.
fn axes(table: &CsvTable) -> Vec<usize> {
    let has = |axis: &usize| table.column(&format!("{}_m", AXES[*axis])).is_ok();
    let found: Vec<usize> = (0..3).filter(has).collect();
    if found.len() < 2 { vec![0, 1, 2] } else { found }
}

fn samples(table: &CsvTable, axes: &[usize]) -> Result<Vec<SampleData>, ReadError> {
    let sample = table.column("sample")?;
    let columns = |before: &str| -> Result<Vec<usize>, ReadError> {
        axes.iter().map(|&axis| table.column(&format!("{before}{}_m", AXES[axis]))).collect()
    };
    let (position, shift) = (columns("")?, columns("d")?);
    let (position_error, rotation_error) = (table.column("position_error_m")?, table.column("rotation_error_rad")?);
    let is_length = |(column, name): (usize, &String)| name.starts_with("length_error_m_").then_some(column);
    let lengths: Vec<usize> = table.heading.iter().enumerate().filter_map(is_length).collect();
    let mut rows = Vec::new();
    for row in &table.rows {
        let number = |column: usize| table.number(row, column);
        let vector = |columns: &[usize]| -> Result<[f64; 3], ReadError> {
            let mut vector = [0.0; 3];
            for (&axis, &column) in axes.iter().zip(columns) {
                vector[axis] = number(column)?;
            }
            Ok(vector)
        };
        rows.push(SampleData {
            sample: number(sample)? as usize,
            position: vector(&position)?,
            position_error: number(position_error)?,
            position_vector: vector(&shift)?,
            rotation_error: number(rotation_error)?,
            lengths: lengths.iter().map(|&column| number(column)).collect::<Result<_, _>>()?,
        });
    }
    rows.sort_by_key(|row| row.sample);
    Ok(rows)
}

/// Names of the calibrated robot's cables with their numbers; numbers alone where there is none.
fn cable_names(robot: Option<&Robot>, count: usize) -> Vec<String> {
    let name = |index: usize| {
        let number = (index + 1).to_string();
        let name = robot.and_then(|robot| robot.cables.get(index)).map(|cable| cable.name.as_str());
        match name {
            Some(name) if name != number => format!("cable {number}: {name}"),
            _ => format!("cable {number}"),
        }
    };
    (0..count).map(name).collect()
}
