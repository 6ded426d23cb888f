//! Rigid cables: the method of multipliers.

use super::attempt::Attempt;
use super::descent::{Stop, Tensions};
use super::problem::Problem;
use super::rigid::Rigid;
use super::springs::Springs;
use super::stability;
use crate::geometry::Pose;
use crate::scalar::LANES;

/// Corrections of the tensions allowed.
const MAX_CORRECTIONS: u32 = 60;
/// Excess relative to the mean length below which pose and tensions are solved for together.
const NEAR: f64 = 1e-3;
/// Fraction to which the excess must shrink in one correction; otherwise the virtual springs become ten times stiffer.
const SLOW: f64 = 0.1;

/// Descends with virtual springs and rest lengths that follow the tensions: q_θ − f/k_v, until q ≤ q_θ for taut cables.
///
/// At the end f = max(0, f + k_v (q − q_θ)) holds, which is balance with rigid cables.
pub(super) fn attempt(
    base: &Problem<'_>,
    rigid: &Rigid<'_>,
    start: &Pose,
    springs: &mut [Springs],
    tensions: &mut Tensions,
) -> Attempt {
    for cable in rigid.cables() {
        springs[cable / LANES].rest_length[cable % LANES] = rigid.lengths[cable];
    }
    let (mut pose, mut iterations, mut last_excess) = (*start, 0, f64::INFINITY);
    let mut stiffening = 1.0;
    for correction in 0.. {
        let mut end = Problem { springs, ..*base }.descend(&pose, tensions);
        iterations += end.iterations;
        end.iterations = iterations;
        let (mut excess, mut is_polished) = (0.0_f64, false);
        for cable in rigid.cables() {
            let (group, lane) = (cable / LANES, cable % LANES);
            let spring = &mut springs[group];
            let tension = tensions.accepted[group][lane];
            // q − q_θ from the spring's own law, exact if taut; slack cables are short enough
            let stretch = tension / spring.stiffness[lane] + spring.rest_length[lane] - rigid.lengths[cable];
            let is_or_was_taut = tension > 0.0 || spring.rest_length[lane] < rigid.lengths[cable];
            if is_or_was_taut {
                excess = excess.max(stretch.abs());
            }
        }
        if end.stop == Stop::Stationary && excess <= NEAR * base.mean_length {
            let unpacked = &tensions.accepted.as_flattened()[..rigid.lengths.len()];
            if let Some((polished, exact)) = base.polished(rigid, &end, unpacked) {
                for (cable, tension) in exact.iter().enumerate() {
                    tensions.accepted[cable / LANES][cable % LANES] = *tension;
                }
                (end, excess, is_polished) = (polished, 0.0, true);
            }
        }
        let done = excess <= base.settings.length_tolerance;
        let hopeless = end.stop != Stop::Stationary || correction >= MAX_CORRECTIONS || stiffening > 1e6;
        if done || hopeless {
            let problem = Problem { springs, ..*base };
            let undecided = problem.undecided(tensions);
            let stability = stability::beside_rigid_cables(&problem, rigid, tensions, &end, is_polished);
            reset(rigid, springs, stiffening);
            return Attempt { end, stability, excess, undecided, pushes: false };
        }
        let slow = excess > SLOW * last_excess && excess > base.settings.length_tolerance;
        let stiffer = if slow { 10.0 } else { 1.0 };
        for cable in rigid.cables() {
            let (group, lane) = (cable / LANES, cable % LANES);
            springs[group].stiffness[lane] *= stiffer;
            let rest_length = rigid.lengths[cable] - tensions.accepted[group][lane] / springs[group].stiffness[lane];
            springs[group].rest_length[lane] = rest_length;
        }
        stiffening *= stiffer;
        (pose, last_excess) = (end.pose, excess);
    }
    unreachable!("the loop ends by its own count")
}

/// Resets the springs to the stiffness with which a descent starts.
fn reset(rigid: &Rigid<'_>, springs: &mut [Springs], stiffening: f64) {
    for cable in rigid.cables() {
        springs[cable / LANES].stiffness[cable % LANES] /= stiffening;
    }
}
