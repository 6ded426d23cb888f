//! Squares that follow the parameters are those of vectors that are solved anew, on every vector unit.

use super::*;
use crate::fit::Settings;
use crate::minimize::cost::write_squares;
use crate::objective::Objective;
use crate::residual::rows::Rows;
use crate::residual::tests::{crane, of, samples};
use cdpr_model::model::{Composition, FreeParameters};
use cdpr_model::scalar::{Unit, dispatch_on};

const FREE: [(Composition, &str); 2] = [
    (Composition::STANDARD, "frame-anchor,platform-anchor,length-offset,length-scale"),
    (Composition::PULLEY, "frame-anchor,platform-anchor,length-offset,length-scale,pulley-radius"),
];

/// Step of [`course`] that repeats the values before.
const REPEATED: usize = 3;

/// Values that go away from a model's and come back, as steps of a fit do.
fn course(model: &Model, parameters: &[Parameter]) -> Vec<Vec<f64>> {
    let at = |size: f64| {
        let moved = |(k, parameter): (usize, &Parameter)| {
            // lengths are scaled by a tenth of a per mille where anchors move by a millimetre
            let fraction = if parameter.unit(model.robot()).is_empty() { 0.1 } else { 1.0 };
            parameter.value(model.robot()) + fraction * size * (k as f64).sin()
        };
        parameters.iter().enumerate().map(moved).collect()
    };
    [0.0, 1e-2, 1.1e-2, 1.1e-2, -3e-3, 0.0].map(at).to_vec()
}

fn problem(composition: Composition, free: &str) -> (Model, Samples, Vec<Parameter>) {
    let model = crane(composition);
    let samples = samples(&model);
    let parameters = free.parse::<FreeParameters>().unwrap().parameters(&model, &FreeParameters::default()).unwrap();
    (model, samples, parameters)
}

/// Short ways end where some 1e-10 m are left; the solver from the measured poses where a step is less than 1e-9 m, beside errors of millimetres.
/// Derivatives are those at a place that the last step has left, of a tenth of a millimetre, and exact once values repeat, as they nearly do at an optimum.
#[test]
fn squares_are_those_of_vectors() {
    for (composition, free) in FREE {
        let (model, samples, parameters) = problem(composition, free);
        let settings = Settings { objective: Objective::Pose, ..Settings::default() };
        let mut residual = of(&model, &samples, &parameters, &settings);
        let mut rows = Rows::new(residual.layout(), parameters.len());
        let [mut short, mut long] = [0, 1].map(|_| DenseEquations::new(parameters.len()));
        residual.restart();
        for (step, values) in course(&model, &parameters).into_iter().enumerate() {
            let of_gradient = if step == REPEATED { 1e-6 } else { 3e-5 };
            let is_written = residual.write(&values, &mut rows);
            let largest = rows.residuals.amax();
            assert!(is_written && residual.normal(0, &values, &mut short), "{is_written} {largest}");
            write_squares(&rows, &mut long);
            assert!((short.cost / long.cost - 1.0).abs() < 1e-6, "{} {}", short.cost, long.cost);
            for k in 0..parameters.len() {
                let size = (long.cost * long.hessian[(k, k)]).sqrt();
                let [found, expected] = [&short, &long].map(|equations| equations.gradient[k]);
                assert!((found - expected).abs() < of_gradient * size, "{step}, {k}: {found} {expected}");
                for j in 0..parameters.len() {
                    let size = (long.hessian[(j, j)] * long.hessian[(k, k)]).sqrt();
                    let [found, expected] = [&short, &long].map(|equations| equations.hessian[(k, j)]);
                    assert!((found - expected).abs() < 1e-3 * size, "{k} {j}: {found} {expected}");
                }
            }
        }
    }
}

#[test]
fn squares_have_the_same_bits_on_every_unit() {
    for (composition, free) in FREE {
        let (model, samples, parameters) = problem(composition, free);
        let metric = Metric::of(&model, &samples, None).unwrap();
        let on = |unit| {
            let mut squares = PoseSquares::of(&model, &samples, &parameters, &metric, 0.1).unwrap();
            let mut equations = DenseEquations::new(parameters.len());
            let mut bits = Vec::new();
            for values in course(&model, &parameters) {
                let change = squares.prepare(&values);
                let with_hessian = !squares.is_summed_near(&values);
                let write = Write { squares: &mut squares, change: &change, with_hessian };
                let is_plain = dispatch_on(unit, write).unwrap();
                assert!(squares.conclude(&values, (is_plain, with_hessian), &mut equations));
                bits.extend(equations.gradient.iter().chain(equations.hessian.iter()).map(|number| number.to_bits()));
            }
            bits
        };
        let portable = on(Unit::Portable);
        Unit::available().for_each(|unit| assert_eq!(on(unit), portable, "{unit:?}"));
    }
}

/// A measured pose that is turned by 20° from where the lengths lead is none for series; planar robots and motor angles have vectors only.
#[test]
fn what_is_not_plain_is_left_to_vectors() {
    let (model, mut samples, parameters) = problem(FREE[0].0, "frame-anchor");
    let turn = cdpr_model::geometry::Twist::new(0.0, 0.0, 0.0, 0.0, 0.35, 0.0);
    samples.poses[3] = samples.poses[3].displaced(&turn);
    let metric = Metric::of(&model, &samples, None).unwrap();
    let mut squares = PoseSquares::of(&model, &samples, &parameters, &metric, 0.1).unwrap();
    let values: Vec<f64> = parameters.iter().map(|parameter| parameter.value(model.robot())).collect();
    let mut equations = DenseEquations::new(values.len());
    assert!(!squares.write(&values, &mut equations) && squares.values.is_none());
    let settings = Settings { objective: Objective::Pose, ..Settings::default() };
    let mut residual = of(&model, &samples, &parameters, &settings);
    let mut rows = Rows::new(residual.layout(), values.len());
    assert!(!residual.normal(0, &values, &mut equations) && residual.write(&values, &mut rows));
    drop(residual);
    samples.motor_angles = Some(samples.lengths.clone());
    assert!(PoseSquares::of(&model, &samples, &parameters, &metric, 0.1).is_none());
}
