//! Rows of samples at unknown poses: lengths alone by their own fast search, everything else by that of all sensors.

use super::equations::Equation;
use crate::residual::poseless::PoselessResidual;
use crate::residual::rows::{Layout, Rows};
use crate::residual::sensors::{SensorLayout, SensorResidual, Weights};
use crate::residual::{Latent, Poseless, Residual};
use cdpr_model::geometry::Pose;
use cdpr_model::measurement::InternalSamples;
use cdpr_model::model::Model;
use cdpr_model::robot::Parameter;

/// Residuals at the poses where a sample's measurements agree best, and behind them those of equations of the parameters alone.
pub(super) struct InternalResidual<'a> {
    samples: Box<dyn Poseless + 'a>,
    equations: &'a [Equation],
    parameters: &'a [Parameter],
    /// Steps of other starts.
    patience: Option<u32>,
}

/// Measurements that the rows of samples are made of.
#[derive(Clone, Debug)]
pub(super) enum Sensing {
    /// Lengths with this standard deviation (m).
    Lengths(f64),
    /// All sensors.
    All(SensorLayout, Weights),
}

impl Sensing {
    /// Residuals of free parameters.
    pub(super) fn residual<'a>(
        &self,
        model: &Model,
        internal: &'a InternalSamples,
        parameters: &'a [Parameter],
        equations: &'a [Equation],
    ) -> InternalResidual<'a> {
        let (samples, patience): (Box<dyn Poseless + 'a>, _) = match self {
            Self::Lengths(sigma) => (Box::new(PoselessResidual::new(model, internal, parameters, *sigma)), None),
            Self::All(layout, weights) => {
                (Box::new(SensorResidual::new(model, internal, parameters, layout, weights)), Some(PATIENCE))
            }
        };
        InternalResidual { samples, equations, parameters, patience }
    }

    /// Standard deviation of a length (m).
    pub(super) fn length_sigma(&self) -> f64 {
        match self {
            Self::Lengths(sigma) => *sigma,
            Self::All(_, weights) => weights.length,
        }
    }
}

/// Steps of other starts by all sensors: those that lead to an optimum take a dozen, and each of a lost one costs searches of poses that nothing holds.
const PATIENCE: u32 = 40;

impl InternalResidual<'_> {
    /// Rows that unknowns of samples do not take up, those of equations included; `None` if unknowns are more.
    pub(super) fn equation_count(&self) -> Option<usize> {
        let layout = self.layout();
        layout.rows().checked_sub(layout.unknowns)
    }

    fn row_count(&self) -> usize {
        self.equations.iter().map(Equation::count).sum()
    }

    /// Writes equations behind the samples.
    fn write_equations(&self, values: &[f64], rows: &mut Rows) -> Option<()> {
        if self.equations.is_empty() {
            return Some(());
        }
        let model = self.model().with_parameters(self.parameters, values)?;
        let mut place = self.samples.layout().rows();
        for equation in self.equations {
            for row in equation.rows(&model, self.parameters)? {
                rows.residuals[place] = row.residual;
                row.derivatives.iter().enumerate().for_each(|(k, entry)| rows.jacobian[(place, k)] = *entry);
                place += 1;
            }
        }
        Some(())
    }
}

/// Equations stand in samples of their own; what these have too many of rows are rows without meaning, each taken up by an unknown.
impl Residual for InternalResidual<'_> {
    fn model(&self) -> &Model {
        self.samples.model()
    }

    fn layout(&self) -> Layout {
        let (own, count) = (self.samples.layout(), self.row_count());
        let conventions = self.equations.iter().filter(|equation| equation.is_convention()).map(Equation::count).sum();
        Layout {
            samples: own.samples + count.div_ceil(own.size),
            size: own.size,
            unknowns: own.unknowns + count.next_multiple_of(own.size) - count,
            data: own.rows() + count - conventions,
            conventions,
        }
    }

    fn write(&mut self, values: &[f64], rows: &mut Rows) -> bool {
        self.samples.write(values, rows) && self.write_equations(values, rows).is_some() && rows.is_finite()
    }

    fn is_absolute(&self) -> bool {
        self.samples.is_absolute()
    }

    fn unit(&self) -> Option<f64> {
        self.samples.unit()
    }

    fn patience(&self) -> Option<u32> {
        self.patience
    }

    fn restart(&mut self) {
        self.samples.restart();
    }

    fn seek_again(&mut self, values: &[f64]) -> bool {
        self.samples.seek_again(values)
    }

    fn latents(&self) -> Vec<Latent> {
        self.samples.latents()
    }

    fn go_on_from(&mut self, latents: &[Latent]) {
        self.samples.go_on_from(latents);
    }
}

impl Poseless for InternalResidual<'_> {
    fn poses(&self) -> Vec<Pose> {
        self.samples.poses()
    }

    fn begin_at(&mut self, poses: &[Pose]) {
        self.samples.begin_at(poses);
    }

    fn unsettled(&self) -> usize {
        self.samples.unsettled()
    }

    fn leverages(&self) -> Vec<f64> {
        self.samples.leverages()
    }
}
