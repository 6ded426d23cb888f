//! Poses at which a platform hangs: the rest of a pose from its position and the load, for fewer cables than degrees of freedom.
//!
//! Find turn and tensions f ≥ 0 with Aᵀ(x) f + w(x) = 0 at a given position (inverse geometrico-static problem, Carricato and Merlet 2013): Newton steps on both, with the
//! change of the wrench −K_G − ∂w/∂x by the turn, from orientations spread over all. Cables as many as coordinates of the position leave single poses; more leave
//! a family, of which a pose near an orientation is taken: the nearest where all cables pull there, else the nearest found with one of them slack.

#[cfg(test)]
mod tests;

use std::f64::consts::TAU;

use nalgebra::{DMatrix, DVector, Quaternion, UnitQuaternion, Vector3};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use thiserror::Error;

use crate::cable::GeometryError;
use crate::geometry::{Pose, Twist};
use crate::model::{Model, SpanEffect};
use crate::scalar::decomposition::{left_null_space, pseudo_inverse, smallest_eigenvalue};
use crate::statics::{Load, Stability, StaticsError, geometric_stiffness};

/// Steps of one search, its longest turn, and the turn (rad) with the imbalance beside the load at which it ends.
const STEPS: usize = 200;
const LONGEST_TURN: f64 = 0.4;
const STILL: f64 = 1e-9;
/// Tension beside the load below zero that is none.
const SLACK: f64 = 1e-6;
/// Halvings of a step that does not make the imbalance less.
const HALVINGS: u32 = 12;
/// Starts besides the orientation asked for: of a platform that turns in the plane, and in space.
const STARTS_IN_PLANE: u32 = 36;
const STARTS_IN_SPACE: u32 = 96;
/// Turn below which two poses are one (rad).
const SAME: f64 = 1e-5;
/// Tensions in multiples of the load that count as much as a turn of one radian where a step along a family is chosen.
const CHEAP: f64 = 1e3;
/// Part of the last step along a family below which the next one has to be.
const SLOWER: f64 = 0.9;
/// Singular values beside the largest that are none.
const NONE: f64 = 1e-10;
/// Share of the largest singular value of the structure matrix from which on cables act in a direction.
const RANK: f64 = 1e-5;
/// Imbalance beside the load up to which a pose is in equilibrium.
const IN_EQUILIBRIUM: f64 = 1e-6;
/// Stiffness beside the load over the mean length that is none.
const INDIFFERENT: f64 = 1e-6;

/// Pose at which the load and cables that pull are in equilibrium.
#[derive(Clone, Debug, PartialEq)]
pub struct Hanging {
    /// The pose.
    pub pose: Pose,
    /// Tension of every cable (N).
    pub tensions: Vec<f64>,
    /// Stability at constant lengths.
    pub stability: Stability,
    /// Smallest stiffness against motions that keep all lengths, turns by the platform radius (N/m).
    pub stiffness: f64,
}

/// All poses found at a position.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct HangingPoses {
    /// Stable ones first, then by their turn from the orientation asked for.
    pub found: Vec<Hanging>,
    /// Equilibria at which a cable would have to push.
    pub pushing: usize,
    /// Dimensions of the family that the position leaves; 0 where poses are single.
    pub freedom: usize,
}

/// Question about a hanging platform that has no answer.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum HangingError {
    /// Cables that fix the pose.
    #[error(
        "{cables} cables fix all {dof} degrees of freedom of the platform, so that no load decides its orientation: give the whole pose"
    )]
    Fixed {
        /// Number of cables.
        cables: usize,
        /// Degrees of freedom.
        dof: usize,
    },
    /// Fewer cables than coordinates of the position.
    #[error(
        "{cables} cables cannot bring the platform to any of the positions with {coordinates} coordinates: those it reaches follow from lengths (`cdpr fk`)"
    )]
    TooFew {
        /// Number of cables.
        cables: usize,
        /// Coordinates of the position.
        coordinates: usize,
    },
    /// A load without a force, by which nothing hangs.
    #[error("no force acts on the platform, so that nothing hangs: state mass and gravity, or a wrench")]
    NoForce,
    /// A model whose cables sag.
    #[error("poses from positions are sought with straight cables: leave the sag out of the model")]
    Sagging,
    /// Statics at a pose.
    #[error(transparent)]
    Statics(#[from] StaticsError),
    /// A pose at which a cable has no path.
    #[error(transparent)]
    Geometry(#[from] GeometryError),
}

/// Poses at which the platform hangs at a position; coordinates outside the motion pattern are those of `near`, whose orientation is the one asked for.
pub fn hanging_poses(model: &Model, load: &Load, near: &Pose) -> Result<HangingPoses, HangingError> {
    if model.composition().span != SpanEffect::Straight {
        return Err(HangingError::Sagging);
    }
    let search = Search::of(model, load)?;
    let mut all = HangingPoses { freedom: search.freedom(), ..HangingPoses::default() };
    search.collect(near, &mut all)?;
    let turn = |one: &Hanging| one.pose.rotation.angle_to(&near.rotation);
    let rank = |one: &Hanging| usize::from(one.stability != Stability::Stable);
    all.found.sort_by(|a, b| rank(a).cmp(&rank(b)).then(turn(a).total_cmp(&turn(b))));
    // where a family ends at cables that hang slack, its nearest end counts
    all.found.truncate(if all.freedom > 0 { 1 } else { usize::MAX });
    Ok(all)
}

/// A rotation, uniform over all (Shoemake 1992).
fn any_rotation(random: &mut ChaCha8Rng) -> UnitQuaternion<f64> {
    let [share, first, second] = [(); 3].map(|()| random.random_range(0.0_f64..1.0));
    let (a, b) = ((1.0 - share).sqrt(), share.sqrt());
    let (first, second) = (TAU * first, TAU * second);
    let numbers = Quaternion::new(b * second.cos(), a * first.sin(), a * first.cos(), b * second.sin());
    UnitQuaternion::from_quaternion(numbers)
}

/// Part of the load that cables which pull leave at a pose, as a share of its force, moments divided by the platform radius; `None` where cables fix the pose, or balance
/// the load.
pub fn unbalanced_share(model: &Model, load: &Load, pose: &Pose) -> Result<Option<f64>, HangingError> {
    let mut search = match Search::of(model, load) {
        Err(HangingError::Fixed { .. } | HangingError::NoForce) => return Ok(None),
        Err(HangingError::TooFew { .. }) => Search::new(model, load),
        other => other?,
    };
    loop {
        let (tensions, imbalance) = search.balance(pose)?;
        let pushing = (0..tensions.len()).filter(|&place| tensions[place] < -search.slack());
        let Some(worst) = pushing.min_by(|&a, &b| tensions[a].total_cmp(&tensions[b])) else {
            let share = imbalance.norm() / search.force;
            return Ok((share > IN_EQUILIBRIUM).then_some(share));
        };
        search.pulling.remove(worst);
    }
}

/// Model and load with their sizes.
struct Search<'a> {
    model: &'a Model,
    load: &'a Load,
    translations: usize,
    /// 1 for forces, 1/radius for moments.
    scaling: DVector<f64>,
    /// Force of the load (N).
    force: f64,
    /// Cables that may pull (from 0); the others are slack.
    pulling: Vec<usize>,
}

impl<'a> Search<'a> {
    fn of(model: &'a Model, load: &'a Load) -> Result<Self, HangingError> {
        let (cables, dof) = (model.cable_count(), model.dof());
        let coordinates = model.robot().motion_pattern.translations();
        if cables >= dof {
            return Err(HangingError::Fixed { cables, dof });
        }
        if cables < coordinates {
            return Err(HangingError::TooFew { cables, coordinates });
        }
        let search = Self::new(model, load);
        if search.force > 0.0 { Ok(search) } else { Err(HangingError::NoForce) }
    }

    fn new(model: &'a Model, load: &'a Load) -> Self {
        let translations = model.robot().motion_pattern.translations();
        let radius = model.platform_radius();
        let scaling = DVector::from_fn(model.dof(), |row, _| if row < translations { 1.0 } else { radius.recip() });
        let pulling = (0..model.cable_count()).collect();
        Self { model, load, translations, scaling, force: load.force(), pulling }
    }

    /// Dimensions of the family of poses at a position.
    fn freedom(&self) -> usize {
        self.pulling.len() - self.translations
    }

    /// Tension below zero that is none (N).
    fn slack(&self) -> f64 {
        SLACK * self.force
    }

    /// Tensions of all cables from those that pull.
    fn of_all(&self, pulling: &DVector<f64>) -> Vec<f64> {
        let mut all = vec![0.0; self.model.cable_count()];
        self.pulling.iter().zip(pulling.iter()).for_each(|(&cable, tension)| all[cable] = *tension);
        all
    }

    /// Adds the poses of the cables that may pull; of a family whose nearest pose has a cable that would push those where one hangs slack.
    fn collect(&self, near: &Pose, all: &mut HangingPoses) -> Result<(), HangingError> {
        let least = |tensions: &[f64]| tensions.iter().copied().fold(f64::INFINITY, f64::min);
        if self.freedom() == 0 {
            let mut known: Vec<Pose> = Vec::new();
            for start in self.starts(near) {
                let Some((pose, tensions)) = self.run(&start, near) else { continue };
                if known.iter().any(|other| other.rotation.angle_to(&pose.rotation) < SAME) {
                    continue;
                }
                known.push(pose);
                match least(&tensions) < -self.slack() {
                    true => all.pushing += 1,
                    false => all.found.push(self.judged(pose, tensions)?),
                }
            }
            return Ok(());
        }
        let Some((pose, tensions)) = self.run(near, near) else { return Ok(()) };
        if least(&tensions) >= -self.slack() {
            all.found.push(self.judged(pose, tensions)?);
            return Ok(());
        }
        all.pushing += 1;
        for slack in &self.pulling {
            let pulling = self.pulling.iter().copied().filter(|cable| cable != slack).collect();
            let one_less = Search { pulling, scaling: self.scaling.clone(), ..*self };
            one_less.collect(near, all)?;
        }
        Ok(())
    }

    /// Orientations from which poses are sought: the one asked for, then spread over all.
    fn starts(&self, near: &Pose) -> Vec<Pose> {
        let axes: Vec<Vector3<f64>> = self.turns().map(|twist| twist.fixed_rows::<3>(3).into_owned()).collect();
        let rotations: Vec<UnitQuaternion<f64>> = match axes[..] {
            [axis] => {
                let step = TAU / f64::from(STARTS_IN_PLANE);
                (1..STARTS_IN_PLANE)
                    .map(|place| UnitQuaternion::from_scaled_axis(axis * (step * f64::from(place))))
                    .collect()
            }
            _ => {
                let mut random = ChaCha8Rng::seed_from_u64(0);
                (0..STARTS_IN_SPACE).map(|_| any_rotation(&mut random)).collect()
            }
        };
        let turned = rotations.into_iter().map(|rotation| Pose { rotation: rotation * near.rotation, ..*near });
        std::iter::once(*near).chain(turned).collect()
    }

    fn turns(&self) -> impl Iterator<Item = &Twist> {
        self.model.twist_basis()[self.translations..].iter()
    }

    /// Tensions that leave least of the load, and what they leave (N, moments by the radius).
    fn balance(&self, pose: &Pose) -> Result<(DVector<f64>, DVector<f64>), HangingError> {
        let structure = self.structure(pose)?;
        let load = self.load.in_pattern(self.model, pose).component_mul(&self.scaling);
        let tensions = -pseudo_inverse(&structure, NONE) * &load;
        let left = &structure * &tensions + load;
        Ok((tensions, left))
    }

    fn structure(&self, pose: &Pose) -> Result<DMatrix<f64>, HangingError> {
        Ok(self.structure_of_all(pose)?.select_columns(&self.pulling))
    }

    fn structure_of_all(&self, pose: &Pose) -> Result<DMatrix<f64>, HangingError> {
        let mut structure = self.model.structure_matrix(pose)?;
        (0..structure.nrows()).for_each(|row| structure.row_mut(row).scale_mut(self.scaling[row]));
        Ok(structure)
    }

    /// Change of cables' and load's wrench by a motion, at constant tensions.
    fn turning(&self, pose: &Pose, tensions: &[f64]) -> Result<DMatrix<f64>, HangingError> {
        // linear in the tensions of straight cables, of which some may push on the way
        let part = |sign: f64| {
            let own: Vec<f64> = tensions.iter().map(|tension| f64::max(sign * tension, 0.0)).collect();
            geometric_stiffness(self.model, pose, &own)
        };
        let of_cables = part(1.0)? - part(-1.0)?;
        let (gradient, basis) = (self.load.gradient(pose), self.model.twist_basis());
        let of_load = |row: usize, column: usize| basis[row].dot(&(gradient * basis[column]));
        Ok(DMatrix::from_fn(basis.len(), basis.len(), |row, column| {
            self.scaling[row] * (of_cables[(row, column)] + of_load(row, column)) * self.scaling[column]
        }))
    }

    /// Newton steps from an orientation; `None` where they end in no equilibrium.
    fn run(&self, start: &Pose, near: &Pose) -> Option<(Pose, Vec<f64>)> {
        let turns = self.model.dof() - self.translations;
        let radius = self.scaling[self.translations].recip();
        let mut pose = *start;
        let (mut tensions, mut left) = self.balance(&pose).ok()?;
        let is_family = self.freedom() > 0;
        let (mut pace, mut last) = (1.0, f64::INFINITY);
        for _ in 0..STEPS {
            let turning = self.turning(&pose, &self.of_all(&tensions)).ok()?;
            let structure = self.structure(&pose).ok()?;
            // in units that make changes of tensions cost nothing beside turns
            let mut jacobian = DMatrix::zeros(self.model.dof(), turns + tensions.len());
            jacobian.columns_mut(0, turns).copy_from(&(turning.columns(self.translations, turns) * radius));
            jacobian.columns_mut(turns, tensions.len()).copy_from(&(&structure * (CHEAP * self.force)));
            let inverse = pseudo_inverse(&jacobian, NONE);
            let mut step = -&inverse * &left;
            if is_family {
                // along the family, towards the orientation asked for
                let back = (near.rotation * pose.rotation.inverse()).scaled_axis();
                let wanted =
                    DVector::from_iterator(turns, self.turns().map(|twist| twist.fixed_rows::<3>(3).dot(&back)))
                        .resize_vertically(turns + tensions.len(), 0.0);
                let along = &wanted - &inverse * (&jacobian * &wanted);
                // shorter steps where the family bends so much that they overshoot
                let length = along.rows(0, turns).norm();
                pace *= if length > SLOWER * last { 0.7 } else { 1.0 };
                last = length;
                step += along * pace;
            }
            let turn = step.rows(0, turns).into_owned();
            let size = turn.norm();
            let is_still = size < STILL;
            let mut factor = f64::min(1.0, LONGEST_TURN / size.max(LONGEST_TURN));
            let before = left.norm();
            for halving in 0..=HALVINGS {
                let ahead = self.turned(&pose, &(&turn * factor));
                let found = self.balance(&ahead).ok()?;
                if is_family || found.1.norm() < before || halving == HALVINGS {
                    (pose, (tensions, left)) = (ahead, found);
                    break;
                }
                factor *= 0.5;
            }
            if is_still && left.norm() <= STILL * self.force {
                return Some((pose, self.of_all(&tensions)));
            }
        }
        None
    }

    fn turned(&self, pose: &Pose, turn: &DVector<f64>) -> Pose {
        let twist = self.turns().zip(turn.iter()).fold(Twist::zeros(), |sum, (axis, amount)| sum + axis * *amount);
        pose.displaced(&twist)
    }

    /// Stability at constant lengths: the least stiffness in the directions that change none.
    fn judged(&self, pose: Pose, tensions: Vec<f64>) -> Result<Hanging, HangingError> {
        // a cable that just hangs slack keeps its length, too
        let structure = self.structure_of_all(&pose)?;
        let stiffness = -self.turning(&pose, &tensions)?;
        let symmetric = (&stiffness + stiffness.transpose()) * 0.5;
        let open = left_null_space(&structure, RANK);
        let least = smallest_eigenvalue(&open * symmetric * open.transpose());
        let lengths = self.model.cable_lengths(&pose)?;
        let mean = lengths.iter().sum::<f64>() / lengths.len() as f64;
        let stability = Stability::of(least, INDIFFERENT * self.force / mean);
        Ok(Hanging { pose, tensions, stability, stiffness: least })
    }
}
