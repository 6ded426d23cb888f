//! Draws the figure of the book's page on pulleys from the library's own numbers.
//!
//! `draw_pulleys FILE` writes it; without a file the committed figure is compared with what is drawn now.

use std::fmt::Write;

use cdpr::cable::outlet::pulley;

/// Pixels per metre, and pixels per pulley radius.
const SCALE: f64 = 70.0;

/// One pulley in its plane: where D is drawn, x_A to the right or to the left, and the platform anchor by (b_xy, b_z) in radii.
struct Drawn {
    entry: [f64; 2],
    side: f64,
    anchor: [f64; 2],
    name: &'static str,
    with_letters: bool,
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let figure = figure()?;
    if let Some(file) = std::env::args_os().nth(1) {
        std::fs::write(file, figure)?;
        return Ok(());
    }
    let committed = concat!(env!("CARGO_MANIFEST_DIR"), "/../docs/book/src/figures/pulleys.svg");
    assert_eq!(std::fs::read_to_string(committed)?, figure, "write it anew: --bin draw_pulleys -- {committed}");
    Ok(())
}

fn figure() -> Result<String, std::fmt::Error> {
    let mut svg = String::from(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 900 330\" font-family=\"sans-serif\" font-size=\"15\">\n\
         <title>A pulley in its plane, and planar pulleys on the right and on the left of their cables</title>\n\
         <rect width=\"900\" height=\"330\" fill=\"white\"/>\n",
    );
    let swivelling = Drawn {
        entry: [110.0, 170.0],
        side: 1.0,
        anchor: [4.6, -1.6],
        name: "in the pulley's plane",
        with_letters: true,
    };
    let right = Drawn { entry: [540.0, 150.0], side: 1.0, anchor: [2.35, -1.9], name: "right", with_letters: false };
    let left = Drawn { entry: [869.0, 150.0], side: -1.0, anchor: [2.35, -1.9], name: "left", with_letters: false };
    for drawn in [swivelling, right, left] {
        draw(&mut svg, &drawn)?;
    }
    svg.push_str("</svg>\n");
    Ok(svg)
}

fn draw(svg: &mut String, drawn: &Drawn) -> std::fmt::Result {
    let [b_xy, b_z] = drawn.anchor;
    let path = pulley::path_on_side([0.0; 3], [0.0, 0.0, 1.0], [1.0, 0.0, 0.0], 1.0, [b_xy, 0.0, b_z]);
    let contact = [b_xy + path.free_length * path.direction[0], b_z + path.free_length * path.direction[2]];
    let at = |[x, z]: [f64; 2]| [drawn.entry[0] + drawn.side * SCALE * x, drawn.entry[1] - SCALE * z];
    let ([dx, dy], [mx, my], [cx, cy], [bx, by]) = (at([0.0, 0.0]), at([1.0, 0.0]), at(contact), at(drawn.anchor));
    let (winch, sweep) = (dy + 1.6 * SCALE, i32::from(drawn.side > 0.0));
    let is_large = i32::from(path.wrap_angle > std::f64::consts::PI);
    writeln!(svg, "<circle cx=\"{mx:.1}\" cy=\"{my:.1}\" r=\"{SCALE}\" fill=\"#e8edf3\" stroke=\"#667\"/>")?;
    writeln!(
        svg,
        "<path d=\"M{dx:.1} {winch:.1}V{:.1}\" stroke=\"#999\" stroke-dasharray=\"5 4\"/>",
        dy - 1.9 * SCALE
    )?;
    writeln!(
        svg,
        "<path d=\"M{dx:.1} {winch:.1}V{dy:.1}A{SCALE} {SCALE} 0 {is_large} {sweep} {cx:.1} {cy:.1}L{bx:.1} {by:.1}\" \
         fill=\"none\" stroke=\"#0b5\" stroke-width=\"3\"/>"
    )?;
    for (x, y) in [(dx, dy), (mx, my), (cx, cy), (bx, by)] {
        writeln!(svg, "<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"3.5\"/>")?;
    }
    if !drawn.with_letters {
        return text(svg, [mx, my + 2.35 * SCALE], &format!("pulley_wrap_side = \"{}\"", drawn.name));
    }
    text(svg, [mx + 0.9 * SCALE, my + 2.15 * SCALE], drawn.name)?;
    for (point, words) in [
        ([dx - 18.0, dy + 4.0], "D"),
        ([mx, my + 20.0], "M"),
        ([cx + 14.0, cy - 8.0], "C"),
        ([bx - 40.0, by + 28.0], "platform anchor"),
        ([dx - 22.0, dy - 1.75 * SCALE], "z_A"),
        ([mx + 0.62 * SCALE, my + 5.0], "→ x_A"),
        ([mx - 26.0, my - 8.0], "r_p"),
        ([dx + 8.0, dy - 0.95 * SCALE], "r_p β"),
        ([0.5 * (cx + bx) + 18.0, 0.5 * (cy + by) - 12.0], "q_f"),
        ([dx + 4.0, winch + 18.0], "from the winch"),
    ] {
        text(svg, point, words)?;
    }
    Ok(())
}

fn text(svg: &mut String, [x, y]: [f64; 2], words: &str) -> std::fmt::Result {
    let words = words.replace('"', "&quot;");
    writeln!(svg, "<text x=\"{x:.1}\" y=\"{y:.1}\" text-anchor=\"middle\">{words}</text>")
}
