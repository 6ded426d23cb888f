//! Load that tensions balance, and their internal and external part.

use cdpr_model::geometry::Pose;
use cdpr_model::model::Model;
use cdpr_model::statics::{StaticsError, TensionSplit, balanced_wrench, section_wrench, split};
use schemars::JsonSchema;
use serde::Serialize;

use super::{Answer, PoseAnswer, WrenchAnswer, has_no_path};
use crate::number_format::cell;
use crate::table::Table;

/// Load behind tensions.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "PlatformLoad")]
pub struct LoadAnswer {
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

/// Null where a cable has no unique path.
#[derive(Default, Serialize, JsonSchema)]
struct Statics {
    #[serde(flatten)]
    wrench: WrenchAnswer,
    /// Part of the tensions that tightens the cables against each other without a wrench (N).
    #[serde(rename = "internal_N")]
    internal: Option<Vec<f64>>,
    /// Part of the tensions that carries the load (N); entries may be negative.
    #[serde(rename = "external_N")]
    external: Option<Vec<f64>>,
    /// Rank of the structure matrix.
    rank: Option<usize>,
    /// Wrenches that groups of cables exert on the platform, where groups were asked for.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    sections: Vec<Section>,
}

/// Wrench that a group of cables exerts on the platform.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "LoadSection")]
struct Section {
    /// Name of the group.
    name: String,
    /// Its cables, from 1.
    cables: Vec<usize>,
    #[serde(flatten)]
    wrench: WrenchAnswer,
}

fn statics(
    model: &Model,
    pose: &Pose,
    tensions: &[f64],
    groups: &[(String, Vec<usize>)],
) -> Result<Statics, StaticsError> {
    let wrench = balanced_wrench(model, pose, tensions)?;
    let TensionSplit { internal, external, rank } = split(model, pose, tensions)?;
    let section = |(name, numbers): &(String, Vec<usize>)| {
        let cables: Vec<usize> = numbers.iter().map(|number| number - 1).collect();
        let wrench = WrenchAnswer::new(model.robot(), &section_wrench(model, pose, tensions, &cables)?);
        Ok(Section { name: name.clone(), cables: numbers.clone(), wrench })
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

impl LoadAnswer {
    /// The load of tensions (N) at a pose, with that of groups of cables: a name and their numbers from 1. A pose at which a cable has no
    /// unique path makes a negative answer; whatever else is wrong is an error.
    pub fn of(
        model: &Model,
        pose: &Pose,
        tensions: Vec<f64>,
        groups: &[(String, Vec<usize>)],
    ) -> Result<Self, StaticsError> {
        let found = statics(model, pose, &tensions, groups);
        let reason = found.as_ref().err().filter(|error| has_no_path(error)).map(ToString::to_string);
        let statics = if reason.is_some() { Statics::default() } else { found? };
        let robot = model.robot();
        Ok(Self {
            robot: robot.name.clone(),
            model: model.composition().to_string(),
            status: if reason.is_none() { "solved" } else { "singular" },
            reason,
            pose: PoseAnswer::new(robot, pose),
            tensions,
            statics,
            cable_names: robot.cables.iter().map(|cable| cable.name.clone()).collect(),
        })
    }

    /// True when every number is finite.
    pub fn is_finite(&self) -> bool {
        self.statics.is_finite()
    }
}

impl Answer for LoadAnswer {
    fn is_negative(&self) -> bool {
        self.reason.is_some()
    }

    fn words(&self, width: Option<usize>) -> String {
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
        format!("{text}\n{}\n{}", wrenches.text(width), parts.text(width))
    }
}
