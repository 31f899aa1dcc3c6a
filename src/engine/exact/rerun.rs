//! A run taken again in dual numbers, for its derivatives.

use super::AtContacts;
use super::derived::{Derived, Found, LANES, Seeds, Task, slopes};
use super::solve::{Played, Solver};
use crate::engine::Limits;
use crate::math::{DoubleDouble, Dual, Octuple, Real};
use crate::scene::Scene;
use crate::trace::{Provenance, Record, Trace};

/// Takes a run again with derivatives; `None` for one in fewer digits than f64.
pub fn follow(
    scene: &Scene,
    trace: &Trace,
    ulp: f64,
    seeds: Seeds,
    task: Task,
    limits: &Limits<'_>,
) -> Option<Found> {
    if ulp <= Octuple::ULP {
        run::<Octuple>(scene, trace, seeds, task, limits)
    } else if ulp <= DoubleDouble::ULP {
        run::<DoubleDouble>(scene, trace, seeds, task, limits)
    } else if ulp <= f64::EPSILON {
        run::<f64>(scene, trace, seeds, task, limits)
    } else {
        None
    }
}

fn run<T: Real>(
    scene: &Scene,
    trace: &Trace,
    seeds: Seeds,
    task: Task,
    limits: &Limits<'_>,
) -> Option<Found> {
    let mut balls = seeds.kinematics::<Dual<T, LANES>>(scene);
    let mut derived = Derived::new(seeds, task, balls.count());
    derived.disturb_all(&mut balls);
    let limits = Limits {
        max_events: trace.events.len() as u64,
        ..*limits
    };
    let solver = Solver::of(balls).at_contacts(AtContacts::Follow);
    let solver = solver.deriving(derived);
    let mut played = solver.play(Provenance::default(), Record::Events, &limits, false);
    let until = played.derived().and_then(Derived::until);
    let until = until.map_or(trace.end_time, |until| until.min(trace.end_time));
    let places = places(&played, until);
    let derived = played.take_derived();
    let events = played.trace().events;
    let both = events.iter().zip(&trace.events);
    let same = both.take_while(|(ours, theirs)| ours == theirs).count();
    derived.map(|derived| derived.into_found(same, places))
}

/// Derivatives of where all balls are at a time that has none, s.
fn places<T: Real>(played: &Played<'_, T>, until: f64) -> Vec<[[f64; LANES]; 2]> {
    let balls = played.balls();
    let at = |ball: usize| {
        let fallen = played.derived().and_then(|derived| derived.fallen(ball));
        fallen.unwrap_or_else(|| balls.moving_at(ball, T::lift(until)).position.map(slopes))
    };
    (0..balls.count()).map(at).collect()
}
