//! Readers meet arbitrary bytes: they never panic, and what they accept is finite and comes back unchanged.

use super::readers::{READERS, check_robot, mutated};
use super::support::builtin;
use cdpr::measurement::Samples;
use cdpr::robot::{self, Robot};
use cdpr_testing::property;
use proptest::prelude::*;

/// Damaged files by the number of their seed; `cargo run --release -p examples --bin mutate_readers` goes on from there.
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
        let spatial = robot::builtin::find("caroca-pulleys").expect("it is built in")
            .replace("[[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]   #", &format!("[{}, {}, {}] #", row(0), row(1), row(2)))
            .replace("swivel_axis = [0.0, 0.0, 1.0]", &format!("swivel_axis = {}", row(1)));
        check_robot(spatial.as_bytes());
        // six digits may be too few for a rotation matrix to be orthonormal to 1e-6
        prop_assert!(digits == 6 || Robot::from_toml(&spatial, "spatial.toml").is_ok());
        let planar = robot::builtin::find("cucablerobot-planar").expect("it is built in")
            .replace("angle_rad = 0.0", &format!("angle_rad = {}", print(angle)));
        prop_assert!(Robot::from_toml(&planar, "planar.toml").is_ok());
        check_robot(planar.as_bytes());
    }
}

/// A minute at 1 kHz: 60 000 rows with all digits are more than the 16 MiB that files written by hand may have.
#[test]
fn a_recording_of_sixty_thousand_rows_is_read() {
    let header = "x_m,y_m,cable_length_m_1,cable_length_m_2,cable_length_m_3,cable_length_m_4,t_s,";
    let (robot, columns) = (builtin("planar-example"), 20);
    let mut text = format!("{header}{}\n", (0..columns).map(|k| format!("channel_{k}")).collect::<Vec<_>>().join(","));
    let row = ["0.5", "4.0", "7.6", "6.0", "6.8005", "6.0"].map(|number| format!("{number:0<18}")).join(",");
    let others = vec!["1.2345678901234567"; columns].join(",");
    (0..60_000).for_each(|k| text.push_str(&format!("{row},{:.4},{others}\n", 1e-3 * f64::from(k))));
    assert!(text.len() > 17 << 20, "{}", text.len());
    let reading = Samples::from_csv(text.as_bytes(), "minute.csv", &robot).expect("fits");
    assert_eq!(reading.samples.len(), 60_000);
}
