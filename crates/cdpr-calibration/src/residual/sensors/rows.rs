//! Residuals of one sample's sensors, with derivatives by parameters and by what is not known of the platform.

use nalgebra::{DMatrix, DVector, Matrix3};

use super::accuracies::{Sensor, Weights};
use super::swivel::Swivel;
use crate::recorded::Recorded;
use crate::residual::Latent;
use crate::residual::balance::noise::{Noise, UNITS};
use crate::residual::balance::rows::{RowModel, SampleRows};
use crate::residual::metric::by_turn;
use cdpr_model::geometry::{Pose, Twist};
use cdpr_model::measurement::InternalSamples;
use cdpr_model::model::Model;
use cdpr_model::robot::{Parameter, ParameterKind, TrackedFrames};

/// Which rows a sample has, in this order: lengths, tensions, equilibrium, swivels, and what is measured of its pose.
#[derive(Clone, Debug)]
pub(crate) struct SensorLayout {
    pub(super) m: usize,
    pub(super) n: usize,
    /// Tensions are recorded and used.
    pub(super) has_tensions: bool,
    /// Tensions are unknowns in equilibrium with the load.
    pub(super) balances: bool,
    pub(super) has_swivels: bool,
    /// Components of a position.
    pub(super) translations: usize,
    /// Some of them are measured with an accuracy.
    pub(super) has_positions: bool,
    /// Orientations are measured with an accuracy.
    pub(super) has_rotations: bool,
}

impl SensorLayout {
    /// First row of a sensor's, and their number.
    pub(super) fn rows(&self, sensor: Sensor) -> (usize, usize) {
        let counts = [
            (Sensor::Length, self.m),
            (Sensor::Tension, if self.has_tensions { self.m } else { 0 }),
            (Sensor::Balance, if self.balances { self.n } else { 0 }),
            (Sensor::Swivel, if self.has_swivels { self.m } else { 0 }),
            (Sensor::Position, if self.has_positions { self.translations } else { 0 }),
            (Sensor::Rotation, if self.has_rotations { self.n - self.translations } else { 0 }),
        ];
        let before = counts.iter().take_while(|(other, _)| *other != sensor).map(|(_, count)| count).sum();
        let own = counts.iter().find(|(other, _)| *other == sensor).map_or(0, |(_, count)| *count);
        (before, own)
    }

    pub(crate) fn size(&self) -> usize {
        let (first, count) = self.rows(Sensor::Rotation);
        first + count
    }

    /// Row of a component of a pose, in the order of the pattern's directions; `None` where no component of its kind is measured.
    fn pose_row(&self, component: usize) -> Option<usize> {
        let (sensor, place) = match component.checked_sub(self.translations) {
            None => (Sensor::Position, component),
            Some(place) => (Sensor::Rotation, place),
        };
        let (first, count) = self.rows(sensor);
        (count > 0).then_some(first + place)
    }
}

/// Measurements at hand, with what is unknown of each sample's platform.
pub(super) struct SampleSensors<'a> {
    pub(super) internal: &'a InternalSamples,
    pub(super) layout: &'a SensorLayout,
    pub(super) weights: &'a Weights,
    /// Degrees of freedom of each sample's pose that are searched.
    pub(super) directions: &'a [Vec<Twist>],
}

/// SensorRows of one sample in standard deviations.
pub(super) struct SensorRows {
    pub(super) residuals: DVector<f64>,
    /// By the directions of the pose, then by the tensions.
    pub(super) by_latent: DMatrix<f64>,
}

impl SampleSensors<'_> {
    /// Unknowns of a sample.
    pub(super) fn unknowns(&self, sample: usize) -> usize {
        self.directions[sample].len() + if self.layout.balances { self.layout.m } else { 0 }
    }

    /// Residuals and derivatives at a pose with tensions, by rows of no parameters; `None` if a cable has no path.
    pub(super) fn rows(&self, rows: &RowModel<'_>, sample: usize, at: &Latent) -> Option<SensorRows> {
        let SensorLayout { m, n, balances, .. } = *self.layout;
        let (model, directions) = (rows.model, &self.directions[sample]);
        let recorded = Recorded::of(&self.internal.samples, sample);
        let (mut plain, mut noise) = (vec![0.0; n + m], Noise::new(model));
        rows.noise_at(&at.pose, &at.tensions, &UNITS, &mut noise, Some((recorded, &mut plain)));
        let size = self.layout.size();
        let mut all =
            SensorRows { residuals: DVector::zeros(size), by_latent: DMatrix::zeros(size, self.unknowns(sample)) };
        let places = places(model, directions);
        let (balance, _) = self.layout.rows(Sensor::Balance);
        // of the rows of elastic models the wrench comes first
        for row in 0..n + m {
            let (to, weight) = match row < n {
                true if balances => (balance + row, self.weights.balance(model, row)),
                true => continue,
                false => (row - n, self.weights.of(Sensor::Length)),
            };
            all.residuals[to] = weight * plain[row];
            for (column, place) in places.iter().enumerate() {
                all.by_latent[(to, column)] = weight * noise.by_pose[row][*place];
            }
            if balances {
                for (cable, by_tension) in noise.by_tension.iter().enumerate() {
                    let entry = match row < n {
                        true => by_tension[row],
                        false if row - n == cable => by_tension[n],
                        false => 0.0,
                    };
                    all.by_latent[(to, directions.len() + cable)] = weight * entry;
                }
            }
        }
        self.write_tensions(sample, at, &mut all);
        self.write_swivels(model, sample, at, &mut all)?;
        self.write_pose(model, sample, at, &mut all);
        all.residuals.iter().all(|number| number.is_finite()).then_some(all)
    }

    fn write_tensions(&self, sample: usize, at: &Latent, all: &mut SensorRows) {
        let (first, count) = self.layout.rows(Sensor::Tension);
        let weight = self.weights.of(Sensor::Tension);
        let recorded = Recorded::of(&self.internal.samples, sample).tensions();
        for cable in 0..count {
            all.residuals[first + cable] = weight * (at.tensions[cable] - recorded[cable]);
            all.by_latent[(first + cable, self.directions[sample].len() + cable)] = weight;
        }
    }

    fn write_swivels(&self, model: &Model, sample: usize, at: &Latent, all: &mut SensorRows) -> Option<()> {
        let (first, count) = self.layout.rows(Sensor::Swivel);
        let Some(angles) = self.internal.swivels.as_ref().filter(|_| count > 0) else { return Some(()) };
        let weight = self.weights.of(Sensor::Swivel);
        for cable in 0..count {
            let swivel = Swivel::of(model, cable, &at.pose)?;
            all.residuals[first + cable] = weight * swivel.minus(angles[sample * count + cable]);
            for (column, twist) in self.directions[sample].iter().enumerate() {
                all.by_latent[(first + cable, column)] = weight * swivel.by_twist(twist);
            }
        }
        Some(())
    }

    /// Components of a pose that are measured with an accuracy: place, row and weight along the pattern's directions.
    fn measured_components<'m>(&'m self, model: &'m Model, sample: usize) -> impl Iterator<Item = Measured<'m>> {
        let known = &self.internal.known[sample];
        let components = model.twist_basis().iter().zip(known).enumerate();
        components.filter(|(_, (_, is_known))| **is_known).filter_map(|(place, (along, _))| {
            let weight = self.weights.along(along, known);
            let row = self.layout.pose_row(place).filter(|_| weight > 0.0)?;
            Some(Measured { row, along, weight })
        })
    }

    fn write_pose(&self, model: &Model, sample: usize, at: &Latent, all: &mut SensorRows) {
        let Some(seen) = self.seen(model, sample, at) else { return };
        for Measured { row, along, weight } in self.measured_components(model, sample) {
            all.residuals[row] = weight * along.dot(&seen.error);
            for (column, twist) in self.directions[sample].iter().enumerate() {
                all.by_latent[(row, column)] = weight * along.dot(&seen.by_platform(twist));
            }
        }
    }

    /// The platform as the tracker sees it; `None` where no component of poses is measured.
    fn seen(&self, model: &Model, sample: usize, at: &Latent) -> Option<Seen> {
        if !(self.layout.has_positions || self.layout.has_rotations) {
            return None;
        }
        let frames = model.robot().tracked;
        let seen = frames.map_or(at.pose, |frames| frames.seen(&at.pose));
        let error = self.internal.samples.poses[sample].displacement_to(&seen);
        Some(Seen { by_turn: by_turn(&error), error, frames, platform: at.pose, rotation: at.pose.rotation_matrix() })
    }

    /// Derivatives by the parameters, a column each.
    pub(super) fn by_parameters(
        &self,
        rows: &RowModel<'_>,
        parameters: &[Parameter],
        sample: usize,
        at: &Latent,
    ) -> Option<DMatrix<f64>> {
        let SensorLayout { m, n, balances, .. } = *self.layout;
        let model = rows.model;
        let mut plain = SampleRows::new(model, parameters.len());
        rows.write(&at.pose, &at.tensions, Recorded::of(&self.internal.samples, sample), &mut plain);
        let mut all = DMatrix::zeros(self.layout.size(), parameters.len());
        let (balance, _) = self.layout.rows(Sensor::Balance);
        for (row, entries) in plain.derivatives().enumerate() {
            let (to, weight) = match row < n {
                true if balances => (balance + row, self.weights.balance(model, row)),
                true => continue,
                false => (row - n, self.weights.of(Sensor::Length)),
            };
            entries.iter().enumerate().for_each(|(column, entry)| all[(to, column)] = weight * entry);
        }
        if let Some(seen) = self.seen(model, sample, at) {
            for (column, parameter) in parameters.iter().enumerate().filter(|(_, own)| own.kind.is_of_recording()) {
                let change = seen.by_parameter(model, parameter);
                for Measured { row, along, weight } in self.measured_components(model, sample) {
                    all[(row, column)] = weight * along.dot(&change);
                }
            }
        }
        let (first, count) = self.layout.rows(Sensor::Swivel);
        let weight = self.weights.of(Sensor::Swivel);
        for cable in 0..count.min(m) {
            let swivel = Swivel::of(model, cable, &at.pose)?;
            for (column, parameter) in parameters.iter().enumerate().filter(|(_, own)| own.cable == cable) {
                all[(first + cable, column)] = weight * swivel.by_parameter(model, parameter);
            }
        }
        Some(all)
    }
}

/// A component of a pose that is measured with an accuracy.
struct Measured<'a> {
    row: usize,
    along: &'a Twist,
    /// 1/σ.
    weight: f64,
}

/// The platform as a tracker sees it at a pose, beside what it has measured.
struct Seen {
    /// From the measured pose to the one that it should see (its own axes).
    error: Twist,
    by_turn: Matrix3<f64>,
    /// `None` where it sees the platform in the robot's frame.
    frames: Option<TrackedFrames>,
    platform: Pose,
    rotation: Matrix3<f64>,
}

impl Seen {
    /// Change of the error by a motion in the tracker's axes.
    fn of(&self, moved: Twist) -> Twist {
        let turned = self.by_turn * moved.fixed_rows::<3>(3);
        let mut moved = moved;
        moved.fixed_rows_mut::<3>(3).copy_from(&turned);
        moved
    }

    fn by_platform(&self, twist: &Twist) -> Twist {
        let moved = |frames: TrackedFrames| frames.seen_by(&frames.by_platform(twist, &self.rotation));
        self.of(self.frames.map_or(*twist, moved))
    }

    /// Change of the error by a component of a frame.
    fn by_parameter(&self, model: &Model, parameter: &Parameter) -> Twist {
        let (Some(component), frames) =
            (model.robot().frame_component(parameter.axis), self.frames.unwrap_or_default())
        else {
            return Twist::zeros();
        };
        let moved = match parameter.kind {
            ParameterKind::TrackerFrame => frames.by_tracker(&component, &self.platform),
            _ => frames.by_marker(&component, &self.rotation),
        };
        self.of(frames.seen_by(&moved))
    }
}

/// Places of directions among those of the pattern.
fn places(model: &Model, directions: &[Twist]) -> Vec<usize> {
    let basis = model.twist_basis();
    directions.iter().filter_map(|twist| basis.iter().position(|own| own == twist)).collect()
}
