//! Whether fitted numbers can be those of a robot.

use super::examined::Examined;
use super::residual_table::median;
use crate::fit::Estimate;
use cdpr_model::finding::{Finding, FindingKind, Severity};
use cdpr_model::measurement::three_digits;
use cdpr_model::robot::ParameterKind;
use nalgebra::Vector3;

/// Factors between units, and what a ratio of this size makes think of.
pub const UNIT_FACTORS: [(f64, &str); 16] = [
    (0.3048, "a foot is 0.3048 m"),
    (1.0 / 0.3048, "a metre is 3.281 feet"),
    (0.0254, "an inch is 0.0254 m"),
    (1.0 / 0.0254, "a metre is 39.37 inches"),
    (0.01, "a centimetre is 0.01 m"),
    (100.0, "a metre is 100 cm"),
    (0.001, "a millimetre is 0.001 m"),
    (1000.0, "a metre is 1000 mm"),
    (0.1, "one is a tenth of the other"),
    (10.0, "one is ten times the other"),
    (4.448, "a pound-force is 4.448 N"),
    (1.0 / 4.448, "a newton is 0.2248 lbf"),
    (9.807, "a kilogram-force is 9.807 N"),
    (1.0 / 9.807, "a newton is 0.102 kgf"),
    (1e-6, "one is a millionth of the other"),
    (1e6, "one is a million times the other"),
];

/// How far a ratio may lie from a factor between units to be it.
const OF_UNIT: f64 = 0.01;
/// Scales beyond these are no winch's.
const SCALES: [f64; 2] = [0.5, 2.0];
/// Scales farther from one than this deserve a word, and a factor common to all of them from this on.
const SCALE_WORD: f64 = 0.02;
const COMMON_WORD: f64 = 0.003;
/// Anchors farther from the file than this fraction of the anchors' diagonal deserve a word, and those beyond so many deviations of their prior.
const ANCHOR_WORD: f64 = 0.05;
const PRIORS: f64 = 4.0;
/// Stiffness beyond this factor from the file's is another cable's, and beyond this one deserves a word.
const OTHER_STIFFNESS: f64 = 3.0;
const STIFFNESS_WORD: f64 = 1.2;
/// Standard deviations beyond which a difference is one.
const SURE: f64 = 3.0;

/// Words for a ratio where it is a factor between units, to a hundredth and this relative slack.
pub(super) fn unit_factor(ratio: f64, slack: f64) -> Option<&'static str> {
    let is_near = |factor: f64| (ratio / factor - 1.0).abs() <= OF_UNIT + slack;
    UNIT_FACTORS.iter().find(|(factor, _)| is_near(*factor)).map(|(_, words)| *words)
}

/// Numbers that cannot be, or deserve a word.
pub(super) fn findings(examined: &Examined<'_>) -> Vec<Finding> {
    let scales = scales(examined, ParameterKind::LengthScale, "length scales", "positions or lengths");
    let tensions = scales_of_tensions(examined);
    let mut found: Vec<Finding> = scales.into_iter().chain(tensions).collect();
    found.extend(anchors(examined));
    found.extend(stiffness(examined));
    found
}

fn of_kind<'a>(examined: &Examined<'a>, kind: ParameterKind) -> Vec<&'a Estimate> {
    examined.fit.parameters.iter().filter(|estimate| estimate.parameter.kind == kind).collect()
}

/// Mean of the estimates by their deviations, and its own deviation.
fn common(estimates: &[&Estimate]) -> (f64, f64) {
    let weight = |estimate: &&&Estimate| 1.0 / estimate.sigma.unwrap_or(1.0).max(1e-12).powi(2);
    let sum: f64 = estimates.iter().map(|estimate| weight(&estimate)).sum();
    let mean = estimates.iter().map(|estimate| weight(&estimate) * estimate.value).sum::<f64>() / sum;
    (mean, (1.0 / sum).sqrt())
}

fn scales_of_tensions(examined: &Examined<'_>) -> Option<Finding> {
    scales(examined, ParameterKind::TensionScale, "tension scales", "tensions or the load")
}

fn scales(examined: &Examined<'_>, kind: ParameterKind, name: &str, of: &str) -> Option<Finding> {
    let estimates = of_kind(examined, kind);
    let farthest = estimates.iter().max_by(|a, b| a.value.ln().abs().total_cmp(&b.value.ln().abs()))?;
    let (mean, sigma) = common(&estimates);
    let values: Vec<f64> = estimates.iter().map(|estimate| estimate.value).collect();
    let (least, most) =
        values.iter().fold((f64::INFINITY, 0.0_f64), |(least, most), value| (least.min(*value), most.max(*value)));
    if let Some(unit) = unit_factor(median(values.iter().copied()), 0.0).filter(|_| least > 0.0 && most < 1.05 * least)
    {
        let text = format!(
            "not to be trusted: all {} {name} lie between {} and {}: {unit}; are {of} in another unit than their columns say?",
            values.len(),
            three_digits(least),
            three_digits(most)
        );
        return Some(Finding::new(FindingKind::Unit, Severity::Distrust, text).of_size(mean, ""));
    }
    let (scale, place) = (farthest.value, &farthest.name);
    if !(SCALES[0]..=SCALES[1]).contains(&scale) {
        let text =
            format!("not to be trusted: {place} = {}: no winch or load cell has such a scale", three_digits(scale));
        let found = Finding::new(FindingKind::Scale, Severity::Distrust, text).of_size(scale, "");
        return Some(found.of_cable(farthest.parameter.cable));
    }
    let is_common = estimates.len() > 1
        && (mean - 1.0).abs() > (SURE * sigma).max(COMMON_WORD)
        && most - least < 0.5 * (mean - 1.0).abs();
    if is_common && kind == ParameterKind::LengthScale {
        let text = format!(
            "all {} {name} have the factor {mean:.4} ± {sigma:.4} in common: gear ratio, drum radius, or a unit of length that is off",
            values.len()
        );
        return Some(Finding::new(FindingKind::Scale, Severity::Caution, text).of_size(mean, ""));
    }
    let is_off = |estimate: &&&Estimate| {
        let off = (estimate.value - 1.0).abs();
        off > SCALE_WORD && off > SURE * estimate.sigma.unwrap_or(0.0)
    };
    let off = estimates.iter().filter(is_off).max_by(|a, b| (a.value - 1.0).abs().total_cmp(&(b.value - 1.0).abs()))?;
    let text = format!("{} = {:.4}: a scale off by {:.1} %", off.name, off.value, 100.0 * (off.value - 1.0));
    let found = Finding::new(FindingKind::Scale, Severity::Caution, text).of_size(off.value, "");
    Some(found.of_cable(off.parameter.cable))
}

/// Anchors far from the file.
fn anchors(examined: &Examined<'_>) -> Option<Finding> {
    let (given, fitted) = (examined.given, examined.fit.model.robot());
    let free = |cable: usize, kind: ParameterKind| {
        examined.fit.parameters.iter().any(|one| one.parameter.kind == kind && one.parameter.cable == cable)
    };
    let diagonal = given.anchor_diagonal();
    let (low, high) = given
        .cables
        .iter()
        .fold((Vector3::repeat(f64::INFINITY), Vector3::repeat(f64::NEG_INFINITY)), |(low, high), cable| {
            (low.inf(&cable.frame_anchor), high.sup(&cable.frame_anchor))
        });
    let mut moved: Vec<(f64, usize, bool)> = Vec::new();
    for (cable, (before, after)) in given.cables.iter().zip(&fitted.cables).enumerate() {
        if !free(cable, ParameterKind::FrameAnchor) {
            continue;
        }
        let beyond = (low - after.frame_anchor).sup(&(after.frame_anchor - high)).max();
        moved.push(((after.frame_anchor - before.frame_anchor).norm(), cable, beyond > diagonal));
    }
    let farthest = moved.iter().max_by(|a, b| a.0.total_cmp(&b.0))?;
    let (distance, cable, _) = *farthest;
    if let Some(outside) = moved.iter().find(|(_, _, is_outside)| *is_outside) {
        let text = format!(
            "not to be trusted: the frame anchor of cable {} moves by {} m, out of the box of the file's anchors by more than its size",
            outside.1 + 1,
            three_digits(outside.0)
        );
        return Some(
            Finding::new(FindingKind::Anchor, Severity::Distrust, text).of_cable(outside.1).of_size(outside.0, "m"),
        );
    }
    let beyond_prior = examined
        .fit
        .parameters
        .iter()
        .filter(|one| one.parameter.kind == ParameterKind::FrameAnchor)
        .any(|one| one.prior_sigma.is_some_and(|sigma| one.change.abs() > PRIORS * sigma));
    (distance > ANCHOR_WORD * diagonal || beyond_prior).then(|| {
        let text = format!(
            "the frame anchor of cable {} lies {} m from the file's, {:.0} % of the diagonal of the anchors: mistyped, or measured in another frame?",
            cable + 1,
            three_digits(distance),
            100.0 * distance / diagonal
        );
        Finding::new(FindingKind::Anchor, Severity::Caution, text).of_cable(cable).of_size(distance, "m")
    })
}

/// Cables whose stiffness is far from the file's.
fn stiffness(examined: &Examined<'_>) -> Option<Finding> {
    let assumed = ["axial_stiffness_EA_N", "axial_compliance_per_N", "spring_constant_N_per_m"];
    if examined.given.assumptions.iter().any(|assumption| assumed.contains(&assumption.plain_key())) {
        return None;
    }
    let ratios: Vec<(f64, f64)> = examined
        .fit
        .parameters
        .iter()
        .filter_map(|estimate| {
            let (nominal, value) = (estimate.nominal?, estimate.value);
            let relative = estimate.sigma.unwrap_or(0.0) / value.abs().max(f64::MIN_POSITIVE);
            let ratio = match estimate.parameter.kind {
                ParameterKind::Compliance => nominal / value,
                ParameterKind::AxialStiffness | ParameterKind::SpringConstant => value / nominal,
                _ => return None,
            };
            (ratio.is_finite() && ratio > 0.0).then_some((ratio, relative))
        })
        .collect();
    let logarithms: Vec<f64> = ratios.iter().map(|(ratio, _)| ratio.ln()).collect();
    let middle = median(logarithms.iter().copied());
    let sigma = median(ratios.iter().map(|(_, relative)| *relative)) / (ratios.len().max(1) as f64).sqrt();
    if logarithms.is_empty() || middle.abs() < SURE * sigma {
        return None;
    }
    let (factor, found) = (middle.abs().exp(), middle.exp());
    let words = format!(
        "the cables are {} times as stiff as the robot file states (median of {})",
        three_digits(found),
        ratios.len()
    );
    let of = |severity: Severity, text: String| {
        Some(Finding::new(FindingKind::Stiffness, severity, text).of_size(found, ""))
    };
    match factor {
        other if other > OTHER_STIFFNESS => {
            of(Severity::Distrust, format!("not to be trusted: {words}: another cable, or tensions in another unit"))
        }
        some if some > STIFFNESS_WORD => of(Severity::Caution, words),
        _ => None,
    }
}
