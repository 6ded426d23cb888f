//! Order of poses by a short path.

use cdpr_model::measurement::Samples;
use cdpr_model::model::Model;

/// Passes over the path, far more than it needs.
const PASSES: usize = 50;

/// Poses in the order of a short path from the robot's home: always to the nearest, then turned round wherever that is shorter.
pub(super) fn along_a_path(model: &Model, samples: &Samples, chosen: Vec<usize>) -> Vec<usize> {
    let robot = model.robot();
    let anchors = robot.cables.iter().map(|cable| cable.platform_anchor.norm());
    // a turn counts as the way of the farthest anchor
    let lever = anchors.fold(0.0, f64::max);
    let home = robot.home_or_middle();
    let pose = |place: Option<usize>| place.map_or(&home, |candidate| &samples.poses[candidate]);
    let way = |from: Option<usize>, to: usize| {
        let (from, to) = (pose(from), pose(Some(to)));
        (to.position - from.position).norm() + lever * from.angle_to(to)
    };
    let mut rest = chosen;
    let mut path: Vec<usize> = Vec::with_capacity(rest.len());
    while !rest.is_empty() {
        let last = path.last().copied();
        let near = |a: &usize, b: &usize| way(last, rest[*a]).total_cmp(&way(last, rest[*b]));
        let next = (0..rest.len()).min_by(near).unwrap_or(0);
        path.push(rest.remove(next));
    }
    for _ in 0..PASSES {
        let mut is_shorter = false;
        for first in 0..path.len() {
            for last in first + 1..path.len() {
                let before = first.checked_sub(1).map(|place| path[place]);
                let after = path.get(last + 1).copied();
                let tail = |end: usize| after.map_or(0.0, |after| way(Some(end), after));
                let now = way(before, path[first]) + tail(path[last]);
                if way(before, path[last]) + tail(path[first]) < now - 1e-9 {
                    path[first..=last].reverse();
                    is_shorter = true;
                }
            }
        }
        if !is_shorter {
            break;
        }
    }
    path
}
