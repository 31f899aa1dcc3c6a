//! The next event of one ball: its phase end, its cushions, and every other ball, each searched only up to the best so far.

use super::flight::{Flight, Phase};
use super::queue::{Candidate, What};
use super::world::World;
use crate::math::Real;
use crate::math::first_root::{Approach, Contact, first_contact, first_crossing, straight_contact};
use crate::physics::Side;
use std::ops::Range;

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
    /// Gap below which a neighbour is noted, length; `None`: none is.
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
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Near {
    /// Two balls.
    Pair(usize, usize),
    /// A ball and a cushion.
    Cushion(usize, Side),
}

impl<T: Real> View<'_, T> {
    /// The next event of `ball` after `now`, all but the encounter `known`. Nothing beyond the duration.
    pub fn next_event(
        &self,
        ball: usize,
        now: T,
        partners: Range<usize>,
        known: Option<Near>,
        notes: &mut Notes<T>,
    ) -> Candidate<T> {
        let flight = &self.flights[ball];
        let mut best = Candidate::none();
        best.time = self.world.duration;
        if flight.moves() {
            if flight.end <= best.time {
                best.time = flight.end;
                best.what = What::End(ball as u32);
            }
            self.cushions(ball, now, known, &mut best, notes);
        }
        if self.world.contact.is_some() {
            self.balls(ball, now, partners, known, &mut best, notes);
        }
        if best.what == What::Nothing {
            Candidate::none()
        } else {
            best
        }
    }

    fn cushions(
        &self,
        ball: usize,
        now: T,
        known: Option<Near>,
        best: &mut Candidate<T>,
        notes: &mut Notes<T>,
    ) {
        let Some(reach) = self.world.reach.get(ball) else {
            return;
        };
        let flight = &self.flights[ball];
        let (position, velocity) = flight.at(now);
        for side in Side::ALL {
            let axis = side.axis();
            let outward = |x: T| if side.sign() < 0 { -x } else { x };
            let gap = outward(reach[side as usize] - position[axis]);
            if let Some(watch) = notes.watch
                && gap <= watch
            {
                notes.add(Near::Cushion(ball, side));
            }
            let speed = outward(velocity[axis]);
            let acceleration = outward(flight.acceleration[axis]);
            if (speed <= T::zero() && acceleration <= T::zero())
                || known == Some(Near::Cushion(ball, side))
            {
                continue;
            }
            notes.root_calls += 1;
            let blur = &self.world.blur;
            let found = first_crossing(gap, speed, acceleration, best.time - now, blur);
            let (after, what) = match found {
                Contact::Never => continue,
                Contact::At(after) => (after, What::Cushion(ball as u32, side)),
                Contact::Unclear(after) => (after, What::UnclearCushion(ball as u32, side)),
            };
            // x before y in a corner; a cushion before the end of a phase
            let time = now + after;
            if time < best.time || (time == best.time && what < best.what) {
                *best = Candidate {
                    time,
                    what,
                    stamp: 0,
                };
            }
        }
    }

    fn balls(
        &self,
        ball: usize,
        now: T,
        partners: Range<usize>,
        known: Option<Near>,
        best: &mut Candidate<T>,
        notes: &mut Notes<T>,
    ) {
        let world = self.world;
        let skip = match known {
            Some(Near::Pair(a, b)) if a == ball => b,
            Some(Near::Pair(a, b)) if b == ball => a,
            _ => usize::MAX,
        };
        let flight = &self.flights[ball];
        let moves = flight.moves();
        let (position, velocity) = flight.at(now);
        let still = [T::zero(); 2];
        for (other, partner) in self.flights[partners.clone()].iter().enumerate() {
            let other = other + partners.start;
            let partner_moves = partner.moves();
            let rests = !(moves || partner_moves);
            if (rests && notes.watch.is_none()) || other == ball || other == skip {
                continue;
            }
            let (place, motion) = if partner_moves {
                partner.at(now)
            } else {
                (partner.position, still)
            };
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
            let limit = best.time.at_most(partner.end) - now;
            // too far apart for the time that is left
            let range = distance + world.blur.length + (flight.fastest + partner.fastest) * limit;
            if square > range * range {
                continue;
            }
            let v = [motion[0] - velocity[0], motion[1] - velocity[1]];
            let found = if !partner_moves && flight.phase != Phase::Rest {
                straight_contact(p, v, flight.end - now, distance, limit, &world.blur)
            } else if !moves || partner.phase == Phase::Free {
                straight_contact(p, v, partner.end - now, distance, limit, &world.blur)
            } else {
                let a = [
                    partner.acceleration[0] - flight.acceleration[0],
                    partner.acceleration[1] - flight.acceleration[1],
                ];
                let approach = Approach { p, v, a, distance };
                first_contact(&approach, limit, &world.blur)
            };
            let (first, second) = (ball.min(other) as u32, ball.max(other) as u32);
            let (after, what) = match found {
                Contact::Never => continue,
                Contact::At(after) => (after, What::Pair(first, second)),
                Contact::Unclear(after) => (after, What::UnclearPair(first, second)),
            };
            let time = now + after;
            if time < best.time || (time == best.time && what < best.what) {
                *best = Candidate {
                    time,
                    what,
                    stamp: self.versions[other],
                };
            }
        }
    }
}
