//! Wrench of a cable on its platform and its derivative by the pose, for plain numbers, dual numbers and lanes.

use crate::scalar::{Real, add, cross, rotate, scale};

/// End of a cable on its platform, by numbers T.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CableEnd<T> {
    /// p_B = r + b, the platform anchor (world, m).
    pub anchor: [T; 3],
    /// b = R b_P, the moment arm of the pull about the platform origin (world, m).
    pub moment_arm: [T; 3],
}

impl<T: Real> CableEnd<T> {
    /// End at the platform anchor b_P (platform frame, m) of a platform at this position (world, m), R given by rows.
    #[inline(always)]
    pub fn at(position: [T; 3], rotation: &[[T; 3]; 3], platform_anchor: [T; 3]) -> Self {
        let moment_arm = rotate(rotation, platform_anchor);
        Self { anchor: add(position, moment_arm), moment_arm }
    }

    /// J_pB = ∂p_B/∂\[δr; δφ\] = \[I, −\[b\]×\] by rows (1, m; world axes, eq. 2.47–2.48).
    #[inline(always)]
    pub fn by_pose(&self) -> [[T; 6]; 3] {
        let (zero, one) = (self.anchor[0].constant(0.0), self.anchor[0].constant(1.0));
        [0, 1, 2].map(|row| wrench(self.moment_arm, core::array::from_fn(|k| if k == row { one } else { zero })))
    }
}

/// An end at the platform origin.
impl From<[f64; 3]> for CableEnd<f64> {
    fn from(anchor: [f64; 3]) -> Self {
        Self { anchor, moment_arm: [0.0; 3] }
    }
}

/// Wrench \[t; b × t\] of a pull t at the moment arm b; for a unit pull, the column of the structure matrix.
#[inline(always)]
pub fn wrench<T: Real>(moment_arm: [T; 3], pull: [T; 3]) -> [T; 6] {
    let moment = cross(moment_arm, pull);
    [pull[0], pull[1], pull[2], moment[0], moment[1], moment[2]]
}

/// Columns of \[b\]× M for a tangent M = ∂t/∂p_B given by rows.
#[inline(always)]
pub fn moment_columns<T: Real>(tangent: &[[T; 3]; 3], moment_arm: [T; 3]) -> [[T; 3]; 3] {
    let [x, y, z] = tangent;
    let column = |k: usize| cross(moment_arm, [x[k], y[k], z[k]]);
    [column(0), column(1), column(2)]
}

/// A row of \[b\]× M \[b\]×ᵀ from the columns of \[b\]× M.
#[inline(always)]
pub fn turned_row<T: Real>(columns: &[[T; 3]; 3], moment_arm: [T; 3], row: usize) -> [T; 3] {
    cross(moment_arm, [columns[0][row], columns[1][row], columns[2][row]])
}

/// ∂\[t; b × t\]/∂\[δr; δφ\] by rows, for a pull t with ∂t/∂p_B = M given by rows: p_B moves by δr + δφ × b, and the
/// moment arm turns.
///
/// At constant tension it is the cable's contribution to K_G; for a unit pull, minus its symmetric part is ∂²q/∂\[δr;
/// δφ\]².
#[inline(always)]
pub fn wrench_by_pose<T: Real>(tangent: &[[T; 3]; 3], moment_arm: [T; 3], pull: [T; 3]) -> [[T; 6]; 6] {
    let columns = moment_columns(tangent, moment_arm);
    let force = |k: usize| wrench(moment_arm, tangent[k]);
    let moment = |k: usize| {
        // (δφ × b) × t = b (t · δφ) − (b · t) δφ
        let mut turn = scale(moment_arm[k], pull);
        let (i, j) = ((k + 1) % 3, (k + 2) % 3);
        turn[k] = -(moment_arm[i] * pull[i] + moment_arm[j] * pull[j]);
        let turn = add(turned_row(&columns, moment_arm, k), turn);
        [columns[0][k], columns[1][k], columns[2][k], turn[0], turn[1], turn[2]]
    };
    [force(0), force(1), force(2), moment(0), moment(1), moment(2)]
}
