//! Impacts at one instant: whether their order changes the result.
//!
//! A ball that approaches two others which it touches, or reaches within the error of the time, is hit by both "at once".
//! Processing the pairs one after another is an answer only if every order gives the same one: always so in a straight
//! line of equal balls or for contacts at right angles, never so in the apex of a rack. This room tries the orders on the
//! cluster of touching balls with positions held still, and says whether they agree. What a scene's convention makes of
//! such an instant is in `cluster_impact`.

use super::agenda::Agenda;
use super::kinematics::Kinematics;
use super::world::World;
use crate::math::Real;
use crate::physics::{Body, Contact, Cushion, Friction, Motion, Side, contact, cushion};
use nalgebra::Vector3;
use std::collections::BTreeSet;

/// Impacts that are tried before the answer is "they disagree": enough for every order of a handful of contacts.
const PATIENCE: u32 = 20_000;

/// Results of two orders are equal if they differ by fewer ulps of the largest speed than this for each impact.
const ROUNDINGS: f64 = 64.0;

/// Two parties within reach of each other.
#[derive(Clone, Copy, Debug)]
pub enum Touch<T: Real> {
    /// Two members of the cluster, and the normal from the first to the second.
    Pair(usize, usize, Vector3<T>),
    /// A member and a cushion.
    Cushion(usize, Side),
}

/// Balls that touch, directly or through others, at one instant.
#[derive(Debug)]
pub struct Cluster<'a, T: Real> {
    /// Laws, masses and what the scalar can tell apart.
    pub world: &'a World<T>,
    /// Indices in scene order.
    pub balls: Vec<usize>,
    /// Velocities of the members.
    pub velocities: Vec<[T; 2]>,
    /// Angular velocities of the members; they only matter to laws with friction.
    pub spins: Vec<[T; 3]>,
    /// Who is within reach of whom, by member (position in `balls`).
    pub touches: Vec<Touch<T>>,
    /// False if it has more balls than were asked for, and was left unfinished.
    whole: bool,
}

/// Velocity `v` of two components as a law wants it.
fn spatial<T: Real>(v: [T; 2]) -> Vector3<T> {
    Vector3::new(v[0], v[1], T::zero())
}

impl<'a, T: Real> Cluster<'a, T> {
    /// The cluster around `seeds` in a run. `state`: centre and velocity of a ball; `spin`: its angular velocity; two parties are
    /// within reach if their gap is touching, or closes within `window` seconds.
    pub fn within(
        balls: &'a Kinematics<'_, T>,
        agenda: &Agenda<T>,
        seeds: &[usize],
        state: &dyn Fn(usize) -> ([T; 2], [T; 2]),
        spin: &dyn Fn(usize) -> [T; 3],
        window: T,
    ) -> Self {
        let world = balls.world();
        // no two balls close in faster than this
        let gap = world.touching + (world.fastest + world.fastest) * window;
        let neighbours = |ball: usize| agenda.neighbours(balls, ball, gap);
        let mut cluster = Cluster::around(world, seeds, state, &neighbours, window, usize::MAX);
        if balls.rotates() {
            cluster.spins = cluster.balls.iter().map(|ball| spin(*ball)).collect();
        }
        cluster
    }

    /// The cluster around `seeds`. `state`: centre and velocity of a ball; `neighbours`: in scene order, all that may be
    /// within reach of one; two parties are within reach if their gap is touching, or closes within `window` seconds. It
    /// is left unfinished as soon as it has more than `most` balls.
    pub fn around(
        world: &'a World<T>,
        seeds: &[usize],
        state: &dyn Fn(usize) -> ([T; 2], [T; 2]),
        neighbours: &dyn Fn(usize) -> Vec<usize>,
        window: T,
        most: usize,
    ) -> Self {
        let mut cluster = Cluster::of(world, seeds.to_vec(), Vec::new(), Vec::new(), Vec::new());
        let mut members: BTreeSet<usize> = seeds.iter().copied().collect();
        // pairs within reach, the smaller index first, with the vector between their centres
        let mut pairs = Vec::new();
        let mut next = 0;
        while let Some(&ball) = cluster.balls.get(next) {
            next += 1;
            let (here, moving) = state(ball);
            for other in neighbours(ball) {
                let (there, velocity) = state(other);
                let p = difference(there, here);
                let v = difference(velocity, moving);
                let reach = world.distance(ball, other) + world.touching + length(v) * window;
                if other == ball || length(p) > reach {
                    continue;
                }
                if ball < other {
                    pairs.push((ball, other, p));
                }
                if members.insert(other) {
                    if members.len() > most {
                        cluster.whole = false;
                        return cluster;
                    }
                    cluster.balls.push(other);
                }
            }
        }
        cluster.balls.sort_unstable();
        pairs.sort_unstable_by_key(|(a, b, _)| (*a, *b));
        let states = cluster.balls.iter().map(|ball| state(*ball));
        let (positions, velocities): (Vec<_>, Vec<_>) = states.unzip();
        cluster.velocities = velocities;
        cluster.spins = vec![[T::zero(); 3]; cluster.balls.len()];
        cluster.find_touches(&positions, &pairs, window);
        cluster
    }

    /// `positions`: of the members; `pairs`: balls within reach of each other, by scene order.
    fn find_touches(&mut self, positions: &[[T; 2]], pairs: &[(usize, usize, [T; 2])], window: T) {
        let world = self.world;
        let mut pairs = pairs.iter().peekable();
        for (first, a) in self.balls.iter().copied().enumerate() {
            while let Some((_, b, p)) = pairs.next_if(|(one, ..)| *one == a) {
                let apart = length(*p);
                if world.contact.is_some() && apart > T::zero() {
                    let second = self.balls.partition_point(|ball| ball < b);
                    let normal = spatial([p[0] / apart, p[1] / apart]);
                    self.touches.push(Touch::Pair(first, second, normal));
                }
            }
            let Some(reach) = world.reach.get(a) else {
                continue;
            };
            for side in Side::ALL {
                let axis = side.axis();
                let gap = (reach[side as usize] - positions[first][axis]).abs();
                if gap <= world.touching + self.velocities[first][axis].abs() * window {
                    self.touches.push(Touch::Cushion(first, side));
                }
            }
        }
    }

    /// A cluster of these balls, which touch as `touches` say: whoever knows both, and need not look for them. `velocities`, `spins`: of
    /// `balls`, in their order; touches are by place in `balls`.
    pub fn of(
        world: &'a World<T>,
        balls: Vec<usize>,
        velocities: Vec<[T; 2]>,
        spins: Vec<[T; 3]>,
        touches: Vec<Touch<T>>,
    ) -> Self {
        Cluster {
            world,
            balls,
            velocities,
            spins,
            touches,
            whole: true,
        }
    }

    /// Contacts that approach, given these velocities.
    fn live<'b>(&'b self, velocities: &'b [[T; 2]]) -> impl Iterator<Item = Touch<T>> + 'b {
        let slow = self.world.blur.speed;
        self.touches.iter().copied().filter(move |touch| {
            let closing = match *touch {
                Touch::Pair(a, b, n) => spatial(difference(velocities[a], velocities[b])).dot(&n),
                Touch::Cushion(a, side) => {
                    let outward = velocities[a][side.axis()];
                    if side.sign() < 0 { -outward } else { outward }
                }
            };
            closing > slow
        })
    }

    /// Masses of the members.
    pub fn masses(&self) -> Vec<T> {
        self.balls
            .iter()
            .map(|ball| self.world.mass[*ball])
            .collect()
    }

    /// True unless every order of the impacts leaves the same velocities, up to rounding; true for an unfinished cluster.
    pub fn order_matters(&self) -> bool {
        if !self.whole {
            return true;
        }
        let mut search = Search {
            tried: 0,
            result: None,
        };
        !self.agree(&self.velocities, &self.spins, 0, &mut search)
    }

    fn agree(
        &self,
        velocities: &[[T; 2]],
        spins: &[[T; 3]],
        depth: u32,
        search: &mut Search<T>,
    ) -> bool {
        let mut finished = true;
        for touch in self.live(velocities) {
            finished = false;
            search.tried += 1;
            if search.tried > PATIENCE || depth > PATIENCE / 100 {
                return false;
            }
            let (mut after, mut turning) = (velocities.to_vec(), spins.to_vec());
            self.apply(touch, &mut after, &mut turning);
            if !self.agree(&after, &turning, depth + 1, search) {
                return false;
            }
        }
        if !finished {
            return true;
        }
        match &search.result {
            None => {
                search.result = Some((velocities.to_vec(), depth));
                true
            }
            Some((first, impacts)) => {
                let fastest = velocities
                    .iter()
                    .map(|v| length(*v))
                    .fold(T::zero(), T::at_least);
                let impacts = f64::from(depth.max(*impacts));
                let rounding = fastest * T::lift(ROUNDINGS * T::ULP * impacts);
                let same = |(a, b): (&[T; 2], &[T; 2])| length(difference(*a, *b)) <= rounding;
                first.iter().zip(velocities).all(same)
            }
        }
    }

    /// One impact by its law.
    pub fn apply(&self, touch: Touch<T>, velocities: &mut [[T; 2]], spins: &mut [[T; 3]]) {
        let world = self.world;
        let laws = (world.contact, world.cushion);
        self.meet(touch, laws, world.friction, velocities, spins);
    }

    /// One impact without loss and friction, whatever its law.
    pub fn apply_elastic(&self, touch: Touch<T>, velocities: &mut [[T; 2]]) {
        let laws = (Some(Contact::Elastic {}), Some(Cushion::Elastic {}));
        self.meet(touch, laws, None, velocities, &mut self.spins.clone());
    }

    fn meet(
        &self,
        touch: Touch<T>,
        (contact, cushion): (Option<Contact<T>>, Option<Cushion<T>>),
        friction: Option<Friction<T>>,
        velocities: &mut [[T; 2]],
        spins: &mut [[T; 3]],
    ) {
        let world = self.world;
        let body = |member: usize| Body {
            velocity: spatial(velocities[member]),
            spin: spins[member].into(),
            mass: world.mass[self.balls[member]],
            radius: world.radius[self.balls[member]],
        };
        let plan = |motion: &Motion<T>| [motion.velocity.x, motion.velocity.y];
        match touch {
            Touch::Pair(a, b, n) => {
                if let Some(law) = contact {
                    let (one, other) = contact::impact(law, friction, &body(a), &body(b), &n);
                    (velocities[a], velocities[b]) = (plan(&one), plan(&other));
                    (spins[a], spins[b]) = (one.spin.into(), other.spin.into());
                }
            }
            Touch::Cushion(a, side) => {
                if let Some(law) = cushion {
                    let motion = cushion::impact(law, &body(a), side).motion;
                    velocities[a] = plan(&motion);
                    spins[a] = motion.spin.into();
                }
            }
        }
    }
}

struct Search<T> {
    tried: u32,
    /// Velocities after the first order, and its number of impacts.
    result: Option<(Vec<[T; 2]>, u32)>,
}

fn difference<T: Real>(a: [T; 2], b: [T; 2]) -> [T; 2] {
    [a[0] - b[0], a[1] - b[1]]
}

fn length<T: Real>(v: [T; 2]) -> T {
    (v[0] * v[0] + v[1] * v[1]).sqrt()
}
