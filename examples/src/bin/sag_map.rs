//! What sag changes: one cable by its tension, and a robot with 14 mm steel cables over its workspace.
//!
//! `cargo run -p examples --bin sag_map [FOLDER]` prints the tables of the book's chapter “Sag”; with a folder it also draws
//! the chapter's figures there (a minute).

#![expect(clippy::print_stdout, reason = "the tables are what it is for")]

use std::error::Error;
use std::path::Path;

use cdpr::cable::law::{CableLaw, Kind};
use cdpr::cable::outlet::Outlet;
use cdpr::cable::span::{Shape, SpanState};
use cdpr::cable::stretch::Stretch;
use cdpr::cable::{CableInput, CableStateError, Recording};
use cdpr::equilibrium::distribution;
use cdpr::model::{Composition, Model, Supported};
use cdpr::robot::Robot;
use cdpr::statics::Load;
use cdpr::study::effects::{Contribution, EffectState, contributions, largest};
use cdpr::tension::Limits;
use examples::drawing::{Grid, Panel, Picture};

/// 14 mm steel rope (kg/m).
const DENSITY: f64 = 0.8;
const GRAVITY: f64 = 9.81;

fn main() -> Result<(), Box<dyn Error>> {
    let folder = std::env::args().nth(1);
    let level = level_span()?;
    let steep = two_lengths()?;
    finite_elements()?;
    let grid = map(if folder.is_some() { 0.5 } else { 2.0 })?;
    if let Some(folder) = folder {
        let folder = Path::new(&folder);
        std::fs::write(folder.join("sag-of-a-cable.svg"), cable_figure(&level, &steep))?;
        std::fs::write(folder.join("sag-map.svg"), map_figure(&grid))?;
    }
    Ok(())
}

// ANCHOR: cable
/// A rope of 0.8 kg/m from a fixed point, which keeps its length.
fn rope(shape: Shape) -> CableLaw {
    CableLaw {
        outlet: Outlet::Point { frame_anchor: [0.0; 3] },
        stretch: Stretch::Rigid,
        hidden_length: 0.0,
        series_compliance: 0.0,
        weight: [0.0, 0.0, -DENSITY * GRAVITY],
        recording: Recording::EXACT,
        kind: Kind::Sagging(shape),
    }
}

/// Sag in the middle and length beyond the chord (m) of a rope to `end` with this tension at its outlet (N).
fn sag(end: [f64; 3], tension: f64) -> Result<(f64, f64), CableStateError> {
    let cable = rope(Shape::Catenary).state(end, CableInput::OutletTension(tension))?;
    let half = SpanState { force: cable.span.force, length: 0.5 * cable.span.length };
    let middle = Shape::Catenary.vector(&half, [0.0, 0.0, -DENSITY * GRAVITY], &Stretch::Rigid);
    let chord = end.iter().map(|x| x * x).sum::<f64>().sqrt();
    Ok((0.5 * end[2] - middle[2], cable.controlled_length - chord))
}
// ANCHOR_END: cable

/// Tension, sag and extra length of a level span of 10 m.
fn level_span() -> Result<Vec<[f64; 3]>, CableStateError> {
    println!("| tension at the outlet N | sag in the middle mm | longer than the chord mm |\n|---|---|---|");
    let mut rows = Vec::new();
    for tension in [250.0, 500.0, 1000.0, 2000.0, 4000.0, 8000.0] {
        let (depth, extra) = sag([10.0, 0.0, 0.0], tension)?;
        println!("| {tension} | {:.2} | {:.4} |", 1e3 * depth, 1e3 * extra);
        // the parabola p l²/(8 T) and p² l³/(24 T²), whose error is of second order in p l/T
        let ratio = DENSITY * GRAVITY * 10.0 / tension;
        assert!((depth / (10.0 * ratio / 8.0) - 1.0).abs() < ratio * ratio);
        assert!((extra / (10.0 * ratio * ratio / 24.0) - 1.0).abs() < ratio * ratio);
        rows.push([tension, depth, extra]);
    }
    Ok(rows)
}

/// Length and tension at the lower end, where the outlet is, of a span of 6 m × 4 m.
fn two_lengths() -> Result<Vec<(f64, f64)>, CableStateError> {
    let end = [6.0, 0.0, 4.0];
    let tension = |length: f64| -> Result<f64, CableStateError> {
        Ok(rope(Shape::Catenary).state(end, CableInput::ControlledLength(length))?.outlet_tension)
    };
    let points = (0..=120).map(|k| 7.215 + 0.065 * f64::from(k));
    let points: Vec<(f64, f64)> =
        points.map(|length| Ok((length, tension(length)?))).collect::<Result<_, CableStateError>>()?;
    let least = points.iter().copied().fold((0.0, f64::INFINITY), |a, b| if b.1 < a.1 { b } else { a });
    println!("\n6 m × 4 m: least tension at the lower end {:.1} N, at {:.2} m", least.1, least.0);
    assert!((least.1 - 24.4).abs() < 0.1, "{least:?}");
    let taut = rope(Shape::Catenary).state(end, CableInput::OutletTension(40.0))?.controlled_length;
    println!("40 N there belong to {taut:.3} m, and to a longer rope");
    Ok(points)
}

/// How near chains of elements come to the catenary.
fn finite_elements() -> Result<(), CableStateError> {
    let end = [8.0, 0.0, 6.0];
    let exact = rope(Shape::Catenary).state(end, CableInput::OutletTension(1000.0))?.controlled_length;
    println!("\n| elements | length error µm | order |\n|---|---|---|");
    let mut before = None;
    for count in [1, 2, 4, 8, 16, 32] {
        let length =
            rope(Shape::FiniteElements(count)).state(end, CableInput::OutletTension(1000.0))?.controlled_length;
        let error = (length - exact).abs();
        let order = before.map(|before: f64| (before / error).log2());
        println!("| {count} | {:.3} | {} |", 1e6 * error, order.map_or("–".to_owned(), |order| format!("{order:.2}")));
        assert!(order.is_none_or(|order| (order - 2.0).abs() < 0.1));
        before = Some(error);
    }
    Ok(())
}

/// What leaving sag out changes, at the points of a horizontal slice.
struct Map {
    x: Vec<f64>,
    y: Vec<f64>,
    /// Largest change of a length (m), displacement (m) without winch offsets and with offsets set at home, largest change of
    /// the tension distribution (N); NaN where no tensions within the limits hold the platform.
    values: [Vec<f64>; 4],
}

// ANCHOR: map
/// The helicopter cabin of the CableRobot Simulator with the weight of its cables.
fn simulator() -> Result<(Robot, Supported), Box<dyn Error>> {
    let mut robot = Robot::builtin("cablerobot-simulator-helicopter").ok_or("not built in")?;
    for cable in &mut robot.cables {
        cable.linear_density = Some(DENSITY);
    }
    let supported = Composition::supported(&robot)?;
    Ok((robot, supported))
}

/// What the effect `catenary` contributes at a position, `None` where no tensions within the limits balance the load.
fn contribution(
    machine: &Model,
    supported: &Supported,
    x: f64,
    y: f64,
) -> Result<Option<Contribution>, Box<dyn Error>> {
    let mut pose = machine.robot().home.ok_or("no home pose")?;
    (pose.position.x, pose.position.y) = (x, y);
    let load = Load::of(machine.robot())?;
    let found = distribution::solve(machine, &pose, &load, &Limits::of(machine.robot(), None, None)?)?;
    if found.reason.is_some() {
        return Ok(None);
    }
    let state = EffectState { pose, load: Ok(load), tensions: Some(found.tensions) };
    let all = contributions(machine, supported, &state)?;
    Ok(all.into_iter().find(|one| one.effect == "catenary" && one.replaced_by.is_none()))
}
// ANCHOR_END: map

fn map(step: f64) -> Result<Map, Box<dyn Error>> {
    let (robot, supported) = simulator()?;
    let machine = Model::new(robot, supported.richest)?;
    let along = |half: f64| -> Vec<f64> {
        let count = (2.0 * half / step).round() as i32;
        (0..=count).map(|k| -half + step * f64::from(k)).collect()
    };
    let mut map = Map { x: along(3.0), y: along(4.0), values: Default::default() };
    for &y in &map.y {
        for &x in &map.x {
            let found = contribution(&machine, &supported, x, y)?;
            let numbers = found.and_then(|found| {
                let length = largest(found.lengths.ok()?);
                let (plain, set) = (found.platform.ok()?, found.platform_beyond_home.ok()?);
                Some([length, plain.translation, set.translation, found.distribution.ok()?])
            });
            for (list, value) in map.values.iter_mut().zip(numbers.unwrap_or([f64::NAN; 4])) {
                list.push(value);
            }
        }
    }
    summary(&map);
    Ok(map)
}

fn summary(map: &Map) {
    let names = ["cable mm", "platform mm", "platform mm, offsets set at home", "tension N"];
    println!("\n| what sag changes | least | largest |\n|---|---|---|");
    for ((name, list), scale) in names.iter().zip(&map.values).zip([1e3, 1e3, 1e3, 1.0]) {
        let finite = || list.iter().copied().filter(|value| value.is_finite());
        let (least, most) = (finite().fold(f64::INFINITY, f64::min), finite().fold(0.0, f64::max));
        println!("| {name} | {:.3} | {:.3} |", scale * least, scale * most);
    }
    let (lengths, count) = (&map.values[0], map.values[0].len());
    let known = lengths.iter().filter(|value| value.is_finite()).count();
    println!("{known} of {count} points can be held");
    // from taut cables in the middle to nearly slack ones at the edge
    assert!(known > 0 && lengths.iter().all(|length| !(*length > 2e-2)), "{lengths:?}");
}

/// Edges of the bands: mm, mm, mm and N.
const LEVELS: [&[f64]; 4] = [
    &[0.2, 0.3, 0.5, 1.0, 2.0, 5.0, 10.0],
    &[0.3, 0.4, 0.5, 0.7, 1.0, 1.5, 2.0, 3.0],
    &[0.0, 0.1, 0.2, 0.5, 1.0, 2.0, 3.0],
    &[160.0, 180.0, 200.0, 220.0, 240.0, 260.0],
];

fn map_figure(map: &Map) -> String {
    let titles = [
        "largest change of a cable length, mm",
        "platform displacement, mm",
        "the same, offsets set at home (+), mm",
        "largest change of a tension, N",
    ];
    let mut picture = Picture::new(720.0, 742.0, "What sag changes over a horizontal slice of the workspace");
    for (index, (title, values)) in titles.iter().zip(&map.values).enumerate() {
        let (column, row) = ((index % 2) as f64, (index / 2) as f64);
        let panel = Panel {
            corner: (58.0 + 360.0 * column, 28.0 + 366.0 * row),
            size: (216.0, 288.0),
            x: (-3.0, 3.0),
            y: (-4.0, 4.0),
            is_logarithmic: false,
        };
        let scale = if index < 3 { 1e3 } else { 1.0 };
        let values = values.iter().map(|value| scale * value).collect();
        picture.text("start", (panel.corner.0, panel.corner.1 - 10.0), title);
        let ticks: (&[f64], &[f64]) = (&[-3.0, -2.0, -1.0, 0.0, 1.0, 2.0, 3.0], &[-4.0, -2.0, 0.0, 2.0, 4.0]);
        picture.axes(&panel, ticks, ("x in m", "y in m"));
        picture.map(&panel, &Grid { x: map.x.clone(), y: map.y.clone(), values }, LEVELS[index]);
        let dashed = r##"stroke="#1b1f24" stroke-dasharray="5 4""##;
        picture.curve(&panel, dashed, &[(-1.5, -1.5), (1.5, -1.5), (1.5, 1.5), (-1.5, 1.5), (-1.5, -1.5)]);
        if index < 3 {
            let (x, y) = panel.place((0.0, 0.0));
            picture.haloed((x, y + 4.0), "+");
        }
    }
    picture.finish()
}

fn cable_figure(level: &[[f64; 3]], steep: &[(f64, f64)]) -> String {
    let mut picture =
        Picture::new(760.0, 330.0, "Sag of a rope of 0.8 kg/m by its tension, and the two lengths of one tension");
    let sagging = Panel {
        corner: (58.0, 30.0),
        size: (290.0, 240.0),
        x: (250.0, 8000.0),
        y: (0.01, 1000.0),
        is_logarithmic: true,
    };
    picture.text("start", (58.0, 18.0), "level span of 10 m");
    let ticks: (&[f64], &[f64]) =
        (&[250.0, 500.0, 1000.0, 2000.0, 4000.0, 8000.0], &[0.01, 0.1, 1.0, 10.0, 100.0, 1000.0]);
    picture.axes(&sagging, ticks, ("tension at the outlet, N", "mm"));
    let of = |column: usize| level.iter().map(|row| (row[0], 1e3 * row[column])).collect::<Vec<_>>();
    picture.curve(&sagging, r##"stroke="#005a9c" stroke-width="2""##, &of(1));
    picture.curve(&sagging, r##"stroke="#a83c00" stroke-width="2" stroke-dasharray="7 4""##, &of(2));
    let (x, y) = sagging.place((1000.0, 1e3 * level[2][1]));
    picture.text("start", (x + 4.0, y - 8.0), "sag in the middle");
    let (x, y) = sagging.place((1000.0, 1e3 * level[2][2]));
    picture.text("start", (x + 4.0, y - 8.0), "longer than the chord");
    let two =
        Panel { corner: (440.0, 30.0), size: (290.0, 240.0), x: (7.0, 15.0), y: (0.0, 100.0), is_logarithmic: false };
    picture.text("start", (440.0, 18.0), "span of 6 m × 4 m, outlet at the lower end");
    picture.axes(
        &two,
        (&[7.0, 9.0, 11.0, 13.0, 15.0], &[0.0, 20.0, 40.0, 60.0, 80.0, 100.0]),
        ("length, m", "tension at the outlet, N"),
    );
    let shown: Vec<(f64, f64)> = steep.iter().copied().filter(|point| point.1 <= 100.0).collect();
    picture.curve(&two, r##"stroke="#005a9c" stroke-width="2""##, &shown);
    picture.curve(&two, r##"stroke="#a83c00" stroke-dasharray="5 4""##, &[(7.0, 24.4), (15.0, 24.4)]);
    let (x, y) = two.place((9.6, 24.4));
    picture.text("start", (x, y + 16.0), "none below 24.4 N");
    let (x, y) = two.place((7.4, 70.0));
    picture.text("start", (x + 6.0, y), "taut");
    let (x, y) = two.place((12.5, 42.0));
    picture.text("middle", (x, y - 10.0), "hanging");
    picture.finish()
}
