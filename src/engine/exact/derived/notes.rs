//! The event loop's part in derivatives: how times move, and what an event takes or leaves.

use super::{Derived, LANES, PARTS, Task, slopes};
use crate::engine::exact::cluster_impact::{ClusterImpact, Met};
use crate::engine::exact::contact::group::{Member, Touch};
use crate::engine::exact::contact::touching::rate;
use crate::engine::exact::encounter::Encounter;
use crate::engine::exact::kinematics::Course;
use crate::engine::exact::queue::What;
use crate::engine::exact::solve::Loop;
use crate::engine::exact::spin::Moving;
use crate::math::Real;

/// A gap whose derivative is less than this part of those of its parties is that of a contact that holds: its rounding, and that of what came before.
const HOLDS: f64 = 1e-6;

impl<T: Real> Loop<'_, T> {
    /// The time of an event, s, with the derivatives that what happens gives it.
    pub(in crate::engine::exact) fn moved(&self, time: T, what: What) -> T {
        let at = time.detached();
        let encounter = match what {
            What::Pair(a, b) | What::UnclearPair(a, b) => Encounter::Pair(a as usize, b as usize),
            What::Cushion(a, side) | What::UnclearCushion(a, side) => {
                Encounter::Cushion(a as usize, side)
            }
            What::Pocket(a, pocket) => return self.moved_fall(at, a as usize, pocket as usize),
            What::End(a) => {
                let ball = a as usize;
                let held = self.balls.contacts().of(ball);
                let held = held.filter(|_| self.balls.is_held(ball));
                let end = held.map_or(self.balls.flight(ball).end, |held| {
                    held.start + held.arc.length
                });
                return time.following(end);
            }
            What::UnclearPocket(..) | What::Leaving(..) | What::Nothing => return at,
        };
        let (gap, rate) = self.balls.gap_at(encounter, at);
        step(at, gap, rate)
    }

    fn moved_fall(&self, at: T, ball: usize, pocket: usize) -> T {
        let [x, y, radius] = self.balls.world().pockets[pocket];
        let Moving {
            position, velocity, ..
        } = self.balls.moving_at(ball, at);
        let p = [x - position[0], y - position[1]];
        let apart = (p[0] * p[0] + p[1] * p[1]).sqrt();
        let rate = -(p[0] * velocity[0] + p[1] * velocity[1]) / apart;
        step(at, apart - radius, rate)
    }

    /// Whether nothing from `time` on is asked for.
    pub(in crate::engine::exact) fn is_past(&self, time: T) -> bool {
        let derived = self.derived.as_ref();
        derived.is_some_and(|derived| derived.is_past(time.to_f64()))
    }

    /// Looks at what an event has done.
    pub(in crate::engine::exact) fn note(&mut self) {
        if let Some(mut derived) = self.derived.take() {
            derived.note(&mut self.balls, self.journal.events() as usize);
            self.derived = Some(derived);
        }
    }

    /// A ball leaves play: where it does keeps its derivatives.
    pub(in crate::engine::exact) fn note_fall(&mut self, ball: usize) {
        let place = self.balls.place(ball).map(slopes);
        if let Some(derived) = &mut self.derived {
            derived.fallen[ball] = Some(place);
        }
    }

    /// What the law of an event may be off by, length/s.
    pub(in crate::engine::exact) fn note_error(&mut self, error: f64) {
        if let Some(Derived {
            task: Task::Errors(errors),
            ..
        }) = self.derived.as_deref_mut()
        {
            errors.of_law = errors.of_law.max(error);
        }
    }

    /// What is left of the approaches of balls that touch is taken out.
    pub(in crate::engine::exact) fn note_taken(
        &mut self,
        members: &[Member<T>],
        touches: &[Touch],
    ) {
        if let Some(Derived {
            task: Task::Errors(errors),
            ..
        }) = self.derived.as_deref_mut()
        {
            for touch in touches {
                let speed = rate(members, *touch).to_f64().abs();
                let balls = touch.members().map(|(m, _)| (members[m].ball, speed));
                errors.taken.extend(balls);
            }
        }
    }

    /// Contacts that are resolved at one instant: in which lanes a change of the input opens one of them.
    fn opening(&self, encounters: impl Iterator<Item = Encounter>) -> [bool; LANES] {
        let mut lanes = [false; LANES];
        let estimates = self.balls.world().estimates;
        for encounter in encounters.filter(|_| !estimates) {
            let (gap, _) = self.balls.gap_at(encounter, self.balls.now());
            let places = encounter.balls().flat_map(|ball| self.balls.place(ball));
            let places: Vec<T> = places.collect();
            for (lane, opens) in lanes.iter_mut().enumerate() {
                let each = places.iter().map(|x| x.partial(lane).abs());
                let size = each.fold(0.0_f64, f64::max);
                let moves = gap.partial(lane).abs();
                *opens |= moves.is_nan() || moves > HOLDS * size;
            }
        }
        lanes
    }

    /// Balls that an instant with several contacts concerns have no derivative by an input that opens one of them.
    pub(in crate::engine::exact) fn note_together(
        &self,
        members: &mut [Member<T>],
        touches: &[Touch],
    ) {
        let lanes = self.opening(touches.iter().map(|touch| touch.encounter(members)));
        for m in members {
            lose(&mut m.moving, &lanes);
        }
    }

    /// Something changes in a group whose stretch began at `start`, s. `at_once`: no time has passed since. If it began with another change, for another
    /// start the two would come one after the other, or the other way round.
    pub(in crate::engine::exact) fn note_turn(
        &mut self,
        members: &mut [Member<T>],
        start: T,
        at_once: bool,
    ) {
        let (now, estimates) = (self.balls.now(), self.balls.world().estimates);
        let Some(derived) = &mut self.derived else {
            return;
        };
        let began = start.to_f64();
        let turned = members.iter().any(|m| derived.turned[m.ball] == began);
        for m in members.iter() {
            derived.turned[m.ball] = now.to_f64();
        }
        if at_once && turned && !estimates {
            let time = start.common(now);
            let lanes = std::array::from_fn(|lane| time.partial(lane).is_nan());
            for m in members {
                lose(&mut m.moving, &lanes);
            }
        }
    }

    /// Balls of an instant that a convention resolves have no derivative by an input that opens one of its contacts.
    pub(in crate::engine::exact) fn note_cluster(&self, cluster: &mut ClusterImpact<T>) {
        let sides = &cluster.sides;
        let rows = cluster.rows.iter().map(|row| {
            let first = sides[row.first.member].ball;
            match &row.second {
                Met::Ball(second) => Encounter::Pair(first, sides[second.member].ball),
                Met::Cushion(side) => Encounter::Cushion(first, *side),
            }
        });
        let lanes = self.opening(rows);
        if !lanes.contains(&true) {
            return;
        }
        for side in &mut cluster.sides {
            let mut far = Moving {
                position: side.position,
                velocity: side.after,
                spin: side.spin_after,
            };
            lose(&mut far, &lanes);
            let course = self.balls.course(side.ball, far);
            side.course = Course {
                flight: side.course.flight.following(&course.flight),
                spin: side
                    .course
                    .spin
                    .zip(course.spin)
                    .map(|(own, other)| own.following(&other)),
            };
        }
    }
}

/// Takes the derivatives by these inputs from a motion.
fn lose<T: Real>(moving: &mut Moving<T>, lanes: &[bool; LANES]) {
    for (lane, _) in lanes.iter().enumerate().filter(|(_, lost)| **lost) {
        for part in 0..PARTS {
            let part = moving.part(part);
            *part = part.nudged(lane, f64::NAN);
        }
    }
}

/// The time at which a gap closes that is `gap` at time `at`, s, and falls at `rate`.
fn step<T: Real>(at: T, gap: T, rate: T) -> T {
    if rate < T::zero() {
        // by its derivatives alone
        at - T::zero().following(gap) / rate.detached()
    } else {
        at
    }
}
