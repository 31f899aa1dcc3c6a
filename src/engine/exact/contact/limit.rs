//! The limit of impacts that shrink, from one of them that is small: what all that are left do together.
//!
//! The approaches `d` of one encounter fall in the ratio `rho`, so the impulses that are left add up to `J = (1 + e) d m / (1 - rho)`, m the mass that
//! answers to one of them. They take a time in proportion to `d` in which the contact would press anyway. What pressing for that time leaves out
//! is of first order in `d`: the impulse that takes out the approach, with what it rubs; and that a ball that rolls does not lose speed by rolling in
//! the slides that impacts leave, `2 u / (7 mu_s g)` for a slip u of each. What is left is of second order.

use super::decide::resettle;
use super::equations::Kick;
use super::group::{Group, Hold, Member, Mode, Touch, Twist};
use super::touching::{SINGULAR, calm, rate};
use crate::engine::exact::encounter::Encounter;
use crate::engine::exact::world::World;
use crate::math::Real;
use crate::math::linear::Factors;

/// Approaches that fall more slowly are none that go to a limit.
const SLOWEST: f64 = 0.95;

/// A ball that is no faster than this many approaches has no direction in which it rolls on.
const CREEPS: f64 = 64.0;

/// The last approach of each encounter.
#[derive(Clone, Debug)]
pub struct Approaches<T> {
    known: Vec<(Encounter, T)>,
}

impl<T: Real> Approaches<T> {
    /// None yet.
    pub fn new() -> Self {
        Approaches { known: Vec::new() }
    }

    /// Writes down an approach, length/s.
    pub fn note(&mut self, encounter: Encounter, closing: T) {
        match self.known.iter_mut().find(|(known, _)| *known == encounter) {
            Some((_, last)) => *last = closing,
            None => self.known.push((encounter, closing)),
        }
    }

    /// An approach by the one before it.
    pub fn ratio(&self, encounter: Encounter, closing: T) -> Option<T> {
        let known = self.known.iter().find(|(known, _)| *known == encounter)?;
        Some(closing / known.1)
    }
}

/// Takes what is left of the approach of contacts out of members that touch. `shrinks`: the ratio of the approach of the only contact to the one before.
pub fn take_out<T: Real>(
    world: &World<T>,
    members: &mut [Member<T>],
    touches: &[Touch],
    shrinks: Option<T>,
) {
    let group = Group {
        members: members.to_vec(),
        holds: touches.iter().map(|touch| Hold::open(*touch)).collect(),
    };
    let system = group.system(world);
    if let ([touch], Some(ratio)) = (touches, shrinks)
        && let Some(each) = impulse(world, &group, *touch)
        && ratio > T::zero()
        && ratio < T::lift(SLOWEST)
    {
        let closing = -rate(members, *touch);
        let whole = each * closing / (T::one() - ratio);
        for kick in &system.kicks[0] {
            let slip = size(kick.slip) * whole;
            roll_on(world, &mut members[kick.member], slip, closing);
        }
    }
    let entries = system.moving.iter().flatten();
    let largest = entries.fold(T::zero(), |most, x| most.at_least(x.abs()));
    let mut impulses: Vec<T> = touches.iter().map(|t| -rate(members, *t)).collect();
    let factors = Factors::of(system.moving, largest * T::lift(SINGULAR));
    if let Some(factors) = factors {
        factors.solve(&mut impulses);
        // one that pulls does not rub
        if impulses.iter().all(|size| *size >= T::zero()) {
            for kicks in system.kicks.iter().zip(&impulses) {
                apply(members, kicks);
            }
        }
    }
    calm(world, members, touches);
}

/// The sum of two impulses, the one that closes and the one that parts, for each unit of the approach; `None` where the law has no restitution.
fn impulse<T: Real>(world: &World<T>, group: &Group<T>, touch: Touch) -> Option<T> {
    let lightness = touch.members().map(|(m, _)| {
        let ball = group.members[m].ball;
        T::one() / world.mass[ball]
    });
    let restitution = match touch {
        Touch::Pair(..) => world.restitution(),
        Touch::Cushion(..) => world.restitution_of_cushions()?,
    };
    Some((T::one() + restitution) / lightness.fold(T::zero(), |sum, x| sum + x))
}

/// Gives back to a ball that rolls what rolling does not take while it slips, `slip` in all, length/s.
fn roll_on<T: Real>(world: &World<T>, m: &mut Member<T>, slip: T, closing: T) {
    let Some(rotation) = world.rotation.filter(|_| m.mode == Mode::Rolls) else {
        return;
    };
    let speed = size(m.moving.velocity);
    if speed > closing * T::lift(CREEPS) {
        let slides = slip * T::lift(2.0) / (rotation.slide * T::lift(7.0));
        let more = T::one() + rotation.roll * slides / speed;
        m.moving.velocity = m.moving.velocity.map(|v| v * more);
        resettle(world, m, T::zero());
    }
}

/// Lets an impulse of this size do what it does to its members.
fn apply<T: Real>(members: &mut [Member<T>], (kicks, impulse): (&Vec<Kick<T>>, &T)) {
    for kick in kicks {
        let m = &mut members[kick.member];
        for k in 0..2 {
            m.moving.velocity[k] += kick.velocity[k] * *impulse;
            if matches!(m.mode, Mode::Slides | Mode::Floats) {
                m.moving.spin[k] += kick.spin[k] * *impulse;
            }
        }
        if m.twist != Twist::Held {
            m.moving.spin[2] += kick.spin[2] * *impulse;
        }
    }
}

fn size<T: Real>([x, y]: [T; 2]) -> T {
    (x * x + y * y).sqrt()
}
