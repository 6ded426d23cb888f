//! Feasibility of sets against the feasibility of single wrenches.

use super::*;
use crate::wrench_set::{Payload, RequiredSet};
use cdpr_model::tension::quadratic::{self, Status};

fn straight_models() -> Vec<Model> {
    let names = ["planar-example", "kntu-planar", "cogiro", "cablerobot-simulator-helicopter", "fast"];
    names.iter().map(|name| model(name, Composition::STANDARD)).collect()
}

#[test]
fn a_set_of_one_wrench_is_feasible_where_the_wrench_is() {
    for model in straight_models() {
        let (load, limits) = (Load::of(model.robot()).unwrap(), Limits::of(model.robot(), None, None).unwrap());
        let set = WrenchSetFeasible::with_ball(&model, &limits, &load, [0.0, 0.0], None).unwrap();
        let single = WrenchFeasible::new(&model, &load, &limits).unwrap();
        for pose in poses(&model, 150, 3.0, 101) {
            let (of_set, of_wrench) = (set.judge(&pose), single.judge(&pose));
            // on the boundary, to 1e-6 of the limits, either answer is right
            if of_wrench.margin.abs() > 9e-3 {
                assert_eq!(of_set.holds(), of_wrench.holds(), "{}: {of_set:?} {of_wrench:?}", model.robot().name);
            }
        }
    }
}

/// If a set holds, every wrench sampled from it is feasible; if it fails, the wrench named by the margin is not.
#[test]
fn a_set_is_feasible_where_all_its_wrenches_are() {
    let mut rng = ChaCha8Rng::seed_from_u64(102);
    for model in straight_models().into_iter().take(4) {
        let (load, limits) = (Load::of(model.robot()).unwrap(), Limits::of(model.robot(), None, None).unwrap());
        let payload = Payload::of(model.robot(), Some([20.0, 150.0]), 3.0, 0.5).unwrap();
        let dof = model.dof();
        let half_extent: Vec<f64> = (0..dof).map(|_| 40.0).collect();
        let around = RequiredSet::Box { center: vec![0.0; dof], half_extent };
        for requirement in [Requirement::AroundLoad(load, around), Requirement::Payload(payload)] {
            let criterion = WrenchSetFeasible::new(&model, &limits, requirement, None).unwrap();
            let (mut held, mut failed) = (0, 0);
            for pose in poses(&model, 60, 2.0, 103) {
                let (matrix, required) = (model.structure_matrix(&pose).unwrap(), criterion.required(&pose));
                let feasible = |wrench: &[f64]| {
                    quadratic::solve(&matrix, wrench, &limits, None).unwrap().status == Status::Feasible
                };
                let margin = criterion.available(&pose).unwrap().margin(&required).unwrap();
                let verdict = criterion.judge(&pose);
                if margin.distance.abs() < 1e-3 {
                    continue;
                }
                match verdict.holds() {
                    true => {
                        held += 1;
                        for _ in 0..20 {
                            let direction: Vec<f64> = (0..dof).map(|_| rng.random_range(-1.0..1.0)).collect();
                            assert!(feasible(&required.furthest(&direction)), "{}: {pose:?}", model.robot().name);
                        }
                    }
                    false => {
                        failed += 1;
                        assert!(!feasible(&margin.wrench), "{}: {verdict:?}", model.robot().name);
                        assert!(verdict.reason.unwrap().contains("outside what the cables can balance"));
                    }
                }
            }
            assert!(held + failed > 50, "{}: {held} {failed}", model.robot().name);
        }
    }
}

/// Static feasibility is dynamic feasibility without acceleration; a larger acceleration or range of masses never
/// helps.
#[test]
fn what_can_be_accelerated_can_be_held() {
    let model = model("cablerobot-simulator-helicopter", Composition::STANDARD);
    let limits = Limits::of(model.robot(), None, None).unwrap();
    let payload = |mass, a, alpha| {
        let payload = Payload::of(model.robot(), Some(mass), a, alpha).unwrap();
        WrenchSetFeasible::new(&model, &limits, Requirement::Payload(payload), None).unwrap()
    };
    let load = Load::of(model.robot()).unwrap();
    let of_load = WrenchSetFeasible::with_ball(&model, &limits, &load, [0.0, 0.0], None).unwrap();
    let (fixed, range) = (payload([100.0; 2], 0.0, 0.0), payload([50.0, 200.0], 0.0, 0.0));
    let (moved, turned) = (payload([50.0, 200.0], 14.0, 0.0), payload([50.0, 200.0], 14.0, 2.0));
    for pose in poses(&model, 100, 3.0, 104) {
        let margins = [&fixed, &range, &moved, &turned].map(|criterion| criterion.judge(&pose).margin);
        assert!((of_load.judge(&pose).margin - margins[0]).abs() < 1e-6);
        assert!(margins.windows(2).all(|pair| pair[1] <= pair[0]), "{margins:?}");
    }
}
