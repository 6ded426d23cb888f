//! Readers meet arbitrary bytes: they never panic, and what they accept is finite and comes back unchanged.

use crate::readers::{READERS, check_robot, mutated};
use crate::support::property;
use cdpr::robot::{Robot, builtin};
use proptest::prelude::*;

/// Damaged files by the number of their seed; `cargo run --release -p cdpr --example mutate_readers` goes on from there.
#[test]
fn damaged_files_are_refused_or_make_sense() {
    for reader in READERS {
        let corpus = (reader.corpus)();
        corpus.iter().for_each(|file| (reader.check)(file));
        for seed in property::seeds(10_000) {
            (reader.check)(&mutated(&corpus, seed));
        }
    }
}

proptest! {
    #![proptest_config(property::cases(2000))]

    /// Printed orientations have rounding errors of every size up to the accepted one.
    #[test]
    fn any_orientation_and_direction_comes_back_to_the_bit(
        angles in proptest::array::uniform3(-7.0..7.0f64),
        digits in 6..17usize,
        angle in -1e3..1e3f64,
    ) {
        let pose = cdpr::geometry::Pose::from_xyz_angles(Default::default(), angles);
        let (matrix, print) = (pose.rotation_matrix(), |number: f64| format!("{number:.digits$}"));
        let row = |row: usize| format!("[{}]", [0, 1, 2].map(|column| print(matrix[(row, column)])).join(", "));
        let spatial = builtin::find("caroca-pulleys").expect("it is built in")
            .replace("[[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]   #", &format!("[{}, {}, {}] #", row(0), row(1), row(2)))
            .replace("swivel_axis = [0.0, 0.0, 1.0]", &format!("swivel_axis = {}", row(1)));
        check_robot(spatial.as_bytes());
        // six digits may be too few for a rotation matrix to be orthonormal to 1e-6
        prop_assert!(digits == 6 || Robot::from_toml(&spatial, "spatial.toml").is_ok());
        let planar = builtin::find("cucablerobot-planar").expect("it is built in")
            .replace("angle_rad = 0.0", &format!("angle_rad = {}", print(angle)));
        prop_assert!(Robot::from_toml(&planar, "planar.toml").is_ok());
        check_robot(planar.as_bytes());
    }
}
