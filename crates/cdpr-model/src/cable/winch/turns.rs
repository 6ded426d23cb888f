//! One layer of cable on a drum: the law between turn and paid-out length, smooth and exactly invertible.

use crate::scalar::Real;

/// Cable wound in a helix of constant radius and pitch, from a point at which the turn φ and the paid-out length are
/// zero.
///
/// A turn by φ unwinds the helix length h φ, h = √(r² + c²), while the contact point travels c φ along the drum. The
/// free part between contact and first pulley, s(φ) = √(t² + (w + c φ)²), takes up its change, so that the length
/// beyond the pulley is
///
/// F(φ) = h φ − (s(φ) − s(0)),  F′ = h − c (w + c φ)/s > 0,
///
/// with t² = d² − r² the square of the tangent from the pulley to the circle of radius r at the distance d of the
/// pulley from the drum's axis. With a guide that travels with the contact point s is constant: F = h φ. Without pitch
/// both are r φ.
///
/// On a spool the cable lies on itself: every metre paid out reduces the squared radius by Q, so that its radius is r −
/// Q φ/2 and it pays out F(φ) = r φ − Q φ²/4.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Turns<T> {
    /// Radius r of the cable's centre line (m).
    pub radius: T,
    /// Travel c of the contact point along the drum's axis (m/rad), signed.
    pub travel: T,
    /// The first pulley; `None` if a guide travels with the contact point.
    pub pulley: Option<FirstPulley<T>>,
    /// Increase Q of the squared radius per metre wound (m), without travel and pulley.
    pub build_up: T,
}

/// Position of the first pulley relative to the drum.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct FirstPulley<T> {
    /// Square of its distance d from the drum's axis (m²).
    pub distance_squared: T,
    /// Position w of the contact point along the axis at φ = 0, counted from the pulley (m).
    pub contact: T,
}

/// A paid-out length with its derivatives.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct PaidOut<T> {
    /// F (m).
    pub value: T,
    /// ∂F/∂φ (m/rad), above zero.
    pub by_turn: T,
    /// ∂F/∂r.
    pub by_radius: T,
    /// ∂F/∂c by the travel (rad).
    pub by_travel: T,
    /// ∂F/∂Q by the build-up.
    pub by_build_up: T,
    /// ∂F/∂w by the position of the contact point.
    pub by_contact: T,
    /// ∂F/∂(d²) (1/m).
    pub by_distance_squared: T,
}

impl<T: Real> Turns<T> {
    /// Length of cable that one radian unwinds, h = √(r² + c²) (m/rad).
    #[inline]
    pub(crate) fn wound_per_radian(&self) -> T {
        (self.radius * self.radius + self.travel * self.travel).sqrt()
    }

    /// Length paid out beyond the first pulley by a turn from φ = 0 (m), negative if cable is reeled in.
    #[inline]
    pub(crate) fn paid_out(&self, turn: T) -> T {
        let wound = self.wound_per_radian() * turn;
        let Some(pulley) = self.pulley else { return wound - self.build_up * quarter_square(turn) };
        let (w, along) = (pulley.contact, self.travel * turn);
        let sum = pulley.free_length(self.radius, w + along) + pulley.free_length(self.radius, w);
        // s(φ) − s(0) without the difference of two nearly equal roots
        wound - along * (w + w + along) / sum
    }

    /// [`Turns::paid_out`] with its derivatives.
    #[inline]
    pub(crate) fn gradient(&self, turn: T) -> PaidOut<T> {
        let (r, c, h) = (self.radius, self.travel, self.wound_per_radian());
        let zero = r.constant(0.0);
        let wound = PaidOut {
            value: self.paid_out(turn),
            by_turn: h - self.build_up * turn * r.constant(0.5),
            by_radius: turn * r / h,
            by_travel: turn * c / h,
            by_build_up: -quarter_square(turn),
            by_contact: zero,
            by_distance_squared: zero,
        };
        let Some(pulley) = self.pulley else { return wound };
        let (w, z) = (pulley.contact, pulley.contact + c * turn);
        let one = r.constant(1.0);
        let inverse = one / pulley.free_length(r, z);
        let inverse_at_start = one / pulley.free_length(r, w);
        let shift = inverse - inverse_at_start;
        PaidOut {
            by_turn: h - c * z * inverse,
            by_radius: wound.by_radius + r * shift,
            by_travel: wound.by_travel - turn * z * inverse,
            by_contact: w * inverse_at_start - z * inverse,
            by_distance_squared: -(r.constant(0.5) * shift),
            ..wound
        }
    }

    /// The turn that pays out this length: the exact inverse of [`Turns::paid_out`] (rad).
    ///
    /// s = h φ − K with K = Δ − s(0), squared, is r² φ² − 2 (h K + w c) φ − Δ (2 s(0) − Δ) = 0; the root with s ≥ 0 is
    /// the larger one, and its discriminant (c K + h w)² + r² t² is a sum of squares. One Newton step removes rounding.
    #[inline]
    pub(crate) fn turn(&self, paid_out: T) -> T {
        let h = self.wound_per_radian();
        let Some(pulley) = self.pulley else {
            let root = (h * h - self.build_up * paid_out).sqrt();
            return (paid_out + paid_out) / (h + root);
        };
        let (r, c, w) = (self.radius, self.travel, pulley.contact);
        let square = r * r;
        let k = paid_out - pulley.free_length(r, w);
        let across = c * k + h * w;
        let root = (across * across + square * (pulley.distance_squared - square)).sqrt();
        let turn = (h * k + w * c + root) / square;
        let z = w + c * turn;
        let slope = h - c * z / pulley.free_length(r, z);
        turn - (self.paid_out(turn) - paid_out) / slope
    }
}

/// φ²/4.
#[inline]
fn quarter_square<T: Real>(turn: T) -> T {
    turn * turn * turn.constant(0.25)
}

impl<T: Real> FirstPulley<T> {
    /// s = √(d² − r² + z²) for a contact point at the position z along the axis.
    #[inline]
    fn free_length(&self, radius: T, z: T) -> T {
        (self.distance_squared - radius * radius + z * z).sqrt()
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::{Const, SVector};
    use num_dual::DualVec;

    use super::*;

    type Dual = DualVec<f64, Const<6>>;

    fn fleeting(radius: f64, travel: f64, distance: f64, contact: f64) -> Turns<f64> {
        let pulley = FirstPulley { distance_squared: distance * distance, contact };
        Turns { radius, travel, pulley: Some(pulley), build_up: 0.0 }
    }

    /// Drums of robots, and one whose pitch is as large as its radius with the pulley close by.
    fn drums() -> [Turns<f64>; 6] {
        [
            fleeting(0.1, 0.008 / std::f64::consts::TAU, 1.5, -0.1),
            fleeting(0.06, -0.004 / std::f64::consts::TAU, 0.4, 0.3),
            fleeting(0.05, 0.05, 0.07, -0.4),
            fleeting(0.08, 0.0, 2.0, 0.2),
            Turns { radius: 0.1, travel: 0.002, pulley: None, build_up: 0.0 },
            // a spool that is empty after 170 rad
            Turns { radius: 0.3, travel: 0.0, pulley: None, build_up: 0.0035 },
        ]
    }

    #[test]
    fn turn_and_length_are_inverse_to_each_other() {
        for drum in drums() {
            for step in -200..=200 {
                let turn = 0.7 * f64::from(step);
                let back = drum.turn(drum.paid_out(turn));
                // rounding of 140 rad and of 14 m over a radius of 0.05 m
                assert!((back - turn).abs() < 1e-12, "{drum:?} {turn} {back}");
                let length = 0.05 * f64::from(step);
                assert!((drum.paid_out(drum.turn(length)) - length).abs() < 1e-13, "{drum:?} {length}");
            }
        }
    }

    /// Turning on always pays out: the helix is longer than its travel along the drum.
    #[test]
    fn the_law_is_strictly_monotone() {
        for drum in drums() {
            for step in -200..=200 {
                assert!(drum.gradient(0.7 * f64::from(step)).by_turn > 0.0);
            }
        }
    }

    #[test]
    fn derivatives_agree_with_dual_numbers_in_both_directions() {
        let variable =
            |value: f64, index: usize| Dual::new(value, num_dual::Derivative::some(SVector::<f64, 6>::ith(index, 1.0)));
        for drum in drums() {
            for turn in [-9.0, 0.0, 3.0, 41.0] {
                let pulley = drum.pulley.map(|pulley| FirstPulley {
                    contact: variable(pulley.contact, 3),
                    distance_squared: variable(pulley.distance_squared, 4),
                });
                let build_up = variable(drum.build_up, 5);
                let dual =
                    Turns { radius: variable(drum.radius, 1), travel: variable(drum.travel, 2), pulley, build_up };
                let expected = dual.paid_out(variable(turn, 0));
                let expected = expected.eps.unwrap_generic(Const, Const::<1>);
                let found = drum.gradient(turn);
                let found = SVector::<f64, 6>::from([
                    found.by_turn,
                    found.by_radius,
                    found.by_travel,
                    found.by_contact,
                    found.by_distance_squared,
                    if drum.pulley.is_some() { 0.0 } else { found.by_build_up },
                ]);
                assert!((expected - found).amax() < 1e-12 * found.amax().max(1.0), "{drum:?}: {expected} {found}");
                // the inverse: ∂φ/∂F = 1/F′, ∂φ/∂p = −(∂F/∂p)/F′
                let inverse = dual.turn(variable(drum.paid_out(turn), 0)).eps.unwrap_generic(Const, Const::<1>);
                let mut of_inverse = found * (-1.0 / found[0]);
                of_inverse[0] = 1.0 / found[0];
                assert!((inverse - of_inverse).amax() < 1e-9 * of_inverse.amax(), "{inverse} {of_inverse}");
            }
        }
    }

    /// Without pitch, also with a guide, the drum is the ideal winch, in value and slope.
    #[test]
    fn pitch_zero_is_the_ideal_winch_reached_smoothly() {
        let ideal = fleeting(0.1, 0.0, 1.5, -0.3).gradient(25.0);
        assert!((ideal.value - 2.5).abs() < 1e-15 && (ideal.by_turn - 0.1).abs() < 1e-16);
        // the free part changes in proportion to the pitch, the helix with its square
        let difference = |travel: f64| fleeting(0.1, travel, 1.5, -0.3).paid_out(25.0) - 2.5;
        let guided = |travel: f64| Turns { radius: 0.1, travel, pulley: None, build_up: 0.0 }.paid_out(25.0) - 2.5;
        assert!((difference(1e-6) / difference(1e-7) - 10.0).abs() < 0.01);
        assert!((guided(1e-3) / guided(1e-4) - 100.0).abs() < 0.1);
        assert!((ideal.by_travel - difference(1e-7) / 1e-7).abs() < 1e-3);
    }
}
