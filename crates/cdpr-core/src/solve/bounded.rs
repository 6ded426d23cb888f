//! Steps of least squares within bounds.

/// Signed distances from the value of each unknown to its lower and to its upper bound.
pub type Room = (f64, f64);

/// Solves for the step of the unknowns that no bound holds: `solve` gives their step, with zeros for the held ones.
///
/// An unknown on a bound that the gradient pushes outwards is held; so is one on a bound that its step would leave.
/// Bounds met further away are left to [`clamped`] or [`stopped`]. `None` if `solve` returns `None`.
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

/// Ends each unknown at the bound that it meets: a long step, but not necessarily a descent to first order.
#[inline]
pub fn clamped(room: &[Room], step: &mut [f64]) {
    for k in 0..step.len() {
        step[k] = step[k].clamp(room[k].0.min(0.0), room[k].1.max(0.0));
    }
}

/// Shortens the step to the first bound that it meets: a descent if the step is one. Returns true if it meets a bound.
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
