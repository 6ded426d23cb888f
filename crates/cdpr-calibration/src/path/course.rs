//! All parameters of a model along the penalty, on fixed weights.

use super::part::Part;
use super::settings::{PathSettings, Penalty, Towards};
use super::subproblem::Group;
use crate::fit::{self, InputError};
use crate::minimize::unknowns::Unknowns;
use crate::problem::Problem;
use crate::progress::unobserved;
use cdpr_model::measurement::Samples;
use cdpr_model::model::Model;
use cdpr_model::robot::{Parameter, ParameterKind};

/// Share by which the first penalty is beyond the least that holds everything: rounding shall let nothing move.
const BEYOND: f64 = 1e-9;
/// Penalties go down to a share of the first between these, and to where the squares are nearly the least.
const LEAST: (f64, f64) = (1e-8, 1e-4);
/// Share of the least squares that the last penalty may add.
const NEAR: f64 = 0.1;
/// The ridge's first one as a multiple of the largest second derivative, and its share.
const RIDGE: (f64, f64) = (100.0, 1e-10);
/// Gradient below this share of what noise makes of it is rounding: the penalised parameters stay at their centre whatever λ > 0.
const NO_GRADIENT: f64 = 1e-6;

/// Question to a course.
pub(super) struct Question<'a> {
    pub(super) model: &'a Model,
    pub(super) parameters: &'a [Parameter],
    pub(super) settings: &'a fit::Settings,
    pub(super) path: &'a PathSettings,
}

/// Least value at one penalty.
#[derive(Clone, Debug)]
pub(super) struct Place {
    pub(super) lambda: f64,
    pub(super) values: Vec<f64>,
    /// Changes from the penalty's centre in metres of cable.
    pub(super) changes: Vec<f64>,
    /// Whether each parameter is off the penalty's centre; true without penalty.
    pub(super) is_off: Vec<bool>,
    /// χ².
    pub(super) squares: f64,
    pub(super) converged: bool,
}

impl Question<'_> {
    /// True for parameters that the penalty acts on.
    pub(super) fn is_penalised(&self, parameter: &Parameter) -> bool {
        self.path.shrink.is_empty() || self.path.shrink.contains(parameter.kind, parameter.cable)
    }

    /// Value at which a parameter has no penalty.
    pub(super) fn centre(&self, parameter: &Parameter) -> f64 {
        let file = parameter.value(self.model.robot());
        let nothing = match parameter.kind {
            ParameterKind::LengthScale | ParameterKind::TensionScale => 1.0,
            _ => 0.0,
        };
        let (low, high) = parameter.bounds();
        match self.path.towards {
            Towards::Zero if self.is_penalised(parameter) && (low..=high).contains(&nothing) => nothing,
            _ => file,
        }
    }

    /// Every parameter in one group, those with a smooth penalty or none alone.
    fn groups(&self, parameters: &[Parameter]) -> Vec<Group> {
        let is_smooth = |parameter: &Parameter| !self.is_penalised(parameter) || self.path.penalty == Penalty::Ridge;
        let of_one = |k: usize| parameters[k];
        let mut groups: Vec<Group> = Vec::new();
        for k in 0..parameters.len() {
            let (own, is_smooth) = (of_one(k), is_smooth(&parameters[k]));
            let is_same = |group: &&mut Group| {
                let other = of_one(group.members[0]);
                (other.kind, other.cable) == (own.kind, own.cable)
            };
            let together = self.path.penalty == Penalty::GroupLasso && !is_smooth;
            match groups.last_mut().filter(|_| together).filter(is_same) {
                Some(group) => group.members.push(k),
                None => groups.push(Group { members: vec![k], weight: if is_smooth { 0.0 } else { 1.0 } }),
            }
        }
        groups.iter_mut().for_each(|group| group.weight *= (group.members.len() as f64).sqrt());
        groups
    }

    fn part(&self, block: usize, own: &Unknowns<'_>) -> Part {
        let (parameters, scales) = (own.parameters, own.scale.to_vec());
        let centre: Vec<f64> = parameters.iter().map(|parameter| self.centre(parameter)).collect();
        let bounds = parameters.iter().zip(&scales).zip(&centre).map(|((parameter, scale), centre)| {
            let (low, high) = parameter.bounds();
            ((low - centre) * scale, (high - centre) * scale)
        });
        let bounds = bounds.collect();
        let is_ridge = self.path.penalty == Penalty::Ridge;
        let ridge = parameters.iter().map(|parameter| is_ridge && self.is_penalised(parameter)).collect();
        Part::new(block, centre, scales, self.groups(parameters), ridge, bounds)
    }

    /// Follows the penalty on samples, over penalties that they tell where none are given.
    pub(super) fn follow(&self, samples: &Samples, lambdas: Option<&[f64]>) -> Result<Vec<Place>, InputError> {
        let samples = &*self.model.with_lengths(samples)?;
        let settings = fit::Settings { starts: 1, ..self.settings.clone() };
        let mut problem = Problem::new(self.model, samples, self.parameters, &settings)?;
        // the optimum leaves the weights that belong to it
        problem.minimize(&unobserved)?;
        let blocks = problem.residual.blocks(self.parameters.len()).into_iter().enumerate();
        let with_parameters = blocks.filter(|(_, range)| !range.is_empty());
        let mut parts: Vec<Part> =
            with_parameters.map(|(block, range)| self.part(block, &problem.unknowns.within(range))).collect();
        let mut places = Vec::new();
        self.walk(&mut problem, &mut parts, lambdas, &mut |place| places.push(place));
        Ok(places)
    }

    fn walk(
        &self,
        problem: &mut Problem<'_>,
        parts: &mut [Part],
        lambdas: Option<&[f64]>,
        take: &mut dyn FnMut(Place),
    ) {
        // unpenalised parameters first, the others held
        for part in parts.iter_mut() {
            part.begin(problem);
            part.minimise(problem, f64::INFINITY);
        }
        let own = match lambdas {
            Some(_) => Vec::new(),
            None => self.lambdas(problem, parts),
        };
        for &lambda in lambdas.unwrap_or(&own) {
            take(minimised(problem, parts, lambda));
        }
    }

    /// Penalties from the least that holds all parameters down by equal ratios to where the squares are nearly the least, and 0.
    fn lambdas(&self, problem: &mut Problem<'_>, parts: &mut [Part]) -> Vec<f64> {
        let curvature = parts.iter().map(Part::curvature).fold(0.0, f64::max);
        let holding = parts.iter().map(Part::least_holding).fold(0.0, f64::max);
        let (top, least) = match self.path.penalty {
            Penalty::Ridge => (RIDGE.0 * curvature, RIDGE.1),
            _ => {
                let top = (1.0 + BEYOND) * holding.max(NO_GRADIENT * curvature.sqrt());
                (top, (near_the_least(problem, parts) / top).clamp(LEAST.0, LEAST.1))
            }
        };
        let last = self.path.points.max(2) - 1;
        let fraction = |point: usize| least.powf(point as f64 / last as f64);
        (0..=last).map(|point| top * fraction(point)).chain([0.0]).collect()
    }
}

/// Least value at a penalty, from where the parts stand.
fn minimised(problem: &mut Problem<'_>, parts: &mut [Part], lambda: f64) -> Place {
    let mut place =
        Place { lambda, values: Vec::new(), changes: Vec::new(), is_off: Vec::new(), squares: 0.0, converged: true };
    for part in parts {
        place.converged &= part.minimise(problem, lambda);
        place.squares += 2.0 * part.half_squares();
        place.values.extend(part.values());
        place.changes.extend(part.changes());
        place.is_off.extend(part.is_off());
    }
    place
}

/// Penalty at which the squares exceed their least by no more than a share: by 2 λ Σ |u|, u the changes at the least. The parts stay where they are.
fn near_the_least(problem: &mut Problem<'_>, parts: &mut [Part]) -> f64 {
    let (mut squares, mut penalty) = (0.0, 0.0);
    for part in parts {
        let (half, own) = part.at_the_least(problem);
        (squares, penalty) = (squares + 2.0 * half, penalty + own);
    }
    if penalty > 0.0 { NEAR * squares / (2.0 * penalty) } else { f64::INFINITY }
}
