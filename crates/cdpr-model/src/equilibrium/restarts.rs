//! Further starts of a search if the guess leads to no answer.

use nalgebra::Vector3;
use rand::{RngExt, SeedableRng};

use crate::geometry::{Pose, Twist};
use crate::model::Model;

/// Height of a box relative to its width below which it counts as flat.
const FLAT: f64 = 1e-6;

/// Starts to try after the guess: the home pose, then positions spread over the frame with turned platforms.
///
/// The same starts for the same robot.
pub fn restart_poses(model: &Model, guess: &Pose) -> impl Iterator<Item = Pose> + use<> {
    let home = model.robot().home_or_middle();
    let (min, max) = room_of(model, &home);
    let mut rng = rand_chacha::ChaCha8Rng::seed_from_u64(0);
    let basis = model.twist_basis().to_vec();
    let translations = model.robot().motion_pattern.translations();
    let turned_guess = Pose { position: guess.position, rotation: home.rotation };
    let scattered = (0..).map(move |index: u32| {
        // every other start keeps the home orientation: platforms seldom turn far
        let turn = if index.is_multiple_of(2) { 0.0 } else { 1.5 };
        let mut twist = Twist::zeros();
        for (axis, direction) in basis.iter().enumerate() {
            let fraction: f64 = rng.random_range(-0.5..0.5);
            let extent = direction.fixed_rows::<3>(0).dot(&(max - min));
            twist += direction * if axis < translations { fraction * extent } else { 2.0 * fraction * turn };
        }
        let middle = (min + max) * 0.5;
        let mut center = home;
        for direction in &basis[..translations] {
            let axis: Vector3<f64> = direction.fixed_rows::<3>(0).into();
            center.position += axis * axis.dot(&(middle - home.position));
        }
        center.displaced(&twist)
    });
    [home, turned_guess].into_iter().chain(scattered)
}

/// Corners of the box around frame anchors and home pose (m). If the box is flat in a direction in which the platform
/// moves, poses on its two sides are mirror images of each other at best, so that the box is extended to the side of
/// gravity, or to both sides.
fn room_of(model: &Model, home: &Pose) -> (Vector3<f64>, Vector3<f64>) {
    let robot = model.robot();
    let anchors = || robot.cables.iter().map(|cable| cable.frame_anchor);
    let mut min = anchors().fold(home.position, |a, b| a.inf(&b));
    let mut max = anchors().fold(home.position, |a, b| a.sup(&b));
    let widest = (max - min).amax();
    let gravity = robot.gravity.unwrap_or_default();
    for axis in model.twist_basis()[..robot.motion_pattern.translations()].iter().map(|twist| twist.fixed_rows::<3>(0))
    {
        if axis.dot(&(max - min)).abs() > FLAT * widest {
            continue;
        }
        let pull = axis.dot(&gravity);
        let depth = axis * if pull == 0.0 { 0.5 * widest } else { widest * pull.signum() };
        let ends = [min + depth, if pull == 0.0 { max - depth } else { max }];
        (min, max) = ends.iter().fold((min, max), |(min, max), end| (min.inf(end), max.sup(end)));
    }
    (min, max)
}
