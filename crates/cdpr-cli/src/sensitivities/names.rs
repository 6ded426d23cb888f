//! Numbers of models and winches by their names.

use cdpr_model::model::Model;
use cdpr_study::sensitivity::ParameterDeviation;

use crate::failure::Failure;

/// Which of the numbers has this name, that `option` was given; near ones are told.
pub(crate) fn place_of(
    causes: &[ParameterDeviation],
    machine: &Model,
    name: &str,
    option: &str,
) -> Result<usize, Failure> {
    let plain = name.split_whitespace().collect::<Vec<_>>().join(" ");
    let names: Vec<String> = causes.iter().map(|cause| cause.name(machine)).collect();
    if let Some(place) = names.iter().position(|known| *known == plain) {
        return Ok(place);
    }
    let nearest = names.iter().max_by(|a, b| strsim::jaro(a, &plain).total_cmp(&strsim::jaro(b, &plain)));
    let example = nearest.map_or_else(String::new, |nearest| format!("did you mean \"{nearest}\"? "));
    let message = format!("{option}: control model, machine and winches have no \"{name}\"");
    let help = format!("{example}`cdpr sensitivity` with --csv names all of them");
    Err(Failure::usage("usage::value", message).with_help(&help))
}
