//! From a robot file to a [`Robot`]: checks the conditions that types cannot express, with the position of each error.

use std::path::Path;

use nalgebra::{Matrix3, Vector3};
use toml::de::DeValue;

use super::assumption_reading::check_assumptions;
use super::cable_defaults::fill_in_cables;
use super::cable_reading::read_cables;
use super::file::{Inertia, Moment, PlatformSection, RobotFile, WorkspaceSection, WrenchSection};
use super::home_reading::read_home;
use super::reader::{Reader, square};
use super::stretch::registry::law_numbers;
use super::surroundings_reading::{read_hull, read_obstacles};
use super::{ExternalWrench, Platform, ReferenceCheck, Robot, Source, TravelBox};
use crate::geometry::{MotionPattern, Wrench};
use crate::reading::{FileError, Gathering, ReadError, Size, Step, TomlDocument, bytes_of, text_from_bytes};

/// The layout version that is read and written.
pub(super) const LAYOUT_VERSION: u32 = 1;

/// Relative asymmetry of an inertia matrix that counts as rounding of its printed digits.
const ASYMMETRY_LIMIT: f64 = 1e-6;

impl Robot {
    /// Reads a robot file of layout version 1; `file_name` is only used in errors.
    pub fn from_toml(text: &str, file_name: &str) -> Result<Self, ReadError> {
        let mut document = TomlDocument::parse(text, file_name)?;
        check_layout_version(&document)?;
        fill_in_cables(&mut document)?;
        let keys = law_numbers().map(|number| number.key).collect();
        let file: RobotFile = document.deserialize_gathering(&Gathering { list: "cable", keys })?;
        let reader = Reader::new(&document, &file)?;
        reader.robot(file)
    }

    /// As [`Robot::from_toml`], from bytes that may not be text.
    pub fn from_toml_bytes(bytes: &[u8], file_name: &str) -> Result<Self, ReadError> {
        Self::from_toml(text_from_bytes(bytes, Size::Text, file_name)?, file_name)
    }

    /// Reads the robot file at a path.
    pub fn from_file(path: impl AsRef<Path>) -> Result<Self, FileError> {
        let path = path.as_ref();
        Ok(Self::from_toml_bytes(&bytes_of(path, Size::Text)?, &path.display().to_string())?)
    }
}

/// Refuses other layouts before their keys are reported as unknown.
fn check_layout_version(document: &TomlDocument<'_>) -> Result<(), ReadError> {
    let path = [Step::Key("layout_version")];
    match document.value(&path) {
        None => Err(document
            .error_at(&[], "robot::layout-version", "the key `layout_version` is missing: is this a robot file?")
            .with_help(format!("write `layout_version = {LAYOUT_VERSION}` in the first line"))),
        Some(DeValue::Integer(version)) if version.as_str() != LAYOUT_VERSION.to_string() => {
            let message = format!("layout version {version} is not known; this program reads version {LAYOUT_VERSION}");
            Err(document
                .error_at(&path, "robot::layout-version", message)
                .with_help(format!("write `layout_version = {LAYOUT_VERSION}`, or use a newer cdpr")))
        }
        // a wrong type is reported with those of other keys
        Some(_) => Ok(()),
    }
}

impl Reader<'_> {
    fn robot(&self, file: RobotFile) -> Result<Robot, ReadError> {
        if file.name.is_empty() || file.name.contains(char::is_whitespace) {
            let message = format!("the name {:?} is not one word", file.name);
            return Err(self
                .document
                .error_at(&[Step::Key("name")], "robot::name", message)
                .with_help("use hyphens for spaces; `title` may be any line"));
        }
        let gravity = |values: &Vec<f64>| self.vector(&[Step::Key("gravity_m_s2")], values);
        let cables = read_cables(self, &file)?;
        let obstacles = read_obstacles(self, &file)?;
        check_assumptions(self, &file)?;
        self.check_references(&file.reference_check, cables.len())?;
        self.check_published(file.source.as_ref())?;
        Ok(Robot {
            gravity: file.gravity_m_s2.as_ref().map(gravity).transpose()?,
            platform: self.platform(&file.platform)?,
            home: file.home_pose.as_ref().map(|home| read_home(self, home)).transpose()?,
            external_wrench: file.external_wrench.map(|wrench| self.external_wrench(wrench)).transpose()?,
            travel: file.workspace.map(|workspace| self.travel(workspace)).transpose()?,
            name: file.name,
            title: file.title,
            motion_pattern: self.pattern,
            kind: file.kind,
            plane: self.plane,
            notes: file.notes,
            source: file.source,
            assumptions: file.assumption,
            obstacles,
            cables,
            reference_checks: file.reference_check,
            calibration: file.calibration,
            tracked: None,
        })
    }

    fn platform(&self, section: &PlatformSection) -> Result<Platform, ReadError> {
        let path = |key| [Step::Key("platform"), Step::Key(key)];
        let center = |values: &Vec<f64>| self.vector(&path("center_of_mass_m"), values);
        let inertia = &section.inertia_about_center_of_mass_kg_m2;
        Ok(Platform {
            mass: self.not_negative(&path("mass_kg"), section.mass_kg)?,
            center_of_mass: section.center_of_mass_m.as_ref().map(center).transpose()?,
            inertia: inertia.as_ref().map(|inertia| self.inertia(inertia)).transpose()?,
            damping: self.not_negative(&path("damping_N_s_per_m"), section.damping_N_s_per_m)?,
            rotational_damping: self
                .not_negative(&path("rotational_damping_Nm_s_per_rad"), section.rotational_damping_Nm_s_per_rad)?,
            hull: section.hull_m.as_deref().map(|points| read_hull(self, points)).transpose()?,
        })
    }

    fn inertia(&self, inertia: &Inertia) -> Result<Matrix3<f64>, ReadError> {
        let path = [Step::Key("platform"), Step::Key("inertia_about_center_of_mass_kg_m2")];
        let error = |message: &str| Err(self.document.error_at(&path, "robot::inertia", message));
        let matrix = match (inertia, self.pattern.is_planar()) {
            (Inertia::Planar(number), true) => {
                let normal = self.plane.normal();
                normal * normal.transpose() * *number
            }
            (Inertia::Planar(_), false) => return error("a spatial robot has a 3×3 inertia matrix, given by rows"),
            (Inertia::Spatial(_), true) => {
                return error("a planar robot has one inertia, about the normal of its plane");
            }
            (Inertia::Spatial(rows), false) => match square(rows) {
                Some(rows) => Matrix3::from_fn(|row, column| rows[row][column]),
                None => return error("the inertia matrix needs 3 rows of 3 numbers"),
            },
        };
        if (matrix - matrix.transpose()).amax() > ASYMMETRY_LIMIT * matrix.amax() {
            return error("an inertia matrix is symmetric; this one is not");
        }
        if matrix.diagonal().iter().any(|&moment| moment < 0.0) {
            return error("a moment of inertia cannot be negative");
        }
        Ok(matrix)
    }

    fn external_wrench(&self, section: WrenchSection) -> Result<ExternalWrench, ReadError> {
        let path = |key| [Step::Key("external_wrench"), Step::Key(key)];
        let force = self.vector(&path("force_N"), &section.force_N)?;
        let moment = match (self.pattern, section.moment_Nm) {
            (_, None) => Vector3::zeros(),
            (MotionPattern::Planar, Some(Moment::Planar(moment))) => self.plane.normal() * moment,
            (MotionPattern::Spatial, Some(Moment::Spatial(moment))) => self.vector(&path("moment_Nm"), &moment)?,
            _ => {
                let message = format!("this moment does not fit motion pattern {}", self.pattern.name());
                return Err(self
                    .document
                    .error_at(&path("moment_Nm"), "robot::moment", message)
                    .with_help("3R3T: three numbers; 1R2T: one number about the plane's normal; 2T and 3T: none"));
            }
        };
        let mut wrench = Wrench::zeros();
        wrench.fixed_rows_mut::<3>(0).copy_from(&force);
        wrench.fixed_rows_mut::<3>(3).copy_from(&moment);
        Ok(ExternalWrench { wrench, includes_gravity: section.includes_gravity, note: section.note })
    }

    fn travel(&self, section: WorkspaceSection) -> Result<TravelBox, ReadError> {
        let path = |key| [Step::Key("workspace"), Step::Key(key)];
        let min = self.vector(&path("position_min_m"), &section.position_min_m)?;
        let max = self.vector(&path("position_max_m"), &section.position_max_m)?;
        if min.iter().zip(max.iter()).any(|(min, max)| min > max) {
            let message = "a component of position_min_m is above that of position_max_m";
            return Err(self.document.error_at(&path("position_min_m"), "robot::workspace", message));
        }
        Ok(TravelBox { min, max, note: section.note })
    }

    /// Checks that published errors are numbers from 0 on.
    fn check_published(&self, source: Option<&Source>) -> Result<(), ReadError> {
        for (index, errors) in source.iter().flat_map(|source| &source.published).enumerate() {
            for (key, value) in [
                ("position_mean_m", Some(errors.position_mean_m)),
                ("rotation_mean_rad", errors.rotation_mean_rad),
                ("length_mean_abs_m", errors.length_mean_abs_m),
                ("tension_mean_norm_N", errors.tension_mean_norm_N),
            ] {
                let path = [Step::Key("source"), Step::Key("published"), Step::Index(index), Step::Key(key)];
                self.not_negative(&path, value)?;
            }
        }
        Ok(())
    }

    /// Checks that the lists of reference checks have the number of entries that the robot needs.
    fn check_references(&self, checks: &[ReferenceCheck], cable_count: usize) -> Result<(), ReadError> {
        let (translations, dof) = (self.pattern.translations(), self.pattern.dof());
        for (index, check) in checks.iter().enumerate() {
            for (key, list, expected) in [
                ("position_m", &check.position_m, translations),
                ("force_N", &check.force_N, translations),
                ("tension_N", &check.tension_N, cable_count),
                ("expected_tension_N", &check.expected_tension_N, cable_count),
                ("expected_offset_m", &check.expected_offset_m, cable_count),
                ("expected_wrench", &check.expected_wrench, dof),
                ("expected_upper_wrench", &check.expected_upper_wrench, dof),
                ("expected_lower_wrench", &check.expected_lower_wrench, dof),
            ] {
                let Some(found) = list.as_ref().map(Vec::len).filter(|&found| found != expected) else { continue };
                let path = [Step::Key("reference_check"), Step::Index(index), Step::Key(key)];
                let message = format!("{key} has {found} numbers, this robot needs {expected}");
                return Err(self.document.error_at(&path, "robot::component-count", message));
            }
        }
        Ok(())
    }
}
