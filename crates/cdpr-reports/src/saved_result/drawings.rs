//! The figures as drawings.

use cdpr_calibration::Difference;
use cdpr_calibration::selection::{ComparedError, SelectionCriterion};

use super::numbers::{CandidateData, ComparedData};
use super::{FigureFile, SampleData, SavedResult};
use crate::figures::{Figure, Ladder, Map, MapPoint, NamedError, convergence, correlations, residuals, spectrum};

/// A part of the largest extent below which positions lie in a plane.
const FLATNESS: f64 = 1e-6;

const WITHOUT_LADDER: &str =
    "no candidates were compared, or the result is older than the differences that the ladder shows";

/// Every drawing.
pub(super) fn all(data: &SavedResult) -> Vec<FigureFile> {
    let in_folder = "the result has no such numbers; a folder that this version's `select` or `demo` wrote has them";
    let figure =
        |name, drawn: Option<Figure>, why_not| FigureFile { name, content: drawn.map(|drawn| drawn.file()), why_not };
    let matrix = data.correlations.as_ref();
    let mut all = vec![
        figure("model-ladder.svg", ladder(data), WITHOUT_LADDER),
        figure("residuals.svg", residuals(&by_cable(data)), in_folder),
        figure("correlations.svg", matrix.and_then(|(names, rows)| correlations(names, rows)), in_folder),
        figure("singular-values.svg", spectrum(&data.singular_values, data.rank), "nothing was free"),
        figure("convergence.svg", convergence(&data.convergence), "the fit made no step"),
    ];
    all.extend(maps(data, in_folder));
    all
}

fn ladder<'a>(data: &'a SavedResult) -> Option<Figure> {
    let unit = match data.criterion {
        SelectionCriterion::Rotation => "rad",
        SelectionCriterion::Tension => "N",
        _ => "m",
    };
    let named = |own: &'a CandidateData| NamedError {
        name: &own.name,
        compared: own.compared.as_ref().map(|own| compared(own, unit)),
    };
    let all: Vec<_> = data.candidates.iter().map(named).collect();
    let recommended = data.candidates.iter().position(|own| Some(&own.name) == data.recommended.as_ref());
    Ladder::of(data.criterion, "validation data", &all, recommended).svg()
}

fn compared(data: &ComparedData, unit: &'static str) -> ComparedError {
    let number = |value: Option<f64>| value.unwrap_or(f64::NAN);
    let [mean, standard_error] = [data.difference, data.difference_standard_error].map(number);
    ComparedError {
        unit,
        is_of_pose: data.by == "pose",
        mean: number(data.mean),
        difference: Difference { mean, standard_error },
        as_good_within: number(data.as_good_within),
        is_as_good: data.as_good_as_best,
    }
}

/// Residuals (mm) of every cable by sample.
fn by_cable(data: &SavedResult) -> Vec<(String, Vec<(usize, f64)>)> {
    let series = |cable: usize| {
        let at = |sample: &SampleData| Some((sample.sample, 1e3 * sample.lengths.get(cable)?));
        data.samples.iter().filter_map(at).collect()
    };
    data.cables.iter().enumerate().map(|(cable, name)| (name.clone(), series(cable))).collect()
}

/// Position errors seen from above and from the side; of a planar robot in its plane.
fn maps(data: &SavedResult, in_folder: &'static str) -> Vec<FigureFile> {
    const VIEWS: [(&str, [usize; 2]); 3] =
        [("error-map-xy.svg", [0, 1]), ("error-map-xz.svg", [0, 2]), ("error-map-yz.svg", [1, 2])];
    let extent = |axis: usize| {
        let values = || data.samples.iter().map(|sample| sample.position[axis]).filter(|value| value.is_finite());
        values().fold(f64::NEG_INFINITY, f64::max) - values().fold(f64::INFINITY, f64::min)
    };
    let extents = [0, 1, 2].map(extent);
    let largest = extents.into_iter().fold(0.0, f64::max);
    let flat = |axis: usize| !(extents[axis] > FLATNESS * largest);
    let beside_the_plane = [0, 1, 2].into_iter().find(|axis| !data.axes.contains(axis));
    let chosen: Vec<_> = match beside_the_plane.or_else(|| [0, 1, 2].into_iter().find(|&axis| flat(axis))) {
        Some(normal) => VIEWS.into_iter().filter(|(_, axes)| !axes.contains(&normal)).collect(),
        None => VIEWS[..2].to_vec(),
    };
    let top = colour_top(&data.samples.iter().map(|sample| 1e3 * sample.position_error).collect::<Vec<_>>());
    let map = |axes: [usize; 2]| {
        let point = |sample: &SampleData| MapPoint {
            at: axes.map(|axis| sample.position[axis]),
            error: 1e3 * sample.position_error,
        };
        let axes = axes.map(|axis| ["x", "y", "z"][axis].to_owned());
        let points = data.samples.iter().map(point).collect();
        Map {
            title: Vec::new(),
            points,
            arrows: Vec::new(),
            axes,
            top,
            colour_label: "position error in mm".to_owned(),
        }
        .svg()
        .map(|map| map.file())
    };
    chosen.into_iter().map(|(name, axes)| FigureFile { name, content: map(axes), why_not: in_folder }).collect()
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
