//! Starts of the search for initial tensions.

use super::{Target, Task};
use crate::control::input_error::InputError;
use crate::control::winches::{initial_tensions, tensions_within};
use crate::tension::Reference;

/// Distance, as a fraction of the range of the limits, below which two starts count as one.
const SAME: f64 = 1e-3;

/// Balanced tensions within the limits, spread over the allowed set: nearest to the middle, to both ends, to the
/// target, to the tensions set now, and to one cable at its largest tension with the others at their least.
///
/// Slack cables and poses without an answer cause local minima of the sum of squares, which a single start may not
/// leave.
pub(super) fn starts(task: &Task<'_>, target: &Target, range: f64) -> Result<Vec<Vec<f64>>, InputError> {
    let (least, largest) = (task.limits.minimum(), task.limits.maximum());
    let nearest = |reference: Reference<'_>| tensions_within(task.limits, reference, task.machine, &task.pose);
    let mut starts = vec![nearest(Reference::Middle)?];
    let one_high = |cable: usize| {
        let mut wish = least.to_vec();
        wish[cable] = largest[cable];
        wish
    };
    let wishes =
        [Some(least.to_vec()), Some(largest.to_vec()), initial_tensions(target, task.machine, &task.pose).ok()]
            .into_iter()
            .chain([task.now.clone()])
            .flatten()
            .chain((0..task.limits.cable_count()).map(one_high));
    for wish in wishes {
        // if one reference has balanced tensions all have, except for rounding
        let Ok(start) = nearest(Reference::Given(&wish)) else { continue };
        let is_near = |other: &Vec<f64>| start.iter().zip(other).all(|(a, b)| (a - b).abs() <= SAME * range);
        if !starts.iter().any(is_near) {
            starts.push(start);
        }
    }
    Ok(starts)
}
