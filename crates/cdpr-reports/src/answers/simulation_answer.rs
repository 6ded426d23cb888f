//! Virtual measurements that were written.

use cdpr_model::compensation::Beyond;
use cdpr_model::control::CommandedPose;
use cdpr_study::Experiment;
use schemars::JsonSchema;
use serde::Serialize;

use super::{Answer, beyond_map, control_title};

/// Virtual measurements in short.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "Simulation")]
pub struct SimulationAnswer {
    /// Number of samples.
    samples: usize,
    /// Number of poses without an answer.
    left_out: usize,
    /// Reasons why poses were left out.
    reasons: Vec<String>,
    seed: u64,
    #[serde(skip_serializing_if = "Option::is_none")]
    control: Option<String>,
    /// Poses beyond the samples of the control model's map.
    #[serde(skip_serializing_if = "Option::is_none")]
    remark: Option<String>,
    winch_offsets_m: Vec<f64>,
    /// File of the measurements.
    out: String,
    /// File that says what is known about the measurements.
    sidecar: String,
}

impl SimulationAnswer {
    /// Samples of an experiment's commands and those that gave none with their reasons, written to a file with its sidecar.
    pub fn new(
        experiment: &Experiment,
        commands: &[CommandedPose],
        left_out: &[(usize, String)],
        seed: u64,
        [out, sidecar]: [String; 2],
    ) -> Self {
        Self {
            samples: commands.len() - left_out.len(),
            left_out: left_out.len(),
            reasons: left_out.iter().map(|(pose, reason)| format!("pose {}: {reason}", pose + 1)).collect(),
            seed,
            control: experiment.compensation.is_some().then(|| control_title(experiment)),
            remark: experiment.compensation.as_ref().and_then(|map| {
                let beyond = Beyond::of(commands.iter().map(|command| map.at(&command.pose).fraction));
                let words = beyond_map(beyond, &format!("{} poses", commands.len()));
                (!words.is_empty()).then(|| words.join("; "))
            }),
            winch_offsets_m: experiment.offsets.clone(),
            out,
            sidecar,
        }
    }
}

impl Answer for SimulationAnswer {
    fn words(&self, _width: Option<usize>) -> String {
        let mut text =
            format!("{} samples written to {}, sensor accuracies to {}\n", self.samples, self.out, self.sidecar);
        if let Some(control) = &self.control {
            let remark = self.remark.as_ref().map_or_else(String::new, |remark| format!("; {remark}"));
            text.push_str(&format!("driven by {control}{remark}\n"));
        }
        if self.left_out > 0 {
            text.push_str(&format!("{} commands gave no sample:\n", self.left_out));
            self.reasons.iter().take(10).for_each(|reason| text.push_str(&format!("  {reason}\n")));
        }
        text
    }
}
