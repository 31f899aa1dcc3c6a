//! What an impact does: both balls advanced to it, the law applied once, new flights, new predictions.
//!
//! This is the cold side of the loop: it runs once an event and is never inlined into the search for the next one.

use super::doubt::Outcome;
use super::flight::Flight;
use super::predict::Near;
use super::solve::{Loop, Turned};
use super::spin::Moving;
use crate::math::Real;
use crate::physics::{Body, Contact, Cushion, Friction, Motion, Side, contact, cushion};
use crate::trace::Ending;
use nalgebra::Vector3;

/// A velocity that an impact cancels down to this many ulps of what was cancelled is zero.
const CANCELLED: f64 = 8.0;

/// A ball on both sides of an impact.
#[derive(Clone, Copy)]
pub struct Party<T> {
    /// Index in scene order.
    pub ball: usize,
    /// What it did until now.
    pub flight: Flight<T>,
    /// Where it is.
    pub position: [T; 2],
    /// Velocity on the near side.
    pub before: [T; 2],
    /// Velocity on the far side.
    pub after: [T; 2],
}

impl<T: Real> Loop<'_, T> {
    fn body(&self, side: &Party<T>) -> Body<T> {
        Body {
            velocity: Vector3::new(side.before[0], side.before[1], T::zero()),
            spin: self.solver.spin_at(side.ball, self.now).into(),
            mass: self.solver.world.mass[side.ball],
            radius: self.solver.world.radius[side.ball],
        }
    }

    /// A ball as it is when an event reaches it.
    pub fn arrival(&self, ball: usize) -> Party<T> {
        let flight = self.solver.flights[ball];
        let (position, before) = flight.at(self.now);
        Party {
            ball,
            flight,
            position,
            before,
            after: before,
        }
    }

    /// Two balls meet.
    #[inline(never)]
    pub fn pair(&mut self, a: usize, b: usize) -> Option<Ending> {
        let law = self.solver.world.contact?;
        let (mut one, mut other) = (self.arrival(a), self.arrival(b));
        let x = other.position[0] - one.position[0];
        let y = other.position[1] - one.position[1];
        let apart = (x * x + y * y).sqrt();
        let n = Vector3::new(x / apart, y / apart, T::zero());
        let closing =
            (one.before[0] - other.before[0]) * n.x + (one.before[1] - other.before[1]) * n.y;
        if closing <= self.solver.world.blur.speed {
            return Some(Ending::Collapsed(self.spot(
                &[a, b],
                "they are pressed together without closing in: impacts follow each other without end",
            )));
        }
        let (first, second) = (self.body(&one), self.body(&other));
        if self.solver.spins.is_empty() {
            collide(law, None, &first, &second, &n, &mut one, &mut other);
        } else {
            self.collide_turning(law, &first, &second, &n, [&mut one, &mut other]);
        }
        if !finite(&one) || !finite(&other) {
            return Some(Ending::NotFinite(
                self.spot(&[a, b], "the impact left no finite velocity"),
            ));
        }
        if let Some(ending) = self.streak(&[a, b]) {
            return Some(ending);
        }
        let window = self.solver.world.time_error(self.now, closing) * T::lift(2.0);
        match self.commit(&[one, other], Near::Pair(a, b), window) {
            Outcome::Alone => {
                self.record_pair(&one, &other, apart);
                None
            }
            Outcome::InDoubt(doubt) => {
                self.indeterminate(doubt, |run| run.record_pair(&one, &other, apart))
            }
            Outcome::Together(ending) => ending,
        }
    }

    /// A ball meets a cushion.
    #[inline(never)]
    pub fn cushion(&mut self, a: usize, side: Side) -> Option<Ending> {
        let law = self.solver.world.cushion?;
        let mut one = self.arrival(a);
        let motion = bounce(law, &self.body(&one), side, &mut one);
        if !self.solver.spins.is_empty() {
            self.turned.clear();
            self.turn(a, &motion);
        }
        if !finite(&one) {
            return Some(Ending::NotFinite(
                self.spot(&[a], "the cushion left no finite velocity"),
            ));
        }
        if let Some(ending) = self.streak(&[a]) {
            return Some(ending);
        }
        let closing = one.before[side.axis()].abs();
        let window = self.solver.world.time_error(self.now, closing) * T::lift(2.0);
        match self.commit(&[one], Near::Cushion(a, side), window) {
            Outcome::Alone => {
                self.record_cushion(&one, side);
                None
            }
            Outcome::InDoubt(doubt) => {
                self.indeterminate(doubt, |run| run.record_cushion(&one, side))
            }
            Outcome::Together(ending) => ending,
        }
    }

    /// Puts the balls of an impact on their new flights and predicts their next events. Answers whether other impacts at
    /// this instant have a say in it.
    fn commit(&mut self, sides: &[Party<T>], known: Near, window: T) -> Outcome {
        let watch = self.solver.world.touching + self.solver.world.fastest * window;
        self.notes.watch = Some(watch);
        self.notes.near.clear();
        self.notes.known = Some(known);
        self.depart(sides);
        self.notes.watch = None;
        self.notes.known = None;
        if self.notes.near.is_empty() {
            return Outcome::Alone;
        }
        self.doubt(sides, window)
    }

    /// Puts balls on their flights after an impact and predicts their next events.
    pub fn depart(&mut self, sides: &[Party<T>]) {
        for side in sides {
            if !self.solver.spins.is_empty() {
                self.depart_turning(side);
                continue;
            }
            let flight = Flight::new(
                self.solver.world.ground,
                self.now,
                side.position,
                side.after,
            );
            self.moving += usize::from(flight.moves());
            self.moving -= usize::from(self.solver.flights[side.ball].moves());
            self.solver.flights[side.ball] = flight;
            self.versions[side.ball] = self.versions[side.ball].wrapping_add(1);
        }
        for (i, side) in sides.iter().enumerate() {
            // the pair itself belongs to the row of the first
            let except = (i > 0).then(|| Near::Pair(sides[0].ball, side.ball));
            self.predict(side.ball, except);
        }
    }

    #[cold]
    fn depart_turning(&mut self, side: &Party<T>) {
        let spin = self.spins_of(side.ball)[1];
        self.set_off(
            side.ball,
            Moving {
                position: side.position,
                velocity: side.after,
                spin,
            },
        );
    }

    /// Applies the law of an impact of two balls that turn, and keeps how they do.
    #[cold]
    fn collide_turning(
        &mut self,
        law: Contact<T>,
        a: &Body<T>,
        b: &Body<T>,
        n: &Vector3<T>,
        [one, other]: [&mut Party<T>; 2],
    ) {
        let (motion, reaction) = collide(law, self.solver.world.friction, a, b, n, one, other);
        self.turned.clear();
        self.turn(one.ball, &motion);
        self.turn(other.ball, &reaction);
    }

    /// Keeps how a ball of the impact at hand turns.
    #[cold]
    fn turn(&mut self, ball: usize, motion: &Motion<T>) {
        self.turned.push(Turned {
            ball,
            spin: self.solver.spins[ball],
            before: self.solver.spin_at(ball, self.now),
            after: motion.spin.into(),
        });
    }

    /// Angular velocity of a ball on both sides of the impact at hand.
    #[inline]
    pub fn spins_of(&self, ball: usize) -> [[T; 3]; 2] {
        if self.solver.spins.is_empty() {
            return [[T::zero(); 3]; 2];
        }
        match self.turned.iter().find(|turned| turned.ball == ball) {
            Some(turned) => [turned.before, turned.after],
            None => [self.solver.spin_at(ball, self.now); 2],
        }
    }

    /// Counts impacts of balls while no time passes; answers when there are too many to be finite.
    pub fn streak(&mut self, balls: &[usize]) -> Option<Ending> {
        let collapsed = self.streaks.count(balls, self.now)?;
        Some(Ending::Collapsed(self.spot(balls, &collapsed)))
    }
}

/// Applies the law of an impact of two balls.
#[inline(always)]
fn collide<T: Real>(
    law: Contact<T>,
    friction: Option<Friction<T>>,
    a: &Body<T>,
    b: &Body<T>,
    n: &Vector3<T>,
    one: &mut Party<T>,
    other: &mut Party<T>,
) -> (Motion<T>, Motion<T>) {
    let (motion, reaction) = contact::impact(law, friction, a, b, n);
    one.after = settled(one.before, &motion);
    other.after = settled(other.before, &reaction);
    (motion, reaction)
}

/// Applies the law of a cushion.
#[inline(never)]
fn bounce<T: Real>(law: Cushion<T>, a: &Body<T>, side: Side, one: &mut Party<T>) -> Motion<T> {
    let motion = cushion::impact(law, a, side).motion;
    one.after = settled(one.before, &motion);
    motion
}

/// The velocity after an impact; zero where nothing but the rounding of a cancellation is left.
///
/// Without this a head-on hit off the axes would leave the cue ball creeping at 1e-17 in a direction that is noise.
fn settled<T: Real>(before: [T; 2], motion: &Motion<T>) -> [T; 2] {
    let after = [motion.velocity.x, motion.velocity.y];
    let square = |v: [T; 2]| v[0] * v[0] + v[1] * v[1];
    let cancelled = square(before) + square([after[0] - before[0], after[1] - before[1]]);
    let rounding = T::lift(CANCELLED * T::ULP);
    if square(after) <= rounding * rounding * cancelled {
        [T::zero(); 2]
    } else {
        after
    }
}

pub fn finite<T: Real>(side: &Party<T>) -> bool {
    (side.after[0] + side.after[1] + side.position[0] + side.position[1]).is_finite()
}
