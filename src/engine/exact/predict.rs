//! The next event of one ball: its phase end, its cushions, and the balls it is shown, each searched only up to the best so far.
//!
//! A time that is found depends on the flights of the balls of the event and on nothing else, to the bit: motion is taken from
//! the start of a flight (of the later of two flights), never from the time at which someone asks. So it does not matter when a
//! prediction is made, which other balls are looked at, or in which order; the first of several events is the first by
//! (time, [`What`]).

use super::encounter::Encounter;
use super::flight::{Flight, Phase};
use super::kinematics::Kinematics;
use super::queue::{Candidate, What};
use crate::math::Real;
use crate::math::first_root::{
    Approach, Contact, first_contact_by, first_crossing, straight_contact,
};
use crate::physics::Side;

/// Ulps of the best time so far by which a search goes on: rounding must not hide what is as early.
const BEYOND: f64 = 4.0;

/// A lookout for what is near: encounters closer than a given gap, noted by predictions of balls whose courses begin now.
#[derive(Debug)]
pub struct Watch<T> {
    reach: T,
    known: Option<Encounter>,
    found: Vec<Encounter>,
}

impl<T: Real> Watch<T> {
    /// Notes what is closer than `reach`, length, but for the encounter that is known.
    pub fn new(reach: T, known: Option<Encounter>) -> Self {
        Watch {
            reach,
            known,
            found: Vec::new(),
        }
    }

    /// The gap below which something is near, length.
    pub fn reach(&self) -> T {
        self.reach
    }

    /// True if nothing is near.
    #[inline]
    pub fn is_clear(&self) -> bool {
        self.found.is_empty()
    }

    /// What is near, in scene order.
    pub fn found(mut self) -> Vec<Encounter> {
        self.found.sort_unstable();
        self.found
    }

    /// Notes an encounter, unless it is the one that is known.
    #[cold]
    pub(super) fn note(&mut self, near: Encounter) {
        if self.known != Some(near) {
            self.found.push(near);
        }
    }
}

/// Whose next event is asked for, and on which course.
#[derive(Clone, Copy, Debug)]
pub struct Row<'a, T: Real> {
    pub(super) balls: &'a Kinematics<'a, T>,
    pub(super) ball: usize,
    pub(super) flight: &'a Flight<T>,
    /// The other ball of the impact at hand; the ball itself where there is none.
    pub(super) mate: usize,
    /// The flight on which that one sets off as well; `None` if it is left out: the encounter of the two belongs to its own row.
    pub(super) ahead: Option<&'a Flight<T>>,
    /// The cushion that is left out.
    pub(super) except: Option<Side>,
}

impl<'a, T: Real> Row<'a, T> {
    /// The row of a ball that goes on as it does.
    #[inline]
    pub fn of(balls: &'a Kinematics<'a, T>, ball: usize) -> Self {
        Row::setting_off(balls, ball, balls.flight(ball))
    }

    /// The row of a ball that would set off now on `flight`.
    #[inline]
    pub fn setting_off(balls: &'a Kinematics<'a, T>, ball: usize, flight: &'a Flight<T>) -> Self {
        Row {
            balls,
            ball,
            flight,
            mate: ball,
            ahead: None,
            except: None,
        }
    }

    /// The same row with another ball that sets off at the same time.
    #[inline]
    pub fn with(self, mate: usize, flight: &'a Flight<T>) -> Self {
        Row {
            mate,
            ahead: Some(flight),
            ..self
        }
    }

    /// The same row but for what happens with another ball.
    #[inline]
    pub fn without_ball(self, mate: usize) -> Self {
        Row {
            mate,
            ahead: None,
            ..self
        }
    }

    /// The same row but for an encounter.
    pub fn without(self, encounter: Encounter) -> Self {
        match encounter {
            Encounter::Pair(a, b) if a == self.ball => self.without_ball(b),
            Encounter::Pair(a, b) if b == self.ball => self.without_ball(a),
            Encounter::Cushion(a, side) if a == self.ball => Row {
                except: Some(side),
                ..self
            },
            Encounter::Pair(..) | Encounter::Cushion(..) => self,
        }
    }

    /// All balls.
    #[inline]
    pub fn balls(&self) -> &'a Kinematics<'a, T> {
        self.balls
    }

    /// Whose row it is.
    #[inline]
    pub fn ball(&self) -> usize {
        self.ball
    }

    /// The course that the ball is on.
    #[inline]
    pub fn flight(&self) -> &'a Flight<T> {
        self.flight
    }

    /// The next event among its own and those with `partners`. Nothing beyond the duration, and nothing before now.
    pub fn next_event(
        &self,
        partners: impl IntoIterator<Item = usize>,
        watch: Option<&mut Watch<T>>,
        searches: &mut u64,
    ) -> Candidate<T> {
        let mut best = self.end();
        self.among(partners, &mut best, watch, searches);
        best.time = best.time.at_least(self.balls.now());
        best
    }

    /// The end of the phase; `Nothing` at the end of the run if that comes first.
    #[inline]
    pub fn end(&self) -> Candidate<T> {
        let duration = self.balls.world().duration;
        if self.flight.end <= duration {
            Candidate {
                time: self.flight.end,
                what: What::End(self.ball as u32),
                stamp: 0,
            }
        } else {
            Candidate {
                time: duration,
                ..Candidate::none()
            }
        }
    }

    /// Replaces `best` by an event with a cushion, a pocket or one of `partners` that precedes it. `searches`: root searches so far.
    #[inline]
    pub fn among(
        &self,
        partners: impl IntoIterator<Item = usize>,
        best: &mut Candidate<T>,
        mut watch: Option<&mut Watch<T>>,
        searches: &mut u64,
    ) {
        let world = self.balls.world();
        if !self.balls.is_quiet() {
            return self.among_contacts(partners, best, watch, searches);
        }
        if self.flight.moves() {
            self.cushions(best, watch.as_deref_mut(), searches);
            if !world.pockets.is_empty() {
                self.pockets(best, searches);
            }
        }
        if world.contact.is_some() {
            self.partners(partners, best, watch, searches);
        }
        if best.what == What::Nothing {
            *best = Candidate::none();
        }
    }

    pub(super) fn cushions(
        &self,
        best: &mut Candidate<T>,
        mut watch: Option<&mut Watch<T>>,
        searches: &mut u64,
    ) {
        let world = self.balls.world();
        let Some([x0, x1, y0, y1]) = world.within_all_reach else {
            return;
        };
        let (ball, flight) = (self.ball, self.flight);
        let blur = &world.blur;
        // mostly no cushion is within what is left of the way to the best so far
        let way = flight.fastest * (later(best.time) - flight.start) + blur.length * T::lift(4.0);
        let way = watch
            .as_deref()
            .map_or(way, |watch| way.at_least(watch.reach));
        let [x, y] = flight.position;
        if x - x0 > way && x1 - x > way && y - y0 > way && y1 - y > way {
            return;
        }
        let Some(reach) = world.reach.get(ball) else {
            return;
        };
        for side in Side::ALL {
            let axis = side.axis();
            let outward = |x: T| if side.sign() < 0 { -x } else { x };
            let gap = outward(reach[side as usize] - flight.position[axis]);
            if let Some(watch) = watch.as_deref_mut()
                && gap <= watch.reach
            {
                watch.note(Encounter::Cushion(ball, side));
            }
            let speed = outward(flight.velocity[axis]);
            let acceleration = outward(flight.acceleration[axis]);
            if (speed <= T::zero() && acceleration <= T::zero()) || self.except == Some(side) {
                continue;
            }
            *searches += 1;
            let limit = later(best.time) - flight.start;
            let found = first_crossing(gap, speed, acceleration, limit, blur);
            // x before y in a corner; a cushion before the end of a phase
            best.or(flight.start, 0, found, || {
                (
                    What::Cushion(ball as u32, side),
                    What::UnclearCushion(ball as u32, side),
                )
            });
        }
    }

    #[cold]
    pub(super) fn pockets(&self, best: &mut Candidate<T>, searches: &mut u64) {
        let (world, flight) = (self.balls.world(), self.flight);
        for (pocket, [x, y, radius]) in world.pockets.iter().enumerate() {
            let approach = Approach {
                p: [*x - flight.position[0], *y - flight.position[1]],
                v: flight.velocity.map(|v| -v),
                a: flight.acceleration.map(|a| -a),
                distance: *radius,
            };
            let limit = later(best.time) - flight.start;
            *searches += 1;
            let end = flight.end - flight.start;
            let found = first_contact_by(&approach, end, limit, &world.blur);
            best.or(flight.start, 0, found, || {
                let (ball, pocket) = (self.ball as u32, pocket as u32);
                (
                    What::Pocket(ball, pocket),
                    What::UnclearPocket(ball, pocket),
                )
            });
        }
    }

    pub(super) fn partners(
        &self,
        partners: impl IntoIterator<Item = usize>,
        best: &mut Candidate<T>,
        mut watch: Option<&mut Watch<T>>,
        searches: &mut u64,
    ) {
        let (ball, flight, mate) = (self.ball, self.flight, self.mate);
        let (world, flights) = (self.balls.world(), self.balls.flights());
        let moves = flight.moves();
        for other in partners {
            let mut partner = &flights[other];
            if other == mate || other == ball {
                match self.ahead {
                    Some(ahead) if other != ball => partner = ahead,
                    _ => continue,
                }
            }
            let rests = !(moves || partner.moves());
            if rests && watch.is_none() {
                continue;
            }
            // when both had begun what they do now
            let since = flight.start.at_least(partner.start);
            let (position, velocity) = flight.from(since);
            let (place, motion) = partner.at(since);
            let p = [place[0] - position[0], place[1] - position[1]];
            let square = p[0] * p[0] + p[1] * p[1];
            let distance = world.distance(ball, other);
            if let Some(watch) = watch.as_deref_mut() {
                let near = distance + watch.reach;
                if square <= near * near {
                    watch.note(Encounter::Pair(ball, other));
                }
                if rests {
                    continue;
                }
            }
            *searches += 1;
            let limit = later(best.time).at_most(partner.end) - since;
            // too far apart for the time that is left
            let range = distance + world.blur.length + (flight.fastest + partner.fastest) * limit;
            if square > range * range {
                continue;
            }
            let v = [motion[0] - velocity[0], motion[1] - velocity[1]];
            let found = self.contact(partner, since, [p, v], distance, limit);
            best.or(since, self.stamp(other), found, || {
                let (first, second) = (ball.min(other) as u32, ball.max(other) as u32);
                (What::Pair(first, second), What::UnclearPair(first, second))
            });
        }
    }

    /// When it first touches a partner that is at `p` from it and moves with `v` at the time `since`, s after that.
    #[inline(always)]
    fn contact(
        &self,
        partner: &Flight<T>,
        since: T,
        [p, v]: [[T; 2]; 2],
        distance: T,
        limit: T,
    ) -> Contact<T> {
        let flight = self.flight;
        let blur = &self.balls.world().blur;
        let curved = flight.phase == Phase::Curve || partner.phase == Phase::Curve;
        if !partner.moves() && !curved {
            straight_contact(p, v, flight.end - since, distance, limit, blur)
        } else if !curved && (!flight.moves() || partner.phase == Phase::Free) {
            straight_contact(p, v, partner.end - since, distance, limit, blur)
        } else {
            let a = [
                partner.acceleration[0] - flight.acceleration[0],
                partner.acceleration[1] - flight.acceleration[1],
            ];
            let approach = Approach { p, v, a, distance };
            let end = flight.end.at_most(partner.end) - since;
            first_contact_by(&approach, end, limit, blur)
        }
    }

    /// How often a partner will have changed its course when this row is known.
    #[inline]
    pub(super) fn stamp(&self, other: usize) -> u32 {
        match self.ahead {
            Some(_) if other == self.mate => self.balls.next_version(other),
            _ => self.balls.version(other),
        }
    }
}

/// A little later than `time`, by more than rounding.
#[inline]
pub(super) fn later<T: Real>(time: T) -> T {
    time + time * T::lift(BEYOND * T::ULP)
}

impl<T: Real> Candidate<T> {
    /// Takes over what was found, s after `since`, if it precedes; `named`: what it is if it is clear, and if it is not.
    #[inline]
    fn or(
        &mut self,
        since: T,
        stamp: u32,
        found: Contact<T>,
        named: impl FnOnce() -> (What, What),
    ) {
        let (after, what) = match found {
            Contact::Never => return,
            Contact::At(after) => (after, named().0),
            Contact::Unclear(after) => (after, named().1),
        };
        let one = Candidate {
            time: since + after,
            what,
            stamp,
        };
        if one.precedes(self) {
            *self = one;
        }
    }
}
