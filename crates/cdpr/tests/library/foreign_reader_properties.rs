//! The reader of CASPR's models meets damage made for XML: values between marks replaced, elements repeated, files cut.

use super::readers::caspr::{BODIES, CABLES, check};
use cdpr::robot::caspr::{self, Files, Options};
use cdpr_testing::property;
use proptest::prelude::*;

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
    #![proptest_config(property::cases(4096))]

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
