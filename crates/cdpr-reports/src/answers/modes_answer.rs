//! Natural frequencies and mode shapes of small motions, and the linear system behind them.

use crate::keys::table_schema::nullable_numbers;
use cdpr_model::geometry::Pose;
use cdpr_model::model::Model;
use cdpr_model::robot::Assumption;
use cdpr_model::statics::Stability;
use cdpr_plant::{Linearization, Mode, Plant, PlantState};
use nalgebra::DMatrix;
use schemars::JsonSchema;
use serde::Serialize;

use super::stiffness_answer::{counts_as_none, word};
use super::tension_doubts::tension_doubts;
use super::{Answer, PoseAnswer, assumed_numbers, degrees_of_freedom, inertia_doubt};
use crate::number_format::{cell, significant};
use crate::table::Table;

type Rows = Vec<Vec<f64>>;

/// Modes of a machine about an equilibrium.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "Modes")]
pub struct ModesAnswer {
    robot: String,
    model: String,
    /// `stable`, `indifferent`, `unstable`; `singular` where the linear system has no modes.
    status: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    reason: Option<String>,
    pose: PoseAnswer,
    /// Names of the components of shapes, matrices and participations.
    degrees_of_freedom: Vec<String>,
    #[serde(rename = "tensions_N")]
    tensions: Vec<f64>,
    /// Modes, the slowest first.
    modes: Vec<ModeAnswer>,
    /// M, K and D of M δz̈ + D δż + K δz = input.
    mass_matrix: Rows,
    /// K of that equation, row by row.
    stiffness_matrix: Rows,
    /// D of that equation, row by row.
    damping_matrix: Rows,
    /// A and B of ẏ = A y + B u with y = \[δz; δż\], u = \[wrench; controlled lengths or motor torques; rates of controlled lengths\].
    system_matrix: Option<Rows>,
    /// B of that system, row by row.
    input_matrix: Option<Rows>,
    /// Real and imaginary part of the eigenvalues of A (1/s).
    eigenvalues_per_s: Vec<[f64; 2]>,
    /// Stiffness that counts as none.
    #[serde(rename = "indifferent_stiffness_N_per_m")]
    indifferent_stiffness: f64,
    /// Largest sensible step of `cdpr run` (s).
    step_max_s: Option<f64>,
    /// Numbers of the robot file that the motion rests on and that no source states.
    assumptions: Vec<Assumption>,
    warnings: Vec<String>,
}

/// Mode of a machine.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "Mode", transform = nullable_numbers)]
struct ModeAnswer {
    /// Natural frequency (Hz); negative if the motion grows, 0 if its stiffness counts as none.
    #[serde(rename = "frequency_Hz")]
    frequency: f64,
    /// `stable`, `indifferent`, `unstable`.
    stability: &'static str,
    /// Stiffness along the mode (N/m), rotations by the platform radius.
    #[serde(rename = "stiffness_N_per_m")]
    stiffness: f64,
    /// Damping as a fraction of critical damping; null if the mode does not oscillate.
    damping_ratio: f64,
    /// Displacements along the degrees of freedom (m, rad), then angles of drums (rad), for modal mass 1.
    shape: Vec<f64>,
    /// Fraction of each degree of freedom in the kinetic energy of the mode.
    participation: Vec<f64>,
}

impl ModeAnswer {
    fn new(mode: &Mode) -> Self {
        Self {
            frequency: mode.frequency,
            stability: word(mode.stability),
            stiffness: mode.stiffness,
            damping_ratio: mode.damping_ratio,
            shape: mode.shape.as_slice().to_vec(),
            participation: mode.participation.as_slice().to_vec(),
        }
    }
}

/// Rows of a matrix.
pub(super) fn rows(matrix: &DMatrix<f64>) -> Rows {
    // + 0.0: the sign of zero says nothing
    matrix.row_iter().map(|row| row.iter().map(|x| x + 0.0).collect()).collect()
}

impl ModesAnswer {
    /// Modes of a machine at a pose, whose tensions leave a residual wrench in the degrees of freedom (N, N·m).
    pub fn new(plant: &Plant, pose: &Pose, residual: &[f64], state: &PlantState, linear: &Linearization) -> Self {
        let model: &Model = plant.model();
        let modes = linear.modes().unwrap_or_default();
        let (status, reason) = verdict(&modes, linear.indifferent_stiffness);
        let tensions: Vec<f64> = state.cables.iter().map(|cable| cable.tension).collect();
        let inertia = inertia_doubt::of_robot(model.robot());
        let warnings = tension_doubts(model, &tensions, residual).into_iter().chain(inertia).collect();
        let drums = (linear.dof..linear.size()).map(|row| format!("drum {}", row - linear.dof + 1));
        let eigenvalues = linear.eigenvalues().unwrap_or_default();
        Self {
            robot: model.robot().name.clone(),
            model: model.composition().to_string(),
            status,
            reason,
            pose: PoseAnswer::new(model.robot(), pose),
            degrees_of_freedom: degrees_of_freedom(model.robot()).into_iter().chain(drums).collect(),
            tensions,
            modes: modes.iter().map(ModeAnswer::new).collect(),
            mass_matrix: rows(&linear.mass),
            stiffness_matrix: rows(&linear.stiffness),
            damping_matrix: rows(&linear.damping),
            system_matrix: linear.system_matrix().as_ref().map(rows),
            input_matrix: linear.input_matrix().as_ref().map(rows),
            eigenvalues_per_s: eigenvalues.iter().map(|value| [value.re, value.im]).collect(),
            indifferent_stiffness: linear.indifferent_stiffness,
            step_max_s: linear.largest_step(),
            assumptions: plant.assumptions().cloned().collect(),
            warnings,
        }
    }
}

/// Stability in a word, and why where it is a no; the slowest mode comes first, and those that grow before all others.
fn verdict(modes: &[Mode], indifferent: f64) -> (&'static str, Option<String>) {
    let Some(first) = modes.first() else {
        return ("singular", Some("the linear system has no modes that swing or grow by themselves".to_owned()));
    };
    let reason = match first.stability {
        Stability::Stable => None,
        Stability::Unstable => Some("the smallest displacement grows along the first mode".to_owned()),
        Stability::Indifferent => {
            let none = counts_as_none(first.stiffness, indifferent);
            Some(format!("along the first mode nothing drives the platform back ({none})"))
        }
    };
    (word(first.stability), reason)
}

impl Answer for ModesAnswer {
    fn is_negative(&self) -> bool {
        self.reason.is_some()
    }

    fn words(&self, width: Option<usize>) -> String {
        let mut text = format!("{}, model {}, at {}\n", self.robot, self.model, self.pose.words());
        self.warnings.iter().for_each(|warning| text.push_str(&format!("warning: {warning}\n")));
        text.push_str(self.status);
        self.reason.iter().for_each(|reason| text.push_str(&format!(": {reason}")));
        text.push_str("\n\nshares of the degrees of freedom in each mode's kinetic energy (%)\n");
        let mut heading = vec!["mode".to_owned(), "Hz".to_owned(), "damping ratio".to_owned()];
        heading.extend(self.degrees_of_freedom.iter().cloned());
        let mut table = Table::with_heading(heading);
        for (index, mode) in self.modes.iter().enumerate() {
            let numbers = [(index + 1).to_string(), cell(Some(mode.frequency), 3), cell(Some(mode.damping_ratio), 4)];
            let shares = mode.participation.iter().map(|share| cell(Some(100.0 * share), 1));
            table.row(numbers.into_iter().chain(shares).collect());
        }
        text.push_str(&table.text(width));
        if let Some(step) = self.step_max_s {
            text.push_str(&format!("\n`cdpr run` takes steps of {} s at most\n", significant(step, 1)));
        }
        text + &assumed_numbers::section("the modes rest on assumed numbers", &self.assumptions)
    }
}
