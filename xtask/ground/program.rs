//! A program without an operating system's library: `cargo xtask test` links it with `-nostdlib` to the crate `cdpr-core` and runs it.
//!
//! It hangs a cable over a pulley and under its own weight, writes a column of the structure matrix, solves normal equations, and lets the damped loop
//! find a root. The exit code is 0 where every number is as it must be, else the number of the first that is not.
#![no_std]
#![no_main]

use core::panic::PanicInfo;

use cdpr_core::cable::elasticity::Elasticity;
use cdpr_core::cable::law::{CableLaw, Kind};
use cdpr_core::cable::outlet::Outlet;
use cdpr_core::cable::span::Shape;
use cdpr_core::cable::stretch::hysteresis::{Hysteresis, Memory, Piece, StopOperator};
use cdpr_core::cable::stretch::{Stretch, Table};
use cdpr_core::cable::{CableInput, Recording, wrench};
use cdpr_core::geometry::Pose;
use cdpr_core::scalar::ldl;
use cdpr_core::solve::{Control, Problem, Rules, Step, StepRule, Stop, Trial, descend};

/// A loop of 200 N at 1 % strain, from constants of the program.
static PIECES: [Piece; 1] = [Piece { start: 0.0, middle: [0.0, 4e5, 0.0, 0.0], half: [0.0, 1e4, 0.0, 0.0] }];
static STOPS: [StopOperator; 1] = [StopOperator { rate: 1e3, weight: 1.0 }];

/// x² = 2 from 1, by Newton's steps.
struct Root {
    x: f64,
    trial: f64,
    step: f64,
}

impl Problem for Root {
    type Number = f64;

    fn step(&mut self, _: &Control<f64>) -> Step<f64> {
        self.step = (2.0 - self.x * self.x) / (2.0 * self.x);
        Step::whole(if self.step < 0.0 { -self.step } else { self.step }, true)
    }

    fn evaluate(&mut self, fraction: f64, _: bool) -> Trial<f64> {
        self.trial = self.x + fraction * self.step;
        Trial::new(1.0, true)
    }

    fn accept(&mut self, helps: bool, _: f64) {
        if helps {
            self.x = self.trial;
        }
    }
}

fn is_near(found: f64, expected: f64, tolerance: f64) -> bool {
    let difference = found - expected;
    difference < tolerance && -difference < tolerance
}

/// 0, or the number of the first check that fails.
fn first_failure() -> i32 {
    // the straight cable of 5 m
    let point = Outlet::Point { frame_anchor: [0.0, 0.0, 4.0] };
    let pose = Pose::from_xyz_angles([3.0, 0.0, 0.0].into(), [0.0, 0.0, 0.3]);
    let path = point.path(pose.position.into());
    if !is_near(path.length, 5.0, 1e-14) {
        return 1;
    }
    // \[u; b × u\] with u = (−0.6, 0, 0.8), b = (0, 1, 0)
    let column = wrench::wrench([0.0, 1.0, 0.0], path.direction);
    if !(is_near(column[0], -0.6, 1e-14) && is_near(column[3], 0.8, 1e-14) && is_near(column[5], 0.6, 1e-14)) {
        return 2;
    }
    // a quarter turn on a pulley of 0.1 m: q = q_f + r_p π/2
    let swivel = Outlet::Swivel { frame_anchor: [0.0; 3], swivel_axis: [0.0, 0.0, -1.0], radius: 0.1 };
    let over = swivel.path([2.1, 0.0, -0.1]);
    if !is_near(over.wrap_angle, core::f64::consts::FRAC_PI_2, 1e-12)
        || !is_near(over.length, over.free_length + 0.1 * over.wrap_angle, 1e-14)
    {
        return 3;
    }
    // a cable of 1 N/m with 500 N: longer than its chord, by less than (w l)²/(24 T²) and rounding
    let law = CableLaw {
        outlet: point,
        stretch: Stretch::Rigid,
        hidden_length: 0.0,
        series_compliance: 0.0,
        weight: [0.0, 0.0, -1.0],
        recording: Recording::EXACT,
        kind: Kind::Sagging(Shape::Catenary),
    };
    let Ok(state) = law.state([3.0, 0.0, 0.0], CableInput::OutletTension(500.0)) else { return 4 };
    if !(state.controlled_length > 5.0 && state.controlled_length < 5.0 + 1e-5) {
        return 5;
    }
    // a rope with a loop: back at the same strain it has less tension
    let Some(rope) = Hysteresis::new(Table::Constant(&PIECES), 0.02, Table::Constant(&STOPS)) else { return 6 };
    let stretched = rope.advance(0.01, &Memory::on_loading_branch(0.0));
    let relaxed = rope.advance(0.005, &stretched);
    let (up, down) = (rope.tension(0.005, &Memory::on_loading_branch(0.0)).0, rope.tension(0.005, &relaxed).0);
    if !(is_near(up, 2050.0, 1e-9) && is_near(down, 1950.0, 1e-9)) {
        return 7;
    }
    let spring = Elasticity::spring(1e4, 0.0).tension(5.01, 5.0).value;
    if !is_near(spring, 100.0, 1e-9) {
        return 8;
    }
    // 2 x + y = 3, x + 3 y = 5
    let (mut matrix, mut right) = ([[2.0, 0.0], [1.0, 3.0]], [3.0, 5.0]);
    if ldl::solve(&mut matrix, &mut right).is_none() || !is_near(right[0], 0.8, 1e-14) || !is_near(right[1], 1.4, 1e-14)
    {
        return 9;
    }
    let rules = Rules { tolerance: 1e-12, max_iterations: 20, least_gain: 0.0, rule: StepRule::Damping };
    let mut root = Root { x: 1.0, trial: 1.0, step: 0.0 };
    let end = descend(&mut root, &rules);
    if end.stop() != Stop::Stationary || !is_near(root.x, core::f64::consts::SQRT_2, 1e-12) {
        return 10;
    }
    0
}

// Entry of the program: no start-up code of a C library runs before, so the stack is aligned here.
core::arch::global_asm!(".globl _start", "_start:", "and rsp, -16", "call run");

/// All checks, and the end of the process.
#[unsafe(no_mangle)]
extern "C" fn run() -> ! {
    let code = first_failure();
    // SAFETY: exit_group takes one number and does not return.
    unsafe {
        core::arch::asm!("syscall", in("rax") 231, in("rdi") code, options(noreturn, nostack));
    }
}

#[panic_handler]
fn panic(_: &PanicInfo<'_>) -> ! {
    // SAFETY: as in `run`.
    unsafe {
        core::arch::asm!("syscall", in("rax") 231, in("rdi") 101, options(noreturn, nostack));
    }
}

/// Copies `count` bytes: one of the four functions that compilers ask of every platform.
///
/// # Safety
/// As in C: both places have so many bytes and do not overlap.
#[unsafe(no_mangle)]
unsafe extern "C" fn memcpy(target: *mut u8, source: *const u8, count: usize) -> *mut u8 {
    // SAFETY: the caller's.
    unsafe {
        core::arch::asm!("rep movsb", inout("rcx") count => _, inout("rdi") target => _, inout("rsi") source => _, options(nostack));
    }
    target
}

/// Fills `count` bytes.
///
/// # Safety
/// As in C: the place has so many bytes.
#[unsafe(no_mangle)]
unsafe extern "C" fn memset(target: *mut u8, value: i32, count: usize) -> *mut u8 {
    // SAFETY: the caller's.
    unsafe {
        core::arch::asm!("rep stosb", inout("rcx") count => _, inout("rdi") target => _, in("al") value as u8, options(nostack));
    }
    target
}

/// Never called: panics abort. The precompiled core names it.
#[unsafe(no_mangle)]
extern "C" fn rust_eh_personality() {}
