//! The least-squares problem of one cable: its own parameters, its own column of recorded lengths.

use crate::cable::outlet;
use crate::measurement::Samples;
use crate::model::{Model, Parameter, ParameterKind};
use crate::scalar::{Kernel, LANES, Lanes, add, dispatch, dot, rotate};

/// Parameters a cable can have: two anchors of three components, offset, scale, radius.
pub(super) const SLOTS: usize = 9;

/// Measured poses as structure of arrays, padded to whole groups of lanes with copies of the last sample.
pub(super) struct PoseLanes {
    position: [Vec<f64>; 3],
    rotation: [Vec<f64>; 9],
    groups: usize,
}

impl PoseLanes {
    pub(super) fn new(samples: &Samples) -> Self {
        let groups = samples.len().div_ceil(LANES);
        let mut lanes = Self { position: Default::default(), rotation: Default::default(), groups };
        for index in 0..groups * LANES {
            let pose = &samples.poses[index.min(samples.len() - 1)];
            for (column, value) in lanes.position.iter_mut().zip(pose.position.iter()) {
                column.push(*value);
            }
            for (column, value) in lanes.rotation.iter_mut().zip(pose.rotation_rows().as_flattened()) {
                column.push(*value);
            }
        }
        lanes
    }
}

/// All parameters of a cable as the kernel reads them; anchors in world and platform components.
#[derive(Clone, Copy, Debug)]
pub(super) struct CableValues {
    pub(super) frame_anchor: [f64; 3],
    pub(super) platform_anchor: [f64; 3],
    pub(super) offset: f64,
    pub(super) scale: f64,
    pub(super) radius: f64,
}

/// The block of one cable.
pub(super) struct Block {
    pub(super) cable: usize,
    pub(super) parameters: Vec<Parameter>,
    /// Place of each parameter in a row of [`SLOTS`] derivatives.
    slots: Vec<usize>,
    pub(super) start: CableValues,
    /// Recorded lengths, padded (m).
    recorded: Vec<f64>,
    /// 1/σ of each residual, 0 in the padding (1/m).
    weights: Vec<f64>,
    axes: Vec<[f64; 3]>,
    swivel_axis: Option<[f64; 3]>,
}

impl Block {
    pub(super) fn new(
        model: &Model,
        cable: usize,
        parameters: Vec<Parameter>,
        samples: &Samples,
        weights: &[f64],
    ) -> Self {
        let data = &model.robot().cables[cable];
        let count = samples.len();
        let padded = count.div_ceil(LANES) * LANES;
        let column = |values: &[f64]| (0..count).map(|sample| values[sample * model.cable_count() + cable]).collect();
        let mut recorded: Vec<f64> = column(&samples.lengths);
        let mut column_weights: Vec<f64> = column(weights);
        recorded.resize(padded, recorded.last().copied().unwrap_or(0.0));
        column_weights.resize(padded, 0.0);
        Self {
            cable,
            slots: parameters.iter().map(slot).collect(),
            parameters,
            start: CableValues {
                frame_anchor: data.frame_anchor.into(),
                platform_anchor: data.platform_anchor.into(),
                offset: data.length_offset.unwrap_or(0.0),
                scale: data.length_scale.unwrap_or(1.0),
                radius: data.pulley_radius.unwrap_or(0.0),
            },
            recorded,
            weights: column_weights,
            axes: model.axes().iter().map(|axis| (*axis).into()).collect(),
            swivel_axis: data.pulley_swivel_axis.filter(|_| model.composition().pulley).map(Into::into),
        }
    }

    /// Mean recorded length (m).
    pub(super) fn mean_length(&self) -> f64 {
        self.recorded.iter().sum::<f64>() / self.recorded.len() as f64
    }

    /// The cable's values after moving the block's parameters by `change`.
    pub(super) fn moved(&self, from: &CableValues, change: &[f64]) -> CableValues {
        let mut values = *from;
        for (parameter, &amount) in self.parameters.iter().zip(change) {
            let along = |mut anchor: [f64; 3]| {
                for k in 0..3 {
                    anchor[k] += self.axes[parameter.axis][k] * amount;
                }
                anchor
            };
            match parameter.kind {
                ParameterKind::FrameAnchor => values.frame_anchor = along(values.frame_anchor),
                ParameterKind::PlatformAnchor => values.platform_anchor = along(values.platform_anchor),
                ParameterKind::LengthOffset => values.offset += amount,
                ParameterKind::LengthScale => values.scale += amount,
                ParameterKind::PulleyRadius => values.radius += amount,
            }
        }
        values
    }

    /// Current value of one parameter of the block.
    pub(super) fn value(&self, values: &CableValues, parameter: &Parameter) -> f64 {
        match parameter.kind {
            ParameterKind::FrameAnchor => dot(self.axes[parameter.axis], values.frame_anchor),
            ParameterKind::PlatformAnchor => dot(self.axes[parameter.axis], values.platform_anchor),
            ParameterKind::LengthOffset => values.offset,
            ParameterKind::LengthScale => values.scale,
            ParameterKind::PulleyRadius => values.radius,
        }
    }

    /// Unit direction that moves frame anchor and platform anchor together along one of the pattern's axes, for a
    /// platform that keeps this rotation; `None` unless all components of both are free.
    pub(super) fn anchors_together(
        &self,
        axis: usize,
        rotation: &nalgebra::Matrix3<f64>,
    ) -> Option<nalgebra::DVector<f64>> {
        let count = |kind| self.parameters.iter().filter(|p| p.kind == kind).count();
        let (frame, platform) = (ParameterKind::FrameAnchor, ParameterKind::PlatformAnchor);
        if axis >= self.axes.len() || count(frame) < self.axes.len() || count(platform) < self.axes.len() {
            return None;
        }
        let along = nalgebra::Vector3::from(self.axes[axis]);
        let in_platform = rotation.transpose() * along;
        let component = |parameter: &Parameter| match parameter.kind {
            ParameterKind::FrameAnchor => f64::from(u8::from(parameter.axis == axis)),
            ParameterKind::PlatformAnchor => dot(self.axes[parameter.axis], in_platform.into()),
            _ => 0.0,
        };
        let direction = nalgebra::DVector::from_iterator(self.parameters.len(), self.parameters.iter().map(component));
        Some(direction.normalize())
    }

    /// Weighted normal equations at `values`.
    pub(super) fn normal<const P: usize>(&self, poses: &PoseLanes, values: &CableValues) -> NormalEquations<P> {
        dispatch(Accumulate::<P> { block: self, poses, values })
    }

    /// Weighted residuals and the columns of the weighted Jacobian, for analysis after the fit.
    pub(super) fn rows(&self, poses: &PoseLanes, values: &CableValues, count: usize) -> (Vec<f64>, Vec<Vec<f64>>) {
        dispatch(WriteRows { block: self, poses, values, count })
    }

    /// 1/σ of each residual, padding included (1/m).
    pub(super) fn weights(&self) -> &[f64] {
        &self.weights
    }

    /// Weighted residual and the derivatives by every slot for one group of samples.
    #[inline(always)]
    fn row<L: Lanes>(&self, l: L, poses: &PoseLanes, values: &CableValues, group: usize) -> (L, [L; SLOTS]) {
        let at = |column: &[f64]| l.load(&column[group * LANES..]);
        let constants = |v: [f64; 3]| [l.constant(v[0]), l.constant(v[1]), l.constant(v[2])];
        let r = &poses.rotation;
        let rotation = [0, 3, 6].map(|first| [at(&r[first]), at(&r[first + 1]), at(&r[first + 2])]);
        let position = [at(&poses.position[0]), at(&poses.position[1]), at(&poses.position[2])];
        let anchor = add(position, rotate(&rotation, constants(values.platform_anchor)));
        let frame_anchor = constants(values.frame_anchor);
        let course = match self.swivel_axis {
            Some(axis) => outlet::pulley::course(frame_anchor, constants(axis), l.constant(values.radius), anchor),
            None => outlet::point::course(frame_anchor, anchor),
        };
        let weight = at(&self.weights);
        let scale = l.constant(values.scale);
        let factor = weight * scale;
        let (by_platform_anchor, _) = course.by_platform_anchor(&rotation);
        let residual = scale * course.length + l.constant(values.offset) - at(&self.recorded);
        let zero = l.constant(0.0);
        let mut row = [zero; SLOTS];
        for (k, axis) in self.axes.iter().enumerate().take(3) {
            row[k] = factor * dot(constants(*axis), course.direction);
            row[3 + k] = factor * dot(constants(*axis), by_platform_anchor);
        }
        row[6] = weight;
        row[7] = weight * course.length;
        row[8] = factor * course.length_by_radius;
        (weight * residual, row)
    }
}

fn slot(parameter: &Parameter) -> usize {
    match parameter.kind {
        ParameterKind::FrameAnchor => parameter.axis,
        ParameterKind::PlatformAnchor => 3 + parameter.axis,
        ParameterKind::LengthOffset => 6,
        ParameterKind::LengthScale => 7,
        ParameterKind::PulleyRadius => 8,
    }
}

/// JᵀWJ (lower triangle), JᵀWρ and ρᵀWρ of one block.
#[derive(Clone, Copy, Debug)]
pub(super) struct NormalEquations<const P: usize> {
    pub(super) cost: f64,
    pub(super) gradient: [f64; P],
    pub(super) matrix: [[f64; P]; P],
}

struct Accumulate<'a, const P: usize> {
    block: &'a Block,
    poses: &'a PoseLanes,
    values: &'a CableValues,
}

impl<const P: usize> Kernel for Accumulate<'_, P> {
    type Output = NormalEquations<P>;

    #[inline(always)]
    fn run<L: Lanes>(self, l: L) -> NormalEquations<P> {
        let zero = l.constant(0.0);
        let (mut cost, mut gradient, mut matrix) = (zero, [zero; P], [[zero; P]; P]);
        let mut slots = [0; P];
        slots.copy_from_slice(&self.block.slots);
        for group in 0..self.poses.groups {
            let (residual, row) = self.block.row(l, self.poses, self.values, group);
            let mut entries = [zero; P];
            for i in 0..P {
                entries[i] = row[slots[i]];
            }
            cost = cost + residual * residual;
            for i in 0..P {
                gradient[i] = gradient[i] + entries[i] * residual;
                for j in 0..=i {
                    matrix[i][j] = matrix[i][j] + entries[i] * entries[j];
                }
            }
        }
        NormalEquations {
            cost: cost.sum(),
            gradient: gradient.map(Lanes::sum),
            matrix: matrix.map(|r| r.map(Lanes::sum)),
        }
    }
}

struct WriteRows<'a> {
    block: &'a Block,
    poses: &'a PoseLanes,
    values: &'a CableValues,
    count: usize,
}

impl Kernel for WriteRows<'_> {
    type Output = (Vec<f64>, Vec<Vec<f64>>);

    #[inline(always)]
    fn run<L: Lanes>(self, l: L) -> Self::Output {
        let slots = &self.block.slots;
        let mut residuals = Vec::with_capacity(self.poses.groups * LANES);
        let mut columns = vec![Vec::with_capacity(self.poses.groups * LANES); slots.len()];
        for group in 0..self.poses.groups {
            let (residual, row) = self.block.row(l, self.poses, self.values, group);
            residuals.extend(residual.to_array());
            for (column, &slot) in columns.iter_mut().zip(slots) {
                column.extend(row[slot].to_array());
            }
        }
        residuals.truncate(self.count);
        columns.iter_mut().for_each(|column| column.truncate(self.count));
        (residuals, columns)
    }
}
