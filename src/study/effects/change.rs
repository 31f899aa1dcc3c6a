//! What two runs of one shot with different effects differ in.

use crate::compare::{Comparison, common_end, stop_times};
use crate::physics::State;
use crate::scene::Scene;
use crate::trace::{EventKind, Path, Trace};

/// A number and the ball that owns it.
#[derive(Clone, Debug, PartialEq)]
pub struct Owned {
    /// The number.
    pub value: f64,
    /// Id of the ball.
    pub ball: String,
}

/// How a run with other effects differs from the reference.
#[derive(Clone, Debug, PartialEq)]
pub struct Change {
    /// Change of where each ball ends, R. A ball that fell counts where it left play; one that fell into the same pocket in both is
    /// 0 away.
    pub distances: Vec<Owned>,
    /// Largest change of when a ball stops, s, over those that stop in both.
    pub stop: Option<Owned>,
    /// Collisions that agree from the start, and those of the reference.
    pub order: (usize, usize),
    /// Balls that fall in only one of the two, or into different pockets: what changes, in words.
    pub falls: Vec<String>,
}

impl Change {
    /// The change from `reference` to `trace`, both complete. `scene` gives the unit R.
    pub fn between(scene: &Scene, trace: &Trace, reference: &Trace) -> Change {
        let comparison = Comparison::new(scene, trace, reference);
        let stops = stop_times(&comparison).into_iter();
        Change {
            distances: distances(scene, trace, reference),
            stop: largest(stops.filter_map(|m| {
                Some(Owned {
                    value: m.value?,
                    ball: m.subject,
                })
            })),
            order: (
                comparison.order.strict,
                comparison.order.reference_collisions,
            ),
            falls: falls(trace, reference),
        }
    }

    /// The largest change of where a ball ends, R.
    pub fn position(&self) -> Option<Owned> {
        largest(self.distances.iter().cloned())
    }

    /// The same as a number; 0 where no ball has one.
    pub fn moved(&self) -> f64 {
        self.position().map_or(0.0, |owned| owned.value)
    }

    /// Change of where one ball ends, R.
    pub fn of_ball(&self, id: &str) -> Option<f64> {
        let mut own = self.distances.iter().filter(|owned| owned.ball == id);
        own.next().map(|owned| owned.value)
    }
}

/// The largest of some numbers with their owners; one that is not a number is the largest of all.
fn largest(values: impl Iterator<Item = Owned>) -> Option<Owned> {
    values.reduce(|most, next| {
        let raises = next.value > most.value || (next.value.is_nan() && !most.value.is_nan());
        if raises { next } else { most }
    })
}

/// Distance of the places where each ball ends, R.
fn distances(scene: &Scene, a: &Trace, b: &Trace) -> Vec<Owned> {
    let end = common_end(a, b);
    let known = (0..a.balls.len()).filter(|i| b.balls.get(*i) == Some(&a.balls[*i]));
    let distance = |i: usize| {
        let (p, q) = (a.paths[i].state_at(end)?, b.paths[i].state_at(end)?);
        let together = pocket_of(a, i).is_some() && pocket_of(a, i) == pocket_of(b, i);
        let apart = if together {
            0.0
        } else {
            (p.position - q.position).norm() / scene.smallest_radius()
        };
        Some(Owned {
            value: apart,
            ball: a.balls[i].clone(),
        })
    };
    known.filter_map(distance).collect()
}

/// The pocket into which a ball fell.
pub fn pocket_of(trace: &Trace, ball: usize) -> Option<u32> {
    trace.events.iter().find_map(|event| match event.kind {
        EventKind::Pocket(fallen, pocket) if fallen as usize == ball => Some(pocket),
        _ => None,
    })
}

/// The balls that fell, with their pockets: `14 p5, 10 p3`, in the order in which they fell.
pub fn fallen(trace: &Trace) -> String {
    let fell = trace.events.iter().filter_map(|event| match event.kind {
        EventKind::Pocket(ball, pocket) => {
            Some(format!("{} p{pocket}", trace.balls.get(ball as usize)?))
        }
        _ => None,
    });
    fell.collect::<Vec<_>>().join(", ")
}

/// What changes of who falls where, from the reference to the trace.
fn falls(trace: &Trace, reference: &Trace) -> Vec<String> {
    let balls = trace.balls.iter().enumerate();
    let change = |(i, id): (usize, &String)| match (pocket_of(trace, i), pocket_of(reference, i)) {
        (None, Some(pocket)) => Some(format!("ball {id} does not fall into p{pocket}")),
        (Some(pocket), None) => Some(format!("ball {id} falls into p{pocket}")),
        (Some(ours), Some(theirs)) if ours != theirs => {
            Some(format!("ball {id} falls into p{ours} instead of p{theirs}"))
        }
        _ => None,
    };
    balls.filter_map(change).collect()
}

/// Kinetic energy at time `t` of the balls in play, mass * length^2/s^2. `scene`: the one that was run.
pub fn energy_at(scene: &Scene, trace: &Trace, t: f64) -> f64 {
    let fell_before = |ball: usize| {
        trace.events.iter().any(|event| {
            matches!(event.kind, EventKind::Pocket(fallen, _) if fallen as usize == ball)
                && event.time <= t
        })
    };
    let state = |(ball, path): (usize, &Path)| {
        let state = path.state_at(t).unwrap_or(scene.balls[ball].state);
        if fell_before(ball) {
            State::at_rest(state.position)
        } else {
            state
        }
    };
    let states: Vec<_> = trace.paths.iter().enumerate().map(state).collect();
    scene.kinetic_energy(&states)
}
