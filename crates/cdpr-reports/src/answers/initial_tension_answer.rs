//! Initial tensions that suit the poses of a study, and the way to them.

use cdpr_model::control::initial_tension::{Approach, Fit, Move, Optimum, Stage};
use cdpr_study::Experiment;
use schemars::JsonSchema;
use serde::Serialize;

use super::{Answer, Size};
use crate::keys::adapters::keys;
use crate::keys::table_schema::ReachableSize;
use crate::keys::{Each, FromOne};
use crate::number_format::cell;
use crate::table::Table;

/// Winches in one state with its consequences.
pub struct WinchState {
    /// Winch offsets (m).
    pub offsets: Vec<f64>,
    /// Tensions at the poses.
    pub fit: Fit,
    /// Reachable area or volume.
    pub reached: Size<f64>,
}

/// Initial tensions for poses, and the way to them.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "InitialTensions")]
pub struct InitialTensionAnswer {
    status: &'static str,
    reason: Option<String>,
    /// Number of poses.
    poses: usize,
    #[serde(flatten, with = "InitialTensionKeys")]
    best: Optimum,
    /// Reason that the first pose without a target has none.
    #[serde(skip_serializing_if = "Option::is_none")]
    no_target: Option<String>,
    /// State with the winches as the study sets them.
    #[serde(with = "WinchStateKeys")]
    before: WinchState,
    /// State with the winches as found.
    #[serde(with = "WinchStateKeys")]
    after: WinchState,
    /// Way from the one state to the other.
    #[serde(with = "ApproachKeys")]
    approach: Approach,
    /// Names of the cables.
    #[serde(skip)]
    names: Vec<String>,
}

keys! {
    /// Initial tensions that follow a target best; cables and poses from 1.
    InitialTensionKeys of Optimum {
        /// Initial tensions of the cables (N).
        tensions = "initial_tensions_N",
        /// Winch offsets, added to the control model's lengths (m).
        offsets = "winch_offsets_m",
        /// Cables, from 1, with an initial tension at a limit.
        at_limits by Each<FromOne>,
        /// Steps taken from the best start.
        iterations,
        /// Number of starts of the search.
        starts,
        /// Number of starts that led to these tensions.
        agreeing = "starts_agreeing",
        /// Poses, from 1, that have no target.
        fit.without_target = "poses_without_target" by Each<FromOne>,
    }
    /// State of the winches.
    WinchStateKeys of WinchState {
        /// Largest distance of a tension from its target at a pose (N).
        fit.largest = "largest_N",
        /// Poses that count: the machine comes to rest there, and there is a target.
        fit.poses = "poses",
        /// Poses with a tension outside its limits.
        fit.outside = "poses_outside_limits",
        /// Poses, from 1, at which the machine does not come to rest.
        fit.without_rest = "poses_without_rest" by Each<FromOne>,
        reached among ReachableSize,
        /// Root mean square of the distances of the tensions from their targets (N).
        fit.rms = "rms_N",
        /// Winch offsets, added to the control model's lengths (m).
        offsets = "winch_offsets_m",
    }
    /// Way to initial tensions, stage by stage.
    ApproachKeys of Approach {
        /// Largest distance of the platform from the initial pose meanwhile (m).
        largest_displacement = "largest_displacement_m",
        /// Cables, from 1, in the order in which a stage moves them: those that pay out first, so that no tension rises earlier than necessary.
        order by Each<FromOne>,
        /// The state to be set first, then the stages in their order.
        stages by Each<StageKeys>,
        /// Largest tension of any cable while the cables move one after the other (N).
        tensions[1] = "tension_max_N",
        /// Least tension of any cable while the cables move one after the other (N).
        tensions[0] = "tension_min_N",
        /// Number of moves after which the machine does not come to rest.
        unanswered = "unanswered_moves",
    }
    /// Stage of the way.
    StageKeys of Stage {
        /// Moves of the winches that lead here, one at a time; empty at the start.
        moves by Each<MoveKeys>,
        /// Readings of the force sensors at rest (N).
        tensions = "tensions_N",
        /// Winch offsets, added to the control model's lengths (m).
        offsets = "winch_offsets_m",
    }
    /// Turn of a winch.
    MoveKeys of Move {
        /// Length that is paid out (m; negative if wound in).
        by = "by_m",
        /// Cable, from 1.
        cable by FromOne,
        /// Tensions that emerge (N); null if the machine does not come to rest.
        tensions = "tensions_N",
    }
}

impl InitialTensionAnswer {
    /// States before and after, the best tensions and the way to them, for so many poses.
    pub fn new(
        experiment: &Experiment,
        [before, after]: [WinchState; 2],
        best: Optimum,
        approach: Approach,
        poses: usize,
    ) -> Self {
        let names: Vec<String> = experiment.machine.robot().cables.iter().map(|cable| cable.name.clone()).collect();
        let reason = shortcoming(&after.fit, poses, &names);
        let status = match reason {
            Some(_) if !after.fit.without_rest.is_empty() => "without-rest",
            Some(_) => "outside-limits",
            None if gains_nothing(&before.fit, &after.fit) => "nothing-to-gain",
            None => "found",
        };
        let no_target = best.fit.no_target.as_ref().map(ToString::to_string);
        Self { status, reason, poses, best, no_target, before, after, approach, names }
    }

    /// A row per stage and a column per cable.
    fn stages(&self, width: Option<usize>, number: impl Fn(&Stage, usize) -> String) -> String {
        let heading = std::iter::once("stage".to_owned()).chain(self.names.iter().map(|name| format!("cable {name}")));
        let mut table = Table::with_heading(heading.collect());
        for (index, stage) in self.approach.stages.iter().enumerate() {
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
        if let (Some(why), [first, ..]) = (&self.no_target, self.best.fit.without_target.as_slice()) {
            text.push_str(&format!(
                "{} of {} poses have no target and do not count in the distances below, first pose {}: {why}\n\n",
                self.best.fit.without_target.len(),
                self.poses,
                first + 1
            ));
        }
        if self.status == "nothing-to-gain" {
            let [before, best] = [&self.before, &self.after].map(|state| state.fit.rms);
            text.push_str(&format!(
                "nothing to gain: the winches as the study sets them follow the target as well as any initial tensions within the limits, \
                 {before:.1} N off in the root mean square against {best:.1} N\n"
            ));
            return text;
        }
        let heading = format!("over {} poses", self.poses);
        let mut table = Table::new([heading.as_str(), "as the study sets them", "best"]);
        let mut row = |name: &str, of: &dyn Fn(&WinchState) -> String| {
            table.row(vec![name.to_owned(), of(&self.before), of(&self.after)]);
        };
        row("distance from the target, rms (N)", &|state| cell(Some(state.fit.rms), 1));
        row("distance from the target, largest (N)", &|state| cell(Some(state.fit.largest), 1));
        row("poses with tensions outside the limits", &|state| state.fit.outside.to_string());
        row(&format!("reachable workspace ({})", self.after.reached.unit()), &|state| {
            cell(Some(state.reached.value), 3)
        });
        text.push_str(&table.text(width));
        text.push_str(&self.search());
        let mut table = Table::new(["cable", "f_ini (N)", "winch offset (mm)", "before (mm)"]);
        for (cable, name) in self.names.iter().enumerate() {
            let at_limit = if self.best.at_limits.contains(&cable) { " at a limit" } else { "" };
            table.row(vec![
                name.clone(),
                format!("{:.1}{at_limit}", self.best.tensions[cable]),
                cell(Some(1e3 * self.best.offsets[cable]), 3),
                cell(Some(1e3 * self.before.offsets[cable]), 3),
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
        let [least, most] = self.approach.tensions;
        text.push_str(&format!(
            "\nmeanwhile tensions lie between {least:.0} N and {most:.0} N, and the platform moves by {:.2} mm at most\n",
            1e3 * self.approach.largest_displacement
        ));
        if self.approach.unanswered > 0 {
            text.push_str(&format!(
                "after {} of the moves the machine comes to no rest: take more stages\n",
                self.approach.unanswered
            ));
        }
        let tensions: Vec<String> = self.best.tensions.iter().map(|tension| format!("{tension:.1}")).collect();
        text.push_str(&format!("\nin the study: [initial] tensions_N = [{}]\n", tensions.join(", ")));
        text
    }
}

impl InitialTensionAnswer {
    /// How the best was found, and what is odd about it.
    fn search(&self) -> String {
        let [before, after] = [&self.before.fit, &self.after.fit];
        let mut text = match self.best.agreeing == self.best.starts {
            true => String::new(),
            false => format!(
                "\n{} of {} starts of the search led to the best, the others to worse\n",
                self.best.agreeing, self.best.starts
            ),
        };
        if before.poses >= after.poses && before.rms < after.rms {
            text.push_str("\nthe winches as the study sets them follow the target better: their initial tensions break the limits\n");
        }
        text
    }

    /// The cables in the order in which winches turn.
    fn order(&self) -> String {
        let names: Vec<&str> = self.approach.order.iter().map(|&cable| self.names[cable].as_str()).collect();
        names.join(", ")
    }
}
