//! Rows of straight cables with a linear law, cables in lanes: the commonest model has a way of its own.

#[cfg(test)]
mod tests;

use cdpr_model::cable::elasticity::StiffnessBasis;
use cdpr_model::cable::law::Kind;
use cdpr_model::cable::wrench::wrench;
use cdpr_model::geometry::Pose;
use cdpr_model::model::Model;
use cdpr_model::robot::{Parameter, ParameterKind};
use cdpr_model::scalar::{Kernel, LANES, Lanes, constants, cross, dispatch, dot, rotate, scale};

/// Places of a cable's parameters: two anchors, offset, scale, compliance, hidden length.
const SLOTS: usize = 10;
/// Those of them that change the pull.
const ANCHORS: usize = 6;

/// Numbers of a model's cables in lanes, with the columns of its parameters.
pub(super) struct LinearRows {
    groups: Vec<Numbers>,
    /// Column, cable and place of every parameter of a cable.
    columns: Vec<(usize, usize, usize)>,
    is_by_unstrained: bool,
}

/// Numbers of eight cables, or fewer with copies of the last one.
#[derive(Clone, Copy, Default)]
struct Numbers {
    hidden_length: [f64; LANES],
    /// κ (1/N).
    specific: [f64; LANES],
    length_scale: [f64; LANES],
    length_offset: [f64; LANES],
    tension_scale: [f64; LANES],
    tension_offset: [f64; LANES],
}

/// Sample at which rows are written.
#[derive(Clone, Copy)]
pub(super) struct At<'a> {
    pub(super) pose: &'a Pose,
    /// Recorded tensions (N).
    pub(super) tensions: &'a [f64],
}

impl LinearRows {
    /// `None` if cables or parameters are others, or the robot is none of six degrees of freedom.
    pub(super) fn of(model: &Model, parameters: &[Parameter]) -> Option<Self> {
        let m = model.cable_count();
        let basis = |cable: usize| match model.law(cable).kind {
            Kind::Linear(_, basis) => basis,
            _ => None,
        };
        let first = basis(0)?;
        if model.dof() != 6 || !(0..m).all(|cable| basis(cable) == Some(first)) {
            return None;
        }
        let of_cable = |(column, parameter): (usize, &Parameter)| Some((column, parameter.cable, slot(parameter)?));
        let is_own = |(_, parameter): &(usize, &Parameter)| parameter.kind.is_of_cable();
        let columns = parameters.iter().enumerate().filter(is_own).map(of_cable).collect::<Option<Vec<_>>>()?;
        // groups of cables take the columns in turn
        if !columns.is_sorted_by_key(|(_, cable, _)| *cable) {
            return None;
        }
        let mut groups = vec![Numbers::default(); m.div_ceil(LANES)];
        for place in 0..groups.len() * LANES {
            let (law, lane) = (model.law(place.min(m - 1)), place % LANES);
            let (numbers, recording) = (&mut groups[place / LANES], &law.recording);
            let Kind::Linear(elasticity, _) = law.kind else { return None };
            numbers.hidden_length[lane] = law.hidden_length;
            numbers.specific[lane] = elasticity.by_length + elasticity.by_controlled_length;
            numbers.length_scale[lane] = recording.length_scale;
            numbers.length_offset[lane] = recording.length_offset;
            numbers.tension_scale[lane] = recording.tension_scale;
            numbers.tension_offset[lane] = recording.tension_offset;
        }
        Some(Self { groups, columns, is_by_unstrained: first == StiffnessBasis::Unstrained })
    }

    /// Writes the derivatives of all rows by the parameters of cables, and the expected lengths; the wrench of the cables, or `None` if a cable
    /// has no path.
    pub(super) fn write(
        &self,
        model: &Model,
        at: At<'_>,
        entries: &mut [f64],
        stride: usize,
        lengths: &mut [f64],
    ) -> Option<[f64; 6]> {
        dispatch(Write { linear: self, model, at, entries, stride, lengths })
    }
}

/// Place of a parameter of a cable.
fn slot(parameter: &Parameter) -> Option<usize> {
    Some(match parameter.kind {
        ParameterKind::FrameAnchor => parameter.axis,
        ParameterKind::PlatformAnchor => 3 + parameter.axis,
        ParameterKind::LengthOffset => 6,
        ParameterKind::LengthScale => 7,
        ParameterKind::Compliance => 8,
        ParameterKind::HiddenLength => 9,
        _ => return None,
    })
}

struct Write<'a> {
    linear: &'a LinearRows,
    model: &'a Model,
    at: At<'a>,
    /// Row-major, rows of a stride.
    entries: &'a mut [f64],
    stride: usize,
    lengths: &'a mut [f64],
}

/// Changes of eight cables with one parameter each: of the wrench, and of the length behind it.
type Change = [[f64; LANES]; 7];

impl Kernel for Write<'_> {
    type Output = Option<[f64; 6]>;

    #[inline(always)]
    fn run<L: Lanes>(self, l: L) -> Option<[f64; 6]> {
        let Self { linear, model, at, entries, stride, lengths } = self;
        let m = lengths.len();
        let (position, rotation) = (at.pose.position.into(), at.pose.rotation_rows());
        let (mut sum, mut next) = ([0.0; 6], 0);
        for (place, (group, numbers)) in model.groups().iter().zip(&linear.groups).enumerate() {
            let first = place * LANES;
            let count = LANES.min(m - first);
            let mut recorded = [at.tensions[first + count - 1]; LANES];
            recorded[..count].copy_from_slice(&at.tensions[first..first + count]);
            let tension = (l.load(&recorded) - l.load(&numbers.tension_offset)) / l.load(&numbers.tension_scale);
            let (path, moment_arm) = group.paths(l, position, &rotation);
            let is_path =
                l.both(path.length.is_less(l.constant(f64::INFINITY)), l.constant(0.0).is_less(path.free_length));
            if l.any(l.without(l.everywhere(true), is_path)) {
                return None;
            }
            let (hidden, specific) = (l.load(&numbers.hidden_length), l.load(&numbers.specific));
            let law = group.elasticity(l);
            let length =
                law.controlled_length_gradient(path.length, tension, hidden, specific, linear.is_by_unstrained);
            let length_scale = l.load(&numbers.length_scale);
            let expected = (length_scale * length.value + l.load(&numbers.length_offset)).to_array();
            lengths[first..first + count].copy_from_slice(&expected[..count]);

            let (u, gradient) = (path.direction, &path.direction_gradient);
            let pull = scale(tension, u);
            let (of_group, weight) = (wrench(moment_arm, pull), l.load(&group.weight));
            for row in 0..6 {
                sum[row] += (of_group[row] * weight).sum();
            }
            let by_length = length_scale * length.by_length;
            let mut changes: [Change; SLOTS] = [[[0.0; LANES]; 7]; SLOTS];
            for k in 0..3 {
                let away = [gradient[0][k], gradient[1][k], gradient[2][k]];
                let moved = wrench(moment_arm, scale(-tension, away));
                let axis = constants(l, [rotation[0][k], rotation[1][k], rotation[2][k]]);
                let mut carried = wrench(moment_arm, scale(tension, rotate(gradient, axis)));
                let turned = cross(axis, pull);
                for row in 0..3 {
                    carried[3 + row] = carried[3 + row] + turned[row];
                }
                for row in 0..6 {
                    moved[row].store(&mut changes[k][row]);
                    carried[row].store(&mut changes[3 + k][row]);
                }
                (by_length * u[k]).store(&mut changes[k][6]);
                (-(by_length * dot(u, axis))).store(&mut changes[3 + k][6]);
            }
            l.constant(1.0).store(&mut changes[6][6]);
            length.value.store(&mut changes[7][6]);
            (length_scale * length.by_compliance).store(&mut changes[8][6]);
            (length_scale * length.by_hidden_length).store(&mut changes[9][6]);

            while let Some(&(column, cable, slot)) = linear.columns.get(next).filter(|of| of.1 < first + LANES) {
                let change = &changes[slot];
                if slot < ANCHORS {
                    for row in 0..6 {
                        entries[row * stride + column] = change[row][cable - first];
                    }
                }
                entries[(6 + cable) * stride + column] = change[6][cable - first];
                next += 1;
            }
        }
        Some(sum)
    }
}
