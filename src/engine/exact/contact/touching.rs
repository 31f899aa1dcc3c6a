//! Balls that touch: which do, and how fast their gaps change.

use super::decide::resettle;
use super::group::{Group, Hold, Member, Mode, Touch, loudest};
use crate::engine::exact::agenda::Agenda;
use crate::engine::exact::encounter::{Encounter, rate_between, rate_to};
use crate::engine::exact::kinematics::Kinematics;
use crate::engine::exact::spin::Moving;
use crate::engine::exact::world::World;
use crate::math::Real;
use crate::math::linear::Factors;
use crate::physics::Side;

/// Parties that touch and approach or part by no more than this many roundings of their speeds do neither.
const STEADY: f64 = 64.0;

/// Rounds in which what is left of approach and parting is taken out of contacts that share balls.
const ROUNDS: usize = 200;

/// Rounds in which they are taken out all together, at most.
const NEWTON: usize = 8;

/// Contacts whose system has a pivot of no more than this part of its largest entry depend on each other.
const SINGULAR: f64 = 1e-9;

/// A gap that is closed moves no party by more than so many of the largest: between a cushion and a ball that rests a third could only get out of a gap that is rounding by
/// going far along both.
const FARTHEST: f64 = 64.0;

/// What is left of a gap or an approach is none at this part of the rounding of the farthest or the fastest ball.
const ULPS: f64 = 0.125;

/// What counts as touching without closing in.
#[derive(Clone, Copy, Debug)]
pub struct Steady<T> {
    /// A gap no larger than this, length.
    pub near: T,
    /// A gap that changes no faster than this, length/s.
    pub slow: T,
    /// Or by no more than this many roundings.
    pub roundings: f64,
}

impl<T: Real> Steady<T> {
    /// As far as rounding tells.
    pub fn of(world: &World<T>) -> Self {
        Steady {
            near: world.touching,
            slow: T::zero(),
            roundings: STEADY,
        }
    }

    /// A gap between parties of this speed that touch at this distance changes no faster than this, length/s, if it does not change.
    pub fn slowest(&self, world: &World<T>, speed: T, distance: T) -> T {
        let grain = world.grain_of_rate(speed, distance);
        self.slow.at_least(grain * T::lift(self.roundings))
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

/// The gap of these parties changes no faster than this now, length/s, if it does not change.
pub fn slowest<T: Real>(balls: &Kinematics<'_, T>, encounter: Encounter, steady: &Steady<T>) -> T {
    let world = balls.world();
    let loudness = |ball: usize| world.loudness(ball, &balls.moving(ball));
    let (speed, distance) = match encounter {
        Encounter::Pair(a, b) => (loudness(a).at_least(loudness(b)), world.distance(a, b)),
        Encounter::Cushion(a, _) => (loudness(a), world.radius[a]),
    };
    steady.slowest(world, speed, distance)
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
            && balls.rate(*encounter).abs() <= slowest(balls, *encounter, steady)
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

/// The same for what has derivatives, and nothing else: none opens or closes a contact.
pub fn keep_slopes<T: Real>(world: &World<T>, members: &mut [Member<T>], touches: &[Touch]) {
    let gap = |members: &[Member<T>], touch: Touch| gap(world, members, touch);
    even_out_derivatives(world, members, touches, gap, |moving| &mut moving.position);
    even_out_derivatives(world, members, touches, rate, |moving| &mut moving.velocity);
    for m in members {
        resettle(world, m, T::zero());
    }
}

/// Takes out of balls what is left of approach and parting of contacts, by impulses along them to which each ball answers as what it does lets it: the
/// nearest velocities by kinetic energy, which it never raises.
pub fn calm<T: Real>(world: &World<T>, members: &mut [Member<T>], touches: &[Touch]) {
    let speed = loudest(world, members);
    let none = world.grain(speed) * T::lift(ULPS);
    even_out(
        world,
        members,
        touches,
        [none, T::lift(f64::INFINITY)],
        rate,
        |moving| &mut moving.velocity,
    );
    for m in members {
        resettle(world, m, world.over(speed));
    }
}

/// Moves balls so that contacts are at contact; those that rest where others do not stay.
pub fn close_gaps<T: Real>(world: &World<T>, members: &mut [Member<T>], touches: &[Touch]) {
    let none = world.blur.length * T::lift(ULPS);
    let gap = |members: &[Member<T>], touch: Touch| gap(world, members, touch);
    even_out(
        world,
        members,
        touches,
        [none, T::lift(FARTHEST)],
        gap,
        |moving| &mut moving.position,
    );
}

/// The gap of two parties, length.
fn gap<T: Real>(world: &World<T>, members: &[Member<T>], touch: Touch) -> T {
    match touch {
        Touch::Pair(a, b) => {
            let [x, y] = between(members, a, b);
            (x * x + y * y).sqrt() - world.distance(members[a].ball, members[b].ball)
        }
        Touch::Cushion(a, side) => {
            let Member { ball, moving, .. } = &members[a];
            let beyond = world.reach[*ball][side as usize] - moving.position[side.axis()];
            if side.sign() < 0 { -beyond } else { beyond }
        }
    }
}

/// What a push along a contact moves: each party by how much for one unit, and where to.
struct Push<T> {
    parties: Vec<(usize, [T; 2])>,
    /// The outward normal of the first party.
    normal: [T; 2],
}

impl<T: Real> Push<T> {
    /// Of a contact whose parties each give by their part of the mass that answers.
    fn of(world: &World<T>, members: &[Member<T>], touch: Touch) -> Self {
        let gives = |m: usize| {
            let part = match members[m].mode {
                Mode::Rests => T::zero(),
                Mode::Rolls => T::lift(5.0) / T::lift(7.0),
                Mode::Slides | Mode::Drags | Mode::Floats => T::one(),
            };
            part / world.mass[members[m].ball]
        };
        let lightness = |m: usize| T::one() / world.mass[members[m].ball];
        let normal = match touch {
            Touch::Cushion(_, side) => {
                let mut n = [T::zero(); 2];
                n[side.axis()] = T::lift(f64::from(side.sign()));
                n
            }
            Touch::Pair(a, b) => {
                let p = between(members, a, b);
                let size = (p[0] * p[0] + p[1] * p[1]).sqrt();
                p.map(|p| p / size)
            }
        };
        // where all rest, only places can be off
        let rest = touch.members().all(|(m, _)| gives(m) == T::zero());
        let parties = touch.members().map(|(m, sign)| {
            let size = if rest { lightness(m) } else { gives(m) };
            (m, normal.map(|n| n * T::lift(-sign) * size))
        });
        Push {
            parties: parties.collect(),
            normal,
        }
    }

    /// How far so many units move the party that gives most.
    fn moves(&self, size: T) -> T {
        let ways = self
            .parties
            .iter()
            .map(|(_, [x, y])| x.abs().at_least(y.abs()));
        size.abs() * ways.fold(T::zero(), T::at_least)
    }

    /// Moves the parties by so many units, in this part of how they move.
    fn give_way(
        &self,
        members: &mut [Member<T>],
        size: T,
        part: impl Fn(&mut Moving<T>) -> &mut [T; 2],
    ) {
        for (m, way) in &self.parties {
            for (k, way) in way.iter().enumerate() {
                part(&mut members[*m].moving)[k] += *way * size;
            }
        }
    }

    /// How much of what this contact is off by one unit of another's push takes out.
    fn takes_out(&self, other: &Push<T>) -> T {
        let mut sum = T::zero();
        for (place, (m, _)) in self.parties.iter().enumerate() {
            let moved = other.parties.iter().find(|(other, _)| other == m);
            if let Some((_, way)) = moved {
                let along = self.normal[0] * way[0] + self.normal[1] * way[1];
                sum += if place == 0 { along } else { -along };
            }
        }
        sum
    }
}

/// Takes out what contacts are `off` by, until no more than `none` is left: all together where they are independent and that moves nobody more than `farthest`
/// times the largest, otherwise one after the other.
fn even_out<T: Real>(
    world: &World<T>,
    members: &mut [Member<T>],
    touches: &[Touch],
    [none, farthest]: [T; 2],
    off: impl Fn(&[Member<T>], Touch) -> T,
    part: impl Fn(&mut Moving<T>) -> &mut [T; 2],
) {
    let largest = |offs: &[T]| {
        offs.iter()
            .fold(T::zero(), |most, off| most.at_least(off.abs()))
    };
    let give_way =
        |members: &mut [Member<T>], push: &Push<T>, size: T| push.give_way(members, size, &part);
    for round in 0..ROUNDS {
        let offs: Vec<T> = touches.iter().map(|touch| off(members, *touch)).collect();
        let most = largest(&offs);
        if most <= none {
            break;
        }
        let pushes = touches.iter().map(|touch| Push::of(world, members, *touch));
        let pushes: Vec<Push<T>> = pushes.collect();
        let row = |k: &Push<T>| pushes.iter().map(|l| k.takes_out(l)).collect();
        let rows: Vec<Vec<T>> = pushes.iter().map(row).collect();
        let size = rows.iter().flatten();
        let size = size.fold(T::zero(), |most, x| most.at_least(x.abs()));
        let regular = (round < NEWTON).then(|| Factors::of(rows, size * T::lift(SINGULAR)));
        let together = regular.flatten().map(|factors| {
            let mut sizes = offs;
            factors.solve(&mut sizes);
            sizes
        });
        let near = |sizes: &Vec<T>| {
            let mut each = pushes.iter().zip(sizes);
            each.all(|(push, size)| push.moves(*size) <= farthest * most)
        };
        if let Some(sizes) = together.filter(near) {
            for (push, size) in pushes.iter().zip(sizes) {
                give_way(members, push, size);
            }
            continue;
        }
        for (touch, push) in touches.iter().zip(&pushes) {
            let size = off(members, *touch) / push.takes_out(push);
            give_way(members, push, size);
        }
    }
    if T::DIFFERENTIATES {
        even_out_derivatives(world, members, touches, off, part);
    }
}

/// Takes the derivatives of what contacts are `off` by out of balls, whose values stay.
fn even_out_derivatives<T: Real>(
    world: &World<T>,
    members: &mut [Member<T>],
    touches: &[Touch],
    off: impl Fn(&[Member<T>], Touch) -> T,
    part: impl Fn(&mut Moving<T>) -> &mut [T; 2],
) {
    let pushes = touches.iter().map(|touch| Push::of(world, members, *touch));
    let pushes: Vec<Push<T>> = pushes.collect();
    let give_way =
        |members: &mut [Member<T>], push: &Push<T>, size: T| push.give_way(members, size, &part);
    // only what has derivatives, of the value 0
    let slope = |members: &[Member<T>], touch: Touch| T::zero().following(off(members, touch));
    let row = |k: &Push<T>| pushes.iter().map(|l| k.takes_out(l)).collect();
    let rows: Vec<Vec<T>> = pushes.iter().map(row).collect();
    let size = rows.iter().flatten();
    let size = size.fold(T::zero(), |most, x| most.at_least(x.abs()));
    if let Some(factors) = Factors::of(rows, size * T::lift(SINGULAR)) {
        let mut sizes: Vec<T> = touches.iter().map(|t| slope(members, *t)).collect();
        factors.solve(&mut sizes);
        for (push, size) in pushes.iter().zip(sizes) {
            give_way(members, push, size);
        }
        return;
    }
    for _ in 0..ROUNDS {
        for (touch, push) in touches.iter().zip(&pushes) {
            let size = slope(members, *touch) / push.takes_out(push);
            give_way(members, push, size);
        }
    }
}

/// From the centre of one member to that of another.
fn between<T: Real>(members: &[Member<T>], a: usize, b: usize) -> [T; 2] {
    let (one, other) = (members[a].moving.position, members[b].moving.position);
    [0, 1].map(|k| other[k] - one[k])
}
