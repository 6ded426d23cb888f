//! `cdpr campaign`: poses planned, measured, identified from and planned again.

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use cdpr_model::control::CommandedPose;
use cdpr_model::measurement::{Samples, SensorSigmas};
use cdpr_model::reading::Size;
use cdpr_study::campaign::{CampaignError, Order, Repetition};
use cdpr_study::study::CampaignRecord;
use clap::Args;

use crate::answer::Output;
use crate::failure::Failure;
use crate::files::{self, OwnFolder};
use crate::interruption;
use crate::measurements::read_measured;
use crate::parts::computed;
use crate::progress::Progress;
use crate::study_file::StudyFile;
use cdpr_reports::answers::{CampaignAnswer, simulated_by};

const EXAMPLES: &str = "\
Examples:
  cdpr campaign studies/twin-campaign.toml --out campaign
  cdpr campaign study.toml --out campaign --format json
  cdpr campaign study.toml --out campaign --repeats 20";

/// File in the folder of a round with the poses to command.
const POSES: &str = "poses.csv";

/// File in the folder of a round with what was measured.
const RECORD: &str = "record.csv";

/// Plan poses, measure, identify, judge, and plan again with the better model, until accuracy or budget is met.
///
/// The table [campaign] of the study says what is free and how many poses a round has. Every round plans the poses that tell most among those of
/// the study that the controller in use reaches and that are not measured yet. With record = \"files\" the campaign writes the poses of a round
/// and waits: put the record beside them and run the command again. Rounds whose record is there are not measured again.
/// The exit code is 1 when an accuracy is asked for and not reached.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    /// Study file (TOML) with a table [campaign]; `cdpr schema study` describes it.
    #[arg(value_name = "STUDY")]
    study: PathBuf,

    /// Folder with one folder a round, result.json and report.html; a campaign that is there goes on.
    #[arg(long, value_name = "DIR")]
    out: PathBuf,

    /// Seed of random poses, exchanges and noise.
    #[arg(long, value_name = "SEED", default_value_t = 0)]
    seed: u64,

    /// Run the campaign on the study's machine with so many other seeds besides: tells how much of its outcome is luck.
    #[arg(long, value_name = "N", default_value_t = 0)]
    repeats: u16,
}

pub(crate) fn run(arguments: Arguments, output: &mut Output) -> Result<ExitCode, Failure> {
    let study = StudyFile::read(&arguments.study)?;
    study.introduce(output);
    let table = study.study.campaign.as_ref().ok_or_else(|| study.refused(&CampaignError::NoTable))?;
    let is_virtual = table.record == CampaignRecord::Virtual;
    // tension tests tell nothing of rigid cables
    let poses = match study.control.needs_tensions() {
        true => study.commands(arguments.seed)?,
        false => study.poses(arguments.seed)?,
    };
    let repeats = arguments.repetitions(&study, &poses, is_virtual)?;
    let _own = OwnFolder::make(&arguments.out)?;
    check_same_study(&arguments)?;
    let progress = Progress::spinner("planning round 1");
    let mut record = |order: &Order<'_>| -> Result<Option<Samples>, Refusal> {
        let (round, rounds, count) = (order.round, table.rounds, order.poses.len());
        progress.at(&format!("round {round} of {rounds} at most: recording {count} poses"));
        let before = order.round - 1;
        interruption::keeps(format!(
            "the records of {before} {} are kept in {}; the same command goes on",
            if before == 1 { "round" } else { "rounds" },
            arguments.out.display()
        ));
        let folder = arguments.out.join(format!("round-{}", order.round));
        let calibrated = order.experiment.control.robot().to_toml();
        let files_of_round = RoundFolder { folder: &folder, seed: arguments.seed.wrapping_add(order.round as u64) };
        files_of_round.write_order(order, &calibrated)?;
        let samples = files_of_round.samples(&study, order, is_virtual, output)?;
        progress.at(&format!("round {round} of {rounds} at most: identifying from {count} new poses, and planning"));
        Ok(samples)
    };
    let campaign = study.campaign(&poses, arguments.seed, &mut record).map_err(|refusal| match refusal {
        Refusal::Campaign(error) => study.refused(&error),
        Refusal::File(failure) => failure,
    })?;
    drop(progress);
    let calibrated = campaign.model.robot().to_toml();
    let folder = arguments.out.display().to_string();
    let answer = CampaignAnswer::new(&study, campaign, poses.len(), &folder, arguments.seed).repeated(repeats);
    let page = answer.page(&crate::session::command_line(), env!("CARGO_PKG_VERSION"));
    let page = page.map_err(|error| Failure::unwritable("the page of the campaign", &error))?;
    let result = output.file(&answer, "result.json")?;
    let at = |name: &str| arguments.out.join(name);
    files::write_all(&[
        (&at("calibrated.toml"), calibrated.as_bytes()),
        (&at("report.html"), page.as_bytes()),
        (&at("result.json"), result.as_bytes()),
    ])?;
    output.answer(&answer)
}

impl Arguments {
    /// The campaign with other seeds, as often as is asked for.
    fn repetitions(
        &self,
        study: &StudyFile,
        poses: &[CommandedPose],
        is_virtual: bool,
    ) -> Result<Vec<Repetition>, Failure> {
        if self.repeats == 0 {
            return Ok(Vec::new());
        }
        if !is_virtual {
            let message = "--repeats: the records of this campaign come from files, and there is one of each round";
            return Err(Failure::input(
                "campaign::repeats",
                message,
                "leave --repeats out, or let the study's machine record",
            ));
        }
        let _progress = Progress::spinner("repeating the campaign");
        Ok(study.repeated_campaigns(poses, self.seed, usize::from(self.repeats), &computed))
    }
}

/// Refuses a folder with the rounds of another study, whose records would be taken for this one's.
fn check_same_study(arguments: &Arguments) -> Result<(), Failure> {
    let (own, copy) = (files::read(&arguments.study, Size::Text)?, arguments.out.join("study.toml"));
    match files::read_if_there(&copy, Size::Text)? {
        Some(before) if before != own => {
            let message = format!(
                "{}: has the rounds of another study, or of this one before it was changed (study.toml in it differs)",
                arguments.out.display()
            );
            Err(Failure::input(
                "campaign::other-study",
                message,
                "choose another folder for --out, or take the study back",
            ))
        }
        Some(_) => Ok(()),
        None => files::write(&copy, &own),
    }
}

/// Mistake of the study, or of a file.
enum Refusal {
    Campaign(CampaignError),
    File(Failure),
}

impl From<CampaignError> for Refusal {
    fn from(error: CampaignError) -> Self {
        Self::Campaign(error)
    }
}

impl From<Failure> for Refusal {
    fn from(failure: Failure) -> Self {
        Self::File(failure)
    }
}

/// Files of a round.
struct RoundFolder<'a> {
    folder: &'a Path,
    seed: u64,
}

impl RoundFolder<'_> {
    /// Writes the poses to command, with the lengths that the controller's model expects, and the controller.
    fn write_order(&self, order: &Order<'_>, controller: &str) -> Result<(), Failure> {
        files::make_folder(self.folder)?;
        let table = Samples { sigmas: SensorSigmas::default(), ..order.expected.clone() };
        let poses = table.to_csv(order.experiment.control.robot());
        files::write_all(&[
            (&self.folder.join(POSES), poses.as_bytes()),
            (&self.folder.join("controller.toml"), controller.as_bytes()),
        ])
    }

    /// The record of a round: that of its file, or of the study's machine; `None` if a file is waited for.
    fn samples(
        &self,
        study: &StudyFile,
        order: &Order<'_>,
        is_virtual: bool,
        output: &Output,
    ) -> Result<Option<Samples>, Refusal> {
        let path = self.folder.join(RECORD);
        if files::is_there(&path) {
            return Ok(Some(read_measured(&path, &order.experiment.control, output)?));
        }
        if !is_virtual {
            return Ok(None);
        }
        let made = order.experiment.record(order.poses, self.seed).map_err(CampaignError::from)?.samples;
        let sidecar = study.sidecar(simulated_by(), self.seed).to_toml();
        let table = made.to_csv(study.machine.robot());
        files::write_all(&[(&path.with_extension("meta.toml"), sidecar.as_bytes()), (&path, table.as_bytes())])?;
        // what a later run reads
        Ok(Some(read_measured(&path, &order.experiment.control, output)?))
    }
}
