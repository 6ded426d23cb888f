//! The layers of cable on a drum: their beginnings and ends, and the drum's law within each.

use std::f64::consts::TAU;

use nalgebra::Vector3;

use super::parameters::{DrumLength, Mounting, Parameters};
use super::turns::{FirstPulley, Turns};

/// Largest number of layers.
const LAYER_LIMIT: usize = 16;

/// One layer of cable.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Layer {
    pub(super) turns: Turns<f64>,
    /// State at φ = 0: the full end of the first layer, the empty end of those above, at which the layer below is full.
    start: DrumFill,
    /// State at the other end of the groove: the empty end of the first layer, the full end of those above.
    end: DrumFill,
    is_first: bool,
    mounting: Option<Mounting>,
}

/// Drum angle and controlled length at one end of a layer, with derivatives.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct DrumFill {
    /// Drum angle (rad).
    pub(super) angle: f64,
    angle_by_pitch: f64,
    /// Controlled length (m).
    pub(super) length: f64,
    by_radius: f64,
    by_pitch: f64,
    by_pulley: Vector3<f64>,
    by_axis: Vector3<f64>,
    /// Position of the contact point along the axis, from the drum's position (m).
    along: f64,
}

/// The first layer, and those above it for which the drum has room.
pub(super) fn layers(drum: &Parameters) -> Vec<Layer> {
    let start = DrumFill {
        angle: drum.start_angle,
        angle_by_pitch: 0.0,
        length: drum.start_length,
        by_radius: 0.0,
        by_pitch: 0.0,
        by_pulley: Vector3::zeros(),
        by_axis: Vector3::zeros(),
        along: 0.0,
    };
    let mut layers = vec![Layer::new(drum, 0, start)];
    let Some(height) = drum.layer_height.filter(|_| drum.groove_length.is_some()) else { return layers };
    let room = drum.mounting.map_or(f64::INFINITY, |mounting| mounting.pulley_from_axis().0);
    let mut start = start;
    for number in 1..LAYER_LIMIT {
        if drum.radius + number as f64 * height >= room {
            break;
        }
        let layer = Layer::new(drum, number, start);
        start = layer.end;
        layers.push(layer);
    }
    layers
}

impl Layer {
    /// Layer `number`, counted from 0, from the state at φ = 0.
    fn new(drum: &Parameters, number: usize, start: DrumFill) -> Self {
        let is_first = number == 0;
        let radius = drum.radius + number as f64 * drum.layer_height.unwrap_or(0.0);
        // layers run back and forth: while they are paid out, the first and every second one move along the axis
        let travel = if number.is_multiple_of(2) { drum.pitch / TAU } else { -drum.pitch / TAU };
        let pulley = drum.mounting.map(|mounting| {
            let (distance, place) = mounting.pulley_from_axis();
            FirstPulley { distance_squared: distance * distance, contact: start.along - place }
        });
        let turns = Turns { radius, travel, pulley, build_up: drum.build_up };
        let mut layer = Self { turns, start, end: start, is_first, mounting: drum.mounting };
        let sign = if is_first { 1.0 } else { -1.0 };
        // a spool is empty at the angle at which its radius would be zero
        let empty = if drum.build_up > 0.0 { 2.0 * drum.radius / drum.build_up } else { f64::INFINITY };
        let turn = drum.groove_length.map_or(empty, |length| TAU * length / drum.pitch);
        layer.end = layer.end_after(sign * turn, drum.pitch);
        layer
    }

    /// State at the other end of the layer, a turn φ = ±2π G/p away.
    fn end_after(&self, turn: f64, pitch: f64) -> DrumFill {
        if !turn.is_finite() {
            return DrumFill { angle: turn, length: turn, ..self.start };
        }
        let angle = self.start.angle + turn;
        let at_fixed_angle = self.gradient(angle);
        let angle_by_pitch = self.start.angle_by_pitch - turn / pitch;
        DrumFill {
            angle,
            angle_by_pitch,
            length: at_fixed_angle.value,
            by_radius: at_fixed_angle.by_radius,
            by_pitch: at_fixed_angle.by_pitch + at_fixed_angle.by_angle * angle_by_pitch,
            by_pulley: at_fixed_angle.by_pulley,
            by_axis: at_fixed_angle.by_axis,
            along: self.along(angle),
        }
    }

    /// State at which the layer is full of cable: its least angle and length.
    #[inline]
    pub(super) fn full(&self) -> DrumFill {
        match self.is_first && self.end.angle.is_finite() && self.turns.build_up == 0.0 {
            true => self.start,
            // without ends, or on a spool, the first layer has no full end
            false if self.is_first => DrumFill { angle: f64::NEG_INFINITY, length: f64::NEG_INFINITY, ..self.start },
            false => self.end,
        }
    }

    /// State at which the layer is empty: its largest angle and length.
    #[inline]
    pub(super) fn empty(&self) -> DrumFill {
        if self.is_first { self.end } else { self.start }
    }

    /// Position of the contact point along the axis, from the drum's position (m).
    pub(super) fn along(&self, angle: f64) -> f64 {
        self.start.along + self.turns.travel * (angle - self.start.angle)
    }

    /// Controlled length at a drum angle of this layer (m).
    #[inline]
    pub(super) fn length(&self, angle: f64) -> f64 {
        self.start.length + self.turns.paid_out(angle - self.start.angle)
    }

    /// Drum angle at a controlled length of this layer (rad).
    #[inline]
    pub(super) fn angle(&self, length: f64) -> f64 {
        self.start.angle + self.turns.turn(length - self.start.length)
    }

    /// [`Layer::length`] with its derivatives.
    pub(super) fn gradient(&self, angle: f64) -> DrumLength {
        let paid = self.turns.gradient(angle - self.start.angle);
        let sign = self.turns.travel.signum();
        let (by_pulley, by_axis) = self.mounting.map_or_else(Default::default, |mounting| {
            let (_, place) = mounting.pulley_from_axis();
            let from = mounting.pulley - mounting.position;
            let across = from - mounting.axis * place;
            let by_pulley = across * (2.0 * paid.by_distance_squared) - mounting.axis * paid.by_contact;
            // d² = from² − (n·from)², w = … − n·from
            (by_pulley, -from * (2.0 * place * paid.by_distance_squared + paid.by_contact))
        });
        DrumLength {
            value: self.start.length + paid.value,
            by_angle: paid.by_turn,
            by_radius: self.start.by_radius + paid.by_radius,
            by_pitch: self.start.by_pitch - paid.by_turn * self.start.angle_by_pitch + sign * paid.by_travel / TAU,
            by_build_up: paid.by_build_up,
            by_start_length: 1.0,
            by_pulley: self.start.by_pulley + by_pulley,
            by_axis: self.start.by_axis + by_axis,
        }
    }
}
