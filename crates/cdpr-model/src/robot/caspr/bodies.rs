//! The bodies file: one rigid link, which is the platform.

use nalgebra::{Matrix3, Vector3};

use super::findings::{Findings, Loss};
use super::joint::Joint;
use crate::geometry::Pose;
use crate::reading::{Element, ReadError};
use crate::robot::{Platform, TravelBox};

/// The platform as the bodies file describes it.
pub(super) struct Body {
    /// Name of the link.
    pub(super) link: String,
    pub(super) joint: Joint,
    pub(super) home: Pose,
    pub(super) travel: Option<TravelBox>,
    pub(super) platform: Platform,
    /// Centre of mass (platform frame, m), also out of a planar robot's plane.
    pub(super) center_of_mass: Vector3<f64>,
    /// Origin of the joint's coordinates (world, m), also out of a planar robot's plane.
    pub(super) origin: Vector3<f64>,
}

/// Reads the only link of a system.
pub(super) fn read(root: &Element<'_, '_>, findings: &mut Findings) -> Result<Body, ReadError> {
    findings.add_unknown_inside(root, &["links"]);
    let links = root.required("links")?;
    let mut found = links.elements();
    let Some(link) = found.next() else {
        return Err(links.error("caspr::no-link", "there is no <link_rigid> in <links>"));
    };
    if let Some(second) = found.next() {
        let message =
            format!("a second link, <{}>{}: robots here have one moving platform", second.name(), quoted_name(&second));
        return Err(second
            .error("caspr::several-links", message)
            .with_help("chains of links cannot be imported; keep the link that the cables hold"));
    }
    if link.name() != "link_rigid" {
        let message = format!("the link <{}>{} is not a <link_rigid>", link.name(), quoted_name(&link));
        return Err(link.error("caspr::link", message));
    }
    body(&link, findings)
}

/// The name of an element in quotes, as part of a sentence; empty without a name.
pub(super) fn quoted_name(element: &Element<'_, '_>) -> String {
    element.attribute("name").map(|name| format!(" `{name}`")).unwrap_or_default()
}

fn body(link: &Element<'_, '_>, findings: &mut Findings) -> Result<Body, ReadError> {
    findings.add_unknown_inside(link, &["joint", "physical", "parent"]);
    let element = link.required("joint")?;
    let joint = Joint::read(&element)?;
    for attribute in element.attribute_names().filter(|name| !["type", "q_initial", "q_min", "q_max"].contains(name)) {
        let (loss, why) = match element.attribute(attribute) {
            Some("true" | "1") if attribute == "actuated" => {
                (Loss::LeftOut, "the drive of the joint itself".to_owned())
            }
            _ => (Loss::Ignored, format!("the attribute `{attribute}` has no place in a robot file")),
        };
        findings.add(loss, &element, why);
    }
    let origin = origin(&link.required("parent")?)?;
    let physical = link.required("physical")?;
    let (platform, center_of_mass) = platform(&physical, &joint, findings)?;
    Ok(Body {
        link: link.attribute("name").unwrap_or_default().trim().to_owned(),
        home: joint.home(&element, &origin, findings)?,
        travel: joint.travel(&element, &origin, findings)?,
        joint,
        platform,
        center_of_mass,
        origin,
    })
}

/// Origin of the joint (world, m).
fn origin(parent: &Element<'_, '_>) -> Result<Vector3<f64>, ReadError> {
    let number = parent.required("num")?;
    if number.index()? != 0 {
        return Err(number.content_error("caspr::parent", "the parent of the platform is the base, number 0"));
    }
    Ok(Vector3::from(parent.required("location")?.vector()?))
}

fn platform(
    physical: &Element<'_, '_>,
    joint: &Joint,
    findings: &mut Findings,
) -> Result<(Platform, Vector3<f64>), ReadError> {
    findings.add_unknown_inside(physical, &["mass", "com_location", "end_location", "inertia"]);
    let element = physical.required("mass")?;
    let mass = element.number()?;
    if mass < 0.0 {
        return Err(element.content_error("robot::negative", format!("a mass of {mass} kg; it cannot be negative")));
    }
    let element = physical.required("com_location")?;
    let center_of_mass = Vector3::from(element.vector()?);
    if joint.out_of_plane(&center_of_mass) != 0.0 {
        findings.add(Loss::Ignored, &element, "the part out of the plane, which no motion in the plane feels");
    }
    if let Some(element) = physical.child("end_location")?
        && element.vector()? != [0.0; 3]
    {
        findings.add(Loss::Ignored, &element, "the tool point of CASPR's operational space");
    }
    let inertia = inertia(&physical.required("inertia")?, joint, (mass, &center_of_mass), findings)?;
    let in_plane = joint.in_plane(&center_of_mass);
    Ok((
        Platform { mass: Some(mass), center_of_mass: Some(in_plane), inertia: Some(inertia), ..Platform::default() },
        center_of_mass,
    ))
}

/// Inertia about the centre of mass (kg·m²); for a planar robot the part about the normal.
fn inertia(
    element: &Element<'_, '_>,
    joint: &Joint,
    (mass, center): (f64, &Vector3<f64>),
    findings: &mut Findings,
) -> Result<Matrix3<f64>, ReadError> {
    findings.add_unknown_inside(element, &["Ixx", "Iyy", "Izz", "Ixy", "Ixz", "Iyz"]);
    let entry = |name| element.required(name)?.number();
    let (xx, yy, zz) = (entry("Ixx")?, entry("Iyy")?, entry("Izz")?);
    let (xy, xz, yz) = (entry("Ixy")?, entry("Ixz")?, entry("Iyz")?);
    let stated = Matrix3::new(xx, xy, xz, xy, yy, yz, xz, yz, zz);
    let matrix = match element.attribute("ref") {
        Some("com") => stated,
        // parallel axis theorem (Huygens and Steiner): inertia about the joint is larger
        Some("joint") => stated - (Matrix3::identity() * center.norm_squared() - center * center.transpose()) * mass,
        other => {
            let message = format!("inertia is about `com` or `joint`, not about `{}`", other.unwrap_or_default());
            return Err(element.attribute_error("ref", "caspr::reference", message));
        }
    };
    if matrix.diagonal().iter().any(|&moment| moment < 0.0) {
        return Err(element.error("robot::inertia", "a moment of inertia about the centre of mass cannot be negative"));
    }
    if !joint.pattern.is_planar() {
        return Ok(matrix);
    }
    let normal = joint.plane.normal();
    let about_normal = normal * normal.transpose() * normal.dot(&(matrix * normal));
    if matrix != about_normal {
        findings.add(Loss::Ignored, element, "all but the inertia about the plane's normal, which nothing else feels");
    }
    Ok(about_normal)
}
