//! Doubts about a pose that come with the tensions asked about.

use cdpr_model::model::Model;

/// Residual wrench, as a share of the largest tension, from which tensions are out of balance: sensors are good for about one percent.
const OUT_OF_BALANCE: f64 = 0.01;

/// Cables taken as slack, and tensions (N) that leave a part of the load without balance: the residual wrench in the degrees of freedom (N, N·m).
pub(super) fn tension_doubts(model: &Model, tensions: &[f64], residual: &[f64]) -> Vec<String> {
    let mut doubts = Vec::new();
    let slack: Vec<String> =
        (0..tensions.len()).filter(|&cable| tensions[cable] == 0.0).map(|cable| (cable + 1).to_string()).collect();
    if !slack.is_empty() {
        doubts.push(format!("without tension, and so taken as slack: cable {}", slack.join(", ")));
    }
    let largest = tensions.iter().copied().fold(0.0, f64::max);
    let translations = model.robot().motion_pattern.translations();
    let scale = |row: usize| if row < translations { 1.0 } else { model.platform_radius() };
    let missing = residual.iter().enumerate().map(|(row, x)| x.abs() / scale(row)).fold(0.0, f64::max);
    if missing > OUT_OF_BALANCE * largest {
        doubts.push(format!(
            "the tensions do not balance the load, {missing:.1} N are missing: the platform would not stay at this pose (`cdpr load` tells the load that they balance)"
        ));
    }
    doubts
}
