//! `precision=auto`: starts in f64 and goes on to more digits when an event turns out to be too close to call.

use super::certainty::{MOST_BALLS, certify_run};
use super::solve::Solver;
use super::{PRECISION, Prepared, Settings};
use crate::engine::setting::refuse;
use crate::engine::{Inside, Limits, Parameter, Refusal, Run};
use crate::math::{DoubleDouble, Octuple, Real};
use crate::scene::Scene;
use crate::trace::{Counter, Ending, Provenance, Record, Trace};

/// A run whose scalar is chosen by what happens.
pub struct Escalating<'a> {
    start: Prepared<'a, f64>,
}

impl<'a> Escalating<'a> {
    /// The scene in f64, where every run begins.
    pub fn boxed(
        scene: &'a Scene,
        provenance: Provenance,
        settings: &Settings,
    ) -> Result<Box<dyn Run + 'a>, Refusal> {
        if scene.balls.len() > MOST_BALLS {
            let message = format!(
                "`precision=auto` looks at every ball for every event and takes at most {MOST_BALLS} balls; the scene has {}: \
                 choose f64, dd or f256",
                scene.balls.len()
            );
            return Err(refuse(Some(PRECISION), message));
        }
        let start = Prepared::new(scene, provenance, settings);
        Ok(Box::new(Escalating { start }))
    }
}

impl Run for Escalating<'_> {
    fn inside(&self) -> Inside {
        self.start.inside()
    }

    fn sheet(&self) -> Vec<Parameter> {
        self.start.sheet()
    }

    fn simulate(self: Box<Self>, record: Record, limits: &Limits<'_>) -> Trace {
        // without events there is nothing to judge by
        let fullest = match record {
            Record::Final => Record::Events,
            other => other,
        };
        let Prepared {
            scene,
            solver,
            provenance,
            contacts,
            ..
        } = self.start;
        let mut trace = judged(solver, provenance.clone(), fullest, limits);
        if !is_certain(&trace) {
            let solver = Solver::<DoubleDouble>::new(scene).at_contacts(contacts);
            trace = judged(solver, provenance.clone(), fullest, limits);
        }
        if !is_certain(&trace) {
            trace = judged(
                Solver::<Octuple>::new(scene).at_contacts(contacts),
                provenance,
                fullest,
                limits,
            );
        }
        if record == Record::Final {
            trace.pare();
        }
        trace
    }
}

/// A run with the certainty of its events.
fn judged<T: Real>(
    solver: Solver<'_, T>,
    provenance: Provenance,
    record: Record,
    limits: &Limits<'_>,
) -> Trace {
    let scene = solver.balls().scene();
    let mut trace = solver.run(provenance, record, limits);
    certify_run(scene, &mut trace, T::ULP, limits);
    let bits = Counter::Bits.id().to_owned();
    trace.counters.insert(bits, u64::from(T::BITS));
    trace.provenance.ulp = T::ULP;
    trace
}

/// True if more digits would change nothing: every event is clear, and the end is not one that rounding brought about.
fn is_certain(trace: &Trace) -> bool {
    match trace.ending {
        Ending::Indeterminate(_) | Ending::Undecidable(_) | Ending::Collapsed(_) => false,
        Ending::Cancelled => true,
        _ => trace.certainty.iter().all(|certainty| certainty.is_clear()),
    }
}
