//! Files of numbers: derivatives, and what every pose has.

use std::fmt::Write;

use cdpr_model::geometry::{Pose, Twist};
use cdpr_model::model::Model;
use cdpr_study::Experiment;
use cdpr_study::tolerance::{Deviations, Quantiles};

/// ∂(pose, tensions) by every parameter at every pose, a row each; poses without an answer have none.
pub fn derivatives(found: &Deviations, experiment: &Experiment) -> String {
    let machine = &experiment.machine;
    let mut text = String::from(
        "pose,x_m,y_m,z_m,parameter,unit,position_x_m_per_unit,position_y_m_per_unit,position_z_m_per_unit,\
         rotation_x_rad_per_unit,rotation_y_rad_per_unit,rotation_z_rad_per_unit",
    );
    let has_tensions = experiment.tensions_emerge();
    let tension_count = if has_tensions { machine.cable_count() } else { 0 };
    (1..=tension_count).for_each(|cable| text.push_str(&format!(",tension_N_{cable}_per_unit")));
    text.push('\n');
    for (place, (at, command)) in found.poses.iter().zip(&found.commanded).enumerate() {
        let Ok(derivatives) = &at.derivatives else { continue };
        for (column, cause) in found.causes.iter().enumerate() {
            let start = position(place, &command.pose);
            let _ = write!(text, "{start},{},{}", cause.name(machine), cause.kind.unit());
            let twist = in_world(machine, derivatives.pose.column(column).iter().copied());
            twist.iter().for_each(|entry| text.push_str(&format!(",{entry}")));
            for tension in
                derivatives.tensions.iter().flat_map(|all| all.column(column).iter().copied().collect::<Vec<_>>())
            {
                text.push_str(&format!(",{tension}"));
            }
            text.push('\n');
        }
    }
    text
}

pub(super) fn in_world(model: &Model, entries: impl Iterator<Item = f64>) -> Twist {
    model.twist_basis().iter().zip(entries).map(|(direction, entry)| direction * entry).sum()
}

fn position(place: usize, pose: &Pose) -> String {
    let r = pose.position;
    format!("{},{},{},{}", place + 1, r.x, r.y, r.z)
}

/// Error and spread at every pose; empty fields where there is no answer.
pub fn poses(found: &Deviations) -> String {
    let mut text = String::from("pose,x_m,y_m,z_m,position_error_m");
    if found.spread.is_some() {
        text.push_str(",linear_deviation_rms_m,linear_worst_case_m");
    }
    if found.drawn.is_some() {
        for name in ["position_error", "deviation"] {
            for figure in ["mean", "rms", "median", "p95", "p99", "max"] {
                text.push_str(&format!(",drawn_{name}_{figure}_m"));
            }
        }
    }
    text.push('\n');
    for (place, command) in found.commanded.iter().enumerate() {
        let mut numbers = vec![found.errors[place]];
        if let Some(spread) = &found.spread {
            numbers.extend([spread.deviation[place], spread.worst_case[place]]);
        }
        if let Some(drawn) = &found.drawn {
            let of = |q: &Quantiles| [q.mean, q.rms, q.median, q.p95, q.p99, q.max];
            numbers.extend(of(&drawn.errors[place]).into_iter().chain(of(&drawn.deviations[place])));
        }
        text.push_str(&position(place, &command.pose));
        for number in numbers {
            let field = if number.is_finite() { number.to_string() } else { String::new() };
            text.push_str(&format!(",{field}"));
        }
        text.push('\n');
    }
    text
}
