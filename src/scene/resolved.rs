//! The scene that engines see: nothing implicit.

use super::choices::{SetName, Simultaneous};
use super::tried::Tried;
use crate::math::Vec3;
use crate::math::angle::unit_vector;
use crate::physics::cloth::rotational;
use crate::physics::contact::plan_distance;
use crate::physics::cue::{Strike, speed_from_force};
use crate::physics::invariants::{kinetic_energy, sphere_inertia};
use crate::physics::{Cloth, Effects, Motion, Side, State};
use serde::{Serialize, Serializer};
use sha2::{Digest, Sha256};

/// A resolved scene: every ball explicit, every default applied, the shot already in the balls' velocities.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Scene {
    /// Unique kebab-case name.
    pub name: String,
    /// One or two sentences: what it is and what would be right.
    pub description: String,
    /// Sets that it belongs to.
    pub sets: Vec<SetName>,
    /// Longest simulated time, s, > 0.
    pub duration: f64,
    /// Whether the run goes on to `duration` after everything has come to rest.
    pub run_to_duration: bool,
    /// Gravity, length/s^2, >= 0; 0 where no law uses it.
    pub gravity: f64,
    /// What the numbers are measured in.
    pub units: Units,
    /// Edges of the table; `None` is an unbounded plane.
    pub table: Option<Table>,
    /// All balls in scene order: `[[balls]]` first, then the rack. At least one.
    pub balls: Vec<Ball>,
    /// How the first ball was set in motion, if the scene says it by a shot.
    pub shot: Option<Shot>,
    /// The effects that the scene calls for.
    pub effects: Effects,
    /// What to do when an impact involves touching balls.
    pub simultaneous: Simultaneous,
    /// Name of the scene with more effects that this one is a model of.
    pub richer: Option<String>,
    /// Engines with settings that the scene wants to be tried besides the presets.
    #[serde(rename = "try")]
    pub try_settings: Vec<Tried>,
}

/// One ball of a resolved scene.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Ball {
    /// Name used in files and reports; unique.
    pub id: String,
    /// Radius, length, > 0.
    pub radius: f64,
    /// Mass, > 0.
    pub mass: f64,
    /// State at time 0; z of the centre is the radius.
    #[serde(serialize_with = "state_as_arrays")]
    pub state: State,
}

/// Edges of the playing surface. A ball's centre stays `radius` inside where the scene has cushions.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Table {
    /// Smallest x and y, length.
    pub min: [f64; 2],
    /// Largest x and y, length.
    pub max: [f64; 2],
}

/// What the numbers of a scene are measured in; names only, unless a law needs SI.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Units {
    /// Name of the length unit.
    pub length: String,
    /// Metres per length unit, where known.
    pub length_in_metres: Option<f64>,
    /// Name of the mass unit.
    pub mass: String,
    /// Kilograms per mass unit, where known.
    pub mass_in_kg: Option<f64>,
    /// Name of the time unit.
    pub time: String,
}

/// How a ball was set in motion. Its velocity in [`Scene::balls`] already contains it.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Shot {
    /// `v = force * contact_time / mass` along the angle.
    Force {
        /// Index of the ball in [`Scene::balls`].
        ball: usize,
        /// Direction, degrees counter-clockwise from +x.
        angle_deg: f64,
        /// Force, mass * length/s^2.
        force: f64,
        /// Time for which it acts, s.
        contact_time: f64,
    },
    /// A speed given directly.
    Velocity {
        /// Index of the ball in [`Scene::balls`].
        ball: usize,
        /// Direction, degrees counter-clockwise from +x.
        angle_deg: f64,
        /// Speed, length/s.
        speed: f64,
    },
    /// A cue that strikes the ball; the ball's spin contains it too.
    Strike {
        /// Index of the ball in [`Scene::balls`].
        ball: usize,
        /// What strikes it, and where.
        #[serde(flatten)]
        strike: Strike,
    },
}

impl Units {
    /// Unit of a speed, as printed.
    pub fn speed(&self) -> String {
        format!("{}/{}", self.length, self.time)
    }

    /// Unit of an acceleration, as printed.
    pub fn acceleration(&self) -> String {
        format!("{}/{}^2", self.length, self.time)
    }
}

impl Shot {
    /// Index of the ball that is shot.
    pub fn ball(&self) -> usize {
        match *self {
            Shot::Force { ball, .. } | Shot::Velocity { ball, .. } | Shot::Strike { ball, .. } => {
                ball
            }
        }
    }
}

impl Scene {
    /// Whether it belongs to a set.
    pub fn is_in(&self, set: SetName) -> bool {
        self.sets.contains(&set)
    }

    /// Index of the cue ball: the shot's ball, else the first in scene order.
    pub fn cue_ball(&self) -> usize {
        self.shot.map_or(0, |shot| shot.ball())
    }

    /// Index of the ball called `id`.
    pub fn ball_index(&self, id: &str) -> Option<usize> {
        self.balls.iter().position(|ball| ball.id == id)
    }

    /// State with which ball `i` starts in every engine: as the scene gives it, but what rolls to six digits over a cloth that would make it roll
    /// rolls ([`rotational::as_meant`]).
    pub fn start(&self, i: usize) -> State {
        self.started(i, |motion, radius| {
            Some(rotational::as_meant(motion, radius))
        })
    }

    /// The same where it rolls, with the spin of natural roll to the last digit; as the scene gives it where it does not.
    pub fn rolling_start(&self, i: usize) -> State {
        self.started(i, rotational::rolling_start)
    }

    fn started(&self, i: usize, rule: fn(&Motion, f64) -> Option<Motion>) -> State {
        let Ball { radius, state, .. } = &self.balls[i];
        let grips = match self.effects.cloth {
            Some(Cloth::Rotational { mu_slide, .. }) => mu_slide * self.gravity > 0.0,
            Some(Cloth::Translational { .. }) | None => false,
        };
        let given = Motion {
            velocity: state.velocity,
            spin: state.spin,
        };
        let motion = grips.then(|| rule(&given, *radius)).flatten();
        let Motion { velocity, spin } = motion.unwrap_or(given);
        State {
            velocity,
            spin,
            ..*state
        }
    }

    /// States of all balls at time 0 as the scene gives them, in scene order.
    pub fn initial_states(&self) -> Vec<State> {
        self.balls.iter().map(|ball| ball.state).collect()
    }

    /// The smallest radius, length: the unit `R` in which lengths are compared.
    pub fn smallest_radius(&self) -> f64 {
        self.balls
            .iter()
            .map(|ball| ball.radius)
            .fold(f64::INFINITY, f64::min)
    }

    /// The largest initial speed, length/s: the unit in which speeds are compared. 0 when nothing moves.
    pub fn largest_speed(&self) -> f64 {
        self.balls
            .iter()
            .map(|ball| ball.state.speed())
            .fold(0.0, f64::max)
    }

    /// The largest absolute coordinate of table and balls, length: the scale of position rounding.
    pub fn largest_coordinate(&self) -> f64 {
        let table = self
            .table
            .iter()
            .flat_map(|t| [t.min[0], t.min[1], t.max[0], t.max[1]]);
        let balls = self
            .balls
            .iter()
            .flat_map(|b| [b.state.position.x, b.state.position.y]);
        table
            .chain(balls)
            .fold(0.0, |largest: f64, x| largest.max(x.abs()))
    }

    /// Two surfaces closer than this touch, length: `1e-12 R + 8 ulp` of the largest coordinate.
    pub fn touching(&self) -> f64 {
        1e-12 * self.smallest_radius() + 8.0 * f64::EPSILON * self.largest_coordinate()
    }

    /// No coordinate gets larger, length: without cushions, by the longest way of the fastest ball; a cloth that turns balls lets them roll on.
    pub fn farthest_coordinate(&self) -> f64 {
        if self.effects.cushion.is_some() {
            return self.largest_coordinate();
        }
        let fastest = self.fastest();
        let duration = match self.effects.cloth {
            Some(Cloth::Translational { mu }) if mu * self.gravity > 0.0 => {
                self.duration.min(fastest / (mu * self.gravity))
            }
            _ => self.duration,
        };
        self.largest_coordinate() + fastest * duration
    }

    /// No ball is ever faster, length/s: all kinetic energy in the lightest.
    pub fn fastest(&self) -> f64 {
        let masses = self.balls.iter().map(|ball| ball.mass);
        let lightest = masses.fold(f64::INFINITY, f64::min);
        (2.0 * (self.initial_energy() / lightest)).sqrt()
    }

    /// What the place of a ball is good to at an event that is solved for in f64, length; also how far such an engine may leave a
    /// ball outside or in another one.
    ///
    /// [`Scene::touching`], and 8 ulp of the longest way that a ball can go: the time of an event is one number, and so is a
    /// velocity. A speed that is noise (8 ulp of the fastest possible) moves a ball by that much until the end, and two ulp of the
    /// clock do less.
    pub fn position_uncertainty(&self) -> f64 {
        self.position_uncertainty_within(self.largest_coordinate(), self.duration)
    }

    /// The same of a run up to `time`, s, in which no coordinate is larger than `extent`, length.
    pub fn position_uncertainty_within(&self, extent: f64, time: f64) -> f64 {
        let way = self.fastest() * time;
        1e-12 * self.smallest_radius() + 8.0 * f64::EPSILON * (extent + way)
    }

    /// Distance of the centres at which balls `a` and `b` touch, seen in plan, length.
    pub fn contact_distance(&self, a: usize, b: usize) -> f64 {
        plan_distance(self.balls[a].radius, self.balls[b].radius)
    }

    /// The mass of the heaviest ball in that of the lightest.
    pub fn mass_ratio(&self) -> f64 {
        let masses = || self.balls.iter().map(|ball| ball.mass);
        masses().fold(0.0, f64::max) / masses().fold(f64::INFINITY, f64::min)
    }

    /// True when all balls have the same mass.
    pub fn equal_masses(&self) -> bool {
        self.balls
            .iter()
            .all(|ball| ball.mass == self.balls[0].mass)
    }

    /// True when all balls have the same radius.
    pub fn equal_radii(&self) -> bool {
        self.balls
            .iter()
            .all(|ball| ball.radius == self.balls[0].radius)
    }

    /// Moment of inertia of ball `i`, or `None` where the scene does not call for rotation.
    pub fn inertia(&self, i: usize) -> Option<f64> {
        let ball = &self.balls[i];
        self.effects
            .rotates()
            .then(|| sphere_inertia(ball.mass, ball.radius))
    }

    /// Kinetic energy of all balls at the given states, mass * length^2/s^2. `states` is in scene order.
    pub fn kinetic_energy(&self, states: &[State]) -> f64 {
        let energy = |(i, state): (usize, &State)| {
            kinetic_energy(state, self.balls[i].mass, self.inertia(i))
        };
        states.iter().enumerate().map(energy).sum()
    }

    /// Kinetic energy at time 0.
    pub fn initial_energy(&self) -> f64 {
        self.kinetic_energy(&self.initial_states())
    }

    /// Where the centre of a ball of radius `radius` may be along the axis of `side`, length.
    pub fn reach(&self, side: Side, radius: f64) -> Option<f64> {
        self.table.map(|t| t.reach(side, radius))
    }

    /// The same scene with its force acting for `contact_time` instead; `None` unless the shot is a force.
    pub fn launched_for(&self, contact_time: f64) -> Option<Scene> {
        let Some(Shot::Force {
            ball,
            angle_deg,
            force,
            ..
        }) = self.shot
        else {
            return None;
        };
        let mut scene = self.clone();
        scene.shot = Some(Shot::Force {
            ball,
            angle_deg,
            force,
            contact_time,
        });
        let speed = speed_from_force(force, contact_time, self.balls[ball].mass);
        scene.balls[ball].state.velocity = plan_vector(speed, angle_deg);
        Some(scene)
    }

    /// Fingerprint of the resolved scene: 16 hexadecimal digits, equal for scenes that are equal to the bit.
    pub fn hash(&self) -> String {
        let text = serde_json::to_string(self).unwrap_or_default();
        let digest = Sha256::digest(text.as_bytes());
        digest
            .iter()
            .take(8)
            .map(|byte| format!("{byte:02x}"))
            .collect()
    }
}

impl Table {
    /// Largest (or, for the sides at the small end, smallest) coordinate that the centre of a ball may have, length.
    pub fn reach(&self, side: Side, radius: f64) -> f64 {
        let axis = side.axis();
        if side.sign() < 0 {
            self.min[axis] + radius
        } else {
            self.max[axis] - radius
        }
    }
}

/// A horizontal vector of the given length and direction.
///
/// `angle_deg`: degrees counter-clockwise from +x.
pub fn plan_vector(length: f64, angle_deg: f64) -> Vec3 {
    let (c, s) = unit_vector(angle_deg);
    Vec3::new(length * c, length * s, 0.0)
}

fn state_as_arrays<S: Serializer>(state: &State, serializer: S) -> Result<S::Ok, S::Error> {
    let as_array = |v: &Vec3| [v.x, v.y, v.z];
    let arrays = [
        as_array(&state.position),
        as_array(&state.velocity),
        as_array(&state.spin),
    ];
    arrays.serialize(serializer)
}
