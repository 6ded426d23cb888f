//! Derivatives by differences, for cables with memory on paths without exact derivatives.
//!
//! The machine drives the path with a deviation of ±h and of ±h/2, by its exact forward problem, and each pose has the
//! central differences D(h) and D(h/2). (4 D(h/2) − D(h))/3 is exact to h⁴, and |D(h/2) − D(h)|/3 is the error of
//! D(h/2): rounding of the solves and nonlinear terms. The law is piecewise smooth; if a deviation between h/2 and h
//! changes the branch of a cable, the estimate shows it. At the end of a branch the difference is the mean of the
//! derivatives on both sides.

use nalgebra::{DMatrix, DVector};

use super::cause::{ParameterDeviation, Side};
use super::kink::Kink;
use super::{Derivatives, Differentiation, Sensitivity};
use cdpr_model::control::Control;
use cdpr_model::control::InputError;
use cdpr_model::control::Operation;
use cdpr_model::control::OperationError;
use cdpr_model::control::Outcome;
use cdpr_model::control::{CommandedPose, Reach};
use cdpr_model::model::Model;

/// Outcomes of the path at −h, h, −h/2, h/2.
type Shifted = [Vec<Outcome>; 4];

/// Outcomes along the path with each number deviating.
pub(super) struct Differences<'a> {
    sensitivity: &'a Sensitivity<'a>,
    /// Indices of the poses driven to, in ascending order.
    places: Vec<usize>,
    /// Outcomes at these poses, cause by cause.
    shifted: Vec<Shifted>,
}

impl<'a> Differences<'a> {
    /// Drives to some of the commanded poses (ascending), and to all before them if each is reached from the one
    /// before.
    pub(super) fn new(
        sensitivity: &'a Sensitivity<'_>,
        commands: &[CommandedPose],
        wanted: Vec<usize>,
    ) -> Result<Self, InputError> {
        let is_in_order = sensitivity.history.is_some_and(|(history, _)| history.reach == Reach::InOrder);
        let places = match wanted.last() {
            Some(&last) if is_in_order => (0..=last).collect(),
            _ => wanted,
        };
        let commands: Vec<CommandedPose> = places.iter().map(|&place| commands[place].clone()).collect();
        let shifted = match commands.is_empty() {
            true => Vec::new(),
            false => Path { sensitivity, commands: &commands }.shifted_by_each()?,
        };
        Ok(Self { sensitivity, places, shifted })
    }

    /// The derivatives at one of the requested poses; `kink` is the reason for which it has no exact ones.
    pub(super) fn derivatives(&self, place: usize, kink: Kink) -> Result<Derivatives, OperationError> {
        let Sensitivity { machine, causes, .. } = self.sensitivity;
        let place = self.places.partition_point(|&other| other < place);
        let (n, m, count) = (machine.dof(), machine.cable_count(), causes.len());
        let (mut pose, mut tensions) = (DMatrix::zeros(n, count), DMatrix::zeros(m, count));
        let mut errors = DVector::zeros(count);
        for (column, (cause, paths)) in causes.iter().zip(&self.shifted).enumerate() {
            let [below, above, near_below, near_above] = paths.each_ref().map(|path| &path[place]);
            [below, above, near_below, near_above]
                .into_iter()
                .try_for_each(Outcome::at_rest)
                .map_err(|reason| OperationError::Deviating { cause: cause.name(machine), reason: Box::new(reason) })?;
            let step = step(cause);
            let basis = machine.twist_basis();
            let moved = |from: &Outcome, to: &Outcome, by: f64| {
                let twist = from.pose.displacement_to(&to.pose) / by;
                DVector::from_iterator(n, basis.iter().map(|direction| direction.dot(&twist)))
            };
            let (far, near) = (moved(below, above, 2.0 * step), moved(near_below, near_above, step));
            errors[column] = (&near - &far).amax() / 3.0;
            pose.set_column(column, &((near * 4.0 - far) / 3.0));
            let (far, near) = (pulled(below, above, 2.0 * step), pulled(near_below, near_above, step));
            tensions.set_column(column, &((near * 4.0 - far) / 3.0));
        }
        let differentiation = Differentiation::Differences { errors, kink };
        Ok(Derivatives { pose, tensions: Some(tensions), differentiation })
    }
}

struct Path<'a> {
    sensitivity: &'a Sensitivity<'a>,
    commands: &'a [CommandedPose],
}

impl Path<'_> {
    fn drive(&self, control: &Model, machine: &Model, offsets: &[f64]) -> Result<Vec<Outcome>, InputError> {
        let control = Control { model: control.clone(), ..self.sensitivity.control.clone() };
        let mut operation = Operation::new(control, machine, offsets)?;
        if let Some((history, start)) = &self.sensitivity.history {
            operation = operation.with_history(history, start);
        }
        Ok(self.commands.iter().map(|command| operation.answer(command)).collect())
    }

    fn shifted_by_each(&self) -> Result<Vec<Shifted>, InputError> {
        let columns = 0..self.sensitivity.causes.len();
        #[cfg(feature = "parallel")]
        {
            use rayon::prelude::*;
            columns.into_par_iter().map(|column| self.shifted(column)).collect()
        }
        #[cfg(not(feature = "parallel"))]
        columns.map(|column| self.shifted(column)).collect()
    }

    fn shifted(&self, column: usize) -> Result<Shifted, InputError> {
        let step = step(&self.sensitivity.causes[column]);
        let drive = |by: f64| self.deviating(column, by);
        Ok([drive(-step)?, drive(step)?, drive(-0.5 * step)?, drive(0.5 * step)?])
    }

    /// Outcomes along the path with one number changed.
    fn deviating(&self, column: usize, by: f64) -> Result<Vec<Outcome>, InputError> {
        let Sensitivity { control, machine, winch_offsets, causes, offsets, .. } = self.sensitivity;
        let cause = &causes[column];
        let changed = |model: &Model, side: Side| -> Result<Option<Model>, InputError> {
            if cause.side != side {
                return Ok(None);
            }
            let mut robot = model.robot().clone();
            cause.deviate(model, &mut robot, by);
            Ok(Some(Model::new(robot, model.composition())?))
        };
        let (own_control, own_machine) = (changed(&control.model, Side::Control)?, changed(machine, Side::Machine)?);
        let offsets: Vec<f64> =
            winch_offsets.iter().zip(&offsets[column]).map(|(offset, change)| offset + by * change).collect();
        self.drive(own_control.as_ref().unwrap_or(&control.model), own_machine.as_ref().unwrap_or(machine), &offsets)
    }
}

/// Change of the tensions from one outcome to another, divided by `by`.
fn pulled(from: &Outcome, to: &Outcome, by: f64) -> DVector<f64> {
    let (from, to) = (from.tensions.as_deref().unwrap_or_default(), to.tensions.as_deref().unwrap_or_default());
    DVector::from_iterator(to.len(), to.iter().zip(from).map(|(to, from)| (to - from) / by))
}

/// Step h: forward problems end within some 1e-11 m, so that differences over it are accurate to 1e-5 and better, and
/// few cables are so near to the end of a branch.
fn step(cause: &ParameterDeviation) -> f64 {
    match cause.kind.unit() {
        "m" | "1" => 1e-5,
        "kg" => 0.1,
        _ => 0.5,
    }
}
