//! Measured poses in lanes, and cables computed over them.

use super::further::{FURTHER, further_values};
use cdpr_model::cable::outlet::Outlet;
use cdpr_model::cable::{CableEnd, CablePath};
use cdpr_model::geometry::Pose;
use cdpr_model::measurement::Samples;
use cdpr_model::model::Model;
use cdpr_model::scalar::{LANES, Lanes, constants};

/// Measured poses as structure of arrays, padded to whole groups of lanes with copies of the last sample.
pub(crate) struct PoseLanes {
    position: [Vec<f64>; 3],
    rotation: [Vec<f64>; 9],
    groups: usize,
}

impl PoseLanes {
    pub(crate) fn new(samples: &Samples) -> Self {
        Self::of(&samples.poses)
    }

    /// Lanes of poses.
    pub(crate) fn of(poses: &[Pose]) -> Self {
        let groups = poses.len().div_ceil(LANES);
        let column = || vec![0.0; groups * LANES];
        let mut lanes =
            Self { position: std::array::from_fn(|_| column()), rotation: std::array::from_fn(|_| column()), groups };
        for index in 0..groups * LANES {
            let pose = &poses[index.min(poses.len() - 1)];
            for (column, value) in lanes.position.iter_mut().zip(pose.position.iter()) {
                column[index] = *value;
            }
            for (column, value) in lanes.rotation.iter_mut().zip(pose.rotation_rows().as_flattened()) {
                column[index] = *value;
            }
        }
        lanes
    }

    /// Number of groups of lanes.
    pub(crate) fn groups(&self) -> usize {
        self.groups
    }

    /// Position and rotation rows of one group.
    #[inline(always)]
    pub(crate) fn at<L: Lanes>(&self, l: L, group: usize) -> ([L; 3], [[L; 3]; 3]) {
        let first = group * LANES;
        let mut position = [l; 3];
        let mut rotation = [[l; 3]; 3];
        for k in 0..3 {
            position[k] = l.load(&self.position[k][first..]);
            for column in 0..3 {
                rotation[k][column] = l.load(&self.rotation[3 * k + column][first..]);
            }
        }
        (position, rotation)
    }
}

/// Parameters of the lengths of one cable: outlet and anchors (world and platform components, m), offset (m), scale, drum.
#[derive(Clone, Copy, Debug)]
pub(crate) struct CableValues {
    pub(crate) outlet: Outlet<f64>,
    pub(crate) platform_anchor: [f64; 3],
    pub(crate) offset: f64,
    pub(crate) scale: f64,
    /// Radius of the winch's drum and length at its start; 0 where the file states none (m).
    pub(crate) drum_radius: f64,
    pub(crate) start_length: f64,
    /// Values behind the slots of the kernels.
    pub(crate) further: [f64; FURTHER],
}

impl CableValues {
    /// The values that a cable (0-based) has in a model.
    pub(crate) fn of(model: &Model, cable: usize) -> Self {
        let outlet = model.law(cable).outlet;
        let further = further_values(model, cable);
        let cable = &model.robot().cables[cable];
        Self {
            outlet,
            platform_anchor: cable.platform_anchor.into(),
            offset: cable.length_offset.unwrap_or(0.0),
            scale: cable.length_scale.unwrap_or(1.0),
            drum_radius: cable.winch.radius.unwrap_or(0.0),
            start_length: cable.winch.start_length.unwrap_or(0.0),
            further,
        }
    }

    /// CablePath and moment arm b = R b_P at poses in lanes.
    #[inline(always)]
    pub(crate) fn path<L: Lanes>(&self, position: [L; 3], rotation: &[[L; 3]; 3]) -> (CablePath<L>, [L; 3]) {
        let l = position[0];
        let end = CableEnd::at(position, rotation, constants(l, self.platform_anchor));
        (self.outlet.map(|number| l.constant(*number)).path(end.anchor), end.moment_arm)
    }
}
