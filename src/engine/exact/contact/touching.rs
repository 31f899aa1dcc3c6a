//! Balls that touch: which do, and how fast their gaps change.

use super::decide::settle;
use super::group::{Group, Hold, Member, Mode, Touch};
use crate::engine::exact::agenda::Agenda;
use crate::engine::exact::encounter::{Encounter, rate_between, rate_to};
use crate::engine::exact::kinematics::Kinematics;
use crate::engine::exact::spin::Moving;
use crate::engine::exact::world::World;
use crate::math::Real;
use crate::physics::Side;

/// Parties that touch and approach or part by no more than this many roundings of the fastest ball do neither.
pub const STEADY: f64 = 64.0;

/// Rounds in which what is left of approach and parting is taken out of contacts that share balls.
const ROUNDS: usize = 200;

/// What is left of a gap or an approach is none at this part of the rounding of the farthest or the fastest ball.
const ULPS: f64 = 0.125;

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
    steady: &Steady<T>,
) -> Vec<Encounter> {
    let touches = |encounter: &Encounter| {
        balls.gap(*encounter) <= steady.near
            && balls.rate(*encounter).abs() <= steady.slow
            && !balls.is_parting(*encounter)
    };
    let mut found = Vec::new();
    if balls.world().contact.is_some() {
        let near = agenda.neighbours(balls, ball, steady.near).into_iter();
        let others = near.filter(|other| *other != ball);
        let pairs = others.map(|other| Encounter::Pair(ball.min(other), ball.max(other)));
        found.extend(pairs.filter(touches));
    }
    if balls.world().reach.get(ball).is_some() {
        let sides = Side::ALL.into_iter();
        let cushions = sides.map(|side| Encounter::Cushion(ball, side));
        found.extend(cushions.filter(touches));
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

/// Puts balls to contact and in step: no gap is open or closed, and none changes.
pub fn keep_contacts<T: Real>(world: &World<T>, members: &mut [Member<T>], touches: &[Touch]) {
    close_gaps(world, members, touches);
    calm(world, members, touches);
}

/// Takes out of balls what is left of approach and parting of contacts, by impulses along them to which each ball answers as what it does lets it: the
/// nearest velocities by kinetic energy, which it never raises.
pub fn calm<T: Real>(world: &World<T>, members: &mut [Member<T>], touches: &[Touch]) {
    let none = world.blur.speed * T::lift(ULPS);
    even_out(world, members, touches, none, rate, |moving| {
        &mut moving.velocity
    });
    for m in members {
        // what rolled or dragged by no more than that rests: nothing has a direction any more
        let stands = m.moving.velocity == [T::zero(); 2];
        if stands && matches!(m.mode, Mode::Rolls | Mode::Drags) {
            m.mode = Mode::Rests;
        }
        settle(world.radius[m.ball], m.mode, &mut m.moving);
    }
}

/// Moves balls so that contacts are at contact; those that rest where others do not stay.
pub fn close_gaps<T: Real>(world: &World<T>, members: &mut [Member<T>], touches: &[Touch]) {
    let none = world.blur.length * T::lift(ULPS);
    let gap = |members: &[Member<T>], touch: Touch| match touch {
        Touch::Pair(a, b) => {
            let [x, y] = between(members, a, b);
            (x * x + y * y).sqrt() - world.distance(members[a].ball, members[b].ball)
        }
        Touch::Cushion(a, side) => {
            let Member { ball, moving, .. } = &members[a];
            let beyond = world.reach[*ball][side as usize] - moving.position[side.axis()];
            if side.sign() < 0 { -beyond } else { beyond }
        }
    };
    even_out(world, members, touches, none, gap, |moving| {
        &mut moving.position
    });
}

/// Takes out what contacts are `off` by, one after the other, until no more than `none` is left: each party gives by its part of the mass that answers.
fn even_out<T: Real>(
    world: &World<T>,
    members: &mut [Member<T>],
    touches: &[Touch],
    none: T,
    off: impl Fn(&[Member<T>], Touch) -> T,
    part: impl Fn(&mut Moving<T>) -> &mut [T; 2],
) {
    let gives = |m: &Member<T>| {
        let part = match m.mode {
            Mode::Rests => T::zero(),
            Mode::Rolls => T::lift(5.0) / T::lift(7.0),
            Mode::Slides | Mode::Drags | Mode::Floats => T::one(),
        };
        part / world.mass[m.ball]
    };
    for _ in 0..ROUNDS {
        let mut most = T::zero();
        for touch in touches {
            let off = off(members, *touch);
            most = most.at_least(off.abs());
            let (first, second, n) = match *touch {
                Touch::Cushion(a, side) => {
                    let mut n = [T::zero(); 2];
                    n[side.axis()] = T::lift(f64::from(side.sign()));
                    (a, None, n)
                }
                Touch::Pair(a, b) => {
                    let p = between(members, a, b);
                    let size = (p[0] * p[0] + p[1] * p[1]).sqrt();
                    (a, Some(b), p.map(|p| p / size))
                }
            };
            let one = gives(&members[first]);
            let other = second.map_or(T::zero(), |b| gives(&members[b]));
            // where all rest, only places can be off
            let (one, other) = if one + other == T::zero() {
                let lightness = |m: usize| T::one() / world.mass[members[m].ball];
                (lightness(first), second.map_or(T::zero(), lightness))
            } else {
                (one, other)
            };
            let push = off / (one + other);
            for (k, n) in n.into_iter().enumerate() {
                part(&mut members[first].moving)[k] += n * push * one;
                if let Some(b) = second {
                    part(&mut members[b].moving)[k] -= n * push * other;
                }
            }
        }
        if most <= none {
            return;
        }
    }
}

/// From the centre of one member to that of another.
fn between<T: Real>(members: &[Member<T>], a: usize, b: usize) -> [T; 2] {
    let (one, other) = (members[a].moving.position, members[b].moving.position);
    [0, 1].map(|k| other[k] - one[k])
}
