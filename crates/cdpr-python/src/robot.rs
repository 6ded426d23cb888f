//! Robots.

use std::sync::Arc;

use cdpr::geometry::Pose;
use cdpr::robot::{self, Parameter};
use numpy::PyArrayDyn;
use pyo3::prelude::*;

use crate::arrays::array;
use crate::error::{OrRaise, mistaken};

/// A robot: anchors, cables, platform, limits. Immutable.
#[pyclass(frozen, module = "cdpr._cdpr")]
pub(crate) struct Robot {
    pub(crate) robot: Arc<robot::Robot>,
}

/// A parameter's name, value and unit.
type Named = (String, Option<f64>, &'static str);

#[pymethods]
impl Robot {
    /// The robot of a TOML text; `name` stands in errors.
    #[staticmethod]
    fn from_toml(py: Python<'_>, text: &[u8], name: &str) -> PyResult<Self> {
        let robot = robot::Robot::from_toml_bytes(text, name).or_raise(py)?;
        Ok(Self { robot: Arc::new(robot) })
    }

    /// The robot that comes with the library; `None` if there is none of this name.
    #[staticmethod]
    fn builtin(name: &str) -> Option<Self> {
        robot::Robot::builtin(name).map(|robot| Self { robot: Arc::new(robot) })
    }

    fn to_toml(&self) -> String {
        self.robot.to_toml()
    }

    #[getter]
    fn name(&self) -> &str {
        &self.robot.name
    }

    #[getter]
    fn title(&self) -> Option<&str> {
        self.robot.title.as_deref()
    }

    #[getter]
    fn motion_pattern(&self) -> &'static str {
        self.robot.motion_pattern.name()
    }

    #[getter]
    fn cable_count(&self) -> usize {
        self.robot.cable_count()
    }

    #[getter]
    fn dof(&self) -> usize {
        self.robot.dof()
    }

    #[getter]
    fn cable_names(&self) -> Vec<&str> {
        self.robot.cables.iter().map(|cable| cable.name.as_str()).collect()
    }

    #[getter]
    fn component_names(&self) -> Vec<String> {
        self.robot.motion_pattern.component_names(self.robot.plane)
    }

    #[getter]
    fn frame_anchors<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
        self.anchors(py, |cable| cable.frame_anchor.into())
    }

    #[getter]
    fn platform_anchors<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
        self.anchors(py, |cable| cable.platform_anchor.into())
    }

    #[getter]
    fn home<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
        array(py, &self.robot.home_or_middle().numbers(), &[7])
    }

    #[getter]
    fn warnings(&self) -> Vec<String> {
        self.robot.warnings()
    }

    /// Names, values (`None` if the file states none) and units of all numbers.
    fn parameters(&self) -> Vec<Named> {
        self.robot.parameters().map(|parameter| self.named(&parameter)).collect()
    }

    /// The parameters that a name stands for; `None` if it is unknown.
    fn parameter(&self, name: &str) -> Option<Vec<Named>> {
        let found = Parameter::named(name, &self.robot)?;
        Some(found.iter().map(|parameter| self.named(parameter)).collect())
    }

    /// A robot with other values of parameters, each a single number.
    fn replaced(&self, py: Python<'_>, changes: Vec<(String, f64)>) -> PyResult<Self> {
        let mut robot = (*self.robot).clone();
        for (name, value) in changes {
            let found = Parameter::named(&name, &robot).unwrap_or_default();
            let [parameter] = found[..] else {
                let message = match found.len() {
                    0 => format!("there is no parameter `{name}`"),
                    count => format!("`{name}` stands for {count} parameters"),
                };
                let help = "`robot.parameters` lists the names of all single numbers";
                return Err(mistaken(py, "parameter::unknown-name", message, help));
            };
            let (least, largest) = parameter.bounds();
            if !value.is_finite() || value < least || value > largest {
                let message = format!("{name} = {value}: outside {least} to {largest}");
                return Err(mistaken(py, "parameter::range", message, "give a number within the range"));
            }
            parameter.set(&mut robot, value);
        }
        Ok(Self { robot: Arc::new(robot) })
    }

    /// Poses in the components of the robot's motion pattern.
    fn components<'py>(&self, py: Python<'py>, poses: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
        let poses = crate::arrays::Poses::of(poses, &self.robot, "poses")?;
        let all = poses.all(py)?;
        let of = |pose: &Pose| self.robot.motion_pattern.pose_to_components(self.robot.plane, pose);
        let numbers: Vec<f64> = all.iter().flat_map(of).collect();
        let shape = [all.len(), self.robot.dof()];
        array(py, &numbers, if poses.is_single { &shape[1..] } else { &shape })
    }

    /// Poses as rows x, y, z, qx, qy, qz, qw.
    fn quaternions<'py>(&self, py: Python<'py>, poses: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
        let poses = crate::arrays::Poses::of(poses, &self.robot, "poses")?;
        let numbers: Vec<f64> = poses.all(py)?.iter().flat_map(Pose::numbers).collect();
        let shape = [poses.count, 7];
        array(py, &numbers, if poses.is_single { &shape[1..] } else { &shape })
    }
}

impl Robot {
    fn named(&self, parameter: &Parameter) -> Named {
        (parameter.name(&self.robot), parameter.get(&self.robot), parameter.unit(&self.robot))
    }

    fn anchors<'py>(
        &self,
        py: Python<'py>,
        of: impl Fn(&robot::Cable) -> [f64; 3],
    ) -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
        let numbers: Vec<f64> = self.robot.cables.iter().flat_map(of).collect();
        array(py, &numbers, &[self.robot.cable_count(), 3])
    }
}

/// Names of the robots that come with the library.
#[pyfunction]
pub(crate) fn builtin_names() -> Vec<&'static str> {
    robot::builtin::names().collect()
}
