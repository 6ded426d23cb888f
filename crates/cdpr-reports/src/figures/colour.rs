//! A scale of colours that the colour-blind can read: dark blue for small, yellow for large (cividis).

/// Number of colours.
pub(super) const STEPS: usize = 12;

/// Anchors of the cividis map (Nuñez, Anderton and Renslow 2018), evenly spaced.
const ANCHORS: [[f64; 3]; 7] = [
    [0.0, 32.0, 76.0],
    [48.0, 68.0, 110.0],
    [87.0, 93.0, 109.0],
    [124.0, 123.0, 120.0],
    [165.0, 155.0, 115.0],
    [209.0, 190.0, 96.0],
    [255.0, 233.0, 69.0],
];

/// The colour of a step as `#rrggbb`.
pub(super) fn of_step(step: usize) -> String {
    let place = step.min(STEPS - 1) as f64 / (STEPS - 1) as f64 * (ANCHORS.len() - 1) as f64;
    let below = (place.floor() as usize).min(ANCHORS.len() - 2);
    let share = place - below as f64;
    let channel = |c: usize| (ANCHORS[below][c] + share * (ANCHORS[below + 1][c] - ANCHORS[below][c])).round() as u8;
    format!("#{:02x}{:02x}{:02x}", channel(0), channel(1), channel(2))
}

/// Step of a value between 0 and `top`.
pub(super) fn step_of(value: f64, top: f64) -> usize {
    ((value / top * STEPS as f64) as usize).min(STEPS - 1)
}
