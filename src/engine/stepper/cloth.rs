//! What the cloth does in one step. It acts on every ball in every step, so it is the stepper's one type parameter.
//!
//! Every law follows the report's scheme: a rate times dt, taken at the start of the step, and a clamp where the rate would
//! carry a motion through its end. A speed that would turn round becomes zero, a slip that would turn round becomes rolling
//! with the velocity that the law gives whatever the friction (v - 2/7 u), for the rest of the step; a spin that would turn
//! round becomes zero. So no step overshoots, and what ends does so in the step in which it should, with an error of first
//! order in dt.

use super::balls::Balls;
use crate::math::Vec3;
use crate::physics::Motion;
use crate::physics::cloth::rotational::{self, Coefficients};
use crate::physics::cloth::translational;

/// The end of a phase of motion within a step.
#[derive(Clone, Copy, Debug)]
pub struct PhaseEnd {
    /// Motion at the end of the step.
    pub motion: Motion,
    /// Whether a slide ended, and rolling begins.
    pub slide: bool,
    /// Whether the centre came to rest.
    pub stop: bool,
    /// Whether the spin about the vertical ended.
    pub spin: bool,
}

/// The friction step of a cloth.
pub trait ClothStep: Sized {
    /// Takes every ball on by one step and answers how many move or spin. Balls of which some motion ends within the step are
    /// left as they are, added to `ending`, and not counted.
    fn act(&self, balls: &mut Balls, ending: &mut Vec<usize>) -> usize;

    /// What a step in which some motion ends leaves of ball `i`.
    fn end(&self, balls: &Balls, i: usize) -> PhaseEnd;

    /// The same law for steps of `dt`, s.
    fn in_steps_of(&self, dt: f64) -> Self;

    /// True when a ball that has come to a halt while it slides is set in motion again by its spin.
    fn drives_slides(&self) -> bool {
        false
    }
}

/// Balls that the report's cloth slows together.
const LANES: usize = 8;

/// Balls of such a block that are slowed one by one while the others are at rest.
const FEW: usize = 3;

/// Free flight.
#[derive(Clone, Copy, Debug)]
pub struct NoCloth;

impl ClothStep for NoCloth {
    fn in_steps_of(&self, _dt: f64) -> Self {
        *self
    }

    fn act(&self, balls: &mut Balls, _ending: &mut Vec<usize>) -> usize {
        let moving = balls.moving_centres();
        // spins that nothing slows, under balls that stand
        let spinning = (0..balls.rotation.len())
            .filter(|&i| balls.speed(i) == 0.0 && !balls.is_at_rest(i))
            .count();
        moving + spinning
    }

    fn end(&self, balls: &Balls, i: usize) -> PhaseEnd {
        PhaseEnd::none(balls, i)
    }
}

/// `v <- (-mu g m dt + m v) / m`, to the letter: the mass is divided out after the sum, as the report does it.
#[derive(Clone, Copy, Debug)]
pub struct Translational {
    /// mu g, length/s^2.
    deceleration: f64,
    dt: f64,
}

impl Translational {
    /// The law with coefficient `mu` as a step of length `dt`.
    pub fn new(mu: f64, gravity: f64, dt: f64) -> Self {
        Translational {
            deceleration: translational::deceleration(mu, gravity),
            dt,
        }
    }

    /// Speed after a step, length/s; a ball with none left, or less, halts.
    #[inline(always)]
    fn slowed(&self, speed: f64, mass: f64) -> f64 {
        (-self.deceleration * mass * self.dt + mass * speed) / mass
    }

    /// Slows a block of which most balls move, from the squares of their speeds.
    #[inline(always)]
    fn slow_all(
        &self,
        block: usize,
        squares: [f64; LANES],
        vx: &mut [f64],
        vy: &mut [f64],
        mass: &[f64],
        ending: &mut Vec<usize>,
    ) -> usize {
        let mut moving = 0;
        let mut halting = [false; LANES];
        let mut ends = false;
        let lanes = vx.iter_mut().zip(vy).zip(mass);
        let results = squares.iter().zip(&mut halting);
        // no branch inside: the compiler turns the block into wide lanes
        for (((vx, vy), &mass), (square, halting)) in lanes.zip(results) {
            let speed = square.sqrt();
            let slowed = self.slowed(speed, mass);
            let halts = slowed <= 0.0;
            // a ball at rest would halt too: it is left alone
            let factor = if halts { 1.0 } else { slowed / speed };
            *vx *= factor;
            *vy *= factor;
            *halting = halts & (*square != 0.0);
            ends |= *halting;
            moving += usize::from(!halts);
        }
        if ends {
            let halting = halting.iter().enumerate().filter(|(_, halts)| **halts);
            ending.extend(halting.map(|(lane, _)| block * LANES + lane));
        }
        moving
    }

    /// Slows a block of which most balls are at rest, from the squares of their speeds.
    #[inline(always)]
    fn slow_few(
        &self,
        block: usize,
        squares: [f64; LANES],
        vx: &mut [f64],
        vy: &mut [f64],
        mass: &[f64],
        ending: &mut Vec<usize>,
    ) -> usize {
        let mut moving = 0;
        let lanes = vx.iter_mut().zip(vy).zip(mass).zip(squares);
        for (lane, (((vx, vy), &mass), square)) in lanes.enumerate() {
            if square == 0.0 {
                continue;
            }
            let speed = square.sqrt();
            let slowed = self.slowed(speed, mass);
            if slowed <= 0.0 {
                ending.push(block * LANES + lane);
                continue;
            }
            let factor = slowed / speed;
            *vx *= factor;
            *vy *= factor;
            moving += 1;
        }
        moving
    }
}

impl ClothStep for Translational {
    fn in_steps_of(&self, dt: f64) -> Self {
        Translational { dt, ..*self }
    }

    fn act(&self, balls: &mut Balls, ending: &mut Vec<usize>) -> usize {
        let mut moving = 0;
        let velocities = balls.vx.chunks_mut(LANES).zip(balls.vy.chunks_mut(LANES));
        let blocks = velocities.zip(balls.mass.chunks(LANES));
        for (block, ((vx, vy), mass)) in blocks.enumerate() {
            let mut squares = [0.0; LANES];
            let mut live = 0;
            for ((square, vx), vy) in squares.iter_mut().zip(&*vx).zip(&*vy) {
                *square = *vx * *vx + *vy * *vy;
                // a root is zero where its square is
                live += usize::from(*square != 0.0);
            }
            if live > FEW {
                moving += self.slow_all(block, squares, vx, vy, mass, ending);
            } else if live > 0 {
                moving += self.slow_few(block, squares, vx, vy, mass, ending);
            }
        }
        moving
    }

    fn end(&self, balls: &Balls, i: usize) -> PhaseEnd {
        let mut end = PhaseEnd::none(balls, i);
        end.motion.velocity = Vec3::zeros();
        end.stop = true;
        end
    }
}

/// Slide, roll and spin-down.
#[derive(Clone, Copy, Debug)]
pub struct Rotational {
    mu: Coefficients,
    gravity: f64,
    dt: f64,
}

impl Rotational {
    /// The law as a step of length `dt`.
    pub fn new(mu: Coefficients, gravity: f64, dt: f64) -> Self {
        Rotational { mu, gravity, dt }
    }

    /// Motion after a step; `None` if some part of it ends within the step.
    fn moved(&self, motion: &Motion, radius: f64, slides: bool) -> Option<Motion> {
        let Rotational { mu, gravity, dt } = *self;
        let Motion { velocity, spin } = *motion;
        if spin.z != 0.0 && spin.z.abs() <= self.spin_step(radius) {
            return None;
        }
        if slides {
            let slip = rotational::slip_velocity(&velocity, &spin, radius);
            if slip.norm() <= self.slip_step() {
                return None;
            }
            let rates = rotational::sliding(&slip, &spin, radius, mu, gravity);
            return Some(Motion {
                velocity: velocity + rates.acceleration * dt,
                spin: spin + rates.angular_acceleration * dt,
            });
        }
        if velocity != Vec3::zeros() && velocity.norm() <= self.roll_step() {
            return None;
        }
        let rates = rotational::rolling(&velocity, &spin, radius, mu, gravity);
        let velocity = velocity + rates.acceleration * dt;
        // a ball that rolls turns with its velocity: nothing accumulates
        let mut turning = rotational::rolling_spin(&velocity, radius);
        turning.z = spin.z + rates.angular_acceleration.z * dt;
        Some(Motion {
            velocity,
            spin: turning,
        })
    }

    /// Velocity of a ball that rolls after `time`; zero if it stops by then.
    fn rolled(&self, velocity: Vec3, time: f64) -> Vec3 {
        let (speed, lost) = (velocity.norm(), self.mu.mu_roll * self.gravity * time);
        if speed <= lost {
            Vec3::zeros()
        } else {
            velocity * (1.0 - lost / speed)
        }
    }

    /// Change of the slip in one step, length/s: it falls at 7/2 of the rate of the centre.
    fn slip_step(&self) -> f64 {
        3.5 * self.mu.mu_slide * self.gravity * self.dt
    }

    /// Change of the speed of a rolling ball in one step, length/s.
    fn roll_step(&self) -> f64 {
        self.mu.mu_roll * self.gravity * self.dt
    }

    /// Change of the spin about the vertical in one step, rad/s.
    fn spin_step(&self, radius: f64) -> f64 {
        rotational::spin_deceleration(self.mu.mu_spin, self.gravity, radius) * self.dt
    }
}

impl ClothStep for Rotational {
    fn in_steps_of(&self, dt: f64) -> Self {
        Rotational { dt, ..*self }
    }

    fn act(&self, balls: &mut Balls, ending: &mut Vec<usize>) -> usize {
        let mut moving = 0;
        for i in 0..balls.len() {
            let (motion, radius) = (balls.motion(i), balls.radius[i]);
            if motion.velocity == Vec3::zeros() && motion.spin == Vec3::zeros() {
                // the last step of a slide took the whole of both: it has ended
                if balls.slides(i) {
                    ending.push(i);
                }
                continue;
            }
            match self.moved(&motion, radius, balls.slides(i)) {
                Some(moved) => {
                    balls.keep_motion(i, &moved);
                    moving += 1;
                }
                None => ending.push(i),
            }
        }
        moving
    }

    fn end(&self, balls: &Balls, i: usize) -> PhaseEnd {
        let Rotational { mu, gravity, dt } = *self;
        let mut end = PhaseEnd::none(balls, i);
        let (Motion { velocity, spin }, radius) = (end.motion, balls.radius[i]);
        let slip = rotational::slip_velocity(&velocity, &spin, radius);
        let sliding = balls.slides(i) && slip.norm() > self.slip_step();
        let (next, mut turning) = if sliding {
            let rates = rotational::sliding(&slip, &spin, radius, mu, gravity);
            (
                velocity + rates.acceleration * dt,
                spin + rates.angular_acceleration * dt,
            )
        } else {
            let next = if balls.slides(i) {
                // it rolls for what is left of the step: without that a pair whose exchanges make it slip anew in every step
                // would never lose its common velocity
                let slid = rotational::slide_time(slip.norm(), mu.mu_slide, gravity);
                self.rolled(
                    rotational::natural_roll(&velocity, &slip),
                    (dt - slid).max(0.0),
                )
            } else {
                self.rolled(velocity, dt)
            };
            end.stop = next == Vec3::zeros() && (balls.slides(i) || velocity != next);
            end.slide = balls.slides(i) && !end.stop;
            (next, rotational::rolling_spin(&next, radius))
        };
        end.spin = spin.z != 0.0 && spin.z.abs() <= self.spin_step(radius);
        turning.z = if end.spin {
            0.0
        } else {
            rotational::spun_down(spin.z, radius, mu.mu_spin, gravity, dt)
        };
        end.motion = Motion {
            velocity: next,
            spin: turning,
        };
        end
    }

    fn drives_slides(&self) -> bool {
        self.mu.mu_slide * self.gravity > 0.0
    }
}

impl PhaseEnd {
    /// The motion of ball `i` as it is, and nothing that ends.
    fn none(balls: &Balls, i: usize) -> Self {
        PhaseEnd {
            motion: balls.motion(i),
            slide: false,
            stop: false,
            spin: false,
        }
    }
}
