//! A plain copy of the report's model, one ball a struct and one loop a sentence, with room for one slip of the pen.
//!
//! Without a slip it is `stepper` to the bit, which a test holds on every scene of the gate set; so what the gate says of a copy with
//! a slip is what it would say of `stepper` with the same slip. Laws of impacts are those of `physics`.

use super::slip::Slip;
use carom::engine::Limits;
use carom::engine::stepped::Clock;
use carom::engine::stepper::{ContactRule, Launch, Settings};
use carom::math::Vec3;
use carom::physics::cloth::rotational::{self, Coefficients};
use carom::physics::{Body, Cloth, Contact, Motion, Side, State, contact, cushion, pockets};
use carom::scene::Scene;
use carom::trace::{Counter, Ending, EventKind, Provenance, Record, Recorder, Spot, Trace};
use nalgebra::Vector2;
use std::collections::BTreeMap;

/// A slip over the cloth below this part of the speeds it is the difference of is none.
const ROLLS: f64 = 8.0 * f64::EPSILON;

#[derive(Clone, Copy, Debug)]
struct Ball {
    /// Index in the scene.
    index: usize,
    r: [f64; 2],
    v: Vec3,
    w: Vec3,
    mass: f64,
    radius: f64,
    /// `None` where nothing turns.
    inertia: Option<f64>,
    slides: bool,
}

impl Ball {
    fn speed(&self) -> f64 {
        (self.v.x * self.v.x + self.v.y * self.v.y).sqrt()
    }

    fn is_at_rest(&self) -> bool {
        self.speed() == 0.0 && self.w == Vec3::zeros()
    }

    fn energy(&self) -> f64 {
        let translation = 0.5 * self.mass * (self.v.x * self.v.x + self.v.y * self.v.y);
        match self.inertia {
            Some(inertia) => translation + 0.5 * inertia * self.w.norm_squared(),
            None => translation,
        }
    }

    fn body(&self) -> Body {
        Body {
            velocity: self.v,
            spin: self.w,
            mass: self.mass,
            radius: self.radius,
        }
    }

    fn state(&self) -> State {
        State {
            position: Vec3::new(self.r[0], self.r[1], self.radius),
            velocity: self.v,
            spin: self.w,
        }
    }

    fn slips(&self) -> bool {
        let slip = rotational::slip_velocity(&self.v, &self.w, self.radius);
        self.inertia.is_some()
            && slip.norm() > ROLLS * (self.v.norm() + self.radius * self.w.xy().norm())
    }

    fn set(&mut self, motion: &Motion) {
        self.v = Vec3::new(motion.velocity.x, motion.velocity.y, 0.0);
        if self.inertia.is_some() {
            self.w = motion.spin;
        }
        self.slides = self.slips();
    }
}

struct Episode {
    pair: (usize, usize),
    event: u32,
    exchanges: u64,
    last_step: u64,
}

struct Program<'a> {
    scene: &'a Scene,
    settings: Settings,
    clock: Clock,
    /// Length of the step that is taken, s.
    dt: f64,
    slip: Slip,
    balls: Vec<Ball>,
    recorder: Recorder,
    episodes: Vec<Episode>,
    ended: Vec<(usize, EventKind)>,
    exchanges: u64,
    overlaps: u64,
    longest: u64,
    since: BTreeMap<(usize, usize), (u64, u64)>,
    /// What overlapped in the step before, by index in the scene.
    stale: Vec<(usize, usize)>,
    /// Who was beyond which wall in the step before.
    beyond: Vec<(usize, Side)>,
}

/// Runs a scene by the report's model with one slip.
pub fn simulate(
    scene: &Scene,
    settings: Settings,
    slip: Slip,
    provenance: Provenance,
    record: Record,
    limits: &Limits<'_>,
) -> Trace {
    let launched = match settings.launch {
        Launch::AsWritten => scene.launched_for(settings.dt),
        Launch::ContactTime => None,
    };
    let from = launched.as_ref().unwrap_or(scene);
    let cue = scene.cue_ball();
    let order = std::iter::once(cue).chain((0..scene.balls.len()).filter(|&i| i != cue));
    let ball = |index: usize| {
        let (ball, inertia) = (&from.balls[index], scene.inertia(index));
        let mut ball = Ball {
            index,
            r: [ball.state.position.x, ball.state.position.y],
            v: Vec3::new(ball.state.velocity.x, ball.state.velocity.y, 0.0),
            w: inertia.map_or_else(Vec3::zeros, |_| ball.state.spin),
            mass: ball.mass,
            radius: ball.radius,
            inertia,
            slides: false,
        };
        ball.slides = ball.slips();
        ball
    };
    let balls: Vec<Ball> = order.map(ball).collect();
    let initial = states(scene, &balls);
    let program = Program {
        scene,
        settings,
        clock: Clock::new(scene.duration, settings.dt),
        dt: settings.dt,
        slip,
        balls,
        recorder: Recorder::new(scene, provenance, record, &initial),
        episodes: Vec::new(),
        ended: Vec::new(),
        exchanges: 0,
        overlaps: 0,
        longest: 0,
        since: BTreeMap::new(),
        stale: Vec::new(),
        beyond: Vec::new(),
    };
    program.run(limits)
}

/// States in scene order; zeros for a ball that left play.
fn states(scene: &Scene, balls: &[Ball]) -> Vec<State> {
    let mut states = vec![State::at_rest(Vec3::zeros()); scene.balls.len()];
    for ball in balls {
        states[ball.index] = ball.state();
    }
    states
}

impl Program<'_> {
    fn run(mut self, limits: &Limits<'_>) -> Trace {
        let steps = self.clock.steps;
        let mut moving = self.balls.iter().filter(|b| !b.is_at_rest()).count();
        let (mut ending, mut step) = (Ending::Duration, 0);
        while step < steps {
            if moving == 0 && !self.scene.run_to_duration {
                ending = Ending::Rest;
                break;
            }
            if step & 0xfff == 0 && limits.is_cancelled() {
                ending = Ending::Cancelled;
                break;
            }
            self.dt = self.clock.length(step);
            if self.slip == Slip::WallsFirst {
                self.cushions(step);
            }
            self.contacts(step);
            moving = self.friction(step);
            if self.slip != Slip::WallsFirst {
                self.cushions(step);
            }
            let dt = match self.slip {
                Slip::StepDoubled => 2.0 * self.dt,
                _ => self.dt,
            };
            for ball in &mut self.balls {
                ball.r[0] += ball.v.x * dt;
                ball.r[1] += ball.v.y * dt;
            }
            step += 1;
            let time = self.clock.time(step);
            for (i, kind) in std::mem::take(&mut self.ended) {
                self.tell(i, kind, time);
            }
            if self.pocket(time) {
                moving = self.balls.iter().filter(|b| !b.is_at_rest()).count();
            }
            if self.recorder.due(time) {
                self.recorder.sample(time, &states(self.scene, &self.balls));
            }
        }
        if moving == 0 && !self.scene.run_to_duration {
            ending = Ending::Rest;
        }
        self.finish(step, ending)
    }

    fn finish(self, step: u64, mut ending: Ending) -> Trace {
        let time = self.clock.time(step);
        let states = states(self.scene, &self.balls);
        let finite = |v: &Vec3| v.norm_squared().is_finite();
        let broken: Vec<u32> = (0..states.len() as u32)
            .filter(|&i| {
                let s = &states[i as usize];
                !(finite(&s.position) && finite(&s.velocity) && finite(&s.spin))
            })
            .collect();
        if !broken.is_empty() {
            ending = Ending::NotFinite(Spot {
                time,
                balls: broken,
                why: "a position or speed overflowed".to_owned(),
            });
        }
        let at_end = self.since.values().filter(|(_, last)| last + 1 == step);
        let counters = [
            (Counter::Steps, step),
            (Counter::Exchanges, self.exchanges),
            (Counter::Overlaps, self.overlaps),
            (Counter::LongestOverlap, self.longest),
            (Counter::OverlapsAtEnd, at_end.count() as u64),
        ];
        self.recorder.finish(time, &states, ending, counters)
    }

    /// Each overlapping pair exchanges, in the report's order.
    fn contacts(&mut self, step: u64) {
        let Some(law) = self.scene.effects.contact else {
            return;
        };
        let time = match self.slip {
            Slip::ContactToldLate => self.clock.time(step + 1),
            _ => self.clock.time(step),
        };
        let n = self.balls.len();
        let all = (0..n).flat_map(|i| (i + 1..n).map(move |j| (i, j)));
        let mut pairs: Vec<(usize, usize)> = all
            .filter(|&(i, j)| {
                let (a, b) = (&self.balls[i], &self.balls[j]);
                let (x, y) = (a.r[0] - b.r[0], a.r[1] - b.r[1]);
                (x * x + y * y).sqrt() < contact::plan_distance(a.radius, b.radius)
            })
            .collect();
        match self.slip {
            Slip::PairsReversed => pairs.reverse(),
            Slip::PairDropped => pairs.retain(|&(i, j)| (i, j) != (0, 1)),
            Slip::StaleContact => {
                let fresh = pairs.clone();
                for old in std::mem::replace(&mut self.stale, fresh) {
                    if !pairs.contains(&old) && old.1 < n {
                        pairs.push(old);
                    }
                }
            }
            _ => {}
        }
        let mut exchanged = Vec::new();
        for (i, j) in pairs {
            let (a, b) = (self.balls[i], self.balls[j]);
            let apart = Vector2::from(a.r) - Vector2::from(b.r);
            let pair = (a.index, b.index);
            self.overlaps += 1;
            let depth = contact::plan_distance(a.radius, b.radius) - apart.norm();
            self.recorder.overlap(time, depth, pair.0, pair.1);
            let entry = self.since.entry(pair).or_insert((step, step));
            if entry.1 + 1 < step {
                entry.0 = step;
            }
            entry.1 = step;
            self.longest = self.longest.max(step - entry.0 + 1);
            if let Some(episode) = self.episodes.iter_mut().find(|e| e.pair == pair) {
                episode.last_step = step;
            }
            if let Some((one, two)) = self.exchange(law, apart, &a, &b) {
                for k in [i, j] {
                    if self.balls[k].speed() > 0.0 && !exchanged.contains(&k) {
                        exchanged.push(k);
                    }
                }
                self.apply(step, time, (i, j), one, two);
            }
        }
        for i in exchanged {
            if self.stays(i) {
                self.tell(i, EventKind::Stop(self.balls[i].index as u32), time);
            }
        }
        self.episodes.retain(|episode| episode.last_step == step);
    }

    /// What two overlapping balls do to each other; `apart`: from the second to the first.
    fn exchange(
        &self,
        law: Contact,
        apart: Vector2<f64>,
        a: &Ball,
        b: &Ball,
    ) -> Option<(Motion, Motion)> {
        let still = |ball: &Ball| ball.v == Vec3::zeros() && ball.w == Vec3::zeros();
        let distance = apart.norm();
        if (still(a) && still(b)) || distance == 0.0 {
            return None;
        }
        let n = self.slip.normal(apart / distance);
        let (one, two) = (a.v.xy().dot(&n), b.v.xy().dot(&n));
        let separating = one - two >= 0.0;
        if self.settings.contact == ContactRule::ApproachingOnly
            && separating
            && self.slip != Slip::StaleContact
        {
            return None;
        }
        let friction = self.scene.effects.friction;
        let friction = friction.filter(|_| !separating && self.slip != Slip::ThrowOff);
        let law = self.slip.contact(law);
        let smooth = law == (Contact::Elastic {}) && friction.is_none();
        let equal = a.mass == b.mass || self.slip == Slip::MassIgnored;
        let (one, two) = if smooth && equal {
            let (along, other) = (n * one, n * two);
            let moved = |v: Vector2<f64>, spin| Motion {
                velocity: Vec3::new(v.x, v.y, 0.0),
                spin,
            };
            (
                moved(a.v.xy() - along + other, a.w),
                moved(b.v.xy() - other + along, b.w),
            )
        } else {
            let n = Vec3::new(-n.x, -n.y, 0.0);
            contact::impact(law, friction, &a.body(), &b.body(), &n)
        };
        let (one, two) = (self.slip.after_hit(one), self.slip.after_hit(two));
        let before = |ball: &Ball| Motion {
            velocity: ball.v,
            spin: ball.w,
        };
        (one != before(a) || two != before(b)).then_some((one, two))
    }

    fn apply(&mut self, step: u64, time: f64, (i, j): (usize, usize), one: Motion, two: Motion) {
        let (a, b) = (self.balls[i], self.balls[j]);
        let mut taken = 0.0;
        for (k, motion) in [(i, one), (j, two)] {
            let (planar, vertical) = motion.on_cloth();
            self.balls[k].set(&planar);
            taken += self.balls[k].mass * vertical;
        }
        self.exchanges += 1;
        let (after, other) = (self.balls[i], self.balls[j]);
        let gained = after.energy() + other.energy() - (a.energy() + b.energy());
        let lost = (after.v - a.v) * a.mass + (other.v - b.v) * b.mass;
        let pair = (a.index, b.index);
        let event = match self.episodes.iter_mut().find(|e| e.pair == pair) {
            Some(episode) => {
                episode.exchanges += 1;
                self.recorder
                    .set_exchanges(episode.event, episode.exchanges);
                episode.event
            }
            None => {
                let kind = EventKind::ball_ball(pair.0, pair.1);
                let event = self.recorder.event(time, kind, Some(1));
                self.episodes.push(Episode {
                    pair,
                    event,
                    exchanges: 1,
                    last_step: step,
                });
                event
            }
        };
        self.book(time, gained, taken, pair.0, Some(pair.1));
        self.recorder
            .momentum_error(time, lost.norm(), pair.0, pair.1);
        self.recorder
            .jump(pair.0, time, &a.state(), &after.state(), event);
        self.recorder
            .jump(pair.1, time, &b.state(), &other.state(), event);
    }

    fn book(&mut self, time: f64, gained: f64, taken: f64, ball: usize, other: Option<usize>) {
        self.recorder
            .energy_change(time, gained + taken, ball, other);
        if taken > 0.0 {
            self.recorder.energy_change(time, -taken, ball, other);
        }
    }

    fn stays(&self, i: usize) -> bool {
        let drives = match self.scene.effects.cloth {
            Some(Cloth::Rotational { mu_slide, .. }) => mu_slide * self.scene.gravity > 0.0,
            Some(Cloth::Translational { .. }) | None => false,
        };
        self.balls[i].speed() == 0.0 && !(self.balls[i].slides && drives)
    }

    /// The cloth slows every ball. Answers how many still move or spin.
    fn friction(&mut self, step: u64) -> usize {
        let time = self.clock.time(step);
        let gravity = self.slip.gravity(self.scene.gravity);
        let mut moving = 0;
        for i in 0..self.balls.len() {
            let ball = self.balls[i];
            let end = match self.scene.effects.cloth {
                None => Phase::going(&ball),
                Some(Cloth::Translational { mu }) => self.slide(&ball, mu * gravity),
                Some(Cloth::Rotational {
                    mu_slide,
                    mu_roll,
                    mu_spin,
                }) => {
                    let mu = self.slip.cloth(Coefficients {
                        mu_slide,
                        mu_roll,
                        mu_spin,
                    });
                    self.turn(&ball, mu, gravity)
                }
            };
            if end.ends() {
                self.recorder.pin(ball.index, time, &ball.state());
                self.balls[i].set(&end.motion);
                let index = ball.index as u32;
                for (ends, kind) in [
                    (end.slide, EventKind::SlideToRoll(index)),
                    (end.stop, EventKind::Stop(index)),
                    (end.spin, EventKind::SpinEnd(index)),
                ] {
                    if ends {
                        self.ended.push((i, kind));
                    }
                }
            } else {
                (self.balls[i].v, self.balls[i].w) = (end.motion.velocity, end.motion.spin);
            }
            moving += usize::from(!self.balls[i].is_at_rest());
        }
        moving
    }

    /// A ball that does not turn.
    fn slide(&self, ball: &Ball, deceleration: f64) -> Phase {
        let (dt, speed, mut end) = (self.dt, ball.speed(), Phase::going(ball));
        if speed == 0.0 {
            return end;
        }
        let slower = (-deceleration * ball.mass * dt + ball.mass * speed) / ball.mass;
        if slower <= self.slip.sleeps_below() {
            end.motion.velocity = Vec3::zeros();
            end.stop = true;
            return end;
        }
        let factor = self.slip.factors(slower / speed);
        end.motion.velocity.x *= factor[0];
        end.motion.velocity.y *= factor[1];
        end
    }

    /// A ball that slides, rolls and spins.
    fn turn(&self, ball: &Ball, mu: Coefficients, gravity: f64) -> Phase {
        let (dt, radius, mut end) = (self.dt, ball.radius, Phase::going(ball));
        if ball.v == Vec3::zeros() && ball.w == Vec3::zeros() {
            return end;
        }
        let (v, w) = (ball.v, ball.w);
        // I / (m R^2): 2/5 for a sphere
        let inertia = self.slip.inertia();
        let spin_step = rotational::spin_deceleration(mu.mu_spin, gravity, radius) * dt;
        let slip = rotational::slip_velocity(&v, &w, radius);
        let slip_step = (1.0 + 1.0 / inertia) * mu.mu_slide * gravity * dt;
        let roll_step = mu.mu_roll * gravity * dt;
        let spin_ends = w.z != 0.0 && w.z.abs() <= spin_step;
        let slides_on = ball.slides && slip.norm() > slip_step;
        let stops = v != Vec3::zeros() && v.norm() <= roll_step;
        let rolls_on = !(ball.slides || stops);
        let sliding = || {
            let mut rates = rotational::sliding(&slip, &w, radius, mu, gravity);
            if self.slip == Slip::RollAtFourSevenths {
                let turn = 1.0 / (inertia * radius);
                rates.angular_acceleration.x = turn * rates.acceleration.y;
                rates.angular_acceleration.y = -turn * rates.acceleration.x;
            }
            (
                v + rates.acceleration * dt,
                w + rates.angular_acceleration * dt,
            )
        };
        if !spin_ends && slides_on {
            (end.motion.velocity, end.motion.spin) = sliding();
            return end;
        }
        if !spin_ends && rolls_on {
            let rates = rotational::rolling(&v, &w, radius, mu, gravity);
            end.motion.velocity = v + rates.acceleration * dt;
            end.motion.spin = rotational::rolling_spin(&end.motion.velocity, radius);
            end.motion.spin.z = w.z + rates.angular_acceleration.z * dt;
            return end;
        }
        let rolled = |velocity: Vec3, time: f64| {
            let (speed, lost) = (velocity.norm(), mu.mu_roll * gravity * time);
            if speed <= lost {
                Vec3::zeros()
            } else {
                velocity * (1.0 - lost / speed)
            }
        };
        let (next, mut turning) = if slides_on {
            sliding()
        } else {
            let next = if ball.slides {
                let slid = rotational::slide_time(slip.norm(), mu.mu_slide, gravity);
                rolled(rotational::natural_roll(&v, &slip), (dt - slid).max(0.0))
            } else {
                rolled(v, dt)
            };
            end.stop = next == Vec3::zeros() && (ball.slides || v != next);
            end.slide = ball.slides && !end.stop;
            (next, rotational::rolling_spin(&next, radius))
        };
        end.spin = spin_ends;
        turning.z = match spin_ends {
            true => 0.0,
            false => rotational::spun_down(w.z, radius, mu.mu_spin, gravity, dt),
        };
        end.within = true;
        end.motion = Motion {
            velocity: next,
            spin: turning,
        };
        end
    }

    /// A ball past a wall is moved to it and that velocity component is turned inward.
    fn cushions(&mut self, step: u64) {
        let time = self.clock.time(step);
        let (Some(law), Some(table)) = (self.scene.effects.cushion, self.scene.table) else {
            return;
        };
        let mut beyond_now = Vec::new();
        for side in self.slip.walls() {
            let (axis, outward) = (side.axis(), f64::from(side.sign()));
            for i in 0..self.balls.len() {
                let before = self.balls[i];
                let limit = table.reach(side, before.radius);
                let beyond = outward * (before.r[axis] - limit);
                if beyond <= 0.0 {
                    continue;
                }
                beyond_now.push((before.index, side));
                let late = self.slip == Slip::CushionLate;
                if late && !self.beyond.contains(&(before.index, side)) {
                    continue;
                }
                let met = outward * before.v[axis] > 0.0;
                let mut taken = 0.0;
                if met {
                    for (_, kind) in self
                        .ended
                        .extract_if(.., |(k, _)| *k == i)
                        .collect::<Vec<_>>()
                    {
                        self.tell(i, kind, time);
                    }
                    let rebound = cushion::impact(self.slip.cushion(law), &before.body(), side);
                    let motion = self.slip.after_cushion(rebound.motion);
                    let (planar, vertical) = motion.on_cloth();
                    self.balls[i].set(&planar);
                    taken = before.mass * vertical;
                }
                if self.slip != Slip::WallForgetsPlace {
                    self.balls[i].r[axis] = limit;
                }
                let (ball, after) = (before.index, self.balls[i].state());
                let kind = EventKind::BallCushion(ball as u32, side);
                let event = self.recorder.event(time, kind, Some(u64::from(met)));
                self.recorder.outside(time, beyond, ball);
                self.recorder
                    .jump(ball, time, &before.state(), &after, event);
                if met {
                    let gained = self.balls[i].energy() - before.energy();
                    self.book(time, gained, taken, ball, None);
                    if self.stays(i) {
                        self.tell(i, EventKind::Stop(ball as u32), time);
                    }
                }
            }
        }
        self.beyond = beyond_now;
    }

    fn tell(&mut self, i: usize, kind: EventKind, time: f64) {
        let (ball, state) = (self.balls[i].index, self.balls[i].state());
        if let EventKind::Stop(_) = kind {
            self.recorder.stop(ball, time, &state, &state);
        } else {
            self.recorder.phase(ball, time, &state, &state, kind);
        }
    }

    /// A ball whose centre is in a pocket leaves play. Answers whether one did.
    fn pocket(&mut self, time: f64) -> bool {
        let Some(pockets) = &self.scene.effects.pockets else {
            return false;
        };
        let (mut any, mut i) = (false, 0);
        while i < self.balls.len() {
            let state = self.balls[i].state();
            let held = pockets::holding(pockets, &state.position);
            let Some(pocket) = held.filter(|_| self.slip != Slip::PocketMissed) else {
                i += 1;
                continue;
            };
            let ball = self.balls.remove(i).index;
            self.recorder.pocket(ball, time, &state, pocket as u32);
            let involves = |pair: (usize, usize)| pair.0 == ball || pair.1 == ball;
            self.episodes.retain(|episode| !involves(episode.pair));
            self.since.retain(|pair, _| !involves(*pair));
            any = true;
        }
        any
    }
}

/// A ball's motion after a step on the cloth, and what ends within it.
struct Phase {
    motion: Motion,
    slide: bool,
    stop: bool,
    spin: bool,
    /// Whether some motion ended, even where no event tells it.
    within: bool,
}

impl Phase {
    fn going(ball: &Ball) -> Self {
        Phase {
            motion: Motion {
                velocity: ball.v,
                spin: ball.w,
            },
            slide: false,
            stop: false,
            spin: false,
            within: false,
        }
    }

    fn ends(&self) -> bool {
        self.stop || self.within
    }
}
