//! Rotation of a ball between two events, and the flights of balls that rotate: slide along a parabola, roll, spin in place.
//!
//! Only scenes that call for rotation have any of this; in others the list of spins is empty. The closed forms are those of a uniform
//! solid sphere (Coriolis 1835): while the lowest point slips with `u = v + R (z x w)`, the centre accelerates by `-mu g u/|u|` and
//! the direction of `u` stays, so the slide lasts `2 |u| / (7 mu g)` and ends with `v = v0 - 2/7 u0`. They are written here from the law
//! and never call the rates of `physics::cloth`.

use super::flight::{Flight, Phase};
use crate::math::Real;
use crate::physics::{Cloth, Effects, State};

/// Where velocity or slip is no more than this many ulps of what it is the difference of, there is none.
const CANCELLED: f64 = 8.0;

/// What ends a flight.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Turn {
    /// Nothing but an impact.
    Never,
    /// The slip ends, and the ball rolls.
    Roll,
    /// The centre comes to rest.
    Stop,
    /// The spin about the vertical ends, and all else goes on.
    Unspun,
}

/// Rotation of a ball during a flight: linear in time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spin<T> {
    /// Angular velocity at the start of the flight, rad/s.
    pub start: [T; 3],
    /// Its constant rate, rad/s^2.
    pub rate: [T; 3],
    /// What ends the flight.
    pub turn: Turn,
    /// True while the lowest point slips over a cloth that has friction.
    pub slides: bool,
}

impl<T: Real> Spin<T> {
    /// The same spin with the derivatives of another.
    pub fn following(self, other: &Self) -> Self {
        let space = |own: [T; 3], other: [T; 3]| [0, 1, 2].map(|i| own[i].following(other[i]));
        Spin {
            start: space(self.start, other.start),
            rate: space(self.rate, other.rate),
            ..self
        }
    }

    /// No rotation.
    pub fn none() -> Self {
        Spin {
            start: [T::zero(); 3],
            rate: [T::zero(); 3],
            turn: Turn::Never,
            slides: false,
        }
    }

    /// Angular velocity `h` seconds after the start of the flight.
    pub fn after(&self, h: T) -> [T; 3] {
        [0, 1, 2].map(|i| self.start[i] + self.rate[i] * h)
    }

    /// True unless the ball does not turn.
    pub fn turns(&self) -> bool {
        self.start.iter().any(|w| *w != T::zero())
    }
}

/// The cloth under balls that rotate; all zero where there is none.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rotation<T> {
    /// Deceleration of a sliding ball, length/s^2.
    pub slide: T,
    /// Deceleration of a rolling ball, length/s^2.
    pub roll: T,
    /// `mu_spin g`, length/s^2.
    pub spin: T,
}

/// Where and how a ball moves: centre and velocity in the plane, spin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Moving<T> {
    /// Centre, length.
    pub position: [T; 2],
    /// Velocity, length/s.
    pub velocity: [T; 2],
    /// Angular velocity, rad/s.
    pub spin: [T; 3],
}

impl<T: Real> Moving<T> {
    /// Velocity of the lowest point of a ball of this radius: `v + R (z x w)`.
    pub fn slip(&self, radius: T) -> [T; 2] {
        let [x, y] = self.velocity;
        [x - radius * self.spin[1], y + radius * self.spin[0]]
    }

    /// Takes out the slip by what the cloth does to a sphere until it rolls.
    pub fn end_slip(&mut self, radius: T) {
        let slip = self.slip(radius);
        let part = T::lift(2.0) / T::lift(7.0);
        self.velocity = [0, 1].map(|axis| self.velocity[axis] - slip[axis] * part);
        let [x, y] = self.velocity;
        [self.spin[0], self.spin[1]] = [-y / radius, x / radius];
    }
}

impl<T: Real> Moving<T> {
    /// A ball at rest at the origin.
    pub fn at_rest() -> Self {
        Moving {
            position: [T::zero(); 2],
            velocity: [T::zero(); 2],
            spin: [T::zero(); 3],
        }
    }

    /// The same motion with the derivatives of another.
    pub fn following(self, other: &Self) -> Self {
        let plane = |own: [T; 2], other: [T; 2]| [0, 1].map(|i| own[i].following(other[i]));
        Moving {
            position: plane(self.position, other.position),
            velocity: plane(self.velocity, other.velocity),
            spin: [0, 1, 2].map(|i| self.spin[i].following(other.spin[i])),
        }
    }

    /// One of its seven numbers: x, y, their rates, and the three of the spin.
    pub fn part(&mut self, part: usize) -> &mut T {
        match part {
            0 | 1 => &mut self.position[part],
            2 | 3 => &mut self.velocity[part - 2],
            _ => &mut self.spin[(part - 4).min(2)],
        }
    }

    /// A state of a scene or a trace, lifted.
    pub fn lifted(state: &State) -> Self {
        let (r, v, w) = (&state.position, &state.velocity, &state.spin);
        Moving {
            position: [T::lift(r.x), T::lift(r.y)],
            velocity: [T::lift(v.x), T::lift(v.y)],
            spin: [T::lift(w.x), T::lift(w.y), T::lift(w.z)],
        }
    }
}

impl<T: Real> Rotation<T> {
    /// The rotation that a scene calls for; `None` where balls do not turn.
    pub fn new(effects: &Effects<T>, gravity: T) -> Option<Self> {
        let zero = T::zero();
        if !effects.rotates() {
            return None;
        }
        Some(match effects.cloth {
            Some(Cloth::Rotational {
                mu_slide,
                mu_roll,
                mu_spin,
            }) => Rotation {
                slide: mu_slide * gravity,
                roll: mu_roll * gravity,
                spin: mu_spin * gravity,
            },
            Some(Cloth::Translational { .. }) | None => Rotation {
                slide: zero,
                roll: zero,
                spin: zero,
            },
        })
    }

    /// The start of a ball in this scalar: its numbers are f64, so what rolls to their rounding rolls, in any scalar. What rolls to six digits only
    /// is the scene's to say: [`crate::scene::Scene::start`].
    pub fn as_meant(&self, radius: T, mut moving: Moving<T>) -> Moving<T> {
        let (_, slips) = self.slip(radius, &moving, T::ULP.max(f64::EPSILON));
        if !slips && self.slide > T::zero() {
            let [vx, vy] = moving.velocity;
            [moving.spin[0], moving.spin[1]] = [-vy / radius, vx / radius];
        }
        moving
    }

    /// Slip of the lowest point over the cloth, and whether it is more than rounding, in units of `ulp`.
    fn slip(&self, radius: T, moving: &Moving<T>, ulp: f64) -> ([T; 2], bool) {
        let ([vx, vy], [wx, wy, _]) = (moving.velocity, moving.spin);
        let slip = [vx - radius * wy, vy + radius * wx];
        let square = |[x, y]: [T; 2]| x * x + y * y;
        let made_of = square(moving.velocity) + radius * radius * square([wx, wy]);
        let rounding = T::lift(CANCELLED * ulp);
        (slip, square(slip) > rounding * rounding * made_of)
    }

    /// The flight and the spin of a ball of radius `radius` from time `start` on.
    pub fn depart(&self, radius: T, start: T, moving: Moving<T>) -> (Flight<T>, Spin<T>) {
        let zero = T::zero();
        let (slip, slips) = self.slip(radius, &moving, T::ULP);
        let (mut flight, mut spin) = if slips && self.slide > zero {
            self.slide(radius, start, moving, slip)
        } else {
            self.roll(radius, start, moving, slip, slips)
        };
        // w_z falls by a torque of its own, whatever else the ball does
        let vertical = spin.start[2];
        if vertical != zero && self.spin > zero {
            let rate = T::lift(2.5) * self.spin / radius;
            spin.rate[2] = if vertical > zero { -rate } else { rate };
            let gone = start + vertical.abs() / rate;
            if gone < flight.end {
                flight.end = gone;
                spin.turn = Turn::Unspun;
                // the end of a free flight is taken for that of its speed
                if flight.phase == Phase::Free {
                    flight.phase = Phase::Curve;
                }
            }
        }
        (flight, spin)
    }

    /// A motion whose spin about the vertical is none: the cloth takes what is small of it at once, and at first order for good.
    pub fn unspun(&self, mut moving: Moving<T>) -> Moving<T> {
        if moving.spin[2] == T::zero() && self.spin > T::zero() {
            moving.spin[2] = moving.spin[2].detached();
        }
        moving
    }

    fn slide(&self, radius: T, start: T, moving: Moving<T>, slip: [T; 2]) -> (Flight<T>, Spin<T>) {
        let speed = (slip[0] * slip[0] + slip[1] * slip[1]).sqrt();
        let push = [
            -(self.slide * slip[0] / speed),
            -(self.slide * slip[1] / speed),
        ];
        let duration = T::lift(2.0) * speed / (T::lift(7.0) * self.slide);
        let size = |[x, y]: [T; 2]| (x * x + y * y).sqrt();
        // the square of the speed is convex in time: largest at one of the ends
        let fastest = size(moving.velocity).at_least(size(rolled(&moving, slip)));
        let turn = T::lift(2.5) / radius;
        let flight = Flight {
            start,
            end: start + duration,
            position: moving.position,
            velocity: moving.velocity,
            acceleration: push,
            fastest,
            phase: Phase::Curve,
        };
        let spin = Spin {
            start: moving.spin,
            rate: [turn * push[1], -(turn * push[0]), T::zero()],
            turn: Turn::Roll,
            slides: true,
        };
        (flight, spin)
    }

    /// A ball that rolls or stands, or slips over a cloth without sliding friction; `slip`: what there is of it.
    fn roll(
        &self,
        radius: T,
        start: T,
        moving: Moving<T>,
        slip: [T; 2],
        slips: bool,
    ) -> (Flight<T>, Spin<T>) {
        let zero = T::zero();
        let Moving {
            position,
            mut velocity,
            mut spin,
        } = moving;
        if !slips && self.slide > zero {
            // what is left of a slip, rounding or a derivative, ends in natural roll at once
            velocity = rolled(&moving, slip);
            [spin[0], spin[1]] = [-velocity[1] / radius, velocity[0] / radius];
        }
        let [vx, vy] = velocity;
        let speed = (vx * vx + vy * vy).sqrt();
        let straight = Flight {
            start,
            end: T::lift(f64::INFINITY),
            position,
            velocity,
            acceleration: [zero; 2],
            fastest: speed,
            phase: if speed == zero {
                Phase::Rest
            } else {
                Phase::Free
            },
        };
        let steady = Spin {
            start: spin,
            rate: [zero; 3],
            turn: Turn::Never,
            slides: false,
        };
        if speed == zero || slips || self.roll <= zero {
            return (straight, steady);
        }
        let duration = speed / self.roll;
        let acceleration = [-vx / duration, -vy / duration];
        let flight = Flight {
            end: start + duration,
            acceleration,
            phase: Phase::Curve,
            ..straight
        };
        let spin = Spin {
            rate: [-acceleration[1] / radius, acceleration[0] / radius, zero],
            turn: Turn::Stop,
            ..steady
        };
        (flight, spin)
    }

    /// How a ball goes on from the end of its flight.
    pub fn turned(&self, radius: T, flight: &Flight<T>, spin: &Spin<T>) -> Moving<T> {
        let zero = T::zero();
        let (position, velocity) = flight.at(flight.end);
        let turning = spin.after(flight.end - flight.start);
        match spin.turn {
            Turn::Never => Moving {
                position,
                velocity,
                spin: turning,
            },
            Turn::Roll => {
                let was = Moving {
                    position: flight.position,
                    velocity: flight.velocity,
                    spin: spin.start,
                };
                let (slip, _) = self.slip(radius, &was, T::ULP);
                let mut velocity = rolled(&was, slip);
                let square = |[x, y]: [T; 2]| x * x + y * y;
                let rounding = T::lift(CANCELLED * T::ULP);
                // a ball whose slide takes all of its speed stands still
                if square(velocity) <= rounding * rounding * (square(was.velocity) + square(slip)) {
                    velocity = [zero; 2];
                }
                let [vx, vy] = velocity;
                Moving {
                    position,
                    velocity,
                    spin: [-vy / radius, vx / radius, turning[2]],
                }
            }
            Turn::Stop => Moving {
                position: flight.rest_position(),
                velocity: [zero; 2],
                spin: [zero, zero, turning[2]],
            },
            Turn::Unspun => {
                // what rolls goes on rolling: rounding must not make it slide
                let rolls = !spin.slides && self.slide > zero;
                let [x, y] = match rolls {
                    true => [-velocity[1] / radius, velocity[0] / radius],
                    false => [turning[0], turning[1]],
                };
                Moving {
                    position,
                    velocity,
                    spin: [x, y, zero],
                }
            }
        }
    }
}

/// Velocity with which a ball that slips by `slip` will roll: natural roll, whatever the friction.
fn rolled<T: Real>(moving: &Moving<T>, slip: [T; 2]) -> [T; 2] {
    let part = T::lift(2.0) / T::lift(7.0);
    [0, 1].map(|i| moving.velocity[i] - slip[i] * part)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Vec3;
    use crate::physics::State;
    use crate::physics::cloth::rotational::{Coefficients, rolling, sliding, slip_velocity};

    const R: f64 = 0.03;
    const G: f64 = 9.81;
    const MU: Coefficients = Coefficients {
        mu_slide: 0.2,
        mu_roll: 0.01,
        mu_spin: 0.02,
    };

    fn rotation() -> Rotation<f64> {
        Rotation {
            slide: MU.mu_slide * G,
            roll: MU.mu_roll * G,
            spin: MU.mu_spin * G,
        }
    }

    fn moving(velocity: [f64; 2], spin: [f64; 3]) -> Moving<f64> {
        Moving {
            position: [1.0, 2.0],
            velocity,
            spin,
        }
    }

    fn state(flight: &Flight<f64>, spin: &Spin<f64>, t: f64) -> State {
        let ([x, y], [vx, vy]) = flight.at(t);
        let [wx, wy, wz] = spin.after(t - flight.start);
        State {
            position: Vec3::new(x, y, R),
            velocity: Vec3::new(vx, vy, 0.0),
            spin: Vec3::new(wx, wy, wz),
        }
    }

    #[test]
    fn its_derivative_is_the_rate_of_the_cloth_law_in_every_phase() {
        let cases = [
            ("stun", [2.0, 0.0], [0.0, 0.0, 0.0], true),
            ("draw with side", [0.0, 3.0], [80.0, 10.0, -25.0], true),
            ("massé", [1.0, -2.0], [-30.0, 60.0, 40.0], true),
            ("rolling", [-0.6, 0.9], [-0.9 / R, -0.6 / R, 5.0], false),
        ];
        for (case, velocity, spin, slides) in cases {
            let (flight, turning) = rotation().depart(R, 1.0, moving(velocity, spin));
            assert_eq!(turning.slides, slides, "{case}");
            let h = 1e-4 * (flight.end - flight.start);
            for part in [0.0, 0.4, 0.99] {
                let t = flight.start + part * (flight.end - flight.start);
                let (a, b) = (state(&flight, &turning, t), state(&flight, &turning, t + h));
                let slip = slip_velocity(&a.velocity, &a.spin, R);
                let rates = if slides {
                    sliding(&slip, &a.spin, R, MU, G)
                } else {
                    rolling(&a.velocity, &a.spin, R, MU, G)
                };
                // differences of numbers of size w, divided by h
                let rounding = 16.0 * f64::EPSILON * 100.0 / h;
                let by_velocity = (b.velocity - a.velocity) / h - rates.acceleration;
                let by_spin = (b.spin - a.spin) / h - rates.angular_acceleration;
                assert!(
                    by_velocity.norm() <= rounding,
                    "{case} at {part}: {by_velocity}"
                );
                assert!(by_spin.norm() <= rounding, "{case} at {part}: {by_spin}");
            }
        }
    }

    #[test]
    fn a_slide_ends_in_natural_roll_and_a_roll_at_rest() {
        let start = moving([1.0, -2.0], [-30.0, 60.0, 0.0]);
        let (flight, spin) = rotation().depart(R, 0.0, start);
        assert_eq!(spin.turn, Turn::Roll);
        let rolls = rotation().turned(R, &flight, &spin);
        // v - 2/7 u with u = (1 - R 60, -2 + R -30)
        let want = [
            1.0 - 2.0 / 7.0 * (1.0 - 60.0 * R),
            -2.0 - 2.0 / 7.0 * (-2.0 - 30.0 * R),
        ];
        let off = (rolls.velocity[0] - want[0]).hypot(rolls.velocity[1] - want[1]);
        assert!(off < 1e-15, "{:?} instead of {want:?}", rolls.velocity);
        // the velocity of the flight at its end says the same
        let (_, velocity) = flight.at(flight.end);
        assert!((velocity[0] - want[0]).hypot(velocity[1] - want[1]) < 1e-14);
        let (flight, spin) = rotation().depart(R, flight.end, rolls);
        assert_eq!((spin.turn, spin.slides), (Turn::Stop, false));
        let rests = rotation().turned(R, &flight, &spin);
        assert_eq!((rests.velocity, rests.spin), ([0.0; 2], [0.0; 3]));
        let speed = want[0].hypot(want[1]);
        let distance =
            (rests.position[0] - rolls.position[0]).hypot(rests.position[1] - rolls.position[1]);
        assert!((distance - speed * speed / (2.0 * MU.mu_roll * G)).abs() < 1e-12);
    }

    #[test]
    fn a_dead_stop_has_no_roll_and_spin_about_the_vertical_outlives_it() {
        // w R / v = 2.5 backwards
        let start = moving([2.0, 0.0], [0.0, -2.5 * 2.0 / R, 300.0]);
        let (flight, spin) = rotation().depart(R, 0.0, start);
        let stands = rotation().turned(R, &flight, &spin);
        assert_eq!(
            (stands.velocity, stands.spin[0], stands.spin[1]),
            ([0.0; 2], 0.0, 0.0)
        );
        let (flight, spin) = rotation().depart(R, flight.end, stands);
        assert_eq!((flight.phase, spin.turn), (Phase::Rest, Turn::Unspun));
        let still = rotation().turned(R, &flight, &spin);
        assert_eq!(still.spin, [0.0; 3]);
        let time = 2.0 * R * 300.0 / (5.0 * MU.mu_spin * G);
        assert!(
            (flight.end - time).abs() < 1e-12,
            "{} instead of {time}",
            flight.end
        );
    }

    #[test]
    fn a_ball_that_rolls_goes_on_rolling_when_it_has_spun_down() {
        let mut spins = 0;
        for i in 1..200 {
            // spun down just before it stops, where the velocity is small and its rounding is that of the start
            let v = 0.01 * f64::from(i);
            let stop = v / (MU.mu_roll * G);
            let w = (1.0 - 1e-4) * stop * 5.0 * MU.mu_spin * G / (2.0 * R);
            let velocity = [0.6 * v, -0.8 * v];
            let spin = [-velocity[1] / R, velocity[0] / R, w];
            let (flight, turning) = rotation().depart(R, 0.0, moving(velocity, spin));
            assert_eq!((turning.turn, turning.slides), (Turn::Unspun, false), "{v}");
            let next = rotation().turned(R, &flight, &turning);
            let (_, after) = rotation().depart(R, flight.end, next);
            assert_eq!((after.turn, after.slides), (Turn::Stop, false), "{v}");
            spins += 1;
        }
        assert_eq!(spins, 199);
    }

    #[test]
    fn without_cloth_nothing_changes() {
        let nothing = Rotation {
            slide: 0.0,
            roll: 0.0,
            spin: 0.0,
        };
        let (flight, spin) = nothing.depart(R, 0.0, moving([1.0, 0.0], [3.0, 4.0, 5.0]));
        assert_eq!((flight.phase, flight.end), (Phase::Free, f64::INFINITY));
        assert_eq!((spin.after(9.0), spin.turn), ([3.0, 4.0, 5.0], Turn::Never));
    }
}
