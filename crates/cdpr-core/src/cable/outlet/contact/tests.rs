//! Jacobians of contact points against dual numbers, and the laws that they obey.

use nalgebra::{Const, SVector};
use num_dual::DualVec;
use proptest::prelude::*;

use super::*;
use crate::scalar::rotate;
use cdpr_testing::property;

/// Derivatives by the platform anchor.
type Dual = DualVec<f64, Const<3>>;

fn gradient(value: &Dual) -> [f64; 3] {
    value.eps.unwrap_generic(Const, Const::<1>).into()
}

fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    let d = sub(a, b);
    dot(d, d).sqrt()
}

/// Outlets of every kind with an axis in any direction; the anchor of the sided one lies in its plane.
fn outlets() -> impl Strategy<Value = (Outlet<f64>, [f64; 3])> {
    let place = [-4.0..4.0_f64, -4.0..4.0_f64, -4.0..4.0_f64];
    (0..3_usize, place.clone(), place.clone(), 0.0..0.4_f64, place).prop_filter_map(
        "no course, or too near to the end of one for digits",
        |(kind, frame_anchor, axis, radius, anchor)| {
            let swivel_axis = scale(1.0 / dot(axis, axis).sqrt(), axis);
            let across = cross(swivel_axis, frame_anchor);
            let side = scale(1.0 / dot(across, across).sqrt(), across);
            let normal = cross(side, swivel_axis);
            let (outlet, anchor) = match kind {
                0 => (Outlet::Point { frame_anchor }, anchor),
                1 => (Outlet::Swivel { frame_anchor, swivel_axis, radius }, anchor),
                _ => {
                    let off_plane = dot(sub(anchor, frame_anchor), normal);
                    let in_plane = sub(anchor, scale(off_plane, normal));
                    (Outlet::Sided { frame_anchor, swivel_axis, side, radius }, in_plane)
                }
            };
            let path = outlet.path(anchor);
            let steepest = path.direction_gradient.iter().flatten().fold(0.0, |most: f64, x| most.max(x.abs()));
            // gradients of 1e3 per metre: millimetres beside axis or rim
            let is_clear = outlet.degeneracy(1, anchor, &path).is_none() && steepest < 1e3;
            is_clear.then_some((outlet, anchor))
        },
    )
}

proptest! {
    #![proptest_config(property::cases(500))]

    /// Both sides are exact, so only rounding separates them; it grows with the rate at which the direction turns.
    #[test]
    fn jacobians_of_contact_points_agree_with_dual_numbers((outlet, anchor) in outlets()) {
        let path = outlet.path(anchor);
        let contact = outlet.contact(anchor, &path);
        let variables = [0, 1, 2]
            .map(|k| Dual::new(anchor[k], num_dual::Derivative::some(SVector::<f64, 3>::ith(k, 1.0))));
        let in_duals = outlet.map(|&number| Dual::from(number));
        let dual_path = in_duals.path(variables);
        let dual = in_duals.contact(variables, &dual_path);
        let steepest = path.direction_gradient.iter().flatten().fold(1.0, |most: f64, x| most.max(x.abs()));
        let tolerance = 1e-12 * steepest;
        prop_assert!(distance(gradient(&dual_path.free_length), contact.free_length_by_anchor) < tolerance);
        prop_assert!(distance(gradient(&dual.arc_length), contact.arc_length_by_anchor) < tolerance);
        for k in 0..3 {
            prop_assert!(distance(gradient(&dual.point[k]), contact.point_by_anchor[k]) < tolerance, "row {k}");
        }
    }

    /// The free part runs from the contact point along −u and is tangent to the pulley there, and l = q_f u has ∂q_f =
    /// uᵀ J_l, which eq. 2.86 as printed (+u J_qu) violates.
    #[test]
    fn the_free_part_begins_at_the_contact_point((outlet, anchor) in outlets()) {
        let path = outlet.path(anchor);
        let contact = outlet.contact(anchor, &path);
        let from_anchor = add(anchor, scale(path.free_length, path.direction));
        // coordinates of a few metres, to rounding
        prop_assert!(distance(contact.point, from_anchor) < 1e-13);
        let u = path.direction;
        let [x, y, z] = contact.point_by_anchor;
        let along = [0, 1, 2].map(|k| u[0] * x[k] + u[1] * y[k] + u[2] * z[k]);
        prop_assert!(distance(sub(along, u), contact.free_length_by_anchor) < 1e-12);
        // the wrapped part is unstretched: a contact point that moves in the plane moves along the cable, against the
        // arc's growth
        prop_assert!(distance(along, scale(-1.0, contact.arc_length_by_anchor)) < 1e-12);
    }

    /// The anchor moves to first order along the twist; the changes of free part and arc add up to that of the whole,
    /// and l changes by that of p_A − p_B.
    #[test]
    fn by_the_pose_parts_sum_to_the_whole((outlet, anchor) in outlets(), twist in proptest::array::uniform6(-1.0..1.0_f64)) {
        let path = outlet.path(anchor);
        let end = CableEnd { anchor, moment_arm: [0.3, -0.2, 0.5] };
        let contact = outlet.contact(anchor, &path);
        let by_pose = contact.by_pose(&end);
        let along = |row: &[f64; 6]| row.iter().zip(&twist).map(|(entry, part)| entry * part).sum::<f64>();
        let (v, omega) = ([twist[0], twist[1], twist[2]], [twist[3], twist[4], twist[5]]);
        let length = path.by_pose(end.moment_arm).0;
        let moved = add(v, cross(omega, end.moment_arm));
        prop_assert!(distance(end.by_pose().map(|row| along(&row)), moved) < 1e-14);
        let parts = along(&by_pose.free_length) + along(&by_pose.arc_length);
        // gradients up to some hundred, on numbers of order one
        prop_assert!((parts - along(&length)).abs() < 1e-12);
        prop_assert!((parts + dot(path.direction, moved)).abs() < 1e-12);
        let point = rotate(&contact.point_by_anchor, moved);
        prop_assert!(distance(by_pose.point.map(|row| along(&row)), point) < 1e-11);
        prop_assert!(distance(by_pose.cable_vector.map(|row| along(&row)), sub(point, moved)) < 1e-11);
    }
}
