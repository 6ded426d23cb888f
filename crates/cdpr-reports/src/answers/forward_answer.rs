//! The pose behind lengths or tensions, whichever forward problem gave it.

use cdpr_model::equilibrium::{ForwardProblem, Solution, Start, Status, forward_kinematics, forward_statics};
use cdpr_model::geometry::Pose;
use cdpr_model::model::Model;
use cdpr_model::statics::Stability;
use cdpr_model::tension::Intervals;
use schemars::JsonSchema;
use serde::Serialize;

use super::stiffness_answer::word;
use super::{Answer, PoseAnswer};
use crate::keys::Word;
use crate::number_format::cell;
use crate::table::Table;

/// Empty if the caller gave a guess.
fn start_words(start: Start) -> &'static str {
    match start {
        Start::Guess => "",
        Start::HomePose => "sought from the home pose, since no --guess is given\n",
        Start::MiddleOfAnchors => {
            "sought from the middle of the frame anchors, since no --guess is given and the file has no home pose\n"
        }
    }
}

/// Stability of an equilibrium in a word; `None` if there is none.
fn stability(status: Status) -> Option<&'static str> {
    match status {
        Status::Converged => Some(word(Stability::Stable)),
        Status::Singular => Some(word(Stability::Indifferent)),
        Status::Unstable => Some(word(Stability::Unstable)),
        _ => None,
    }
}

/// A pose elsewhere that fits the lengths better.
#[derive(Debug, Serialize, JsonSchema)]
#[schemars(rename = "AlternativePose")]
struct AlternativeAnswer {
    pose: PoseAnswer,
    /// Root mean square of the length residuals there (m).
    residual_rms_m: f64,
}

/// A pose behind lengths or tensions.
#[derive(Debug, Serialize, JsonSchema)]
#[expect(non_snake_case, reason = "the fields are the keys of the contract, units included")]
#[schemars(rename = "ForwardKinematics")]
pub struct ForwardAnswer {
    robot: String,
    model: String,
    #[serde(with = "Word")]
    status: Status,
    reason: Option<String>,
    /// Start of the search.
    #[serde(with = "Word")]
    sought_from: Start,
    pose: PoseAnswer,
    /// A better fit elsewhere than the pose that belongs to the start of the search.
    #[serde(skip_serializing_if = "Option::is_none")]
    alternative: Option<AlternativeAnswer>,
    /// Modelled minus given lengths (m).
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(with = "Option<Vec<Option<f64>>>")]
    residuals_m: Option<Vec<f64>>,
    /// Root mean square of the residuals (m).
    #[serde(skip_serializing_if = "Option::is_none")]
    residual_rms_m: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(with = "Option<Vec<Option<f64>>>")]
    tensions_N: Option<Vec<f64>>,
    /// Least and largest tension of each rigid cable where statics leaves a choice; null where nothing bounds it.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(with = "Option<Vec<[Option<f64>; 2]>>")]
    tension_intervals_N: Option<Vec<[f64; 2]>>,
    /// Size of the wrench that is out of balance, moments divided by the platform radius.
    #[serde(skip_serializing_if = "Option::is_none")]
    wrench_residual_N: Option<f64>,
    /// Smallest stiffness of the platform; null where rigid cables leave it no motion.
    #[serde(skip_serializing_if = "Option::is_none")]
    stability_N_per_m: Option<f64>,
    /// `stable`, `indifferent`, `unstable`: of an equilibrium.
    #[serde(skip_serializing_if = "Option::is_none")]
    stability: Option<&'static str>,
    /// Steps of the search.
    iterations: u32,
    /// Searches from other starts.
    restarts: u32,
    #[serde(skip)]
    cable_names: Vec<String>,
}

impl ForwardAnswer {
    fn new(model: &Model, pose: &Pose, status: Status, reason: Option<String>) -> Self {
        let robot = model.robot();
        Self {
            robot: robot.name.clone(),
            model: model.composition().to_string(),
            status,
            reason,
            sought_from: Start::Guess,
            pose: PoseAnswer::new(robot, pose),
            alternative: None,
            residuals_m: None,
            residual_rms_m: None,
            tensions_N: None,
            tension_intervals_N: None,
            wrench_residual_N: None,
            stability_N_per_m: None,
            stability: None,
            iterations: 0,
            restarts: 0,
            cable_names: robot.cables.iter().map(|cable| cable.name.clone()).collect(),
        }
    }

    /// The pose that belongs to lengths: the best fit, or pose and tensions in equilibrium.
    pub fn of_lengths(model: &Model, solution: Solution, problem: ForwardProblem) -> Self {
        let is_fit = problem == ForwardProblem::LeastSquares;
        Self {
            residuals_m: Some(solution.residuals),
            residual_rms_m: is_fit.then_some(solution.residual_rms),
            tensions_N: (!is_fit).then_some(solution.tensions),
            wrench_residual_N: (!is_fit).then_some(solution.wrench_residual),
            stability_N_per_m: (!is_fit).then_some(solution.stability),
            stability: stability(solution.status).filter(|_| !is_fit),
            iterations: solution.iterations,
            restarts: solution.restarts,
            ..Self::new(model, &solution.pose, solution.status, solution.reason)
        }
    }

    /// The pose at which given tensions balance the load.
    pub fn of_tensions(model: &Model, tensions: &[f64], solution: forward_statics::Solution) -> Self {
        Self {
            tensions_N: Some(tensions.to_vec()),
            wrench_residual_N: Some(solution.wrench_residual),
            stability_N_per_m: Some(solution.stability),
            stability: stability(solution.status),
            iterations: solution.iterations,
            restarts: solution.restarts,
            ..Self::new(model, &solution.pose, solution.status, solution.reason)
        }
    }

    /// Tells where the search started.
    pub fn sought_from(self, start: Start) -> Self {
        Self { sought_from: start, ..self }
    }

    /// Tells of a better fit elsewhere.
    pub fn with_alternative(self, model: &Model, alternative: Option<forward_kinematics::Alternative>) -> Self {
        let alternative = alternative.map(|found| AlternativeAnswer {
            pose: PoseAnswer::new(model.robot(), &found.pose),
            residual_rms_m: found.residual_rms,
        });
        Self { alternative, ..self }
    }

    /// Tells how far each tension may go while all balance the load.
    pub fn with_intervals(self, intervals: Intervals) -> Self {
        Self { tension_intervals_N: Some(intervals.ranges), ..self }
    }

    /// The better fit elsewhere in a sentence.
    fn alternative_words(&self) -> String {
        let (Some(alternative), Some(rms)) = (&self.alternative, self.residual_rms_m) else { return String::new() };
        format!(
            "the lengths fit better elsewhere, {} mm rms instead of {} mm: {}; the answer is the pose that belongs to {}: make sure \
             that the platform is there\n",
            cell(Some(1e3 * alternative.residual_rms_m), 3),
            cell(Some(1e3 * rms), 3),
            alternative.pose.words(),
            if self.sought_from == Start::Guess { "--guess" } else { "the start of the search" },
        )
    }

    /// Adds a sentence to the reason.
    pub fn remark(&mut self, text: &str) {
        self.reason = Some(self.reason.take().map_or_else(|| text.to_owned(), |reason| format!("{reason}; {text}")));
    }

    fn table(&self) -> Table {
        let ends = |end: usize| -> Option<Vec<f64>> {
            Some(self.tension_intervals_N.as_ref()?.iter().map(|range| range[end]).collect())
        };
        let (least, largest) = (ends(0), ends(1));
        let columns = [
            ("tension N", &self.tensions_N, 1.0, 3),
            ("from N", &least, 1.0, 3),
            ("to N", &largest, 1.0, 3),
            ("residual mm", &self.residuals_m, 1e3, 6),
        ];
        let columns: Vec<_> = columns
            .iter()
            .filter_map(|(name, numbers, scale, digits)| Some((*name, numbers.as_ref()?, *scale, *digits)))
            .collect();
        let mut table = Table::with_heading(
            ["cable"].into_iter().chain(columns.iter().map(|column| column.0)).map(str::to_owned).collect(),
        );
        for (cable, name) in self.cable_names.iter().enumerate() {
            let cells = columns.iter().map(|(_, numbers, scale, digits)| cell(Some(scale * numbers[cable]), *digits));
            table.row([name.clone()].into_iter().chain(cells).collect());
        }
        table
    }
}

impl Answer for ForwardAnswer {
    fn is_negative(&self) -> bool {
        self.status != Status::Converged
    }

    fn words(&self, width: Option<usize>) -> String {
        let Self { iterations, restarts, .. } = self;
        let steps = match restarts {
            0 => format!("{iterations} iterations"),
            1 => format!("{iterations} iterations with 1 restart"),
            _ => format!("{iterations} iterations with {restarts} restarts"),
        };
        let verdict = match self.status {
            Status::Converged => format!("converged after {steps}"),
            Status::Singular => "singular".to_owned(),
            Status::Unstable => "an unstable equilibrium".to_owned(),
            _ => format!("not converged after {steps}"),
        };
        let mut text = format!("{}, model {}: {verdict}\n", self.robot, self.model);
        if let Some(reason) = &self.reason {
            text.push_str(&format!("{reason}\n"));
        }
        text.push_str(&self.alternative_words());
        text.push_str(start_words(self.sought_from));
        let best = if self.is_negative() { "best pose found" } else { "pose" };
        text.push_str(&format!("{best}: {}\n\n{}", self.pose.words(), self.table().text(width)));
        if let Some(rms) = self.residual_rms_m {
            text.push_str(&format!("rms residual {} mm\n", cell(Some(1e3 * rms), 6)));
        }
        if let Some(stability) = self.stability_N_per_m.filter(|stability| stability.is_finite()) {
            let word = self.stability.map(|word| format!(" ({word})")).unwrap_or_default();
            text.push_str(&format!("smallest stiffness {stability:.4e} N/m{word}\n"));
        }
        text
    }
}
