//! Stiffness and compliance of the platform at a pose.

use cdpr_model::geometry::Pose;
use cdpr_model::model::Model;
use cdpr_model::statics::{Stability, Stiffness};
use nalgebra::DMatrix;
use schemars::JsonSchema;
use serde::Serialize;

use super::tension_doubts::tension_doubts;
use super::{Answer, PoseAnswer, degrees_of_freedom};
use crate::number_format::cell;
use crate::table::Table;

type Rows = Vec<Vec<f64>>;

/// Stiffness matrices of a pose with their meaning.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "Stiffness")]
pub struct StiffnessAnswer {
    robot: String,
    model: String,
    /// `stable`, `indifferent`, `unstable`; `infeasible` without tensions, `singular` without paths.
    status: &'static str,
    reason: Option<String>,
    pose: PoseAnswer,
    /// Names of the degrees of freedom.
    degrees_of_freedom: Vec<String>,
    #[serde(rename = "tensions_N")]
    tensions: Option<Vec<f64>>,
    #[serde(flatten)]
    matrices: Matrices,
    warnings: Vec<String>,
    #[serde(skip)]
    cable_names: Vec<String>,
}

/// Null without tensions or courses.
#[derive(Default, Serialize, JsonSchema)]
struct Matrices {
    /// Stiffness of the platform (N/m, N, N·m), row by row.
    stiffness: Option<Rows>,
    /// Part from the turning of cables and moment arms under tension, row by row; it is subtracted.
    geometric: Option<Rows>,
    /// Part from the stretch of the cables, row by row.
    cable: Option<Rows>,
    /// Part from the weight's moment, which turns with the platform, row by row; it is subtracted.
    gravity: Option<Rows>,
    /// Inverse of the stiffness, row by row; null where it has none.
    compliance: Option<Rows>,
    /// Change of the wrench with each controlled length (N/m, N), row by row.
    length_to_wrench: Option<Rows>,
    /// Eigenvalues of the stiffness, rotations by the length scale (N/m).
    #[serde(rename = "eigenvalues_N_per_m")]
    eigenvalues: Option<Vec<f64>>,
    /// Stiffness that counts as none.
    #[serde(rename = "indifferent_stiffness_N_per_m")]
    indifferent_stiffness: Option<f64>,
    /// Length by which rotations count (m).
    length_scale_m: f64,
    /// Stiffness of each cable (N/m).
    #[serde(rename = "cable_stiffness_N_per_m")]
    cable_stiffness: Option<Vec<f64>>,
    /// Lengths that the winches set, without strain (m).
    controlled_lengths_m: Option<Vec<f64>>,
    /// Wrench that is out of balance (N, N·m).
    wrench_residual: Option<Vec<f64>>,
}

fn rows(matrix: &DMatrix<f64>) -> Rows {
    // + 0.0: the sign of zero says nothing
    matrix.row_iter().map(|row| row.iter().map(|x| x + 0.0).collect()).collect()
}

/// Stability in a word, and why where it is a no.
fn verdict(model: &Model, stiffness: &Stiffness, tensions: &[f64]) -> (&'static str, Option<String>) {
    let stability = stiffness.stability();
    let smallest = stiffness.eigenvalues().first().copied().unwrap_or(f64::NAN);
    let reason = match stability {
        Stability::Stable => None,
        Stability::Unstable => {
            Some(format!("a displacement is driven on by {:.4} N/m instead of driven back", -smallest))
        }
        Stability::Indifferent => {
            let slack = tensions.iter().filter(|&&tension| tension == 0.0).count();
            let (cables, dof) = (model.cable_count(), model.dof());
            let counts = format!("{cables} cables, {slack} of them slack, for {dof} degrees of freedom");
            let none = counts_as_none(smallest, stiffness.indifferent_stiffness);
            Some(format!("in some direction nothing drives the platform back ({counts}; {none})"))
        }
    };
    (word(stability), reason)
}

/// Stability in a word.
pub(super) fn word(stability: Stability) -> &'static str {
    match stability {
        Stability::Stable => "stable",
        Stability::Indifferent => "indifferent",
        Stability::Unstable => "unstable",
    }
}

/// Clause on a stiffness that counts as none (N/m).
pub(super) fn counts_as_none(smallest: f64, indifferent: f64) -> String {
    format!("the stiffness there, {smallest:.1e} N/m, counts as none below {indifferent:.1e} N/m")
}

impl StiffnessAnswer {
    /// The answer before matrices are known.
    pub fn new(model: &Model, pose: &Pose) -> Self {
        let robot = model.robot();
        Self {
            robot: robot.name.clone(),
            model: model.composition().to_string(),
            status: "singular",
            reason: None,
            pose: PoseAnswer::new(robot, pose),
            degrees_of_freedom: degrees_of_freedom(robot),
            tensions: None,
            matrices: Matrices { length_scale_m: model.platform_radius(), ..Matrices::default() },
            warnings: Vec::new(),
            cable_names: robot.cables.iter().map(|cable| cable.name.clone()).collect(),
        }
    }

    /// The same without matrices: the status in a word, and the reason.
    pub fn refused(self, status: &'static str, reason: String) -> Self {
        Self { status, reason: Some(reason), ..self }
    }

    /// The same with the matrices at tensions (N), which leave a part of the load without balance.
    pub fn with(self, model: &Model, stiffness: &Stiffness, tensions: Vec<f64>, residual: &[f64]) -> Self {
        let (status, reason) = verdict(model, stiffness, &tensions);
        let warnings = tension_doubts(model, &tensions, residual);
        let compliance = stiffness.compliance();
        let matrices = Matrices {
            stiffness: Some(rows(&stiffness.system)),
            geometric: Some(rows(&stiffness.geometric)),
            cable: Some(rows(&stiffness.cable)),
            gravity: Some(rows(&stiffness.load)),
            compliance: compliance.as_ref().map(rows),
            length_to_wrench: Some(rows(&stiffness.by_controlled_length)),
            eigenvalues: Some(stiffness.eigenvalues()),
            indifferent_stiffness: Some(stiffness.indifferent_stiffness),
            length_scale_m: self.matrices.length_scale_m,
            cable_stiffness: Some(stiffness.cable_stiffness.clone()),
            controlled_lengths_m: Some(stiffness.controlled_lengths.clone()),
            wrench_residual: Some(residual.to_vec()),
        };
        Self { status, reason, matrices, warnings, tensions: Some(tensions), ..self }
    }

    fn matrix(&self, title: &str, rows: &Rows, scale: f64, width: Option<usize>) -> String {
        let mut heading = vec![title.to_owned()];
        heading.extend(self.degrees_of_freedom.iter().cloned());
        let mut table = Table::with_heading(heading);
        for (name, row) in self.degrees_of_freedom.iter().zip(rows) {
            table.row([vec![name.clone()], row.iter().map(|&x| cell(Some(scale * x), 3)).collect()].concat());
        }
        table.text(width)
    }
}

impl Answer for StiffnessAnswer {
    fn is_negative(&self) -> bool {
        self.reason.is_some()
    }

    fn words(&self, width: Option<usize>) -> String {
        let mut text = format!("{}, model {}, at {}\n", self.robot, self.model, self.pose.words());
        self.warnings.iter().for_each(|warning| text.push_str(&format!("warning: {warning}\n")));
        text.push_str(self.status);
        self.reason.iter().for_each(|reason| text.push_str(&format!(": {reason}")));
        text.push('\n');
        let Matrices { stiffness: Some(stiffness), geometric: Some(geometric), cable: Some(cable), .. } =
            &self.matrices
        else {
            return text;
        };
        let units = "forces N, moments N·m; columns per m, per rad";
        text.push_str(&format!(
            "\nstiffness K = K_C − K_G − ∂w/∂x ({units})\n{}",
            self.matrix("K", stiffness, 1.0, width)
        ));
        text.push_str(&format!("\nof cable stretch\n{}", self.matrix("K_C", cable, 1.0, width)));
        text.push_str(&format!("\nof turning cables\n{}", self.matrix("K_G", geometric, 1.0, width)));
        let gravity = self.matrices.gravity.iter().filter(|rows| rows.iter().flatten().any(|&x| x != 0.0));
        gravity.for_each(|rows| {
            text.push_str(&format!("\nof the turning weight\n{}", self.matrix("∂w/∂x", rows, 1.0, width)))
        });
        if let Some(compliance) = &self.matrices.compliance {
            let units = "µm, µrad; columns per N, per N·m";
            text.push_str(&format!("\ncompliance ({units})\n{}", self.matrix("1/K", compliance, 1e6, width)));
        }
        let values = self.matrices.eigenvalues.iter().flatten().map(|&value| cell(Some(value), 3));
        let (values, radius) = (values.collect::<Vec<_>>().join(", "), self.matrices.length_scale_m);
        text.push_str(&format!("\neigenvalues N/m (turns at a radius of {radius:.3} m): {values}\n\n"));
        let mut table = Table::new(["cable", "tension N", "stiffness N/m", "controlled length m"]);
        for (index, name) in self.cable_names.iter().enumerate() {
            let of = |list: &Option<Vec<f64>>| list.as_ref().map(|list| list[index]);
            let Matrices { cable_stiffness, controlled_lengths_m, .. } = &self.matrices;
            let numbers =
                [cell(of(&self.tensions), 3), cell(of(cable_stiffness), 1), cell(of(controlled_lengths_m), 6)];
            table.row([vec![name.clone()], numbers.to_vec()].concat());
        }
        text + &table.text(width)
    }
}
