//! Inertias that no body has: one principal moment exceeds the sum of the two others.

use cdpr_model::geometry::MotionPattern;
use cdpr_model::robot::{Body, Robot};
use cdpr_plant::Simulation;
use nalgebra::{Matrix3, SymmetricEigen};

use crate::number_format::{short, significant};

/// Share of the sum of two principal moments by which the third may exceed it: rounding of printed numbers.
const ROUNDING: f64 = 1e-3;

/// Doubt about the inertia of a robot file.
pub(super) fn of_robot(robot: &Robot) -> Option<String> {
    // planar robots state one moment alone, which any body may have
    let inertia = robot.platform.inertia.filter(|_| robot.motion_pattern == MotionPattern::Spatial)?;
    impossible_moments(&inertia).map(|moments| words("as the file states it,", moments))
}

/// Doubts about the inertia of a machine at its start, and after each load that it takes up or loses.
pub(super) fn of_run(simulation: &Simulation) -> Vec<String> {
    let robot = simulation.plant.model().robot();
    let mut doubts: Vec<String> = of_robot(robot).into_iter().collect();
    let Some(mut body) = Body::of(robot).ok().filter(|_| robot.motion_pattern == MotionPattern::Spatial) else {
        return doubts;
    };
    for event in &simulation.events {
        let Some(load) = event.happening.load_change() else { continue };
        let Some(next) = body.with_point_mass(load.mass, &load.place) else { break };
        body = next;
        let when = || format!("after the event at {} s", short(event.time));
        doubts.extend(impossible_moments(&body.inertia).map(|moments| words(&when(), moments)));
    }
    doubts
}

/// Principal moments (kg·m²), ascending, that break the triangle rule.
fn impossible_moments(inertia: &Matrix3<f64>) -> Option<[f64; 3]> {
    let eigen = SymmetricEigen::try_new(*inertia, f64::EPSILON, 1000)?;
    let mut moments: [f64; 3] = eigen.eigenvalues.into();
    moments.sort_by(f64::total_cmp);
    (moments[2] > (moments[0] + moments[1]) * (1.0 + ROUNDING)).then_some(moments)
}

fn words(when: &str, moments: [f64; 3]) -> String {
    let [small, middle, large] = moments.map(|moment| significant(moment, 4));
    format!(
        "{when} the platform has principal moments of inertia of {small}, {middle} and {large} kg·m², the largest above the sum of the others, as \
         no body has them (triangle rule): check inertia_about_center_of_mass_kg_m2 and its axes"
    )
}

#[cfg(test)]
mod tests {
    use nalgebra::{Rotation3, Vector3};

    use super::*;

    /// A rod, a plate and a ball are bodies, whatever the axes; 10, 20 and 62.5 kg·m² are not.
    #[test]
    fn the_largest_moment_is_at_most_the_sum_of_the_others() {
        let turned = Rotation3::from_euler_angles(0.3, -0.8, 1.2);
        let judged = |moments: [f64; 3]| {
            let inertia =
                turned.matrix() * Matrix3::from_diagonal(&Vector3::from(moments)) * turned.matrix().transpose();
            impossible_moments(&inertia)
        };
        for possible in [[0.0, 5.0, 5.0], [30.0, 20.0, 50.0], [7.0, 7.0, 7.0], [117.0, 121.0, 62.5]] {
            assert_eq!(judged(possible), None);
        }
        let found = judged([10.0, 62.5, 20.0]).unwrap();
        assert!(found.iter().zip([10.0, 20.0, 62.5]).all(|(a, b)| (a - b).abs() < 1e-12), "{found:?}");
    }
}
