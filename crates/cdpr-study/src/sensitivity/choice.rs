//! Derivatives of chosen tensions by the model, for any method of tension distribution.
//!
//! A method maps structure matrix and load to tensions; [`Response`] has the derivatives of this map. A deviation
//! changes the column of its cable and the load. The pulls W(f, p) of sagging cables turn with their tensions: the
//! method is given ∂W/∂f as matrix and w + W − ∂W/∂f f as load, and its tensions are those at which both were
//! evaluated. By differentiation, a deviation changes the column by ∂²W/∂f∂p and the load by ∂W/∂p − ∂²W/∂f∂p f; a
//! tension changes its own column by ∂²W/∂f² and the load by −∂²W/∂f² f, so that with the response R
//!
//! df = R(dp) + K df,  K's column of cable i = R(∂²Wᵢ/∂fᵢ², −∂²Wᵢ/∂fᵢ² fᵢ),  df = (I − K)⁻¹ R(dp).
//!
//! ∂W/∂f and ∂W/∂p are those of the cable's own equations; their slopes along the tension are differences of fourth
//! order of these derivatives, for one cable at a time.

use nalgebra::{DMatrix, DVector};

use super::cause::ParameterDeviation;
use super::equilibrium::load_change;
use cdpr_model::cable::CableState;
use cdpr_model::geometry::{Pose, Wrench};
use cdpr_model::model::Model;
use cdpr_model::statics::{Load, StaticsError, cable_state};
use cdpr_model::tension::{Limits, Method, NotSmooth, Response};

/// Fraction of a tension (of 1 N at least) over which slopes of derivatives are taken: h⁴ and rounding over h are both
/// below 1e-9 of the derivatives.
const STEP: f64 = 1e-3;

/// Chosen tensions of a model at a pose.
pub(super) struct Choice<'a> {
    model: &'a Model,
    pose: Pose,
    tensions: Vec<f64>,
    response: Response,
    /// (I − K)⁻¹; the unit matrix for straight cables, whose columns do not turn with their tensions.
    turning: Option<DMatrix<f64>>,
}

impl<'a> Choice<'a> {
    /// Tensions that a method has chosen within limits, or the reason for which they have no derivative.
    pub(super) fn by(
        method: Method,
        model: &'a Model,
        pose: &Pose,
        load: &Load,
        limits: &Limits,
        tensions: &[f64],
    ) -> Result<Result<Self, NotSmooth>, StaticsError> {
        let matrix = by_tensions(model, pose, tensions)?;
        let mut wrench = load.in_pattern(model, pose);
        for (cable, &tension) in tensions.iter().enumerate() {
            let pull = in_pattern(model, &cable_state(model, pose, cable, tension)?.wrench());
            wrench += pull - matrix.column(cable) * tension;
        }
        let response = Response::of(method, &matrix, wrench.as_slice(), limits, tensions);
        Self::new(model, pose, tensions, response)
    }

    /// The balanced tensions nearest to a reference (N), without limits.
    pub(super) fn nearest(
        model: &'a Model,
        pose: &Pose,
        tensions: &[f64],
        reference: &[f64],
    ) -> Result<Result<Self, NotSmooth>, StaticsError> {
        let matrix = by_tensions(model, pose, tensions)?;
        let response = Response::of_nearest(&matrix, tensions, reference);
        Self::new(model, pose, tensions, response)
    }

    fn new(
        model: &'a Model,
        pose: &Pose,
        tensions: &[f64],
        response: Result<Response, NotSmooth>,
    ) -> Result<Result<Self, NotSmooth>, StaticsError> {
        let response = match response {
            Ok(response) => response,
            Err(reason) => return Ok(Err(reason)),
        };
        let mut choice = Self { model, pose: *pose, tensions: tensions.to_vec(), response, turning: None };
        let mut matrix = DMatrix::identity(tensions.len(), tensions.len());
        for (cable, &tension) in tensions.iter().enumerate() {
            let slope = choice.slope_by_tension(cable, |state| state.by_given_tension(1.0).0)?;
            let change = choice.response.change(cable, slope.as_slice(), (-&slope * tension).as_slice());
            let mut column = matrix.column_mut(cable);
            column -= change;
        }
        choice.turning = matrix.try_inverse();
        Ok(Ok(choice))
    }

    /// Change of all tensions per unit of a deviation of the model (N).
    pub(super) fn by_cause(&self, cause: &ParameterDeviation) -> Result<DVector<f64>, StaticsError> {
        let mut wrench = in_pattern(self.model, &load_change(cause, self.model, &self.pose));
        let mut column = DVector::zeros(wrench.len());
        if let Some((parameter, unit)) = cause.cable_parameter(self.model) {
            let rotation = self.pose.rotation_matrix();
            let of = |state: &CableState| self.model.by_parameter(cause.cable, state, &parameter, &rotation).0;
            let state = cable_state(self.model, &self.pose, cause.cable, self.tensions[cause.cable])?;
            column = self.slope_by_tension(cause.cable, of)? * unit;
            wrench += in_pattern(self.model, &of(&state)) * unit;
            wrench -= &column * self.tensions[cause.cable];
        }
        Ok(self.turned(self.response.change(cause.cable, column.as_slice(), wrench.as_slice())))
    }

    /// Change of all tensions per newton of one cable's reference (N).
    pub(super) fn by_reference(&self, cable: usize) -> DVector<f64> {
        self.turned(self.response.change_by_reference(cable))
    }

    /// A change with the effect of turning sagging cables added.
    fn turned(&self, change: DVector<f64>) -> DVector<f64> {
        match &self.turning {
            Some(turning) => turning * change,
            None => change,
        }
    }

    /// Slope of a wrench of one cable along its tension, in the pattern's rows.
    fn slope_by_tension(
        &self,
        cable: usize,
        wrench: impl Fn(&CableState) -> Wrench,
    ) -> Result<DVector<f64>, StaticsError> {
        let (tension, step) = (self.tensions[cable], STEP * self.tensions[cable].max(1.0));
        let at = |steps: f64| -> Result<DVector<f64>, StaticsError> {
            let state = cable_state(self.model, &self.pose, cable, tension + steps * step)?;
            Ok(in_pattern(self.model, &wrench(&state)))
        };
        let (near, far) = (at(1.0)? - at(-1.0)?, at(2.0)? - at(-2.0)?);
        Ok((near * 8.0 - far) / (12.0 * step))
    }
}

/// ∂(wrench)/∂f in the pattern's rows: the structure matrix of straight cables.
fn by_tensions(model: &Model, pose: &Pose, tensions: &[f64]) -> Result<DMatrix<f64>, StaticsError> {
    let mut matrix = DMatrix::zeros(model.dof(), tensions.len());
    for (cable, &tension) in tensions.iter().enumerate() {
        let (wrench, _) = cable_state(model, pose, cable, tension)?.by_given_tension(1.0);
        matrix.set_column(cable, &in_pattern(model, &wrench));
    }
    Ok(matrix)
}

fn in_pattern(model: &Model, wrench: &Wrench) -> DVector<f64> {
    let basis = model.twist_basis();
    DVector::from_iterator(basis.len(), basis.iter().map(|twist| twist.dot(wrench)))
}
