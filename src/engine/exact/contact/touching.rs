//! Balls that touch: which do, and how fast their gaps change.

use super::decide::settle;
use super::group::{Group, Hold, Member, Mode, Touch};
use crate::engine::exact::agenda::Agenda;
use crate::engine::exact::encounter::Encounter;
use crate::engine::exact::kinematics::Kinematics;
use crate::engine::exact::spin::Moving;
use crate::engine::exact::world::World;
use crate::math::Real;
use crate::physics::Side;

/// Parties that touch and approach or part by no more than this many roundings of the fastest ball do neither.
pub const STEADY: f64 = 64.0;

/// Rounds in which what is left of approach and parting is taken out of contacts that share balls.
const ROUNDS: usize = 200;

/// Balls that touch, taken out of their courses.
pub struct Gathered<T> {
    /// The balls.
    pub members: Vec<Member<T>>,
    /// Who touches whom, by place in `members`.
    pub touches: Vec<Touch>,
    /// The contacts that held until now.
    pub held: Vec<Encounter>,
}

/// Rate of the gap of two balls, length/s.
pub fn rate_between<T: Real>(one: &Moving<T>, other: &Moving<T>) -> T {
    let p = [0, 1].map(|i| other.position[i] - one.position[i]);
    let v = [0, 1].map(|i| other.velocity[i] - one.velocity[i]);
    (p[0] * v[0] + p[1] * v[1]) / (p[0] * p[0] + p[1] * p[1]).sqrt()
}

/// Rate of the gap of a ball to a cushion, length/s.
pub fn rate_to<T: Real>(moving: &Moving<T>, side: Side) -> T {
    let v = moving.velocity[side.axis()];
    if side.sign() < 0 { v } else { -v }
}

/// Rate of the gap of two parties, length/s.
pub fn rate<T: Real>(members: &[Member<T>], touch: Touch) -> T {
    match touch {
        Touch::Pair(a, b) => rate_between(&members[a].moving, &members[b].moving),
        Touch::Cushion(a, side) => rate_to(&members[a].moving, side),
    }
}

/// What touches a ball now and neither approaches nor parts from it.
pub fn touching<T: Real>(
    balls: &Kinematics<'_, T>,
    agenda: &Agenda<T>,
    ball: usize,
) -> Vec<Encounter> {
    let world = balls.world();
    let slow = world.blur.speed * T::lift(STEADY);
    let own = balls.moving(ball);
    let mut found = Vec::new();
    if world.contact.is_some() {
        for other in agenda.neighbours(balls, ball, world.touching) {
            if other == ball {
                continue;
            }
            let there = balls.moving(other);
            let p = [0, 1].map(|i| there.position[i] - own.position[i]);
            let apart = (p[0] * p[0] + p[1] * p[1]).sqrt();
            let rate = rate_between(&own, &there);
            let pair = Encounter::Pair(ball.min(other), ball.max(other));
            let near = apart <= world.distance(ball, other) + world.touching;
            if near && rate.abs() <= slow && !balls.is_parting(pair) {
                found.push(pair);
            }
        }
    }
    if let Some(reach) = world.reach.get(ball) {
        for side in Side::ALL {
            let gap = (reach[side as usize] - own.position[side.axis()]).abs();
            let encounter = Encounter::Cushion(ball, side);
            let near = gap <= world.touching && rate_to(&own, side).abs() <= slow;
            if near && !balls.is_parting(encounter) {
                found.push(encounter);
            }
        }
    }
    found
}

/// Groups of members that contacts connect.
pub fn components<T: Real>(whole: &Group<T>) -> Vec<Group<T>> {
    let n = whole.members.len();
    let mut of: Vec<usize> = (0..n).collect();
    for hold in &whole.holds {
        if let Touch::Pair(a, b) = hold.touch {
            let (to, from) = (of[a].min(of[b]), of[a].max(of[b]));
            for label in &mut of {
                if *label == from {
                    *label = to;
                }
            }
        }
    }
    let mut groups = Vec::new();
    for label in 0..n {
        let own: Vec<usize> = (0..n).filter(|i| of[*i] == label).collect();
        if own.is_empty() {
            continue;
        }
        let place = |i: usize| own.iter().position(|o| *o == i);
        let holds = whole.holds.iter().filter_map(|hold| {
            let touch = match hold.touch {
                Touch::Pair(a, b) => Touch::Pair(place(a)?, place(b)?),
                Touch::Cushion(a, side) => Touch::Cushion(place(a)?, side),
            };
            Some(Hold { touch, ..*hold })
        });
        groups.push(Group {
            holds: holds.collect(),
            members: own.iter().map(|i| whole.members[*i]).collect(),
        });
    }
    groups
}

/// Takes the rounding of a stretch out of the gaps of a group: no gap opens or closes, and none has changed.
pub fn keep_contacts<T: Real>(world: &World<T>, group: &Group<T>, states: &mut [Moving<T>]) {
    for hold in &group.holds {
        match hold.touch {
            Touch::Cushion(a, side) => states[a].velocity[side.axis()] = T::zero(),
            Touch::Pair(a, b) => {
                let (ma, mb) = (
                    world.mass[group.members[a].ball],
                    world.mass[group.members[b].ball],
                );
                let rests = |i: usize| group.members[i].mode == Mode::Rests;
                // a ball at rest takes no part in it
                let share = match (rests(a), rests(b)) {
                    (false, false) => mb / (ma + mb),
                    (true, false) => T::zero(),
                    _ => T::one(),
                };
                let (one, other) = (states[a], states[b]);
                let p = [0, 1].map(|i| other.position[i] - one.position[i]);
                let v = [0, 1].map(|i| other.velocity[i] - one.velocity[i]);
                let square = p[0] * p[0] + p[1] * p[1];
                let along = (p[0] * v[0] + p[1] * v[1]) / square;
                for (i, p) in p.into_iter().enumerate() {
                    states[a].velocity[i] += p * along * share;
                    states[b].velocity[i] -= p * along * (T::one() - share);
                }
            }
        }
    }
    for (m, state) in group.members.iter().zip(states) {
        settle(world.radius[m.ball], m.mode, state);
    }
}

/// Takes out of states what is left of approach and parting of encounters.
pub fn calm<T: Real>(
    world: &World<T>,
    encounters: &[Encounter],
    states: &mut [(usize, Moving<T>)],
) {
    for _ in 0..ROUNDS {
        for encounter in encounters {
            let place = |ball: usize| states.iter().position(|(b, _)| *b == ball);
            match *encounter {
                Encounter::Cushion(a, side) => {
                    if let Some(a) = place(a) {
                        states[a].1.velocity[side.axis()] = T::zero();
                    }
                }
                Encounter::Pair(a, b) => {
                    let (Some(i), Some(j)) = (place(a), place(b)) else {
                        continue;
                    };
                    let share = world.mass[b] / (world.mass[a] + world.mass[b]);
                    let (one, other) = (states[i].1, states[j].1);
                    let p = [0, 1].map(|k| other.position[k] - one.position[k]);
                    let v = [0, 1].map(|k| other.velocity[k] - one.velocity[k]);
                    let square = p[0] * p[0] + p[1] * p[1];
                    let along = (p[0] * v[0] + p[1] * v[1]) / square;
                    for (k, p) in p.into_iter().enumerate() {
                        states[i].1.velocity[k] += p * along * share;
                        states[j].1.velocity[k] -= p * along * (T::one() - share);
                    }
                }
            }
        }
    }
}
