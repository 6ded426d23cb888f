//! Profiles of parameters, bootstrap deviations and bands of poses: JSON, words, tables and figures.

use std::fmt::Write;

use cdpr_calibration::fit::{Fit, Profile};
use cdpr_calibration::{PoseBand, Resampled};
use cdpr_model::geometry::Pose;
use cdpr_model::model::Model;
use schemars::JsonSchema;
use serde::Serialize;

use crate::NamedFile;
use crate::figures::{ErrorPanel, ErrorRows, Map, MapPoint, ProfileCurves, profiles};
use crate::keys::{Each, Maybe, ProfileKeys, ResampledKeys};
use crate::number_format::{NONE, decimals_for, fixed, significant};
use crate::report::Addition;
use crate::study_page::{SAME_HEIGHT, levels};
use crate::table::Table;

/// Uncertainty of a fit beyond its linear deviations.
#[derive(Default, Serialize, JsonSchema)]
pub struct UncertaintyAnswer {
    /// Profiles of chosen parameters.
    #[serde(with = "Each::<ProfileKeys>", skip_serializing_if = "Vec::is_empty")]
    pub profiles: Vec<Profile>,
    /// Deviations of a bootstrap of blocks.
    #[serde(with = "Maybe::<ResampledKeys>", skip_serializing_if = "Option::is_none")]
    pub bootstrap: Option<Resampled>,
    /// Bands of poses that the calibrated model commands.
    #[serde(skip)]
    pub bands: Vec<(Pose, Option<PoseBand>)>,
    /// Doubt about the bands in words: parameters without a deviation.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub band_warning: Option<String>,
}

/// Doubt about bands that some parameters say nothing to.
fn band_warning(fit: &Fit) -> Option<String> {
    let (without, count) = (fit.without_deviation(), fit.parameters.len());
    (without > 0).then(|| match without == count {
        true => format!("none of the {count} parameters has a standard deviation, so there are none of the pose"),
        false => format!(
            "{without} of {count} parameters have no standard deviation and are left out, so that these are lower bounds of the pose's"
        ),
    })
}

/// A unit for people and the factor to it.
pub(super) fn shown(unit: &'static str) -> (&'static str, f64) {
    match unit {
        "m" => ("mm", 1e3),
        "1/N" => ("1/GN", 1e9),
        other => (other, 1.0),
    }
}

impl UncertaintyAnswer {
    /// Of what was found for a fit.
    pub fn new(
        fit: &Fit,
        profiles: Vec<Profile>,
        bootstrap: Option<Resampled>,
        bands: Vec<(Pose, Option<PoseBand>)>,
    ) -> Self {
        let band_warning = if bands.is_empty() { None } else { band_warning(fit) };
        Self { profiles, bootstrap, bands, band_warning }
    }

    pub(super) fn words(&self, width: Option<usize>) -> String {
        let mut text = String::new();
        if !self.profiles.is_empty() {
            text.push_str(&format!("\nprofiles, 95 % intervals\n\n{}", self.profile_table(width)));
        }
        if let Some(found) = &self.bootstrap {
            let Resampled { replicates, failed, block_length, .. } = found;
            let failures = if *failed > 0 { format!(", {failed} more without a fit") } else { String::new() };
            text.push_str(&format!(
                "\nbootstrap: {replicates} data sets of blocks of {block_length} samples{failures}\n\n{}",
                bootstrap_table(found, width)
            ));
        }
        text.extend(self.band_words());
        text
    }

    fn band_words(&self) -> Option<String> {
        let known: Vec<f64> = self.bands.iter().filter_map(|(_, band)| Some(band.as_ref()?.position)).collect();
        if self.bands.is_empty() {
            return None;
        }
        let doubt = self.band_warning.as_ref().map_or_else(String::new, |words| format!(": {words}"));
        let (mean, largest) =
            (known.iter().sum::<f64>() / known.len() as f64, known.iter().copied().fold(0.0, f64::max));
        Some(match known.len() {
            0 => format!("\nbands of poses{doubt}\n"),
            count => format!(
                "\nbands of {count} of {} poses{doubt}\nstandard deviation of the position {} mm in the mean, at most {} mm\n",
                self.bands.len(),
                significant(1e3 * mean, 3),
                significant(1e3 * largest, 3)
            ),
        })
    }

    fn profile_table(&self, width: Option<usize>) -> String {
        let mut table = Table::new(["parameter", "unit", "value", "by σ, from", "to", "by profile, from", "to"]);
        for profile in &self.profiles {
            let (unit, factor) = shown(profile.unit);
            let decimals = decimals_for(Some(factor * profile.sigma));
            let number = |value: f64| fixed(factor * value, decimals);
            let end = |end: Option<f64>| end.map_or_else(|| NONE.to_owned(), number);
            let half = profile.quantile_95 * profile.sigma;
            table.row(vec![
                profile.parameter.clone(),
                unit.to_owned(),
                number(profile.value),
                number(profile.value - half),
                number(profile.value + half),
                end(profile.interval[0]),
                end(profile.interval[1]),
            ]);
        }
        table.text(width)
    }

    /// Parts of a page: profiles, bootstrap.
    pub(super) fn additions(&self) -> Vec<Addition> {
        let profiles = (!self.profiles.is_empty()).then(|| self.profile_addition());
        profiles.into_iter().chain(self.bootstrap.as_ref().map(bootstrap_addition)).collect()
    }

    fn profile_addition(&self) -> Addition {
        let sentence = |profile: &Profile| {
            let (unit, factor) = shown(profile.unit);
            let decimals = decimals_for(Some(factor * profile.sigma));
            let number = |value: f64| fixed(factor * value, decimals);
            let end = |end: Option<f64>| end.map_or_else(|| "open".to_owned(), number);
            let half = profile.quantile_95 * profile.sigma;
            format!(
                "`{}` = {} {unit}: by the profile {} to {}, by the linear deviation {} to {}.",
                profile.parameter,
                number(profile.value),
                end(profile.interval[0]),
                end(profile.interval[1]),
                number(profile.value - half),
                number(profile.value + half)
            )
        };
        let curves: Vec<ProfileCurves> = self.profiles.iter().map(curves).collect();
        let open = self.profiles.iter().filter(|profile| profile.interval.contains(&None)).count();
        let of = match self.profiles.len() {
            1 => "1 parameter".to_owned(),
            count => format!("{count} parameters"),
        };
        let ends = if open > 0 { format!(", {open} of them open at an end") } else { String::new() };
        Addition {
            id: "profiles",
            title: "Profiles of parameters",
            gist: format!("95 % intervals of {of}{ends}"),
            sentences: self.profiles.iter().map(sentence).collect(),
            figure: profiles(&curves).map(|figure| (figure, PROFILE_WORDS)),
        }
    }

    /// Tables and figures; bands are drawn in the plane of a planar robot, else from above, height by height.
    pub fn files(&self, model: &Model) -> Vec<NamedFile> {
        let mut files = Vec::new();
        if !self.profiles.is_empty() {
            files.push(NamedFile::new("profiles.csv", profiles_csv(&self.profiles)));
            let curves: Vec<ProfileCurves> = self.profiles.iter().map(curves).collect();
            files.extend(profiles(&curves).map(|figure| NamedFile::new("profiles.svg", figure.file())));
        }
        if let Some(found) = &self.bootstrap {
            files.push(NamedFile::new("bootstrap.csv", bootstrap_csv(found)));
        }
        if !self.bands.is_empty() {
            files.push(NamedFile::new("pose-bands.csv", bands_csv(&self.bands)));
            files.extend(self.band_maps(model));
        }
        files
    }

    fn band_maps(&self, model: &Model) -> Vec<NamedFile> {
        let axes: Vec<usize> = model.axes().iter().map(|axis| axis.iamax()).collect();
        let heights: Vec<f64> = self.bands.iter().map(|(pose, _)| pose.position.z).collect();
        let heights: Vec<Option<f64>> = match axes.len() > 2 {
            true => levels(&heights).into_iter().map(Some).collect(),
            false => vec![None],
        };
        let bands = || self.bands.iter().filter_map(|(pose, band)| Some((pose.position, band.as_ref()?)));
        let top = bands().map(|(_, band)| 1e3 * band.position).fold(0.0, f64::max);
        let drawn = |height: Option<f64>| {
            let is_there = |z: f64| height.is_none_or(|height| (z - height).abs() < SAME_HEIGHT);
            let points = bands().filter(|(position, _)| is_there(position.z));
            let of = height.map_or_else(String::new, |height| format!(" at z = {} m", significant(height, 3)));
            let map = Map {
                title: Vec::new(),
                points: points
                    .map(|(position, band)| MapPoint {
                        at: [position[axes[0]], position[axes[1]]],
                        error: 1e3 * band.position,
                    })
                    .collect(),
                arrows: Vec::new(),
                axes: [axes[0], axes[1]].map(|axis| ["x", "y", "z"][axis].to_owned()),
                top,
                colour_label: format!("standard deviation of the position in mm{of}"),
            };
            let name = height.map_or_else(String::new, |height| format!("-at-z-{height:.2}"));
            Some(NamedFile::new(format!("pose-band{name}.svg"), map.svg()?.file()))
        };
        heights.into_iter().filter_map(drawn).collect()
    }
}

fn curves(profile: &Profile) -> ProfileCurves {
    let (unit, factor) = shown(profile.unit);
    let of = |read: fn(&cdpr_calibration::fit::ProfilePoint) -> f64, factor: f64| {
        profile.points.iter().map(|point| factor * read(point)).collect::<Vec<f64>>()
    };
    ProfileCurves {
        name: profile.parameter.clone(),
        unit: unit.to_owned(),
        shifts: of(|point| point.shift, factor),
        held: of(|point| point.held.max(0.0).sqrt(), 1.0 / profile.threshold.sqrt()),
        refitted: of(|point| point.refitted.max(0.0).sqrt(), 1.0 / profile.threshold.sqrt()),
        length_rms: of(|point| point.length_rms_m, 1e3),
        position_mean: of(|point| point.position_mean_m, 1e3),
        interval: profile.interval.map(|end| end.map(|end| factor * (end - profile.value))),
        linear: factor * profile.quantile_95 * profile.sigma,
        levels: [1e3 * profile.length_rms_m, 1e3 * profile.given_length_rms_m],
    }
}

/// Words below figures of a page.
const PROFILE_WORDS: &str = "Left: rise of the weighted squares with a parameter; where it crosses the dashed limit the 95 % interval ends (dots), beside the linear one (bars at the limit). Right: errors on the data of the fit, the other parameters held.";
const BOOTSTRAP_WORDS: &str =
    "Standard deviations of every parameter, of the replicates and by the Jacobian at the optimum.";

fn bootstrap_addition(found: &Resampled) -> Addition {
    let Resampled { replicates, failed, block_length, parameters, .. } = found;
    let failures = if *failed > 0 { format!(", {failed} more without a fit") } else { String::new() };
    let ratios: Vec<f64> = parameters.iter().filter_map(|one| one.ratio).collect();
    let ends = ratios.iter().copied().reduce(f64::min).zip(ratios.iter().copied().reduce(f64::max));
    let ends =
        ends.map(|(low, high)| format!("{} to {} times the linear ones", significant(low, 3), significant(high, 3)));
    let mut units: Vec<&str> = Vec::new();
    for one in parameters {
        if !units.contains(&one.unit) {
            units.push(one.unit);
        }
    }
    let panel = |unit: &&'static str| {
        let (words, factor) = shown(unit);
        let values = parameters.iter().map(|one| match one.unit == *unit {
            true => [factor * one.bootstrap, factor * one.linear.unwrap_or(f64::NAN)],
            false => [f64::NAN; 2],
        });
        ErrorPanel { label: format!("standard deviation, {words}"), values: values.collect(), like: None }
    };
    let figure = ErrorRows {
        label: "Standard deviations of the bootstrap beside linear ones",
        names: parameters.iter().map(|one| one.parameter.clone()).collect(),
        series: ("bootstrap", Some("linear")),
        panels: units.iter().map(panel).collect(),
    };
    Addition {
        id: "bootstrap",
        title: "Bootstrap",
        gist: ends.unwrap_or_else(|| "no linear deviation to compare with".to_owned()),
        sentences: vec![format!("{replicates} data sets of blocks of {block_length} samples{failures}.")],
        figure: figure.svg().map(|figure| (figure, BOOTSTRAP_WORDS)),
    }
}

fn bootstrap_table(found: &Resampled, width: Option<usize>) -> String {
    let mut table = Table::new(["parameter", "unit", "linear σ", "bootstrap σ", "bootstrap / linear", "bias"]);
    for one in &found.parameters {
        let (unit, factor) = shown(one.unit);
        let figure = |value: Option<f64>| value.map_or_else(|| NONE.to_owned(), |value| significant(value, 3));
        table.row(vec![
            one.parameter.clone(),
            unit.to_owned(),
            figure(one.linear.map(|sigma| factor * sigma)),
            figure(Some(factor * one.bootstrap)),
            figure(one.ratio),
            figure(Some(factor * one.bias)),
        ]);
    }
    table.text(width)
}

/// A field of a table; empty where there is no number.
fn field(value: f64) -> String {
    if value.is_nan() { String::new() } else { value.to_string() }
}

fn profiles_csv(profiles: &[Profile]) -> String {
    let mut text = String::from("parameter,unit,value,shift,held,refitted,threshold,length_rms_m,position_mean_m\n");
    for profile in profiles {
        for point in &profile.points {
            let numbers = [
                profile.value,
                point.shift,
                point.held,
                point.refitted,
                profile.threshold,
                point.length_rms_m,
                point.position_mean_m,
            ];
            let _ = writeln!(text, "{},{},{}", profile.parameter, profile.unit, numbers.map(field).join(","));
        }
    }
    text
}

fn bootstrap_csv(found: &Resampled) -> String {
    let mut text = String::from("parameter,unit,linear,bootstrap,bias,ratio\n");
    for one in &found.parameters {
        let numbers = [one.linear.unwrap_or(f64::NAN), one.bootstrap, one.bias, one.ratio.unwrap_or(f64::NAN)]
            .map(field)
            .join(",");
        let _ = writeln!(text, "{},{},{numbers}", one.parameter, one.unit);
    }
    text
}

fn bands_csv(bands: &[(Pose, Option<PoseBand>)]) -> String {
    let mut text = String::from("x_m,y_m,z_m,sigma_position_m,sigma_rotation_rad\n");
    for (pose, band) in bands {
        let [x, y, z]: [f64; 3] = pose.position.into();
        let (position, rotation) = band.map_or((f64::NAN, f64::NAN), |band| (band.position, band.rotation));
        let _ = writeln!(text, "{x},{y},{z},{},{}", field(position), field(rotation));
    }
    text
}
