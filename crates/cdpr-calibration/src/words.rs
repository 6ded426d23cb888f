//! Weak directions of parameter space in words.

use cdpr_model::model::Model;
use cdpr_model::robot::{Parameter, axis_name};

/// A direction in the parameters of one cable that the data hardly determine.
pub(super) enum Direction {
    /// Frame anchor and platform anchor of the cable together along a world axis (index of the pattern's axes).
    AnchorsTogether {
        /// Cable, from 0.
        cable: usize,
        /// Axis of the pattern, from 0.
        axis: usize,
        /// Standard deviation along it (m); infinite when not determined.
        deviation: f64,
    },
    /// Anything else: coefficients of a unit vector.
    Combination {
        /// Parameter and coefficient.
        coefficients: Vec<(Parameter, f64)>,
        /// Standard deviation along it (m); infinite when not determined.
        deviation: f64,
    },
}

impl Direction {
    /// Standard deviation along it (m).
    pub(super) fn deviation(&self) -> f64 {
        match self {
            Self::AnchorsTogether { deviation, .. } | Self::Combination { deviation, .. } => *deviation,
        }
    }
}

/// One sentence for each group of directions.
pub(super) fn describe(model: &Model, directions: Vec<Direction>) -> Vec<String> {
    let mut words = Vec::new();
    for axis in 0..model.axes().len() {
        let mut cables = Vec::new();
        let mut largest = 0.0_f64;
        for direction in &directions {
            if let Direction::AnchorsTogether { cable, axis: of, deviation } = direction
                && *of == axis
            {
                cables.push(*cable);
                largest = largest.max(*deviation);
            }
        }
        if !cables.is_empty() {
            words.push(together(model, axis, &cables, largest));
        }
    }
    for direction in &directions {
        if let Direction::Combination { coefficients, deviation } = direction {
            words.push(combination(model, coefficients, *deviation));
        }
    }
    words
}

fn together(model: &Model, axis: usize, cables: &[usize], deviation: f64) -> String {
    let axis = axis_name(model.robot(), axis);
    let numbers: Vec<String> = cables.iter().map(|cable| (cable + 1).to_string()).collect();
    let which = match (cables.len() == model.cable_count(), cables.len()) {
        (true, _) => "all frame anchors and all platform anchors together".to_owned(),
        (false, 1) => format!("frame anchor and platform anchor of cable {} together", numbers[0]),
        (false, _) => format!("frame anchors and platform anchors of cables {} together", numbers.join(", ")),
    };
    format!("{which} along {axis} ({})", spread(deviation))
}

fn combination(model: &Model, coefficients: &[(Parameter, f64)], deviation: f64) -> String {
    let mut terms: Vec<_> = coefficients.iter().filter(|(_, c)| c.abs() > 0.1).collect();
    terms.sort_by(|a, b| b.1.abs().total_cmp(&a.1.abs()));
    // the sign of a direction means nothing: let the largest term be positive
    let sign = terms.first().map_or(1.0, |(_, c)| c.signum());
    let mut text = String::new();
    for (index, (parameter, coefficient)) in terms.into_iter().enumerate() {
        let value = sign * coefficient;
        let operator = match (index, value < 0.0) {
            (0, _) => "",
            (_, true) => " − ",
            (_, false) => " + ",
        };
        text.push_str(&format!("{operator}{:.2} {}", value.abs(), parameter.name(model.robot())));
    }
    format!("{text} ({})", spread(deviation))
}

fn spread(deviation: f64) -> String {
    match deviation.is_finite() {
        true => format!("standard deviation up to {deviation:.2} m"),
        false => "not determined at all".to_owned(),
    }
}
