//! The linearized motion against dual numbers of the law.

use nalgebra::{Const, SVector};
use num_dual::{Derivative, DualVec};

use super::hysteresis::{Hysteresis, Memory, MemoryChange};
use super::hysteresis_tests::law;

/// Derivatives by tension, strain and stops of the memory.
type Dual = DualVec<f64, Const<5>>;

fn variable(value: f64, index: usize) -> Dual {
    Dual::new(value, Derivative::some(SVector::<f64, 5>::ith(index, 1.0)))
}

fn gradient(dual: Dual) -> SVector<f64, 5> {
    dual.eps.unwrap_generic(Const, Const::<1>)
}

/// Stops after a motion to a strain, from a memory of dual numbers.
fn stops(law: &Hysteresis, strain: Dual, (before, stops): (Dual, [Dual; 3])) -> [Dual; 3] {
    let one = Dual::from(1.0);
    std::array::from_fn(|j| {
        let free = stops[j] + (strain - before) * Dual::from(law.stops()[j].rate);
        match free.re.abs() < 1.0 {
            true => free,
            false if free.re < 0.0 => -one,
            false => one,
        }
    })
}

/// f = ½(up + down) + ½(up − down) Σ wⱼ Sⱼ.
fn tension(law: &Hysteresis, strain: Dual, stops: [Dual; 3]) -> Dual {
    let (up, down) = (law.loading(strain).0, law.unloading(strain).0);
    let state = (0..3).fold(Dual::from(0.0), |sum, j| sum + stops[j] * Dual::from(law.stops()[j].weight));
    ((up + down) + (up - down) * state) * Dual::from(0.5)
}

/// Memories with stops that follow, that slide, and of both kinds, and tensions that continue or reverse the motion.
#[test]
fn motions_agree_with_dual_numbers() {
    let law = law();
    let turned = law.advance(0.0093, &Memory::on_unloading_branch(0.009));
    let again = law.advance(0.0091, &turned);
    let mut kinds = [0; 2];
    for memory in [Memory::virgin(), Memory::on_loading_branch(0.009), turned, again] {
        for target in [40.0, 900.0, 4000.0, 4480.0, 4600.0, 11000.0] {
            let motion = law.motion(target, &memory);
            let dual = (variable(memory.strain, 1), std::array::from_fn(|j| variable(memory.stops[j], 2 + j)));
            // one step of Newton's method carries the derivatives
            let at = |strain: Dual| tension(&law, strain, stops(&law, strain, dual));
            let slope = law.tension(motion.strain, &memory).1;
            let first = Dual::from(motion.strain);
            let strain = first - (at(first) - variable(target, 0)) / Dual::from(slope);
            let after = stops(&law, strain, dual).map(gradient);
            kinds[usize::from(motion.forgets())] += 1;
            for index in 0..5 {
                let mut before = MemoryChange { strain: f64::from(u8::from(index == 1)), ..MemoryChange::default() };
                if index > 1 {
                    before.stops[index - 2] = 1.0;
                }
                let found = motion.strain_change(f64::from(u8::from(index == 0)), &before);
                let expected = gradient(strain)[index];
                // compliances are 1e-6 to 1e-3 1/N, of strains and stops up to 1
                let apart = (found - expected).abs();
                assert!(
                    apart < 1e-12 * expected.abs() + 1e-18,
                    "{memory:?} to {target} N by {index}: {found} {expected}"
                );
                let moved = motion.memory_change(found, &before);
                for j in 0..3 {
                    let apart = (moved.stops[j] - after[j][index]).abs();
                    assert!(
                        apart < 1e-11 * after[j][index].abs() + 1e-14,
                        "{memory:?} to {target} N: stop {j} by {index}"
                    );
                }
            }
        }
    }
    assert!(kinds.iter().all(|&count| count > 2), "{kinds:?}");
}

#[test]
fn a_motion_knows_how_near_a_stop_is_to_its_end() {
    let law = law();
    let memory = Memory::on_loading_branch(0.009);
    let tension = |strain: f64| law.tension(strain, &memory).0;
    // not moved at all, and turned by 1e-6
    assert!(law.motion(tension(0.009), &memory).margin() < 1e-15);
    assert!((law.motion(tension(0.009 - 1e-6), &memory).margin() - 1e-6).abs() < 1e-15);
    // the narrowest stop, 4e-4 wide each way, has come to its other end
    assert!(law.motion(tension(0.009 - 4e-4), &memory).margin() < 1e-15);
    // a deviation that moves both ends of a zero motion alike leaves the stops where they are, another one does not
    let still = law.motion(tension(0.009), &memory);
    let before = MemoryChange { strain: 1.0, ..MemoryChange::default() };
    assert_eq!(still.crossing(1e-9, 1.0, &before), 0.0);
    assert_eq!(still.crossing(1e-9, 1.5, &before), 0.5);
    let pushed = law.motion(tension(0.009), &still.pushed_on(1e-9, &memory));
    assert!(pushed.forgets() && (1e-9..3e-9).contains(&pushed.margin()), "{pushed:?}");
}
