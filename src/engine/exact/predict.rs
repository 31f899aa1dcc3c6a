//! The next event of one ball: its phase end, its cushions, and the balls it is shown, each searched only up to the best so far.
//!
//! A time that is found depends on the flights of the balls of the event and on nothing else, to the bit: motion is taken from
//! the start of a flight (of the later of two flights), never from the time at which someone asks. So it does not matter when a
//! prediction is made, which other balls are looked at, or in which order; the first of several events is the first by
//! (time, [`What`]).

use super::flight::{Flight, Phase};
use super::queue::{Candidate, What};
use super::world::World;
use crate::math::Real;
use crate::math::first_root::{
    Approach, Contact, first_contact_by, first_crossing, straight_contact,
};
use crate::physics::Side;

/// Ulps of the best time so far by which a search goes on: rounding must not hide what is as early.
const BEYOND: f64 = 4.0;

/// What a prediction reads.
pub struct View<'a, T> {
    /// The unchanging part.
    pub world: &'a World<T>,
    /// All flights.
    pub flights: &'a [Flight<T>],
    /// Changes of every ball so far.
    pub versions: &'a [u32],
}

/// What a prediction writes besides its answer.
#[derive(Clone, Debug, Default)]
pub struct Notes<T> {
    /// Root searches so far.
    pub root_calls: u64,
    /// Gap below which a neighbour is noted, length; `None`: none is. Only for a ball whose flight begins now.
    pub watch: Option<T>,
    /// The partner that is not noted.
    pub known: Option<Near>,
    /// Neighbours closer than that.
    pub near: Vec<Near>,
}

impl<T> Notes<T> {
    #[cold]
    fn add(&mut self, near: Near) {
        if self.known != Some(near) {
            self.near.push(near);
        }
    }
}

/// A ball with something else in its reach.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Near {
    /// Two balls.
    Pair(usize, usize),
    /// A ball and a cushion.
    Cushion(usize, Side),
}

impl Near {
    /// The other ball of a pair with `ball` in it.
    fn partner_of(self, ball: usize) -> Option<usize> {
        match self {
            Near::Pair(a, b) if a == ball => Some(b),
            Near::Pair(a, b) if b == ball => Some(a),
            Near::Pair(..) | Near::Cushion(..) => None,
        }
    }
}

impl<T: Real> View<'_, T> {
    /// The next event of `ball` among its own and those with `partners`, but for the encounter `except`. Nothing beyond the
    /// duration, and nothing before `now`.
    pub fn next_event(
        &self,
        ball: usize,
        now: T,
        partners: impl IntoIterator<Item = usize>,
        except: Option<Near>,
        notes: &mut Notes<T>,
    ) -> Candidate<T> {
        let mut best = self.end(ball);
        self.among(ball, partners, except, &mut best, notes);
        best.time = best.time.at_least(now);
        best
    }

    /// The end of the phase of `ball`; `Nothing` at the end of the run if that comes first.
    #[inline]
    pub fn end(&self, ball: usize) -> Candidate<T> {
        let flight = &self.flights[ball];
        if flight.end <= self.world.duration {
            Candidate {
                time: flight.end,
                what: What::End(ball as u32),
                stamp: 0,
            }
        } else {
            Candidate {
                time: self.world.duration,
                ..Candidate::none()
            }
        }
    }

    /// Replaces `best` by an event of `ball` with a cushion or one of `partners` that precedes it.
    #[inline]
    pub fn among(
        &self,
        ball: usize,
        partners: impl IntoIterator<Item = usize>,
        except: Option<Near>,
        best: &mut Candidate<T>,
        notes: &mut Notes<T>,
    ) {
        if self.flights[ball].moves() {
            self.cushions(ball, except, best, notes);
            if !self.world.pockets.is_empty() {
                self.pockets(ball, best, notes);
            }
        }
        if self.world.contact.is_some() {
            self.balls(ball, partners, except, best, notes);
        }
        if best.what == What::Nothing {
            *best = Candidate::none();
        }
    }

    fn cushions(
        &self,
        ball: usize,
        except: Option<Near>,
        best: &mut Candidate<T>,
        notes: &mut Notes<T>,
    ) {
        let Some([x0, x1, y0, y1]) = self.world.within_all_reach else {
            return;
        };
        let flight = &self.flights[ball];
        let blur = &self.world.blur;
        // mostly no cushion is within what is left of the way to the best so far
        let way = flight.fastest * (later(best.time) - flight.start) + blur.length * T::lift(4.0);
        let way = notes.watch.map_or(way, |watch| way.at_least(watch));
        let [x, y] = flight.position;
        if x - x0 > way && x1 - x > way && y - y0 > way && y1 - y > way {
            return;
        }
        let Some(reach) = self.world.reach.get(ball) else {
            return;
        };
        for side in Side::ALL {
            let axis = side.axis();
            let outward = |x: T| if side.sign() < 0 { -x } else { x };
            let gap = outward(reach[side as usize] - flight.position[axis]);
            if let Some(watch) = notes.watch
                && gap <= watch
            {
                notes.add(Near::Cushion(ball, side));
            }
            let speed = outward(flight.velocity[axis]);
            let acceleration = outward(flight.acceleration[axis]);
            if (speed <= T::zero() && acceleration <= T::zero())
                || except == Some(Near::Cushion(ball, side))
            {
                continue;
            }
            notes.root_calls += 1;
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
    fn pockets(&self, ball: usize, best: &mut Candidate<T>, notes: &mut Notes<T>) {
        let flight = &self.flights[ball];
        for (pocket, [x, y, radius]) in self.world.pockets.iter().enumerate() {
            let approach = Approach {
                p: [*x - flight.position[0], *y - flight.position[1]],
                v: flight.velocity.map(|v| -v),
                a: flight.acceleration.map(|a| -a),
                distance: *radius,
            };
            let limit = later(best.time) - flight.start;
            notes.root_calls += 1;
            let end = flight.end - flight.start;
            let found = first_contact_by(&approach, end, limit, &self.world.blur);
            best.or(flight.start, 0, found, || {
                let (ball, pocket) = (ball as u32, pocket as u32);
                (
                    What::Pocket(ball, pocket),
                    What::UnclearPocket(ball, pocket),
                )
            });
        }
    }

    fn balls(
        &self,
        ball: usize,
        partners: impl IntoIterator<Item = usize>,
        except: Option<Near>,
        best: &mut Candidate<T>,
        notes: &mut Notes<T>,
    ) {
        let world = self.world;
        let skip = except.and_then(|near| near.partner_of(ball));
        let skip = skip.unwrap_or(ball);
        let flight = &self.flights[ball];
        let moves = flight.moves();
        for other in partners {
            let partner = &self.flights[other];
            let rests = !(moves || partner.moves());
            if (rests && notes.watch.is_none()) || other == ball || other == skip {
                continue;
            }
            // when both had begun what they do now
            let since = flight.start.at_least(partner.start);
            let (position, velocity) = flight.from(since);
            let (place, motion) = partner.at(since);
            let p = [place[0] - position[0], place[1] - position[1]];
            let square = p[0] * p[0] + p[1] * p[1];
            let distance = world.distance(ball, other);
            if let Some(watch) = notes.watch {
                let near = distance + watch;
                if square <= near * near {
                    notes.add(Near::Pair(ball, other));
                }
                if rests {
                    continue;
                }
            }
            notes.root_calls += 1;
            let limit = later(best.time).at_most(partner.end) - since;
            // too far apart for the time that is left
            let range = distance + world.blur.length + (flight.fastest + partner.fastest) * limit;
            if square > range * range {
                continue;
            }
            let v = [motion[0] - velocity[0], motion[1] - velocity[1]];
            let curved = flight.phase == Phase::Curve || partner.phase == Phase::Curve;
            let found = if !partner.moves() && !curved {
                straight_contact(p, v, flight.end - since, distance, limit, &world.blur)
            } else if !curved && (!moves || partner.phase == Phase::Free) {
                straight_contact(p, v, partner.end - since, distance, limit, &world.blur)
            } else {
                let a = [
                    partner.acceleration[0] - flight.acceleration[0],
                    partner.acceleration[1] - flight.acceleration[1],
                ];
                let approach = Approach { p, v, a, distance };
                let end = flight.end.at_most(partner.end) - since;
                first_contact_by(&approach, end, limit, &world.blur)
            };
            best.or(since, self.versions[other], found, || {
                let (first, second) = (ball.min(other) as u32, ball.max(other) as u32);
                (What::Pair(first, second), What::UnclearPair(first, second))
            });
        }
    }
}

/// A little later than `time`, by more than rounding.
#[inline]
fn later<T: Real>(time: T) -> T {
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
