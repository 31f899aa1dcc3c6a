//! The only place for arguments, environment, terminal, paths and Ctrl-C.

pub mod output;

use std::process::ExitCode;

/// Runs the program with the arguments of the process.
pub fn main() -> ExitCode {
    ExitCode::SUCCESS
}
