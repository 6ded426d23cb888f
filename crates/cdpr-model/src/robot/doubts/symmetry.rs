//! One anchor beside the place that the symmetry of all others gives it.
//!
//! A symmetry mirrors one axis or several about a centre, which pairs of anchors show. A displaced anchor leaves itself and its image without
//! partners under every symmetry that the others have: a finding is returned where two symmetries or more agree on its place.

use nalgebra::Vector3;

use crate::finding::{Finding, FindingKind, Severity};
use crate::robot::Robot;

/// Distances that count as none, and that count as far, as parts of the largest distance of two anchors.
const SAME: f64 = 0.005;
const FAR: f64 = 0.02;

/// Symmetries that have to agree where one coordinate is beside its place, as a mistyped one is, and where several are: four anchors of which
/// three are corners of a rectangle have three.
const AGREEING: [usize; 2] = [2, 4];

/// Axes that are mirrored about a centre.
#[derive(Clone, Copy)]
struct Mirror {
    flipped: [bool; 3],
    centre: Vector3<f64>,
}

/// Point that a symmetry of the others does not find at the place of an image.
#[derive(Clone, Copy, PartialEq)]
struct Displaced {
    index: usize,
    expected: Vector3<f64>,
    flipped: [bool; 3],
}

impl Mirror {
    fn image(&self, point: &Vector3<f64>) -> Vector3<f64> {
        Vector3::from_fn(|axis, _| match self.flipped[axis] {
            true => 2.0 * self.centre[axis] - point[axis],
            false => point[axis],
        })
    }
}

/// Frame anchors, then platform anchors.
pub(super) fn anchor_beside_the_symmetry(robot: &Robot) -> Vec<Finding> {
    let frame: Vec<Vector3<f64>> = robot.cables.iter().map(|cable| cable.frame_anchor).collect();
    let platform: Vec<Vector3<f64>> = robot.cables.iter().map(|cable| cable.platform_anchor).collect();
    [("frame", frame), ("platform", platform)]
        .into_iter()
        .filter_map(|(kind, points)| {
            let found = displaced(&points);
            let first = *found.first()?;
            let beside = (points[first.index] - first.expected).norm();
            let place = |one: &Displaced| {
                let [x, y, z] = [one.expected.x, one.expected.y, one.expected.z];
                format!("({x:.3}, {y:.3}, {z:.3}) m")
            };
            let mut text = format!(
                "the {kind} anchor of cable {} (\"{}\") lies {beside:.3} m beside {}, the place that the symmetry of the others gives it",
                first.index + 1,
                robot.cables[first.index].name,
                place(&first)
            );
            for other in &found[1..] {
                text.push_str(&format!(", or else that of cable {} beside {}", other.index + 1, place(other)));
            }
            text.push_str("; if it is meant so, nothing is wrong");
            let finding = Finding::new(FindingKind::Anchor, Severity::Remark, text).of_size(beside, "m");
            Some(if found.len() == 1 { finding.of_cable(first.index) } else { finding })
        })
        .collect()
}

/// The point that is displaced, or the two that may be; none where the points have another symmetry or none.
fn displaced(points: &[Vector3<f64>]) -> Vec<Displaced> {
    let pairs = || points.iter().flat_map(|one| points.iter().map(move |other| (one - other).norm()));
    let size = pairs().fold(0.0, f64::max);
    if points.len() < 4 || size <= 0.0 {
        return Vec::new();
    }
    let tolerance = SAME * size;
    let (mut kept, mut found) = (Vec::new(), Vec::new());
    // an axis along which nothing extends mirrors nothing
    let extends = [0, 1, 2].map(|axis| points.iter().any(|point| (point[axis] - points[0][axis]).abs() > tolerance));
    for flips in 1..8_u8 {
        let flipped = [0, 1, 2].map(|axis| flips & (1 << axis) != 0);
        if (0..3).any(|axis| flipped[axis] && !extends[axis]) {
            continue;
        }
        match of_mirror(points, flipped, tolerance) {
            Ok(mirror) => kept.push(mirror),
            Err(displaced) => found.extend(displaced),
        }
    }
    // a symmetry that all points have and that moves a point would be broken by another place of it
    let may_move = |one: &Displaced| {
        let point = &points[one.index];
        kept.iter().all(|mirror| (mirror.image(point) - point).norm() <= tolerance)
    };
    let beside = |one: &Displaced| points[one.index] - one.expected;
    // a place that two cables share was meant
    let is_shared =
        |one: &Displaced| points.iter().filter(|other| (*other - points[one.index]).norm() <= tolerance).count() > 1;
    found.retain(|one| may_move(one) && !is_shared(one) && beside(one).norm() > FAR * size);
    let agree =
        |a: &Displaced, b: &Displaced| a.index == b.index && (a.expected - b.expected).norm() <= 2.0 * tolerance;
    let support = |one: &Displaced| {
        let mut symmetries: Vec<[bool; 3]> =
            found.iter().filter(|other| agree(one, other)).map(|other| other.flipped).collect();
        symmetries.sort_unstable();
        symmetries.dedup();
        symmetries.len()
    };
    let most = found.iter().map(support).max().unwrap_or(0);
    let mut best: Vec<Displaced> = Vec::new();
    for one in found.iter().filter(|one| support(one) == most) {
        if !best.iter().any(|other| agree(one, other)) {
            best.push(*one);
        }
    }
    let coordinates = |one: &Displaced| beside(one).iter().filter(|along| along.abs() > 2.0 * tolerance).count();
    let is_sure = best.iter().all(|one| most >= AGREEING[usize::from(coordinates(one) > 1)]);
    match is_sure && best.len() <= 2 {
        true => best,
        false => Vec::new(),
    }
}

/// The centre about which all points are symmetric, or the points that are displaced about a centre of all others.
fn of_mirror(points: &[Vector3<f64>], flipped: [bool; 3], tolerance: f64) -> Result<Mirror, Vec<Displaced>> {
    let mut found = Vec::new();
    for (first, one) in points.iter().enumerate() {
        for other in &points[first..] {
            let mirror = Mirror { flipped, centre: 0.5 * (one + other) };
            if (mirror.image(one) - other).norm() > tolerance {
                continue;
            }
            let has_partner = |point: &Vector3<f64>| {
                let image = mirror.image(point);
                points.iter().any(|other| (other - image).norm() <= tolerance)
            };
            let alone: Vec<usize> = (0..points.len()).filter(|&index| !has_partner(&points[index])).collect();
            let displaced = |index, expected| Displaced { index, expected, flipped };
            match alone[..] {
                [] => return Ok(mirror),
                [only] => found.push(displaced(only, 0.5 * (points[only] + mirror.image(&points[only])))),
                [a, b] => {
                    found.push(displaced(a, mirror.image(&points[b])));
                    found.push(displaced(b, mirror.image(&points[a])));
                }
                _ => {}
            }
        }
    }
    Err(found)
}
