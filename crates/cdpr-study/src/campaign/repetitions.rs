//! Campaigns repeated with other seeds: how much of an outcome is luck of the noise and of the exchanges.

use serde::{Deserialize, Serialize};

use super::{Campaign, CampaignError};
use crate::Experiment;
use crate::parts::{Parts, nullable};
use cdpr_model::control::CommandedPose;
use cdpr_model::measurement::Samples;
use cdpr_model::reading::Keyword;

/// Distance between the seeds of repetitions: rounds of one campaign take seeds that follow its own.
const NEXT_SEED: u64 = 1000;

/// A campaign with another seed, in short: a part of the repetitions.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Repetition {
    /// Seed of the exchanges and of the noise.
    pub seed: u64,
    /// Word for the end of the campaign; `failed` where it could not be run.
    pub status: String,
    /// Reason for which it could not be run.
    pub reason: Option<String>,
    /// Rounds, in order.
    pub rounds: Vec<RepeatedRound>,
}

/// A round of a repetition.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct RepeatedRound {
    /// Samples measured so far.
    pub poses: usize,
    /// Mean position error on held-out samples (m); `None` if there are too few samples to hold some out.
    pub validation_position_mean_m: Option<f64>,
    /// Mean position error of the driven machine (m).
    pub driven_position_mean_m: Option<f64>,
    /// Fraction of the study's poses that the identified controller reaches.
    #[serde(with = "nullable")]
    pub reach_share: f64,
}

impl Experiment {
    /// Runs the study's `[campaign]` on its virtual machine with as many other seeds, after `seed`.
    pub fn repeated_campaigns(
        &self,
        poses: &[CommandedPose],
        seed: u64,
        count: usize,
        parts: &Parts<'_, Repetition>,
    ) -> Vec<Repetition> {
        parts(count, &|part| {
            let own = seed.wrapping_add(NEXT_SEED * (part as u64 + 1));
            match self.virtual_campaign(poses, own) {
                Ok(campaign) => Repetition::of(own, &campaign),
                Err(error) => {
                    let (status, reason) = ("failed".to_owned(), Some(error.to_string()));
                    Repetition { seed: own, status, reason, rounds: Vec::new() }
                }
            }
        })
    }

    /// A campaign whose records are those of the study's machine.
    fn virtual_campaign(&self, poses: &[CommandedPose], seed: u64) -> Result<Campaign, CampaignError> {
        self.campaign(poses, seed, &mut |order| -> Result<Option<Samples>, CampaignError> {
            let record = order.experiment.record(order.poses, seed.wrapping_add(order.round as u64))?;
            Ok(Some(record.samples))
        })
    }
}

impl Repetition {
    fn of(seed: u64, campaign: &Campaign) -> Self {
        let rounds = campaign.rounds.iter().map(|round| RepeatedRound {
            poses: round.poses,
            validation_position_mean_m: round.validation.map(|errors| errors.position_error_m.mean),
            driven_position_mean_m: round.driven.as_ref().map(|driven| driven.position_error_m.mean),
            reach_share: round.reach_share,
        });
        Self { seed, status: campaign.status.name().to_owned(), reason: None, rounds: rounds.collect() }
    }
}
