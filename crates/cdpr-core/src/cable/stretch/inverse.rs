//! The strain at which a rising law has a tension.

use crate::scalar::Select;

/// Most doublings in the search for a strain with more tension than the target.
const DOUBLINGS: usize = 100;

/// Most Newton steps and bisections; a law with kinks and pieces takes about ten.
const STEPS: usize = 100;

/// The strain ≥ 0 at which the rising `law` (tension and slope) has the tension `target` ≥ 0, and the slope there.
///
/// Newton's iteration with bisection where it would leave the bracket, until a step is below the fraction `smallest` of
/// the strain, and one step more; `start` > 0 is any strain of the right magnitude.
#[inline]
pub(super) fn strain_of_tension<T: Select>(target: T, start: f64, smallest: f64, law: impl Fn(T) -> (T, T)) -> (T, T) {
    let mut lower = target.constant(0.0);
    let mut upper = target.constant(start);
    for _ in 0..DOUBLINGS {
        let is_short = law(upper).0.is_less(target);
        if !target.any(is_short) {
            break;
        }
        (lower, upper) = (upper.select(is_short, lower), (upper + upper).select(is_short, upper));
    }
    let mut strain = upper;
    for _ in 0..STEPS {
        let (tension, slope) = law(strain);
        let is_short = tension.is_less(target);
        (lower, upper) = (strain.select(is_short, lower), upper.select(is_short, strain));
        let middle = target.constant(0.5) * (lower + upper);
        let newton = strain - (tension - target) / slope;
        let newton = middle.select(newton.is_less(lower), newton);
        let next = middle.select(upper.is_less(newton), newton);
        let moved = (next - strain).abs();
        let is_moving = (target.constant(smallest) * next.abs()).is_less(moved);
        strain = next;
        if !target.any(is_moving) {
            break;
        }
    }
    // the last step carries the derivatives of dual numbers, however the value was found
    let (tension, slope) = law(strain);
    (strain - (tension - target) / slope, slope)
}
