//! The event loop's part in accumulations: when impacts are left to their limit, and what comes between.

use super::contact::arc::{Arc, Series};
use super::contact::foreseen::{Foreseen, SLOW};
use super::contact::group::{Group, Hold, Member, Mode, Touch, Twist};
use super::contact::held::{Held, Next, Passage, Way};
use super::contact::tail;
use super::encounter::Encounter;
use super::flight::{Flight, Phase};
use super::impact::Impact;
use super::predict::Row;
use super::solve::Loop;
use super::spin::Moving;
use crate::math::Real;

/// An accumulation is left to its limit when an approach is this many times what rounding makes of one.
const NOISE: f64 = 100.0;

/// Two answers for one limit are the same if velocities differ by no more than this part of the approach.
const SAME: f64 = 1e-2;

/// The way to a limit is followed if what the approach does to it is this many errors of a position.
const RESOLVED: f64 = 64.0;

/// On the way to a limit no ball is faster or slower by more than this many approaches, and what the cloth does.
const NEAR: f64 = 32.0;

impl<T: Real> Loop<'_, T> {
    /// An impact that may be one of an accumulation: puts its balls on the way to the limit, if there is one and nothing else comes before it.
    #[cold]
    #[inline(never)]
    pub(super) fn accumulates<const N: usize>(&mut self, impact: &Impact<T, N>) -> bool {
        let (encounter, closing) = (impact.encounter, impact.closing);
        let states = impact.sides.each_ref().map(|side| Moving {
            position: side.position,
            velocity: side.before,
            spin: side.spin_before,
        });
        let now = self.balls.now();
        let Some(limit) = tail::limit(self.balls.world(), encounter, &states) else {
            return false;
        };
        let found = Foreseen {
            encounter,
            time: now + limit.after,
            states: limit.states,
        };
        // the first answer sees least of the rounding of gaps; it stands while the impacts go as it says
        let known = self.foreseen.iter().find(|known| {
            known.encounter == found.encounter
                && (known.time - found.time).abs() <= limit.after * T::lift(SLOW)
                && known.time > now
                && known.agrees(&found, closing * T::lift(SAME))
        });
        let chosen = known.cloned().unwrap_or(found);
        let others = |known: &Foreseen<T>| known.time > now && known.encounter != encounter;
        self.foreseen.retain(others);
        self.foreseen.push(chosen.clone());
        if !self.is_noise(closing) {
            return false;
        }
        let Some(passages) = self.way_to(&chosen, closing) else {
            return false;
        };
        self.go_to_limit(encounter, &passages, chosen.time, limit.impacts);
        true
    }

    /// Whether an approach is so slow that rounding will soon say how it goes on.
    fn is_noise(&self, closing: T) -> bool {
        let world = self.balls.world();
        let noise = (world.blur.length * world.strongest() * T::lift(2.0)).sqrt();
        closing <= noise * T::lift(NOISE)
    }

    /// The straight way of two parties to their limit, from an approach at `closing`, length/s; `None` if it is not near what they do, or
    /// something else comes before.
    fn way_to(&mut self, limit: &Foreseen<T>, closing: T) -> Option<Vec<Passage<T>>> {
        let (encounter, time) = (limit.encounter, limit.time);
        let after = time - self.balls.now();
        let world = self.balls.world();
        if after <= T::zero() || time > world.duration {
            return None;
        }
        // where the way is so short that its rounding tells, the balls are there at once
        let resolved = after * closing > world.blur.length * T::lift(RESOLVED);
        let most = closing * T::lift(NEAR) + world.strongest() * after * T::lift(2.0);
        let mut passages = Vec::new();
        for (ball, end) in encounter.balls().zip(&limit.states) {
            let start = self.balls.moving(ball);
            let two = T::lift(2.0);
            let way = [0, 1].map(|i| end.position[i] - start.position[i]);
            // through both ends with a constant acceleration
            let through = [0, 1].map(|i| way[i] / after * two - end.velocity[i]);
            let leaving = if resolved { through } else { end.velocity };
            let near = |v: [T; 2]| (0..2).all(|i| (v[i] - start.velocity[i]).abs() <= most);
            if !near(leaving) || !near(end.velocity) {
                return None;
            }
            let change = |from: T, to: T| {
                if resolved {
                    (to - from) / after
                } else {
                    T::zero()
                }
            };
            passages.push(Passage {
                ball,
                before: start,
                leaving: Moving {
                    velocity: leaving,
                    ..start
                },
                acceleration: [0, 1].map(|i| change(leaving[i], end.velocity[i])),
                rate: [0, 1, 2].map(|i| change(start.spin[i], end.spin[i])),
                end: *end,
            });
        }
        let comes = passages
            .iter()
            .any(|passage| self.comes_before(passage, encounter, time));
        (!comes).then_some(passages)
    }

    /// Whether an event of a ball on its way to a limit, besides its `encounter`, comes before `time`, s.
    fn comes_before(&mut self, passage: &Passage<T>, encounter: Encounter, time: T) -> bool {
        let Passage { ball, leaving, .. } = *passage;
        let size = |[x, y]: [T; 2]| (x * x + y * y).sqrt();
        let flight = Flight {
            start: self.balls.now(),
            end: T::lift(f64::INFINITY),
            position: leaving.position,
            velocity: leaving.velocity,
            acceleration: passage.acceleration,
            fastest: size(leaving.velocity).at_least(size(passage.end.velocity)),
            phase: Phase::Curve,
        };
        let row = Row::setting_off(&self.balls, ball, &flight);
        let row = row.without(encounter);
        self.agenda.foresee(&row, None).time <= time
    }

    /// Puts two parties on their way to a limit at `time`, s.
    fn go_to_limit(
        &mut self,
        encounter: Encounter,
        passages: &[Passage<T>],
        time: T,
        impacts: u32,
    ) {
        let now = self.balls.now();
        let after = time - now;
        self.journal
            .accumulation(&self.balls, encounter, passages, impacts);
        let hold = Hold {
            touch: match encounter {
                Encounter::Pair(..) => Touch::Pair(0, 1),
                Encounter::Cushion(_, side) => Touch::Cushion(0, side),
            },
            pressed: true,
        };
        let members = passages.iter().map(|p| Member {
            ball: p.ball,
            moving: p.leaving,
            mode: Mode::Floats,
            twist: Twist::Free,
        });
        let series = passages
            .iter()
            .map(|p| Series::straight(p.ball, &p.leaving, p.acceleration, p.rate, after));
        self.hold(Held {
            group: Group {
                holds: vec![hold],
                members: members.collect(),
            },
            arc: Arc {
                length: after,
                series: series.collect(),
                changes: Vec::new(),
            },
            start: now,
            next: Next::Limit(Way {
                encounter,
                before: passages.iter().map(|p| p.before).collect(),
                ends: passages.iter().map(|p| p.end).collect(),
            }),
            stuck: 0,
        });
    }

    /// Something comes between a ball and the limit that it is on its way to: its group is where its impacts have brought it by now.
    pub(super) fn interrupt(&mut self, ball: usize) {
        let on_the_way = |held: &Held<T>| matches!(held.next, Next::Limit(_));
        if !self.balls.contacts().of(ball).is_some_and(on_the_way) {
            return;
        }
        let Some(held) = self.balls.let_go(ball) else {
            return;
        };
        let Next::Limit(way) = &held.next else {
            return;
        };
        self.journal.stretch(&self.balls, &held);
        let after = self.balls.now() - held.start;
        let world = self.balls.world();
        let found = tail::until(world, way.encounter, &way.before, after);
        let along = held.group.members.iter();
        let states =
            found.unwrap_or_else(|| along.map(|m| self.balls.state_in(&held, m.ball)).collect());
        self.journal
            .passed(&self.balls, &held.group.members, &way.before, &states);
        let mut balls = Vec::new();
        for (m, moving) in held.group.members.iter().zip(states) {
            let course = self.balls.course(m.ball, moving);
            self.balls.set_off(m.ball, &course);
            balls.push(m.ball);
        }
        self.predict_all(&balls);
    }
}
