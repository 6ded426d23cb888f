//! Point outlet: the cable runs straight from the frame anchor (standard model, eq. 2.5–2.8).

use crate::cable::path::{CablePath, normalized};
use crate::scalar::{Real, sub};

/// Path from the frame anchor a to the platform anchor p_B (both world, m).
#[inline(always)]
pub fn path<T: Real>(frame_anchor: [T; 3], platform_anchor: [T; 3]) -> CablePath<T> {
    let (u, q) = normalized(sub(frame_anchor, platform_anchor));
    let zero = q.constant(0.0);
    let inverse = q.constant(1.0) / q;
    let mut direction_gradient = [[zero; 3]; 3];
    for row in 0..3 {
        for column in 0..3 {
            let identity = q.constant(if row == column { 1.0 } else { 0.0 });
            direction_gradient[row][column] = (u[row] * u[column] - identity) * inverse;
        }
    }
    CablePath {
        length: q,
        free_length: q,
        direction: u,
        wrap_angle: zero,
        length_by_radius: zero,
        direction_by_radius: [zero; 3],
        direction_gradient,
    }
}
