//! Frames of tracker and marker, and changes of recorded lengths, in sentences.

use cdpr_calibration::fit::ShiftEstimate;
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

/// A line for each change of a cable's recorded lengths inside the record.
pub(super) fn shift_words(shifts: &[ShiftEstimate]) -> String {
    let line = |own: &ShiftEstimate| {
        let place = match own.line() {
            Some(line) => format!("from line {line} on"),
            None => "over the record".to_owned(),
        };
        let [change, sigma, before, after] =
            [own.change, own.sigma, own.offset_before(), own.offset_after].map(|metres| 1e3 * metres);
        format!(
            "{}: recorded lengths change by {change:+.2} ± {sigma:.2} mm {place}; length offset {before:.2} mm before, {after:.2} mm after, which the calibrated \
             robot has\n",
            own.shift
        )
    };
    shifts.iter().map(line).collect()
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
