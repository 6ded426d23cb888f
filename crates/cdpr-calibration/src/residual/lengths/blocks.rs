//! The least-squares problem of one cable: its own parameters, its own column of recorded lengths.

#[cfg(test)]
mod tests;

use super::further::{FURTHER, Turns, further_place};
use super::further_columns::further_column;
use super::normal_equations::{Columns, NormalEquations, Sums, exact};
use super::pose_lanes::{CableValues, PoseLanes};
use super::recordings::{Recorder, Recordings};
use super::weights::Weights;
use crate::unit_scale::UnitScale;
use cdpr_model::measurement::Samples;
use cdpr_model::model::Model;
use cdpr_model::robot::{Parameter, ParameterKind};
use cdpr_model::scalar::{Kernel, LANES, Lanes, dispatch};

/// Parameters a cable can have in the kernels: two anchors of three components, offset, scale, pulley radius, drum radius, start length.
pub(crate) const SLOTS: usize = 11;

/// Those of them that are none of drums: frame anchor, platform anchor, offset, scale, pulley radius.
pub(crate) const LENGTH_SLOTS: usize = 9;

/// The block of one cable.
pub(crate) struct Block {
    pub(crate) cable: usize,
    pub(crate) parameters: Vec<Parameter>,
    /// Place of each parameter in a row of [`SLOTS`] derivatives, or behind it.
    slots: Vec<usize>,
    turns: Turns,
    unit_scale: UnitScale,
    pub(crate) start: CableValues,
    /// Recorded lengths, padded (m).
    recorded: Vec<f64>,
    /// Law from motor angles (rad) to recorded lengths (m), where a free parameter changes it.
    recorder: Option<Recorder>,
    /// 1/σ of each residual, 0 in the padding (1/m).
    weights: Vec<f64>,
}

impl Block {
    pub(crate) fn new(
        model: &Model,
        cable: usize,
        parameters: Vec<Parameter>,
        samples: &Samples,
        weights: &Weights,
    ) -> Self {
        Self { weights: weights.of_cable(cable).to_vec(), ..Self::unweighted(model, cable, parameters, samples) }
    }

    /// Its parameters and recorded lengths, without weights of residuals.
    pub(crate) fn unweighted(model: &Model, cable: usize, parameters: Vec<Parameter>, samples: &Samples) -> Self {
        let count = samples.len();
        let mut recorded = Vec::with_capacity(count.next_multiple_of(LANES));
        recorded.extend(samples.lengths.iter().skip(cable).step_by(model.cable_count()));
        recorded.resize(count.next_multiple_of(LANES), recorded.last().copied().unwrap_or(0.0));
        let mean_length = recorded.iter().sum::<f64>() / recorded.len() as f64;
        Self {
            cable,
            turns: Turns::of(model, cable, &parameters),
            unit_scale: UnitScale::of(&model.robot().cables[cable], mean_length),
            slots: parameters.iter().map(|parameter| slot(model, parameter)).collect(),
            recorder: Recorder::of(model, cable, &parameters, samples),
            parameters,
            start: CableValues::of(model, cable),
            recorded,
            weights: Vec::new(),
        }
    }

    /// Weighs the residuals anew.
    pub(crate) fn set_weights(&mut self, weights: &Weights) {
        self.weights.copy_from_slice(weights.of_cable(self.cable));
    }

    /// Weighs the residuals anew, those of each sample times a factor.
    pub(crate) fn set_weights_times(&mut self, weights: &Weights, factors: &[f64]) {
        let own = weights.of_cable(self.cable).iter().zip(factors);
        self.weights.iter_mut().zip(own).for_each(|(target, (weight, factor))| *target = weight * factor);
    }

    /// Adds the squares of the residuals at `values` with other weights to those of each sample, padding included.
    pub(crate) fn add_squares(&self, poses: &PoseLanes, values: &CableValues, weights: &Weights, squares: &mut [f64]) {
        let recordings = self.recorder.as_ref().map(|recorder| recorder.at(values));
        let recorded = recordings.as_ref().map_or(&self.recorded, |changed| &changed.lengths);
        dispatch(AddSquares { poses, values, recorded, weights: weights.of_cable(self.cable), squares });
    }

    /// Metres that one unit of a parameter is worth.
    pub(crate) fn scale(&self, kind: ParameterKind) -> f64 {
        self.unit_scale.metres(kind)
    }

    /// The cable's values after moving the block's parameters by `change`.
    pub(crate) fn moved(&self, from: &CableValues, change: &[f64]) -> CableValues {
        let mut values = *from;
        for (&slot, &amount) in self.slots.iter().zip(change) {
            number(&mut values, slot).into_iter().for_each(|number| *number += amount);
        }
        self.turns.turn_pulley(&mut values.outlet, &values.further);
        values
    }

    /// The cable's values where the block's parameters have these.
    pub(crate) fn at(&self, values: &[f64]) -> CableValues {
        let mut change = [0.0; SLOTS + FURTHER];
        let changes = values.iter().zip(self.values(&self.start)).map(|(to, from)| to - from);
        change.iter_mut().zip(changes).for_each(|(target, change)| *target = change);
        self.moved(&self.start, &change[..values.len()])
    }

    /// Current values of the block's parameters.
    pub(crate) fn values(&self, values: &CableValues) -> impl Iterator<Item = f64> {
        let mut values = *values;
        self.slots.iter().map(move |&slot| number(&mut values, slot).map_or(0.0, |number| *number))
    }

    /// Weighted normal equations at `values`.
    pub(crate) fn normal<const P: usize>(&self, poses: &PoseLanes, values: &CableValues) -> NormalEquations<P> {
        let recordings = self.recorder.as_ref().map(|recorder| recorder.at(values));
        let recordings = recordings.as_ref();
        if self.is_wide() {
            let (residuals, columns) = self.rows_at(poses, values, recordings);
            return NormalEquations::of_columns(&residuals, &columns);
        }
        let sums = Accumulate::<P> { block: self, poses, values, recordings };
        // what is chosen most often has a kernel of its own, where nothing is computed in vain
        match P {
            3 | 6 | 8 if self.slots.iter().copied().eq(0..P) => dispatch(InOrder(sums)),
            _ => dispatch(sums),
        }
    }

    /// Weighted residuals and the columns of the weighted Jacobian, for analysis after the fit.
    pub(crate) fn rows(&self, poses: &PoseLanes, values: &CableValues, count: usize) -> (Vec<f64>, Columns) {
        let recordings = self.recorder.as_ref().map(|recorder| recorder.at(values));
        let (mut residuals, mut columns) = self.rows_at(poses, values, recordings.as_ref());
        residuals.truncate(count);
        columns.iter_mut().for_each(|column| column.truncate(count));
        (residuals, columns)
    }

    /// True where parameters are free that the kernels do not know.
    fn is_wide(&self) -> bool {
        self.slots.iter().any(|&slot| slot >= SLOTS)
    }

    /// [`Block::rows`] with those of the padding.
    fn rows_at(&self, poses: &PoseLanes, values: &CableValues, recordings: Option<&Recordings>) -> (Vec<f64>, Columns) {
        let (residuals, mut columns) = dispatch(WriteRows { block: self, poses, values, recordings });
        for (column, &slot) in columns.iter_mut().zip(&self.slots).filter(|(_, slot)| **slot >= SLOTS) {
            *column = further_column(slot - SLOTS, &self.turns, values, poses, &self.weights, recordings);
        }
        (residuals, columns)
    }

    /// Places of the parameters in a row of derivatives; `None` if the row has places of drums or further ones.
    pub(crate) fn places_of_lengths(&self) -> Option<&[usize]> {
        let is_known = self.recorder.is_none() && self.slots.iter().all(|&slot| slot < LENGTH_SLOTS);
        is_known.then_some(&*self.slots)
    }

    /// Recorded lengths, padded (m).
    pub(crate) fn recorded(&self) -> &[f64] {
        &self.recorded
    }

    /// 1/σ of each residual, padding included (1/m).
    pub(crate) fn weights(&self) -> &[f64] {
        &self.weights
    }
}

/// Weighted residual and the derivatives by every slot for one group of samples, the residual first.
type Row = [[f64; LANES]; 1 + SLOTS];

/// Groups of samples whose rows are made in one call.
const ROWS: usize = 6;

/// Rows for some groups of samples in succession: what all sums share, compiled once.
struct Rows<'a> {
    block: &'a Block,
    poses: &'a PoseLanes,
    values: &'a CableValues,
    recordings: Option<&'a Recordings>,
    first: usize,
    /// Filled.
    rows: &'a mut [Row],
}

impl Kernel for Rows<'_> {
    type Output = ();

    #[inline(always)]
    fn run<L: Lanes>(self, l: L) {
        let Self { block, poses, values, recordings, first, rows } = self;
        for (group, target) in (first..).zip(rows) {
            let (residual, row) = block.row(l, poses, values, recordings, group);
            residual.store(&mut target[0]);
            for (target, entry) in target[1..].iter_mut().zip(&row) {
                entry.store(target);
            }
        }
    }
}

impl Block {
    /// Weighted residual and the derivatives by every slot for one group of samples.
    #[inline(always)]
    fn row<L: Lanes>(
        &self,
        l: L,
        poses: &PoseLanes,
        values: &CableValues,
        recordings: Option<&Recordings>,
        group: usize,
    ) -> (L, [L; SLOTS]) {
        let (position, rotation) = poses.at(l, group);
        let (path, _) = values.path(position, &rotation);
        let weight = l.load(&self.weights[group * LANES..]);
        let first = group * LANES;
        let recorded = l.load(&recordings.map_or(&self.recorded, |changed| &changed.lengths)[first..]);
        let scale = l.constant(values.scale);
        let mut row = [l.constant(0.0); SLOTS];
        row[..9].copy_from_slice(&path.recorded_length_row(&rotation, weight, scale));
        if let Some(recordings) = recordings {
            for (entry, by_anchor) in row.iter_mut().zip(&recordings.by_anchor) {
                *entry = *entry - weight * l.load(&by_anchor[first..]);
            }
            row[9] = -(weight * l.load(&recordings.by_radius[first..]));
            row[10] = -weight;
        }
        (weight * (scale * path.length + l.constant(values.offset) - recorded), row)
    }
}

/// Squares of one cable's weighted residuals, added to those of each sample.
struct AddSquares<'a> {
    poses: &'a PoseLanes,
    values: &'a CableValues,
    recorded: &'a [f64],
    weights: &'a [f64],
    squares: &'a mut [f64],
}

impl Kernel for AddSquares<'_> {
    type Output = ();

    #[inline(always)]
    fn run<L: Lanes>(self, l: L) {
        let Self { poses, values, recorded, weights, squares } = self;
        let (scale, offset) = (l.constant(values.scale), l.constant(values.offset));
        for group in 0..poses.groups() {
            let first = group * LANES;
            let (position, rotation) = poses.at(l, group);
            let (path, _) = values.path(position, &rotation);
            let residual = scale * path.length + offset - l.load(&recorded[first..]);
            let weighted = l.load(&weights[first..]) * residual;
            (l.load(&squares[first..]) + weighted * weighted).store(&mut squares[first..]);
        }
    }
}

/// Anchors of every motion pattern move along axes of the world: the component is the place.
fn slot(model: &Model, parameter: &Parameter) -> usize {
    if let Some(place) = further_place(parameter) {
        return SLOTS + place;
    }
    match parameter.kind {
        ParameterKind::FrameAnchor => model.axes()[parameter.axis].iamax(),
        ParameterKind::PlatformAnchor => 3 + model.axes()[parameter.axis].iamax(),
        ParameterKind::LengthOffset => 6,
        ParameterKind::LengthScale => 7,
        ParameterKind::PulleyRadius => 8,
        ParameterKind::DrumRadius => 9,
        _ => 10,
    }
}

/// The number behind a place of a row; `None` for the radius of a cable without pulley.
fn number(values: &mut CableValues, slot: usize) -> Option<&mut f64> {
    match slot {
        0..3 => Some(&mut values.outlet.frame_anchor_mut()[slot]),
        3..6 => Some(&mut values.platform_anchor[slot - 3]),
        6 => Some(&mut values.offset),
        7 => Some(&mut values.scale),
        8 => values.outlet.radius_mut(),
        9 => Some(&mut values.drum_radius),
        10 => Some(&mut values.start_length),
        _ => Some(&mut values.further[slot - SLOTS]),
    }
}

/// The sums over all samples.
pub(crate) struct Accumulate<'a, const P: usize> {
    pub(crate) block: &'a Block,
    pub(crate) poses: &'a PoseLanes,
    pub(crate) values: &'a CableValues,
    pub(crate) recordings: Option<&'a Recordings>,
}

/// The same sums where the free parameters are the first P places of a row, in order.
struct InOrder<'a, const P: usize>(Accumulate<'a, P>);

impl<const P: usize> Kernel for InOrder<'_, P> {
    type Output = NormalEquations<P>;

    #[inline(always)]
    fn run<L: Lanes>(self, l: L) -> NormalEquations<P> {
        let Accumulate { block, poses, values, recordings } = self.0;
        let mut sums = Sums::new(l, P);
        for group in 0..poses.groups() {
            let (residual, row) = block.row(l, poses, values, recordings, group);
            let mut entries = [l; P];
            entries.copy_from_slice(&row[..P]);
            sums.add(residual, &entries);
        }
        sums.total()
    }
}

impl<const P: usize> Kernel for Accumulate<'_, P> {
    type Output = NormalEquations<P>;

    #[inline(always)]
    fn run<L: Lanes>(self, l: L) -> NormalEquations<P> {
        let Self { block, poses, values, recordings } = self;
        let count = exact::<P>(block.slots.len());
        let mut slots = [0; P];
        slots[..count].copy_from_slice(&block.slots);
        let mut sums = Sums::new(l, count);
        let mut rows = [[[0.0; LANES]; 1 + SLOTS]; ROWS];
        for first in (0..poses.groups()).step_by(ROWS) {
            let groups = ROWS.min(poses.groups() - first);
            l.apart(Rows { block, poses, values, recordings, first, rows: &mut rows[..groups] });
            for row in &rows[..groups] {
                let residual = l.load(&row[0]);
                let mut entries = [l; P];
                for i in 0..count {
                    entries[i] = l.load(&row[1 + slots[i]]);
                }
                sums.add(residual, &entries);
            }
        }
        sums.total()
    }
}

struct WriteRows<'a> {
    block: &'a Block,
    poses: &'a PoseLanes,
    values: &'a CableValues,
    recordings: Option<&'a Recordings>,
}

/// Weighted residuals and columns of the slots of the kernels, padding included; columns of other slots stay empty.
impl Kernel for WriteRows<'_> {
    type Output = (Vec<f64>, Columns);

    #[inline(always)]
    fn run<L: Lanes>(self, l: L) -> Self::Output {
        let Self { block, poses, values, recordings } = self;
        let mut residuals = Vec::with_capacity(poses.groups() * LANES);
        let mut columns = vec![Vec::with_capacity(poses.groups() * LANES); block.slots.len()];
        let mut rows = vec![[[0.0; LANES]; 1 + SLOTS]; poses.groups()];
        l.apart(Rows { block, poses, values, recordings, first: 0, rows: &mut rows });
        for row in &rows {
            residuals.extend(row[0]);
            for (column, &slot) in columns.iter_mut().zip(&block.slots).filter(|(_, slot)| **slot < SLOTS) {
                column.extend(row[1 + slot]);
            }
        }
        (residuals, columns)
    }
}
