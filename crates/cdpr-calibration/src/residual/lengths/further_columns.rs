//! Columns of the Jacobian by parameters beyond those of the kernels.

use super::further::{BUILD_UP, DRUM_TURN, PITCH, START_ANGLE, SWIVEL_TURN, Turns};
use super::pose_lanes::{CableValues, PoseLanes};
use super::recordings::Recordings;
use cdpr_model::cable::winch::DrumLength;
use cdpr_model::scalar::{Kernel, LANES, Lanes, add, constants, cross, dispatch, dot, sub};

/// Weighted column of the parameter at a place, padding included.
pub(crate) fn further_column(
    place: usize,
    turns: &Turns,
    values: &CableValues,
    poses: &PoseLanes,
    weights: &[f64],
    recordings: Option<&Recordings>,
) -> Vec<f64> {
    let zero = || vec![0.0; weights.len()];
    let by_recorded = |of: &dyn Fn(&DrumLength) -> f64| match recordings {
        None => zero(),
        Some(recordings) => recordings.all.iter().zip(weights).map(|(length, weight)| -(weight * of(length))).collect(),
    };
    match (place, &turns.drum, &turns.swivel) {
        (PITCH, ..) => by_recorded(&|length| length.by_pitch),
        (START_ANGLE, ..) => by_recorded(&|length| -length.by_angle),
        (DRUM_TURN..SWIVEL_TURN, Some(drum), _) => {
            let turned = drum.by_turn(&values.further[DRUM_TURN..SWIVEL_TURN], place - DRUM_TURN);
            by_recorded(&|length| length.by_axis.dot(&turned))
        }
        (BUILD_UP, ..) => by_recorded(&|length| length.by_build_up),
        (SWIVEL_TURN.., _, Some(swivel)) => {
            let turn = swivel.rotation_by_turn(&values.further[SWIVEL_TURN..BUILD_UP], place - SWIVEL_TURN).into();
            dispatch(PulleyTurn { weights, poses, values, turn })
        }
        _ => zero(),
    }
}

/// Weighted derivatives of the recorded length by a turn ω of the pulley about D: u·(ω × (p_B − D)).
struct PulleyTurn<'a> {
    weights: &'a [f64],
    poses: &'a PoseLanes,
    values: &'a CableValues,
    turn: [f64; 3],
}

impl Kernel for PulleyTurn<'_> {
    type Output = Vec<f64>;

    #[inline(always)]
    fn run<L: Lanes>(self, l: L) -> Vec<f64> {
        let Self { weights, poses, values, turn } = self;
        let mut column = vec![0.0; poses.groups() * LANES];
        let (turn, entry) = (constants(l, turn), constants(l, *values.outlet.frame_anchor()));
        for group in 0..poses.groups() {
            let (position, rotation) = poses.at(l, group);
            let (path, moment_arm) = values.path(position, &rotation);
            let moved = cross(turn, sub(add(position, moment_arm), entry));
            let weight = l.load(&weights[group * LANES..]) * l.constant(values.scale);
            (weight * dot(path.direction, moved)).store(&mut column[group * LANES..]);
        }
        column
    }
}
