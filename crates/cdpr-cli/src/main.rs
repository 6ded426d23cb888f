//! The `cdpr` command.

fn main() {}
