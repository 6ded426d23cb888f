//! Formulas of cable-driven parallel robots that need no operating system, for control kernels and generated code.
//!
//! Everything here is a function of its arguments over [`scalar::Real`], [`scalar::Select`] or [`scalar::Smooth`]: the
//! same code serves `f64`, dual numbers and eight lanes at once. There is no `std`, no allocation and no file format;
//! features add them: `std` (the system's elementary functions; tables allocated at run time), `libm` (elementary
//! functions without a system), `vectors` (AVX2 and AVX-512, found at run time), `dual` (the traits for dual numbers),
//! `files` (names of choices in files).
//!
//! | module | content |
//! |---|---|
//! | [`scalar`] | number types, small factorisations |
//! | [`geometry`] | pose, twist, wrench, rates of angles |
//! | [`solve`] | the one damped loop (Levenberg–Marquardt step and others) and its convergence test |
//! | [`cable`] | outlet, path, law of stretch, span, state of one cable |
//! | [`structure`] | cables in lanes: lengths and structure matrix Aᵀ |
//!
//! SI units and radians everywhere; frames and signs as in the symbol table of the crate `cdpr`.
#![cfg_attr(not(any(feature = "std", test)), no_std)]

#[cfg(not(any(feature = "std", feature = "libm", test)))]
compile_error!(
    "elementary functions are missing: enable the feature `std`, or `libm` where there is no operating system"
);

pub mod cable;
pub mod geometry;
pub mod scalar;
pub mod solve;
pub mod structure;
