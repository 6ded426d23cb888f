//! Free parameters and measurements of a calibration without poses, checked; and the model it starts from.

use super::equations::Equation;
use super::found::modelled_length;
use super::gauge::Gauge;
use super::internal::Sensing;
use super::partial_poses::{frame_parameters, freed_frames, with_frames};
use crate::fit::{
    ASSUMED_NOISE, InputError, Settings, check_motor_angles, check_question, checked_parameters, prior_sigma,
};
use crate::gauge_convention::GaugeConvention;
use crate::residual::balance::start::with_constant_wrench;
use crate::residual::sensors::{SensorLayout, Swivel, Weights};
use cdpr_model::measurement::{InternalSamples, Samples};
use cdpr_model::model::{FreeParameters, Model, ParameterError, RecordingParameter};
use cdpr_model::robot::{Parameter, ParameterKind};
use cdpr_model::statics::Load;

/// Weight of what fixes a gauge, beside the rows of all samples together: none of it reaches the deviations of parameters, and equations keep their digits.
const STILL: f64 = 100.0;

/// A calibration to be done.
#[derive(Clone)]
pub(super) struct Question<'a> {
    /// The model that searches start from: it states a constant wrench where that is free.
    pub(super) model: Model,
    pub(super) internal: InternalSamples,
    /// The free parameters.
    pub(super) parameters: Vec<Parameter>,
    pub(super) sensing: Sensing,
    /// Facts known besides, and conditions that fix the gauge.
    pub(super) equations: Vec<Equation>,
    pub(super) settings: &'a Settings,
}

/// Free parameters that only tensions tell.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Forces {
    /// None.
    Nothing,
    /// Of load cells, or of winches that count from nowhere.
    Sensors,
    /// The load: the wrench, or the weight.
    Load,
}

impl Forces {
    fn of(free: &FreeParameters, hold: &FreeParameters, internal: &InternalSamples) -> Self {
        let is_free = |kind: ParameterKind, cables: usize| {
            (0..cables).any(|cable| free.contains(kind, cable) && !hold.contains(kind, cable))
        };
        let m = internal.samples.cable_count;
        let of_sensors = [ParameterKind::TensionScale, ParameterKind::TensionOffset];
        let counts_from_nowhere = internal.are_changes && is_free(ParameterKind::LengthOffset, m);
        let is_of_load = ParameterKind::IDENTIFIED.into_iter().any(|kind| kind.is_of_load() && is_free(kind, 1));
        match is_of_load {
            true => Self::Load,
            false if counts_from_nowhere || of_sensors.into_iter().any(|kind| is_free(kind, m)) => Self::Sensors,
            false => Self::Nothing,
        }
    }
}

/// Rows of a model's samples: of lengths alone, or of all sensors; tensions count where the load is known or free, of rigid models where these are `asked` or there are no more cables
/// than degrees of freedom. Of fewer cables than degrees of freedom under a known load, tensions are unknowns in equilibrium if none are recorded but swivels or parts of poses are.
///
/// More cables pull against each other, and stretch by what the model lacks: calibrated lengths have anchors that make up for it, equilibrium has the true ones.
pub(super) fn sensing(model: &Model, internal: &InternalSamples, asked: Forces) -> Sensing {
    let samples = &internal.samples;
    let has_load = asked == Forces::Load || Load::of(model.robot()).is_ok();
    let is_told = asked != Forces::Nothing || model.cable_count() <= model.dof();
    // beside lengths alone equilibrium leaves no equation
    let has_others = internal.swivels.is_some() || internal.known.iter().flatten().any(|known| *known);
    let hangs = model.cable_count() < model.dof() && has_others;
    let balances = model.needs_tensions() || has_load && (samples.tensions.is_some() && is_told || hangs);
    let holding = || Load::of(model.robot()).map_or(0.0, |load| load.force() / model.cable_count() as f64);
    let typical = samples.tensions.as_deref().map_or_else(holding, mean);
    let weights = Weights::new(model, &samples.sigmas, typical);
    let weights = if model.robot().tracked.is_some() { weights.of_tracker() } else { weights };
    let layout = SensorLayout::of(model, internal, balances, &weights);
    match layout.has_only_lengths() {
        true => Sensing::Lengths(samples.sigmas.length.filter(|sigma| *sigma > 0.0).unwrap_or(ASSUMED_NOISE)),
        false => Sensing::All(layout, weights),
    }
}

fn mean(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len().max(1) as f64
}

/// Refuses swivel angles that count from nothing.
pub(super) fn check_swivels(model: &Model, internal: &InternalSamples) -> Result<(), InputError> {
    if internal.swivels.is_none() {
        return Ok(());
    }
    let lacks_zero = |cable: &usize| !Swivel::has_zero(model, *cable);
    match (0..model.cable_count()).find(lacks_zero) {
        Some(cable) => Err(InputError::NoSwivel { cable: cable + 1 }),
        None => Ok(()),
    }
}

/// A mass that the record states sample by sample is not free.
fn check_masses(parameters: &[Parameter], internal: &InternalSamples) -> Result<(), ParameterError> {
    let is_mass = |parameter: &Parameter| parameter.kind == ParameterKind::Mass;
    match internal.masses.is_some() && parameters.iter().any(is_mass) {
        true => Err(ParameterError::NoEffect {
            kind: ParameterKind::Mass,
            reason: "the record states the mass of every sample (`mass_kg`): leave the column out, or hold `mass`",
        }),
        false => Ok(()),
    }
}

impl<'a> Question<'a> {
    pub(super) fn of(
        model: &Model,
        internal: &InternalSamples,
        free: &FreeParameters,
        settings: &'a Settings,
    ) -> Result<Self, InputError> {
        let freed = freed_frames(model, internal, free, settings)?;
        let model = &with_frames(model, internal, &freed)?;
        let free = &free.without_recording(&RecordingParameter::FRAMES);
        check_question(model, &internal.samples, settings)?;
        check_swivels(model, internal)?;
        let sensing = sensing(model, internal, Forces::of(free, &settings.hold, internal));
        internal.facts.iter().try_for_each(|known| known.check(model.cable_count(), internal.are_changes))?;
        let equations = internal.facts.iter().cloned().map(Equation::Known).collect();
        if sensing.residual(model, internal, &[], &[]).equation_count().unwrap_or(0) == 0 {
            return Err(no_equation_left(model, &sensing));
        }
        let balances = matches!(&sensing, Sensing::All(layout, _) if layout.balances());
        let mut parameters = match sensing {
            Sensing::Lengths(_) => checked_parameters(model, &internal.samples, free, settings)?,
            Sensing::All(..) => free.parameters_with(model, &settings.hold, balances)?,
        };
        parameters.extend(frame_parameters(model, internal, &freed));
        check_motor_angles(&parameters, &internal.samples)?;
        check_masses(&parameters, internal)?;
        let (model, internal) = (model.clone(), internal.clone());
        let mut question = Self { model, internal, parameters, sensing, equations, settings };
        if balances {
            question.state_load()?;
        }
        if matches!(question.sensing, Sensing::All(..)) {
            question.count_lengths_from_nothing()?;
        }
        question.count_swivels_from_nothing()?;
        Ok(question)
    }

    /// The question of a model as it is: nothing is free, and facts count that are known besides.
    pub(super) fn as_given(model: &Model, internal: &InternalSamples, settings: &'a Settings) -> Self {
        let sensing = sensing(model, internal, Forces::Sensors);
        let equations = internal.facts.iter().cloned().map(Equation::Known).collect();
        let (model, internal) = (model.clone(), internal.clone());
        Self { model, internal, parameters: Vec::new(), sensing, equations, settings }
    }

    /// Remark on recorded tensions that are no rows.
    pub(super) fn unused_tensions(&self) -> Option<String> {
        let is_used = matches!(&self.sensing, Sensing::All(layout, _) if layout.balances());
        let has_load = Load::of(self.model.robot()).is_ok();
        (!is_used && has_load && self.internal.samples.tensions.is_some()).then(|| {
            "tensions are recorded and not used: rigid cables that pull against each other stretch by what the model lacks, so that equilibrium and lengths ask for different \
             anchors; take an elastic model, or free tension-scale, tension-offset or wrench, which tensions tell"
                .to_owned()
        })
    }

    /// Parameters that are searched under the convention of the gauge.
    pub(super) fn fix(&mut self, gauge: &Gauge) -> Result<Vec<Parameter>, InputError> {
        let all = self.parameters.clone();
        match self.settings.gauge {
            GaugeConvention::Known if !gauge.held.is_empty() => Err(InputError::GaugeOpen { motions: gauge.words() }),
            GaugeConvention::Known => Ok(all),
            GaugeConvention::LeastChange => {
                self.hold_still(gauge);
                Ok(all)
            }
            GaugeConvention::Anchors => {
                let is_kept = |(place, _): &(usize, Parameter)| !gauge.held.contains(place);
                Ok(all.into_iter().enumerate().filter(is_kept).map(|(_, parameter)| parameter).collect())
            }
        }
    }

    /// Keeps anchors as near to the file's as the motions of the gauge let them be.
    pub(super) fn hold_still(&mut self, gauge: &Gauge) {
        let weight = STILL * (self.internal.samples.len() as f64).sqrt() / self.sensing.length_sigma();
        self.equations.extend(gauge.stillness(&self.model, &self.parameters, weight));
    }

    /// Gives the model the constant wrench that is free, and refuses one without load.
    fn state_load(&mut self) -> Result<(), InputError> {
        let home = self.model.robot().home_or_middle();
        let samples = Samples { poses: vec![home; self.internal.samples.len()], ..self.internal.samples.clone() };
        let tensions = samples.tensions.clone().unwrap_or_else(|| vec![1.0; samples.lengths.len()]);
        self.model = with_constant_wrench(&self.model, &samples, &tensions, &self.parameters)?;
        Ok(())
    }

    /// Lengths that count from an unknown pose are lengths with unknown offsets beside other sensors, which tell these.
    fn count_lengths_from_nothing(&mut self) -> Result<(), InputError> {
        if !self.internal.are_changes {
            return Ok(());
        }
        let m = self.model.cable_count();
        let is_offset = |cable: usize| {
            move |parameter: &Parameter| parameter.cable == cable && parameter.kind == ParameterKind::LengthOffset
        };
        if !(0..m).all(|cable| self.parameters.iter().any(is_offset(cable))) {
            return Err(InputError::ChangesBesideSensors);
        }
        self.internal.are_changes = false;
        let home = self.model.robot().home_or_middle();
        let mut robot = self.model.robot().clone();
        for cable in 0..m {
            let changes: Vec<f64> = self.internal.samples.lengths.iter().skip(cable).step_by(m).copied().collect();
            let length = modelled_length(&self.model, cable, &home);
            let offset = robot.cables[cable].length_offset.unwrap_or(0.0) + mean(&changes) - length;
            robot.cables[cable].length_offset = Some(offset);
        }
        self.model = Model::new(robot, self.model.composition())?;
        Ok(())
    }

    /// Gives encoders of swivels whose zero is free and not stated one by the home pose, from which searches find the way.
    fn count_swivels_from_nothing(&mut self) -> Result<(), InputError> {
        let mut free =
            self.parameters.iter().filter(|parameter| parameter.kind == ParameterKind::SwivelOffset).peekable();
        if free.peek().is_none() {
            return Ok(());
        }
        let swivels = self.internal.swivels.as_ref().ok_or(InputError::NoSwivelAngles)?;
        let (m, home) = (self.model.cable_count(), self.model.robot().home_or_middle());
        let mut robot = self.model.robot().clone();
        for cable in free.map(|parameter| parameter.cable) {
            let own = || swivels.iter().skip(cable).step_by(m);
            let direction = own().fold((0.0, 0.0), |(x, y), angle| (x + angle.cos(), y + angle.sin()));
            let angle = Swivel::angle_at(&self.model, cable, &home);
            if let (None, Some(angle)) = (robot.cables[cable].swivel_offset, angle) {
                robot.cables[cable].swivel_offset = Some(f64::atan2(direction.1, direction.0) - angle);
            }
        }
        self.model = Model::new(robot, self.model.composition())?;
        Ok(())
    }

    /// Equations that poses leave for the parameters, and those known besides.
    pub(super) fn count_equations(&self) -> usize {
        self.sensing.residual(&self.model, &self.internal, &[], &self.equations).equation_count().unwrap_or(0)
    }

    /// Priors on these parameters.
    pub(super) fn prior_count(&self, parameters: &[Parameter]) -> usize {
        parameters.iter().filter(|parameter| prior_sigma(self.settings, parameter.kind).is_some()).count()
    }

    /// Recorded tensions that are used (N).
    pub(super) fn tensions(&self) -> &[f64] {
        match self.sensing {
            Sensing::All(..) => self.internal.samples.tensions.as_deref().unwrap_or_default(),
            Sensing::Lengths(_) => &[],
        }
    }

    pub(super) fn mean_tension(&self) -> f64 {
        mean(self.tensions())
    }
}

/// The refusal of measurements that leave no equation.
pub(super) fn no_equation_left(model: &Model, sensing: &Sensing) -> InputError {
    let (m, n) = (model.cable_count(), model.dof());
    match sensing {
        Sensing::Lengths(_) => {
            InputError::NoEquationLeft { rows: m, sensors: format!("{m} cable lengths"), unknowns: n, of: "the pose" }
        }
        Sensing::All(layout, _) => InputError::NoEquationLeft {
            rows: layout.size(),
            sensors: layout.words(),
            unknowns: n + if layout.balances() { m } else { 0 },
            of: if layout.balances() { "the pose and the tensions" } else { "the pose" },
        },
    }
}
