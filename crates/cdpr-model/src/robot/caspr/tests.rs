//! Small models, with one CASPR feature each.

use std::f64::consts::FRAC_PI_2;

use nalgebra::Vector3;

use super::*;
use crate::geometry::MotionPattern;

const BODIES: &str = r#"<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE bodies_system SYSTEM "../../templates/bodies.dtd">
<bodies_system>
  <links display_range="0 1 0 1 0 1" view_angle="0 90">
    <link_rigid num="1" name="Test plate">
      <joint type="SPATIAL_EULER_XYZ" q_initial="1 2 3 0 0 0" q_min="0 0 0 -3.1416 -3.1416 -3.1416" q_max="4 4 4 3.1416 3.1416 3.1416"/>
      <physical>
        <mass>2</mass>
        <com_location>0.1 0 0</com_location>
        <end_location>0 0 0</end_location>
        <inertia ref="com">
          <Ixx>1</Ixx>
          <Iyy>2</Iyy>
          <Izz>3</Izz>
          <Ixy>0.1</Ixy>
          <Ixz>0.2</Ixz>
          <Iyz>0.3</Iyz>
        </inertia>
      </physical>
      <parent>
        <num>0</num>
        <location>0 0 0.5</location>
      </parent>
    </link_rigid>
  </links>
</bodies_system>
"#;

const CABLES: &str = r#"<!DOCTYPE cables SYSTEM "../../templates/cables.dtd">
<cables default_cable_set="plain">
  <cable_set id="plain">
    <cable_ideal name="a" attachment_reference="joint">
      <properties><force_min>1</force_min><force_max>10</force_max></properties>
      <attachments>
        <attachment><link>0</link><location>0 0 5</location></attachment>
        <attachment><link>1</link><location>0.1 0.2 0.3</location></attachment>
      </attachments>
    </cable_ideal>
    <cable_linear_spring name="b" attachment_reference="com">
      <properties><K>1300</K><force_min>0</force_min><force_max>Inf</force_max></properties>
      <attachments>
        <base_rotating_pulley>
          <fixed_location>4 0 5</fixed_location>
          <pulley_radius>0.05</pulley_radius>
          <cable_entry_vector>0 0 2</cable_entry_vector>
        </base_rotating_pulley>
        <attachment><link>1</link><location>0 0 0</location></attachment>
      </attachments>
    </cable_linear_spring>
  </cable_set>
  <cable_set id="other">
    <cable_passive_linear_spring name="s" attachment_reference="com">
      <properties><K>5</K><l0>1</l0></properties>
      <attachments>
        <attachment><link>0</link><location>0 0 9</location></attachment>
        <attachment><link>1</link><location>0 0 0</location></attachment>
      </attachments>
    </cable_passive_linear_spring>
    <cable_vsd_torsion_spring name="v" attachment_reference="joint">
      <properties><K_cable>5</K_cable><force_min>0</force_min><force_max>1</force_max></properties>
      <attachments>
        <attachment><link>1</link><location>0 0 0</location></attachment>
        <attachment><link>0</link><location>0 0 9</location></attachment>
      </attachments>
    </cable_vsd_torsion_spring>
    <cable_ideal name="v" attachment_reference="joint">
      <properties><force_min>0</force_min><force_max>1</force_max><diameter>0.006</diameter></properties>
      <attachments>
        <attachment><link>0</link><location>1 0 9</location></attachment>
        <attachment><link>1</link><location>0 0 0</location></attachment>
      </attachments>
    </cable_ideal>
  </cable_set>
</cables>
"#;

fn imported(bodies: &str, cables: &str, cable_set: Option<&str>) -> Result<Import, ReadError> {
    let files = Files {
        bodies: bodies.as_bytes(),
        bodies_name: "models/Test_plate_bodies.xml",
        cables: cables.as_bytes(),
        cables_name: "models/Test_plate_cables.xml",
    };
    import(&files, &Options { cable_set, name: None })
}

#[test]
fn every_number_arrives_in_its_place() {
    let import = imported(BODIES, CABLES, None).unwrap();
    let robot = &import.robot;
    assert_eq!((robot.name.as_str(), robot.title.as_deref()), ("test-plate", Some("Test plate")));
    assert_eq!(robot.motion_pattern, MotionPattern::Spatial);
    assert_eq!(robot.gravity, Some(Vector3::new(0.0, 0.0, -9.81)));
    // the joint is 0.5 m above the world's origin
    assert_eq!(robot.home.unwrap().position, Vector3::new(1.0, 2.0, 3.5));
    assert_eq!(robot.travel.as_ref().unwrap().max, Vector3::new(4.0, 4.0, 4.5));
    assert_eq!(robot.platform.inertia.unwrap()[(2, 1)], 0.3);
    let [a, b] = &robot.cables[..] else { panic!("two cables") };
    assert_eq!((a.tension_min, a.tension_max, a.axial_stiffness()), (Some(1.0), Some(10.0), None));
    assert_eq!(a.platform_anchor, Vector3::new(0.1, 0.2, 0.3));
    // `com` counts from the centre of mass; the entry vector becomes a direction
    assert_eq!(b.platform_anchor, Vector3::new(0.1, 0.0, 0.0));
    assert_eq!((b.pulley_radius(), b.pulley_swivel_axis()), (Some(0.05), Some(Vector3::z())));
    assert_eq!((b.axial_stiffness(), b.tension_max), (Some(1300.0), None));
    assert_eq!((import.cable_set.as_str(), import.cable_sets), ("plain", vec!["plain".to_owned(), "other".to_owned()]));
    assert_eq!(import.findings, []);
}

#[test]
fn springs_and_devices_are_told_with_name_and_line() {
    let import = imported(BODIES, CABLES, Some("other")).unwrap();
    let names: Vec<&str> = import.robot.cables.iter().map(|cable| cable.name.as_str()).collect();
    assert_eq!(names, ["v", "v-2"], "a second cable of one name gets its own");
    let told: Vec<(Loss, Option<&str>, usize)> =
        import.findings.iter().map(|it| (it.loss, it.name.as_deref(), it.line)).collect();
    assert_eq!(
        told,
        [
            (Loss::LeftOut, Some("s"), 24),
            (Loss::Simplified, Some("v"), 31),
            (Loss::Simplified, Some("v"), 38),
            (Loss::Ignored, None, 23)
        ]
    );
    assert!(import.findings[1].why.contains("K_cable") && import.findings[2].why.contains("diameter"));
    let notes = import.robot.notes.join("\n");
    assert!(notes.contains("passive spring") && notes.contains("\"s\""), "{notes}");
}

/// Inertia about the joint is larger by m·(c²·1 − c cᵀ) than about the centre of mass.
#[test]
fn inertia_about_the_joint_is_brought_to_the_centre_of_mass() {
    let import = imported(&BODIES.replace("ref=\"com\"", "ref=\"joint\""), CABLES, None).unwrap();
    let inertia = import.robot.platform.inertia.unwrap();
    let expected = Vector3::new(1.0, 2.0 - 0.02, 3.0 - 0.02); // m = 2 kg, c = 0.1 m along x
    assert!((inertia.diagonal() - expected).amax() < 1e-15, "{inertia}"); // rounding of numbers near 1
}

/// PLANAR_XZ turns about +y, which is from z to x; our plane `xz` turns from x to z.
#[test]
fn planar_angles_turn_as_casprs_joints_do() {
    for (joint, axis, gravity) in [
        ("PLANAR_XY", Vector3::z(), Vector3::zeros()),
        ("PLANAR_YZ", Vector3::x(), -Vector3::z() * 9.81),
        ("PLANAR_XZ", Vector3::y(), -Vector3::z() * 9.81),
    ] {
        let bodies = BODIES
            .replace("SPATIAL_EULER_XYZ", joint)
            .replace("1 2 3 0 0 0", &format!("1 2 {FRAC_PI_2}"))
            .replace("0 0 0 -3.1416 -3.1416 -3.1416", "0 0 -3.1416")
            .replace("4 4 4 3.1416 3.1416 3.1416", "4 4 3.1416")
            .replace("<location>0 0 0.5<", "<location>0 0 0<")
            .replace("0.1 0 0<", "0 0 0<");
        // both ends in the plane through the joint
        let cables = CABLES.replace("0 0 5<", "0 0 0<").replace("4 0 5<", "4 4 4<").replace("0.1 0.2 0.3<", "0 0 0<");
        let cables = cables.replace(
            ">4 4 4<",
            if joint == "PLANAR_YZ" {
                ">0 4 4<"
            } else if joint == "PLANAR_XZ" {
                ">4 0 4<"
            } else {
                ">4 4 0<"
            },
        );
        let cables = cables.replace("0 0 2<", if joint == "PLANAR_XY" { "0 2 0<" } else { "0 0 2<" });
        let import = imported(&bodies, &cables, None).unwrap_or_else(|error| panic!("{joint}: {error}"));
        let rotation = import.robot.home.unwrap().rotation;
        // the arc cosine inside an angle loses half the digits, the axis does not
        assert!((rotation.scaled_axis() - axis * FRAC_PI_2).norm() < 1e-14, "{joint}");
        assert_eq!(import.robot.gravity, Some(gravity), "{joint}");
        let normal = import.robot.plane.normal();
        let stated = Vector3::new(1.0, 2.0, 3.0).component_mul(&axis).sum();
        assert_eq!(import.robot.platform.inertia.unwrap(), normal * normal.transpose() * stated, "{joint}");
    }
}

#[test]
fn points_in_space_have_no_orientation() {
    let bodies = BODIES
        .replace("SPATIAL_EULER_XYZ", "T_XYZ")
        .replace("1 2 3 0 0 0", "1 2 3")
        .replace(" -3.1416 -3.1416 -3.1416", "")
        .replace(" 3.1416 3.1416 3.1416", "");
    let import = imported(&bodies, CABLES, None).unwrap();
    assert_eq!((import.robot.motion_pattern, import.joint.as_str()), (MotionPattern::SpatialPoint, "T_XYZ"));
}

/// Asserts that one replacement is refused at `line` of the file, with this code, and that the message names `named`.
fn refused(in_bodies: bool, (from, to): (&str, &str), (line, code, named): (usize, &str, &str)) {
    let original = if in_bodies { BODIES } else { CABLES };
    assert!(original.contains(from), "{from}");
    let text = original.replacen(from, to, 1);
    let result = if in_bodies { imported(&text, CABLES, None) } else { imported(BODIES, &text, None) };
    let error = result.expect_err(&format!("accepted: {to}"));
    assert_eq!((error.line(), error.code), (Some(line), code), "{error}");
    assert!(error.to_string().contains(named), "`{named}` is not in: {error}");
    assert!(error.file_name.ends_with(if in_bodies { "_bodies.xml" } else { "_cables.xml" }), "{error}");
}

#[test]
fn bodies_that_no_robot_is_are_refused_with_their_place() {
    let second = "<link_rigid num=\"2\" name=\"Arm\"/>\n  </links>";
    for (from, to, line, code, named) in [
        ("</links>", second, 25, "caspr::several-links", "`Arm`"),
        ("SPATIAL_EULER_XYZ", "S_EULER_XYZ", 6, "caspr::joint", "S_EULER_XYZ holds the platform"),
        ("SPATIAL_EULER_XYZ", "SPATIAL_EULER_ZYX", 6, "caspr::joint", "did you mean `SPATIAL_EULER_XYZ`?"),
        ("q_initial=\"1 2 3 0 0 0\"", "q_initial=\"1 2 3\"", 6, "xml::wrong-type", "6 coordinates, found 3"),
        ("q_initial=\"1 2 3 0 0 0\"", "q_initial=\"1 2 3 0 0 pi\"", 6, "xml::wrong-type", "`pi`"),
        ("q_max=\"4 4", "q_max=\"4 -4", 6, "caspr::range", "q_min[2]"),
        ("<mass>2</mass>", "<mass>-2</mass>", 8, "robot::negative", "-2"),
        ("<mass>2</mass>", "", 7, "xml::missing", "<mass>"),
        ("<mass>2</mass>", "<mass>2</mass><mass>3</mass>", 8, "xml::twice", "<mass>"),
        ("<mass>2</mass>", "<mass>NaN</mass>", 8, "xml::wrong-type", "NaN"),
        ("0.1 0 0<", "0.1 0<", 9, "xml::wrong-type", "3 numbers, found 2"),
        ("ref=\"com\"", "ref=\"con\"", 11, "caspr::reference", "`con`"),
        ("<Ixx>1<", "<Ixx>-1<", 11, "robot::inertia", "negative"),
        ("<num>0<", "<num>1<", 21, "caspr::parent", "base"),
        ("<bodies_system>", "<bodies>", 26, "xml::syntax", "this is not XML"),
    ] {
        refused(true, (from, to), (line, code, named));
    }
}

#[test]
fn cables_that_no_robot_has_are_refused_with_their_place() {
    let third = "<attachment><link>1</link><location>0.1 0.2 0.3</location></attachment>\n        <attachment><link>1</link><location>0 0 0</location></attachment>";
    for (from, to, line, code, named) in [
        ("\"plain\">\n  <", "\"plane\">\n  <", 2, "caspr::cable-set", "did you mean `plain`?"),
        ("default_cable_set=\"plain\"", "", 2, "caspr::cable-set", "plain, other"),
        (" name=\"a\"", "", 4, "xml::missing", "`name`"),
        ("attachment_reference=\"joint\"", "attachment_reference=\"tip\"", 4, "caspr::reference", "`tip`"),
        ("<force_min>1<", "<force_min>-1<", 5, "robot::negative", "`a`"),
        ("<force_min>1<", "<force_min>11<", 5, "robot::tension-limits", "`a`"),
        ("<K>1300</K>", "", 12, "xml::missing", "<K>"),
        ("<K>1300</K>", "<K>0</K>", 12, "robot::not-positive", "`b`"),
        ("<link>0</link>", "<link>1</link>", 4, "caspr::links", "`a`"),
        ("<link>1</link>", "<link>2</link>", 4, "caspr::links", "`a`"),
        ("<attachment><link>1</link><location>0.1 0.2 0.3</location></attachment>", third, 9, "caspr::routing", "3"),
        ("<pulley_radius>0.05<", "<pulley_radius>-0.05<", 16, "robot::negative", "`b`"),
        ("0 0 2<", "0 0 0<", 17, "robot::swivel-axis", "direction"),
        ("<fixed_location>4 0 5<", "<fixed_location>0 0 5<", 3, "caspr::not-a-robot", "same point"),
    ] {
        refused(false, (from, to), (line, code, named));
    }
}

#[test]
fn unknown_kinds_of_cable_and_attachment_are_named() {
    let cables = CABLES.replace("cable_ideal", "muscle_hill_type");
    let error = imported(BODIES, &cables, None).unwrap_err();
    assert_eq!((error.line(), error.code), (Some(4), "caspr::cable-type"), "{error}");
    let error =
        imported(BODIES, &CABLES.replace("base_rotating_pulley", "screw_base_rotating_pulley"), None).unwrap_err();
    assert!(error.to_string().contains("allowed: attachment, base_rotating_pulley"), "{error}");
    let missing = imported(BODIES, CABLES, Some("othr")).unwrap_err();
    assert!(missing.to_string().contains("did you mean `other`? allowed: plain, other"), "{missing}");
}

#[test]
fn a_cable_that_leaves_a_planar_robots_plane_is_refused() {
    let bodies = BODIES.replace("SPATIAL_EULER_XYZ", "P_XY").replace("1 2 3 0 0 0", "1 2");
    let bodies = bodies.replace("0 0 0 -3.1416 -3.1416 -3.1416", "0 0").replace("4 4 4 3.1416 3.1416 3.1416", "4 4");
    let error = imported(&bodies, CABLES, None).unwrap_err();
    assert_eq!((error.line(), error.code), (Some(7), "caspr::out-of-plane"), "{error}");
}

#[test]
fn robots_are_named_after_their_file() {
    for (path, name) in [
        ("CoGiRo_bodies.xml", "cogiro"),
        ("a/b\\2_DoF_VSD_bodies.xml", "2-dof-vsd"),
        ("NIST_RoboCrane_bodies.xml", "nist-robocrane"),
        ("bodies", "bodies"),
        ("é.xml", "imported"),
    ] {
        assert_eq!(plain_name(path), name);
    }
}
