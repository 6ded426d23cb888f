//! The list of all criteria: one entry each.

use super::entry::{CriterionRequest, Entry, Number, Setting};
use super::wrench_feasible::WRENCH_FEASIBLE;
use super::{
    CableInterference, CableObstacles, Criterion, Dexterity, JacobianConditioning, LengthLimits, MinimumStiffness,
    ModelValidity, NaturalFrequency, PlatformInterference, PlatformObstacles, StaticStability, WrapLimits,
    WrenchClosure, WrenchFeasible, WrenchSetFeasible,
};
use crate::WorkspaceError;
use crate::criterion::Requirement;
use crate::wrench_set::Payload;

const fn needed(name: &'static str, unit: &'static str) -> Number {
    Number { name, unit, is_required: true }
}

const fn optional(name: &'static str, unit: &'static str) -> Number {
    Number { name, unit, is_required: false }
}

const LENGTH: Number = optional("length", "m");

/// All criteria.
pub const ENTRIES: &[Entry] = &[
    Entry {
        name: WRENCH_FEASIBLE,
        summary: "tensions within their limits balance the load",
        numbers: &[],
        make: |setting, _| {
            let (load, limits) = (setting.load.clone()?, setting.limits.clone()?);
            Ok(Box::new(WrenchFeasible::new(setting.model, &load, &limits)?))
        },
    },
    Entry {
        name: "wrench-closure",
        summary: "the cables can pull against each other, so that they could balance any load",
        numbers: &[],
        make: |setting, _| Ok(Box::new(WrenchClosure::new(setting.model)?)),
    },
    Entry {
        name: "wrench-set-feasible",
        summary: "tensions within their limits balance the load and every further force and moment, or a payload from mass-min to \
                  mass-max in every acceleration up to these (moments compared at length)",
        numbers: &[
            optional("force", "N"),
            optional("moment", "N·m"),
            optional("mass-min", "kg"),
            optional("mass-max", "kg"),
            optional("acceleration", "m/s²"),
            optional("angular-acceleration", "rad/s²"),
            LENGTH,
        ],
        make: wrench_set,
    },
    Entry {
        name: "stiffness",
        summary: "the smallest eigenvalue of the stiffness is at least this, turns counted at length (elastic models)",
        numbers: &[needed("least", "N/m"), LENGTH],
        make: |setting, wanted| {
            let (load, limits) = (setting.load.clone()?, setting.limits.clone()?);
            let (least, length) = (wanted.required("least"), wanted.number("length"));
            Ok(Box::new(MinimumStiffness::new(setting.model, &load, &limits, least, length)?))
        },
    },
    Entry {
        name: "stability",
        summary: "every small displacement is driven back (elastic models)",
        numbers: &[LENGTH],
        make: |setting, wanted| {
            let (load, limits) = (setting.load.clone()?, setting.limits.clone()?);
            Ok(Box::new(StaticStability::new(setting.model, &load, &limits, wanted.number("length"))?))
        },
    },
    Entry {
        name: "natural-frequency",
        summary: "the lowest natural frequency is at least this (elastic models)",
        numbers: &[needed("least", "Hz")],
        make: |setting, wanted| {
            let (load, limits) = (setting.load.clone()?, setting.limits.clone()?);
            Ok(Box::new(NaturalFrequency::new(setting.model, &load, &limits, wanted.required("least"))?))
        },
    },
    Entry {
        name: "condition",
        summary: "the condition number of the structure matrix is at most this, moments divided by length",
        numbers: &[needed("largest", "1"), LENGTH],
        make: |setting, wanted| {
            let (largest, length) = (wanted.required("largest"), wanted.number("length"));
            Ok(Box::new(JacobianConditioning::new(setting.model, largest, length)?))
        },
    },
    Entry {
        name: "dexterity",
        summary: "the inverse of the condition number is at least this, moments divided by length",
        numbers: &[needed("least", "1"), LENGTH],
        make: |setting, wanted| {
            let (least, length) = (wanted.required("least"), wanted.number("length"));
            Ok(Box::new(Dexterity::new(setting.model, least, length)?))
        },
    },
    Entry {
        name: "cable-length",
        summary: "every cable keeps its limits of length, those of the file or these",
        numbers: &[optional("least", "m"), optional("largest", "m")],
        make: |setting, wanted| {
            let [least, largest] = ["least", "largest"].map(|number| wanted.number(number));
            Ok(Box::new(LengthLimits::new(setting.model, least, largest)?))
        },
    },
    Entry {
        name: "pulley-wrap",
        summary: "every cable keeps its limits of wrap angle, those of the file or these (models with pulleys)",
        numbers: &[optional("least", "rad"), optional("largest", "rad")],
        make: |setting, wanted| {
            let [least, largest] = ["least", "largest"].map(|number| wanted.number(number));
            Ok(Box::new(WrapLimits::new(setting.model, least, largest)?))
        },
    },
    Entry {
        name: "cable-interference",
        summary: "any two cables keep apart by their diameters and the clearance",
        numbers: &[optional("clearance", "m"), optional("diameter", "m")],
        make: |setting, wanted| {
            let (clearance, diameter) = (wanted.number("clearance").unwrap_or(0.0), wanted.number("diameter"));
            Ok(Box::new(CableInterference::new(setting.model, clearance, diameter)?))
        },
    },
    Entry {
        name: "platform-interference",
        summary: "every cable leaves the platform by this angle at least",
        numbers: &[optional("angle", "rad")],
        make: |setting, wanted| {
            Ok(Box::new(PlatformInterference::new(setting.model, wanted.number("angle").unwrap_or(0.0))?))
        },
    },
    Entry {
        name: "obstacles",
        summary: "every cable keeps away from the file's obstacles by its diameter and the clearance",
        numbers: &[optional("clearance", "m"), optional("diameter", "m")],
        make: |setting, wanted| {
            let (clearance, diameter) = (wanted.number("clearance").unwrap_or(0.0), wanted.number("diameter"));
            Ok(Box::new(CableObstacles::new(setting.model, clearance, diameter)?))
        },
    },
    Entry {
        name: "platform-obstacles",
        summary: "the platform keeps away from the file's obstacles by the clearance",
        numbers: &[optional("clearance", "m")],
        make: |setting, wanted| {
            Ok(Box::new(PlatformObstacles::new(setting.model, wanted.number("clearance").unwrap_or(0.0))?))
        },
    },
    Entry {
        name: "validity",
        summary: "every cable has a course",
        numbers: &[],
        make: |setting, _| Ok(Box::new(ModelValidity::new(setting.model))),
    },
];

/// The criterion of a payload if one of its numbers is given, else of a ball about the load.
fn wrench_set<'a>(setting: &Setting<'a>, wanted: &CriterionRequest) -> Result<Box<dyn Criterion + 'a>, WorkspaceError> {
    let (model, limits, length) = (setting.model, setting.limits.clone()?, wanted.number("length"));
    let of_ball = ["force", "moment"].map(|number| wanted.number(number));
    let [least, largest, acceleration, angular] =
        ["mass-min", "mass-max", "acceleration", "angular-acceleration"].map(|number| wanted.number(number));
    if [least, largest, acceleration, angular].iter().all(Option::is_none) {
        let radii = of_ball.map(|radius| radius.unwrap_or(0.0));
        return Ok(Box::new(WrenchSetFeasible::with_ball(model, &limits, &setting.load.clone()?, radii, length)?));
    }
    if let Some(value) = of_ball.into_iter().flatten().next() {
        return Err(WorkspaceError::Setting {
            criterion: "wrench-set-feasible",
            setting: "further force or moment",
            value,
            wanted: "beside the numbers of a payload it is left out: ask for two criteria",
        });
    }
    // one given mass stands for both limits
    let mass = least.or(largest).zip(largest.or(least)).map(|(least, largest)| [least, largest]);
    let payload = Payload::of(model.robot(), mass, acceleration.unwrap_or(0.0), angular.unwrap_or(0.0))?;
    Ok(Box::new(WrenchSetFeasible::new(model, &limits, Requirement::Payload(payload), length)?))
}
