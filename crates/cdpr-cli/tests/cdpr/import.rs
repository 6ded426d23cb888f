//! `cdpr import`: robots of other tools.

use super::{Run, cdpr_in, numbers};

/// A platform in three cables, one of them a passive spring.
pub(crate) fn model() -> tempfile::TempDir {
    let bodies = r#"<bodies_system><links><link_rigid num="1" name="Plate">
<joint type="T_XYZ" q_initial="1 1 1" q_min="0 0 0" q_max="2 2 2"/>
<physical><mass>2</mass><com_location>0 0 0</com_location><end_location>0 0 1</end_location>
<inertia ref="com"><Ixx>0</Ixx><Iyy>0</Iyy><Izz>0</Izz><Ixy>0</Ixy><Ixz>0</Ixz><Iyz>0</Iyz></inertia></physical>
<parent><num>0</num><location>0 0 0</location></parent></link_rigid></links></bodies_system>"#;
    let cable = |kind: &str, name: &str, anchor: &str| {
        format!(
            "<{kind} name=\"{name}\" attachment_reference=\"joint\"><properties><force_min>1</force_min>\
             <force_max>9</force_max></properties><attachments><attachment><link>0</link><location>{anchor}</location>\
             </attachment><attachment><link>1</link><location>0 0 0</location></attachment></attachments></{kind}>\n"
        )
    };
    let set = |name: &str, cables: [String; 3]| format!("<cable_set id=\"{name}\">\n{}</cable_set>\n", cables.concat());
    let ideal = |name: &str, anchor: &str| cable("cable_ideal", name, anchor);
    let spring = cable("cable_passive_linear_spring", "return spring", "1 1 0");
    let cables = format!(
        "<cables default_cable_set=\"sprung\">\n{}{}</cables>\n",
        set("sprung", [ideal("a", "0 0 3"), ideal("b", "2 2 3"), spring]),
        set("driven", [ideal("a", "0 0 3"), ideal("b", "2 2 3"), ideal("c", "0 2 3")])
    );
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("plate_bodies.xml"), bodies).unwrap();
    std::fs::write(folder.path().join("plate_cables.xml"), cables).unwrap();
    folder
}

fn imported(folder: &tempfile::TempDir, options: &str) -> Run {
    cdpr_in(folder.path(), &format!("import caspr plate_bodies.xml plate_cables.xml --out plate.toml {options}"))
}

#[test]
fn an_imported_robot_can_be_used_at_once() {
    let folder = model();
    let run = imported(&folder, "--cable-set driven --format json");
    assert_eq!(run.exit_code, 0, "{}", run.stderr);
    let answer = run.json_with(&["robot", "out", "taken", "refused", "reported", "warnings"]);
    assert_eq!((answer["robot"].as_str(), answer["motion_pattern"].as_str()), (Some("plate"), Some("3T")));
    assert_eq!(answer["taken"]["cables"].as_array().unwrap().len(), 3);
    assert_eq!(answer["refused"].as_array().unwrap().len(), 0);
    // the tool point of CASPR does not act
    assert_eq!(answer["reported"][0]["element"], "end_location");
    let lengths = cdpr_in(folder.path(), "ik plate.toml --pose 1,1,1 --format json").json();
    let expected = 6.0_f64.sqrt(); // 1 m, 1 m and 2 m to each anchor
    assert!(numbers(&lengths["cable_lengths_m"]).iter().all(|length| (length - expected).abs() < 1e-12), "{lengths}");
}

#[test]
fn what_is_left_out_is_told_with_name_and_line_everywhere() {
    let folder = model();
    let run = imported(&folder, "--name sprung-plate --format json");
    assert_eq!(run.exit_code, 0, "{}", run.stderr);
    let left_out = &run.json()["refused"][0];
    assert_eq!((left_out["name"].as_str(), left_out["line"].as_u64()), (Some("return spring"), Some(5)));
    assert!(run.stderr.contains("plate_cables.xml:5: <cable_passive_linear_spring> `return spring`"), "{}", run.stderr);
    let file = std::fs::read_to_string(folder.path().join("plate.toml")).unwrap();
    assert!(file.contains("name = \"sprung-plate\"") && file.contains("return spring"), "{file}");
    assert!(imported(&folder, "").stdout.contains("left out\n  plate_cables.xml:5"));
}

#[test]
fn strict_writes_nothing_where_something_would_be_left_out() {
    let folder = model();
    let run = imported(&folder, "--strict");
    assert_eq!(run.exit_code, 2);
    assert!(run.stderr.contains("`return spring`"), "{}", run.stderr);
    assert!(!folder.path().join("plate.toml").exists());
    assert_eq!(imported(&folder, "--strict --cable-set driven").exit_code, 0);
}

#[test]
fn models_that_cannot_be_imported_are_refused_with_their_place() {
    let folder = model();
    for (options, message) in [("--cable-set drivn", "did you mean `driven`?"), ("--name=", "one word")] {
        let run = imported(&folder, options);
        assert_eq!(run.exit_code, 2, "{options}");
        assert!(run.stderr.contains(message), "{}", run.stderr);
    }
    let swapped = cdpr_in(folder.path(), "import caspr plate_cables.xml plate_bodies.xml --out plate.toml");
    assert_eq!(swapped.exit_code, 2);
    assert!(swapped.stderr.contains("--> plate_cables.xml:1:1") && swapped.stderr.contains("right order"));
    assert_eq!(cdpr_in(folder.path(), "import caspr none.xml plate_cables.xml --out plate.toml").exit_code, 4);
    let path = folder.path().join("plate_bodies.xml");
    let bodies = std::fs::read_to_string(&path).unwrap().replace("T_XYZ", "S_EULER_XYZ");
    std::fs::write(&path, bodies).unwrap();
    let run = imported(&folder, "--format json");
    let error = run.json_with(&["file", "line", "column", "code"]);
    assert_eq!((run.exit_code, error["line"].as_u64(), error["code"].as_str()), (2, Some(2), Some("caspr::joint")));
    assert!(!folder.path().join("plate.toml").exists());
}
