//! What the model leaves unexplained: residuals of the lengths, position errors and where they occur.

use cdpr::geometry::Pose;
use minijinja::{Value, context};

use super::chart::{self, Map, MapPoint};
use super::parameters::chart_value;
use super::{Report, Shown, number};

/// The charts on validation data.
pub(super) fn remains(report: &Report<'_>, shown: &Shown<'_>) -> Value {
    let errors = &shown.judgement.validation_errors;
    let millimetres: Vec<f64> = errors.position.iter().map(|error| 1e3 * error).collect();
    let mean = 1e3 * shown.judgement.validation.position_error_m.mean;
    let mean_words = format!("mean {} mm", number::significant(mean, 4));
    let histogram = chart::histogram(&millimetres, "position error in mm", (mean, &mean_words));
    let top = colour_top(&millimetres);
    let maps: Value = views(report)
        .into_iter()
        .filter_map(|view| {
            Some(context! { plane => view.name(), svg => chart_value(Some(map(report, shown, &view, top)?)) })
        })
        .collect();
    context! {
        residuals => chart_value(chart::residuals(&by_cable(report, shown))),
        banded => errors.len() > 300,
        histogram => chart_value(histogram),
        maps,
        top => number::significant(top, 3),
        clipped => millimetres.iter().filter(|error| **error > top).count(),
    }
}

/// Length residuals (mm) of every cable by sample number from 1, in the order of the data.
fn by_cable(report: &Report<'_>, shown: &Shown<'_>) -> Vec<(String, Vec<(usize, f64)>)> {
    let judgement = shown.judgement;
    let errors = &judgement.validation_errors;
    let mut order: Vec<(usize, usize)> =
        judgement.validation_samples.iter().enumerate().map(|(row, &sample)| (sample, row)).collect();
    order.sort_unstable();
    let series = |cable: usize| {
        let at = |&(sample, row): &(usize, usize)| {
            Some((sample + 1, 1e3 * errors.length.get(row * errors.cable_count + cable)?))
        };
        order.iter().filter_map(at).collect()
    };
    let cables = report.robot.cables.iter().enumerate().take(errors.cable_count);
    cables
        .map(|(index, cable)| {
            let number = (index + 1).to_string();
            let name = if cable.name == number {
                format!("cable {number}")
            } else {
                format!("cable {number}: {}", cable.name)
            };
            (name, series(index))
        })
        .collect()
}

/// A projection of positions.
struct View {
    axes: [(String, cdpr::nalgebra::Vector3<f64>); 2],
}

impl View {
    fn name(&self) -> String {
        format!("{}–{}", self.axes[0].0, self.axes[1].0)
    }

    fn of(&self, pose: &Pose) -> [f64; 2] {
        [0, 1].map(|axis| self.axes[axis].1.dot(&pose.position))
    }
}

/// The plane of a planar robot; x–y and x–z of a spatial one.
fn views(report: &Report<'_>) -> Vec<View> {
    use cdpr::nalgebra::Vector3;
    let robot = report.robot;
    if robot.motion_pattern.is_planar() {
        let mut letters = robot.plane.axes().chars().map(String::from).collect::<Vec<_>>().into_iter();
        let mut letter = || letters.next().unwrap_or_default();
        let axes = [(letter(), robot.plane.first_axis()), (letter(), robot.plane.second_axis())];
        return vec![View { axes }];
    }
    let (x, y, z) = (Vector3::x(), Vector3::y(), Vector3::z());
    vec![
        View { axes: [("x".to_owned(), x), ("y".to_owned(), y)] },
        View { axes: [("x".to_owned(), x), ("z".to_owned(), z)] },
    ]
}

fn map(report: &Report<'_>, shown: &Shown<'_>, view: &View, top: f64) -> Option<String> {
    let judgement = shown.judgement;
    let rows = judgement.validation_samples.iter().zip(&judgement.validation_errors.position);
    let points = rows.filter_map(|(&sample, &error)| {
        let pose = report.samples.poses.get(sample)?;
        Some(MapPoint { at: view.of(pose), error: 1e3 * error })
    });
    let axes = [0, 1].map(|axis| view.axes[axis].0.clone());
    Map { points: points.collect(), axes, top, colour_label: "position error in mm".to_owned() }.svg()
}

/// The largest error, unless few outliers would leave one colour to all others: then three times the 95 % quantile.
fn colour_top(errors: &[f64]) -> f64 {
    let mut sorted: Vec<f64> = errors.iter().copied().filter(|error| error.is_finite()).collect();
    sorted.sort_by(f64::total_cmp);
    let Some(&largest) = sorted.last() else { return 1.0 };
    let p95 = sorted[(sorted.len() - 1) * 95 / 100];
    let top = if largest > 3.0 * p95 && p95 > 0.0 { 3.0 * p95 } else { largest };
    if top > 0.0 { top } else { 1.0 }
}
