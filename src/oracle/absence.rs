//! Whether a run is a reference, and what is said where there is none.

use super::engine;
use crate::engine::Refusal;
use crate::trace::{Ending, Trace};

/// What is said where the reference cannot say how far its own run can be believed.
pub const NOTHING: &str = "the exact engine has nothing to hold it against";

/// Why a scene has no reference.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Absence<'a> {
    /// It was not asked.
    NotAsked,
    /// The user asked to stop before its end.
    Stopped,
    /// It refused to run.
    Refused(&'a Refusal),
    /// It did not reach the end that the scene asks for.
    Ended(&'a Trace),
}

/// What kind of absence it is: these are told apart wherever one is spoken of.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Lack {
    /// Nobody asked for the reference, or the user asked to stop before its end.
    NotAsked,
    /// The reference does not run the scene.
    Refused,
    /// The physics of the scene has no one answer from then on, s.
    NotUnique(f64),
    /// The reference stopped there, s, and says nothing of what comes after.
    StoppedAt(f64),
}

impl Absence<'_> {
    /// Its kind.
    pub fn lack(self) -> Lack {
        match self {
            Absence::NotAsked | Absence::Stopped | Absence::Refused(Refusal::Stopped) => {
                Lack::NotAsked
            }
            Absence::Refused(_) => Lack::Refused,
            Absence::Ended(trace) => match trace.ending {
                Ending::Cancelled => Lack::NotAsked,
                Ending::Indeterminate(_) => Lack::NotUnique(trace.end_time),
                _ => Lack::StoppedAt(trace.end_time),
            },
        }
    }

    /// In one sentence. `ended`: how a run ended.
    pub fn in_words(self, ended: impl FnOnce(&Trace) -> String) -> String {
        match self {
            Absence::NotAsked => format!("the {} engine was not asked", engine().id()),
            Absence::Stopped => format!("the {} run was stopped before its end", engine().id()),
            Absence::Refused(refusal) => format!("{} {refusal}", engine().id()),
            Absence::Ended(trace) => ended(trace),
        }
    }
}

/// The run of the reference, if it is an answer: one that reached the end that the scene asks for. Errors: why it is none.
pub fn answer<'a>(ran: Result<&'a Trace, &'a Refusal>) -> Result<&'a Trace, Absence<'a>> {
    match ran {
        Err(refusal) => Err(Absence::Refused(refusal)),
        Ok(trace) if trace.ending.is_complete() => Ok(trace),
        Ok(trace) => Err(Absence::Ended(trace)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::engine::exact::solve;
    use crate::engine::{Limits, Roster};
    use crate::oracle::is_reference;
    use crate::scene::catalogue;

    fn run(max_events: u64) -> Trace {
        let scene = catalogue::scene("report-break").unwrap_or_else(|error| panic!("{error}"));
        let limits = Limits {
            max_events,
            ..Limits::NONE
        };
        solve::<f64>(&scene, &limits).trace
    }

    #[test]
    fn only_a_run_to_the_end_that_the_scene_asks_for_is_an_answer() {
        let (whole, cut) = (run(10_000), run(3));
        assert!(whole.ending == Ending::Rest && matches!(cut.ending, Ending::Budget(_)));
        assert_eq!(answer(Ok(&whole)), Ok(&whole));
        assert_eq!(answer(Ok(&cut)), Err(Absence::Ended(&cut)));
        let refusal = Refusal::NotComparable {
            missing: vec!["something".into()],
        };
        assert_eq!(answer(Err(&refusal)), Err(Absence::Refused(&refusal)));
        let said = |absence: Absence<'_>| absence.in_words(|trace| trace.ending.id().to_owned());
        assert_eq!(said(Absence::Ended(&cut)), "budget");
        assert_eq!(
            said(Absence::Refused(&refusal)),
            "exact cannot simulate something"
        );
        assert_eq!(said(Absence::NotAsked), "the exact engine was not asked");
        // a run that was stopped is told in the words of its refusal, and one that never began in its own
        let stopped = Absence::Refused(&Refusal::Stopped);
        assert_eq!(said(stopped), "exact was stopped before its end");
        assert_eq!(
            said(Absence::Stopped),
            "the exact run was stopped before its end"
        );
    }

    #[test]
    fn one_engine_of_all_is_the_reference() {
        let roster = Roster::built_in();
        let references = roster.iter().filter(|one| is_reference(one.as_ref()));
        let ids: Vec<&str> = references.map(|one| one.id()).collect();
        assert_eq!(ids, [engine().id()]);
    }
}
