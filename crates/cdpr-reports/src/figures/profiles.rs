//! Profiles of parameters: the rise of the weighted squares over a shift, the others held and refitted, and the residuals beside it.

use super::axis::{Axis, finite_range};
use super::drawing::{Anchor, Drawing};
use super::figure::Figure;

/// Profile of one parameter, in units for people.
pub struct ProfileCurves {
    /// Name of the parameter.
    pub name: String,
    /// Unit of the shift.
    pub unit: String,
    /// Shifts from the optimum.
    pub shifts: Vec<f64>,
    /// Root of the rise of the weighted squares in units of the limit, the others held: two straight lines for a parabola.
    pub held: Vec<f64>,
    /// The same, the others refitted.
    pub refitted: Vec<f64>,
    /// Root mean square of the length residuals (mm), the others held.
    pub length_rms: Vec<f64>,
    /// Mean position error (mm), the others held.
    pub position_mean: Vec<f64>,
    /// Ends of the 95 % interval of the profile as shifts; `None` where it is open.
    pub interval: [Option<f64>; 2],
    /// Half width of the linear 95 % interval.
    pub linear: f64,
    /// Levels of the length residuals: of the optimum and of the model as given (mm).
    pub levels: [f64; 2],
}

const PANEL: (f64, f64) = (330.0, 130.0);
/// From the corner of one panel to that of the next.
const PITCH: (f64, f64) = (420.0, 196.0);
const CORNER: (f64, f64) = (76.0, 64.0);
/// Roots of rises above this are beyond the picture.
const MOST: f64 = 2.0;

/// A row of two panels for every parameter; `None` without any.
pub fn profiles(all: &[ProfileCurves]) -> Option<Figure> {
    if all.is_empty() {
        return None;
    }
    let height = CORNER.1 + PITCH.1 * (all.len() - 1) as f64 + PANEL.1 + 46.0;
    let mut drawing = Drawing::new(CORNER.0 + PITCH.0 + PANEL.0 + 120.0, height, "Profiles of parameters");
    legend(&mut drawing);
    for (row, curves) in all.iter().enumerate() {
        let top = CORNER.1 + PITCH.1 * row as f64;
        let (low, high) = finite_range(curves.shifts.iter().copied())?;
        let label = format!("shift of {} in {}", curves.name, curves.unit);
        for column in 0..2 {
            let left = CORNER.0 + PITCH.0 * f64::from(column);
            let (right, bottom) = (left + PANEL.0, top + PANEL.1);
            let x = Axis::exact(low, high, (left, right), 6);
            x.draw_below(
                &mut drawing,
                top,
                bottom,
                if curves.unit.is_empty() { label.trim_end_matches(" in ") } else { &label },
            );
            match column {
                0 => draw_rise(&mut drawing, curves, &x, (left, top, right, bottom)),
                _ => draw_errors(&mut drawing, curves, &x, (left, top, right, bottom))?,
            }
        }
    }
    Some(drawing.finish())
}

fn legend(drawing: &mut Drawing) {
    let (left, right) = (CORNER.0, CORNER.0 + PITCH.0);
    let entries = [
        (left, 16.0, "curve tone-2", "root of the rise of the weighted squares, others held"),
        (left, 34.0, "curve", "the same, others refitted"),
        (right, 16.0, "curve tone-1", "cable length, rms"),
        (right, 34.0, "curve", "position error, mean"),
    ];
    for (x, y, class, words) in entries {
        drawing.polyline(class, &[(x, y), (x + 26.0, y)], false);
        drawing.text("tick", Anchor::Start, (x + 32.0, y + 4.0), words);
    }
}

type Corners = (f64, f64, f64, f64);

fn draw_rise(drawing: &mut Drawing, curves: &ProfileCurves, x: &Axis, (left, top, right, bottom): Corners) {
    let y = Axis::exact(0.0, MOST, (bottom, top), 4);
    y.draw_left(drawing, left, right, "√(rise / limit)");
    drawing.line("limit", (left, y.place(1.0)), (right, y.place(1.0)));
    for (class, values) in [("curve tone-2", &curves.held), ("curve", &curves.refitted)] {
        let below: Vec<(f64, f64)> = clipped(&curves.shifts, values, MOST);
        let points: Vec<(f64, f64)> = below.iter().map(|&(shift, rise)| (x.place(shift), y.place(rise))).collect();
        drawing.polyline(class, &points, false);
    }
    let limit = y.place(1.0);
    for shift in [-curves.linear, curves.linear].into_iter().filter(|shift| x.holds(*shift)) {
        drawing.line("bar plain", (x.place(shift), limit - 7.0), (x.place(shift), limit + 7.0));
    }
    for shift in curves.interval.into_iter().flatten().filter(|shift| x.holds(*shift)) {
        let words = format!("end of the 95 % interval: {}", crate::number_format::significant(shift, 3));
        drawing.circle("dot chosen", (x.place(shift), limit), 3.5, &words);
    }
}

/// Points of a curve with a valley, cut where it crosses a height.
fn clipped(shifts: &[f64], values: &[f64], most: f64) -> Vec<(f64, f64)> {
    let mut points: Vec<(f64, f64)> = Vec::new();
    for k in 0..shifts.len() {
        let crosses = k > 0 && (values[k - 1] > most) != (values[k] > most);
        if crosses {
            let share = (most - values[k - 1]) / (values[k] - values[k - 1]);
            points.push((shifts[k - 1] + share * (shifts[k] - shifts[k - 1]), most));
        }
        if values[k] <= most {
            points.push((shifts[k], values[k]));
        }
    }
    points
}

fn draw_errors(
    drawing: &mut Drawing,
    curves: &ProfileCurves,
    x: &Axis,
    (left, top, right, bottom): Corners,
) -> Option<()> {
    let [optimum, given] = curves.levels;
    let all = curves.length_rms.iter().chain(&curves.position_mean).copied();
    let (_, high) = finite_range(all.chain([optimum]))?;
    // the level of the model as given is told in words where it is far above
    let is_near = given <= 2.0 * high;
    let y = Axis::linear(0.0, if is_near { high.max(given) } else { high }, (bottom, top), 5);
    y.draw_left(drawing, left, right, "error in mm");
    let level = |drawing: &mut Drawing, value: f64, words: &str| {
        drawing.line("zero", (left, y.place(value)), (right, y.place(value)));
        drawing.text("tick", Anchor::Start, (right + 6.0, y.place(value) + 4.0), words);
    };
    level(drawing, optimum, "length: optimum");
    match is_near {
        true => level(drawing, given, "length: as given"),
        false => {
            let words = format!("length as given: {} mm", crate::number_format::significant(given, 3));
            drawing.text("tick", Anchor::End, (right - 6.0, top + 12.0), &words);
        }
    }
    for (class, values) in [("curve tone-1", &curves.length_rms), ("curve", &curves.position_mean)] {
        let finite = curves.shifts.iter().zip(values).filter(|(_, value)| value.is_finite());
        let points: Vec<(f64, f64)> = finite.map(|(&shift, &value)| (x.place(shift), y.place(value))).collect();
        drawing.polyline(class, &points, false);
    }
    Some(())
}

#[cfg(test)]
mod tests {
    use super::clipped;

    #[test]
    fn a_valley_is_cut_where_it_leaves_the_picture() {
        let found = clipped(&[-2.0, -1.0, 0.0, 1.0, 2.0], &[4.0, 1.0, 0.0, 1.0, 4.0], 2.5);
        assert_eq!(found, [(-1.5, 2.5), (-1.0, 1.0), (0.0, 0.0), (1.0, 1.0), (1.5, 2.5)]);
    }
}
