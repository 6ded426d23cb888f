//! How far the direction of a cable may turn within a cell.

use nalgebra::{Matrix3, Vector3};

use cdpr_model::cable::CablePath;
use cdpr_model::cable::outlet::Outlet;

/// Largest |D²u\[δ, δ\]| L² for a cable from a point, over all δ of length 1: 2/√3.
const BEND: f64 = 1.154_701;

/// Change of a cable's direction u with the platform: |u(r + δ) − u(r) − gradient δ| ≤ remainder for all |δ| ≤ reach.
pub(super) struct Turning {
    /// ∂u/∂r (1/m), symmetric.
    pub(super) gradient: Matrix3<f64>,
    /// Bound of what the gradient leaves; ∞ where the cable may lose its path.
    pub(super) remainder: f64,
}

impl Turning {
    /// The change of a cable with this outlet, and its path to an anchor (world, m), within a distance `reach` (m).
    pub(super) fn of(outlet: &Outlet<f64>, path: &CablePath<f64>, anchor: &Vector3<f64>, reach: f64) -> Self {
        let rows = path.direction_gradient;
        let gradient = Matrix3::from_fn(|row, column| rows[row][column]);
        let remainder = if reach == 0.0 { 0.0 } else { 0.5 * bend(outlet, path, anchor, reach) * reach * reach };
        Self { gradient, remainder }
    }
}

/// Bound of the second derivative of the direction within the distance (1/m²).
///
/// In the plane of a pulley the cable turns by 1/L per length across it, and L changes by r_p/L; the plane itself turns
/// by 1/ρ per length, at the distance ρ from the swivel axis.
fn bend(outlet: &Outlet<f64>, path: &CablePath<f64>, anchor: &Vector3<f64>, reach: f64) -> f64 {
    let to = anchor - Vector3::from(*outlet.frame_anchor());
    // least free length within the distance, from that to the pulley's centre
    let free = |radius: f64| {
        let center = (path.free_length.powi(2) + radius * radius).sqrt() - reach;
        if center > radius { (center * center - radius * radius).sqrt() } else { 0.0 }
    };
    let bound = match outlet {
        Outlet::Point { .. } => BEND / free(0.0).powi(2),
        Outlet::Sided { swivel_axis, side, radius, .. } => {
            let is_closed = Vector3::from(*side).dot(&to) >= reach || Vector3::from(*swivel_axis).dot(&to) <= -reach;
            let length = if is_closed { free(*radius) } else { 0.0 };
            (BEND + radius / length) / length.powi(2)
        }
        Outlet::Swivel { swivel_axis, radius, .. } => {
            let axis = Vector3::from(*swivel_axis);
            let (length, across) = (free(*radius), ((to - axis * axis.dot(&to)).norm() - reach).max(0.0));
            (BEND + radius / length) / length.powi(2) + BEND / across.powi(2) + 2.0 / (length * across)
        }
    };
    if bound.is_nan() { f64::INFINITY } else { bound }
}

#[cfg(test)]
mod tests {
    use super::*;
    use cdpr_model::geometry::Pose;
    use cdpr_model::model::Model;
    use cdpr_model::robot::{Pulley, Robot};
    use rand::{RngExt, SeedableRng};
    use rand_chacha::ChaCha8Rng;

    /// Directions at random displacements keep the bound, with points and with pulleys, and come near it.
    #[test]
    fn no_cable_turns_further_than_its_bound() {
        let mut rng = ChaCha8Rng::seed_from_u64(7);
        let mut nearest: f64 = 0.0;
        for (name, radius) in [("cogiro", None), ("cogiro", Some(0.2)), ("planar-example", None)] {
            let mut robot = Robot::builtin(name).unwrap();
            for cable in robot.cables.iter_mut().filter(|_| radius.is_some()) {
                cable.pulley = radius.map(|radius| Pulley::Whole { radius, swivel_axis: Vector3::z().into() });
            }
            let effects = if radius.is_some() { "pulley" } else { "standard" };
            let model = Model::new(robot, effects.parse().unwrap()).unwrap();
            let home = model.robot().home_or_middle();
            for _ in 0..2000 {
                let mut random = |size: f64| -> Vector3<f64> {
                    model.axes().iter().map(|axis| axis * rng.random_range(-size..size)).sum()
                };
                let pose = Pose { position: home.position + random(1.0), rotation: home.rotation };
                let moved = random(0.6);
                let there = Pose { position: pose.position + moved, rotation: pose.rotation };
                for cable in 0..model.cable_count() {
                    let (path, arm) = model.path(cable, &pose).unwrap();
                    let turning = Turning::of(model.outlet(cable), &path, &(pose.position + arm), moved.norm());
                    let Ok((after, _)) = model.path(cable, &there) else { continue };
                    let change = Vector3::from(after.direction) - Vector3::from(path.direction);
                    let left = (change - turning.gradient * moved).norm();
                    assert!(left <= turning.remainder + 1e-12, "{name}, cable {cable}: {left} {}", turning.remainder);
                    nearest = nearest.max(left / turning.remainder);
                }
            }
        }
        assert!(nearest > 0.5, "{nearest}");
    }
}
