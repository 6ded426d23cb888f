//! Vectors of all sensors in a machine at poses that nobody measured: lengths, tensions in equilibrium with the load, swivel angles, and parts of poses.
//!
//! Each sample has its own pose and, where cables balance a load, its own tensions; both are eliminated sample by sample as in the vectors of lengths alone
//! (variable projection with the derivative of Kaufman 1975). Equilibrium is a row of great weight: what a load cell misses is an error of its tension.

mod accuracies;
mod rows;
mod seek;
mod settle;
mod swivel;
#[cfg(test)]
mod tests;

use nalgebra::{DMatrix, DVector};

use accuracies::is_turn;
pub(crate) use accuracies::{Sensor, Weights};
use rows::SampleSensors;
pub(crate) use rows::SensorLayout;
use settle::Settled;
pub(crate) use swivel::Swivel;

use super::balance::rows::RowModel;
use super::poseless::{guess, orthonormalise};
use super::rows::{Layout, Rows};
use super::{Latent, Poseless, Residual};
use cdpr_model::geometry::{Pose, Twist};
use cdpr_model::measurement::{InternalSamples, SensorSigmas};
use cdpr_model::model::Model;
use cdpr_model::robot::{Parameter, TrackedFrames};
use cdpr_model::statics::Load;

/// Residuals of all sensors at the poses and tensions where they agree best.
pub(crate) struct SensorResidual<'a> {
    model: Model,
    parameters: &'a [Parameter],
    internal: &'a InternalSamples,
    layout: SensorLayout,
    weights: Weights,
    directions: Vec<Vec<Twist>>,
    guesses: Vec<Latent>,
    /// Found last.
    found: Vec<Latent>,
    /// Samples whose search ended on the way where was written last.
    unsettled: usize,
    /// True once all samples have settled somewhere: from there on a place where one does not is none.
    has_settled: bool,
    /// True once these are no guesses.
    is_found: bool,
    /// True where the guesses were found before.
    are_guesses_found: bool,
    /// Share of each row's residual that its own pose and tensions take up, where was written last.
    leverages: DVector<f64>,
}

/// Rows of a model under a load: of no parameters, and of the free ones.
struct RowsOf<'a> {
    bare: RowModel<'a>,
    full: RowModel<'a>,
}

impl SensorLayout {
    /// Rows that a model's samples have; nothing of tensions where the load is not `balanced`.
    pub(crate) fn of(model: &Model, internal: &InternalSamples, balances: bool, weights: &Weights) -> Self {
        let is_measured = |known: &[bool], turns: bool| {
            let mut components = model.twist_basis().iter().zip(known);
            components.any(|(along, own)| *own && is_turn(along) == turns && weights.along(along, known) > 0.0)
        };
        let has = |turns: bool| internal.known.iter().any(|known| is_measured(known, turns));
        Self {
            m: model.cable_count(),
            n: model.dof(),
            has_tensions: balances && internal.samples.tensions.is_some(),
            balances,
            has_swivels: internal.swivels.is_some(),
            translations: model.robot().motion_pattern.translations(),
            has_positions: has(false),
            has_rotations: has(true),
        }
    }

    /// True where lengths are the only rows.
    pub(crate) fn has_only_lengths(&self) -> bool {
        !(self.balances || self.has_swivels || self.has_positions || self.has_rotations)
    }

    /// True where tensions are unknowns in equilibrium with the load.
    pub(crate) fn balances(&self) -> bool {
        self.balances
    }

    /// True where every accuracy is stated that weighs a row.
    pub(crate) fn are_stated(&self, stated: &SensorSigmas) -> bool {
        let weighed = [Sensor::Length, Sensor::Tension, Sensor::Swivel, Sensor::Position, Sensor::Rotation];
        weighed.into_iter().filter(|sensor| self.has(*sensor)).all(|sensor| sensor.is_stated(stated))
    }

    /// True where a sensor gives rows.
    pub(crate) fn has(&self, sensor: Sensor) -> bool {
        self.rows(sensor).1 > 0
    }

    /// Places of a sensor's rows among those of so many samples.
    pub(crate) fn places(&self, sensor: Sensor, samples: usize) -> impl Iterator<Item = usize> {
        let (first, count) = self.rows(sensor);
        let size = self.size();
        (0..samples).flat_map(move |sample| (0..count).map(move |row| sample * size + first + row))
    }

    /// The rows of a sample in words.
    pub(crate) fn words(&self) -> String {
        let named = [
            (Sensor::Length, "cable lengths"),
            (Sensor::Tension, "tensions"),
            (Sensor::Balance, "of equilibrium"),
            (Sensor::Swivel, "swivel angles"),
            (Sensor::Position, "components of a position"),
            (Sensor::Rotation, "of an orientation"),
        ];
        let told = |(sensor, name): (Sensor, &str)| {
            let (_, count) = self.rows(sensor);
            (count > 0).then(|| format!("{count} {name}"))
        };
        named.into_iter().filter_map(told).collect::<Vec<_>>().join(", ")
    }
}

impl<'a> SensorResidual<'a> {
    pub(crate) fn new(
        model: &Model,
        internal: &'a InternalSamples,
        parameters: &'a [Parameter],
        layout: &SensorLayout,
        weights: &Weights,
    ) -> Self {
        let home = model.robot().home_or_middle();
        // what is measured with an accuracy is searched, too
        let free = |known: &Vec<bool>| {
            let is_searched = |(twist, own): &(&Twist, &bool)| !**own || weights.along(twist, known) > 0.0;
            model.twist_basis().iter().zip(known).filter(is_searched).map(|(twist, _)| *twist).collect()
        };
        let m = model.cable_count();
        let tension = |sample: usize, cable: usize| match &internal.samples.tensions {
            Some(tensions) if layout.balances => tensions[sample * m + cable],
            _ => weights.typical,
        };
        let near = |sample: usize| {
            let (measured, known) = (&internal.samples.poses[sample], &internal.known[sample]);
            match &model.robot().tracked {
                Some(frames) => platform_near(frames, measured, known, &home),
                None => guess(model, measured, known, &home),
            }
        };
        let latent = |sample: usize| Latent {
            pose: near(sample),
            tensions: (0..m).map(|cable| tension(sample, cable)).collect(),
        };
        let guesses: Vec<Latent> = (0..internal.samples.len()).map(latent).collect();
        Self {
            directions: internal.known.iter().map(free).collect(),
            leverages: DVector::zeros(layout.size() * guesses.len()),
            found: guesses.clone(),
            is_found: false,
            unsettled: 0,
            has_settled: false,
            are_guesses_found: false,
            layout: layout.clone(),
            weights: *weights,
            model: model.clone(),
            parameters,
            internal,
            guesses,
        }
    }

    fn sensors(&self) -> SampleSensors<'_> {
        let Self { internal, layout, weights, directions, .. } = self;
        SampleSensors { internal, layout, weights, directions }
    }

    fn try_write(&mut self, values: &[f64], rows: &mut Rows) -> Option<()> {
        let model = self.model.with_parameters(self.parameters, values)?;
        let load = self.load(&model)?;
        // a trial that fails must not leave places behind that are none
        let before = self.found.clone();
        let is_written = self.write_all(&model, load, rows);
        if is_written.is_none() {
            (self.found, self.unsettled) = (before, 0);
            return None;
        }
        self.is_found = true;
        self.has_settled |= self.unsettled == 0;
        is_written
    }

    fn write_all(&mut self, model: &Model, load: Load, rows: &mut Rows) -> Option<()> {
        let has_masses = self.internal.masses.is_some() && self.layout.balances;
        let mut rows_of = self.rows_of(model, load, 0);
        self.unsettled = 0;
        for sample in 0..self.guesses.len() {
            if has_masses {
                rows_of = self.rows_of(model, load, sample);
            }
            let found = self.find(&rows_of.bare, sample)?;
            self.unsettled += usize::from(!found.is_least);
            if self.has_settled && self.unsettled > 0 {
                return None;
            }
            self.found[sample] = found.latent;
            self.write_sample(&rows_of, sample, rows)?;
        }
        Some(())
    }

    /// The load that cables balance; none where equilibrium is no row.
    fn load(&self, model: &Model) -> Option<Load> {
        if self.layout.balances { Load::of(model.robot()).ok() } else { Some(Load::constant(nalgebra::zero())) }
    }

    /// Rows of a sample under the load, of its own mass where the record states one.
    fn rows_of<'m>(&self, model: &'m Model, load: Load, sample: usize) -> RowsOf<'m>
    where
        'a: 'm,
    {
        let masses = self.internal.masses.as_ref().filter(|_| self.layout.balances);
        let load = masses.map_or(load, |masses| load.with_mass(model.robot(), masses[sample]));
        RowsOf { bare: RowModel::new(model, load, &[]), full: RowModel::new(model, load, self.parameters) }
    }

    /// Pose and tensions of a sample: near those found last, or the best of searches from the guess and from the sample before.
    fn find(&self, rows: &RowModel<'_>, sample: usize) -> Option<Settled> {
        let sensors = self.sensors();
        let from = |latent: &Latent| sensors.settle(rows, sample, latent);
        let near = if self.is_found { from(&self.found[sample]) } else { None };
        if let Some(near) = near.as_ref().filter(|near| near.is_least) {
            return Some(near.clone());
        }
        let guess = &self.guesses[sample];
        // load cells that are wrong by far lead searches astray before they know where they are
        let relaxed = self.weights.relaxed();
        let relaxed = SampleSensors { weights: &relaxed, ..self.sensors() };
        let is_use = |end: &Settled| end.is_least || !self.has_settled;
        let by_geometry = |latent: &Latent| from(&relaxed.settle(rows, sample, latent).filter(is_use)?.latent);
        let before = sample.checked_sub(1).map(|before| self.placed(sample, &self.found[before].pose));
        let starts: Vec<Latent> = std::iter::once(guess.clone()).chain(before).collect();
        let ends = starts.iter().flat_map(|latent| [from(latent), by_geometry(latent)]).flatten();
        near.into_iter().chain(ends).reduce(Settled::better)
    }

    /// The sample near the pose of another one, with the components that its own record states exactly.
    fn placed(&self, sample: usize, near: &Pose) -> Latent {
        let (guessed, known) = (&self.guesses[sample], &self.internal.known[sample]);
        let is_exact = |(twist, own): (&Twist, &bool)| *own && self.weights.along(twist, known) == 0.0;
        let exact: Vec<bool> = self.model.twist_basis().iter().zip(known).map(is_exact).collect();
        Latent { pose: guess(&self.model, &guessed.pose, &exact, near), ..guessed.clone() }
    }

    /// Rows of a sample without what its pose and tensions explain.
    fn write_sample(&mut self, of: &RowsOf<'_>, sample: usize, rows: &mut Rows) -> Option<()> {
        let (sensors, at) = (self.sensors(), &self.found[sample]);
        let size = self.layout.size();
        let mut own = sensors.rows(&of.bare, sample, at)?;
        let mut by_parameters = sensors.by_parameters(&of.full, self.parameters, sample, at)?;
        let unknowns = own.by_latent.ncols();
        // twice is enough for right angles to rounding, whatever the weights
        orthonormalise(&mut own.by_latent, unknowns);
        orthonormalise(&mut own.by_latent, unknowns);
        for _ in 0..2 {
            let explained: DMatrix<f64> = own.by_latent.tr_mul(&by_parameters);
            by_parameters -= &own.by_latent * explained;
        }
        let leverages = DVector::from_fn(size, |row, _| own.by_latent.row(row).norm_squared());
        self.leverages.rows_mut(sample * size, size).copy_from(&leverages);
        rows.residuals.rows_mut(sample * size, size).copy_from(&own.residuals);
        rows.jacobian.rows_mut(sample * size, size).copy_from(&by_parameters);
        Some(())
    }

    /// Rows that are none: parts of poses that are not measured.
    fn absent(&self) -> usize {
        let count: usize =
            [Sensor::Position, Sensor::Rotation].into_iter().map(|sensor| self.layout.rows(sensor).1).sum();
        let own = |known: &Vec<bool>| measured_count(&self.model, &self.weights, known).min(count);
        self.internal.known.iter().map(|known| count - own(known)).sum()
    }
}

/// Parts of a pose that are measured with an accuracy.
fn measured_count(model: &Model, weights: &Weights, known: &[bool]) -> usize {
    let is_row = |(twist, own): &(&Twist, &bool)| **own && weights.along(twist, known) > 0.0;
    model.twist_basis().iter().zip(known).filter(is_row).count()
}

/// Pose of the platform from which searches begin where a tracker has measured some components of its own: the others are those of the home pose.
fn platform_near(frames: &TrackedFrames, measured: &Pose, known: &[bool], home: &Pose) -> Pose {
    let turns_known = known.get(3..).is_some_and(|turns| turns.iter().any(|known| *known));
    let (tracker, marker) = (frames.tracker.pose(), frames.marker.pose());
    let rotation = match turns_known {
        true => tracker.rotation * measured.rotation * marker.rotation.inverse(),
        false => home.rotation,
    };
    let position = tracker.transform(&measured.position) - rotation * marker.position;
    let is_placed = known.iter().take(3).all(|known| *known);
    Pose { position: if is_placed { position } else { home.position }, rotation }
}

impl Poseless for SensorResidual<'_> {
    fn poses(&self) -> Vec<Pose> {
        self.found.iter().map(|latent| latent.pose).collect()
    }

    fn begin_at(&mut self, poses: &[Pose]) {
        (self.is_found, self.are_guesses_found) = (true, true);
        for latents in [&mut self.guesses, &mut self.found] {
            latents.iter_mut().zip(poses).for_each(|(latent, pose)| latent.pose = *pose);
        }
    }

    fn unsettled(&self) -> usize {
        self.unsettled
    }

    fn leverages(&self) -> Vec<f64> {
        self.leverages.as_slice().to_vec()
    }
}

impl Residual for SensorResidual<'_> {
    fn layout(&self) -> Layout {
        let sensors = self.sensors();
        let of_samples: usize = (0..self.guesses.len()).map(|sample| sensors.unknowns(sample)).sum();
        Layout::of(self.guesses.len(), self.layout.size()).eliminating(of_samples + self.absent())
    }

    fn model(&self) -> &Model {
        &self.model
    }

    fn is_absolute(&self) -> bool {
        self.layout.are_stated(&self.internal.samples.sigmas)
    }

    fn restart(&mut self) {
        self.found.clone_from(&self.guesses);
        (self.is_found, self.unsettled) = (self.are_guesses_found, 0);
    }

    fn seek_again(&mut self, values: &[f64]) -> bool {
        self.find_better(values).unwrap_or(false)
    }

    fn latents(&self) -> Vec<Latent> {
        self.found.clone()
    }

    fn go_on_from(&mut self, latents: &[Latent]) {
        self.found.clone_from_slice(latents);
        (self.is_found, self.unsettled) = (true, 0);
    }

    fn write(&mut self, values: &[f64], rows: &mut Rows) -> bool {
        self.try_write(values, rows).is_some() && rows.is_finite()
    }
}
