//! Axes of a robot's parts, which identification may turn from the direction in the file.

use std::ops::Deref;

use nalgebra::Vector3;

/// Angle below which cosines and sines of turns are computed by their series, which are exact to rounding there (rad).
const SMALL_TURN: f64 = 1e-3;

/// Unit vector n along an axis (world), with the rotation vector t that turns the given vector n₀ to it: n = n₀ cos|t|
/// + (t × n₀) sin|t|/|t|.
///
/// t is perpendicular to n₀, so that its two components determine n. Axes are equal if their vectors are.
#[derive(Clone, Copy, Debug)]
pub struct Axis {
    vector: Vector3<f64>,
    given: Vector3<f64>,
    turn: Vector3<f64>,
}

impl From<Vector3<f64>> for Axis {
    /// Axis along a unit vector, not turned.
    fn from(given: Vector3<f64>) -> Self {
        Self { vector: given, given, turn: Vector3::zeros() }
    }
}

impl Deref for Axis {
    type Target = Vector3<f64>;

    fn deref(&self) -> &Vector3<f64> {
        &self.vector
    }
}

impl PartialEq for Axis {
    fn eq(&self, other: &Self) -> bool {
        self.vector == other.vector
    }
}

impl Axis {
    /// The two directions about which the axis turns: the world axis with the least component along n₀ (the first of
    /// several), made perpendicular to n₀, and the cross product of n₀ with it.
    pub(crate) fn directions(&self) -> [Vector3<f64>; 2] {
        let across = Vector3::ith(self.given.iamin(), 1.0);
        let first = (across - self.given * self.given.dot(&across)).normalize();
        [first, self.given.cross(&first)]
    }

    /// Turn about a direction perpendicular to n₀ (rad).
    pub(crate) fn turn_about(&self, direction: &Vector3<f64>) -> f64 {
        self.turn.dot(direction) + 0.0
    }

    /// Sets the turn about a direction perpendicular to n₀ (rad); that about the other direction does not change.
    pub fn set_turn_about(&mut self, direction: &Vector3<f64>, angle: f64) {
        self.turn = self.turn - direction * self.turn.dot(direction) + direction * angle;
        let size = self.turn.norm();
        if size == 0.0 {
            self.vector = self.given;
            return;
        }
        let sine = if size < SMALL_TURN { 1.0 - size * size / 6.0 } else { size.sin() / size };
        self.vector = (self.given * size.cos() + self.turn.cross(&self.given) * sine).normalize();
    }

    /// Derivative ∂n by the turn about a direction perpendicular to n₀.
    ///
    /// With s = sin|t|/|t| and c = (cos|t| − s)/|t|²: ∂n = −n₀ s (t·e) + (t × n₀) c (t·e) + s (e × n₀).
    pub fn by_turn_about(&self, direction: &Vector3<f64>) -> Vector3<f64> {
        let square = self.turn.norm_squared();
        let size = square.sqrt();
        let (sine, slope) = match size < SMALL_TURN {
            true => (1.0 - square / 6.0, square / 30.0 - 1.0 / 3.0),
            false => {
                let sine = size.sin() / size;
                (sine, (size.cos() - sine) / square)
            }
        };
        let along = self.turn.dot(direction);
        self.turn.cross(&self.given) * (slope * along) - self.given * (sine * along)
            + direction.cross(&self.given) * sine
    }

    /// Rotation vector of the axis per turn about a direction perpendicular to n₀, without a component along the axis.
    pub fn rotation_by_turn_about(&self, direction: &Vector3<f64>) -> Vector3<f64> {
        self.vector.cross(&self.by_turn_about(direction))
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::{Const, SVector};
    use num_dual::{DualNum, DualVec};

    use super::*;

    type Dual = DualVec<f64, Const<2>>;

    fn axes() -> impl Iterator<Item = Axis> {
        [[0.0, 0.0, 1.0], [0.0, -1.0, 0.0], [0.6, 0.0, -0.8], [0.48, 0.6, 0.64]]
            .map(|[x, y, z]| Axis::from(Vector3::new(x, y, z)))
            .into_iter()
    }

    #[test]
    fn directions_are_perpendicular_and_a_vertical_axis_turns_about_x_and_y() {
        for axis in axes() {
            let [first, second] = axis.directions();
            let products =
                [first.dot(&second), first.dot(&axis), second.dot(&axis), first.norm() - 1.0, second.norm() - 1.0];
            assert!(products.iter().all(|product| product.abs() < 1e-15), "{products:?}");
        }
        let upright = Axis::from(Vector3::z());
        assert_eq!(upright.directions(), [Vector3::x(), Vector3::y()]);
    }

    #[test]
    fn derivatives_agree_with_dual_numbers_and_the_axis_stays_a_unit_vector() {
        for start in axes() {
            let directions = start.directions();
            for turns in [[0.4, -0.3], [1e-3, 2e-3], [3e-4, 1e-4], [0.0, 1.2]] {
                let mut axis = start;
                directions.iter().zip(turns).for_each(|(direction, turn)| axis.set_turn_about(direction, turn));
                assert!((axis.norm() - 1.0).abs() < 1e-15);
                let variable = |index: usize| {
                    Dual::new(turns[index], num_dual::Derivative::some(SVector::<f64, 2>::ith(index, 1.0)))
                };
                let (a, b) = (variable(0), variable(1));
                let size = (a * a + b * b).sqrt();
                for row in 0..3 {
                    let across = a * directions[0].cross(&start)[row] + b * directions[1].cross(&start)[row];
                    let expected = size.cos() * start[row] + across * size.sin() / size;
                    // the square root near 0 costs dual numbers some digits
                    assert!((axis[row] - expected.re).abs() < 1e-12, "{turns:?}");
                    let slopes = expected.eps.unwrap_generic(Const, Const::<1>);
                    for (direction, slope) in directions.iter().zip(slopes.iter()) {
                        let found = axis.by_turn_about(direction)[row];
                        assert!((found - slope).abs() < 1e-10, "{turns:?} {row}: {found} {slope}");
                    }
                }
            }
        }
    }

    #[test]
    fn turns_that_are_set_are_the_turns_that_are_told() {
        for mut axis in axes() {
            let [first, second] = axis.directions();
            axis.set_turn_about(&first, 0.2);
            axis.set_turn_about(&second, -0.1);
            assert!((axis.turn_about(&first) - 0.2).abs() < 1e-16 && (axis.turn_about(&second) + 0.1).abs() < 1e-16);
            axis.set_turn_about(&second, 0.0);
            axis.set_turn_about(&first, 0.0);
            assert!((*axis - axis.given).norm() < 1e-16);
        }
    }
}
