//! A large loop of a cable's tension over its strain with a small one inside, and the drawing of it for the book.
//!
//! `cargo run -p examples --bin hysteresis_loops docs/book/src/figures/hysteresis.svg` writes the drawing.

use std::fmt::Write;

use cdpr::cable::stretch::hysteresis::{Hysteresis, Memory};
use cdpr::cable::stretch::hysteresis_law;
use cdpr::robot::HysteresisTable;

/// Size of the drawing and of its margin.
const WIDTH: f64 = 640.0;
const HEIGHT: f64 = 400.0;
const MARGIN: f64 = 56.0;

/// Largest strain and tension drawn.
const STRAIN: f64 = 0.012;
const TENSION: f64 = 8000.0;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    // ANCHOR: loops
    let law = hysteresis_law(&HysteresisTable {
        strain: vec![0.0, 0.004, 0.008, 0.012],
        loading_N: vec![0.0, 1200.0, 3600.0, 8000.0],
        unloading_N: vec![0.0, 700.0, 2500.0, 6800.0],
        transition_strain: vec![0.0004, 0.0015],
        transition_share: Some(vec![0.6, 0.4]),
        ..HysteresisTable::default()
    })?;
    // up to 1 %, back to 0.6 %, a small loop to 0.85 % and back, down to nothing
    let mut memory = Memory::on_loading_branch(0.0);
    let mut tensions = Vec::new();
    for strain in [0.010, 0.006, 0.0085, 0.006, 0.0] {
        tensions.push(law.tension(strain, &memory).0);
        memory = law.advance(strain, &memory);
    }
    // the small loop closes: the way back meets the large one where it left it
    assert!((tensions[1] - tensions[3]).abs() < 1e-9);
    // a cycle costs energy, in J per metre of cable
    assert!(law.cycle_loss(0.006, 0.0085, 500) > 0.0);
    // and back from tension to strain
    let (strain, _) = law.strain(tensions[0], &Memory::on_loading_branch(0.0));
    assert!((strain - 0.010).abs() < 1e-15);
    // ANCHOR_END: loops
    if let Some(path) = std::env::args().nth(1) {
        std::fs::write(path, drawing(&law))?;
    }
    Ok(())
}

fn drawing(law: &Hysteresis) -> String {
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {WIDTH} {HEIGHT}\" font-family=\"sans-serif\" font-size=\"14\" fill=\"none\">\n<title>Tension over strain with hysteresis</title>\n<rect width=\"{WIDTH}\" height=\"{HEIGHT}\" fill=\"#ffffff\"/>\n"
    );
    let (left, bottom) = (MARGIN, HEIGHT - MARGIN);
    let _ = writeln!(svg, "<path d=\"M{left} 16V{bottom}H{}\" stroke=\"#444444\"/>", WIDTH - 16.0);
    for percent in [0.0, 0.4, 0.8, 1.2] {
        let [x, _] = place(0.01 * percent, 0.0);
        let _ = writeln!(
            svg,
            "<text x=\"{x:.0}\" y=\"{}\" fill=\"#222222\" text-anchor=\"middle\">{percent} %</text>",
            bottom + 20.0
        );
    }
    for kilonewtons in [2.0, 4.0, 6.0, 8.0] {
        let [_, y] = place(0.0, 1e3 * kilonewtons);
        let _ = writeln!(
            svg,
            "<text x=\"{}\" y=\"{:.0}\" fill=\"#222222\" text-anchor=\"end\">{kilonewtons} kN</text>",
            left - 6.0,
            y + 5.0
        );
    }
    let _ = writeln!(
        svg,
        "<text x=\"{}\" y=\"{}\" fill=\"#222222\" text-anchor=\"middle\">strain</text>",
        0.5 * WIDTH,
        HEIGHT - 12.0
    );
    for branch in [Hysteresis::loading::<f64>, Hysteresis::unloading::<f64>] {
        let points: Vec<[f64; 2]> =
            (0..=60).map(|k| STRAIN * f64::from(k) / 60.0).map(|x| [x, branch(law, x).0]).collect();
        line(&mut svg, &points, "stroke=\"#999999\" stroke-dasharray=\"4 4\"");
    }
    let mut memory = Memory::on_loading_branch(0.0);
    for (strain, colour) in
        [(0.010, "#0b6bcb"), (0.006, "#c2410c"), (0.0085, "#0b6bcb"), (0.006, "#c2410c"), (0.0, "#c2410c")]
    {
        let strains = (0..=120).map(|k| memory.strain + (strain - memory.strain) * f64::from(k) / 120.0);
        let points: Vec<[f64; 2]> = strains.map(|x| [x, law.tension(x, &memory).0]).collect();
        line(&mut svg, &points, &format!("stroke=\"{colour}\" stroke-width=\"2\""));
        memory = law.advance(strain, &memory);
    }
    for (x, y, colour, text) in [(0.0058, 3100.0, "#0b6bcb", "loading"), (0.0062, 900.0, "#c2410c", "unloading")] {
        let [x, y] = place(x, y);
        let _ = writeln!(svg, "<text x=\"{x:.0}\" y=\"{y:.0}\" fill=\"{colour}\" text-anchor=\"middle\">{text}</text>");
    }
    svg + "</svg>\n"
}

fn place(strain: f64, tension: f64) -> [f64; 2] {
    let (width, height) = (WIDTH - 2.0 * MARGIN, HEIGHT - MARGIN - 24.0);
    [MARGIN + width * strain / STRAIN, HEIGHT - MARGIN - height * tension / TENSION]
}

fn line(svg: &mut String, points: &[[f64; 2]], style: &str) {
    svg.push_str("<polyline points=\"");
    for [x, y] in points.iter().map(|point| place(point[0], point[1])) {
        let _ = write!(svg, "{x:.1},{y:.1} ");
    }
    let _ = writeln!(svg, "\" {style}/>");
}
