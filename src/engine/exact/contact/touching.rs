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

/// What counts as touching without closing in.
#[derive(Clone, Copy, Debug)]
pub struct Steady<T> {
    /// A gap no larger than this, length.
    pub near: T,
    /// A gap that changes no faster than this, length/s.
    pub slow: T,
}

impl<T: Real> Steady<T> {
    /// As far as rounding tells.
    pub fn of(world: &World<T>) -> Self {
        Steady {
            near: world.touching,
            slow: world.blur.speed * T::lift(STEADY),
        }
    }
}

/// What is left of an approach is none at this part of the rounding of the fastest ball.
const ULPS: f64 = 0.125;

/// Balls that touch, taken out of their courses.
pub struct Gathered<T> {
    /// The balls.
    pub members: Vec<Member<T>>,
    /// Who touches whom, by place in `members`.
    pub touches: Vec<Touch>,
    /// The contacts that held until now.
    pub held: Vec<Encounter>,
}

/// What a contact that begins does to a ball.
#[derive(Clone, Copy, Debug)]
pub struct Touched<T> {
    /// Index in scene order.
    pub ball: usize,
    /// How it moved.
    pub before: Moving<T>,
    /// How it moves.
    pub after: Moving<T>,
    /// Whether its centre comes to rest.
    pub stops: bool,
}

impl<T: Real> Touched<T> {
    /// Whether it does anything.
    pub fn is_changed(&self) -> bool {
        let (before, after) = (&self.before, &self.after);
        self.stops || before.velocity != after.velocity || before.spin != after.spin
    }
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

/// The gap of two parties now, length; negative where they overlap.
pub fn gap<T: Real>(balls: &Kinematics<'_, T>, encounter: Encounter) -> T {
    let world = balls.world();
    match encounter {
        Encounter::Pair(a, b) => {
            let (p, q) = (balls.place(a), balls.place(b));
            let [x, y] = [0, 1].map(|i| q[i] - p[i]);
            (x * x + y * y).sqrt() - world.distance(a, b)
        }
        Encounter::Cushion(a, side) => {
            let beyond = world.reach[a][side as usize] - balls.place(a)[side.axis()];
            if side.sign() < 0 { -beyond } else { beyond }
        }
    }
}

/// What touches a ball now and neither approaches nor parts from it.
pub fn touching<T: Real>(
    balls: &Kinematics<'_, T>,
    agenda: &Agenda<T>,
    ball: usize,
    steady: &Steady<T>,
) -> Vec<Encounter> {
    let world = balls.world();
    let Steady { near: gap, slow } = *steady;
    let own = balls.moving(ball);
    let mut found = Vec::new();
    if world.contact.is_some() {
        for other in agenda.neighbours(balls, ball, gap) {
            if other == ball {
                continue;
            }
            let there = balls.moving(other);
            let p = [0, 1].map(|i| there.position[i] - own.position[i]);
            let apart = (p[0] * p[0] + p[1] * p[1]).sqrt();
            let rate = rate_between(&own, &there);
            let pair = Encounter::Pair(ball.min(other), ball.max(other));
            let near = apart <= world.distance(ball, other) + gap;
            if near && rate.abs() <= slow && !balls.is_parting(pair) {
                found.push(pair);
            }
        }
    }
    if let Some(reach) = world.reach.get(ball) {
        for side in Side::ALL {
            let apart = (reach[side as usize] - own.position[side.axis()]).abs();
            let encounter = Encounter::Cushion(ball, side);
            let near = apart <= gap && rate_to(&own, side).abs() <= slow;
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
    let holds = group.holds.iter();
    let named: Vec<Encounter> = holds.map(|h| h.touch.encounter(&group.members)).collect();
    let balls = group.members.iter().map(|m| m.ball);
    let mut placed: Vec<(usize, Moving<T>)> = balls.zip(states.iter().copied()).collect();
    close_gaps(world, &named, &mut placed);
    for (state, (_, placed)) in states.iter_mut().zip(placed) {
        *state = placed;
    }
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

/// Takes out of balls what is left of approach and parting of contacts, by impulses along them to which each ball answers as what it does lets it: the
/// nearest velocities by kinetic energy, which it never raises.
pub fn calm<T: Real>(world: &World<T>, members: &mut [Member<T>], touches: &[Touch]) {
    let answers = |m: &Member<T>| {
        let part = match m.mode {
            Mode::Rests => T::zero(),
            Mode::Rolls => T::lift(5.0) / T::lift(7.0),
            Mode::Slides | Mode::Drags | Mode::Floats => T::one(),
        };
        part / world.mass[m.ball]
    };
    for _ in 0..ROUNDS {
        let mut fastest = T::zero();
        for touch in touches {
            let rate = rate(members, *touch);
            fastest = fastest.at_least(rate.abs());
            let (first, second, n) = match *touch {
                Touch::Cushion(a, side) => {
                    let mut n = [T::zero(); 2];
                    // against the way in which the rate counts
                    n[side.axis()] = if side.sign() < 0 { -T::one() } else { T::one() };
                    (a, None, n)
                }
                Touch::Pair(a, b) => {
                    let (one, other) = (members[a].moving.position, members[b].moving.position);
                    let p = [0, 1].map(|k| other[k] - one[k]);
                    let size = (p[0] * p[0] + p[1] * p[1]).sqrt();
                    (a, Some(b), p.map(|p| p / size))
                }
            };
            let one = answers(&members[first]);
            let other = second.map_or(T::zero(), |b| answers(&members[b]));
            if one + other == T::zero() {
                continue;
            }
            let impulse = rate / (one + other);
            for (k, n) in n.into_iter().enumerate() {
                members[first].moving.velocity[k] += n * impulse * one;
                if let Some(b) = second {
                    members[b].moving.velocity[k] -= n * impulse * other;
                }
            }
        }
        if fastest <= world.blur.speed * T::lift(ULPS) {
            break;
        }
    }
    for m in members {
        settle(world.radius[m.ball], m.mode, &mut m.moving);
    }
}

/// Moves balls so that encounters are at contact; those that rest where others do not stay.
pub fn close_gaps<T: Real>(
    world: &World<T>,
    encounters: &[Encounter],
    states: &mut [(usize, Moving<T>)],
) {
    let two = T::lift(2.0);
    for _ in 0..ROUNDS {
        let mut farthest = T::zero();
        for encounter in encounters {
            let place = |ball: usize| states.iter().position(|(b, _)| *b == ball);
            match *encounter {
                Encounter::Cushion(a, side) => {
                    if let Some(a) = place(a) {
                        let (ball, state) = &mut states[a];
                        state.position[side.axis()] = world.reach[*ball][side as usize];
                    }
                }
                Encounter::Pair(a, b) => {
                    let (Some(i), Some(j)) = (place(a), place(b)) else {
                        continue;
                    };
                    let (one, other) = (states[i].1, states[j].1);
                    let rests = |m: &Moving<T>| m.velocity == [T::zero(); 2];
                    let share = match (rests(&one), rests(&other)) {
                        (true, false) => T::zero(),
                        (false, true) => T::one(),
                        _ => world.mass[b] / (world.mass[a] + world.mass[b]),
                    };
                    let p = [0, 1].map(|k| other.position[k] - one.position[k]);
                    let square = p[0] * p[0] + p[1] * p[1];
                    let distance = world.distance(a, b);
                    // the gap in parts of the distance, by a Newton step for its square
                    let gap = (square - distance * distance) / (square * two);
                    farthest = farthest.at_least(gap.abs());
                    for (k, p) in p.into_iter().enumerate() {
                        states[i].1.position[k] += p * gap * share;
                        states[j].1.position[k] -= p * gap * (T::one() - share);
                    }
                }
            }
        }
        if farthest <= T::lift(T::ULP) {
            return;
        }
    }
}
