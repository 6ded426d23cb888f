//! The `[[cable]]` tables of a robot file.

use std::collections::BTreeMap;

use nalgebra::Vector3;

use super::cable_defaults::{STIFFNESS_KEYS, tell_default};
use super::file::{CableSection, RobotFile};
use super::parameter::{ParameterKind as Kind, Range};
use super::reader::{Reader, key_name};
use super::stretch::registry::{LAWS, law_numbers};
use super::{Cable, CableStiffness, Pulley};
use crate::reading::{MAGNITUDE_LIMIT, ReadError, Step};

/// Largest number of cables: far above any robot's, and every matrix stays small.
const CABLE_LIMIT: usize = 10_000;

/// Largest number of elements of a cable: their error is negligible by then.
const FINITE_ELEMENT_LIMIT: usize = 1000;

/// Largest deviation of a direction's norm from 1 by rounding of its printed digits.
const DIRECTION_NORM_TOLERANCE: f64 = 1e-3;

/// All cables of the file, checked one by one and against each other.
pub(super) fn read_cables(reader: &Reader<'_>, file: &RobotFile) -> Result<Vec<Cable>, ReadError> {
    check_count(reader, file)?;
    let cables: Vec<Cable> = file
        .cable
        .iter()
        .enumerate()
        .map(|(index, section)| CableReader { reader, section, index }.cable())
        .map(|cable| cable.map_err(|error| tell_default(reader, error)))
        .collect::<Result<_, _>>()?;
    check_names(reader, file, &cables)?;
    let same_place = |cable: &Cable| cable.frame_anchor == cables[0].frame_anchor;
    if cables.len() > 1 && cables.iter().all(same_place) {
        let path = [Step::Key("cable"), Step::Index(1), Step::Key("frame_anchor_m")];
        let message = "all frame anchors are the same point, so the cables cannot hold a platform";
        return Err(reader.document.error_at(&path, "robot::coincident-anchors", message));
    }
    Ok(cables)
}

fn check_count(reader: &Reader<'_>, file: &RobotFile) -> Result<(), ReadError> {
    let (found, stated) = (file.cable.len(), file.cable_count);
    let error = |key, code, message: String| reader.document.error_at(&[Step::Key(key)], code, message);
    if found == 0 {
        return Err(error("cable", "robot::no-cables", "the robot has no cables".to_owned())
            .with_help("add a table [[cable]] with name, frame_anchor_m and platform_anchor_m for each cable"));
    }
    if found > CABLE_LIMIT {
        return Err(error(
            "cable",
            "robot::too-many-cables",
            format!("{found} cables; at most {CABLE_LIMIT} are read"),
        ));
    }
    match stated {
        Some(stated) if stated != found => {
            let message = format!("cable_count is {stated}, but there are {found} tables [[cable]]");
            Err(error("cable_count", "robot::cable-count", message)
                .with_help("is the file complete? correct one of them"))
        }
        _ => Ok(()),
    }
}

/// Checks that names are given and unique. A file with repository and commit as its source keeps the published names:
/// [`Robot::warnings`](super::Robot::warnings) reports repeated names there (CASPR's MACARM has one).
fn check_names(reader: &Reader<'_>, file: &RobotFile, cables: &[Cable]) -> Result<(), ReadError> {
    let is_quoted = file.source.as_ref().is_some_and(|source| source.repository.is_some() && source.commit.is_some());
    let mut seen = BTreeMap::new();
    for (index, cable) in cables.iter().enumerate() {
        let path = [Step::Key("cable"), Step::Index(index), Step::Key("name")];
        if cable.name.trim().is_empty() {
            let message = format!("cable {} has an empty name", index + 1);
            return Err(reader.document.error_at(&path, "robot::cable-name", message));
        }
        if let Some(first) = seen.insert(cable.name.as_str(), index + 1).filter(|_| !is_quoted) {
            let message = format!("cables {first} and {} are both named `{}`", index + 1, cable.name);
            return Err(reader
                .document
                .error_at(&path, "robot::cable-name", message)
                .with_help("give every cable a name of its own"));
        }
    }
    Ok(())
}

/// One `[[cable]]` table with its index.
pub(super) struct CableReader<'a> {
    pub(super) reader: &'a Reader<'a>,
    pub(super) section: &'a CableSection,
    index: usize,
}

impl CableReader<'_> {
    fn cable(&self) -> Result<Cable, ReadError> {
        let section = self.section;
        self.check_stiffness()?;
        let tensions = (section.tension_min_N, section.tension_max_N);
        self.check_limits([Kind::TensionMin, Kind::TensionMax], tensions, "robot::tension-limits")?;
        let lengths = (section.length_min_m, section.length_max_m);
        self.check_limits([Kind::LengthMin, Kind::LengthMax], lengths, "robot::length-limits")?;
        let wraps = (section.pulley_wrap_min_rad, section.pulley_wrap_max_rad);
        self.check_limits([Kind::WrapMin, Kind::WrapMax], wraps, "robot::wrap-limits")?;
        self.check_wrap_side()?;
        self.check_pulley_inertia()?;
        let cable = Cable {
            name: section.name.clone(),
            frame_anchor: self.vector("frame_anchor_m", &section.frame_anchor_m)?,
            platform_anchor: self.platform_anchor()?,
            pulley: self.pulley()?,
            pulley_wrap_side: section.pulley_wrap_side,
            pulley_wrap_min: section.pulley_wrap_min_rad,
            pulley_wrap_max: section.pulley_wrap_max_rad,
            diameter: self.number(Kind::Diameter, section.diameter_m)?,
            length_min: section.length_min_m,
            length_max: section.length_max_m,
            speed_max: self.number(Kind::SpeedMax, section.speed_max_m_s)?,
            tension_min: section.tension_min_N,
            tension_max: section.tension_max_N,
            stiffness: self.stiffness()?,
            stiffness_by: section.stiffness_by,
            hidden_length: self.number(Kind::HiddenLength, section.hidden_length_m)?,
            series_compliance: self.number(Kind::SeriesCompliance, section.series_compliance_m_per_N)?,
            tension_of_strain: section.tension_of_strain_N.clone(),
            hysteresis: section.hysteresis.clone(),
            law_numbers: self.law_numbers()?,
            length_scale: self.number(Kind::LengthScale, section.length_scale)?,
            length_offset: section.length_offset_m,
            tension_scale: self.number(Kind::TensionScale, section.tension_scale)?,
            tension_offset: section.tension_offset_N,
            swivel_offset: section.swivel_offset_rad,
            tension_at: section.tension_at,
            linear_density: self.number(Kind::LinearDensity, section.linear_density_kg_per_m)?,
            finite_elements: self.finite_elements(section.finite_elements)?,
            damping: self.number(Kind::CableDamping, section.cable_damping_N_s_per_m)?,
            damping_time: self.number(Kind::CableDampingTime, section.cable_damping_time_s)?,
            pulley_friction: self.number(Kind::PulleyFriction, section.pulley_friction)?,
            pulley_inertia: self.number(Kind::PulleyInertia, section.pulley_inertia_kg_m2)?,
            winch: self.winch()?,
        };
        self.check_stretch(&cable)?;
        Ok(cable)
    }

    /// Numbers of laws of stretch, by their keys.
    fn law_numbers(&self) -> Result<BTreeMap<&'static str, f64>, ReadError> {
        let stated = law_numbers().filter_map(|number| Some((number.key, *self.section.law_numbers.get(number.key)?)));
        stated.map(|(key, value)| Ok((key, self.positive(key, Some(value))?.unwrap_or(value)))).collect()
    }

    /// Checks that a pulley with an inertia has a radius, by which it turns with its cable.
    fn check_pulley_inertia(&self) -> Result<(), ReadError> {
        let has_radius = self.section.pulley_radius_m.is_some_and(|radius| radius > 0.0);
        if has_radius || !self.section.pulley_inertia_kg_m2.is_some_and(|inertia| inertia > 0.0) {
            return Ok(());
        }
        let message = "pulley_inertia_kg_m2 is given, but no pulley_radius_m above zero";
        let help = "a pulley turns by the length of cable over its radius: add pulley_radius_m";
        Err(self.error("pulley_inertia_kg_m2", "robot::pulley-inertia", message).with_help(help))
    }

    /// The platform anchor; it may be missing for a point platform, but not for one that rotates.
    fn platform_anchor(&self) -> Result<Vector3<f64>, ReadError> {
        let pattern = self.reader.pattern;
        match &self.section.platform_anchor_m {
            Some(values) => self.vector("platform_anchor_m", values),
            None if pattern.dof() == pattern.translations() => Ok(Vector3::zeros()),
            None => {
                let message = "the key `platform_anchor_m` is missing here";
                let help = format!(
                    "add `platform_anchor_m = …`, the cable's end on the platform: only point platforms (2T, 3T) do without, a platform of motion pattern {} turns",
                    pattern.name()
                );
                Err(self.error("platform_anchor_m", "toml::missing-key", message).with_help(help))
            }
        }
    }

    fn pulley(&self) -> Result<Option<Pulley>, ReadError> {
        let radius = self.number(Kind::PulleyRadius, self.section.pulley_radius_m)?;
        let axis = self.section.pulley_swivel_axis.as_deref().map(|axis| self.direction(axis)).transpose()?;
        Ok(Pulley::of(radius, axis.map(Into::into)))
    }

    /// The stiffness in one of the three forms of the file.
    fn stiffness(&self) -> Result<Option<CableStiffness>, ReadError> {
        let axial = self.number(Kind::AxialStiffness, self.section.axial_stiffness_EA_N)?.map(CableStiffness::Axial);
        let compliance = self.number(Kind::Compliance, self.section.axial_compliance_per_N)?;
        let spring = self.number(Kind::SpringConstant, self.section.spring_constant_N_per_m)?;
        Ok(axial.or(compliance.map(CableStiffness::Compliance)).or(spring.map(CableStiffness::Spring)))
    }

    fn path<'k>(&self, key: &'k str) -> [Step<'k>; 3] {
        [Step::Key("cable"), Step::Index(self.index), Step::Key(key)]
    }

    pub(super) fn error(&self, key: &str, code: &'static str, message: &str) -> ReadError {
        let message = format!("cable {} (`{}`): {message}", self.index + 1, self.section.name);
        self.reader.document.error_at(&self.path(key), code, message)
    }

    pub(super) fn vector(&self, key: &str, values: &[f64]) -> Result<Vector3<f64>, ReadError> {
        self.reader.vector(&self.path(key), values)
    }

    /// A number within the range of its parameter.
    pub(super) fn number(&self, kind: Kind, number: Option<f64>) -> Result<Option<f64>, ReadError> {
        match kind.range() {
            Range::NotNegative => self.reader.not_negative(&self.path(kind.key()), number),
            Range::Positive => self.positive(kind.key(), number),
            Range::Real | Range::NotZero => Ok(number),
        }
    }

    fn positive(&self, key: &str, number: Option<f64>) -> Result<Option<f64>, ReadError> {
        match number {
            Some(number) if number < 1.0 / MAGNITUDE_LIMIT => {
                let least =
                    if number > 0.0 { format!(", at least {:e}", 1.0 / MAGNITUDE_LIMIT) } else { String::new() };
                let message = format!("{} is {number:?}; it must be above zero{least}", key_name(&self.path(key)));
                Err(self.error(key, "robot::not-positive", &message).with_help("leave the key out if unknown"))
            }
            fine => Ok(fine),
        }
    }

    fn direction(&self, values: &[f64]) -> Result<Vector3<f64>, ReadError> {
        let axis = self.vector("pulley_swivel_axis", values)?;
        let help = "it is the unit vector from the winch into the pulley, e.g. [0.0, 0.0, 1.0]";
        self.unit("pulley_swivel_axis", axis, "robot::swivel-axis", help)
    }

    /// A unit vector; rounding of the printed digits is removed, a larger deviation is an error.
    pub(super) fn unit(
        &self,
        key: &str,
        axis: Vector3<f64>,
        code: &'static str,
        help: &str,
    ) -> Result<Vector3<f64>, ReadError> {
        let norm = axis.norm();
        if (norm - 1.0).abs() > DIRECTION_NORM_TOLERANCE {
            let message = format!("{key} has the norm {norm}; a direction has the norm 1");
            return Err(self.error(key, code, &message).with_help(help.to_owned()));
        }
        // a vector that is already unit to rounding is not changed, so that files are read back to the bit
        Ok(if (norm - 1.0).abs() <= 4.0 * f64::EPSILON { axis } else { axis / norm })
    }

    /// Checks the number of elements of a cable.
    fn finite_elements(&self, count: Option<usize>) -> Result<Option<usize>, ReadError> {
        match count {
            Some(count) if !(1..=FINITE_ELEMENT_LIMIT).contains(&count) => {
                let message = format!("finite_elements is {count}; a cable has 1 to {FINITE_ELEMENT_LIMIT}");
                Err(self
                    .error("finite_elements", "robot::finite-elements", &message)
                    .with_help("10 elements are within 1 % of the sag; leave the key out for them"))
            }
            fine => Ok(fine),
        }
    }

    /// Checks that at most one of the three stiffness keys is stated.
    fn check_stiffness(&self) -> Result<(), ReadError> {
        let section = self.section;
        let stated = [section.axial_stiffness_EA_N, section.axial_compliance_per_N, section.spring_constant_N_per_m];
        let given: Vec<&str> =
            STIFFNESS_KEYS.into_iter().zip(stated).filter_map(|(key, value)| value.map(|_| key)).collect();
        match given[..] {
            [first, second, ..] => Err(self
                .error(second, "robot::stiffness-twice", &format!("both {first} and {second} are given"))
                .with_help("they say the same thing in different ways: keep one")),
            _ => Ok(()),
        }
    }

    /// Checks the laws of stretch: tension must rise with strain.
    fn check_stretch(&self, cable: &Cable) -> Result<(), ReadError> {
        for law in LAWS {
            let Err(error) = law.of(cable) else { continue };
            let steps = [law.table, Some(error.key())].into_iter().flatten().map(Step::Key);
            let path: Vec<Step<'_>> = [Step::Key("cable"), Step::Index(self.index)].into_iter().chain(steps).collect();
            let message = format!("cable {} (`{}`): {error}", self.index + 1, self.section.name);
            return Err(self.reader.document.error_at(&path, error.code(), message).with_help(error.help()));
        }
        Ok(())
    }

    /// Checks that only planar robots have pulleys that do not swivel.
    fn check_wrap_side(&self) -> Result<(), ReadError> {
        if self.section.pulley_wrap_side.is_none() || self.reader.pattern.is_planar() {
            return Ok(());
        }
        let message = "pulley_wrap_side belongs to planar robots; the platform of this one would leave the plane of a pulley that \
                       does not swivel";
        Err(self
            .error("pulley_wrap_side", "robot::wrap-side", message)
            .with_help("leave the key out: with pulley_swivel_axis alone the pulley turns to the platform"))
    }

    /// Checks two limits: neither below zero, and in order.
    fn check_limits(
        &self,
        kinds: [Kind; 2],
        limits: (Option<f64>, Option<f64>),
        code: &'static str,
    ) -> Result<(), ReadError> {
        let [least, largest] = kinds.map(Kind::key);
        match (self.number(kinds[0], limits.0)?, self.number(kinds[1], limits.1)?) {
            (Some(min), Some(max)) if min > max => Err(self
                .error(least, code, &format!("{least} = {min} is above {largest} = {max}"))
                .with_help("swap them, or mend the wrong one")),
            _ => Ok(()),
        }
    }
}
