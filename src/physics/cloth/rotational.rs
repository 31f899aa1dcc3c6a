//! Cloth under a ball that rotates: slide, roll and spin-down.
//!
//! While the ball's lowest point slips over the cloth, Coulomb friction acts against the slip and turns the ball until it rolls;
//! the direction of the slip never changes, so the path is a parabola (Coriolis 1835). A rolling ball is slowed by rolling
//! resistance. Spin about the vertical falls by a friction torque of its own at all times. All for a uniform solid sphere.
//!
//! The rates are for engines that step in time. The closed forms below them are for tests and for people; the exact engine
//! writes its own.

use crate::math::{Real, Vec3};
use crate::physics::{Motion, State};
use nalgebra::Vector3;

/// What the cloth does to the motion of a ball at one moment.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rates<T: Real = f64> {
    /// Of the centre, length/s^2.
    pub acceleration: Vector3<T>,
    /// Of the spin, rad/s^2.
    pub angular_acceleration: Vector3<T>,
}

/// The numbers of the law.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Coefficients<T = f64> {
    /// Sliding friction, >= 0.
    pub mu_slide: T,
    /// Rolling resistance, >= 0.
    pub mu_roll: T,
    /// Friction against spin about the vertical, >= 0.
    pub mu_spin: T,
}

/// Velocity of the ball's lowest point over the cloth, length/s: `u = v + R (z x w) = (vx - R wy, vy + R wx, 0)`.
pub fn slip_velocity<T: Real>(velocity: &Vector3<T>, spin: &Vector3<T>, radius: T) -> Vector3<T> {
    Vector3::new(
        velocity.x - radius * spin.y,
        velocity.y + radius * spin.x,
        T::zero(),
    )
}

/// Horizontal spin of a ball that rolls with `velocity`, rad/s: `(-vy, vx, 0) / R`.
pub fn rolling_spin<T: Real>(velocity: &Vector3<T>, radius: T) -> Vector3<T> {
    Vector3::new(-velocity.y / radius, velocity.x / radius, T::zero())
}

/// A slip of no more than this part of the velocity is none where numbers are given to six digits: half a unit in the sixth of the velocity
/// and of the spin, each at a leading 1.
const SIX_DIGITS: f64 = 2.0 * 5e-6;

/// A slip of no more than this part of what it is the difference of is rounding: some ulp.
const ROUNDING: f64 = 8.0 * f64::EPSILON;

/// How a ball starts that rolls by the digits of its numbers; `None` of one that slides.
///
/// The one rule for the start of a run, in every engine: the slip as a vector, beside the velocity as a whole. A slip that is rounding leaves
/// the velocity as it is. A larger one, up to six digits, is none only where the spin is written in six digits or fewer; it ends at once, as the
/// cloth ends it within microseconds: `v - 2/7 u`, with no more energy than the numbers had. A state of a trace has more digits than that, so
/// that a slip that is truly there stays, however small: next to balls in contact it says how they part. The spin about the vertical takes
/// no part, and a ball without any velocity rolls only if it does not turn either.
pub fn rolling_start(start: &Motion, radius: f64) -> Option<Motion> {
    let Motion { velocity, spin } = *start;
    let slip = slip_velocity(&velocity, &spin, radius);
    let (size, whole) = (slip.norm(), velocity.norm());
    let velocity = if is_rounding(size, start, radius) {
        velocity
    } else if size <= SIX_DIGITS * whole && spin.xy().iter().all(|w| has_six_digits(*w)) {
        natural_roll(&velocity, &slip)
    } else {
        return None;
    };
    let mut turning = rolling_spin(&velocity, radius);
    turning.z = spin.z;
    Some(Motion {
        velocity,
        spin: turning,
    })
}

/// Whether six significant digits are all that a number has.
fn has_six_digits(x: f64) -> bool {
    format!("{x:.5e}").parse() == Ok(x)
}

/// The motion with which a run starts: as it is given, but for a slip that is more than rounding of a ball that rolls by [`rolling_start`].
pub fn as_meant(start: &Motion, radius: f64) -> Motion {
    let size = slip_velocity(&start.velocity, &start.spin, radius).norm();
    match rolling_start(start, radius) {
        Some(rolls) if !is_rounding(size, start, radius) => rolls,
        _ => *start,
    }
}

fn is_rounding(slip: f64, motion: &Motion, radius: f64) -> bool {
    slip <= ROUNDING
        * motion
            .velocity
            .norm()
            .hypot(radius * motion.spin.xy().norm())
}

/// Rates while a ball slides: `a = -mu_slide g u/|u|`, `dw/dt = -(5 mu_slide g / 2R) (u/|u| x z)`, and the decay of `w_z`.
///
/// `slip`: velocity of the lowest point, not zero.
pub fn sliding<T: Real>(
    slip: &Vector3<T>,
    spin: &Vector3<T>,
    radius: T,
    mu: Coefficients<T>,
    gravity: T,
) -> Rates<T> {
    let push = slip * (-(mu.mu_slide * gravity) / slip.dot(slip).sqrt());
    let turn = T::lift(2.5) / radius;
    Rates {
        acceleration: push,
        angular_acceleration: Vector3::new(
            turn * push.y,
            -(turn * push.x),
            against(spin.z, spin_deceleration(mu.mu_spin, gravity, radius)),
        ),
    }
}

/// Rates while a ball rolls: `a = -mu_roll g v/|v|`, horizontal spin slaved to the velocity, and the decay of `w_z`.
///
/// A ball that does not move has no rolling resistance.
pub fn rolling<T: Real>(
    velocity: &Vector3<T>,
    spin: &Vector3<T>,
    radius: T,
    mu: Coefficients<T>,
    gravity: T,
) -> Rates<T> {
    let speed = velocity.dot(velocity).sqrt();
    let acceleration = if speed == T::zero() {
        Vector3::new(T::zero(), T::zero(), T::zero())
    } else {
        velocity * (-(mu.mu_roll * gravity) / speed)
    };
    let mut angular_acceleration = rolling_spin(&acceleration, radius);
    angular_acceleration.z = against(spin.z, spin_deceleration(mu.mu_spin, gravity, radius));
    Rates {
        acceleration,
        angular_acceleration,
    }
}

/// Rate at which `|w_z|` falls until it is zero, rad/s^2: `5 mu_spin g / (2 R)`.
pub fn spin_deceleration<T: Real>(mu_spin: T, gravity: T, radius: T) -> T {
    T::lift(2.5) * mu_spin * gravity / radius
}

/// `size` with the sign that takes `x` towards zero; zero where `x` is.
fn against<T: Real>(x: T, size: T) -> T {
    if x > T::zero() {
        -size
    } else if x < T::zero() {
        size
    } else {
        T::zero()
    }
}

/// Time for which a ball with slip speed `slip`, length/s, slides, s: `2 |u| / (7 mu_slide g)`; infinite without friction.
pub fn slide_time(slip: f64, mu_slide: f64, gravity: f64) -> f64 {
    2.0 * slip / (7.0 * mu_slide * gravity)
}

/// Velocity with which a ball rolls once it has stopped sliding, length/s: `v - 2/7 u`, whatever the friction.
///
/// Angular momentum about the contact is conserved (Coriolis 1835).
pub fn natural_roll(velocity: &Vec3, slip: &Vec3) -> Vec3 {
    velocity - slip * (2.0 / 7.0)
}

/// State of a sliding ball after `t` s, `t` not beyond [`slide_time`]: `r + v t - mu_slide g t^2/2 u/|u|`.
pub fn slid(start: &State, radius: f64, mu: Coefficients, gravity: f64, t: f64) -> State {
    let slip = slip_velocity(&start.velocity, &start.spin, radius);
    let rates = sliding(&slip, &start.spin, radius, mu, gravity);
    let mut spin = start.spin + rates.angular_acceleration * t;
    spin.z = spun_down(start.spin.z, radius, mu.mu_spin, gravity, t);
    State {
        position: start.position + start.velocity * t + rates.acceleration * (t * t / 2.0),
        velocity: start.velocity + rates.acceleration * t,
        spin,
    }
}

/// Motion at the moment a slide ends: natural roll, and what is left of the spin about the vertical.
pub fn after_slide(start: &Motion, radius: f64, mu: Coefficients, gravity: f64) -> Motion {
    let slip = slip_velocity(&start.velocity, &start.spin, radius);
    let velocity = natural_roll(&start.velocity, &slip);
    let mut spin = rolling_spin(&velocity, radius);
    let time = slide_time(slip.norm(), mu.mu_slide, gravity);
    spin.z = spun_down(start.spin.z, radius, mu.mu_spin, gravity, time);
    Motion { velocity, spin }
}

/// Time until a ball that rolls with speed `v`, length/s, stops, s: `v / (mu_roll g)`.
pub fn roll_time(v: f64, mu_roll: f64, gravity: f64) -> f64 {
    v / (mu_roll * gravity)
}

/// Distance until a ball that rolls with speed `v`, length/s, stops, length: `v^2 / (2 mu_roll g)`.
pub fn roll_distance(v: f64, mu_roll: f64, gravity: f64) -> f64 {
    v * v / (2.0 * mu_roll * gravity)
}

/// Time until the spin `w_z`, rad/s, about the vertical is gone, s: `2 R |w_z| / (5 mu_spin g)`.
pub fn spin_time(w_z: f64, radius: f64, mu_spin: f64, gravity: f64) -> f64 {
    w_z.abs() / spin_deceleration(mu_spin, gravity, radius)
}

/// Spin about the vertical after `t` s, rad/s.
pub fn spun_down(w_z: f64, radius: f64, mu_spin: f64, gravity: f64, t: f64) -> f64 {
    let left = w_z.abs() - spin_deceleration(mu_spin, gravity, radius) * t;
    left.max(0.0).copysign(w_z)
}
