//! Draws the figure of the book's page on tension distribution: all allowed tensions of a robot with two cables more than
//! degrees of freedom at one pose, and the ones that each method chooses.
//!
//! `draw_tensions FILE` writes it; without a file the committed figure is compared with what is drawn now.

use std::error::Error;
use std::fmt::Write;

use cdpr::geometry::Pose;
use cdpr::model::{Composition, Model};
use cdpr::nalgebra::{DMatrix, Vector3};
use cdpr::reading::Keyword;
use cdpr::robot::Robot;
use cdpr::tension::{Limits, Method, Options, Status, solve};

/// Lower left and upper right corner of the plane in the picture (pixels).
const PIXELS: [[f64; 2]; 2] = [[60.0, 480.0], [490.0, 50.0]];

/// The question: who holds 500 kg (and a little moment) at this pose of the CableRobot Simulator?
struct Question {
    matrix: DMatrix<f64>,
    wrench: [f64; 6],
    limits: Limits,
}

/// The part of the plane that is drawn.
struct Window {
    /// Cables (from 0) whose tensions are the axes.
    axes: [usize; 2],
    /// Lower left corner, and length of both axes (kN).
    corner: [f64; 2],
    length: f64,
}

/// A point of the plane, and what is written beside it.
struct Mark {
    at: [f64; 2],
    methods: Vec<&'static str>,
    is_allowed: bool,
}

fn main() -> Result<(), Box<dyn Error>> {
    let figure = figure()?;
    if let Some(file) = std::env::args_os().nth(1) {
        std::fs::write(file, figure)?;
        return Ok(());
    }
    let committed = concat!(env!("CARGO_MANIFEST_DIR"), "/../docs/book/src/figures/tension-polygon.svg");
    assert_eq!(std::fs::read_to_string(committed)?, figure, "write it anew: --bin draw_tensions -- {committed}");
    Ok(())
}

fn figure() -> Result<String, Box<dyn Error>> {
    let question = question()?;
    let axes = widest(&question);
    let (corners, edges) = polygon(&question, axes);
    let marks = marks(&question, axes)?;
    let window = Window::around(axes, corners.iter().copied().chain(marks.iter().map(|mark| mark.at)));
    let mut svg = String::from(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 870 530\" role=\"img\" font-family=\"sans-serif\" font-size=\"13\">\n\
         <title>All allowed tensions of eight cables at one pose, and those that each method chooses</title>\n\
         <style>text { fill: #1b1f24; } .halo { paint-order: stroke; stroke: #ffffff; stroke-width: 4px; }</style>\n\
         <rect width=\"870\" height=\"530\" fill=\"#ffffff\"/>\n",
    );
    draw_axes(&mut svg, &window)?;
    let path: Vec<String> =
        corners.iter().map(|corner| window.pixel(*corner)).map(|[x, y]| format!("{x:.1},{y:.1}")).collect();
    writeln!(svg, "<polygon points=\"{}\" fill=\"#dbe9f6\" stroke=\"#1f5a94\" stroke-width=\"1.5\"/>", path.join(" "))?;
    for ([x, y], name) in edges.iter().map(|edge| (edge.beside(&window), &edge.name)) {
        writeln!(
            svg,
            "<text class=\"halo\" x=\"{x:.1}\" y=\"{y:.1}\" text-anchor=\"middle\" font-size=\"11\">{name}</text>"
        )?;
    }
    let points: Vec<[f64; 2]> = marks.iter().map(|mark| window.pixel(mark.at)).collect();
    for (index, (mark, disc)) in marks.iter().zip(discs(&points)).enumerate() {
        draw_mark(&mut svg, points[index], disc, index + 1, mark)?;
    }
    svg.push_str("</svg>\n");
    Ok(svg)
}

fn question() -> Result<Question, Box<dyn Error>> {
    let robot = Robot::builtin("cablerobot-simulator-helicopter").ok_or("is built in")?;
    let model = Model::new(robot, Composition::STANDARD)?;
    let pose = Pose::from_xyz_angles(Vector3::new(0.9, -0.5, 1.7), [0.0, 0.05, 0.08]);
    let matrix = model.structure_matrix(&pose)?;
    Ok(Question {
        matrix,
        wrench: [0.0, 0.0, -5000.0, 400.0, -300.0, 200.0],
        limits: Limits::uniform(8, 1000.0, 6000.0)?,
    })
}

/// What a tension is over the plane: the other cables follow from two of them, f = c₀ + c₁ x + c₂ y (kN).
fn over_the_plane(question: &Question, axes: [usize; 2]) -> Vec<[f64; 3]> {
    let others: Vec<usize> = (0..8).filter(|cable| !axes.contains(cable)).collect();
    let column = |cable: usize| question.matrix.column(cable).into_owned();
    let square = DMatrix::from_fn(6, 6, |row, place| question.matrix[(row, others[place])]);
    let right = DMatrix::from_fn(6, 3, |row, place| match place {
        0 => -question.wrench[row] / 1000.0,
        axis => -column(axes[axis - 1])[row],
    });
    let solved = square.lu().solve(&right).unwrap_or_else(|| DMatrix::zeros(6, 3));
    let mut coefficients = vec![[0.0; 3]; 8];
    coefficients[axes[0]][1] = 1.0;
    coefficients[axes[1]][2] = 1.0;
    for (place, cable) in others.into_iter().enumerate() {
        coefficients[cable] = [0, 1, 2].map(|k| solved[(place, k)]);
    }
    coefficients
}

/// An edge of the polygon, and the limit that it is.
struct Edge {
    middle: [f64; 2],
    /// Outwards.
    normal: [f64; 2],
    name: String,
}

impl Edge {
    /// The place of its name (pixels).
    fn beside(&self, window: &Window) -> [f64; 2] {
        let [x, y] = window.pixel(self.middle);
        [x + 34.0 * self.normal[0], y - 16.0 * self.normal[1] + 4.0]
    }
}

/// The two cables over whose tensions the polygon is least of a line: the largest area.
fn widest(question: &Question) -> [usize; 2] {
    let pairs = (0..8).flat_map(|first| (first + 1..8).map(move |second| [first, second]));
    let area = |axes: [usize; 2]| -> f64 {
        let corners = polygon(question, axes).0;
        let next = corners.iter().cycle().skip(1);
        0.5 * corners.iter().zip(next).map(|(a, b)| a[0] * b[1] - a[1] * b[0]).sum::<f64>().abs()
    };
    pairs.max_by(|a, b| area(*a).total_cmp(&area(*b))).unwrap_or([0, 1])
}

/// Corners of the polygon (kN), and its longer edges.
fn polygon(question: &Question, axes: [usize; 2]) -> (Vec<[f64; 2]>, Vec<Edge>) {
    let coefficients = over_the_plane(question, axes);
    let half_planes = coefficients.iter().enumerate().flat_map(|(cable, c)| {
        let (least, largest) = (question.limits.minimum()[cable] / 1000.0, question.limits.maximum()[cable] / 1000.0);
        [(cable, least, [c[0] - least, c[1], c[2]]), (cable, largest, [largest - c[0], -c[1], -c[2]])]
    });
    let half_planes: Vec<(usize, f64, [f64; 3])> = half_planes.collect();
    let inside = |c: &[f64; 3], [x, y]: [f64; 2]| c[0] + c[1] * x + c[2] * y;
    let mut corners = vec![[-1e3, -1e3], [1e3, -1e3], [1e3, 1e3], [-1e3, 1e3]];
    for (_, _, plane) in &half_planes {
        corners = cut(&corners, |point| inside(plane, point));
    }
    let mut edges = Vec::new();
    for (index, &a) in corners.iter().enumerate() {
        let b = corners[(index + 1) % corners.len()];
        for (cable, limit, plane) in &half_planes {
            let is_edge = inside(plane, a).abs() < 1e-9 && inside(plane, b).abs() < 1e-9;
            if is_edge && (b[0] - a[0]).hypot(b[1] - a[1]) > 0.3 {
                let size = plane[1].hypot(plane[2]);
                edges.push(Edge {
                    middle: [0, 1].map(|k| 0.5 * (a[k] + b[k])),
                    normal: [-plane[1] / size, -plane[2] / size],
                    name: format!("f{} = {limit} kN", cable + 1),
                });
            }
        }
    }
    (corners, edges)
}

/// The part of a convex polygon where a linear function is not negative.
fn cut(corners: &[[f64; 2]], inside: impl Fn([f64; 2]) -> f64) -> Vec<[f64; 2]> {
    let mut kept = Vec::new();
    for (index, &a) in corners.iter().enumerate() {
        let b = corners[(index + 1) % corners.len()];
        let (at_a, at_b) = (inside(a), inside(b));
        if at_a >= 0.0 {
            kept.push(a);
        }
        if (at_a < 0.0) != (at_b < 0.0) {
            let part = at_a / (at_a - at_b);
            kept.push([a[0] + part * (b[0] - a[0]), a[1] + part * (b[1] - a[1])]);
        }
    }
    kept
}

/// What each method chooses; methods that choose the same share a mark.
fn marks(question: &Question, axes: [usize; 2]) -> Result<Vec<Mark>, Box<dyn Error>> {
    let mut marks: Vec<Mark> = Vec::new();
    for method in Method::ALL.iter().copied().filter(|method| *method != Method::NearestWrench) {
        let answer = solve(method, &question.matrix, &question.wrench, &question.limits, &Options::default())?;
        let at = axes.map(|cable| answer.tensions[cable] / 1000.0);
        match marks.iter_mut().find(|mark| (mark.at[0] - at[0]).hypot(mark.at[1] - at[1]) < 1e-4) {
            Some(mark) => mark.methods.push(method.name()),
            None => {
                let is_allowed = answer.status == Status::Feasible;
                marks.push(Mark { at, methods: vec![method.name()], is_allowed });
            }
        }
    }
    Ok(marks)
}

impl Window {
    /// A square around these points (kN).
    fn around(axes: [usize; 2], points: impl Iterator<Item = [f64; 2]> + Clone) -> Self {
        let end =
            |k: usize, pick: fn(f64, f64) -> f64, from: f64| points.clone().map(|point| point[k]).fold(from, pick);
        let low = [0, 1].map(|k| end(k, f64::min, f64::INFINITY));
        let high = [0, 1].map(|k| end(k, f64::max, f64::NEG_INFINITY));
        let length = 1.25 * (high[0] - low[0]).max(high[1] - low[1]);
        Self { axes, corner: [0, 1].map(|k| 0.5 * (low[k] + high[k] - length)), length }
    }

    fn pixel(&self, at: [f64; 2]) -> [f64; 2] {
        [0, 1].map(|k| PIXELS[0][k] + (at[k] - self.corner[k]) / self.length * (PIXELS[1][k] - PIXELS[0][k]))
    }
}

fn draw_axes(svg: &mut String, window: &Window) -> std::fmt::Result {
    let ([left, bottom], [right, top]) = (PIXELS[0], PIXELS[1]);
    for tick in 0..=10 {
        let at = f64::from(tick);
        let [x, y] = window.pixel([at; 2]);
        if x > left && x < right {
            writeln!(svg, "<path d=\"M{x:.1} {bottom}V{top}\" stroke=\"#e3e7eb\"/>")?;
            writeln!(svg, "<text x=\"{x:.1}\" y=\"{:.1}\" text-anchor=\"middle\">{tick}</text>", bottom + 18.0)?;
        }
        if y < bottom && y > top {
            writeln!(svg, "<path d=\"M{left} {y:.1}H{right}\" stroke=\"#e3e7eb\"/>")?;
            writeln!(svg, "<text x=\"{:.1}\" y=\"{:.1}\" text-anchor=\"end\">{tick}</text>", left - 8.0, y + 4.5)?;
        }
    }
    let [x_name, y_name] = window.axes.map(|cable| format!("tension of cable {}, kN", cable + 1));
    writeln!(svg, "<text x=\"275\" y=\"518\" text-anchor=\"middle\">{x_name}</text>")?;
    writeln!(svg, "<text transform=\"translate(20 265) rotate(-90)\" text-anchor=\"middle\">{y_name}</text>")
}

/// Places of the numbered discs (pixels): at their points, or beside points that lie so close to each other that discs would hide one.
fn discs(points: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let apart = |[x, y]: [f64; 2], [u, v]: [f64; 2]| (x - u).hypot(y - v);
    let mut places: Vec<[f64; 2]> = Vec::new();
    for (index, &point) in points.iter().enumerate() {
        let is_free = |place: [f64; 2]| {
            let others = points.iter().enumerate().filter(|(other, _)| *other != index).map(|(_, other)| *other);
            others.chain(places.iter().copied()).all(|other| apart(place, other) > 19.0)
        };
        let around = (0..8).map(|turn| f64::from(3 + turn) * std::f64::consts::FRAC_PI_4);
        let beside = around.map(|angle| [point[0] + 30.0 * angle.cos(), point[1] - 30.0 * angle.sin()]);
        places.push([point].into_iter().chain(beside).find(|&place| is_free(place)).unwrap_or(point));
    }
    places
}

/// A numbered disc, hollow where limits are broken, joined with its point where it stands beside it, and its line in the legend.
fn draw_mark(svg: &mut String, point: [f64; 2], place: [f64; 2], number: usize, mark: &Mark) -> std::fmt::Result {
    if place != point {
        let ([x, y], [to_x, to_y]) = (point, place);
        writeln!(
            svg,
            "<path d=\"M{x:.1} {y:.1}L{to_x:.1} {to_y:.1}\" stroke=\"#1b1f24\"/><circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"2.5\" fill=\"#1b1f24\"/>"
        )?;
    }
    let (fill, ink) = if mark.is_allowed { ("#1b1f24", "#ffffff") } else { ("#ffffff", "#1b1f24") };
    let mut disc = |[x, y]: [f64; 2]| {
        writeln!(
            svg,
            "<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"8.5\" fill=\"{fill}\" stroke=\"#1b1f24\"/>\
             <text x=\"{x:.1}\" y=\"{:.1}\" text-anchor=\"middle\" font-size=\"11\" style=\"fill:{ink}\">{number}</text>",
            y + 4.0
        )
    };
    let line = 60.0 + 42.0 * (number - 1) as f64;
    disc(place)?;
    disc([520.0, line])?;
    writeln!(svg, "<text x=\"538\" y=\"{:.1}\">{}</text>", line + 4.5, mark.methods.join(", "))?;
    let note = if mark.is_allowed { "" } else { " (breaks limits)" };
    let [x, y] = mark.at;
    writeln!(svg, "<text x=\"538\" y=\"{:.1}\" font-size=\"11\">{x:.2} kN, {y:.2} kN{note}</text>", line + 19.0)
}
