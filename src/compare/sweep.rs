//! Whether a trace passes over a collision: its paths, swept by parry's time of impact.
//!
//! Neither the finders nor the contact law of an engine are asked: only the knots of a trace are read, and two spheres of the
//! scene's radii are cast along its paths. A path between knots is a parabola; it is cut into pieces whose chord leaves
//! it by at most `a h^2 / 8`, and `h` is chosen so that this is no more than rounding may be. Stretches that the speeds at the
//! knots alone keep the balls apart in are skipped. So it is for traces whose knots are all there is: those of `exact`.

use crate::math::Vec3;
use crate::physics::{Side, State};
use crate::scene::Scene;
use crate::trace::{Contacts, Trace, UNEXPLAINED_IN_CONTACT};
use parry3d_f64::math::{Pose, Vector};
use parry3d_f64::query::{ShapeCastOptions, cast_shapes};
use parry3d_f64::shape::Ball;

/// Casts of one pair after which a sweep gives up: balls that stay within rounding of each other for long.
const MOST_CASTS: u64 = 20_000;

/// What a sweep saw.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Sweep {
    /// Questions to parry.
    pub casts: u64,
    /// Pairs that were given up: too many questions, or an allowance as large as a ball.
    pub given_up: u64,
    /// Pairs that were given up because their balls, in contact or where one has left them, need too many questions: they are held at their knots.
    pub lasting: u64,
    /// The first overlap of each pair: the balls and s.
    pub overlaps: Vec<(usize, usize, f64)>,
    /// Centres beyond where their cushions let them be: ball, side, s.
    pub outside: Vec<(usize, Side, f64)>,
}

/// Sweeps every pair of a trace, and every ball against its cushions.
///
/// `allowed`: what rounding may do to a position, length; as much again is allowed for the chord.
pub fn sweep(scene: &Scene, trace: &Trace, allowed: f64) -> Sweep {
    let mut seen = Sweep::default();
    let n = scene.balls.len();
    let contacts = Contacts::of(trace);
    for a in 0..n {
        for b in a + 1..n {
            let found = overlap_of(scene, trace, (a, b), allowed, &contacts, &mut seen);
            if let Some(time) = found {
                seen.overlaps.push((a, b, time));
            }
        }
        if scene.effects.cushion.is_some() {
            seen.outside.extend(outside(scene, trace, a, allowed));
        }
    }
    seen
}

/// Position, velocity and spin of a ball at both ends of a stretch without knots of its own.
fn ends(trace: &Trace, ball: usize, from: f64, to: f64) -> Option<(State, State)> {
    let path = trace.paths.get(ball)?;
    path.state_at(from).zip(path.before(to))
}

fn times(trace: &Trace, balls: &[usize]) -> Vec<f64> {
    let knots = balls.iter().flat_map(|ball| &trace.paths[*ball].knots);
    let mut times: Vec<f64> = knots.map(|knot| knot.time).collect();
    times.sort_by(f64::total_cmp);
    times.dedup();
    times
}

/// Motion of one ball as seen from another over one stretch of time: exact where both accelerations are constant.
struct Stretch {
    p: Vec3,
    v: Vec3,
    /// Change of the velocity over the whole stretch: its quotient by `h` may be too large for a number.
    dv: Vec3,
    h: f64,
}

impl Stretch {
    fn at(&self, t: f64) -> Vec3 {
        self.p + (self.v + self.dv * (0.5 * (t / self.h))) * t
    }

    /// Largest relative speed from `t` on: it is linear in time as a vector, so that its size is largest at an end.
    fn fastest(&self, t: f64) -> f64 {
        let speed = |t: f64| (self.v + self.dv * (t / self.h)).norm();
        speed(t).max(speed(self.h))
    }
}

/// When the balls `a` and `b` of a trace first overlap by more than is allowed, s. Counts into `seen`; see [`sweep`].
pub fn first_overlap(
    scene: &Scene,
    trace: &Trace,
    (a, b): (usize, usize),
    allowed: f64,
    seen: &mut Sweep,
) -> Option<f64> {
    overlap_of(scene, trace, (a, b), allowed, &Contacts::of(trace), seen)
}

fn overlap_of(
    scene: &Scene,
    trace: &Trace,
    (a, b): (usize, usize),
    allowed: f64,
    contacts: &Contacts,
    seen: &mut Sweep,
) -> Option<f64> {
    let radii = [a, b].map(|ball| scene.balls[ball].radius);
    if radii.iter().any(|radius| *radius <= 2.0 * allowed) {
        seen.given_up += 1;
        return None;
    }
    let reach = radii[0] + radii[1];
    // where a ball left play, others may follow
    let in_play = |ball: usize| match (trace.pocketed(ball), trace.paths[ball].knots.last()) {
        (true, Some(last)) => last.time,
        _ => f64::INFINITY,
    };
    let until = in_play(a).min(in_play(b));
    let most = seen.casts + MOST_CASTS;
    let held = |ball: usize, span: &[f64]| {
        contacts.during(ball, [span[0], span[1]]) || contacts.during(ball, [span[0]; 2])
    };
    for span in times(trace, &[a, b]).windows(2).filter(|s| s[1] <= until) {
        let h = span[1] - span[0];
        // both allowances, half off each radius: these must never meet; what knots in contact leave unexplained keeps them from meeting as well
        let unexplained = [a, b].into_iter().zip(radii).map(|(ball, radius)| {
            if held(ball, span) {
                UNEXPLAINED_IN_CONTACT * radius
            } else {
                0.0
            }
        });
        let unexplained: f64 = unexplained.sum();
        let [first, second] = radii.map(|radius| Ball::new(radius - allowed - unexplained));
        let ((a0, a1), (b0, b1)) =
            ends(trace, a, span[0], span[1]).zip(ends(trace, b, span[0], span[1]))?;
        let stretch = Stretch {
            p: b0.position - a0.position,
            v: b0.velocity - a0.velocity,
            dv: (b1.velocity - b0.velocity) - (a1.velocity - a0.velocity),
            h,
        };
        // a step whose chord is within rounding of the parabola
        let fine = (8.0 * allowed / stretch.dv.norm()).sqrt() * h.sqrt();
        let mut t = 0.0;
        while t < h {
            let here = stretch.at(t);
            let gap = (here.norm() - reach).max(0.0);
            let free = gap / stretch.fastest(t);
            // a cast from far away is good to rounding of the way, not of the balls
            if free > fine || gap > reach {
                t += free;
                continue;
            }
            let next = (t + fine).min(h);
            let there = stretch.at(next);
            seen.casts += 1;
            if meets(&first, &second, here, there) {
                return Some(span[0] + t);
            }
            if seen.casts >= most {
                // or rest where a contact has left them
                let until = [0.0, span[1]];
                if contacts.during(a, until) && contacts.during(b, until) {
                    seen.lasting += 1;
                } else {
                    seen.given_up += 1;
                }
                return None;
            }
            // the last piece may be shorter than the clock resolves
            t = if next > t { next } else { h };
        }
    }
    None
}

/// Whether the second ball, going from one place to another in a straight line as seen from the first, touches it.
fn meets(first: &Ball, second: &Ball, from: Vec3, to: Vec3) -> bool {
    let vector = |v: Vec3| Vector::new(v.x, v.y, v.z);
    let options = ShapeCastOptions {
        max_time_of_impact: 1.0,
        ..ShapeCastOptions::default()
    };
    let hit = cast_shapes(
        &Pose::IDENTITY,
        Vector::ZERO,
        first,
        &Pose::from_translation(vector(from)),
        vector(to - from),
        second,
        options,
    );
    // parry casts balls; an answer that it refuses to give is not taken for a miss
    hit.map_or(true, |hit| hit.is_some())
}

/// Sides and times, s, at which the centre of a ball is farther out than is allowed, length.
pub fn outside(scene: &Scene, trace: &Trace, ball: usize, allowed: f64) -> Vec<(usize, Side, f64)> {
    let mut found = Vec::new();
    let knots = &trace.paths[ball].knots;
    for side in Side::ALL {
        let axis = side.axis();
        let outward = f64::from(side.sign());
        let Some(reach) = scene.reach(side, scene.balls[ball].radius) else {
            continue;
        };
        for pair in knots.windows(2) {
            let (start, end) = (&pair[0].state, &pair[1].state);
            let h = pair[1].time - pair[0].time;
            let (v0, v1) = (outward * start.velocity[axis], outward * end.velocity[axis]);
            let beyond = |x: f64| outward * (x - reach) > allowed;
            // where it turns back, if it does
            let turn = if v0 > 0.0 && v1 < 0.0 {
                start.position[axis] + outward * 0.5 * v0 * (v0 / (v0 - v1)) * h
            } else {
                end.position[axis]
            };
            if beyond(start.position[axis]) || beyond(end.position[axis]) || beyond(turn) {
                found.push((ball, side, pair[0].time));
            }
        }
    }
    found
}
