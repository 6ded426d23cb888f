//! Pages on robots made up here: well-formed, self-contained, and telling what the library computes.

use cdpr_model::equilibrium::distribution;
use cdpr_model::geometry::Pose;
use cdpr_model::model::{Composition, Model};
use cdpr_model::reading::ErrorCode;
use cdpr_model::robot::Robot;
use cdpr_model::statics::Load;
use cdpr_model::tension::Limits;
use cdpr_workspace::Criterion;
use cdpr_workspace::criterion::WrenchFeasible;

use nalgebra::Vector3;

use cdpr_workspace::mesh::{Field, Mesh};

use super::*;
use crate::answers::WorkspaceAnswer;
use crate::html_page::reading::{assert_stands_alone, data, markup};

/// Ingredients of a page.
struct Case {
    model: Model,
    load: Load,
    limits: Limits,
    start: Pose,
    bounds: Vec<[f64; 2]>,
    findings: Vec<Finding>,
}

impl Case {
    fn new(robot: Robot, limits: [f64; 2], bounds: &[[f64; 2]]) -> Self {
        let load = Load::of(&robot).unwrap();
        let limits = Limits::uniform(robot.cable_count(), limits[0], limits[1]).unwrap();
        let start = robot.home_or_middle();
        let model = Model::new(robot, Composition::STANDARD).unwrap();
        Self { model, load, limits, start, bounds: bounds.to_vec(), findings: vec![] }
    }

    fn planar() -> Self {
        Self::new(Robot::builtin("planar-example").unwrap(), [1000.0, 8000.0], &[[-4.0, 4.0], [0.5, 9.5]])
    }

    fn spatial() -> Self {
        let robot = Robot::builtin("cablerobot-simulator-helicopter").unwrap();
        Self::new(robot, [1000.0, 9000.0], &[[-4.0, 4.0], [-4.0, 4.0], [-1.5, 5.5]])
    }

    fn page(&self) -> String {
        let criterion = WrenchFeasible::new(&self.model, &self.load, &self.limits).unwrap();
        render(&WorkspacePage {
            model: &self.model,
            answer: &WorkspaceAnswer::default(),
            criterion: criterion.name(),
            unit: criterion.unit(),
            judge: &|pose| criterion.judge(pose),
            statics: Some((&self.load, &self.limits)),
            start: &self.start,
            bounds: &self.bounds,
            findings: &self.findings,
            is_found: !self.findings.is_empty(),
            facts: &[("Limits", "1000 N to 8000 N".to_owned())],
            warnings: &["`--step` is coarse".to_owned()],
            command: "cdpr workspace robot --page page.html",
            version: "0.1.0",
        })
        .unwrap()
    }
}

fn tetrahedron() -> Mesh {
    Mesh {
        vertices: vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.5]],
        triangles: vec![[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]],
        fields: vec![
            Field { name: "margin".to_owned(), unit: "N".to_owned(), values: vec![0.5, 0.25, 0.0, 12.5] },
            Field { name: "limiting cable".to_owned(), unit: String::new(), values: vec![1.0, 8.0, 8.0, 0.0] },
        ],
    }
}

#[test]
fn the_page_is_well_formed_and_asks_nothing_of_the_network() {
    for page in [Case::planar().page(), Case::spatial().page()] {
        assert_stands_alone(&page);
    }
}

/// Every node of the page holds the tensions and the verdict that the library gives there, to the four digits written.
#[test]
fn the_grid_of_the_page_holds_what_the_library_computes() {
    for case in [Case::planar(), Case::spatial()] {
        let data = data(&case.page());
        let grid = &data["grid"];
        let axes = grid["axes"].as_array().unwrap();
        let criterion = WrenchFeasible::new(&case.model, &case.load, &case.limits).unwrap();
        let numbers = |value: &serde_json::Value| -> Vec<f64> {
            value.as_array().unwrap().iter().map(|number| number.as_f64().unwrap()).collect()
        };
        let count = grid["margin"].as_array().unwrap().len();
        let (mut feasible, mut infeasible) = (0, 0);
        for node in (0..count).step_by(37) {
            let mut position = Vector3::from_column_slice(&numbers(&grid["base_m"]));
            let mut rest = node as u64;
            for axis in axes {
                let count = axis["count"].as_u64().unwrap();
                let at = axis["start_m"].as_f64().unwrap() + (rest % count) as f64 * axis["step_m"].as_f64().unwrap();
                position += at * Vector3::from_column_slice(&numbers(&axis["direction"]));
                rest /= count;
            }
            let pose = Pose { position, ..case.start };
            let found = distribution::solve(&case.model, &pose, &case.load, &case.limits).unwrap();
            let verdict = criterion.judge(&pose);
            match grid["tensions_N"][node].as_array() {
                Some(_) => {
                    feasible += 1;
                    for (shown, computed) in numbers(&grid["tensions_N"][node]).iter().zip(&found.tensions) {
                        assert!((shown - computed).abs() <= 5.1e-4 * computed, "{shown} N for {computed} N");
                    }
                    assert_eq!(grid["reason"][node], -1);
                }
                None => {
                    infeasible += 1;
                    assert!(found.reason.is_some(), "tensions are missing at {position}");
                    let sentence = grid["sentences"][grid["reason"][node].as_u64().unwrap() as usize].as_str().unwrap();
                    assert_eq!(
                        sentence.matches('§').count(),
                        grid["numbers"][node].as_str().unwrap().split(' ').count()
                    );
                }
            }
            assert_eq!(grid["margin"][node].as_f64().unwrap_or(f64::NEG_INFINITY) >= 0.0, verdict.holds());
        }
        assert!(feasible > 5 && infeasible > 5, "both kinds were seen: {feasible}, {infeasible}");
    }
}

#[test]
fn names_from_files_cannot_become_markup() {
    let mut case = Case::planar();
    let mut robot = case.model.robot().clone();
    robot.name = "</script><script>alert(1)</script>".to_owned();
    robot.cables[0].name = "<img src='http://x'>".to_owned();
    case.model = Model::new(robot, Composition::STANDARD).unwrap();
    let page = case.page();
    assert!(!page.contains("<script>alert"));
    assert!(!markup(&page).contains("<img"));
    assert_eq!(data(&page)["robot"]["cables"][0]["name"], "<img src='http://x'>");
}

#[test]
fn results_of_a_page_can_be_laid_over_another() {
    let mut case = Case::spatial();
    case.findings = vec![
        Finding {
            name: "1 to 9 kN".to_owned(),
            measure: 0.25,
            error_bound: Some(0.01),
            shape: Shape::Surface { mesh: tetrahedron(), method: "octree".to_owned() },
        },
        Finding { name: "grid".to_owned(), measure: 0.3, error_bound: None, shape: Shape::Unknown },
    ];
    assert_eq!(findings_of(&case.page()).unwrap(), case.findings);
    let page = case.page();
    assert_eq!(data(&page)["regions"][0]["limiting_cable"], serde_json::json!([1, 8, 8, 0]));
    assert!(page.contains("surface of the octree, 4 triangles") && !page.contains("hull of"), "its form has its name");
    let outlines = vec![vec![[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]];
    let mut planar = Case::planar();
    let region = Finding { name: "area".to_owned(), measure: 0.5, error_bound: None, shape: Shape::Areas(outlines) };
    planar.findings = vec![region];
    assert_eq!(findings_of(&planar.page()).unwrap(), planar.findings);
}

/// Pages of earlier versions said nothing of their vertices, nor how a surface was found.
#[test]
fn a_surface_of_an_earlier_version_can_still_be_laid_over() {
    let region = r#"{"name":"a","measure":1,"error_bound":null,"unit":"m³","vertices_m":[0,0,0,1,0,0,0,1,0],"triangles":[0,1,2],"outlines_m":[]}"#;
    let block = format!(
        r#"<script type="application/json" id="cdpr-data">{{"page":"workspace","regions":[{region}]}}</script>"#
    );
    let Shape::Surface { mesh, method } = &findings_of(&block).unwrap()[0].shape else {
        panic!("a surface was written")
    };
    assert_eq!((mesh.triangles.len(), mesh.fields.len(), method.as_str()), (1, 0, "hull"));
}

#[test]
fn a_file_that_is_no_page_is_refused_with_the_reason() {
    let block = r#"<script type="application/json" id="cdpr-data">"#;
    let region = r#"{"name":"a","measure":1,"error_bound":null,"unit":"m³","vertices_m":[0,0,0],"triangles":[0,0,1],"outlines_m":[]}"#;
    for (text, reason) in [
        ("<p>nothing</p>".to_owned(), "no results"),
        (format!("{block}{{]</script>"), "cannot be read"),
        (format!(r#"{block}{{"page":"report","regions":[]}}</script>"#), "about report"),
        (format!(r#"{block}{{"page":"workspace","regions":[{region}]}}</script>"#), "vertices that are not there"),
    ] {
        let error = findings_of(&text).unwrap_err();
        assert_eq!(error.code(), "workspace::overlay");
        assert!(error.to_string().contains(reason), "{error}");
    }
}
