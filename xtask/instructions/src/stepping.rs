//! Counts the instructions of another run of this program by stepping through it, on the unit that valgrind does not have.

use std::error::Error;
use std::process::{Command, Stdio};

use cdpr::scalar::Unit;
use nix::libc::{SYS_sched_yield, user_regs_struct};
use nix::sys::ptrace::{self, Options};
use nix::sys::signal::Signal;
use nix::sys::wait::{WaitStatus, waitpid};
use nix::unistd::Pid;

/// Runs this program with an argument; says after each work's name how many instructions it took. Nothing where the machine lacks the unit.
pub(crate) fn count(argument: &str) -> Result<(), Box<dyn Error>> {
    if !Unit::Avx512.is_available() {
        return Ok(());
    }
    let mut program = Command::new(std::env::current_exe()?);
    let mut child = program.arg(argument).stdin(Stdio::piped()).spawn()?;
    let traced = Pid::from_raw(child.id().try_into()?);
    if let Err(reason) = ptrace::seize(traced, Options::PTRACE_O_TRACESYSGOOD | Options::PTRACE_O_EXITKILL) {
        println!("refused {reason}");
        return Ok(child.kill()?);
    }
    ptrace::interrupt(traced)?;
    waitpid(traced, None)?;
    // the end of its input, for which it waits
    drop(child.stdin.take());
    loop {
        ptrace::syscall(traced, None)?;
        match waitpid(traced, None)? {
            WaitStatus::PtraceSyscall(_) if is_mark(&ptrace::getregs(traced)?) => {
                // out of the system call
                ptrace::syscall(traced, None)?;
                waitpid(traced, None)?;
                println!("instructions {}", steps(traced)?);
            }
            WaitStatus::Exited(_, 0) => return Ok(()),
            WaitStatus::PtraceSyscall(_) => {}
            other => return Err(format!("`{argument}` came to {other:?}").into()),
        }
    }
}

/// Instructions up to the next mark.
fn steps(traced: Pid) -> Result<u64, Box<dyn Error>> {
    let mut count = 0;
    loop {
        ptrace::step(traced, None)?;
        match waitpid(traced, None)? {
            WaitStatus::Stopped(_, Signal::SIGTRAP) => count += 1,
            other => return Err(format!("a step came to {other:?}").into()),
        }
        if is_mark(&ptrace::getregs(traced)?) {
            return Ok(count);
        }
    }
}

/// Whether the last system call is the one that marks counted work.
fn is_mark(registers: &user_regs_struct) -> bool {
    i64::try_from(registers.orig_rax) == Ok(SYS_sched_yield)
}
