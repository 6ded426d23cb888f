//! Steps of least squares that respect bounds.

/// Ways from here to the lower and the upper bound of each unknown.
pub type Room = (f64, f64);

/// Solves for the step of the unknowns that no bound holds: `solve` gives that of the others, with zeros for those held.
///
/// An unknown on a bound that the gradient pushes outwards stays there; one whose step would leave it is held too. Other bounds are
/// met by [`clamped`] or [`stopped`].
#[inline]
pub fn bounded_step(
    gradient: impl Fn(usize) -> f64,
    room: &[Room],
    held: &mut [bool],
    step: &mut [f64],
    mut solve: impl FnMut(&[bool], &mut [f64]) -> Option<()>,
) -> Option<()> {
    let count = step.len();
    for k in 0..count {
        held[k] = (room[k].0 >= 0.0 && gradient(k) > 0.0) || (room[k].1 <= 0.0 && gradient(k) < 0.0);
    }
    loop {
        solve(held, step)?;
        let outside = |k: usize| !held[k] && (step[k] < room[k].0 || step[k] > room[k].1);
        match (0..count).find(|&k| outside(k) && (room[k].0 >= 0.0 || room[k].1 <= 0.0)) {
            // already on the bound: hold it and solve for the others
            Some(k) => held[k] = true,
            None => return Some(()),
        }
    }
}

/// Ends each unknown at the bound that it meets: far, but no descent to first order.
#[inline]
pub fn clamped(room: &[Room], step: &mut [f64]) {
    for k in 0..step.len() {
        step[k] = step[k].clamp(room[k].0.min(0.0), room[k].1.max(0.0));
    }
}

/// Ends the step at the first bound that it meets: a descent, if the step is one. Whether there is such a bound.
pub fn stopped(room: &[Room], step: &mut [f64]) -> bool {
    let step_fraction = |(step, room): (&f64, &Room)| match *step {
        0.0 => f64::INFINITY,
        step if step < 0.0 => room.0 / step,
        step => room.1 / step,
    };
    let step_fraction = step.iter().zip(room).map(step_fraction).fold(f64::INFINITY, f64::min).max(0.0);
    if step_fraction < 1.0 {
        step.iter_mut().for_each(|step| *step *= step_fraction);
    }
    clamped(room, step);
    step_fraction < 1.0
}
