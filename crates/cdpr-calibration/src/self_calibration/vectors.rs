//! Rows of samples at unknown poses: lengths alone by their own fast search, everything else by that of all sensors.

use super::equations::Equation;
use crate::objective::{Latent, Layout, PoselessVectors, SensorVectors, Stacked, Vectors, Weights};
use cdpr_model::geometry::Pose;
use cdpr_model::measurement::InternalSamples;
use cdpr_model::model::Model;
use cdpr_model::robot::Parameter;

/// Residuals at the poses where a sample's measurements agree best, and behind them those of equations of the parameters alone.
pub(super) struct PoseVectors<'a> {
    samples: SampleVectors<'a>,
    equations: &'a [Equation],
    model: &'a Model,
    parameters: &'a [Parameter],
}

/// Residuals of samples.
enum SampleVectors<'a> {
    /// Of lengths.
    Lengths(Box<PoselessVectors<'a>>),
    /// Of all sensors.
    Sensors(Box<SensorVectors<'a>>),
}

/// Measurements that the rows of samples are made of.
#[derive(Clone, Debug)]
pub(super) enum Sensing {
    /// Lengths with this standard deviation (m).
    Lengths(f64),
    /// All sensors.
    All(Layout, Weights),
}

impl Sensing {
    /// Vectors of free parameters.
    pub(super) fn vectors<'a>(
        &self,
        model: &'a Model,
        internal: &'a InternalSamples,
        parameters: &'a [Parameter],
        equations: &'a [Equation],
    ) -> PoseVectors<'a> {
        let samples = match self {
            Self::Lengths(sigma) => {
                SampleVectors::Lengths(Box::new(PoselessVectors::new(model, internal, parameters, *sigma)))
            }
            Self::All(layout, weights) => {
                SampleVectors::Sensors(Box::new(SensorVectors::new(model, internal, parameters, layout, weights)))
            }
        };
        PoseVectors { samples, equations, model, parameters }
    }

    /// Standard deviation of a length (m).
    pub(super) fn length_sigma(&self) -> f64 {
        match self {
            Self::Lengths(sigma) => *sigma,
            Self::All(_, weights) => weights.length,
        }
    }

    /// Metres that are one unit of the vectors, where they have one.
    pub(super) fn unit(&self) -> Option<f64> {
        match self {
            Self::Lengths(sigma) => Some(*sigma),
            Self::All(..) => None,
        }
    }
}

impl PoseVectors<'_> {
    /// Poses found last, one of each sample.
    pub(super) fn poses(&self) -> Vec<Pose> {
        match &self.samples {
            SampleVectors::Lengths(vectors) => vectors.poses().to_vec(),
            SampleVectors::Sensors(vectors) => vectors.poses(),
        }
    }

    /// Samples whose search for a pose ended on the way where was written last.
    pub(super) fn unsettled(&self) -> usize {
        match &self.samples {
            SampleVectors::Lengths(_) => 0,
            SampleVectors::Sensors(vectors) => vectors.unsettled(),
        }
    }

    /// Rows that unknowns of samples do not take up, those of equations included; `None` if unknowns are more.
    pub(super) fn equation_count(&self) -> Option<usize> {
        (self.size() * self.samples()).checked_sub(self.unknowns())
    }

    /// Shares of the rows' residuals that their own poses take up; empty where only lengths are rows.
    pub(super) fn leverages(&self) -> Vec<f64> {
        match &self.samples {
            SampleVectors::Lengths(_) => Vec::new(),
            SampleVectors::Sensors(vectors) => vectors.leverages(),
        }
    }

    /// Begins searches at poses that were found before.
    pub(super) fn begin_at(&mut self, poses: &[Pose]) {
        match &mut self.samples {
            SampleVectors::Lengths(vectors) => vectors.begin_at(poses),
            SampleVectors::Sensors(vectors) => vectors.begin_at(poses),
        }
    }

    fn sample_count(&self) -> usize {
        match &self.samples {
            SampleVectors::Lengths(vectors) => vectors.samples(),
            SampleVectors::Sensors(vectors) => vectors.samples(),
        }
    }

    fn row_count(&self) -> usize {
        self.equations.iter().map(Equation::count).sum()
    }

    /// Writes equations behind the samples.
    fn write_equations(&self, values: &[f64], stacked: &mut Stacked) -> Option<()> {
        if self.equations.is_empty() {
            return Some(());
        }
        let model = self.model.with_parameters(self.parameters, values)?;
        let mut place = self.size() * self.sample_count();
        for equation in self.equations {
            for row in equation.rows(&model, self.parameters)? {
                stacked.residuals[place] = row.residual;
                row.derivatives.iter().enumerate().for_each(|(k, entry)| stacked.jacobian[(place, k)] = *entry);
                place += 1;
            }
        }
        Some(())
    }
}

/// Steps of other starts by all sensors: those that lead to an optimum take a dozen, and each of a lost one costs searches of poses that nothing holds.
const PATIENCE: u32 = 40;

/// Equations stand in samples of their own; what these have too many of rows are rows without meaning, each taken up by an unknown.
impl Vectors for PoseVectors<'_> {
    fn patience(&self) -> Option<u32> {
        matches!(self.samples, SampleVectors::Sensors(_)).then_some(PATIENCE)
    }

    fn size(&self) -> usize {
        match &self.samples {
            SampleVectors::Lengths(vectors) => vectors.size(),
            SampleVectors::Sensors(vectors) => vectors.size(),
        }
    }

    fn unknowns(&self) -> usize {
        let own = match &self.samples {
            SampleVectors::Lengths(vectors) => vectors.unknowns(),
            SampleVectors::Sensors(vectors) => vectors.unknowns(),
        };
        own + self.row_count().next_multiple_of(self.size()) - self.row_count()
    }

    fn samples(&self) -> usize {
        self.sample_count() + self.row_count().div_ceil(self.size())
    }

    fn rows(&self) -> (usize, usize) {
        let conventions = self.equations.iter().filter(|equation| equation.is_convention()).map(Equation::count).sum();
        (self.size() * self.sample_count() + self.row_count() - conventions, conventions)
    }

    fn restart(&mut self) {
        match &mut self.samples {
            SampleVectors::Lengths(vectors) => vectors.restart(),
            SampleVectors::Sensors(vectors) => vectors.restart(),
        }
    }

    fn seek_again(&mut self, values: &[f64]) -> bool {
        match &mut self.samples {
            SampleVectors::Lengths(vectors) => vectors.seek_again(values),
            SampleVectors::Sensors(vectors) => vectors.seek_again(values),
        }
    }

    fn latents(&self) -> Vec<Latent> {
        match &self.samples {
            SampleVectors::Lengths(vectors) => vectors.latents(),
            SampleVectors::Sensors(vectors) => vectors.latents(),
        }
    }

    fn go_on_from(&mut self, latents: &[Latent]) {
        match &mut self.samples {
            SampleVectors::Lengths(vectors) => vectors.go_on_from(latents),
            SampleVectors::Sensors(vectors) => vectors.go_on_from(latents),
        }
    }

    fn write(&mut self, values: &[f64], stacked: &mut Stacked) -> bool {
        let is_written = match &mut self.samples {
            SampleVectors::Lengths(vectors) => vectors.write(values, stacked),
            SampleVectors::Sensors(vectors) => vectors.write(values, stacked),
        };
        is_written && self.write_equations(values, stacked).is_some() && stacked.is_finite()
    }
}
