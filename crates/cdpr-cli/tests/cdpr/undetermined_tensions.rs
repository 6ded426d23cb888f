//! Rigid cables whose tensions statics does not determine: answers have a warning and the interval of each cable.

use super::{cdpr_in, file_with};

/// A platform that hangs by its middle plane on four cables of a cube (oKermorgant's cube, a robot of his package `cdpr`): of six rows of the structure matrix three are independent.
fn cube() -> String {
    let cable = |(index, [x, y]): (usize, [f64; 2])| {
        format!(
            "[[cable]]\nname = \"{}\"\nframe_anchor_m = [{}, {}, 4.0]\nplatform_anchor_m = [{}, {}, 0.0]\n",
            index + 1,
            2.0 * x,
            2.0 * y,
            0.2 * x,
            0.2 * y
        )
    };
    let corners = [[-1.0, -1.0], [-1.0, 1.0], [1.0, 1.0], [1.0, -1.0]];
    let cables: String = corners.into_iter().enumerate().map(cable).collect();
    format!(
        "layout_version = 1\nname = \"cube\"\nmotion_pattern = \"3R3T\"\ngravity_m_s2 = [0.0, 0.0, -9.81]\n[platform]\nmass_kg = 1.0\n\
         center_of_mass_m = [0.0, 0.0, 0.0]\n[home_pose]\nposition_m = [0.0, 0.0, 2.0]\n\
         rotation = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]\n\
         [cable_defaults]\ntension_min_N = 0.0\ntension_max_N = 100.0\n{cables}"
    )
}

/// Any tensions with f1 = f3, f2 = f4 and f1 + f2 = 7.939 N balance; the answer was 3.970 N for all, or others from another guess.
#[test]
fn tensions_that_statics_does_not_determine_come_with_their_intervals() {
    let (folder, _) = file_with("cube.toml", cube().as_bytes());
    for command in [
        "fk cube.toml --lengths 3.237283,3.237283,3.237283,3.237283",
        "fk cube.toml --lengths 3.237283,3.237283,3.237283,3.237283 --guess 0.1,0.05,1.9,0.02,0.01,0.1",
        "tension cube.toml --pose 0,0,2,0,0,0",
    ] {
        let run = cdpr_in(folder.path(), &format!("{command} --format json"));
        assert_eq!(run.exit_code, 0, "{command}: {}", run.stderr);
        let answer = run.json();
        let ranges = answer["tension_intervals_N"].as_array().unwrap_or_else(|| panic!("{command}: {answer}"));
        assert_eq!(ranges.len(), 4);
        for range in ranges {
            let end = |index: usize| range[index].as_f64().unwrap();
            // lengths are given to 1 µm
            assert!(end(0).abs() < 1e-6 && (end(1) - 7.939).abs() < 5e-4, "{command}: {range}");
        }
        let warnings = answer["warnings"].to_string();
        assert!(
            warnings.contains("does not determine the tensions") && warnings.contains("cable 3 0 to 7.939 N"),
            "{warnings}"
        );
        let text = cdpr_in(folder.path(), command);
        assert!(text.stdout.contains("7.939") && text.stderr.contains("cable 3 0 to 7.939 N"), "{}", text.stdout);
    }
    // within limits the intervals are theirs
    let bounded = cdpr_in(folder.path(), "tension cube.toml --pose 0,0,2,0,0,0 --min 3 --format json").json();
    let range = &bounded["tension_intervals_N"][0];
    assert!(
        (range[0].as_f64().unwrap() - 3.0).abs() < 1e-9 && (range[1].as_f64().unwrap() - 4.939).abs() < 5e-4,
        "{range}"
    );
}

/// Three cables to a point: statics determines them, and nothing is said. More cables than degrees of freedom: intervals, but no warning.
#[test]
fn determined_tensions_come_without_intervals_and_redundant_ones_without_a_warning() {
    let (folder, _) = file_with("square.toml", super::SQUARE.as_bytes());
    let one = |command: &str| cdpr_in(folder.path(), &format!("{command} --format json")).json();
    let redundant = one("tension square.toml --pose 5,4 --wrench 0,-20 --min 10 --max 100");
    let ranges = redundant["tension_intervals_N"].as_array().unwrap();
    assert_eq!((ranges.len(), redundant["warnings"].as_array().unwrap().len()), (4, 0));
    for (range, tension) in ranges.iter().zip(redundant["tensions_N"].as_array().unwrap()) {
        let (least, largest, f) = (range[0].as_f64().unwrap(), range[1].as_f64().unwrap(), tension.as_f64().unwrap());
        assert!(10.0 <= least && least <= f && f <= largest && largest <= 100.0, "{range} {tension}");
    }
    let determined = one("tension fast --pose 0,0,150,0,0,0");
    assert!(determined.get("tension_intervals_N").is_none() && determined["warnings"].as_array().unwrap().is_empty());
}
