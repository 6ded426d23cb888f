//! The law of two pieces: soft below the strain of a knee, stiff above it.

use cdpr_core::cable::stretch::Stretch;
use cdpr_core::cable::stretch::two_piece::TwoPiece;

use super::StretchError;
use super::numbers::{LawNumber, all_stated};
use crate::robot::Cable;

/// Its numbers, in the order of [`TwoPiece`].
pub(super) const NUMBERS: [LawNumber; 3] = [
    LawNumber {
        name: "stiffness-below-knee",
        key: "stiffness_below_knee_EA_N",
        unit: "N",
        about: "Specific stiffness E·A below the knee (N), which the effect `two-piece` reads with `stiffness_above_knee_EA_N` and `knee_strain`.",
    },
    LawNumber {
        name: "stiffness-above-knee",
        key: "stiffness_above_knee_EA_N",
        unit: "N",
        about: "Slope of the tension over the strain above the knee (N), of the effect `two-piece`.",
    },
    LawNumber {
        name: "knee-strain",
        key: "knee_strain",
        unit: "",
        about: "Strain, counted from the unstrained length, at which the two slopes of the effect `two-piece` meet.",
    },
];

/// The law of the cable; `None` if its file states none of the numbers.
pub(super) fn law(cable: &Cable) -> Result<Option<Stretch>, StretchError> {
    let numbers = all_stated(&NUMBERS, &cable.law_numbers)?;
    Ok(numbers.map(|[below, above, knee]| Stretch::TwoPiece(TwoPiece { below, above, knee })))
}

/// Number of parameters of the law.
pub(super) fn count(_: &Cable) -> usize {
    NUMBERS.len()
}

/// Gives a cable half the stiffness up to a strain of 0.04 %.
pub(super) fn sample(cable: &mut Cable, stiffness: f64) {
    let values = [0.5 * stiffness, stiffness, 4e-4];
    cable.law_numbers.extend(NUMBERS.iter().map(|number| number.key).zip(values));
}

#[cfg(all(test, feature = "files"))]
mod tests {
    use crate::robot::Robot;

    const KEYS: &str =
        "stiffness_below_knee_EA_N = 100000.0\nstiffness_above_knee_EA_N = 800000.0\nknee_strain = 0.002\n";

    /// The planar example with further lines for all of its cables.
    fn file(lines: &str) -> String {
        Robot::builtin("planar-example").expect("built in").to_toml().replacen(
            "[[cable]]",
            &format!("[cable_defaults]\n{lines}\n[[cable]]"),
            1,
        )
    }

    fn robot() -> Robot {
        Robot::from_toml(&file(KEYS), "robot.toml").unwrap_or_else(|error| panic!("{error}"))
    }

    #[test]
    fn its_keys_are_read_and_written() {
        let robot = robot();
        assert!(robot.cables.iter().all(|cable| cable.law_numbers["knee_strain"] == 0.002));
        let written = robot.to_toml();
        assert_eq!(written.matches(KEYS).count(), 4, "{written}");
        assert_eq!(Robot::from_toml(&written, "robot.toml").unwrap(), robot);
    }

    #[test]
    fn mistakes_are_told_at_their_key() {
        for (lines, code, words) in [
            ("knee_strain = 0.002", "stretch::entries", "stiffness_below_knee_EA_N"),
            ("knee_strain = 0.0", "robot::not-positive", "knee_strain"),
            ("knee_strain = \"soft\"", "toml::wrong-type", "number"),
            ("knee_strains = 0.002", "toml::unknown-key", "did you mean `knee_strain`"),
        ] {
            let error = Robot::from_toml(&file(lines), "robot.toml").unwrap_err();
            assert_eq!(error.code, code, "{error}");
            let told = format!("{error} {}", error.help.as_deref().unwrap_or_default());
            assert!(error.line().is_some() && told.contains(words), "{told}");
        }
    }
}
