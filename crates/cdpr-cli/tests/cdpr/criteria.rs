//! Criteria of `workspace` by their names and numbers.

use super::{cdpr, cdpr_in};

/// Without further wrenches a set is the load itself: the planar example's 71.15 m².
#[test]
fn a_set_without_extent_has_the_area_of_the_load_and_a_larger_one_less() {
    let area = |criterion: &str| {
        let run = cdpr(&format!("workspace planar-example --criterion {criterion} --step 0.1 --format json"));
        assert_eq!(run.exit_code, 0, "{}", run.stderr);
        run.json()["area_m2"].as_f64().unwrap()
    };
    let (load, gusts) = (area("wrench-set-feasible"), area("wrench-set-feasible:force=200"));
    // cells of 0.1 m along an outline of 36 m
    assert!((load - 71.15).abs() < 0.5 && gusts < load - 1.0, "{load} {gusts}");
    assert!((area("wrench-feasible") - load).abs() < 1e-9);
    // criteria that are asked for together all have to hold
    let both = area("wrench-set-feasible:force=200 --criterion cable-length:largest=10");
    assert!(both < gusts - 1.0, "{both} {gusts}");
}

#[test]
fn what_a_criterion_lacks_is_told_with_the_key() {
    for (arguments, words) in [
        ("planar-example --criterion platform-interference", "`hull_m` in [platform]"),
        ("planar-example --criterion cable-length", "`length_max_m` of cable 1"),
        ("planar-example --criterion obstacles", "[[obstacle]]"),
        ("planar-example --criterion cable-interference", "`diameter_m` of cable 1"),
        ("planar-example --criterion stability", "effect `elastic`"),
        ("planar-example --criterion pulley-wrap:least=1", "effect `pulley`"),
        ("planar-example --criterion stiffness", "needs the number `least`"),
        ("planar-example --criterion condition:largest=0.5", "1 or more"),
        ("planar-example --criterion wrench-set-feasible:mass-min=9,mass-max=3", "9 kg to 3 kg"),
    ] {
        let run = cdpr(&format!("workspace {arguments}"));
        assert_eq!(run.exit_code, 2, "{arguments}: {}", run.stdout);
        assert!(run.stderr.contains(words), "{arguments}: {}", run.stderr);
    }
}

/// The state of a count belongs to the numbers of its criteria too.
#[test]
fn a_count_is_not_resumed_with_other_numbers() {
    let folder = tempfile::tempdir().unwrap();
    let count = |largest: &str| {
        let criterion = format!("--criterion cable-length:largest={largest}");
        cdpr_in(folder.path(), &format!("workspace planar-example {criterion} --step 0.5 --resume count.json"))
    };
    assert_eq!((count("10").exit_code, count("10").exit_code), (0, 0));
    let other = count("11");
    assert!(other.exit_code == 2 && other.stderr.contains("workspace::resume"), "{}", other.stderr);
}
