//! Start of a fit: linear least squares with the denominator of the round before as weight (Sanathanan and Koerner 1963).

use nalgebra::{Complex, DMatrix, DVector};
use std::f64::consts::TAU;

use super::points::Point;
use super::transfer::{Orders, Transfer};

/// Rounds; more change the start, not the optimum.
const ROUNDS: usize = 6;

/// A transfer function of these orders near the points, at a given delay (s); `None` where the equations do not determine it.
pub(super) fn start(points: &[Point], orders: Orders, delay: f64, unit: f64) -> Option<Transfer> {
    let (poles, zeros) = (orders.poles, orders.zeros);
    let count = 1 + poles + zeros;
    if 2 * points.len() < count {
        return None;
    }
    let mut denominator = vec![0.0; poles];
    let mut numerator = vec![0.0; zeros];
    let mut gain = 0.0;
    for _ in 0..ROUNDS {
        let mut matrix = DMatrix::zeros(2 * points.len(), count);
        let mut right = DVector::zeros(2 * points.len());
        for (row, point) in points.iter().enumerate() {
            let s = Complex::new(0.0, TAU * point.frequency / unit);
            // without the delay, the points are those of N/D alone
            let response = point.response * (s * delay * unit).exp();
            let below = denominator.iter().rev().fold(Complex::default(), |sum: Complex<f64>, a| (sum + a) * s) + 1.0;
            let weight = 1.0 / (point.sigma * below.norm());
            let mut write = |column: usize, value: Complex<f64>| {
                matrix[(2 * row, column)] = weight * value.re;
                matrix[(2 * row + 1, column)] = weight * value.im;
            };
            (0..=zeros).for_each(|k| write(k, s.powi(k as i32)));
            (1..=poles).for_each(|k| write(zeros + k, -response * s.powi(k as i32)));
            (right[2 * row], right[2 * row + 1]) = (weight * response.re, weight * response.im);
        }
        let scale: Vec<f64> = matrix.column_iter().map(|column| column.norm().max(f64::MIN_POSITIVE)).collect();
        matrix.column_iter_mut().zip(&scale).for_each(|(mut column, scale)| column /= *scale);
        let factors = matrix.qr();
        factors.q_tr_mul(&mut right);
        let mut solution = factors.unpack_r().solve_upper_triangular(&right.rows(0, count))?;
        solution.iter_mut().zip(&scale).for_each(|(value, scale)| *value /= scale);
        if !solution.iter().all(|value| value.is_finite()) || solution[0] == 0.0 {
            return None;
        }
        gain = solution[0];
        numerator = (1..=zeros).map(|k| solution[k] / gain).collect();
        denominator = (1..=poles).map(|k| solution[zeros + k]).collect();
    }
    let delay = if orders.has_delay { delay } else { 0.0 };
    Some(Transfer { gain, delay, denominator, numerator, unit, has_delay: orders.has_delay })
}
