//! The operations of every vector unit of the machine, against those of `f64`.
#![allow(clippy::unwrap_used, reason = "tests fail by panic")]

use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

use cdpr::scalar::{Kernel, LANES, Lanes, Select, Unit, dispatch, dispatch_narrow, dispatch_on};

/// Every operation on one number type, for two operands.
#[inline(always)]
fn every_operation<T: Select>(a: T, b: T) -> [T; 12] {
    let less = a.is_less(b);
    let chosen = (a + b).select(less, a - b);
    [a + b, a - b, a * b, a / b, -a, a.sqrt(), a.full_angle(b), a.abs(), a.min(b), a.max(b), chosen, a.constant(0.1)]
}

/// [`every_operation`] on whole slices, its results one after the other, and sum and `any` per eight numbers.
struct EveryOperation<'a> {
    a: &'a [f64],
    b: &'a [f64],
}

impl Kernel for EveryOperation<'_> {
    type Output = (Vec<[[f64; LANES]; 12]>, Vec<(f64, bool)>);

    #[inline(always)]
    fn run<L: Lanes>(self, lanes: L) -> Self::Output {
        let chunks = || self.a.chunks_exact(LANES).zip(self.b.chunks_exact(LANES));
        let results = chunks().map(|(a, b)| every_operation(lanes.load(a), lanes.load(b)).map(Lanes::to_array));
        let reductions = chunks().map(|(a, b)| {
            let (a, b) = (lanes.load(a), lanes.load(b));
            (a.sum(), a.any(a.is_less(b)))
        });
        (results.collect(), reductions.collect())
    }
}

/// Two operands: all pairs of special values, then random ones; their number is a multiple of eight.
fn operands() -> (Vec<f64>, Vec<f64>) {
    let tiny = f64::from_bits(1);
    let special = [0.0, 1.0, 0.5, 1e-310, tiny, 1e200, 1.7e308, f64::MIN_POSITIVE, f64::INFINITY, f64::NAN];
    let special: Vec<f64> = special.iter().flat_map(|&x| [x, -x]).collect();
    let mut pairs: Vec<_> = special.iter().flat_map(|&a| special.iter().map(move |&b| (a, b))).collect();
    let mut generator = ChaCha8Rng::seed_from_u64(2);
    for magnitude in [1.0, 1.0, 1e-12, 1e150] {
        pairs.extend((0..4_000).map(|_| {
            let mut next = |largest: f64| generator.random_range(-largest..largest);
            (next(magnitude), next(1.0))
        }));
    }
    assert_eq!(pairs.len() % LANES, 0);
    pairs.into_iter().unzip()
}

/// Equal bits, or NaN on both sides: the sign and payload of a NaN depend on the instruction.
fn is_same(a: f64, b: f64) -> bool {
    a.to_bits() == b.to_bits() || (a.is_nan() && b.is_nan())
}

#[test]
fn every_unit_gives_the_bits_of_f64() {
    let (a, b) = operands();
    for unit in Unit::available() {
        let (results, _) = dispatch_on(unit, EveryOperation { a: &a, b: &b }).expect("an available unit");
        for (index, (&a, &b)) in a.iter().zip(&b).enumerate() {
            let expected = every_operation(a, b);
            for operation in 0..expected.len() {
                let found = results[index / LANES][operation][index % LANES];
                let same = is_same(found, expected[operation]);
                assert!(same, "operation {operation} of {a:e} and {b:e} on {unit:?}: {found:e}");
            }
        }
    }
}

#[test]
fn every_unit_gives_the_same_sums_and_the_same_any() {
    let (a, b) = operands();
    let (_, expected) = dispatch_on(Unit::Portable, EveryOperation { a: &a, b: &b }).expect("always there");
    for (chunk, &(_, any)) in expected.iter().enumerate() {
        let lanes = chunk * LANES..(chunk + 1) * LANES;
        assert_eq!(any, a[lanes.clone()].iter().zip(&b[lanes]).any(|(a, b)| a < b));
    }
    for unit in Unit::available() {
        let (_, found) = dispatch_on(unit, EveryOperation { a: &a, b: &b }).expect("an available unit");
        let same = found.iter().zip(&expected).all(|(f, e)| is_same(f.0, e.0) && f.1 == e.1);
        assert!(same, "sums or any on {unit:?}");
    }
}

#[test]
fn sum_adds_all_eight_lanes() {
    struct Sum;
    impl Kernel for Sum {
        type Output = f64;
        #[inline(always)]
        fn run<L: Lanes>(self, lanes: L) -> f64 {
            lanes.load(&[1.0, 2.0, 4.0, 8.0, 16.0, 32.0, 64.0, 128.0]).sum()
        }
    }
    assert_eq!(dispatch(Sum), 255.0);
    assert_eq!(dispatch_narrow(Sum), 255.0);
}

#[test]
fn store_writes_eight_numbers_and_leaves_the_rest() {
    struct Store<'a>(&'a mut [f64]);
    impl Kernel for Store<'_> {
        type Output = ();
        #[inline(always)]
        fn run<L: Lanes>(self, lanes: L) {
            lanes.constant(3.0).store(self.0);
        }
    }
    for unit in Unit::available() {
        let mut target = [1.0; 9];
        dispatch_on(unit, Store(&mut target)).expect("an available unit");
        assert_eq!(target, [3.0, 3.0, 3.0, 3.0, 3.0, 3.0, 3.0, 3.0, 1.0]);
    }
}

#[test]
fn a_unit_runs_exactly_when_it_is_available() {
    struct Nothing;
    impl Kernel for Nothing {
        type Output = ();
        #[inline(always)]
        fn run<L: Lanes>(self, _lanes: L) {}
    }
    for unit in [Unit::Portable, Unit::Avx2, Unit::Avx512] {
        assert_eq!(dispatch_on(unit, Nothing).is_some(), unit.is_available());
        assert_eq!(Unit::available().any(|each| each == unit), unit.is_available());
    }
}
