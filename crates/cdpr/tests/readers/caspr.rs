//! A small model of CASPR, and what must hold of its reader.
#![allow(dead_code, reason = "tests and the long run use different parts")]

use cdpr::robot::Robot;
use cdpr::robot::caspr::{Files, Options, import};

/// A robot with everything that the reader of bodies knows.
pub(crate) const BODIES: &str = r#"<?xml version="1.0" encoding="utf-8"?>
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

/// Its cables: a plain one, an elastic one over a pulley, a passive spring.
pub(crate) const CABLES: &str = r#"<cables default_cable_set="one">
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

/// Reads both files; what is accepted is finite and read back unchanged, what is refused is told in words.
pub(crate) fn check(bodies: &[u8], cables: &[u8]) {
    let files = Files { bodies, bodies_name: "any_bodies.xml", cables, cables_name: "any_cables.xml" };
    match import(&files, &Options::default()) {
        Ok(found) => {
            let robot = found.robot;
            assert_eq!(Robot::from_toml(&robot.to_toml(), "again.toml").as_ref(), Ok(&robot));
            assert!(robot.home.is_some_and(|home| home.is_finite()));
            robot.warnings();
        }
        Err(error) => {
            assert!(!error.to_string().is_empty() && error.place.iter().all(|place| place.snippet().contains('^')));
        }
    }
}

/// As [`check`], of a file of bodies.
pub(crate) fn check_bodies(bytes: &[u8]) {
    check(bytes, CABLES.as_bytes());
}

/// As [`check`], of a file of cables.
pub(crate) fn check_cables(bytes: &[u8]) {
    check(BODIES.as_bytes(), bytes);
}
