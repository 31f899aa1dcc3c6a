//! The step loop: the report's order of operations, and what each step tells the recorder.

use super::cloth::{self, ClothStep, NoCloth};
use super::contact::{Partner, Sizes, exchange};
use super::{ContactRule, Launch, Settings};
use crate::engine::setting::parameters;
use crate::engine::{Inside, Limits, PairMaterial, Parameter, Partner as Meets, Role, Run};
use crate::math::Vec3;
use crate::math::angle::unit_vector;
use crate::physics::cue::speed_from_force;
use crate::physics::{Body, Contact, Cushion, Side, State, cushion};
use crate::scene::{Scene, Shot};
use crate::trace::{Ending, EventKind, Provenance, Record, Recorder, Spot, Trace};
use nalgebra::Vector2;
use std::collections::BTreeMap;

/// A scene inside the stepper, before its first step.
#[derive(Debug)]
pub struct Stepping<'a> {
    scene: &'a Scene,
    settings: Settings,
    version: String,
    balls: Balls,
}

/// The balls as arrays. Index 0 is the ball that was shot, the others follow in scene order: the report's order of pairs.
#[derive(Clone, Debug)]
struct Balls {
    scene_index: Vec<usize>,
    x: Vec<f64>,
    y: Vec<f64>,
    vx: Vec<f64>,
    vy: Vec<f64>,
    mass: Vec<f64>,
    radius: Vec<f64>,
}

impl Balls {
    fn new(scene: &Scene, settings: &Settings) -> Self {
        let cue = scene.cue_ball();
        let mut scene_index = vec![cue];
        scene_index.extend((0..scene.balls.len()).filter(|&i| i != cue));
        let ball = |&i: &usize| &scene.balls[i];
        let column = |value: fn(&crate::scene::Ball) -> f64| {
            scene_index.iter().map(|i| value(ball(i))).collect()
        };
        let mut balls = Balls {
            x: column(|b| b.state.position.x),
            y: column(|b| b.state.position.y),
            vx: column(|b| b.state.velocity.x),
            vy: column(|b| b.state.velocity.y),
            mass: column(|b| b.mass),
            radius: column(|b| b.radius),
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
        balls
    }

    fn len(&self) -> usize {
        self.x.len()
    }

    fn velocity(&self, i: usize) -> Vector2<f64> {
        Vector2::new(self.vx[i], self.vy[i])
    }

    fn speed(&self, i: usize) -> f64 {
        (self.vx[i] * self.vx[i] + self.vy[i] * self.vy[i]).sqrt()
    }

    fn energy(&self, i: usize) -> f64 {
        0.5 * self.mass[i] * (self.vx[i] * self.vx[i] + self.vy[i] * self.vy[i])
    }

    fn partner(&self, i: usize) -> Partner {
        Partner {
            position: Vector2::new(self.x[i], self.y[i]),
            velocity: self.velocity(i),
            mass: self.mass[i],
            radius: self.radius[i],
        }
    }

    fn state(&self, i: usize) -> State {
        State {
            position: Vec3::new(self.x[i], self.y[i], self.radius[i]),
            velocity: Vec3::new(self.vx[i], self.vy[i], 0.0),
            spin: Vec3::zeros(),
        }
    }

    /// States in scene order.
    fn states(&self) -> Vec<State> {
        let mut states = vec![State::at_rest(Vec3::zeros()); self.len()];
        for (i, &ball) in self.scene_index.iter().enumerate() {
            states[ball] = self.state(i);
        }
        states
    }
}

impl<'a> Stepping<'a> {
    pub fn new(scene: &'a Scene, settings: Settings, version: String) -> Self {
        let balls = Balls::new(scene, &settings);
        Stepping {
            scene,
            settings,
            version,
            balls,
        }
    }

    fn provenance(&self) -> Provenance {
        Provenance {
            engine: "stepper".to_owned(),
            version: self.version.clone(),
            parameters: parameters(&self.settings),
            scene: self.scene.name.clone(),
            scene_hash: self.scene.hash(),
            resolution: self.settings.dt,
            rest_speed: 0.0,
        }
    }
}

impl Run for Stepping<'_> {
    fn inside(&self) -> Inside {
        let scene = self.scene;
        let energy = (0..self.balls.len()).map(|i| self.balls.energy(i)).sum();
        let mut balls = scene.balls.clone();
        for (i, &ball) in self.balls.scene_index.iter().enumerate() {
            balls[ball].state = self.balls.state(i);
            balls[ball].mass = self.balls.mass[i];
            balls[ball].radius = self.balls.radius[i];
        }
        let mut materials = Vec::new();
        for ball in 0..balls.len() {
            let mut meets = |partner, friction, restitution| {
                materials.push(PairMaterial {
                    ball,
                    partner,
                    friction,
                    restitution,
                });
            };
            if let Some(Contact::Elastic {}) = scene.effects.contact {
                meets(Meets::Ball, 0.0, 1.0);
            }
            if let Some(cloth) =
                cloth::translational(&scene.effects, scene.gravity, self.settings.dt)
            {
                meets(Meets::Cloth, cloth.mu(), 0.0);
            }
            if let Some(Cushion::Elastic {}) = scene.effects.cushion {
                meets(Meets::Cushion, 0.0, 1.0);
            }
        }
        let replaced = match self.settings.launch {
            Launch::ContactTime => None,
            Launch::AsWritten => Some(self.settings.dt),
        };
        Inside {
            inertia: vec![None; balls.len()],
            balls,
            energy,
            materials,
            ulp: f64::EPSILON,
            contact_time: replaced,
        }
    }

    fn sheet(&self) -> Vec<Parameter> {
        let scene = self.scene;
        let settings = &self.settings;
        let mut sheet = vec![
            Parameter::new(Role::TimeStep, "dt", settings.dt, "s"),
            Parameter::new(Role::Precision, "scalar", "f64", ""),
            Parameter::new(Role::Rotation, "rotation", "none", ""),
            Parameter::new(
                Role::PositionCorrection,
                "walls",
                "a ball past a wall is moved to it",
                "",
            ),
            Parameter::new(Role::Rest, "speed clamped at", 0, &scene.units.speed()),
        ];
        let launch = match (scene.shot, settings.launch) {
            (Some(Shot::Force { force, .. }), Launch::AsWritten) => format!("{force} * dt / m"),
            (
                Some(Shot::Force {
                    force,
                    contact_time,
                    ..
                }),
                Launch::ContactTime,
            ) => {
                format!("{force} * {contact_time} s / m")
            }
            _ => "velocity of the scene".to_owned(),
        };
        sheet.push(Parameter::new(Role::Launch, "launch", launch, ""));
        let detection = match settings.contact {
            ContactRule::AsWritten => "overlap at a step, every step",
            ContactRule::ApproachingOnly => "overlap at a step, if approaching",
        };
        if scene.effects.contact.is_some() {
            sheet.push(Parameter::new(
                Role::ContactDetection,
                "contact",
                detection,
                "",
            ));
            sheet.push(Parameter::new(
                Role::BallRestitution,
                "exchange of normal velocities",
                "e = 1",
                "",
            ));
            sheet.push(Parameter::new(
                Role::BallFriction,
                "tangential impulse",
                0,
                "",
            ));
        }
        if let Some(cloth) = cloth::translational(&scene.effects, scene.gravity, settings.dt) {
            sheet.push(Parameter::new(Role::ClothFriction, "mu", cloth.mu(), ""));
            sheet.push(Parameter::new(
                Role::Gravity,
                "g",
                scene.gravity,
                &scene.units.acceleration(),
            ));
        }
        if scene.effects.cushion.is_some() {
            sheet.push(Parameter::new(
                Role::CushionRestitution,
                "component turned inward",
                "e = 1",
                "",
            ));
            sheet.push(Parameter::new(
                Role::CushionFriction,
                "tangential impulse",
                0,
                "",
            ));
        }
        sheet
    }

    fn simulate(self: Box<Self>, record: Record, limits: &Limits<'_>) -> Trace {
        let recorder = Recorder::new(self.scene, self.provenance(), record, &self.balls.states());
        match cloth::translational(&self.scene.effects, self.scene.gravity, self.settings.dt) {
            Some(cloth) => Loop::new(&self, cloth, recorder).run(limits),
            None => Loop::new(&self, NoCloth, recorder).run(limits),
        }
    }
}

/// A contact episode: from the first exchange of a pair until it no longer overlaps.
#[derive(Clone, Copy, Debug)]
struct Episode {
    pair: (usize, usize),
    event: u32,
    exchanges: u64,
    last_step: u64,
}

/// One run. Everything it needs is allocated before the first step.
struct Loop<'a, C> {
    scene: &'a Scene,
    settings: Settings,
    cloth: C,
    balls: Balls,
    sizes: Sizes,
    walls: Vec<(Side, Vec<f64>)>,
    recorder: Recorder,
    overlapping: Vec<(usize, usize)>,
    episodes: Vec<Episode>,
    exchanged: Vec<usize>,
    stopped: Vec<usize>,
    exchanges: u64,
    overlaps: u64,
    longest_overlap: u64,
    overlap_since: BTreeMap<(usize, usize), (u64, u64)>,
}

impl<'a, C: ClothStep> Loop<'a, C> {
    fn new(run: &Stepping<'a>, cloth: C, recorder: Recorder) -> Self {
        let scene = run.scene;
        let balls = run.balls.clone();
        let walls = match (scene.effects.cushion, scene.table) {
            (Some(_), Some(table)) => {
                let limits = |side| balls.radius.iter().map(|&r| table.reach(side, r)).collect();
                Side::ALL.iter().map(|&side| (side, limits(side))).collect()
            }
            _ => Vec::new(),
        };
        let n = balls.len();
        Loop {
            scene,
            settings: run.settings,
            cloth,
            sizes: Sizes::new(&balls.radius),
            balls,
            walls,
            recorder,
            overlapping: Vec::with_capacity(4 * n),
            episodes: Vec::with_capacity(4 * n),
            exchanged: Vec::with_capacity(n),
            stopped: Vec::with_capacity(n),
            exchanges: 0,
            overlaps: 0,
            longest_overlap: 0,
            overlap_since: BTreeMap::new(),
        }
    }

    fn run(mut self, limits: &Limits<'_>) -> Trace {
        let dt = self.settings.dt;
        // a duration that is a whole number of steps up to rounding takes exactly that number
        let steps = (self.scene.duration / dt * (1.0 - 1e-12)).ceil() as u64;
        let mut moving = (0..self.balls.len())
            .filter(|&i| self.balls.speed(i) > 0.0)
            .count();
        let mut ending = Ending::Duration;
        let mut step = 0;
        while step < steps {
            if moving == 0 && !self.scene.run_to_duration {
                ending = Ending::Rest;
                break;
            }
            if step & 0xfff == 0 && limits.is_cancelled() {
                ending = Ending::Cancelled;
                break;
            }
            self.contacts(step);
            moving = self.friction(step);
            self.cushions(step);
            self.advance();
            step += 1;
            let time = step as f64 * dt;
            self.stops(time);
            if self.recorder.due(time) {
                self.recorder.sample(time, &self.balls.states());
            }
        }
        if moving == 0 && !self.scene.run_to_duration {
            ending = Ending::Rest;
        }
        self.finish(step, ending)
    }

    fn finish(self, step: u64, ending: Ending) -> Trace {
        let time = step as f64 * self.settings.dt;
        let states = self.balls.states();
        let broken: Vec<u32> = states
            .iter()
            .enumerate()
            .filter(|(_, s)| {
                !(s.position.norm_squared().is_finite() && s.velocity.norm_squared().is_finite())
            })
            .map(|(i, _)| i as u32)
            .collect();
        let ending = match broken.is_empty() {
            true => ending,
            false => Ending::NotFinite(Spot {
                time,
                balls: broken,
                why: "a position or speed overflowed".to_owned(),
            }),
        };
        let at_rest = self
            .overlap_since
            .values()
            .filter(|(_, last)| last + 1 == step)
            .count() as u64;
        let counters = [
            ("steps", step),
            ("exchanges", self.exchanges),
            ("overlaps", self.overlaps),
            ("longest_overlap_steps", self.longest_overlap),
            ("pairs_overlapping_at_end", at_rest),
        ];
        let counters = counters
            .into_iter()
            .map(|(name, count)| (name.to_owned(), count))
            .collect();
        self.recorder.finish(time, &states, ending, counters)
    }

    /// 1. and 2.: the ball that was shot against every other, then each pair of the others.
    fn contacts(&mut self, step: u64) {
        let Some(law) = self.scene.effects.contact else {
            return;
        };
        self.sizes
            .overlapping(&self.balls.x, &self.balls.y, &mut self.overlapping);
        if !self.overlapping.is_empty() {
            self.exchange_all(step, law);
        }
        if !self.episodes.is_empty() {
            self.episodes.retain(|episode| episode.last_step == step);
        }
    }

    #[cold]
    #[inline(never)]
    fn exchange_all(&mut self, step: u64, law: Contact) {
        let time = step as f64 * self.settings.dt;
        self.exchanged.clear();
        for k in 0..self.overlapping.len() {
            let (i, j) = self.overlapping[k];
            let (a, b) = (self.balls.partner(i), self.balls.partner(j));
            let depth = self.sizes.distance(i, j) - (a.position - b.position).norm();
            let (first, second) = (self.balls.scene_index[i], self.balls.scene_index[j]);
            self.overlaps += 1;
            self.recorder.overlap(time, depth, first, second);
            self.keep_overlap(step, (i, j));
            if let Some(episode) = self
                .episodes
                .iter_mut()
                .find(|episode| episode.pair == (i, j))
            {
                episode.last_step = step;
            }
            let Some((va, vb)) = exchange(self.settings.contact, law, &a, &b) else {
                continue;
            };
            self.apply(step, time, (i, j), va, vb);
        }
        self.stops_after_exchange(time);
    }

    fn apply(
        &mut self,
        step: u64,
        time: f64,
        (i, j): (usize, usize),
        va: Vector2<f64>,
        vb: Vector2<f64>,
    ) {
        let balls = &mut self.balls;
        let (first, second) = (balls.scene_index[i], balls.scene_index[j]);
        let (before_i, before_j) = (balls.state(i), balls.state(j));
        let energy = balls.energy(i) + balls.energy(j);
        for (ball, velocity) in [(i, va), (j, vb)] {
            if balls.speed(ball) > 0.0 && !self.exchanged.contains(&ball) {
                self.exchanged.push(ball);
            }
            (balls.vx[ball], balls.vy[ball]) = (velocity.x, velocity.y);
        }
        self.exchanges += 1;
        let (after_i, after_j) = (balls.state(i), balls.state(j));
        let gained = balls.energy(i) + balls.energy(j) - energy;
        let lost = (after_i.velocity - before_i.velocity) * balls.mass[i]
            + (after_j.velocity - before_j.velocity) * balls.mass[j];
        let known = self
            .episodes
            .iter_mut()
            .find(|episode| episode.pair == (i, j));
        let event = match known {
            Some(episode) => {
                episode.exchanges += 1;
                self.recorder
                    .set_exchanges(episode.event, episode.exchanges);
                episode.event
            }
            None => {
                let event = self
                    .recorder
                    .event(time, EventKind::ball_ball(first, second), Some(1));
                self.episodes.push(Episode {
                    pair: (i, j),
                    event,
                    exchanges: 1,
                    last_step: step,
                });
                event
            }
        };
        self.recorder
            .energy_change(time, gained, first, Some(second));
        self.recorder
            .momentum_error(time, lost.norm(), first, second);
        self.recorder.jump(first, time, &before_i, &after_i, event);
        self.recorder.jump(second, time, &before_j, &after_j, event);
    }

    /// How long each pair has overlapped without a break, in steps.
    fn keep_overlap(&mut self, step: u64, pair: (usize, usize)) {
        let entry = self.overlap_since.entry(pair).or_insert((step, step));
        if entry.1 + 1 < step {
            entry.0 = step;
        }
        entry.1 = step;
        self.longest_overlap = self.longest_overlap.max(step - entry.0 + 1);
    }

    /// Balls that moved before this step's exchanges and have come out of them at rest.
    fn stops_after_exchange(&mut self, time: f64) {
        for k in 0..self.exchanged.len() {
            let i = self.exchanged[k];
            if self.balls.speed(i) == 0.0 {
                let state = self.balls.state(i);
                self.recorder
                    .stop(self.balls.scene_index[i], time, &state, &state);
            }
        }
    }

    /// 3.: every ball's speed falls, and stops at zero. Answers how many balls still move.
    fn friction(&mut self, step: u64) -> usize {
        let mut moving = 0;
        for i in 0..self.balls.len() {
            let speed = self.balls.speed(i);
            if speed == 0.0 {
                continue;
            }
            moving += 1;
            if !C::ACTS {
                continue;
            }
            let slowed = self.cloth.slowed(speed, self.balls.mass[i]);
            if slowed <= 0.0 {
                self.clamp(step, i);
                moving -= 1;
            } else {
                let factor = slowed / speed;
                self.balls.vx[i] *= factor;
                self.balls.vy[i] *= factor;
            }
        }
        moving
    }

    /// Friction would turn the ball around within this step: it stops.
    #[cold]
    #[inline(never)]
    fn clamp(&mut self, step: u64, i: usize) {
        let state = self.balls.state(i);
        self.recorder.pin(
            self.balls.scene_index[i],
            step as f64 * self.settings.dt,
            &state,
        );
        (self.balls.vx[i], self.balls.vy[i]) = (0.0, 0.0);
        self.stopped.push(i);
    }

    /// 4.: a ball past a wall is moved to it and that velocity component is turned inward.
    fn cushions(&mut self, step: u64) {
        for w in 0..self.walls.len() {
            let (side, limits) = &self.walls[w];
            let coordinate = if side.axis() == 0 {
                &self.balls.x
            } else {
                &self.balls.y
            };
            let mut any = false;
            if side.sign() < 0 {
                for (x, limit) in coordinate.iter().zip(limits) {
                    any |= x < limit;
                }
            } else {
                for (x, limit) in coordinate.iter().zip(limits) {
                    any |= x > limit;
                }
            }
            if any {
                self.meet_wall(step, w);
            }
        }
    }

    #[cold]
    #[inline(never)]
    fn meet_wall(&mut self, step: u64, wall: usize) {
        let Some(law) = self.scene.effects.cushion else {
            return;
        };
        let time = step as f64 * self.settings.dt;
        let (side, outward) = (self.walls[wall].0, f64::from(self.walls[wall].0.sign()));
        for i in 0..self.balls.len() {
            let limit = self.walls[wall].1[i];
            let before = self.balls.state(i);
            let beyond = outward * (before.position[side.axis()] - limit);
            if beyond <= 0.0 {
                continue;
            }
            let mut after = before;
            after.position[side.axis()] = limit;
            let met = outward * before.velocity[side.axis()] > 0.0;
            if met {
                let body = Body {
                    velocity: before.velocity,
                    spin: before.spin,
                    mass: self.balls.mass[i],
                    radius: self.balls.radius[i],
                };
                after.velocity = cushion::impact(law, &body, side).motion.velocity;
            }
            (self.balls.x[i], self.balls.y[i]) = (after.position.x, after.position.y);
            (self.balls.vx[i], self.balls.vy[i]) = (after.velocity.x, after.velocity.y);
            let ball = self.balls.scene_index[i];
            let event = self.recorder.event(
                time,
                EventKind::BallCushion(ball as u32, side),
                Some(u64::from(met)),
            );
            self.recorder.outside(time, beyond, ball);
            self.recorder.jump(ball, time, &before, &after, event);
        }
    }

    /// 5.: positions move with the new velocities.
    fn advance(&mut self) {
        let (balls, dt) = (&mut self.balls, self.settings.dt);
        for (x, v) in balls.x.iter_mut().zip(&balls.vx) {
            *x += v * dt;
        }
        for (y, v) in balls.y.iter_mut().zip(&balls.vy) {
            *y += v * dt;
        }
    }

    /// Balls that friction stopped in this step: at rest from the end of the step on.
    fn stops(&mut self, time: f64) {
        for k in 0..self.stopped.len() {
            let i = self.stopped[k];
            let state = self.balls.state(i);
            self.recorder
                .stop(self.balls.scene_index[i], time, &state, &state);
        }
        self.stopped.clear();
    }
}
