//! Loads, tension limits, methods and criteria that callers choose, or the robot's own.

use cdpr::Model;
use cdpr::reading::Keyword;
use cdpr::robot::Robot;
use cdpr::statics::Load;
use cdpr::tension::{Limits, Method};
use cdpr::workspace::Criterion;
use cdpr::workspace::criterion::registry::{self, CriterionRequest, Setting};
use pyo3::prelude::*;

use crate::arrays::{Rows, numbers};
use crate::error::{OrRaise, mistaken};

/// Lower and upper limits of tensions (N).
pub(crate) type LimitArguments<'py> = (Bound<'py, PyAny>, Bound<'py, PyAny>);

/// The load that `wrench` gives, by the components of the robot's motion pattern, or the robot's own.
pub(crate) fn load(py: Python<'_>, robot: &Robot, wrench: Option<&Bound<'_, PyAny>>) -> PyResult<Load> {
    let Some(wrench) = wrench else { return Load::of(robot).or_raise(py) };
    let pattern = robot.motion_pattern;
    let names = pattern.wrench_names(robot.plane).join(", ");
    let components = Rows::of(wrench, pattern.dof(), "wrench", &names)?;
    let basis = pattern.twist_basis(robot.plane);
    Ok(Load::constant(basis.iter().zip(components.contiguous().iter()).map(|(unit, number)| unit * *number).sum()))
}

/// The load that `wrench` gives; `None` for the robot's own where it is needed.
pub(crate) fn load_if_given(
    py: Python<'_>,
    robot: &Robot,
    wrench: Option<&Bound<'_, PyAny>>,
) -> PyResult<Option<Load>> {
    wrench.map(|wrench| load(py, robot, Some(wrench))).transpose()
}

/// The limits (minimum, maximum), each a number or one per cable, or the robot's own.
pub(crate) fn limits(py: Python<'_>, robot: &Robot, limits: Option<LimitArguments<'_>>) -> PyResult<Limits> {
    let Some((minimum, maximum)) = limits else { return Limits::of(robot, None, None).or_raise(py) };
    let per_cable = |bound: &Bound<'_, PyAny>| -> PyResult<Vec<f64>> {
        match bound.extract::<f64>() {
            Ok(number) => Ok(vec![number; robot.cable_count()]),
            Err(_) => Ok(numbers(bound, "limits")?.as_array().iter().copied().collect()),
        }
    };
    let (minimum, maximum) = (per_cable(&minimum)?, per_cable(&maximum)?);
    if let Some(found) = [minimum.len(), maximum.len()].into_iter().find(|found| *found != robot.cable_count()) {
        let message = format!("limits: {found} numbers for {} cables", robot.cable_count());
        return Err(mistaken(py, "limits::count", message, "give one number, or one per cable"));
    }
    Limits::new(minimum, maximum).or_raise(py)
}

/// The choice with this name.
pub(crate) fn named<T: Keyword>(py: Python<'_>, name: &str, what: &str) -> PyResult<T> {
    T::named(name).ok_or_else(|| {
        let known: Vec<&str> = T::ALL.iter().map(|choice| choice.name()).collect();
        let message = format!("{what}: there is no `{name}`");
        mistaken(py, "usage::value", message, &format!("choose one of {}", known.join(", ")))
    })
}

/// The way to choose tensions.
pub(crate) fn method(py: Python<'_>, name: &str) -> PyResult<Method> {
    named(py, name, "method")
}

/// Inputs of criteria: load and limits as given, or those of the robot if it states them.
pub(crate) fn setting<'m>(
    py: Python<'_>,
    model: &'m Model,
    bounds: Option<LimitArguments<'_>>,
    wrench: Option<&Bound<'_, PyAny>>,
) -> PyResult<Setting<'m>> {
    let robot = model.robot();
    Ok(Setting {
        model,
        load: match wrench {
            Some(_) => Ok(load(py, robot, wrench)?),
            None => Load::of(robot),
        },
        limits: match bounds {
            Some(_) => Ok(limits(py, robot, bounds)?),
            None => Limits::of(robot, None, None),
        },
    })
}

/// The criterion that all of these names ask for.
pub(crate) fn criterion<'a>(
    py: Python<'_>,
    names: &[String],
    setting: &Setting<'a>,
) -> PyResult<Box<dyn Criterion + 'a>> {
    let wanted =
        names.iter().map(|name| name.parse::<CriterionRequest>()).collect::<Result<Vec<_>, _>>().or_raise(py)?;
    registry::all(&wanted, setting).or_raise(py)
}
