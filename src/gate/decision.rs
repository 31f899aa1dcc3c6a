//! What follows from how a run stands to what was accepted.

use thiserror::Error;

/// How a run stands to what was accepted.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Standing {
    /// It was stopped before its end.
    pub cut_short: bool,
    /// Scenes of which nothing is accepted.
    pub missing: usize,
    /// Scenes that are no longer those whose findings were accepted.
    pub stale: usize,
    /// Findings that differ.
    pub changes: usize,
    /// Promised invariants that do not hold.
    pub broken_promises: usize,
}

/// What follows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Decision {
    /// Everything is as accepted.
    Met,
    /// Something is not, or a promise is broken, which no acceptance excuses.
    NotMet,
    /// Not everything was held, so nothing can be said: a run that did not reach its end cannot pass.
    Incomplete,
}

/// Why findings cannot be accepted.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum Refused {
    /// The run was stopped.
    #[error("nothing is accepted: the run was stopped before its end")]
    CutShort,
    /// A promise is broken.
    #[error(
        "nothing is accepted: {0} promised invariant(s) do not hold, and what is promised is not up to acceptance"
    )]
    BrokenPromise(usize),
}

impl Standing {
    /// What follows for whoever asked.
    pub fn decision(&self) -> Decision {
        if self.cut_short || self.missing > 0 {
            Decision::Incomplete
        } else if self.stale + self.changes + self.broken_promises > 0 {
            Decision::NotMet
        } else {
            Decision::Met
        }
    }

    /// Whether the findings may be accepted.
    pub fn acceptance(&self) -> Result<(), Refused> {
        match *self {
            Standing {
                cut_short: true, ..
            } => Err(Refused::CutShort),
            Standing {
                broken_promises: broken @ 1..,
                ..
            } => Err(Refused::BrokenPromise(broken)),
            _ => Ok(()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Decision, Refused, Standing};

    #[test]
    fn only_a_whole_run_without_any_difference_meets_what_was_accepted() {
        let met = Standing::default();
        assert_eq!(met.decision(), Decision::Met);
        for (standing, expected) in [
            (Standing { changes: 1, ..met }, Decision::NotMet),
            (Standing { stale: 1, ..met }, Decision::NotMet),
            (
                Standing {
                    broken_promises: 1,
                    ..met
                },
                Decision::NotMet,
            ),
            (Standing { missing: 1, ..met }, Decision::Incomplete),
            (
                Standing {
                    cut_short: true,
                    ..met
                },
                Decision::Incomplete,
            ),
            (
                Standing {
                    cut_short: true,
                    changes: 1,
                    ..met
                },
                Decision::Incomplete,
            ),
        ] {
            assert_eq!(standing.decision(), expected, "{standing:?}");
        }
    }

    #[test]
    fn a_broken_promise_and_a_run_that_was_stopped_are_never_accepted() {
        let met = Standing::default();
        for (standing, expected) in [
            (met, Ok(())),
            (
                Standing {
                    changes: 9,
                    missing: 2,
                    stale: 1,
                    ..met
                },
                Ok(()),
            ),
            (
                Standing {
                    broken_promises: 2,
                    ..met
                },
                Err(Refused::BrokenPromise(2)),
            ),
            (
                Standing {
                    cut_short: true,
                    ..met
                },
                Err(Refused::CutShort),
            ),
        ] {
            assert_eq!(standing.acceptance(), expected, "{standing:?}");
        }
    }
}
