//! Exit codes: what the program says to other programs. One list; `--help` and the README have their sentence from it.

use std::process::ExitCode;

/// How a command ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Exit {
    /// It did what it was asked.
    Finished,
    /// It ran, and what was expected of it is not so.
    NotMet,
    /// Nothing can be said: it did not run, or not on what was asked.
    CouldNotRun,
    /// Ctrl-C or SIGTERM ended it before it had finished.
    StoppedEarly,
}

impl Exit {
    /// Every way to end.
    pub const ALL: [Exit; 4] = [
        Exit::Finished,
        Exit::NotMet,
        Exit::CouldNotRun,
        Exit::StoppedEarly,
    ];

    /// The code that the shell sees. 130 is what shells say of a program that Ctrl-C ended.
    pub const fn code(self) -> u8 {
        match self {
            Exit::Finished => 0,
            Exit::NotMet => 1,
            Exit::CouldNotRun => 2,
            Exit::StoppedEarly => 130,
        }
    }

    /// When it is given, in words.
    pub const fn when(self) -> &'static str {
        match self {
            Exit::Finished => {
                "finished (a divergence, an ending, a refusal among several engines included)"
            }
            Exit::NotMet => "only from check, diff, fuzz and stability: an expectation is not met",
            Exit::CouldNotRun => {
                "it could not run (bad usage, bad scene, missing baseline, or run of one engine that refuses: nothing is written)"
            }
            Exit::StoppedEarly => {
                "stopped by the user (Ctrl-C, SIGTERM) before it had finished, with \"stopped early\" in the first line of what is \
                 printed or written (JSON: the key stopped_early; CSV: on stderr and in run.json)"
            }
        }
    }
}

impl From<Exit> for ExitCode {
    fn from(exit: Exit) -> ExitCode {
        ExitCode::from(exit.code())
    }
}

/// Every code and when it is given, in one sentence.
pub fn sentence() -> String {
    let one = |exit: Exit| format!("{} {}", exit.code(), exit.when());
    format!("Exit codes: {}.", Exit::ALL.map(one).join("; "))
}
