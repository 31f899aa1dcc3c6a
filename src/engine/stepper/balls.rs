//! The balls in play, as the arrays that a step walks through.
//!
//! What a scene does not call for has no array: without rotation there is no spin, and a ball that left play is in none of
//! them.

use super::{Launch, Settings};
use crate::math::Vec3;
use crate::math::angle::unit_vector;
use crate::physics::cloth::rotational;
use crate::physics::cue::speed_from_force;
use crate::physics::{Body, Motion, State};
use crate::scene::{Ball, Scene, Shot};
use nalgebra::Vector2;

/// A ball whose slip is smaller than this, relative to the speeds it is the difference of, rolls: a few roundings.
const ROLLS: f64 = 8.0 * f64::EPSILON;

/// The balls as arrays. First the ball that was shot, then the others in scene order: the report's order of pairs.
#[derive(Clone, Debug)]
pub struct Balls {
    /// Index in the scene.
    pub scene_index: Vec<usize>,
    /// Centre x, length.
    pub x: Vec<f64>,
    /// Centre y, length.
    pub y: Vec<f64>,
    /// Velocity x, length/s.
    pub vx: Vec<f64>,
    /// Velocity y, length/s.
    pub vy: Vec<f64>,
    /// Mass.
    pub mass: Vec<f64>,
    /// Radius, length.
    pub radius: Vec<f64>,
    /// How each ball turns; empty where the scene does not call for rotation.
    pub rotation: Vec<Rotation>,
    /// Number of balls in the scene.
    listed: usize,
}

/// How a ball turns.
#[derive(Clone, Copy, Debug)]
pub struct Rotation {
    /// rad/s.
    pub spin: Vec3,
    /// Moment of inertia.
    pub inertia: f64,
    /// Whether its lowest point moves over the cloth.
    pub slides: bool,
}

impl Balls {
    /// The balls of a scene before the first step.
    pub fn new(scene: &Scene, settings: &Settings) -> Self {
        let cue = scene.cue_ball();
        let mut scene_index = vec![cue];
        scene_index.extend((0..scene.balls.len()).filter(|&i| i != cue));
        let ball = |&i: &usize| &scene.balls[i];
        let column = |value: fn(&Ball) -> f64| scene_index.iter().map(|i| value(ball(i))).collect();
        let starts: Vec<State> = scene_index.iter().map(|i| scene.start(*i)).collect();
        let turning = |(&i, start): (&usize, &State)| {
            Some(Rotation {
                spin: start.spin,
                inertia: scene.inertia(i)?,
                slides: false,
            })
        };
        let mut balls = Balls {
            x: column(|b| b.state.position.x),
            y: column(|b| b.state.position.y),
            vx: starts.iter().map(|start| start.velocity.x).collect(),
            vy: starts.iter().map(|start| start.velocity.y).collect(),
            mass: column(|b| b.mass),
            radius: column(|b| b.radius),
            rotation: scene_index
                .iter()
                .zip(&starts)
                .filter_map(turning)
                .collect(),
            listed: scene.balls.len(),
            scene_index,
        };
        if let (
            Launch::AsWritten,
            Some(Shot::Force {
                angle_deg, force, ..
            }),
        ) = (settings.launch, scene.shot)
        {
            let speed = speed_from_force(force, settings.dt, balls.mass[0]);
            let (c, s) = unit_vector(angle_deg);
            (balls.vx[0], balls.vy[0]) = (speed * c, speed * s);
        }
        for i in 0..balls.rotation.len() {
            balls.rotation[i].slides = balls.slips(i);
        }
        balls
    }

    /// Number of balls in play.
    pub fn len(&self) -> usize {
        self.x.len()
    }

    /// Speed of the centre, length/s.
    pub fn speed(&self, i: usize) -> f64 {
        (self.vx[i] * self.vx[i] + self.vy[i] * self.vy[i]).sqrt()
    }

    /// Spin, rad/s; zero where the scene does not call for rotation.
    pub fn spin(&self, i: usize) -> Vec3 {
        self.rotation.get(i).map_or_else(Vec3::zeros, |r| r.spin)
    }

    /// True when velocity and spin are zero.
    pub fn is_at_rest(&self, i: usize) -> bool {
        self.speed(i) == 0.0 && self.rotation.get(i).is_none_or(|r| r.spin == Vec3::zeros())
    }

    /// True when velocity and spin are zero to the bit: nothing is left that an exchange could pass on.
    pub fn is_still(&self, i: usize) -> bool {
        self.vx[i] == 0.0 && self.vy[i] == 0.0 && self.spin(i) == Vec3::zeros()
    }

    /// Number of balls whose centre moves.
    pub fn moving_centres(&self) -> usize {
        let velocities = self.vx.iter().zip(&self.vy);
        velocities
            // a root is zero where its square is
            .filter(|(vx, vy)| *vx * *vx + *vy * *vy != 0.0)
            .count()
    }

    /// Number of balls that are not at rest.
    pub fn moving(&self) -> usize {
        (0..self.len()).filter(|&i| !self.is_at_rest(i)).count()
    }

    /// True when a ball slides over the cloth.
    pub fn slides(&self, i: usize) -> bool {
        self.rotation.get(i).is_some_and(|r| r.slides)
    }

    /// Kinetic energy, rotation included where the scene calls for it.
    pub fn energy(&self, i: usize) -> f64 {
        let translation = 0.5 * self.mass[i] * (self.vx[i] * self.vx[i] + self.vy[i] * self.vy[i]);
        match self.rotation.get(i) {
            Some(r) => translation + 0.5 * r.inertia * r.spin.norm_squared(),
            None => translation,
        }
    }

    /// Centre in plan, length.
    pub fn position(&self, i: usize) -> Vector2<f64> {
        Vector2::new(self.x[i], self.y[i])
    }

    /// What an impact law needs to know.
    pub fn body(&self, i: usize) -> Body {
        Body {
            velocity: Vec3::new(self.vx[i], self.vy[i], 0.0),
            spin: self.spin(i),
            mass: self.mass[i],
            radius: self.radius[i],
        }
    }

    /// State in the scene's frame.
    pub fn state(&self, i: usize) -> State {
        State {
            position: Vec3::new(self.x[i], self.y[i], self.radius[i]),
            velocity: Vec3::new(self.vx[i], self.vy[i], 0.0),
            spin: self.spin(i),
        }
    }

    /// States in scene order; a ball that left play has none, and zeros stand in its place.
    pub fn states(&self) -> Vec<State> {
        let mut states = Vec::new();
        self.read(&mut states);
        states
    }

    /// Replaces `states` by [`Balls::states`].
    pub fn read(&self, states: &mut Vec<State>) {
        states.clear();
        states.resize(self.listed, State::at_rest(Vec3::zeros()));
        for (i, &ball) in self.scene_index.iter().enumerate() {
            states[ball].position = Vec3::new(self.x[i], self.y[i], self.radius[i]);
            states[ball].velocity = Vec3::new(self.vx[i], self.vy[i], 0.0);
        }
        for (rotation, &ball) in self.rotation.iter().zip(&self.scene_index) {
            states[ball].spin = rotation.spin;
        }
    }

    /// Velocity and spin.
    pub fn motion(&self, i: usize) -> Motion {
        Motion {
            velocity: Vec3::new(self.vx[i], self.vy[i], 0.0),
            spin: self.spin(i),
        }
    }

    /// The motion of a ball that slides or rolls as before.
    pub fn keep_motion(&mut self, i: usize, motion: &Motion) {
        (self.vx[i], self.vy[i]) = (motion.velocity.x, motion.velocity.y);
        if let Some(rotation) = self.rotation.get_mut(i) {
            rotation.spin = motion.spin;
        }
    }

    /// What an impact left of the motion of a ball, which then slides or rolls. The table keeps it from moving up or down.
    pub fn set_motion(&mut self, i: usize, motion: &Motion) {
        self.keep_motion(i, motion);
        if i < self.rotation.len() {
            self.rotation[i].slides = self.slips(i);
        }
    }

    /// Takes balls out of play, by ascending index; those after them move up.
    pub fn remove(&mut self, leaving: &[usize]) {
        remove(&mut self.scene_index, leaving);
        for column in [
            &mut self.x,
            &mut self.y,
            &mut self.vx,
            &mut self.vy,
            &mut self.mass,
            &mut self.radius,
        ] {
            remove(column, leaving);
        }
        if !self.rotation.is_empty() {
            remove(&mut self.rotation, leaving);
        }
    }

    /// True when the lowest point of a ball moves over the cloth by more than rounding.
    fn slips(&self, i: usize) -> bool {
        let (velocity, spin, radius) = (self.body(i).velocity, self.spin(i), self.radius[i]);
        let slip = rotational::slip_velocity(&velocity, &spin, radius);
        slip.norm() > ROLLS * (velocity.norm() + radius * spin.xy().norm())
    }
}

/// Removes the items at some indices, ascending, in one pass.
pub fn remove<T>(column: &mut Vec<T>, leaving: &[usize]) {
    let (mut index, mut next) = (0, 0);
    column.retain(|_| {
        let leaves = leaving.get(next) == Some(&index);
        next += usize::from(leaves);
        index += 1;
        !leaves
    });
}
