//! Where to start again when the guess led nowhere.

use nalgebra::Vector3;
use rand::{RngExt, SeedableRng};

use crate::geometry::{Pose, Twist};
use crate::model::Model;

/// Starts to try after the guess: the home pose, then positions spread over the frame with turned platforms.
///
/// Always the same for the same robot.
pub(super) fn restart_poses(model: &Model, guess: &Pose) -> impl Iterator<Item = Pose> + use<> {
    let home = model.robot().home_or_middle();
    let anchors = || model.robot().cables.iter().map(|cable| cable.frame_anchor);
    let min = anchors().fold(home.position, |a, b| a.inf(&b));
    let max = anchors().fold(home.position, |a, b| a.sup(&b));
    let mut rng = rand_chacha::ChaCha8Rng::seed_from_u64(0);
    let basis = model.twist_basis().to_vec();
    let translations = model.robot().motion_pattern.translations();
    let turned_guess = Pose { position: guess.position, rotation: home.rotation };
    let scattered = (0..).map(move |index: u32| {
        // every other start keeps the home orientation: platforms seldom turn far
        let turn = if index.is_multiple_of(2) { 0.0 } else { 1.5 };
        let mut twist = Twist::zeros();
        for (axis, direction) in basis.iter().enumerate() {
            let share: f64 = rng.random_range(-0.5..0.5);
            let extent = direction.fixed_rows::<3>(0).dot(&(max - min));
            twist += direction * if axis < translations { share * extent } else { 2.0 * share * turn };
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
