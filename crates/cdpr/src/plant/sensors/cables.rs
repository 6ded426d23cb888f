//! Sensors that share the winches' clock: encoders, load pins, swivels, and the inclinometer where no tracker sees the platform.

use std::fmt::Write;

use super::signal::{Clock, LowPass, Noise, counted};
use super::table::{EncoderTable, InclinometerTable, LoadPinTable, SensorTable, SwivelTable};
use crate::geometry::{Pose, Twist};
use crate::measurement::{turn_columns, turn_numbers};
use crate::model::Model;
use crate::plant::plant::Plant;
use crate::plant::state::State;

/// Random streams of the sensors.
const LOAD_PINS: u64 = 1;
const SWIVELS: u64 = 2;
const INCLINOMETER: u64 = 3;

/// Encoders, load pins, swivels and inclinometer with their rows.
#[derive(Clone, Debug)]
pub(super) struct CableSensors {
    clock: Clock,
    encoders: Option<EncoderTable>,
    load_pins: Option<(LoadPinTable, Vec<LowPass>, Noise)>,
    swivels: Option<(SwivelTable, Noise)>,
    inclinometer: Option<(InclinometerTable, Noise)>,
    /// Time of the last look (s).
    last: f64,
    rows: Vec<Row>,
}

/// Readings of all of them at a time.
#[derive(Clone, Debug)]
struct Row {
    time: f64,
    pose: Option<Pose>,
    lengths: Vec<f64>,
    tensions: Vec<f64>,
    swivels: Vec<f64>,
}

impl CableSensors {
    /// `None` where the scenario has none of them.
    pub(super) fn new(table: &SensorTable, model: &Model) -> Option<Self> {
        let noise = |stream| Noise::new(table.seed, stream);
        let pins = table.load_pins.clone().map(|pins| {
            let filters = vec![LowPass::new(pins.bandwidth_Hz); model.cable_count()];
            (pins, filters, noise(LOAD_PINS))
        });
        let sensors = Self {
            clock: Clock::new(table.rate_Hz),
            encoders: table.encoders.clone(),
            load_pins: pins,
            swivels: table.swivels.map(|swivels| (swivels, noise(SWIVELS))),
            inclinometer: table.inclinometer.map(|inclinometer| (inclinometer, noise(INCLINOMETER))),
            last: 0.0,
            rows: Vec::new(),
        };
        let is_there = sensors.encoders.is_some()
            || sensors.load_pins.is_some()
            || sensors.swivels.is_some()
            || sensors.inclinometer.is_some();
        is_there.then_some(sensors)
    }

    pub(super) fn look(&mut self, plant: &Plant, state: &State) {
        let time = state.time - self.last;
        self.last = state.time;
        // amplifiers follow between the rows too
        if let Some((_, filters, _)) = &mut self.load_pins {
            filters.iter_mut().zip(&state.cables).for_each(|(filter, cable)| filter.pass(cable.tension, time));
        }
        if !self.clock.is_due(state.time) {
            return;
        }
        let row = Row {
            time: state.time,
            pose: self.inclinometer.as_mut().map(|(table, noise)| turned(&state.pose, plant.model(), table, noise)),
            lengths: self.lengths(plant.model(), state),
            tensions: self.tensions(plant.model()),
            swivels: self.swivel_angles(plant.model(), state),
        };
        self.rows.push(row);
    }

    fn lengths(&self, model: &Model, state: &State) -> Vec<f64> {
        let Some(encoders) = &self.encoders else { return Vec::new() };
        let lost = |cable: usize| -> f64 {
            let lost = encoders.loss.iter().filter(|loss| loss.cable == cable + 1 && loss.time_s < state.time);
            lost.map(|loss| loss.length_m).sum()
        };
        let length = |(index, cable): (usize, &crate::plant::CableMotion)| {
            let recorded = model.recorded_length(index, cable.controlled_length);
            counted(recorded, encoders.resolution_m) - lost(index)
        };
        state.cables.iter().enumerate().map(length).collect()
    }

    fn tensions(&mut self, model: &Model) -> Vec<f64> {
        let Some((table, filters, noise)) = &mut self.load_pins else { return Vec::new() };
        let shown = |(index, filter): (usize, &LowPass)| {
            let bias = table.bias_N.as_ref().map_or(0.0, |bias| bias[index]);
            let shown = model.recorded_tension(index, filter.output()) + bias + noise.of(table.noise_N);
            table.range_N.map_or(shown, |range| shown.clamp(0.0, range))
        };
        filters.iter().enumerate().map(shown).collect()
    }

    fn swivel_angles(&mut self, model: &Model, state: &State) -> Vec<f64> {
        let Some((table, noise)) = &mut self.swivels else { return Vec::new() };
        let angle = |cable: usize| {
            let angle = swivel_angle(model, cable, &state.pose).unwrap_or(f64::NAN);
            counted(angle + noise.of(table.noise_rad), table.resolution_rad)
        };
        (0..model.cable_count()).map(angle).collect()
    }

    /// Rows per second, and numbers in a row.
    pub(super) fn rate_and_columns(&self, model: &Model) -> (f64, usize) {
        let kinds = [self.encoders.is_some(), self.load_pins.is_some(), self.swivels.is_some()];
        let of_cables = kinds.into_iter().filter(|is_there| *is_there).count() * model.cable_count();
        let turn = if self.inclinometer.is_some() { turn_columns(model.robot().motion_pattern).len() } else { 0 };
        (self.clock.rate(), 1 + of_cables + turn)
    }

    /// Columns of measurement files.
    pub(super) fn csv(&self, plant: &Plant) -> String {
        let model = plant.model();
        let (robot, cables) = (model.robot(), 1..=model.cable_count());
        let mut names = vec!["t_s".to_owned()];
        if self.inclinometer.is_some() {
            names.extend(turn_columns(robot.motion_pattern).iter().map(|name| (*name).to_owned()));
        }
        let mut of_cables = |is_there: bool, stem: &str| {
            names.extend(cables.clone().filter(|_| is_there).map(|cable| format!("{stem}_{cable}")));
        };
        of_cables(self.encoders.is_some(), "cable_length_m");
        of_cables(self.load_pins.is_some(), "tension_N");
        of_cables(self.swivels.is_some(), "swivel_rad");
        let mut text = names.join(",") + "\n";
        for row in &self.rows {
            let _ = write!(text, "{}", row.time);
            let turn = row.pose.as_ref().map(|pose| turn_numbers(robot, pose)).unwrap_or_default();
            for value in turn.iter().chain(&row.lengths).chain(&row.tensions).chain(&row.swivels) {
                // a swivel whose angle is not determined shows nothing
                let _ = if value.is_nan() { write!(text, ",") } else { write!(text, ",{}", value + 0.0) };
            }
            text.push('\n');
        }
        text
    }
}

/// Angle of a pulley's swivel, right-handed about its axis from the direction of gravity (rad); `None` for one that does not swivel, and without gravity.
pub(super) fn swivel_angle(model: &Model, cable: usize, pose: &Pose) -> Option<f64> {
    model.swivel_angle(cable, pose, &model.robot().gravity?)
}

fn turned(pose: &Pose, model: &Model, table: &InclinometerTable, noise: &mut Noise) -> Pose {
    let turns = model.twist_basis().iter().filter(|basis| basis.fixed_rows::<3>(3).norm() > 0.0);
    let error: Twist = turns.map(|basis| basis * noise.of(table.noise_rad)).sum();
    pose.displaced(&error)
}
