//! The tables of the page, which need no script.

use cdpr_model::control::error_statistics::PoseErrorStatistics;
use cdpr_study::field::{Sample, Summary};
use minijinja::{Value, context};

use super::StudyPage;
use crate::answers::{axis_names, error_rows};
use crate::number_format::{fixed, significant};

/// Poses that the table lists; `errors.csv` holds all.
pub(super) const MOST_POSES: usize = 200;

/// Error statistics by rows, each a name, a unit and five numbers.
pub(super) fn errors(summary: &Summary, turns: bool) -> Value {
    let rows = error_rows(summary).into_iter().filter(|row| turns || row.unit != "°");
    rows.map(|row| {
        let PoseErrorStatistics { mean, rms, median, p95, max } = row.error;
        let cells = [mean, rms, median, p95, max].map(|value| significant(row.factor * value, 4));
        context! { name => row.name, unit => row.unit, cells => cells.to_vec() }
    })
    .collect()
}

/// The first poses: titles of the columns, and rows of cells.
pub(super) fn poses(page: &StudyPage<'_>) -> Value {
    let robot = page.experiment.machine.robot();
    let (pattern, axes) = (robot.motion_pattern, axis_names(robot));
    let angles: &[&str] = match pattern.dof() - axes.len() {
        0 => &[],
        1 => &["angle"],
        _ => &["rx", "ry", "rz"],
    };
    let mut titles = vec!["pose".to_owned()];
    titles.extend(axes.iter().map(|axis| format!("{axis}, m")));
    titles.extend(angles.iter().map(|angle| format!("{angle}, °")));
    titles.extend(axes.iter().map(|axis| format!("error {axis}, mm")));
    titles.push("error, mm".to_owned());
    titles.extend(pattern.has_rotation().then(|| "rotation error, °".to_owned()));
    titles.push("linear step, mm".to_owned());
    let has_tensions = page.experiment.tensions_emerge();
    titles.extend(has_tensions.then(|| "tensions, N".to_owned()));
    let tracks = page.found.summary.tension_error.is_some();
    titles.extend(tracks.then(|| "commanded, N".to_owned()));
    let row = |(index, sample): (usize, &Sample)| -> Vec<String> {
        let components = pattern.pose_to_components(robot.plane, &sample.commanded);
        let mut cells = vec![(index + 1).to_string()];
        cells.extend(components[..axes.len()].iter().map(|at| fixed(*at, 3)));
        cells.extend(components[axes.len()..].iter().map(|angle| fixed(angle.to_degrees(), 2)));
        let shift = sample.exact.map(|error| crate::answers::components(robot, &error.fixed_rows::<3>(0).into_owned()));
        let millimetres = |length: Option<f64>| significant(1e3 * length.unwrap_or(f64::NAN), 4);
        cells.extend((0..axes.len()).map(|axis| millimetres(shift.as_ref().map(|shift| shift[axis]))));
        cells.push(millimetres(sample.exact.map(|error| error.fixed_rows::<3>(0).norm())));
        if pattern.has_rotation() {
            let angle = sample.exact.map_or(f64::NAN, |error| error.fixed_rows::<3>(3).norm());
            cells.push(significant(angle.to_degrees(), 3));
        }
        cells.push(millimetres(sample.linear.map(|error| error.fixed_rows::<3>(0).norm())));
        if has_tensions {
            let listed = |tensions: &Option<Vec<f64>>| {
                let answered = tensions.as_ref().filter(|_| sample.exact.is_some());
                let all = |tensions: &Vec<f64>| tensions.iter().map(|f| fixed(*f, 0)).collect::<Vec<_>>().join(", ");
                answered.map_or_else(|| "–".to_owned(), all)
            };
            cells.push(listed(&sample.outcome.tensions));
            cells.extend(tracks.then(|| listed(&sample.outcome.commanded_tensions)));
        }
        cells
    };
    let rows: Vec<Vec<String>> = page.found.samples.iter().take(MOST_POSES).enumerate().map(row).collect();
    context! { titles, rows }
}
