//! Readers of other tools' files meet arbitrary bytes: they answer or refuse, quickly, and never panic.

use std::time::Instant;

use cdpr::robot::Robot;
use cdpr::robot::caspr::{self, Files, Options};
use proptest::prelude::*;

const BODIES: &str = r#"<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE bodies_system SYSTEM "bodies.dtd">
<bodies_system>
  <links display_range="0 1 0 1 0 1">
    <link_rigid num="1" name="Plate">
      <joint type="SPATIAL_EULER_XYZ" q_initial="1 2 3 0.1 0.2 0.3" q_min="0 0 0 -3.15 -3.15 -3.15" q_max="4 4 4 3.15 3.15 3.15"/>
      <physical>
        <mass>2</mass>
        <com_location>0.1 0 0</com_location>
        <inertia ref="joint"><Ixx>1</Ixx><Iyy>2</Iyy><Izz>3</Izz><Ixy>0.1</Ixy><Ixz>0.2</Ixz><Iyz>0.3</Iyz></inertia>
      </physical>
      <parent><num>0</num><location>0 0 0.5</location></parent>
    </link_rigid>
  </links>
</bodies_system>
"#;

const CABLES: &str = r#"<cables default_cable_set="one">
  <cable_set id="one">
    <cable_ideal name="a" attachment_reference="joint">
      <properties><force_min>1</force_min><force_max>10</force_max></properties>
      <attachments>
        <attachment><link>0</link><location>0 0 5</location></attachment>
        <attachment><link>1</link><location>0.1 0.2 0.3</location></attachment>
      </attachments>
    </cable_ideal>
    <!-- over a pulley -->
    <cable_linear_spring name="b" attachment_reference="com">
      <properties><K>1300</K><force_min>0</force_min><force_max>Inf</force_max></properties>
      <attachments>
        <base_rotating_pulley>
          <fixed_location>4 0 5</fixed_location><pulley_radius>0.05</pulley_radius>
          <cable_entry_vector>0 0.6 0.8</cable_entry_vector>
        </base_rotating_pulley>
        <attachment><link>1</link><location>0 0 0</location></attachment>
      </attachments>
    </cable_linear_spring>
    <cable_passive_linear_spring name="s" attachment_reference="com"/>
  </cable_set>
</cables>
"#;

/// One small damage to a file; positions are shares of its length.
#[derive(Clone, Debug)]
enum Damage {
    Flip(f64, u8),
    Delete(f64, usize),
    Repeat(f64, usize, usize),
    /// Something else between two marks (`>` and `<`, or quotes).
    Replace(f64, &'static str),
}

const VALUES: [&str; 24] = [
    "",
    "nan",
    "Inf",
    "-inf",
    "1e308",
    "1e30",
    "-1e30",
    "-1",
    "0",
    "2",
    "1e-320",
    "0 0 0",
    "1 2",
    "1e30 1e30 1e30",
    "com",
    "joint",
    "PLANAR_XZ",
    "SPATIAL_QUATERNION",
    "T_XYZ",
    "P_XY",
    "&amp;",
    "&x;",
    "<a>",
    "]]>",
];

fn damage() -> impl Strategy<Value = Damage> {
    let share = || 0.0..1.0f64;
    prop_oneof![
        (share(), any::<u8>()).prop_map(|(at, byte)| Damage::Flip(at, byte)),
        (share(), 1..200usize).prop_map(|(at, count)| Damage::Delete(at, count)),
        (share(), 1..300usize, 1..50usize).prop_map(|(at, count, times)| Damage::Repeat(at, count, times)),
        (share(), 0..VALUES.len()).prop_map(|(at, index)| Damage::Replace(at, VALUES[index])),
    ]
}

fn damaged(mut bytes: Vec<u8>, damage: &Damage) -> Vec<u8> {
    let length = bytes.len();
    let index = |share: f64| ((share * length as f64) as usize).min(length.saturating_sub(1));
    if length == 0 {
        return bytes;
    }
    match *damage {
        Damage::Flip(at, byte) => bytes[index(at)] ^= byte,
        Damage::Delete(at, count) => drop(bytes.drain(index(at)..(index(at) + count).min(length))),
        Damage::Repeat(at, count, times) => {
            let part = bytes[index(at)..(index(at) + count).min(length)].repeat(times);
            bytes.splice(index(at)..index(at), part);
        }
        Damage::Replace(at, value) => {
            let is_mark = |byte: &u8| b"<>\"".contains(byte);
            let start = bytes[..index(at)].iter().rposition(is_mark).map_or(0, |mark| mark + 1);
            let end = bytes[start..].iter().position(is_mark).map_or(length, |mark| start + mark);
            bytes.splice(start..end, value.bytes());
        }
    }
    bytes
}

/// Reads both files; what is accepted is finite and read back unchanged, what is refused is told in words.
fn check(bodies: &[u8], cables: &[u8]) {
    let start = Instant::now();
    let files = Files { bodies, bodies_name: "any_bodies.xml", cables, cables_name: "any_cables.xml" };
    match caspr::import(&files, &Options::default()) {
        Ok(import) => {
            let robot = import.robot;
            assert_eq!(Robot::from_toml(&robot.to_toml(), "again.toml").as_ref(), Ok(&robot));
            assert!(robot.home.is_some_and(|home| home.is_finite()));
            robot.warnings();
        }
        Err(error) => {
            assert!(!error.to_string().is_empty() && error.place.iter().all(|place| place.snippet().contains('^')));
        }
    }
    // a thousandth of it suffices; the rest is for a busy machine
    assert!(start.elapsed().as_secs() < 10, "hangs");
}

#[test]
fn the_undamaged_model_is_read() {
    let files = Files { bodies: BODIES.as_bytes(), bodies_name: "a", cables: CABLES.as_bytes(), cables_name: "b" };
    assert_eq!(caspr::import(&files, &Options::default()).unwrap().robot.cable_count(), 2);
}

/// Truncation is the damage that happens: every cut is refused.
#[test]
fn a_cut_model_is_refused() {
    for end in 0..CABLES.trim_end().len() {
        let files =
            Files { bodies: BODIES.as_bytes(), bodies_name: "a", cables: &CABLES.as_bytes()[..end], cables_name: "b" };
        assert!(caspr::import(&files, &Options::default()).is_err(), "cut at {end}");
    }
}

proptest! {
    // fixed seeds: the same inputs in every run
    #![proptest_config(ProptestConfig {
        cases: 4096,
        rng_seed: proptest::test_runner::RngSeed::Fixed(11),
        failure_persistence: None,
        ..ProptestConfig::default()
    })]

    #[test]
    fn any_bytes_are_read_or_refused(bytes in proptest::collection::vec(any::<u8>(), 0..400)) {
        check(&bytes, CABLES.as_bytes());
        check(BODIES.as_bytes(), &bytes);
    }

    #[test]
    fn damaged_models_are_read_or_refused(list in proptest::collection::vec(damage(), 1..4)) {
        let apply = |text: &str| list.iter().fold(text.as_bytes().to_vec(), damaged);
        check(&apply(BODIES), CABLES.as_bytes());
        check(BODIES.as_bytes(), &apply(CABLES));
        check(&apply(BODIES), &apply(CABLES));
    }
}
