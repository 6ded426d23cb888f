//! The data that the script of the page draws from: one JSON block, which `viewer/src/data.ts` describes.
//!
//! The block holds the answer, which is `result.json` without wall times and the marks of a JSON answer, and what charts need besides: the robot as given and
//! calibrated, and the judged samples with the errors of both models. No physics is left to the script.

use cdpr_calibration::Evaluation;
use cdpr_model::geometry::Pose;
use schemars::JsonSchema;
use serde::Serialize;

use super::{Purpose, ReportPage, Shown};
use crate::answers::SelectionAnswer;
use crate::html_page::{PageKind, RobotPicture, data_block, digits, quaternion, vector};

/// Numbers that a page may hold for its samples (about 8 bytes each): more samples are thinned out.
const MOST_NUMBERS: usize = 90_000;

/// Data of a report: the answer, and what its pictures need besides.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "ReportData")]
pub(crate) struct PageData<'a> {
    /// Kind of the page.
    #[schemars(extend("const" = "report"))]
    page: &'static str,
    /// The answer without wall times.
    result: &'a SelectionAnswer<'a>,
    /// Index of the candidate that the details are about.
    shown: usize,
    /// Index of the robot as given, where it is another candidate.
    given: Option<usize>,
    criterion: CriterionWords,
    /// "validation data", or "the data of the fit" where nothing was held out.
    data_words: &'static str,
    /// True where candidates were compared.
    selection: bool,
    /// Robot with the parameters of the shown candidate.
    robot: RobotPicture,
    /// Robot as given.
    given_robot: RobotPicture,
    samples: SampleData,
    /// Positions of the fit's samples.
    fit_position_m: Vec<[f64; 3]>,
    /// Coefficients of the shown candidate's parameters: the lower triangle with the diagonal; null without free parameters.
    #[schemars(with = "Option<Vec<Vec<Option<f64>>>>")]
    correlation: Option<Vec<Vec<f64>>>,
}

/// Criterion for people: its unit, and the factor from SI to it.
#[derive(Serialize, JsonSchema)]
struct CriterionWords {
    words: String,
    unit: &'static str,
    factor: f64,
}

/// Samples that models were judged by, in the order of the data; every list has an entry for each.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "JudgedSamples")]
struct SampleData {
    /// Samples before thinning out.
    total: usize,
    /// Number of the sample in the data, from 1.
    number: Vec<usize>,
    time_s: Option<Vec<f64>>,
    position_m: Vec<[f64; 3]>,
    quaternion_xyzw: Vec<[f64; 4]>,
    recorded_length_m: Vec<Vec<f64>>,
    /// Recorded length minus that of the sample before in the data; null for the first.
    length_change_m: Vec<Option<Vec<f64>>>,
    /// Outside the ranges of the poses that its fit saw.
    outside: Vec<bool>,
    /// Explained by no candidate, so that no figure counts it.
    set_aside: Vec<bool>,
    calibrated: ErrorData,
    as_given: Option<ErrorData>,
}

/// Errors of a model, sample by sample.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "SampleErrors")]
struct ErrorData {
    /// Predicted minus measured position (world).
    position_error_m: Vec<Option<[f64; 3]>>,
    #[schemars(with = "Vec<Option<f64>>")]
    rotation_error_rad: Vec<f64>,
    /// Modelled minus recorded, per cable.
    #[schemars(with = "Vec<Vec<Option<f64>>>")]
    length_error_m: Vec<Vec<f64>>,
    /// Predicted minus recorded, per cable; null for a model that knows none, or data without.
    #[serde(rename = "tension_error_N")]
    #[schemars(with = "Option<Vec<Vec<Option<f64>>>>")]
    tension_error: Option<Vec<Vec<f64>>>,
}

/// The block; `null` without a candidate to show.
pub(super) fn json(page: &ReportPage<'_>, shown: Option<&Shown<'_>>) -> String {
    let data = shown.map(|shown| PageData {
        page: PageKind::Report.name(),
        result: &page.answer,
        shown: shown.index,
        given: shown.before().map(|given| given.index),
        criterion: CriterionWords {
            words: page.answer.criterion.to_string(),
            unit: page.answer.criterion.unit(),
            factor: page.answer.criterion.in_unit(1.0),
        },
        data_words: page.report.data_words(),
        selection: page.report.purpose == Purpose::Selection,
        robot: RobotPicture::of(shown.judgement.fit.model.robot(), &[]),
        given_robot: RobotPicture::of(page.report.robot, &[]),
        samples: samples(page, shown),
        fit_position_m: fit_positions(page),
        correlation: correlation(shown),
    });
    data_block(&data)
}

/// A judged sample: its row among the errors, and its index in the data.
#[derive(Clone, Copy)]
struct Row {
    row: usize,
    sample: usize,
}

/// True when the page holds a part of the samples only.
pub(super) fn is_thinned(page: &ReportPage<'_>, shown: &Shown<'_>) -> bool {
    rows(page, shown).len() < shown.judgement.validation_samples.len()
}

/// The judged samples in the order of the data, evenly thinned out to what a page may hold; the largest error always stays.
fn rows(page: &ReportPage<'_>, shown: &Shown<'_>) -> Vec<Row> {
    let judgement = shown.judgement;
    let mut all: Vec<Row> =
        judgement.validation_samples.iter().enumerate().map(|(row, &sample)| Row { row, sample }).collect();
    all.sort_by_key(|row| row.sample);
    let models = 1 + usize::from(shown.before().is_some());
    let per_cable = 2 + models * (1 + usize::from(judgement.validation.tension_error.is_some()));
    let numbers = 9 + 4 * models + per_cable * page.report.robot.cable_count();
    let step = (all.len() * numbers).div_ceil(MOST_NUMBERS).max(1);
    let error = |row: &Row| judgement.validation_errors.position[row.row];
    let worst = all.iter().filter(|row| error(row).is_finite()).max_by(|a, b| error(a).total_cmp(&error(b)));
    let worst = worst.map(|row| row.row);
    let kept = all.iter().enumerate().filter(|(index, row)| index % step == 0 || Some(row.row) == worst);
    kept.map(|(_, row)| *row).collect()
}

fn samples(page: &ReportPage<'_>, shown: &Shown<'_>) -> SampleData {
    let rows = rows(page, shown);
    let data = page.report.samples;
    let is_outside = &page.answer.coverage.is_outside;
    let pose = |row: &Row| -> &Pose { &data.poses[row.sample] };
    let change = |row: &Row| {
        let before = data.lengths_of(row.sample.checked_sub(1)?);
        let now = data.lengths_of(row.sample);
        Some(now.iter().zip(before).map(|(now, before)| digits(now - before, 4)).collect())
    };
    let lengths = |row: &Row| data.lengths_of(row.sample).iter().map(|length| digits(*length, 6)).collect();
    SampleData {
        total: shown.judgement.validation_samples.len(),
        number: rows.iter().map(|row| row.sample + 1).collect(),
        time_s: data.time.as_ref().map(|time| rows.iter().map(|row| time[row.sample]).collect()),
        position_m: rows.iter().map(|row| vector(&pose(row).position, 6)).collect(),
        quaternion_xyzw: rows.iter().map(|row| quaternion(pose(row), 6)).collect(),
        recorded_length_m: rows.iter().map(lengths).collect(),
        length_change_m: rows.iter().map(change).collect(),
        outside: rows.iter().map(|row| is_outside.get(row.row).copied().unwrap_or(false)).collect(),
        set_aside: rows.iter().map(|row| shown.judgement.set_aside.contains(&row.row)).collect(),
        calibrated: errors(&rows, &shown.judgement.validation_errors),
        as_given: shown.before().map(|given| errors(&rows, &given.judgement.validation_errors)),
    }
}

fn errors(rows: &[Row], evaluation: &Evaluation) -> ErrorData {
    let cables = evaluation.cable_count;
    let per_cable = |all: &[f64], row: &Row| -> Vec<f64> {
        all.get(row.row * cables..(row.row + 1) * cables).unwrap_or_default().iter().map(|e| digits(*e, 4)).collect()
    };
    let position = |row: &Row| {
        let error = evaluation.position_vector.get(row.row)?;
        error.iter().all(|value| value.is_finite()).then(|| error.map(|value| digits(value, 4)))
    };
    let tensions = !evaluation.tension.is_empty();
    ErrorData {
        position_error_m: rows.iter().map(position).collect(),
        rotation_error_rad: rows.iter().map(|row| digits(evaluation.rotation[row.row], 4)).collect(),
        length_error_m: rows.iter().map(|row| per_cable(&evaluation.length, row)).collect(),
        tension_error: tensions.then(|| rows.iter().map(|row| per_cable(&evaluation.tension, row)).collect()),
    }
}

/// Positions of the data of the reported fit, at most 2000 of them and the corners of their box.
fn fit_positions(page: &ReportPage<'_>) -> Vec<[f64; 3]> {
    let all: Vec<usize> = match page.report.folds {
        [fold] => fold.train.clone(),
        _ => (0..page.report.samples.len()).collect(),
    };
    let step = all.len().div_ceil(2000).max(1);
    let position = |sample: usize| page.report.samples.poses[sample].position;
    let extreme = |axis: usize, sign: f64| {
        let at = |sample: &usize| sign * position(*sample)[axis];
        all.iter().copied().max_by(|a, b| at(a).total_cmp(&at(b)))
    };
    let corners = (0..3).flat_map(|axis| [extreme(axis, 1.0), extreme(axis, -1.0)]).flatten();
    all.iter().copied().step_by(step).chain(corners).map(|sample| vector(&position(sample), 6)).collect()
}

fn correlation(shown: &Shown<'_>) -> Option<Vec<Vec<f64>>> {
    let rows = &shown.judgement.fit.analysis.correlation_rows;
    let is_there = !rows.is_empty() && rows.len() == shown.judgement.fit.parameters.len();
    is_there.then(|| rows.iter().map(|row| row.iter().map(|value| digits(*value, 3)).collect()).collect())
}
