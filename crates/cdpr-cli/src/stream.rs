//! Streams that a command writes to.

use std::io::{self, IsTerminal, Write};

/// A stream that a command writes to: standard output or standard error, which may be a terminal, or memory.
pub trait Stream: Write + Send {
    /// True if the stream is a terminal.
    fn is_terminal(&self) -> bool {
        false
    }

    /// True for a stream of the process itself, to which signs of life may be written while a command works.
    fn is_of_process(&self) -> bool {
        false
    }

    /// Characters in a line of the terminal; `None` if the stream is none, or does not tell.
    fn width(&self) -> Option<usize> {
        None
    }
}

impl Stream for io::Stdout {
    fn is_terminal(&self) -> bool {
        IsTerminal::is_terminal(self)
    }

    fn width(&self) -> Option<usize> {
        if !IsTerminal::is_terminal(self) {
            return None;
        }
        terminal_size::terminal_size_of(self).map(|(width, _)| usize::from(width.0)).filter(|width| *width > 0)
    }
}

impl Stream for io::Stderr {
    fn is_of_process(&self) -> bool {
        true
    }

    fn is_terminal(&self) -> bool {
        IsTerminal::is_terminal(self)
    }
}

impl Stream for Vec<u8> {}
