//! The numbers behind the figures, one CSV table each; SI units in the heading.

use cdpr_calibration::selection::SelectionCriterion;

use super::numbers::ComparedData;
use super::{AXES, CandidateData, FigureFile, ParameterData, SampleData, SavedResult};

/// Every table.
pub(super) fn all(data: &SavedResult) -> Vec<FigureFile> {
    let in_folder = "the result has no such numbers; a folder that this version's `select` or `demo` wrote has them";
    let rows = |is_there: bool, table: &dyn Fn() -> String| is_there.then(table);
    let figure = |name, content, why_not| FigureFile { name, content, why_not };
    let samples = !data.samples.is_empty();
    vec![
        figure("model-ladder.csv", rows(!data.candidates.is_empty(), &|| ladder(data)), "no candidates were compared"),
        figure("residuals.csv", rows(samples, &|| residuals(data)), in_folder),
        figure("pose-errors.csv", rows(samples, &|| pose_errors(data)), in_folder),
        figure("parameters.csv", rows(!data.parameters.is_empty(), &|| parameters(data)), "nothing was free"),
        figure("correlations.csv", data.correlations.as_ref().and_then(correlations), in_folder),
        figure(
            "singular-values.csv",
            rows(!data.singular_values.is_empty(), &|| numbered("singular_value", 1, &data.singular_values)),
            "nothing was free",
        ),
        figure(
            "convergence.csv",
            rows(!data.convergence.is_empty(), &|| numbered("weighted_sum_of_squares", 0, &data.convergence)),
            in_folder,
        ),
    ]
}

/// Lines of a table; a field that needs quotes gets them.
fn table(heading: &[String], rows: impl IntoIterator<Item = Vec<String>>) -> String {
    let mut writer = csv::Writer::from_writer(Vec::new());
    // writing to memory cannot fail, and every row has the heading's width
    let _ = writer.write_record(heading);
    for row in rows {
        let _ = writer.write_record(&row);
    }
    writer.into_inner().ok().and_then(|bytes| String::from_utf8(bytes).ok()).unwrap_or_default()
}

fn words<const N: usize>(heading: [&str; N]) -> Vec<String> {
    heading.map(str::to_owned).to_vec()
}

/// A number; empty if it is not finite.
fn field(value: f64) -> String {
    if value.is_finite() { value.to_string() } else { String::new() }
}

fn optional(value: Option<f64>) -> String {
    value.map(field).unwrap_or_default()
}

/// Column of the error by which candidates are compared.
fn compared_metric(data: &SavedResult) -> &'static str {
    let is_of_pose = data.candidates.iter().filter_map(|own| own.compared.as_ref()).any(|own| own.by == "pose");
    if is_of_pose { "pose_mean_m" } else { criterion_path(data.criterion).1 }
}

/// Place of the criterion among a candidate's errors, and the name of its column.
fn criterion_path(criterion: SelectionCriterion) -> (&'static str, &'static str) {
    match criterion {
        SelectionCriterion::Rotation => ("/rotation_error_rad/mean", "rotation_mean_rad"),
        SelectionCriterion::Length => ("/length_error_m/mean_abs", "length_mean_abs_m"),
        SelectionCriterion::Tension => ("/tension_error_N/mean_norm", "tension_mean_norm_N"),
        _ => ("/position_error_m/mean", "position_mean_m"),
    }
}

fn ladder(data: &SavedResult) -> String {
    let (path, metric) = criterion_path(data.criterion);
    let compared = compared_metric(data);
    let heading = [
        "candidate",
        "model",
        "free",
        "parameter_count",
        &format!("train_{metric}"),
        &format!("validation_{metric}"),
        &format!("standard_error_{metric}"),
        &format!("compared_{compared}"),
        &format!("difference_{compared}"),
        &format!("standard_error_of_difference_{compared}"),
        "as_good_as_best",
        "rank",
        "condition",
        "recommended",
        "failure",
    ];
    let row = |candidate: &CandidateData| {
        let count = |number: Option<usize>| number.map(|number| number.to_string()).unwrap_or_default();
        vec![
            candidate.name.clone(),
            candidate.model.clone(),
            candidate.free.clone(),
            count(candidate.parameter_count),
            optional(candidate.train.pointer(path).and_then(serde_json::Value::as_f64)),
            optional(candidate.criterion),
            optional(candidate.standard_error),
            of_compared(candidate, |own| own.mean),
            of_compared(candidate, |own| own.difference),
            of_compared(candidate, |own| own.difference_standard_error),
            candidate.compared.as_ref().map(|own| own.as_good_as_best.to_string()).unwrap_or_default(),
            count(candidate.rank),
            optional(candidate.condition),
            (data.recommended.as_ref() == Some(&candidate.name)).to_string(),
            candidate.failure.clone().unwrap_or_default(),
        ]
    };
    table(&words(heading), data.candidates.iter().map(row))
}

fn of_compared(candidate: &CandidateData, number: fn(&ComparedData) -> Option<f64>) -> String {
    optional(candidate.compared.as_ref().and_then(number))
}

fn residuals(data: &SavedResult) -> String {
    let cables = data.samples.first().map_or(0, |sample| sample.lengths.len());
    let heading = std::iter::once("sample".to_owned()).chain((1..=cables).map(|k| format!("length_residual_m_{k}")));
    let row = |sample: &SampleData| {
        let number = std::iter::once(sample.sample.to_string());
        number.chain(sample.lengths.iter().map(|&length| field(length))).collect()
    };
    table(&heading.collect::<Vec<_>>(), data.samples.iter().map(row))
}

fn pose_errors(data: &SavedResult) -> String {
    let named = |before: &'static str| data.axes.iter().map(move |&axis| format!("{before}{}_m", AXES[axis]));
    let mut heading = vec!["sample".to_owned()];
    heading.extend(named("").chain(["position_error_m".to_owned()]).chain(named("d")));
    heading.push("rotation_error_rad".to_owned());
    let row = |sample: &SampleData| {
        let along = |vector: [f64; 3]| data.axes.iter().map(move |&axis| vector[axis]);
        let numbers = along(sample.position).chain([sample.position_error]).chain(along(sample.position_vector));
        let numbers = numbers.chain([sample.rotation_error]).map(field);
        std::iter::once(sample.sample.to_string()).chain(numbers).collect()
    };
    table(&heading, data.samples.iter().map(row))
}

fn parameters(data: &SavedResult) -> String {
    let heading = words(["parameter", "unit", "start", "value", "sigma", "change", "prior_sigma", "at_bound"]);
    let row = |parameter: &ParameterData| {
        let change = parameter.value.zip(parameter.start).map(|(value, start)| value - start);
        let numbers = [parameter.start, parameter.value, parameter.sigma, change, parameter.prior_sigma].map(optional);
        let mut fields = vec![parameter.name.clone(), parameter.unit.clone()];
        fields.extend(numbers);
        fields.push(parameter.at_bound.to_string());
        fields
    };
    table(&heading, data.parameters.iter().map(row))
}

fn correlations((names, rows): &(Vec<String>, Vec<Vec<f64>>)) -> Option<String> {
    let heading: Vec<String> = std::iter::once("parameter".to_owned()).chain(names.iter().cloned()).collect();
    let row = |(name, values): (&String, &Vec<f64>)| {
        std::iter::once(name.clone()).chain(values.iter().map(|&value| field(value))).collect()
    };
    (!names.is_empty()).then(|| table(&heading, names.iter().zip(rows).map(row)))
}

fn numbered(name: &str, first: usize, values: &[f64]) -> String {
    let rows = values.iter().enumerate().map(|(index, &value)| vec![(first + index).to_string(), field(value)]);
    table(&words([if first == 0 { "step" } else { "number" }, name]), rows)
}
