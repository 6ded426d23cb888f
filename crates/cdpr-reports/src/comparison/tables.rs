//! Tables of a result's folder.

use std::fmt::Write;

use cdpr_calibration::selection::{JudgedCandidate, Judgement};
use cdpr_model::reading::Keyword;

use super::Comparison;
use crate::answers::{axis_names, components};

/// Judged candidates with their names.
fn judged(comparison: &Comparison) -> impl Iterator<Item = (&JudgedCandidate, &Judgement)> {
    comparison.selection.candidates.iter().filter_map(|candidate| Some((candidate, candidate.outcome.as_ref().ok()?)))
}

/// A field of a table; empty where there is no number.
fn field(value: f64) -> String {
    if value.is_nan() { String::new() } else { value.to_string() }
}

pub(super) fn candidates(comparison: &Comparison) -> String {
    let mut text = String::from(
        "candidate,parameter_count,criterion,standard_error,train_position_mean_m,validation_position_mean_m,\
         validation_rotation_mean_rad,validation_length_rms_m,rank,condition,validation_samples,answered,at_bound,\
         weak_direction_count,weak_direction_deviation_m,loss,outliers\n",
    );
    for (candidate, judgement) in judged(comparison) {
        let (train, validation, analysis) = (&judgement.train, &judgement.validation, &judgement.fit.analysis);
        let errors = [
            judgement.criterion,
            judgement.standard_error,
            train.position_error_m.mean,
            validation.position_error_m.mean,
            validation.rotation_error_rad.mean,
            validation.length_error_m.rms,
        ];
        let _ = writeln!(
            text,
            "\"{}\",{},{},{},{},{},{},{},{},{},{},{}",
            candidate.name,
            judgement.fit.parameters.len(),
            errors.map(field).join(","),
            analysis.rank,
            analysis.condition,
            validation.samples,
            validation.answered,
            judgement.fit.at_bound().count(),
            analysis.weak_direction_count,
            analysis.weak_deviation,
            judgement.fit.loss.name(),
            judgement.fit.outliers.len(),
        );
    }
    text
}

pub(super) fn parameters(comparison: &Comparison) -> String {
    let mut text = String::from("candidate,parameter,unit,start,value,sigma,change,prior_sigma,at_bound\n");
    let optional = |value: Option<f64>| value.map(|value| value.to_string()).unwrap_or_default();
    for (candidate, judgement) in judged(comparison) {
        for estimate in &judgement.fit.parameters {
            let _ = writeln!(
                text,
                "\"{}\",{},{},{},{},{},{},{},{}",
                candidate.name,
                estimate.name,
                estimate.unit,
                estimate.start,
                estimate.value,
                optional(estimate.sigma),
                estimate.change,
                optional(estimate.prior_sigma),
                estimate.at_bound,
            );
        }
    }
    text
}

/// Outliers of every judged candidate's fit.
pub(super) fn outliers(comparison: &Comparison) -> String {
    let mut text = String::from("candidate,sample,line,residual_m,weight,reason\n");
    for (candidate, judgement) in judged(comparison) {
        for outlier in &judgement.fit.outliers {
            let line = outlier.line.map(|line| line.to_string()).unwrap_or_default();
            let (sample, residual, weight) = (outlier.sample, field(outlier.residual_m), outlier.weight);
            let _ = writeln!(text, "\"{}\",{sample},{line},{residual},{weight},\"{}\"", candidate.name, outlier.reason);
        }
    }
    text
}

/// Errors of the recommended (else the best) candidate, one row per validation sample; of a planar robot along the axes of its plane.
pub(super) fn errors(comparison: &Comparison) -> String {
    let robot = &comparison.data.robot;
    let count = robot.cable_count();
    let lengths: Vec<String> = (1..=count).map(|cable| format!("length_error_m_{cable}")).collect();
    let axes = axis_names(robot);
    let named = |before: &str| axes.iter().map(|axis| format!("{before}{axis}_m")).collect::<Vec<_>>().join(",");
    let (place, shift, lengths) = (named(""), named("d"), lengths.join(","));
    let mut text = format!("sample,{place},position_error_m,{shift},rotation_error_rad,{lengths}\n");
    let Some(judgement) = shown(comparison) else { return text };
    let errors = &judgement.validation_errors;
    for (row, sample) in judgement.validation_samples.iter().enumerate() {
        let fields = |vector| components(robot, &vector).into_iter().map(field).collect::<Vec<_>>().join(",");
        let (place, shift) =
            (fields(comparison.data.samples.poses[*sample].position), fields(errors.position_vector[row].into()));
        let lengths: Vec<String> = errors.length[row * count..][..count].iter().map(|&error| field(error)).collect();
        let (position, rotation) = (field(errors.position[row]), field(errors.rotation[row]));
        let _ = writeln!(text, "{},{place},{position},{shift},{rotation},{}", sample + 1, lengths.join(","));
    }
    text
}

/// The candidate that tables by sample and by pairs of parameters are about: the recommended, else the best one.
fn shown(comparison: &Comparison) -> Option<&Judgement> {
    let index = comparison.selection.recommended.or(comparison.selection.best)?;
    comparison.selection.candidates[index].outcome.as_ref().ok()
}

/// Singular values of every candidate's Jacobian, from large to small (SI units).
pub(super) fn singular_values(comparison: &Comparison) -> String {
    let mut text = String::from("candidate,number,singular_value\n");
    for (candidate, judgement) in judged(comparison) {
        for (index, value) in judgement.fit.analysis.singular_values.iter().enumerate() {
            let _ = writeln!(text, "{},{},{value}", quoted(&candidate.name), index + 1);
        }
    }
    text
}

/// The weighted sum of squares of every candidate after each step of its fit.
pub(super) fn convergence(comparison: &Comparison) -> String {
    let mut text = String::from("candidate,step,weighted_sum_of_squares\n");
    for (candidate, judgement) in judged(comparison) {
        for (step, cost) in judgement.fit.history.iter().enumerate() {
            let _ = writeln!(text, "{},{step},{cost}", quoted(&candidate.name));
        }
    }
    text
}

/// Correlation coefficients of the recommended (else the best) candidate's parameters: the whole matrix, empty where one
/// of the two is not determined.
pub(super) fn correlations(comparison: &Comparison) -> String {
    let Some(judgement) = shown(comparison) else { return "parameter\n".to_owned() };
    let fit = &judgement.fit;
    let rows = &fit.analysis.correlation_rows;
    let names: Vec<String> = fit.parameters.iter().map(|estimate| quoted(&estimate.name)).collect();
    let mut text = ["parameter".to_owned()].into_iter().chain(names.clone()).collect::<Vec<_>>().join(",") + "\n";
    for (i, name) in names.iter().enumerate() {
        let entry = |j: usize| rows.get(i.max(j)).and_then(|row| row.get(i.min(j))).filter(|value| value.is_finite());
        let entries = (0..names.len()).map(|j| entry(j).map(f64::to_string).unwrap_or_default());
        let _ = writeln!(text, "{name},{}", entries.collect::<Vec<_>>().join(","));
    }
    text
}

/// A field of text.
fn quoted(text: &str) -> String {
    format!("\"{}\"", text.replace('"', "\"\""))
}
