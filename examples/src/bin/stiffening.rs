//! A rope that stiffens, the straight line that comes nearest to it, and the drawing of both for the book.
//!
//! `cargo run -p examples --bin stiffening docs/book/src/figures/elasticity.svg` writes the drawing.
#![expect(clippy::print_stdout, reason = "a program that shows its figures")]

use cdpr::cable::stretch::polynomial_law;
use examples::drawing::{Panel, Picture};

/// Largest strain drawn.
const STRAIN: f64 = 0.012;
const POINTS: u32 = 121;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    // ANCHOR: polynomial
    // f = c₁ ε + c₂ ε² + c₃ ε³ up to 4.5 kN
    let rope = polynomial_law(&[2e5, 1e7, 4e8], Some(4500.0))?;
    let (tension, slope) = rope.tension(0.006);
    // EA at this tension, and back from tension to strain
    assert!((tension - 1646.4).abs() < 1e-9 && (slope - 363_200.0).abs() < 1e-6);
    let (strain, _) = rope.strain(tension);
    assert!((strain - 0.006).abs() < 1e-15);
    // ANCHOR_END: polynomial
    let curve: Vec<(f64, f64)> = (0..POINTS)
        .map(|k| STRAIN * f64::from(k) / f64::from(POINTS - 1))
        .map(|strain| (strain, rope.tension(strain).0))
        .collect();
    // the line through 0 with the least squares of the differences
    let sum = |of: fn(&(f64, f64)) -> f64| curve.iter().map(of).sum::<f64>();
    let stiffness = sum(|(strain, tension)| strain * tension) / sum(|(strain, _)| strain * strain);
    let off = curve.iter().map(|(strain, tension)| (tension - stiffness * strain).abs()).fold(0.0, f64::max);
    println!("nearest line: EA = {stiffness:.0} N, off by up to {off:.0} N");
    if let Some(path) = std::env::args().nth(1) {
        std::fs::write(path, figure(&curve, stiffness))?;
    }
    Ok(())
}

fn figure(curve: &[(f64, f64)], stiffness: f64) -> String {
    let mut picture = Picture::new(560.0, 360.0, "Tension over strain: elastic and polynomial");
    let panel =
        Panel { corner: (70.0, 20.0), size: (460.0, 280.0), x: (0.0, 1.2), y: (0.0, 5.0), is_logarithmic: false };
    picture.axes(
        &panel,
        (&[0.0, 0.2, 0.4, 0.6, 0.8, 1.0, 1.2], &[0.0, 1.0, 2.0, 3.0, 4.0, 5.0]),
        ("strain, %", "tension, kN"),
    );
    let scaled = |points: &mut dyn Iterator<Item = (f64, f64)>| -> Vec<(f64, f64)> {
        points.map(|(strain, tension)| (100.0 * strain, 1e-3 * tension)).collect()
    };
    let line = scaled(&mut [0.0, STRAIN].into_iter().map(|strain| (strain, stiffness * strain)));
    picture.curve(&panel, r##"stroke="#005a9c" stroke-width="2""##, &scaled(&mut curve.iter().copied()));
    picture.curve(&panel, r##"stroke="#a83c00" stroke-width="2" stroke-dasharray="7 4""##, &line);
    let (x, y) = panel.place((0.86, 2.6));
    picture.text("start", (x + 8.0, y + 14.0), "polynomial");
    let (x, y) = panel.place((0.5, 1e-5 * stiffness * 0.5));
    picture.text("end", (x - 8.0, y - 6.0), "elastic");
    picture.finish()
}
