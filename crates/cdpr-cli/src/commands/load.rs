//! `cdpr load`: what the cables' tensions say about the load.

use std::process::ExitCode;
use std::str::FromStr;

use cdpr::geometry::Pose;
use cdpr::model::Model;
use cdpr::statics::{StaticsError, TensionSplit, balanced_wrench, section_wrench, split};
use clap::Args;
use serde::Serialize;

use crate::answer::{Answer, Output};
use crate::failure::Failure;
use crate::inputs::{ModelArguments, pose_of};
use crate::numbers::NumberList;
use crate::statics_failure::{has_no_path, refused};
use crate::table::{Table, cell};
use cdpr_reports::answers::PoseAnswer;
use cdpr_reports::answers::WrenchAnswer;

const EXAMPLES: &str = "\
Examples:
  cdpr load planar-example --pose 0,5.2 --tensions 5808,5909,2390,2421
  cdpr load cablerobot-simulator-helicopter-kinematic-calibrated --pose 0,0,1.5,0,0,0 \\
    --tensions 3678,2169,4250,1708,3985,2394,4715,1684 --group upper=1,3,5,7 --group lower=2,4,6,8
  cdpr load calibrated.toml --pose 0,0,1.5,0,0,0 --recorded --tensions 3710,2190,4260,1700,3990,2400,4720,1690";

/// Load estimation: the external wrench that cable tensions balance, and the tensions' internal and external part.
///
/// The wrench is constant in world axes, its moment about the platform origin: the weight is part of it. The external part
/// of the tensions carries that wrench, the internal part only tightens the cables against each other (eq. 2.40); both add
/// up to the tensions.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    #[command(flatten)]
    model: ModelArguments,

    /// Platform pose (m, rad), components as in `cdpr ik --pose`.
    #[arg(long, value_name = "POSE", allow_hyphen_values = true)]
    pose: NumberList,

    /// Cable tensions, one per cable (N), pull positive.
    #[arg(long, value_name = "TENSIONS", allow_hyphen_values = true)]
    tensions: NumberList,

    /// The tensions are as the robot records them: remove the file's tension_scale and tension_offset_N first.
    #[arg(long)]
    recorded: bool,

    /// Also the wrench that a group of cables exerts on the platform: a name and cable numbers; may be repeated.
    #[arg(long = "group", value_name = "NAME=1,3,…")]
    groups: Vec<Group>,
}

/// A named group of cables, `upper=1,3,5,7`.
#[derive(Clone, Debug)]
struct Group {
    name: String,
    /// Numbers from 1.
    cables: Vec<usize>,
}

impl FromStr for Group {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let form = "a name, `=` and cable numbers expected, e.g. upper=1,3,5,7";
        let (name, numbers) = text.split_once('=').ok_or(form)?;
        if name.trim().is_empty() || numbers.trim().is_empty() {
            return Err(form.to_owned());
        }
        let number = |word: &str| match word.trim().parse::<usize>() {
            Ok(number) if number > 0 => Ok(number),
            _ => Err(format!("`{}` is not a cable number; cables are counted from 1", word.trim())),
        };
        Ok(Self { name: name.trim().to_owned(), cables: numbers.split(',').map(number).collect::<Result<_, _>>()? })
    }
}

#[derive(Serialize)]
struct LoadEstimate {
    robot: String,
    model: String,
    status: &'static str,
    reason: Option<String>,
    pose: PoseAnswer,
    #[serde(rename = "tensions_N")]
    tensions: Vec<f64>,
    #[serde(flatten)]
    statics: Statics,
    #[serde(skip)]
    cable_names: Vec<String>,
}

/// Null where a cable has no unique course.
#[derive(Default, Serialize)]
struct Statics {
    #[serde(flatten)]
    wrench: WrenchAnswer,
    #[serde(rename = "internal_N")]
    internal: Option<Vec<f64>>,
    #[serde(rename = "external_N")]
    external: Option<Vec<f64>>,
    rank: Option<usize>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    sections: Vec<Section>,
}

#[derive(Serialize)]
struct Section {
    name: String,
    cables: Vec<usize>,
    #[serde(flatten)]
    wrench: WrenchAnswer,
}

pub(crate) fn run(arguments: Arguments, output: &mut Output) -> Result<ExitCode, Failure> {
    let model = arguments.model.read()?;
    let robot = model.robot();
    let pose = pose_of(robot, "--pose", &arguments.pose)?;
    let mut tensions = arguments.tensions.0;
    if arguments.recorded {
        tensions.iter_mut().enumerate().take(model.cable_count()).for_each(|(cable, tension)| {
            *tension = model.real_tension(cable, *tension);
        });
    }
    let found = statics(&model, &pose, &tensions, &arguments.groups);
    let reason = found.as_ref().err().filter(|error| has_no_path(error)).map(ToString::to_string);
    let statics = match found {
        Err(_) if reason.is_some() => Statics::default(),
        found => found.map_err(|error| refused("--tensions", &error))?,
    };
    if !statics.is_finite() {
        return Err(Failure::numerical("the wrench of these tensions overflows; check their unit (N)"));
    }
    output.answer(&LoadEstimate {
        robot: robot.name.clone(),
        model: model.composition().to_string(),
        status: if reason.is_none() { "solved" } else { "singular" },
        reason,
        pose: PoseAnswer::new(robot, &pose),
        tensions,
        statics,
        cable_names: robot.cables.iter().map(|cable| cable.name.clone()).collect(),
    })
}

fn statics(model: &Model, pose: &Pose, tensions: &[f64], groups: &[Group]) -> Result<Statics, StaticsError> {
    let wrench = balanced_wrench(model, pose, tensions)?;
    let TensionSplit { internal, external, rank } = split(model, pose, tensions)?;
    let section = |group: &Group| {
        let cables: Vec<usize> = group.cables.iter().map(|number| number - 1).collect();
        let wrench = WrenchAnswer::new(model.robot(), &section_wrench(model, pose, tensions, &cables)?);
        Ok(Section { name: group.name.clone(), cables: group.cables.clone(), wrench })
    };
    Ok(Statics {
        wrench: WrenchAnswer::new(model.robot(), &wrench),
        internal: Some(internal),
        external: Some(external),
        rank: Some(rank),
        sections: groups.iter().map(section).collect::<Result<_, StaticsError>>()?,
    })
}

impl Statics {
    fn is_finite(&self) -> bool {
        let wrenches = std::iter::once(&self.wrench).chain(self.sections.iter().map(|section| &section.wrench));
        let mut parts = self.internal.iter().chain(&self.external).flatten();
        wrenches.into_iter().all(WrenchAnswer::is_finite) && parts.all(|number| number.is_finite())
    }
}

impl Answer for LoadEstimate {
    fn is_negative(&self) -> bool {
        self.reason.is_some()
    }

    fn words(&self) -> String {
        let mut text = format!("{}, model {}, at {}\n", self.robot, self.model, self.pose.words());
        if let Some(reason) = &self.reason {
            text.push_str(&format!("singular: {reason}\n"));
        }
        let Statics { wrench, internal: Some(internal), external: Some(external), .. } = &self.statics else {
            return text;
        };
        let mut heading = vec!["wrench on the platform".to_owned()];
        heading.extend(wrench.heading());
        let mut wrenches = Table::with_heading(heading);
        let mut row = |name: String, wrench: &WrenchAnswer| {
            wrenches.row([vec![name], wrench.cells()].concat());
        };
        row("load that the tensions balance".to_owned(), wrench);
        self.statics.sections.iter().for_each(|section| row(format!("cables of {}", section.name), &section.wrench));
        let mut parts = Table::new(["cable", "tension N", "internal N", "external N"]);
        for (cable, name) in self.cable_names.iter().enumerate() {
            let numbers = [self.tensions[cable], internal[cable], external[cable]];
            parts.row([vec![name.clone()], numbers.map(|number| cell(Some(number), 3)).to_vec()].concat());
        }
        format!("{text}\n{}\n{}", wrenches.text(), parts.text())
    }
}
