//! Marks around counted work, for callgrind and for stepping.

use std::hint::black_box;
use std::thread::yield_now;

use cdpr::scalar::Unit;

/// Prints the vector unit that the work runs on.
pub(crate) fn print_unit() {
    let unit = Unit::available().last().expect("every machine has the portable one");
    println!("unit {unit:?}");
}

/// Lets go when standard input ends: whoever counts steps has taken hold by then.
pub(crate) fn wait_for_start() {
    std::io::copy(&mut std::io::stdin(), &mut std::io::sink()).expect("standard input");
}

/// Does the work twice, counted the second time: what the first use of something prepares is not counted.
///
/// Stepping counts from one system call `sched_yield` to the next, which nothing else here makes.
pub(crate) fn count(name: &str, work: &mut dyn FnMut() -> usize) {
    let first = work();
    assert!(first > 0, "{name} succeeds at nothing");
    println!("count {name}");
    yield_now();
    let second = counted(work);
    yield_now();
    assert_eq!(first, second, "{name} differs the second time");
}

/// Callgrind counts while it is in this function, and knows it by its name.
#[inline(never)]
fn counted(work: &mut dyn FnMut() -> usize) -> usize {
    black_box(work())
}
