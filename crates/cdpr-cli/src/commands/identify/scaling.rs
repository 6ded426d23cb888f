//! Scales of parameters, weights of rows, and the condition that they lead to.

use std::path::PathBuf;

use cdpr_calibration::fit::{Fit, InputError};
use cdpr_calibration::{KindScale, condition_map, conditioning, scaled_kind};
use cdpr_reports::answers::ScalingAnswer;

use super::options::ScalingArguments;
use super::task::Task;
use crate::failure::Failure;

/// Answer and file of what the options ask for.
pub(super) type Found = (Option<ScalingAnswer>, Option<(PathBuf, Vec<u8>)>);

pub(super) fn find(task: &Task<'_>, fit: &Fit) -> Result<Found, Failure> {
    let ScalingArguments { scale, condition_map: map, .. } = &*task.arguments.scaling;
    if scale.is_empty() && map.is_none() {
        return Ok((None, None));
    }
    let refused = |error: InputError| Failure::refused(&task.arguments.data.name(), &error);
    let of_option = |error: InputError| Failure::refused("--scale or --condition-map", &error);
    let is_auto = matches!(&scale[..], [one] if one == "auto") || scale.is_empty();
    let names = if is_auto { &[] } else { &scale[..] };
    let scales: Vec<KindScale> =
        names.iter().map(|text| text.parse()).collect::<Result<_, InputError>>().map_err(of_option)?;
    let samples = fit.as_fitted(task.samples);
    let (free, settings) = (&task.arguments.free, task.settings());
    let found = conditioning(&fit.model, &samples, free, &settings, &scales).map_err(refused)?;
    let answer = ScalingAnswer::new(found, is_auto);
    let Some([kinds, file]) = map.as_deref() else { return Ok((Some(answer), None)) };
    let pair = kinds.split_once(',').ok_or_else(|| of_option(InputError::ScaleSyntax { text: kinds.clone() }))?;
    let kinds = [scaled_kind(pair.0).map_err(of_option)?, scaled_kind(pair.1).map_err(of_option)?];
    let map = condition_map(&fit.model, &samples, free, &settings, &scales, kinds).map_err(of_option)?;
    let figure = answer.map(&map).map(|figure| (PathBuf::from(file), figure.file().into_bytes()));
    Ok((Some(answer), figure))
}
