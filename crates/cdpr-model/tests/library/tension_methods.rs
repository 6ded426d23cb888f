//! Every method of tension distribution: balance, limits, optimality, and continuity along a path.

use std::path::Path;

use super::distribution::Problem;
use super::problems::{models, random_problem, random_problem_within};
use cdpr_model::model::{Composition, Model};
use cdpr_model::reading::Keyword;
use cdpr_model::robot::Robot;
use cdpr_model::tension::{Answer, Limits, Method, Options, Reference, Solver, Status, solve};
use cdpr_testing::property;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

/// Problems on all built-in robots and made-up ones of redundancy 0 to 6.
const PROBLEMS: usize = 4_000;

/// One solver per method for one robot, used again and again.
fn solvers(model: &Model) -> Vec<Solver> {
    Method::ALL.iter().map(|method| Solver::new(*method, model.cable_count(), model.dof())).collect()
}

/// The centroid of six-dimensional sets takes a tenth of a second.
fn is_affordable(method: Method, problem: &Problem) -> bool {
    method != Method::Centroid || problem.cable_count() < problem.wrench.len() + 5
}

/// Balance and limits, or a proof that there are none; `NotFound` of methods only that do not claim to find all.
fn check(answer: &Answer, problem: &Problem, context: &str) {
    let Problem { matrix, wrench, limits } = problem;
    match answer.status {
        Status::Feasible => {
            assert!(limits.contain(&answer.tensions, 0.0), "{context}: {answer:?}");
            // Dykstra's projections stop within 1e-9 of the largest limit; a dozen cables, rows of the length of the lever
            let lever = matrix.amax().max(1.0);
            let rest = answer.wrench_residual.iter().fold(0.0_f64, |most, rest| most.max(rest.abs()));
            assert!(rest <= 2e-8 * lever * problem.largest_limit(), "{context}: {rest:e} {answer:?}");
            assert!(answer.reason().is_none() && answer.certificate().is_none());
        }
        Status::Infeasible => {
            let proof = answer.certificate().expect("no rates here");
            assert!(proof.proves(matrix, wrench, limits), "{context}: {answer:?}");
            assert!(answer.reason().is_some_and(|reason| !reason.is_empty()));
        }
        Status::NotFound => {
            assert!(!answer.method.is_exact(), "{context}: {answer:?}");
            assert!(answer.reason().is_some_and(|reason| reason.contains("qp does")), "{:?}", answer.reason());
        }
        _ => panic!("{context}: {answer:?}"),
    }
}

fn norm(p: f64, parts: impl Iterator<Item = f64>) -> f64 {
    parts.map(|part| part.abs().powf(p)).sum::<f64>().powf(1.0 / p)
}

/// Answers of all methods; all verdicts agree but those of methods that may miss tensions.
fn answers(solvers: &mut [Solver], problem: &Problem, options: &Options<'_>, context: &str) -> Vec<Answer> {
    let mut answers: Vec<Answer> = Vec::new();
    for (solver, method) in solvers.iter_mut().zip(Method::ALL.iter().copied()) {
        if !is_affordable(method, problem) {
            continue;
        }
        let options = Options { p: options.p.max(method.least_p().unwrap_or(1.0)), ..*options };
        let answer = solver.solve(&problem.matrix, &problem.wrench, &problem.limits, &options).expect("fits").clone();
        let context = format!("{context}, {method}");
        check(&answer, problem, &context);
        if let Some(qp) = answers.first() {
            let agrees =
                answer.status == qp.status || (answer.status, qp.status) == (Status::NotFound, Status::Feasible);
            assert!(agrees, "{context}: {:?}, qp {:?}", answer.status, qp.status);
        }
        answers.push(answer);
    }
    answers
}

fn of(answers: &[Answer], method: Method) -> Option<&Answer> {
    answers.iter().find(|answer| answer.method == method)
}

/// Norms and barriers are compared with those of every other method.
fn compare(answers: &[Answer], problem: &Problem, p: f64, context: &str) {
    let unit = problem.largest_limit();
    let feasible: Vec<&Answer> = answers.iter().filter(|answer| answer.status == Status::Feasible).collect();
    let (Some(low), Some(high)) = (of(answers, Method::Minimum), of(answers, Method::Maximum)) else { return };
    let norms = |answer: &Answer| {
        let limits = &problem.limits;
        let missing = limits.maximum().iter().zip(&answer.tensions).map(|(largest, f)| (largest - f) / unit);
        [norm(p, answer.tensions.iter().map(|f| f / unit)), norm(p, missing)]
    };
    let ([least, _], [_, missing]) = (norms(low), norms(high));
    for other in feasible {
        let [a, b] = norms(other);
        // tensions within 1e-8 of the optimum, with a flat norm: 1e-7 is what rounding and the stop rule leave
        assert!(least <= a + 1e-7 && missing <= b + 1e-7, "{context}, p = {p}: {} {other:?}\n{low:?}", other.method);
    }
    let dykstra = of(answers, Method::Dykstra).filter(|answer| answer.status == Status::Feasible);
    if let (Some(dykstra), Some(qp)) = (dykstra, of(answers, Method::Qp)) {
        let apart = dykstra.tensions.iter().zip(&qp.tensions).fold(0.0_f64, |most, (a, b)| most.max((a - b).abs()));
        // the gap of the stop rule, 1e-9, seen through the angle between balance and limits
        assert!(apart < 1e-4 * unit, "{context}: {apart} N");
    }
    let barrier = |answer: &Answer| -> f64 {
        let ends = problem.limits.minimum().iter().zip(problem.limits.maximum());
        let distances = answer.tensions.iter().zip(ends);
        distances.map(|(f, (least, largest))| -((f - least) / unit).ln() - ((largest - f) / unit).ln()).sum()
    };
    if let (Some(centre), Some(centroid)) = (of(answers, Method::Barrier), of(answers, Method::Centroid)) {
        let (at_centre, at_centroid) = (barrier(centre), barrier(centroid));
        assert!(!(at_centroid < at_centre - 1e-9 * at_centre.abs().max(1.0)), "{context}: {at_centre} {at_centroid}");
    }
}

/// The nearest wrench: within limits, and no cable could still bring it nearer.
///
/// The squared distance is convex: what a cable could gain is no more than its slope times its way to the limit. A cable that stands
/// near its limit may have a slope, since among tensions of one wrench the programme takes the nearest to the middle.
fn check_nearest(answer: &Answer, problem: &Problem, context: &str) {
    let Problem { matrix, limits, .. } = problem;
    assert!(limits.contain(&answer.tensions, 0.0), "{context}: {answer:?}");
    let lever = matrix.amax().max(1.0);
    let size = lever * lever * problem.wrench.iter().fold(problem.largest_limit(), |most, w| most.max(w.abs()));
    for (cable, column) in matrix.column_iter().enumerate() {
        let slope: f64 = column.iter().zip(&answer.wrench_residual).map(|(entry, rest)| entry * rest).sum();
        let (f, least, largest) = (answer.tensions[cable], limits.minimum()[cable], limits.maximum()[cable]);
        // less pull would bring it nearer, or more
        let gain = f64::max(slope * (f - least), -slope * (largest - f));
        assert!(gain <= 1e-8 * size * problem.largest_limit(), "{context}, cable {cable}: {gain} {answer:?}");
    }
}

#[test]
fn every_method_balances_within_limits_or_proves_that_none_can() {
    let models = models();
    let mut solvers: Vec<Vec<Solver>> = models.iter().map(solvers).collect();
    let mut tally = vec![[0; 3]; Method::ALL.len()];
    for case in 0..PROBLEMS {
        let mut rng = ChaCha8Rng::seed_from_u64(property::first_seed() + case as u64);
        let (model, solvers) = (&models[case % models.len()], &mut solvers[case % models.len()]);
        let problem = random_problem(model, &mut rng);
        let p = [1.0, 2.0, 1.5, 4.0, 8.0][rng.random_range(0..5)];
        let context = format!("case {case}, {}", model.robot().name);
        let found = answers(solvers, &problem, &Options { p, ..Options::default() }, &context);
        for answer in &found {
            let place = Method::ALL.iter().position(|method| *method == answer.method).expect("is one");
            tally[place][[Status::Feasible, Status::NotFound, Status::Infeasible]
                .iter()
                .position(|status| *status == answer.status)
                .expect("is one")] += 1;
        }
        if found[0].status == Status::Feasible {
            compare(&found, &problem, p, &context);
        } else if let Some(nearest) = of(&found, Method::NearestWrench) {
            check_nearest(nearest, &problem, &context);
        }
    }
    for (method, &[feasible, missed, infeasible]) in Method::ALL.iter().zip(&tally) {
        println!("{method}: {feasible} feasible, {missed} missed, {infeasible} infeasible");
        assert!(feasible > PROBLEMS / 10 && infeasible > PROBLEMS / 10, "a one-sided test of {method}");
    }
    let missed = |method| tally[Method::ALL.iter().position(|other| *other == method).expect("is one")][1];
    assert!(missed(Method::ImprovedClosedForm) < missed(Method::ClosedForm) / 2, "{tally:?}");
}

/// Forces in kN, or a robot ten times as strong: the same parts of the limits.
#[test]
fn scaling_load_and_limits_scales_the_answer() {
    let models = models();
    for case in 0..400 {
        let mut rng = ChaCha8Rng::seed_from_u64(property::first_seed() + 50_000 + case as u64);
        let problem = random_problem(&models[case % models.len()], &mut rng);
        let factor = 10_f64.powf(rng.random_range(-3.0..3.0));
        let times = |list: &[f64]| -> Vec<f64> { list.iter().map(|number| factor * number).collect() };
        let limits = Limits::new(times(problem.limits.minimum()), times(problem.limits.maximum())).expect("in order");
        for method in Method::ALL.iter().copied().filter(|method| is_affordable(*method, &problem)) {
            let options = Options::default();
            let one = solve(method, &problem.matrix, &problem.wrench, &problem.limits, &options).expect("fits");
            let other = solve(method, &problem.matrix, &times(&problem.wrench), &limits, &options).expect("fits");
            assert_eq!(one.status, other.status, "case {case}, {method}");
            let apart = one.tensions.iter().zip(&other.tensions).map(|(a, b)| (a - b / factor).abs());
            // rounding through the condition of active limits; Dykstra's stop rule may fall one round later
            let tolerance = if method == Method::Dykstra { 1e-5 } else { 1e-6 } * problem.largest_limit();
            let apart = apart.fold(0.0, f64::max);
            assert!(one.status != Status::Feasible || apart < tolerance, "case {case}, {method}: {apart} N");
        }
    }
}

/// Robots of the shared collection, those without limits with 10 to 5000 N.
#[test]
fn every_method_serves_every_robot_of_the_collection() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../shared/data/robots");
    let Ok(files) = std::fs::read_dir(&folder) else {
        assert!(std::env::var_os("CI").is_none_or(|ci| ci != "true"), "{} is missing", folder.display());
        println!("skipped: {} is missing", folder.display());
        return;
    };
    let mut paths: Vec<_> = files.map(|file| file.expect("readable").path()).collect();
    paths.sort();
    for (index, path) in paths.iter().filter(|path| path.extension().is_some_and(|end| end == "toml")).enumerate() {
        let name = path.display().to_string();
        let robot = Robot::from_toml_bytes(&std::fs::read(path).expect("readable"), &name).expect("valid");
        let limits = Limits::of(&robot, None, None)
            .or_else(|_| Limits::uniform(robot.cables.len(), 10.0, 5000.0))
            .expect("in order");
        let model = Model::new(robot, Composition::STANDARD).expect("a model");
        let mut solvers = solvers(&model);
        let mut rng = ChaCha8Rng::seed_from_u64(index as u64);
        let mut feasible = 0;
        for case in 0..40 {
            let problem = random_problem_within(&model, limits.clone(), &mut rng);
            let context = format!("{name}, case {case}");
            let found = answers(&mut solvers, &problem, &Options::default(), &context);
            feasible += usize::from(found[0].status == Status::Feasible);
            if found[0].status == Status::Feasible {
                compare(&found, &problem, 2.0, &context);
            }
        }
        assert!(feasible > 3, "{name}: {feasible} of 40 feasible");
    }
}

/// Rates narrow the limits; when they are the reason, the reason says so.
#[test]
fn rates_keep_tensions_near_the_previous_ones_or_are_the_reason() {
    let matrix = nalgebra::DMatrix::from_row_slice(1, 2, &[1.0, -1.0]);
    let limits = Limits::uniform(2, 100.0, 1000.0).expect("in order");
    let solved = |method, wrench: f64, previous: &[f64], rate: f64| {
        let rates = [rate; 2];
        let options = Options {
            reference: Reference::Previous,
            previous: Some(previous),
            rates: Some(&rates),
            time_step: 0.1,
            ..Options::default()
        };
        solve(method, &matrix, &[wrench], &limits, &options).expect("fits")
    };
    for &method in Method::ALL {
        // 500 N ± 20 N: f₁ − f₂ = 30 N is possible, 50 N is not, and 40 N just so
        let near = solved(method, -30.0, &[500.0, 500.0], 200.0);
        assert_eq!(near.status, Status::Feasible, "{method}");
        assert!(near.tensions.iter().all(|f| (f - 500.0).abs() <= 20.0), "{method}: {near:?}");
        assert!((near.tensions[0] - near.tensions[1] - 30.0).abs() < 1e-6, "{method}: {near:?}");
        let far = solved(method, -50.0, &[500.0, 500.0], 200.0);
        assert_eq!(far.status, Status::Infeasible, "{method}");
        let reason = far.reason().expect("has one");
        assert!(reason.contains("without the rates there are tensions"), "{method}: {reason}");
        assert!(reason.contains("cable 1 would need 530 N, its limit allows 520 N"), "{method}: {reason}");
        let heavy = solved(method, -2000.0, &[500.0, 500.0], 200.0).reason().expect("has one");
        assert!(!heavy.contains("rate"), "{method}: {heavy}");
        let out = solved(method, 0.0, &[500.0, 1500.0], 200.0);
        let expected =
            "cable 2 had 1500.0 N, 500.0 N above its largest tension of 1000 N, and its rate lets it change by 20.0 N";
        assert!(out.reason().is_some_and(|reason| reason.starts_with(expected)), "{:?}", out.reason());
    }
}

#[test]
fn wishes_that_mean_nothing_are_refused() {
    let matrix = nalgebra::DMatrix::from_row_slice(1, 2, &[1.0, -1.0]);
    let limits = Limits::uniform(2, 100.0, 1000.0).expect("in order");
    let error =
        |options: Options<'_>| solve(Method::Qp, &matrix, &[0.0], &limits, &options).expect_err("refused").to_string();
    for (options, fault) in [
        (Options { p: 0.5, ..Options::default() }, "p of the p-norm is 0.5; it has to be from 1 to 8"),
        (Options { p: f64::NAN, ..Options::default() }, "p of the p-norm is NaN"),
        (Options { reference: Reference::Previous, ..Options::default() }, "need the previous tensions"),
        (Options { rates: Some(&[1.0, 1.0]), ..Options::default() }, "need the previous tensions"),
        (Options { previous: Some(&[1.0]), ..Options::default() }, "expected 2 previous tensions, found 1"),
        (Options { previous: Some(&[1.0, f64::NAN]), ..Options::default() }, "previous tensions is not finite"),
        (Options { reference: Reference::Given(&[1.0]), ..Options::default() }, "expected 2 reference tensions"),
        (Options { lengths: Some(&[0.0]), ..Options::default() }, "length of a wrench row (m) is 0"),
        (Options { time_step: -1.0, ..Options::default() }, "time step (s) is -1"),
        (
            Options { previous: Some(&[1.0; 2]), rates: Some(&[-1.0, 1.0]), ..Options::default() },
            "rate of tension (N/s) is -1",
        ),
    ] {
        let message = error(options);
        assert!(message.contains(fault), "{message}");
    }
}
