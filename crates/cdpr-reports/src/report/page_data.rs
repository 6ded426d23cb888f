//! The data that the script of the page draws from: one JSON block. `viewer/src/data.ts` is its reader.
//!
//! SI units, named in the keys. The block holds `result.json` without wall times and the marks of a JSON answer, and what charts need
//! besides: the robot as given and calibrated, and the judged samples with the errors of both models. No physics is left to the script.

use cdpr_calibration::Evaluation;
use cdpr_model::cable::winch::Winch;
use cdpr_model::geometry::Pose;
use cdpr_model::robot::Cable;
use serde::Serialize;

use super::{Purpose, Report, Shown};
use crate::answers::SelectionAnswer;
use crate::html_page::{PlaneData, digits, inside_script, plain, vector};

/// Numbers that a page may hold for its samples (about 8 bytes each): more samples are thinned out.
const MOST_NUMBERS: usize = 90_000;

/// The whole block.
#[derive(Serialize)]
struct PageData<'a> {
    result: SelectionAnswer,
    /// Index of the candidate that the details are about.
    shown: usize,
    /// Index of the robot as given, where it is another candidate.
    given: Option<usize>,
    criterion: CriterionWords,
    data_words: &'a str,
    selection: bool,
    robot: RobotData,
    samples: SampleData,
    /// Positions of the fit's samples.
    fit_position_m: Vec<[f64; 3]>,
    /// `None` without free parameters.
    correlation: Option<CorrelationData>,
}

/// The criterion for people: its unit, and what a value in SI is multiplied by.
#[derive(Serialize)]
struct CriterionWords {
    words: String,
    unit: &'static str,
    factor: f64,
}

#[derive(Serialize)]
struct RobotData {
    plane: Option<PlaneData>,
    turns: bool,
    cables: Vec<CableData>,
}

#[derive(Serialize)]
struct CableData {
    name: String,
    frame_anchor_nominal_m: [f64; 3],
    frame_anchor_m: [f64; 3],
    platform_anchor_nominal_m: [f64; 3],
    platform_anchor_m: [f64; 3],
    pulley: Option<PulleyData>,
    drum: Option<DrumData>,
}

/// A drum whose place the file states: the ends of its groove on the axis, and the way of the cable to its first pulley at the start angle.
#[derive(Serialize)]
struct DrumData {
    radius_m: f64,
    from_m: [f64; 3],
    to_m: [f64; 3],
    way_m: Option<[[f64; 3]; 2]>,
}

/// Length of a groove that the file leaves open, in radii of its drum.
const OPEN_GROOVE: f64 = 3.0;

impl DrumData {
    fn of(cable: &Cable) -> Option<Self> {
        let winch = &cable.winch;
        let (radius, position, axis) = (winch.radius?, winch.position?, *winch.axis?);
        let length = winch.groove.and_then(|groove| groove.ends).map_or(OPEN_GROOVE * radius, |ends| ends.length);
        let drum = Winch::of(cable).and_then(Result::ok);
        let leaves = drum.and_then(|winch| winch.drum.departure(winch.drum.parameters().start_angle).ok().flatten());
        let first_pulley = winch.first_pulley.unwrap_or(cable.frame_anchor);
        Some(Self {
            radius_m: digits(radius, 6),
            from_m: vector(&position, 6),
            to_m: vector(&(position + axis * length), 6),
            way_m: leaves.map(|leaves| [vector(&leaves.contact, 6), vector(&first_pulley, 6)]),
        })
    }
}

/// A pulley that the file states with radius and axis.
#[derive(Serialize)]
struct PulleyData {
    radius_m: f64,
    swivel_axis: [f64; 3],
}

/// The judged samples, in the order of the data; every list has an entry for each.
#[derive(Serialize)]
struct SampleData {
    /// Samples before thinning out.
    total: usize,
    /// Number of the sample in the data, from 1.
    number: Vec<usize>,
    time_s: Option<Vec<f64>>,
    position_m: Vec<[f64; 3]>,
    quaternion_xyzw: Vec<[f64; 4]>,
    recorded_length_m: Vec<Vec<f64>>,
    /// Recorded length minus that of the sample before in the data; `None` for the first.
    length_change_m: Vec<Option<Vec<f64>>>,
    /// Outside the ranges of the poses that its fit saw.
    outside: Vec<bool>,
    /// Explained by no candidate, so that no figure counts it.
    set_aside: Vec<bool>,
    calibrated: ErrorData,
    as_given: Option<ErrorData>,
}

/// Errors of a model; NaN becomes null.
#[derive(Serialize)]
struct ErrorData {
    /// Predicted minus measured position (world).
    position_error_m: Vec<Option<[f64; 3]>>,
    rotation_error_rad: Vec<f64>,
    /// Modelled minus recorded, per cable.
    length_error_m: Vec<Vec<f64>>,
    /// Predicted minus recorded, per cable; `None` for a model that knows none, or data without.
    #[serde(rename = "tension_error_N")]
    tension_error: Option<Vec<Vec<f64>>>,
}

/// The lower triangle, with the diagonal.
#[derive(Serialize)]
struct CorrelationData {
    names: Vec<String>,
    lower: Vec<Vec<f64>>,
}

/// The block as text that may stand inside a `script` element; `null` without a candidate to show.
pub(super) fn json(report: &Report<'_>, shown: Option<&Shown<'_>>) -> String {
    let data = shown.map(|shown| PageData {
        result: SelectionAnswer::new(report),
        shown: shown.index,
        given: shown.before().map(|given| given.index),
        criterion: CriterionWords {
            words: report.criterion.to_string(),
            unit: report.criterion.unit(),
            factor: report.criterion.in_unit(1.0),
        },
        data_words: report.data_words(),
        selection: report.purpose == Purpose::Selection,
        robot: robot(report, shown),
        samples: samples(report, shown),
        fit_position_m: fit_positions(report),
        correlation: correlation(report, shown),
    });
    let text = serde_json::to_string(&data).expect("strings and numbers only");
    inside_script(&text)
}

fn robot(report: &Report<'_>, shown: &Shown<'_>) -> RobotData {
    let nominal = report.robot;
    let calibrated = &shown.judgement.fit.model.robot().cables;
    let cables = nominal.cables.iter().zip(calibrated).enumerate().map(|(index, (before, after))| CableData {
        name: cable_name(index + 1, &before.name),
        frame_anchor_nominal_m: vector(&before.frame_anchor, 6),
        frame_anchor_m: vector(&after.frame_anchor, 6),
        platform_anchor_nominal_m: vector(&before.platform_anchor, 6),
        platform_anchor_m: vector(&after.platform_anchor, 6),
        pulley: after
            .pulley_radius()
            .zip(after.pulley_swivel_axis())
            .map(|(radius, axis)| PulleyData { radius_m: digits(radius, 6), swivel_axis: vector(&axis, 6) }),
        drum: DrumData::of(after),
    });
    RobotData { plane: PlaneData::of(nominal), turns: nominal.motion_pattern.has_rotation(), cables: cables.collect() }
}

fn cable_name(number: usize, name: &str) -> String {
    let number = number.to_string();
    if name == number { format!("cable {number}") } else { plain(&format!("cable {number}: {name}")) }
}

/// A judged sample: its row among the errors, and its index in the data.
#[derive(Clone, Copy)]
struct Row {
    row: usize,
    sample: usize,
}

/// True when the page holds a part of the samples only.
pub(super) fn is_thinned(report: &Report<'_>, shown: &Shown<'_>) -> bool {
    rows(report, shown).len() < shown.judgement.validation_samples.len()
}

/// The judged samples in the order of the data, evenly thinned out to what a page may hold; the largest error always stays.
fn rows(report: &Report<'_>, shown: &Shown<'_>) -> Vec<Row> {
    let judgement = shown.judgement;
    let mut all: Vec<Row> =
        judgement.validation_samples.iter().enumerate().map(|(row, &sample)| Row { row, sample }).collect();
    all.sort_by_key(|row| row.sample);
    let models = 1 + usize::from(shown.before().is_some());
    let per_cable = 2 + models * (1 + usize::from(judgement.validation.tension_error.is_some()));
    let numbers = 9 + 4 * models + per_cable * report.robot.cable_count();
    let step = (all.len() * numbers).div_ceil(MOST_NUMBERS).max(1);
    let error = |row: &Row| judgement.validation_errors.position[row.row];
    let worst = all.iter().filter(|row| error(row).is_finite()).max_by(|a, b| error(a).total_cmp(&error(b)));
    let worst = worst.map(|row| row.row);
    let kept = all.iter().enumerate().filter(|(index, row)| index % step == 0 || Some(row.row) == worst);
    kept.map(|(_, row)| *row).collect()
}

fn samples(report: &Report<'_>, shown: &Shown<'_>) -> SampleData {
    let rows = rows(report, shown);
    let data = report.samples;
    let is_outside = cdpr_calibration::coverage(report.robot, data, report.folds).is_outside;
    let pose = |row: &Row| -> &Pose { &data.poses[row.sample] };
    let change = |row: &Row| {
        let before = data.lengths_of(row.sample.checked_sub(1)?);
        let now = data.lengths_of(row.sample);
        Some(now.iter().zip(before).map(|(now, before)| digits(now - before, 4)).collect())
    };
    let quaternion = |row: &Row| -> [f64; 4] {
        let [x, y, z, w]: [f64; 4] = pose(row).rotation.coords.into();
        [x, y, z, w].map(|value| digits(value, 6))
    };
    let lengths = |row: &Row| data.lengths_of(row.sample).iter().map(|length| digits(*length, 6)).collect();
    SampleData {
        total: shown.judgement.validation_samples.len(),
        number: rows.iter().map(|row| row.sample + 1).collect(),
        time_s: data.time.as_ref().map(|time| rows.iter().map(|row| time[row.sample]).collect()),
        position_m: rows.iter().map(|row| vector(&pose(row).position, 6)).collect(),
        quaternion_xyzw: rows.iter().map(quaternion).collect(),
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
fn fit_positions(report: &Report<'_>) -> Vec<[f64; 3]> {
    let all: Vec<usize> = match report.folds {
        [fold] => fold.train.clone(),
        _ => (0..report.samples.len()).collect(),
    };
    let step = all.len().div_ceil(2000).max(1);
    let position = |sample: usize| report.samples.poses[sample].position;
    let extreme = |axis: usize, sign: f64| {
        let at = |sample: &usize| sign * position(*sample)[axis];
        all.iter().copied().max_by(|a, b| at(a).total_cmp(&at(b)))
    };
    let corners = (0..3).flat_map(|axis| [extreme(axis, 1.0), extreme(axis, -1.0)]).flatten();
    all.iter().copied().step_by(step).chain(corners).map(|sample| vector(&position(sample), 6)).collect()
}

fn correlation(report: &Report<'_>, shown: &Shown<'_>) -> Option<CorrelationData> {
    let fit = &shown.judgement.fit;
    let names: Vec<String> = fit.parameters.iter().map(|estimate| estimate.parameter.name(report.robot)).collect();
    let lower = fit.analysis.correlation_rows.iter().map(|row| row.iter().map(|value| digits(*value, 3)).collect());
    let lower: Vec<Vec<f64>> = lower.collect();
    (!names.is_empty() && lower.len() == names.len()).then_some(CorrelationData { names, lower })
}
