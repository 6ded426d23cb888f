//! What an ideal winch gets wrong: cable paid out by drums with a groove against radius times angle, in millimetres.
//!
//! `cargo run -p examples --bin drum_against_ideal_winch [FIGURE.svg]` prints the table of the book's chapter “Winch and drum”
//! and draws its figure.

#![expect(clippy::print_stdout, reason = "the table is what it is for")]

use std::fmt::Write;

use cdpr::cable::winch::{Drum, DrumError, GrooveError, Mounting, Parameters};
use cdpr::nalgebra::Vector3;
use cdpr::robot::DrumSide;

/// Cable paid out (m), one column each.
const LENGTHS: [f64; 5] = [2.0, 4.0, 6.0, 8.0, 10.0];

// ANCHOR: drum
/// A drum of 0.1 m with a pitch of 8 mm, whose pulley stands `distance` above it and `ahead` along the drum (m).
fn drum(distance: f64, ahead: f64) -> Parameters {
    Parameters {
        radius: 0.1,
        pitch: 0.008,
        start_angle: 0.0,
        start_length: 0.0,
        mounting: Some(Mounting {
            position: Vector3::zeros(),
            axis: Vector3::x(),
            side: DrumSide::Left,
            pulley: Vector3::new(ahead, 0.0, distance),
        }),
        groove_length: None,
        layer_height: None,
        build_up: 0.0,
        advantage: 1.0,
    }
}

/// How much more cable than an ideal winch of its radius a drum pays out, at the angle that gives `length` (m).
fn surplus(drum: &Drum, length: f64) -> Result<f64, GrooveError> {
    let angle = drum.angle(length)?;
    Ok(length - drum.parameters().radius * angle)
}
// ANCHOR_END: drum

fn main() -> Result<(), Box<dyn std::error::Error>> {
    // 10 m are 15.9 turns, on which the contact point travels 0.127 m
    let drums: Vec<(&str, Drum)> = [
        ("guide that travels with the cable", Parameters { mounting: None, ..drum(2.0, 0.0) }),
        ("pulley 2 m away, level with the middle of the groove", drum(2.0, 0.064)),
        ("pulley 2 m away, level with the start", drum(2.0, 0.0)),
        ("pulley 2 m away, level with the end", drum(2.0, 0.127)),
        ("pulley 1 m away, level with the start", drum(1.0, 0.0)),
        (
            "radius 0.1 mm too small in the file",
            Parameters { radius: 0.1001, pitch: 0.0, mounting: None, ..drum(2.0, 0.0) },
        ),
    ]
    .into_iter()
    .map(|(name, parameters)| Ok((name, Drum::new(parameters)?)))
    .collect::<Result<_, DrumError>>()?;
    println!(
        "| millimetres more than 0.1 m · angle after | {} |",
        LENGTHS.map(|length| format!("{length} m")).join(" | ")
    );
    println!("|---|{}", "---|".repeat(LENGTHS.len()));
    for (name, drum) in &drums {
        let mut cells = Vec::new();
        for length in LENGTHS {
            // the last one is what a wrong radius costs: the angle is the machine's, the radius the file's
            let surplus =
                if name.starts_with("radius") { length - 0.1 * drum.angle(length)? } else { surplus(drum, length)? };
            // adding zero takes the sign off what rounds to it
            cells.push(format!("{:.2}", (1e5 * surplus).round() / 100.0 + 0.0));
        }
        println!("| {name} | {} |", cells.join(" | "));
    }
    // the helix alone: h/r − 1 = 81 ppm
    let guided = surplus(&drums[0].1, 10.0)?;
    assert!((guided - 10.0 * (1.0 - 0.1 / f64::hypot(0.1, 0.008 / std::f64::consts::TAU))).abs() < 1e-12);
    match std::env::args().nth(1) {
        Some(path) => Ok(std::fs::write(path, figure(&drums[..5])?)?),
        None => Ok(()),
    }
}

/// Curves over 0 to 10 m, −8 to 5 mm.
fn figure(drums: &[(&str, Drum)]) -> Result<String, Box<dyn std::error::Error>> {
    let (x, y) = (|length: f64| 60.0 + 50.0 * length, |surplus: f64| 150.0 - 22e3 * surplus);
    let mut svg = String::from(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 640 416\" font-family=\"sans-serif\" font-size=\"12\" role=\"img\">\n\
         <title>Cable that a drum pays out beyond radius times angle (mm) over the length paid out (m)</title>\n\
         <rect width=\"640\" height=\"416\" fill=\"white\"/>\n",
    );
    for millimetres in -8..=5 {
        let level = y(1e-3 * f64::from(millimetres));
        writeln!(svg, "<line x1=\"60\" x2=\"560\" y1=\"{level}\" y2=\"{level}\" stroke=\"#ddd\"/>")?;
        writeln!(svg, "<text x=\"52\" y=\"{}\" text-anchor=\"end\">{millimetres}</text>", level + 4.0)?;
    }
    for length in (0..=10).step_by(2) {
        let place = x(f64::from(length));
        writeln!(svg, "<text x=\"{place}\" y=\"344\" text-anchor=\"middle\">{length}</text>")?;
    }
    writeln!(svg, "<text x=\"310\" y=\"360\" text-anchor=\"middle\">length paid out (m)</text>")?;
    writeln!(svg, "<text x=\"60\" y=\"22\">more than radius · angle (mm)</text>")?;
    for (index, ((name, drum), colour)) in
        drums.iter().zip(["#555", "#0072b2", "#009e73", "#d55e00", "#cc79a7"]).enumerate()
    {
        let mut points = String::new();
        for step in 0..=100 {
            let length = 0.1 * f64::from(step);
            write!(points, "{:.1},{:.1} ", x(length), y(surplus(drum, length)?))?;
        }
        writeln!(
            svg,
            "<polyline points=\"{}\" fill=\"none\" stroke=\"{colour}\" stroke-width=\"2\"/>",
            points.trim_end()
        )?;
        let (column, row) = (60 + 300 * (index / 3), 376 + 15 * (index % 3));
        writeln!(
            svg,
            "<line x1=\"{column}\" x2=\"{}\" y1=\"{row}\" y2=\"{row}\" stroke=\"{colour}\" stroke-width=\"2\"/>",
            column + 18
        )?;
        writeln!(svg, "<text x=\"{}\" y=\"{}\" font-size=\"11\">{name}</text>", column + 24, row + 4)?;
    }
    svg.push_str("</svg>\n");
    Ok(svg)
}
