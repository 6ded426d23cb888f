//! Frames of tracker and marker in sentences.

use cdpr_calibration::{FrameEstimate, RecordingFrames};

/// A line for each frame with its deviations, and what fixes the robot's own frame.
pub(super) fn frame_words(frames: &RecordingFrames) -> String {
    let mut text = String::new();
    let tracker = ("tracker frame: world of the tracker in the robot's frame", &frames.tracker);
    for (name, estimate) in [tracker, ("marker frame: marker on the platform", &frames.marker)] {
        text.extend(estimate.as_ref().map(|estimate| format!("{name}, {}\n", numbers(estimate))));
    }
    if !frames.gauge.free.is_empty() {
        text.push_str(&format!(
            "gauge: the data leave {} free ({} directions), fixed by the least change of the file's anchors\n",
            frames.gauge.free.join(" and "),
            frames.gauge.directions
        ));
    }
    text
}

fn numbers(frame: &FrameEstimate) -> String {
    let list = |values: [f64; 3], factor: f64, decimals: usize| {
        values.map(|value| format!("{:.decimals$}", factor * value)).join(", ")
    };
    let degrees = 1f64.to_degrees();
    format!(
        "at ({}) ± ({}) mm, turned by Rx Ry Rz ({}) ± ({})°",
        list(frame.position_m, 1e3, 2),
        list(frame.sigma_position_m, 1e3, 2),
        list(frame.rotation_rad, degrees, 3),
        list(frame.sigma_rotation_rad, degrees, 3)
    )
}
