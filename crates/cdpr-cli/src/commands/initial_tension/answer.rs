//! What `cdpr initial-tension` answers.

use cdpr::metamodel::initial_tension::{Approach, Fit, Optimum};
use serde::Serialize;
use serde_json::{Value, json};

use crate::answer::Answer;
use crate::laboratory::Laboratory;
use crate::table::{Table, cell};

/// The winches in one state, and what it leads to.
pub(super) struct State {
    pub(super) offsets: Vec<f64>,
    pub(super) fit: Fit,
    /// Reachable area (m²) or volume (m³).
    pub(super) reached: f64,
}

#[derive(Serialize)]
pub(super) struct InitialTensionAnswer {
    status: &'static str,
    reason: Option<String>,
    poses: usize,
    #[serde(rename = "initial_tensions_N")]
    initial_tensions: Vec<f64>,
    winch_offsets_m: Vec<f64>,
    /// Cables from 1 whose initial tension stands at a limit.
    at_limits: Vec<usize>,
    iterations: u32,
    before: Value,
    after: Value,
    approach: Value,
    #[serde(skip)]
    states: [State; 2],
    #[serde(skip)]
    way: Approach,
    #[serde(skip)]
    names: Vec<String>,
    #[serde(skip)]
    unit: &'static str,
}

impl InitialTensionAnswer {
    pub(super) fn new(laboratory: &Laboratory, states: [State; 2], best: Optimum, way: Approach, poses: usize) -> Self {
        let names: Vec<String> = laboratory.machine.robot().cables.iter().map(|cable| cable.name.clone()).collect();
        let is_planar = laboratory.machine.axes().len() == 2;
        let size = if is_planar { "reachable_area_m2" } else { "reachable_volume_m3" };
        let state = |state: &State| {
            let Fit { rms, largest, poses, outside, .. } = &state.fit;
            let rms = rms.is_finite().then_some(rms);
            json!({ "winch_offsets_m": state.offsets, "rms_N": rms, "largest_N": largest, "poses": poses,
                    "poses_outside_limits": outside, size: state.reached })
        };
        let stage = |stage: &cdpr::metamodel::initial_tension::Stage| {
            let moves = stage.moves.iter();
            let moves =
                moves.map(|each| json!({ "cable": each.cable + 1, "by_m": each.by, "tensions_N": each.tensions }));
            json!({ "winch_offsets_m": stage.offsets, "tensions_N": stage.tensions, "moves": moves.collect::<Vec<_>>() })
        };
        let [least, most] = way.tensions;
        let reason = states[1].fit.worst.map(|worst| {
            let (outside, pose, name) = (states[1].fit.outside, worst.pose + 1, &names[worst.cable]);
            format!(
                "no initial tensions follow the target within the limits everywhere: at {outside} of {poses} poses a tension breaks \
                 them, worst at pose {pose}, cable {name} with {:.0} N",
                worst.tension
            )
        });
        Self {
            status: if reason.is_none() { "found" } else { "outside-limits" },
            reason,
            poses,
            initial_tensions: best.tensions,
            winch_offsets_m: best.offsets,
            at_limits: best.at_limits.iter().map(|cable| cable + 1).collect(),
            iterations: best.iterations,
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
    fn stages(&self, number: impl Fn(&cdpr::metamodel::initial_tension::Stage, usize) -> String) -> String {
        let heading = std::iter::once("stage".to_owned()).chain(self.names.iter().map(|name| format!("cable {name}")));
        let mut table = Table::with_heading(heading.collect());
        for (index, stage) in self.way.stages.iter().enumerate() {
            let cells = (0..self.names.len()).map(|cable| number(stage, cable));
            table.row(std::iter::once(index.to_string()).chain(cells).collect());
        }
        table.text()
    }
}

impl Answer for InitialTensionAnswer {
    fn is_negative(&self) -> bool {
        self.reason.is_some()
    }

    fn words(&self) -> String {
        let mut text = String::new();
        if let Some(reason) = &self.reason {
            text.push_str(&format!("{reason}\n\n"));
        }
        let heading = format!("over {} poses", self.poses);
        let mut table = Table::new([heading.as_str(), "as the study sets them", "best"]);
        let mut row = |name: &str, of: &dyn Fn(&State) -> String| {
            table.row(vec![name.to_owned(), of(&self.states[0]), of(&self.states[1])]);
        };
        row("distance from the target, rms (N)", &|state| cell(Some(state.fit.rms), 1));
        row("distance from the target, largest (N)", &|state| cell(Some(state.fit.largest), 1));
        row("poses with tensions outside the limits", &|state| state.fit.outside.to_string());
        row(&format!("reachable workspace ({})", self.unit), &|state| cell(Some(state.reached), 3));
        text.push_str(&table.text());
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
        text.push_str(&format!("\n{}", table.text()));
        text.push_str(&format!(
            "\nTo get there: command the initial pose, stage 0 first; in each stage turn the winches {}, one by one.\n",
            self.order()
        ));
        text.push_str(&format!(
            "\nwinch offsets (mm; below zero: wound in)\n{}",
            self.stages(|stage, cable| cell(Some(1e3 * stage.offsets[cable]), 3))
        ));
        text.push_str(&format!(
            "\nwhat the force sensors read after each stage (N)\n{}",
            self.stages(|stage, cable| cell(Some(stage.tensions[cable]), 0))
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
    /// The cables in the order in which winches turn.
    fn order(&self) -> String {
        let names: Vec<&str> = self.way.order.iter().map(|&cable| self.names[cable].as_str()).collect();
        names.join(", ")
    }
}
