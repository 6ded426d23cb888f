//! Statics as a witness: where the load hangs on the platform, by recorded tensions, or by poses that only gravity holds.

use nalgebra::{DMatrix, DVector, Vector3};

use super::examined::Examined;
use super::load::{LEAST_OF_TENSIONS, freeing, stated_weight};
use crate::paired::platform_radius;
use cdpr_model::finding::{Finding, FindingKind, Severity};
use cdpr_model::geometry::{Pose, Wrench};
use cdpr_model::measurement::{Samples, three_digits};
use cdpr_model::model::Model;
use cdpr_model::robot::ParameterKind;
use cdpr_model::scalar::decomposition::{left_null_space, symmetric_eigen};
use cdpr_model::statics::{Load, balanced_wrench};

/// Distances in radii of the platform anchors from which on the center of mass is another one, and from which on that is worth a word.
const ELSEWHERE: f64 = 0.5;
const WORTH_A_WORD: f64 = 0.05;
/// Standard errors by which it has to be off, and the least share of the squared moments that it has to explain.
const SURE: f64 = 6.0;
const LEAST_EXPLAINED: f64 = 0.5;
/// Share of the largest information below which a direction of the platform is not determined, e.g. the height of the center where the platform hardly turns.
const OPEN: f64 = 1e-4;
/// Share of the largest singular value of the structure matrix from which on cables act in a direction.
const OPEN_STRUCTURE: f64 = 1e-5;
/// Most samples that are asked; of more, so many are taken evenly.
const MOST: usize = 400;

/// A center of mass that is not the file's; `None` if the data do not determine it, or agree with the file.
pub(super) fn finding(examined: &Examined<'_>) -> Option<Finding> {
    let given = examined.given;
    let is_assumed = given.assumptions.iter().any(|assumption| assumption.plain_key() == "center_of_mass_m");
    let weight = stated_weight(given)?;
    // a wrench has its moment of its own
    if is_assumed || given.external_wrench.is_some() || !given.motion_pattern.has_rotation() {
        return None;
    }
    let samples = examined.fit.as_fitted(examined.samples);
    let moments = Moments::of(&examined.fit.model, &samples)?;
    let Offset { vector, deviation, explained } = moments.offset()?;
    let (size, radius) = (vector.norm(), platform_radius(given));
    let is_sure = size > SURE * deviation && size > WORTH_A_WORD * radius && explained > LEAST_EXPLAINED;
    is_sure.then(|| {
        let own = given.platform.center_of_mass.unwrap_or_else(Vector3::zeros);
        let place = |point: Vector3<f64>| {
            let [x, y, z] = (1e3 * point).map(|metres| format!("{metres:.0}")).into();
            format!("({x}, {y}, {z}) mm")
        };
        let words = format!(
            "what balances the load of {} N at the measured poses is a center of mass at {}, {} mm from that of the robot file at {} (explains {:.0} % of the moments \
             that are left): is `center_of_mass_m` right, and the payload where it was?{}",
            three_digits(weight),
            place(own + vector),
            three_digits(1e3 * size),
            place(own),
            100.0 * explained,
            freeing(examined, ParameterKind::CenterOfMass)
        );
        let (severity, text) = match size > ELSEWHERE * radius {
            true => (Severity::Distrust, format!("not to be trusted: {words}")),
            false => (Severity::Caution, words),
        };
        Finding::new(FindingKind::Load, severity, text).of_size(size, "m").explaining(explained)
    })
}

/// Moments that are left of all samples, and how they change with the center of mass along the axes of the platform.
struct Moments {
    left: DVector<f64>,
    by_center: DMatrix<f64>,
}

/// Center of mass by the data, as seen from that of the file.
struct Offset {
    vector: Vector3<f64>,
    /// Standard error of its length (m).
    deviation: f64,
    /// Share of the squared moments that it explains.
    explained: f64,
}

impl Moments {
    /// `None` where neither tensions are recorded nor gravity alone holds the platform in some direction.
    fn of(model: &Model, samples: &Samples) -> Option<Self> {
        let load = Load::of(model.robot()).ok()?;
        let (dof, m) = (model.dof(), model.cable_count());
        if samples.tensions.is_none() && m >= dof || is_drowned(samples, load.force()) {
            return None;
        }
        let basis = DMatrix::from_fn(dof, 6, |row, column| model.twist_basis()[row][column]);
        let taken = samples.len().min(MOST);
        let (mut left, mut by_center) = (Vec::new(), Vec::new());
        for sample in (0..taken).map(|place| place * samples.len() / taken) {
            let pose = &samples.poses[sample];
            let wanted = load.wrench(pose);
            let (missing, force, seen) = match &samples.tensions {
                Some(tensions) => {
                    let held = balanced_wrench(model, pose, &tensions[sample * m..][..m]).ok()?;
                    let moments = basis.rows(model.axes().len(), dof - model.axes().len()).into_owned();
                    (wanted - held, held.fixed_rows::<3>(0).into_owned(), moments)
                }
                None => {
                    let structure = model.structure_matrix(pose).ok()?;
                    (
                        wanted,
                        wanted.fixed_rows::<3>(0).into_owned(),
                        left_null_space(&structure, OPEN_STRUCTURE) * &basis,
                    )
                }
            };
            left.extend((&seen * missing).iter());
            by_center.push(&seen * by_axes(pose, &force));
        }
        let rows: usize = by_center.iter().map(DMatrix::nrows).sum();
        let mut stacked = DMatrix::zeros(rows, 3);
        let mut row = 0;
        for own in by_center {
            stacked.rows_mut(row, own.nrows()).copy_from(&own);
            row += own.nrows();
        }
        (rows > 20).then(|| Self { left: DVector::from_vec(left), by_center: stacked })
    }

    /// Least squares in the directions that the data determine; `None` if they determine none.
    fn offset(&self) -> Option<Offset> {
        let right = self.by_center.tr_mul(&self.left);
        let found = symmetric_eigen(self.by_center.tr_mul(&self.by_center))?;
        let largest = found.eigenvalues.max();
        let (mut vector, mut inverse) = (Vector3::zeros(), 0.0);
        for (value, direction) in found.eigenvalues.iter().zip(found.eigenvectors.column_iter()) {
            if *value > OPEN * largest && *value > 0.0 {
                vector -= direction * (direction.dot(&right) / value);
                inverse += value.recip();
            }
        }
        let before = self.left.norm_squared();
        let after = (&self.left + &self.by_center * vector).norm_squared();
        let freedom = (self.left.len() as f64 - 3.0).max(1.0);
        let deviation = (after / freedom * inverse).sqrt();
        (largest > 0.0 && before > 0.0).then(|| Offset { vector, deviation, explained: 1.0 - after / before })
    }
}

/// True if the load is small beside the tensions, so that errors of load cells would count for a load.
fn is_drowned(samples: &Samples, force: f64) -> bool {
    let Some(tensions) = &samples.tensions else { return false };
    let sum: f64 = tensions.iter().map(|tension| tension.abs()).sum();
    force < LEAST_OF_TENSIONS * sum / samples.len().max(1) as f64
}

/// Wrenches of a force at unit distances along the axes of the platform.
fn by_axes(pose: &Pose, force: &Vector3<f64>) -> DMatrix<f64> {
    let mut columns = DMatrix::zeros(6, 3);
    for axis in 0..3 {
        let moment = (pose.rotation * Vector3::ith(axis, 1.0)).cross(force);
        let wrench = Wrench::new(0.0, 0.0, 0.0, moment.x, moment.y, moment.z);
        columns.column_mut(axis).copy_from(&wrench);
    }
    columns
}
