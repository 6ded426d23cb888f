//! Tables and drawings of a field of errors.

use std::fmt::Write;

use cdpr::geometry::Twist;
use cdpr::metamodel::field::{Field, Sample};
use cdpr::model::Model;

use crate::NamedFile;
use crate::figures::{Map, MapPoint};
use crate::number_format::short;

/// One row per commanded pose; empty cells where there is no answer.
pub fn errors_table(found: &Field) -> String {
    let cables = found.samples.iter().find_map(|sample| Some(sample.outcome.tensions.as_ref()?.len())).unwrap_or(0);
    let mut text = String::from(
        "pose,status,x_m,y_m,z_m,qx,qy,qz,qw,dx_m,dy_m,dz_m,rx_rad,ry_rad,rz_rad,linear_dx_m,linear_dy_m,linear_dz_m,\
         linear_rx_rad,linear_ry_rad,linear_rz_rad",
    );
    (1..=cables).for_each(|cable| text.push_str(&format!(",tension_N_{cable}")));
    text.push('\n');
    for (index, sample) in found.samples.iter().enumerate() {
        let (position, turn) = (sample.commanded.position, sample.commanded.rotation.coords);
        let mut cells = vec![(index + 1).to_string(), sample.outcome.status.name().to_owned()];
        cells.extend(position.iter().chain(turn.iter()).map(f64::to_string));
        let twist = |twist: &Option<Twist>| -> Vec<String> {
            twist.as_ref().map_or_else(|| vec![String::new(); 6], |twist| twist.iter().map(f64::to_string).collect())
        };
        cells.extend(twist(&sample.exact));
        cells.extend(twist(&sample.linear));
        let tensions = sample.outcome.tensions.as_deref().unwrap_or(&[]);
        cells.extend((0..cables).map(|cable| tensions.get(cable).map_or_else(String::new, f64::to_string)));
        let _ = writeln!(text, "{}", cells.join(","));
    }
    text
}

/// Position errors over the plane of a planar robot; of a spatial one seen along each axis, from above height by height where
/// the poses have few heights.
pub fn error_maps(found: &Field, machine: &Model) -> Vec<NamedFile> {
    let names = ["x", "y", "z"];
    let axes: Vec<usize> = machine.axes().iter().map(|axis| axis.iamax()).collect();
    let views: Vec<[usize; 2]> = match axes.as_slice() {
        &[first, second] => vec![[first, second]],
        _ => vec![[0, 1], [0, 2], [1, 2]],
    };
    let top = 1e3 * found.summary.position_error_m.max;
    let drawn = |[first, second]: [usize; 2], height: Option<f64>| {
        let point = |sample: &Sample| {
            let error = sample.exact?.fixed_rows::<3>(0).norm();
            let position = sample.commanded.position;
            let is_there = height.is_none_or(|height| (position.z - height).abs() < SAME_HEIGHT);
            is_there.then(|| MapPoint { at: [position[first], position[second]], error: 1e3 * error })
        };
        let (at, of) = height.map_or_else(Default::default, |height| {
            let height = short(height);
            (format!("-at-z-{}", height.replace('−', "-")), format!(" at z = {height} m"))
        });
        let map = Map {
            title: Vec::new(),
            arrows: Vec::new(),
            points: found.samples.iter().filter_map(point).collect(),
            axes: [names[first], names[second]].map(str::to_owned),
            top,
            colour_label: format!("position error in mm{of}"),
        };
        Some(NamedFile::new(format!("error-map-{}{}{at}.svg", names[first], names[second]), map.svg()?.file()))
    };
    let of_poses: Vec<f64> = found.samples.iter().map(|sample| sample.commanded.position.z).collect();
    let heights = if axes.len() > 2 { levels(&of_poses) } else { Vec::new() };
    let views = views.into_iter().map(|view| (view, None));
    views
        .chain(heights.into_iter().map(|height| ([0, 1], Some(height))))
        .filter_map(|(view, at)| drawn(view, at))
        .collect()
}

/// Heights nearer to each other than this are one (m).
pub(crate) const SAME_HEIGHT: f64 = 1e-6;
/// More heights than this are no levels but a cloud.
const MOST_HEIGHTS: usize = 7;

/// The different ones among the heights of poses; none where all have the same, or nearly each its own.
pub(crate) fn levels(of_poses: &[f64]) -> Vec<f64> {
    let mut heights = of_poses.to_vec();
    heights.sort_by(f64::total_cmp);
    heights.dedup_by(|a, b| (*a - *b).abs() < SAME_HEIGHT);
    let are_levels = (2..=MOST_HEIGHTS).contains(&heights.len()) && of_poses.len() >= 4 * heights.len();
    if are_levels { heights } else { Vec::new() }
}
