//! The cables file: named sets of cables, of which one is imported.

use std::collections::BTreeMap;

use nalgebra::Vector3;

use super::bodies::{Body, quoted_name};
use super::findings::{Findings, Loss};
use crate::reading::{Element, ReadError, help_for_unknown};
use crate::robot::{Cable, CableStiffness, Pulley};

/// Cables that are imported completely: CASPR's ideal cable, and the linear spring (k = K/length, our
/// `axial_stiffness`).
const TAKEN: &[&str] = &["cable_ideal", "cable_linear_spring"];

/// Cables with devices of variable stiffness, for which the file format has no law; the device is left out.
const TAKEN_WITHOUT_DEVICE: &[&str] = &["cable_vsd_torsion_spring", "cable_vsd_flexure_linear", "cable_vsd_polynomial"];

/// Cables that pull without a winch, which the library does not have.
const PASSIVE: &[&str] = &["cable_passive_linear_spring"];

/// Largest distance of an anchor from a plane by rounding of its digits (m).
const PLANE_TOLERANCE: f64 = 1e-9;

/// The imported set.
pub(super) struct CableSet<'t, 'a> {
    pub(super) name: String,
    /// Names of all sets.
    pub(super) all: Vec<String>,
    pub(super) cables: Vec<Cable>,
    pub(super) element: Element<'t, 'a>,
}

/// Reads the set of this name, or the default one.
pub(super) fn read<'t, 'a>(
    root: &Element<'t, 'a>,
    wanted: Option<&str>,
    body: &Body,
    findings: &mut Findings,
) -> Result<CableSet<'t, 'a>, ReadError> {
    findings.add_unknown_inside(root, &["cable_set"]);
    let sets: Vec<Element<'t, 'a>> = root.elements().filter(|element| element.name() == "cable_set").collect();
    let names = sets.iter().map(|set| set.required_attribute("id")).collect::<Result<Vec<&str>, _>>()?;
    let index = chosen(root, &names, wanted)?;
    let element = sets[index];
    let mut cables = Vec::new();
    for cable in element.elements() {
        cables.extend(read_cable(&cable, body, findings)?);
    }
    if cables.is_empty() {
        let message = format!("the cable set `{}` has no cable that a winch drives", names[index]);
        return Err(element.error("robot::no-cables", message));
    }
    rename_doubles(&element, &mut cables, findings);
    let all = names.iter().map(|&name| name.to_owned()).collect();
    Ok(CableSet { name: names[index].to_owned(), all, cables, element })
}

/// Index of the set of this name, or of the default one.
fn chosen(root: &Element<'_, '_>, names: &[&str], wanted: Option<&str>) -> Result<usize, ReadError> {
    let place = |name: &str| names.iter().position(|known| *known == name);
    match (wanted, root.attribute("default_cable_set")) {
        (Some(wanted), _) => place(wanted).ok_or_else(|| {
            let message = format!("there is no cable set `{wanted}`");
            root.error("caspr::cable-set", message).with_help(help_for_unknown(wanted, names))
        }),
        (None, Some(default)) => place(default).ok_or_else(|| {
            let message = format!("the default cable set `{default}` is not in the file");
            root.attribute_error("default_cable_set", "caspr::cable-set", message)
                .with_help(help_for_unknown(default, names))
        }),
        (None, None) if names.len() == 1 => Ok(0),
        (None, None) => Err(root
            .error("caspr::cable-set", format!("{} cable sets and no default among them", names.len()))
            .with_help(format!("name one of them: {}", names.join(", ")))),
    }
}

/// Renames cables with a repeated name: names are unique in a robot file, but not in CASPR.
fn rename_doubles(set: &Element<'_, '_>, cables: &mut [Cable], findings: &mut Findings) {
    let mut seen: BTreeMap<String, usize> = BTreeMap::new();
    let taken: Vec<String> = cables.iter().map(|cable| cable.name.clone()).collect();
    for cable in cables {
        let count = seen.entry(cable.name.clone()).and_modify(|count| *count += 1).or_insert(1);
        if *count > 1 {
            let free = |number: usize| Some(format!("{}-{number}", cable.name)).filter(|name| !taken.contains(name));
            let name = (*count..).find_map(free).unwrap_or_default();
            findings.add(Loss::Ignored, set, format!("a second cable `{}` is called `{name}`", cable.name));
            cable.name = name;
        }
    }
}

/// Reads one cable; `None`, and a finding, for a passive spring.
fn read_cable(element: &Element<'_, '_>, body: &Body, findings: &mut Findings) -> Result<Option<Cable>, ReadError> {
    let kind = element.name();
    if PASSIVE.contains(&kind) {
        let why = "a passive spring, which no key of a robot file holds; tensions and poses under load will differ";
        findings.add(Loss::LeftOut, element, why);
        return Ok(None);
    }
    if !TAKEN.contains(&kind) && !TAKEN_WITHOUT_DEVICE.contains(&kind) {
        let known: Vec<&str> = [TAKEN, TAKEN_WITHOUT_DEVICE, PASSIVE].concat();
        let message = format!("<{kind}>{} is no cable that can be imported", quoted_name(element));
        return Err(element.error("caspr::cable-type", message).with_help(help_for_unknown(kind, &known)));
    }
    findings.add_unknown_inside(element, &["properties", "attachments"]);
    let mut cable = Cable { name: element.required_attribute("name")?.trim().to_owned(), ..Cable::default() };
    properties(element, &mut cable, findings)?;
    attachments(element, body, &mut cable)?;
    Ok(Some(cable))
}

/// Reads limits of tension, and stiffness.
fn properties(element: &Element<'_, '_>, cable: &mut Cable, findings: &mut Findings) -> Result<(), ReadError> {
    let properties = element.required("properties")?;
    let limit = |name: &str| -> Result<Option<f64>, ReadError> {
        let Some(limit) = properties.child(name)? else { return Ok(None) };
        if limit.text()?.eq_ignore_ascii_case("inf") {
            return Ok(None);
        }
        match limit.number()? {
            below if below < 0.0 => {
                let message = format!("{name} of cable `{}` is {below}; it cannot be negative", cable.name);
                Err(limit.content_error("robot::negative", message))
            }
            fine => Ok(Some(fine)),
        }
    };
    (cable.tension_min, cable.tension_max) = (limit("force_min")?, limit("force_max")?);
    if let (Some(min), Some(max)) = (cable.tension_min, cable.tension_max)
        && min > max
    {
        let message = format!("force_min = {min} of cable `{}` is above force_max = {max}", cable.name);
        return Err(properties.required("force_min")?.content_error("robot::tension-limits", message));
    }
    let mut known = vec!["force_min", "force_max"];
    if element.name() == "cable_linear_spring" {
        known.push("K");
        let stiffness = properties.required("K")?;
        cable.stiffness = match stiffness.number()? {
            number if number > 0.0 => Some(CableStiffness::Axial(number)),
            number => {
                let message = format!("K of cable `{}` is {number}; it must be above zero", cable.name);
                return Err(stiffness.content_error("robot::not-positive", message));
            }
        };
    }
    let lost: Vec<&str> =
        properties.elements().map(|inner| inner.name()).filter(|name| !known.contains(name)).collect();
    if TAKEN_WITHOUT_DEVICE.contains(&element.name()) {
        let why = format!("taken as a rigid cable without its variable-stiffness device ({})", lost.join(", "));
        findings.add(Loss::Simplified, element, why);
    } else if !lost.is_empty() {
        findings.add(Loss::Simplified, element, format!("taken without {}", lost.join(", ")));
    }
    Ok(())
}

/// Reads both ends: a point or a rotating pulley at the base, a point at the platform.
fn attachments(element: &Element<'_, '_>, body: &Body, cable: &mut Cable) -> Result<(), ReadError> {
    let list: Vec<Element<'_, '_>> = element.required("attachments")?.elements().collect();
    let [first, second] = list[..] else {
        let message = format!("cable `{}` runs over {} attachments; cables here have two ends", cable.name, list.len());
        let place = list.get(2).unwrap_or(element);
        return Err(place.error("caspr::routing", message).with_help("one attachment at link 0 and one at link 1"));
    };
    let (base, moving) = match link_of(&first)? {
        Some(1) => (second, first),
        _ => (first, second),
    };
    let links = (link_of(&base)?, link_of(&moving)?);
    if !matches!(links, (None | Some(0), Some(1))) {
        let message = format!("cable `{}` does not run from the base (link 0) to the platform (link 1)", cable.name);
        return Err(element.error("caspr::links", message));
    }
    match base.name() {
        "base_rotating_pulley" => pulley(&base, body, cable)?,
        _ => cable.frame_anchor = Vector3::from(base.required("location")?.vector()?),
    }
    let location = moving.required("location")?;
    let stated = Vector3::from(location.vector()?);
    cable.platform_anchor = match element.required_attribute("attachment_reference")? {
        "joint" => stated,
        "com" => body.center_of_mass + stated,
        other => {
            let message = format!("attachment_reference is `joint` or `com`, not `{other}`");
            return Err(element.attribute_error("attachment_reference", "caspr::reference", message));
        }
    };
    flatten(&base, body, cable)
}

/// The link of an attachment; `None` for a pulley, which is on the base.
fn link_of(attachment: &Element<'_, '_>) -> Result<Option<usize>, ReadError> {
    match attachment.name() {
        "attachment" => Ok(Some(attachment.required("link")?.index()?)),
        "base_rotating_pulley" => Ok(None),
        other => Err(attachment
            .error("caspr::attachment", format!("<{other}> is no attachment that can be imported"))
            .with_help(help_for_unknown(other, &["attachment", "base_rotating_pulley"]))),
    }
}

fn pulley(element: &Element<'_, '_>, body: &Body, cable: &mut Cable) -> Result<(), ReadError> {
    cable.frame_anchor = Vector3::from(element.required("fixed_location")?.vector()?);
    let radius = element.required("pulley_radius")?;
    let radius = match radius.number()? {
        below if below < 0.0 => {
            let message = format!("the pulley radius of cable `{}` is {below}; it cannot be negative", cable.name);
            return Err(radius.content_error("robot::negative", message));
        }
        fine => fine,
    };
    let entry = element.required("cable_entry_vector")?;
    // CASPR accepts an entry vector of any length
    let axis = Vector3::from(entry.vector()?).try_normalize(0.0).ok_or_else(|| {
        entry.content_error("robot::swivel-axis", "cable_entry_vector is zero and so without direction")
    })?;
    if body.joint.out_of_plane(&axis).abs() > PLANE_TOLERANCE {
        let message = format!("the pulley of cable `{}` does not stand in the plane of the robot", cable.name);
        return Err(entry.content_error("caspr::out-of-plane", message));
    }
    cable.pulley = Some(Pulley::Whole { radius, swivel_axis: axis.into() });
    Ok(())
}

/// Reduces the anchors of a planar robot to their components in the plane; a cable that leaves the plane is an error.
fn flatten(base: &Element<'_, '_>, body: &Body, cable: &mut Cable) -> Result<(), ReadError> {
    let joint = &body.joint;
    let across = cable.frame_anchor - body.origin - cable.platform_anchor;
    if joint.out_of_plane(&across).abs() > PLANE_TOLERANCE {
        let message = format!(
            "cable `{}` leaves the plane {} of the robot by {} m",
            cable.name,
            joint.plane.axes(),
            joint.out_of_plane(&across)
        );
        return Err(base
            .error("caspr::out-of-plane", message)
            .with_help("a robot whose cables leave its plane is spatial"));
    }
    cable.frame_anchor = joint.in_plane(&cable.frame_anchor);
    cable.platform_anchor = joint.in_plane(&cable.platform_anchor);
    if let Some(axis) = cable.pulley_swivel_axis() {
        cable.set_pulley_swivel_axis(joint.in_plane(&axis));
    }
    Ok(())
}
