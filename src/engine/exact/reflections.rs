//! Generalised reflections: several contacts at one instant, resolved together (Smith, Kaufman, Vouga, Tamstorf and Grinspun 2012,
//! "Reflections on simultaneous impact").
//!
//! All contacts that approach are taken together as one set of constraints. In the metric of the masses, the velocity is
//! reflected off the nearest velocity that none of them forbids: `v+ = 2 c - v`, `c` the projection of `v` onto the cone
//! `closing <= 0`. A projection onto a cone is at right angles to what it removes, so `|v+| = |v|`: kinetic energy is kept; every
//! impulse acts along a normal on both parties, so momentum is. The projection is unique, so mirror images and other orders
//! of the balls give the same answer up to rounding. The reflection can make further contacts approach (the next ball of a
//! cradle); they are reflected in the next pass, until none approaches.
//!
//! It is a convention, not the truth about touching balls: real ones deform, and which of them separate first depends on
//! how. A scene has to name it.
//!
//! Contacts that share no ball do not see each other and are solved apart, and one alone is left to its law: in a cradle the
//! exchange of equal masses stays exact to the bit.

use crate::math::Real;

/// Passes before the answer is that they never end. A light ball between heavy ones needs many, a rack a few dozen.
const MOST_PASSES: u32 = 10_000;

/// A velocity smaller than this many ulps of the cluster's largest speed, for each impulse, is zero.
const CANCELLED: f64 = 8.0;

/// A contact as a bound on velocities: its closing speed is the sum of `direction . velocity` over its members.
#[derive(Clone, Copy, Debug)]
pub struct Constraint<T> {
    /// A member of the cluster, and the direction in which it closes (unit).
    pub first: (usize, [T; 2]),
    /// The other one; none for a cushion.
    pub second: Option<(usize, [T; 2])>,
}

impl<T: Real> Constraint<T> {
    /// Its members with the directions in which they close.
    pub fn ends(&self) -> impl Iterator<Item = (usize, [T; 2])> {
        std::iter::once(self.first).chain(self.second)
    }

    /// The members that it bounds, one or two.
    pub fn members(&self) -> impl Iterator<Item = usize> {
        self.ends().map(|(member, _)| member)
    }

    /// Closing speed, length/s; positive while they approach.
    pub fn closing(&self, velocities: &[[T; 2]]) -> T {
        self.ends().fold(T::zero(), |sum, (member, d)| {
            let v = velocities[member];
            sum + d[0] * v[0] + d[1] * v[1]
        })
    }

    /// Changes velocities by an impulse against the closing direction.
    pub fn push(&self, impulse: T, mass: &[T], velocities: &mut [[T; 2]]) {
        for (member, d) in self.ends() {
            for axis in 0..2 {
                velocities[member][axis] -= d[axis] * impulse / mass[member];
            }
        }
    }

    /// By how much a unit impulse at `other` lowers the closing speed here, 1/mass.
    pub fn coupling(&self, other: &Self, mass: &[T]) -> T {
        let mut sum = T::zero();
        for (member, d) in self.ends() {
            for (one, e) in other.ends() {
                if one == member {
                    sum += (d[0] * e[0] + d[1] * e[1]) / mass[member];
                }
            }
        }
        sum
    }

    /// Whether they share a ball.
    pub fn meets(&self, other: &Self) -> bool {
        self.members()
            .any(|member| other.members().any(|one| one == member))
    }
}

/// What reflections leave of a cluster.
#[derive(Clone, Debug)]
pub struct Reflected<T> {
    /// Velocities of the members afterwards.
    pub velocities: Vec<[T; 2]>,
    /// Contacts that took part (indices into the constraints) and their whole impulse, in the order of the first pass in
    /// which they did, then in scene order.
    pub impulses: Vec<(usize, T)>,
}

/// A cluster as reflections see it.
#[derive(Clone, Copy, Debug)]
pub struct Approaching<'a, T> {
    /// Its contacts.
    pub constraints: &'a [Constraint<T>],
    /// Masses of its members.
    pub mass: &'a [T],
    /// Velocities of its members, length/s.
    pub velocities: &'a [[T; 2]],
    /// What closes in no faster than this does not approach, length/s.
    pub slow: T,
}

impl<T: Real> Approaching<'_, T> {
    /// Reflects until no contact approaches; `None` if there is no end to it. `alone`: the law of a contact that shares no ball with another
    /// that approaches, applied to the velocities.
    pub fn reflect(&self, mut alone: impl FnMut(usize, &mut [[T; 2]])) -> Option<Reflected<T>> {
        let Approaching {
            constraints,
            mass,
            slow,
            ..
        } = *self;
        let mut velocities = self.velocities.to_vec();
        let mut impulses: Vec<(usize, T)> = Vec::new();
        let mut book = |contact: usize, impulse: T| match impulses
            .iter_mut()
            .find(|(known, _)| *known == contact)
        {
            Some((_, sum)) => *sum += impulse,
            None => impulses.push((contact, impulse)),
        };
        let mut passes = 0;
        loop {
            let closing: Vec<usize> = (0..constraints.len())
                .filter(|i| constraints[*i].closing(&velocities) > slow)
                .collect();
            if closing.is_empty() {
                break;
            }
            passes += 1;
            if passes > MOST_PASSES {
                return None;
            }
            let before = velocities.clone();
            for group in groups(&closing, |a, b| constraints[a].meets(&constraints[b])) {
                if let [contact] = group[..] {
                    let constraint = &constraints[contact];
                    let speed = constraint.closing(&before);
                    book(
                        contact,
                        (speed + speed) / constraint.coupling(constraint, mass),
                    );
                    alone(contact, &mut velocities);
                    continue;
                }
                let set: Vec<&Constraint<T>> = group.iter().map(|i| &constraints[*i]).collect();
                let halves = projection(&set, mass, &before, slow)?;
                for (contact, half) in group.iter().zip(halves) {
                    if half > T::zero() {
                        let impulse = half + half;
                        book(*contact, impulse);
                        constraints[*contact].push(impulse, mass, &mut velocities);
                    }
                }
            }
        }
        let counted = impulses.len();
        let part = keep_energy(mass, self.velocities, &mut velocities);
        for (_, impulse) in &mut impulses {
            *impulse *= part;
        }
        self.settle(&mut velocities, counted);
        Some(Reflected {
            velocities,
            impulses,
        })
    }

    /// The inelastic projection: the velocities nearest to these, in the metric of the masses, in which no contact closes. `None`
    /// if there is no end to it.
    pub fn project(&self) -> Option<Reflected<T>> {
        let set: Vec<&Constraint<T>> = self.constraints.iter().collect();
        let found = projection(&set, self.mass, self.velocities, self.slow)?;
        let mut velocities = self.velocities.to_vec();
        let mut impulses = Vec::new();
        for (contact, impulse) in found.into_iter().enumerate() {
            if impulse > T::zero() {
                self.constraints[contact].push(impulse, self.mass, &mut velocities);
                impulses.push((contact, impulse));
            }
        }
        Some(Reflected {
            velocities,
            impulses,
        })
    }

    /// Rounding of cancelled velocities is no velocity: without this, balls that should rest would creep in a direction
    /// that is noise. `impulses`: how many there were.
    pub fn settle(&self, velocities: &mut [[T; 2]], impulses: usize) {
        let part = T::lift(CANCELLED * T::ULP * impulses as f64);
        let square = |v: &[T; 2]| v[0] * v[0] + v[1] * v[1];
        let fastest = self
            .velocities
            .iter()
            .chain(velocities.iter())
            .map(square)
            .fold(T::zero(), T::at_least);
        for (after, before) in velocities.iter_mut().zip(self.velocities) {
            if *after != *before && square(after) <= part * part * fastest {
                *after = [T::zero(); 2];
            }
        }
    }
}

/// The impulses that bring contacts which share balls to no closing speed: half of what reflects. `None` if there is no end to it.
fn projection<T: Real>(
    set: &[&Constraint<T>],
    mass: &[T],
    velocities: &[[T; 2]],
    slow: T,
) -> Option<Vec<T>> {
    let speeds: Vec<T> = set.iter().map(|c| c.closing(velocities)).collect();
    let row = |row: &&Constraint<T>| set.iter().map(|c| row.coupling(c, mass)).collect();
    let matrix: Vec<Vec<T>> = set.iter().map(row).collect();
    let mut impulses = project(&matrix, &speeds, slow)?;
    refine(&mut impulses, &matrix, set, mass, velocities);
    Some(impulses)
}

/// Rounding of all impulses that is left as it is, in ulps: what is exact stays exact.
const ROUNDED: f64 = 64.0;

/// Largest part by which impulses are corrected for their energy: what is farther off is no rounding.
const CORRECTED: f64 = 1e-6;

/// Scales all changes of velocity by the one factor that keeps the kinetic energy, which rounding of a thousand passes does not;
/// answers that factor. Momentum stays what it is.
fn keep_energy<T: Real>(mass: &[T], before: &[[T; 2]], after: &mut [[T; 2]]) -> T {
    let (mut work, mut square) = (T::zero(), T::zero());
    for ((mass, v), w) in mass.iter().zip(before).zip(after.iter()) {
        for axis in 0..2 {
            let change = w[axis] - v[axis];
            work += *mass * v[axis] * change;
            square += *mass * change * change;
        }
    }
    let part = -(work + work) / square;
    let off = (part - T::one()).abs();
    if off > T::lift(ROUNDED * T::ULP) && off < T::lift(CORRECTED) {
        for (v, w) in before.iter().zip(after) {
            for axis in 0..2 {
                w[axis] = v[axis] + part * (w[axis] - v[axis]);
            }
        }
        part
    } else {
        T::one()
    }
}

/// Times that impulses are corrected by what they leave closing.
const REFINEMENTS: usize = 2;

/// Corrects the impulses of a projection by the closing speeds that they leave, which are taken from the velocities.
///
/// Between balls of very different masses the coupling is the sum of a large and a small part and has lost the digits of the small
/// one, which alone decides how hard two heavy balls press a light one between them. The velocities have not.
fn refine<T: Real>(
    impulses: &mut [T],
    matrix: &[Vec<T>],
    set: &[&Constraint<T>],
    mass: &[T],
    before: &[[T; 2]],
) {
    let active: Vec<usize> = (0..set.len())
        .filter(|i| impulses[*i] > T::zero())
        .collect();
    for _ in 0..REFINEMENTS {
        let mut velocities = before.to_vec();
        for i in &active {
            set[*i].push(impulses[*i], mass, &mut velocities);
        }
        let left: Vec<T> = set.iter().map(|c| c.closing(&velocities)).collect();
        let Some(corrections) = solve(matrix, &left, &active) else {
            return;
        };
        for (i, correction) in active.iter().zip(corrections) {
            let corrected = impulses[*i] + correction;
            if corrected > T::zero() {
                impulses[*i] = corrected;
            }
        }
    }
}

/// Contacts in groups that do not meet each other, as `meet` says; each group and the list of groups in ascending order.
pub fn groups(contacts: &[usize], meet: impl Fn(usize, usize) -> bool) -> Vec<Vec<usize>> {
    let mut groups: Vec<Vec<usize>> = Vec::new();
    for contact in contacts {
        let meets = |group: &Vec<usize>| group.iter().any(|other| meet(*contact, *other));
        let (mut joined, apart): (Vec<_>, Vec<_>) = groups.into_iter().partition(meets);
        joined.push(vec![*contact]);
        groups = apart;
        groups.push(joined.concat());
    }
    for group in &mut groups {
        group.sort_unstable();
    }
    groups.sort();
    groups
}

/// The impulses `x >= 0` that bring closing speeds to zero or below: `w = speeds - matrix x <= 0`, and `w = 0` where `x > 0`.
///
/// `matrix` (contacts x contacts) is the symmetric, positive semidefinite coupling. The active-set method of Lawson and Hanson
/// for non-negative least squares: contacts join one at a time, the one that closes fastest first, and leave when they would
/// pull. One that depends on those that already push has nothing left to close and never joins, so a rack with more contacts
/// than motions is no trouble. `None` if it does not end, which rounding could bring about.
fn project<T: Real>(matrix: &[Vec<T>], speeds: &[T], slow: T) -> Option<Vec<T>> {
    let zero = T::zero();
    let n = speeds.len();
    let mut x = vec![zero; n];
    let mut active: Vec<usize> = Vec::new();
    // contacts that did not help since the last progress
    let mut barred = vec![false; n];
    for _ in 0..32 * (n + 1) {
        let left = |i: usize| (0..n).fold(speeds[i], |sum, j| sum - matrix[i][j] * x[j]);
        let mut worst: Option<(usize, T)> = None;
        for i in (0..n).filter(|i| !barred[*i] && !active.contains(i)) {
            let speed = left(i);
            if speed > worst.map_or(slow, |(_, most)| most) {
                worst = Some((i, speed));
            }
        }
        let Some((joining, _)) = worst else {
            return Some(x);
        };
        active.push(joining);
        while !active.is_empty() {
            let Some(free) = solve(matrix, speeds, &active) else {
                break;
            };
            // as far toward the free solution as no contact pulls
            let mut part = T::one();
            for (i, value) in active.iter().zip(&free) {
                if *value <= zero {
                    part = part.at_most(x[*i] / (x[*i] - *value));
                }
            }
            for (i, value) in active.iter().zip(&free) {
                let next = x[*i] + part * (*value - x[*i]);
                x[*i] = if *value <= zero && next <= x[*i] * T::lift(T::ULP) {
                    zero
                } else {
                    next
                };
            }
            if part >= T::one() {
                break;
            }
            active.retain(|i| x[*i] > zero);
        }
        active.retain(|i| x[*i] > zero);
        if x[joining] > zero {
            barred.fill(false);
        } else {
            barred[joining] = true;
        }
    }
    None
}

/// Solves the rows and columns `chosen` of a symmetric system by `L D L^T`; `None` if they depend on each other.
fn solve<T: Real>(matrix: &[Vec<T>], right: &[T], chosen: &[usize]) -> Option<Vec<T>> {
    let n = chosen.len();
    let mut lower = vec![vec![T::zero(); n]; n];
    let mut diagonal = vec![T::zero(); n];
    for i in 0..n {
        for j in 0..=i {
            let mut sum = matrix[chosen[i]][chosen[j]];
            for k in 0..j {
                sum -= lower[i][k] * lower[j][k] * diagonal[k];
            }
            if j < i {
                lower[i][j] = sum / diagonal[j];
            } else {
                let rounding = T::lift(16.0 * T::ULP * n as f64) * matrix[chosen[i]][chosen[i]];
                if sum <= rounding {
                    return None;
                }
                diagonal[i] = sum;
            }
        }
    }
    let mut x: Vec<T> = chosen.iter().map(|i| right[*i]).collect();
    for i in 0..n {
        for k in 0..i {
            let known = lower[i][k] * x[k];
            x[i] -= known;
        }
    }
    for i in (0..n).rev() {
        x[i] /= diagonal[i];
        for k in i + 1..n {
            let known = lower[k][i] * x[k];
            x[i] -= known;
        }
    }
    Some(x)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A deterministic number between -1 and 1.
    fn draw(seed: &mut u64) -> f64 {
        *seed = seed
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (*seed >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }

    #[test]
    fn a_projection_leaves_nothing_closing_and_pushes_only_where_it_holds() {
        let mut seed = 7;
        for case in 0..2000 {
            // more contacts than motions in every third case, so that they depend on each other
            let n = 2 + case % 7;
            let motions = if case % 3 == 0 { n - 1 } else { n + 2 };
            let normals: Vec<Vec<f64>> = (0..n)
                .map(|_| (0..motions).map(|_| draw(&mut seed)).collect())
                .collect();
            let dot = |a: &[f64], b: &[f64]| -> f64 { a.iter().zip(b).map(|(x, y)| x * y).sum() };
            let matrix: Vec<Vec<f64>> = normals
                .iter()
                .map(|a| normals.iter().map(|b| dot(a, b)).collect())
                .collect();
            // speeds that a motion can have
            let motion: Vec<f64> = (0..motions).map(|_| draw(&mut seed)).collect();
            let speeds: Vec<f64> = normals.iter().map(|a| dot(a, &motion)).collect();
            let x = project(&matrix, &speeds, 1e-14).unwrap_or_default();
            assert_eq!(x.len(), n, "case {case} did not end");
            for i in 0..n {
                let left = speeds[i] - dot(&matrix[i], &x);
                // rounding of n products of impulses that nearly dependent normals make large
                let largest = x.iter().copied().fold(1.0, f64::max);
                let rounding = 1e-13 * largest * n as f64;
                assert!(x[i] >= 0.0 && left <= rounding, "case {case}: {left:e}");
                assert!(
                    x[i] == 0.0 || left.abs() <= rounding,
                    "case {case}: pushes with {} where {left:e} is left",
                    x[i]
                );
            }
        }
    }

    #[test]
    fn contacts_that_share_no_ball_are_solved_apart() {
        let contact = |a: usize, b: usize| Constraint {
            first: (a, [1.0, 0.0]),
            second: Some((b, [-1.0, 0.0])),
        };
        let all = [contact(0, 1), contact(2, 3), contact(1, 4), contact(3, 5)];
        let meet = |a: usize, b: usize| all[a].meets(&all[b]);
        let found = groups(&[0, 1, 2, 3], meet);
        assert_eq!(found, vec![vec![0, 2], vec![1, 3]]);
        assert_eq!(groups(&[0, 3], meet), vec![vec![0], vec![3]]);
    }
}
