//! The files of a sweep's points: numbers of robots are set in the robots, all others in the text.

use toml::Table;

use super::key::KeyTarget;
use super::point_error::PointError;
use super::pulleys::with_pulleys;
use super::{Key, Subjects, Sweep};
use crate::{Robots, Study};
use cdpr_model::reading::ReadError;
use cdpr_model::robot::{Parameter, Robot};

/// The files of a sweep without its values.
pub(super) struct Files {
    keys: Vec<Key>,
    /// Axis of placed pulleys, for each parameter of the sweep.
    axes: Vec<Option<Vec<f64>>>,
    study: File<Study>,
    control: File<Robot>,
    machine: File<Robot>,
    offset_robot: Option<String>,
}

/// A file as text and, if it can be read without the sweep's values, its content.
struct File<T> {
    place: KeyTarget,
    /// Name of the file in errors.
    name: &'static str,
    table: Table,
    read: Option<T>,
    /// Parameters of the robot that each parameter of the sweep sets; `None` if its key is no parameter.
    parameters: Vec<Option<Vec<Parameter>>>,
}

/// The files with values for some parameters.
pub(super) struct Changed<'f> {
    files: &'f Files,
    /// Index of the sweep's parameter, and its value.
    values: &'f [(usize, f64)],
}

impl Files {
    pub(super) fn new(sweep: &Sweep, subjects: &Subjects) -> Result<Self, PointError> {
        let table = |text: &str, name: &str| -> Result<Table, ReadError> {
            text.parse().map_err(|error: toml::de::Error| ReadError::new(name, "toml::syntax", error.to_string()))
        };
        let study = table(&subjects.study, "the study")?;
        let keys: Vec<Key> = sweep.parameter.iter().map(|parameter| parameter.key.parse()).collect::<Result<_, _>>()?;
        let robot = |text: &str, place: KeyTarget, known, name| -> Result<File<Robot>, PointError> {
            let read = Robot::from_toml(text, known).ok();
            let parameters_of = |key: &Key| match &read {
                Some(robot) if key.place.covers(place) => key.parameters(robot),
                _ => Ok(None),
            };
            let parameters = keys.iter().map(parameters_of).collect::<Result<_, _>>()?;
            Ok(File { place, name, table: table(text, known)?, parameters, read })
        };
        Ok(Self {
            axes: sweep.parameter.iter().map(|parameter| parameter.swivel_axis.clone()).collect(),
            study: File {
                place: KeyTarget::Study,
                name: "the study of this point",
                table: study,
                read: Study::from_toml_bytes(subjects.study.as_bytes(), "the study").ok(),
                parameters: Vec::new(),
            },
            control: robot(
                &subjects.control,
                KeyTarget::Control,
                "the control model",
                "the control model of this point",
            )?,
            machine: robot(&subjects.machine, KeyTarget::Machine, "the machine", "the machine of this point")?,
            offset_robot: subjects.offset_robot.clone(),
            keys,
        })
    }

    /// The files with these values; an error for keys that do not exist.
    pub(super) fn with<'f>(&'f self, values: &'f [(usize, f64)]) -> Result<Changed<'f>, PointError> {
        let changed = Changed { files: self, values };
        changed.table(&self.study, None)?;
        for robot in [&self.control, &self.machine] {
            if changed.by_parameters(robot).is_none() {
                changed.table(robot, robot.read.as_ref())?;
            }
        }
        Ok(changed)
    }
}

impl<'f> Changed<'f> {
    /// The study and its robots; the robot of predictions is left out, since sweeps need none.
    pub(super) fn read(&self) -> Result<(Study, Robots), PointError> {
        let Files { study, control, machine, offset_robot, .. } = self.files;
        let study = match (&study.read, self.of(study.place).next()) {
            (Some(known), None) => known.clone(),
            _ => Study::from_toml_bytes(self.text(study, None)?.as_bytes(), study.name)?,
        };
        let mut machine = self.robot(machine)?;
        let placed = self.of(KeyTarget::PlacedPulleys).last();
        if let Some((index, radius)) = placed {
            machine = with_pulleys(&machine, &study, radius, self.files.axes[index].as_deref())?;
        }
        let former = offset_robot.as_ref().map(|text| Robot::from_toml(text, "the offset robot")).transpose()?;
        Ok((study, Robots { control: self.robot(control)?, machine, prediction: None, former }))
    }

    /// The values whose keys change the file at a place.
    fn of(&self, place: KeyTarget) -> impl Iterator<Item = (usize, f64)> {
        self.values.iter().copied().filter(move |(index, _)| self.files.keys[*index].place.covers(place))
    }

    fn robot(&self, file: &File<Robot>) -> Result<Robot, PointError> {
        match self.by_parameters(file) {
            Some(robot) => Ok(robot),
            None => {
                let mut robot = Robot::from_toml(&self.text(file, file.read.as_ref())?, file.name)?;
                self.set_without_key(file, &mut robot);
                Ok(robot)
            }
        }
    }

    /// Sets the parameters for which files have no key: turns of axes, and the wrench, which has two.
    fn set_without_key(&self, file: &File<Robot>, robot: &mut Robot) {
        for (index, value) in self.of(file.place) {
            let parameters = file.parameters[index].iter().flatten();
            let without: Vec<_> = parameters.filter(|parameter| parameter.key(robot).is_none()).copied().collect();
            without.iter().for_each(|parameter| parameter.set(robot, value));
        }
    }

    /// The robot with its parameters set; `None` if a key is no parameter, or if the values must be checked by the
    /// reader.
    fn by_parameters(&self, file: &File<Robot>) -> Option<Robot> {
        let mut robot = file.read.clone()?;
        for (index, value) in self.of(file.place) {
            for parameter in file.parameters[index].as_ref()? {
                parameter.set_alone(&mut robot, value)?;
            }
        }
        Some(robot)
    }

    /// The text with the values at their keys; the keys of parameters are those of `robot`.
    fn table<T>(&self, file: &File<T>, robot: Option<&Robot>) -> Result<Table, PointError> {
        let mut table = file.table.clone();
        for (index, value) in self.of(file.place) {
            self.files.keys[index].set(&mut table, value, robot)?;
        }
        Ok(table)
    }

    fn text<T>(&self, file: &File<T>, robot: Option<&Robot>) -> Result<String, PointError> {
        let table = self.table(file, robot)?;
        Ok(toml::to_string(&table).map_err(|error| ReadError::new(file.name, "toml::syntax", error.to_string()))?)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sweep_of(key: &str) -> Sweep {
        let text = format!("study = \"s\"\n[[parameter]]\nkey = \"{key}\"\nvalues = [1]");
        Sweep::from_toml_bytes(text.as_bytes(), "sweep.toml").unwrap()
    }

    /// Setting a parameter gives the same robot as editing its key and reading the file again.
    #[test]
    fn a_robot_with_a_parameter_set_is_the_robot_of_the_edited_file() {
        let mut set = 0;
        for name in cdpr_model::robot::builtin::names() {
            let robot = Robot::builtin(name).unwrap();
            let text = robot.to_toml();
            let subjects = Subjects { study: String::new(), control: text.clone(), machine: text, offset_robot: None };
            // for cables, only the last
            for key in robot.parameters().filter_map(|parameter| parameter.key(&robot)) {
                let last = format!("cable[{}]", robot.cable_count());
                if key.starts_with("cable") && !key.starts_with(&last) {
                    continue;
                }
                let sweep = sweep_of(&format!("machine.{key}"));
                let files = Files::new(&sweep, &subjects).unwrap();
                for value in [0.1, 1.0 / 3.0, 1e-31, 0.0, -2.5, 1e31] {
                    let values = [(0, value)];
                    let changed = Changed { files: &files, values: &values };
                    let Some(by_parameter) = changed.by_parameters(&files.machine) else { continue };
                    let by_text = Robot::from_toml(&changed.text(&files.machine, None).unwrap(), "edited").unwrap();
                    assert_eq!(by_parameter, by_text, "{name}: {key} = {value}");
                    set += 1;
                }
            }
        }
        // anchors alone are more than this
        assert!(set > 500, "{set} were compared");
    }

    fn machine_of(key: &str, value: f64) -> Result<Robot, PointError> {
        let text = Robot::builtin("planar-example").unwrap().to_toml();
        let subjects = Subjects { study: String::new(), control: text.clone(), machine: text, offset_robot: None };
        let sweep = sweep_of(key);
        let files = Files::new(&sweep, &subjects)?;
        let values = [(0, value)];
        let changed = files.with(&values)?;
        changed.robot(&files.machine)
    }

    /// A parameter has the same name in fits, deviations and sweeps, also if the reader has to check the value.
    #[test]
    fn a_parameter_is_swept_by_its_name_as_by_its_key() {
        for (name, key, value) in [
            ("frame-anchor[2].x", "cable[2].frame_anchor_m[1]", 7.5),
            ("axial-stiffness", "cable[*].axial_stiffness_EA_N", 3e5),
            ("mass", "platform.mass_kg", 150.0),
            // least and largest limit each other
            ("tension-max[3]", "cable[3].tension_max_N", 9000.0),
        ] {
            let by_name = machine_of(&format!("machine.{name}"), value).unwrap();
            assert_eq!(by_name, machine_of(&format!("both.{key}"), value).unwrap(), "{name}");
            assert_ne!(by_name, Robot::builtin("planar-example").unwrap(), "{name}");
        }
        for name in ["frame-anchor[9].x", "frame-anchor[1].q", "swivel-axis[1].turn_1", "mass.x"] {
            let refused = machine_of(&format!("machine.{name}"), 1.0).unwrap_err().to_string();
            assert!(refused.contains(name) && refused.contains("no parameter"), "{refused}");
        }
        assert!(machine_of("machine.tension-max[3]", -1e9).is_err());
    }

    #[test]
    fn usual_keys_need_no_text() {
        let robot = Robot::builtin("planar-example").unwrap();
        let text = robot.to_toml();
        let subjects = Subjects { study: String::new(), control: text.clone(), machine: text, offset_robot: None };
        for key in ["both.cable[*].axial_stiffness_EA_N", "control.cable[1].frame_anchor_m[1]", "both.platform.mass_kg"]
        {
            let sweep = sweep_of(key);
            let files = Files::new(&sweep, &subjects).unwrap();
            let changed = Changed { files: &files, values: &[(0, 1000.0)] };
            assert!(changed.by_parameters(&files.control).is_some(), "{key}");
            assert!(changed.by_parameters(&files.machine).is_some(), "{key}");
        }
    }
}
