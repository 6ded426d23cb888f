//! Initial tensions that suit the poses of a study, and the way to them.

use cdpr_model::control::initial_tension::{Approach, Fit, Optimum};
use cdpr_study::Experiment;
use serde::Serialize;
use serde_json::{Value, json};

use super::Answer;
use crate::number_format::cell;
use crate::table::Table;

/// Winches in one state with its consequences.
pub struct WinchState {
    /// Winch offsets (m).
    pub offsets: Vec<f64>,
    /// Tensions at the poses.
    pub fit: Fit,
    /// Reachable area (m²) or volume (m³).
    pub reached: f64,
}

/// Initial tensions for poses, and the way to them.
#[derive(Serialize)]
pub struct InitialTensionAnswer {
    status: &'static str,
    reason: Option<String>,
    poses: usize,
    #[serde(rename = "initial_tensions_N")]
    initial_tensions: Vec<f64>,
    winch_offsets_m: Vec<f64>,
    /// Cables from 1 whose initial tension stands at a limit.
    at_limits: Vec<usize>,
    iterations: u32,
    starts: usize,
    /// Starts of the search that led to these tensions.
    starts_agreeing: usize,
    /// Poses from 1 that have no target and do not count in the distances from it.
    poses_without_target: Vec<usize>,
    /// Why the first of those has none.
    #[serde(skip_serializing_if = "Option::is_none")]
    no_target: Option<String>,
    before: Value,
    after: Value,
    approach: Value,
    #[serde(skip)]
    states: [WinchState; 2],
    #[serde(skip)]
    way: Approach,
    #[serde(skip)]
    names: Vec<String>,
    #[serde(skip)]
    unit: &'static str,
}

impl InitialTensionAnswer {
    /// States before and after, the best tensions and the way to them, for so many poses.
    pub fn new(experiment: &Experiment, states: [WinchState; 2], best: Optimum, way: Approach, poses: usize) -> Self {
        let names: Vec<String> = experiment.machine.robot().cables.iter().map(|cable| cable.name.clone()).collect();
        let is_planar = experiment.machine.axes().len() == 2;
        let size = if is_planar { "reachable_area_m2" } else { "reachable_volume_m3" };
        let state = |state: &WinchState| {
            let Fit { rms, largest, poses, outside, without_rest, .. } = &state.fit;
            let rms = rms.is_finite().then_some(rms);
            json!({ "winch_offsets_m": state.offsets, "rms_N": rms, "largest_N": largest, "poses": poses,
                    "poses_outside_limits": outside, "poses_without_rest": from_one(without_rest), size: state.reached })
        };
        let stage = |stage: &cdpr_model::control::initial_tension::Stage| {
            let moves = stage.moves.iter();
            let moves =
                moves.map(|each| json!({ "cable": each.cable + 1, "by_m": each.by, "tensions_N": each.tensions }));
            json!({ "winch_offsets_m": stage.offsets, "tensions_N": stage.tensions, "moves": moves.collect::<Vec<_>>() })
        };
        let [least, most] = way.tensions;
        let [former, latter] = [&states[0].fit, &states[1].fit];
        let reason = shortcoming(latter, poses, &names);
        let status = match reason {
            Some(_) if !latter.without_rest.is_empty() => "without-rest",
            Some(_) => "outside-limits",
            None if gains_nothing(former, latter) => "nothing-to-gain",
            None => "found",
        };
        Self {
            status,
            reason,
            poses,
            initial_tensions: best.tensions,
            winch_offsets_m: best.offsets,
            at_limits: best.at_limits.iter().map(|cable| cable + 1).collect(),
            iterations: best.iterations,
            starts: best.starts,
            starts_agreeing: best.agreeing,
            poses_without_target: from_one(&latter.without_target),
            no_target: latter.no_target.as_ref().map(ToString::to_string),
            before: state(&states[0]),
            after: state(&states[1]),
            approach: json!({
                "order": way.order.iter().map(|cable| cable + 1).collect::<Vec<_>>(),
                "stages": way.stages.iter().map(stage).collect::<Vec<_>>(),
                "tension_min_N": least, "tension_max_N": most,
                "largest_displacement_m": way.largest_displacement,
                "unanswered_moves": way.unanswered,
            }),
            states,
            way,
            names,
            unit: if is_planar { "m²" } else { "m³" },
        }
    }

    /// A row per stage and a column per cable.
    fn stages(
        &self,
        width: Option<usize>,
        number: impl Fn(&cdpr_model::control::initial_tension::Stage, usize) -> String,
    ) -> String {
        let heading = std::iter::once("stage".to_owned()).chain(self.names.iter().map(|name| format!("cable {name}")));
        let mut table = Table::with_heading(heading.collect());
        for (index, stage) in self.way.stages.iter().enumerate() {
            let cells = (0..self.names.len()).map(|cable| number(stage, cable));
            table.row(std::iter::once(index.to_string()).chain(cells).collect());
        }
        table.text(width)
    }
}

/// A study's own winches follow the target as well as the best ones when nothing but this share of the distance is gained.
const NOTHING: f64 = 1e-3;

/// True where the winches stay as the study sets them.
fn gains_nothing(before: &Fit, after: &Fit) -> bool {
    // of less than a newton nothing is left to gain
    before.poses >= after.poses
        && before.outside <= after.outside
        && before.rms - after.rms <= NOTHING * before.rms.max(1.0)
}

/// Numbers of poses as people count them.
fn from_one(poses: &[usize]) -> Vec<usize> {
    poses.iter().map(|pose| pose + 1).collect()
}

/// Why no initial tensions do everywhere.
fn shortcoming(fit: &Fit, poses: usize, names: &[String]) -> Option<String> {
    if let Some(first) = fit.without_rest.first() {
        let count = fit.without_rest.len();
        return Some(format!(
            "at {count} of {poses} poses the machine comes to no rest with the initial tensions that follow the target best, first at pose {}: \
             they do not count below, and `cdpr accuracy` tells why",
            first + 1
        ));
    }
    fit.worst.map(|worst| {
        let (outside, pose, name) = (fit.outside, worst.pose + 1, &names[worst.cable]);
        format!(
            "no initial tensions follow the target within the limits everywhere: at {outside} of {poses} poses a tension breaks \
             them, worst at pose {pose}, cable {name} with {:.0} N",
            worst.tension
        )
    })
}

impl Answer for InitialTensionAnswer {
    fn is_negative(&self) -> bool {
        self.reason.is_some()
    }

    fn words(&self, width: Option<usize>) -> String {
        let mut text = String::new();
        if let Some(reason) = &self.reason {
            text.push_str(&format!("{reason}\n\n"));
        }
        if let (Some(why), count) = (&self.no_target, self.poses_without_target.len()) {
            text.push_str(&format!(
                "{count} of {} poses have no target and do not count in the distances below, first pose {}: {why}\n\n",
                self.poses, self.poses_without_target[0]
            ));
        }
        if self.status == "nothing-to-gain" {
            let [before, best] = [&self.states[0], &self.states[1]].map(|state| state.fit.rms);
            text.push_str(&format!(
                "nothing to gain: the winches as the study sets them follow the target as well as any initial tensions within the limits, \
                 {before:.1} N off in the root mean square against {best:.1} N\n"
            ));
            return text;
        }
        let heading = format!("over {} poses", self.poses);
        let mut table = Table::new([heading.as_str(), "as the study sets them", "best"]);
        let mut row = |name: &str, of: &dyn Fn(&WinchState) -> String| {
            table.row(vec![name.to_owned(), of(&self.states[0]), of(&self.states[1])]);
        };
        row("distance from the target, rms (N)", &|state| cell(Some(state.fit.rms), 1));
        row("distance from the target, largest (N)", &|state| cell(Some(state.fit.largest), 1));
        row("poses with tensions outside the limits", &|state| state.fit.outside.to_string());
        row(&format!("reachable workspace ({})", self.unit), &|state| cell(Some(state.reached), 3));
        text.push_str(&table.text(width));
        text.push_str(&self.search());
        let mut table = Table::new(["cable", "f_ini (N)", "winch offset (mm)", "before (mm)"]);
        for (cable, name) in self.names.iter().enumerate() {
            let at_limit = if self.at_limits.contains(&(cable + 1)) { " at a limit" } else { "" };
            table.row(vec![
                name.clone(),
                format!("{:.1}{at_limit}", self.initial_tensions[cable]),
                cell(Some(1e3 * self.winch_offsets_m[cable]), 3),
                cell(Some(1e3 * self.states[0].offsets[cable]), 3),
            ]);
        }
        text.push_str(&format!("\n{}", table.text(width)));
        text.push_str(&format!(
            "\nTo get there: command the initial pose, stage 0 first; in each stage turn the winches {}, one by one.\n",
            self.order()
        ));
        text.push_str(&format!(
            "\nwinch offsets (mm; below zero: wound in)\n{}",
            self.stages(width, |stage, cable| cell(Some(1e3 * stage.offsets[cable]), 3))
        ));
        text.push_str(&format!(
            "\nwhat the force sensors read after each stage (N)\n{}",
            self.stages(width, |stage, cable| cell(Some(stage.tensions[cable]), 0))
        ));
        let [least, most] = self.way.tensions;
        text.push_str(&format!(
            "\nmeanwhile tensions lie between {least:.0} N and {most:.0} N, and the platform moves by {:.2} mm at most\n",
            1e3 * self.way.largest_displacement
        ));
        if self.way.unanswered > 0 {
            text.push_str(&format!(
                "after {} of the moves the machine comes to no rest: take more stages\n",
                self.way.unanswered
            ));
        }
        let tensions: Vec<String> = self.initial_tensions.iter().map(|tension| format!("{tension:.1}")).collect();
        text.push_str(&format!("\nin the study: [initial] tensions_N = [{}]\n", tensions.join(", ")));
        text
    }
}

impl InitialTensionAnswer {
    /// How the best was found, and what is odd about it.
    fn search(&self) -> String {
        let [before, after] = [&self.states[0].fit, &self.states[1].fit];
        let mut text = match self.starts_agreeing == self.starts {
            true => String::new(),
            false => format!(
                "\n{} of {} starts of the search led to the best, the others to worse\n",
                self.starts_agreeing, self.starts
            ),
        };
        if before.poses >= after.poses && before.rms < after.rms {
            text.push_str("\nthe winches as the study sets them follow the target better: their initial tensions break the limits\n");
        }
        text
    }

    /// The cables in the order in which winches turn.
    fn order(&self) -> String {
        let names: Vec<&str> = self.way.order.iter().map(|&cable| self.names[cable].as_str()).collect();
        names.join(", ")
    }
}
