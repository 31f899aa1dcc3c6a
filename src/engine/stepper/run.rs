//! The step loop: the report's order of operations, and what each step tells the recorder.

use super::balls::Balls;
use super::cloth::{ClothStep, NoCloth, Rotational, Translational};
use super::contact::{Laws, Sizes, exchange};
use super::overlaps::{self, Overlaps};
use super::pairs::Pairs;
use super::walls::Walls;
use super::{Settings, sheet};
use crate::engine::setting::parameters;
use crate::engine::stepped::Clock;
use crate::engine::{Inside, Limits, Parameter, Run};
use crate::physics::cloth::rotational::Coefficients;
use crate::physics::{Cloth, Contact, Cushion, Effects, Motion, State, cushion, pockets};
use crate::scene::Scene;
use crate::trace::{Counter, Ending, EventKind, Provenance, Record, Recorder, Spot, Trace};

/// A scene inside the stepper, before its first step.
#[derive(Debug)]
pub struct Stepping<'a> {
    /// What is simulated.
    pub scene: &'a Scene,
    /// How.
    pub settings: Settings,
    /// The balls before the first step.
    pub balls: Balls,
    /// The laws that the loop applies: what it knows of them it has from here.
    pub laws: Effects,
    provenance: Provenance,
}

impl<'a> Stepping<'a> {
    pub fn new(scene: &'a Scene, settings: Settings, version: String) -> Self {
        Stepping {
            scene,
            settings,
            balls: Balls::new(scene, &settings),
            laws: scene.effects.clone(),
            provenance: Provenance {
                engine: super::ID.to_owned(),
                version,
                parameters: parameters(&settings),
                scene: scene.name.clone(),
                scene_hash: scene.hash(),
                resolution: settings.dt,
                rest_speed: 0.0,
                ulp: f64::EPSILON,
            },
        }
    }
}

impl Run for Stepping<'_> {
    fn inside(&self) -> Inside {
        sheet::inside(self.scene, &self.settings, &self.balls, &self.laws)
    }

    fn sheet(&self) -> Vec<Parameter> {
        sheet::sheet(self.scene, &self.settings)
    }

    fn simulate(mut self: Box<Self>, record: Record, limits: &Limits<'_>) -> Trace {
        let provenance = std::mem::take(&mut self.provenance);
        let recorder = Recorder::new(self.scene, provenance, record, &self.balls.states());
        let (gravity, dt) = (self.scene.gravity, self.settings.dt);
        match self.laws.cloth {
            None => Loop::new(&self, NoCloth, recorder).run(limits),
            Some(Cloth::Translational { mu }) => {
                Loop::new(&self, Translational::new(mu, gravity, dt), recorder).run(limits)
            }
            Some(Cloth::Rotational {
                mu_slide,
                mu_roll,
                mu_spin,
            }) => {
                let mu = Coefficients {
                    mu_slide,
                    mu_roll,
                    mu_spin,
                };
                Loop::new(&self, Rotational::new(mu, gravity, dt), recorder).run(limits)
            }
        }
    }
}

/// Balls of all steps between two looks at whether the user asked to stop.
const PATIENCE: usize = 1 << 16;

/// One run. Everything it needs is allocated before the first step.
struct Loop<'a, C> {
    scene: &'a Scene,
    settings: Settings,
    laws: &'a Effects,
    clock: Clock,
    /// Length of the step that is taken, s.
    dt: f64,
    cloth: C,
    balls: Balls,
    sizes: Sizes,
    pairs: Pairs,
    walls: Walls,
    pockets: &'a [[f64; 3]],
    recorder: Recorder,
    /// Pairs that overlap in this step, by index in play.
    overlapping: Vec<(usize, usize)>,
    overlaps: Overlaps,
    /// Balls that moved before this step's exchanges and took part in them, by index in play.
    exchanged: Vec<usize>,
    /// The last step in which each ball was put among them, counted from 1.
    exchanged_in: Vec<u64>,
    /// Balls of which some motion ends within this step, by ascending index in play.
    ending: Vec<usize>,
    /// What ended within this step, by ascending index in play: told at its end.
    ended: Vec<Ended>,
    /// Balls that leave play in this step, by ascending index in play.
    leaving: Vec<usize>,
    /// States in scene order, for a sample.
    states: Vec<State>,
    exchanges: u64,
    overlapped: u64,
    longest_overlap: u64,
}

/// The end of a phase of a ball's motion.
#[derive(Clone, Copy, Debug)]
struct Ended {
    ball: usize,
    kind: EventKind,
    told: bool,
}

impl<'a, C: ClothStep> Loop<'a, C> {
    fn new(run: &'a Stepping<'_>, cloth: C, recorder: Recorder) -> Self {
        let scene = run.scene;
        let balls = run.balls.clone();
        let n = balls.len();
        let sizes = Sizes::new(&balls.radius);
        Loop {
            scene,
            settings: run.settings,
            laws: &run.laws,
            clock: Clock::new(scene.duration, run.settings.dt),
            dt: run.settings.dt,
            cloth,
            pairs: Pairs::new(run.settings.partners, &sizes, n),
            sizes,
            walls: Walls::new(scene, &balls.radius),
            balls,
            pockets: run.laws.pockets.as_ref().map_or(&[], |p| &p.circles),
            recorder,
            overlapping: Vec::with_capacity(4 * n),
            overlaps: Overlaps::new(4 * n),
            exchanged: Vec::with_capacity(n),
            exchanged_in: vec![0; n],
            ending: Vec::with_capacity(n),
            ended: Vec::with_capacity(3 * n),
            leaving: Vec::with_capacity(n),
            states: Vec::with_capacity(n),
            exchanges: 0,
            overlapped: 0,
            longest_overlap: 0,
        }
    }

    fn run(mut self, limits: &Limits<'_>) -> Trace {
        let last = self.clock.steps - 1;
        let mut moving = self.balls.moving();
        let mut ending = Ending::Duration;
        let mut step = 0;
        let patience = (PATIENCE / self.balls.len().max(1)).max(1) as u64;
        while step <= last {
            if moving == 0 && !self.scene.run_to_duration {
                ending = Ending::Rest;
                break;
            }
            if step % patience == 0 && limits.is_cancelled() {
                ending = Ending::Cancelled;
                break;
            }
            if step == last {
                self.shorten(last);
            }
            self.contacts(step);
            moving = self.friction(step);
            self.cushions(step);
            self.advance();
            step += 1;
            let time = self.clock.time(step);
            self.tell_ended(time);
            if self.any_pocketed() {
                self.pocket(time);
                moving = self.balls.moving();
            }
            if self.recorder.due(time) {
                self.balls.read(&mut self.states);
                self.recorder.sample(time, &self.states);
            }
        }
        if moving == 0 && !self.scene.run_to_duration {
            ending = Ending::Rest;
        }
        self.finish(step, ending)
    }

    /// The last step ends with the duration.
    #[cold]
    fn shorten(&mut self, last: u64) {
        self.dt = self.clock.length(last);
        self.cloth = self.cloth.in_steps_of(self.dt);
    }

    fn finish(self, step: u64, ending: Ending) -> Trace {
        let time = self.clock.time(step);
        let states = self.balls.states();
        let broken: Vec<u32> = states
            .iter()
            .enumerate()
            .filter(|(_, s)| {
                !(s.position.norm_squared().is_finite()
                    && s.velocity.norm_squared().is_finite()
                    && s.spin.norm_squared().is_finite())
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
        let counters = [
            (Counter::Steps, step),
            (Counter::Exchanges, self.exchanges),
            (Counter::Overlaps, self.overlapped),
            (Counter::LongestOverlap, self.longest_overlap),
            (Counter::OverlapsAtEnd, self.overlaps.now().len() as u64),
        ];
        self.recorder.finish(time, &states, ending, counters)
    }

    /// 1. and 2.: the ball that was shot against every other, then each pair of the others.
    fn contacts(&mut self, step: u64) {
        let Some(contact) = self.laws.contact else {
            return;
        };
        let (x, y) = (&self.balls.x, &self.balls.y);
        self.pairs
            .overlapping(&self.sizes, x, y, &mut self.overlapping);
        if !(self.overlapping.is_empty() && self.overlaps.now().is_empty()) {
            self.exchange_all(step, contact);
        }
    }

    #[cold]
    #[inline(never)]
    fn exchange_all(&mut self, step: u64, contact: Contact) {
        let laws = Laws {
            contact,
            friction: self.laws.friction,
        };
        let time = self.clock.time(step);
        self.exchanged.clear();
        self.overlaps.begin();
        for k in 0..self.overlapping.len() {
            let (i, j) = self.overlapping[k];
            let apart = self.balls.position(i) - self.balls.position(j);
            let depth = self.sizes.distance(i, j) - apart.norm();
            let (first, second) = (self.balls.scene_index[i], self.balls.scene_index[j]);
            self.overlapped += 1;
            self.recorder.overlap(time, depth, first, second);
            let overlap = self.overlaps.meet(step, (i, j));
            let since = self.overlaps.now()[overlap].since;
            self.longest_overlap = self.longest_overlap.max(step - since + 1);
            // a rack that overlaps at rest is most of what the rule as written meets
            if self.balls.is_still(i) && self.balls.is_still(j) {
                continue;
            }
            let (a, b) = (self.balls.body(i), self.balls.body(j));
            if let Some(motions) = exchange(self.settings.contact, laws, apart, &a, &b) {
                self.apply(step, overlap, motions);
            }
        }
        self.stops_after_exchange(time);
    }

    /// Gives both balls of an overlapping pair their motions after an exchange, and tells it.
    fn apply(&mut self, step: u64, overlap: usize, (one, two): (Motion, Motion)) {
        let time = self.clock.time(step);
        let (i, j) = self.overlaps.now()[overlap].pair;
        let balls = &mut self.balls;
        let (first, second) = (balls.scene_index[i], balls.scene_index[j]);
        let (before_i, before_j) = (balls.state(i), balls.state(j));
        let energy = balls.energy(i) + balls.energy(j);
        let mut taken = 0.0;
        for (ball, motion) in [(i, one), (j, two)] {
            if balls.speed(ball) > 0.0 && self.exchanged_in[ball] != step + 1 {
                self.exchanged_in[ball] = step + 1;
                self.exchanged.push(ball);
            }
            let (planar, vertical) = motion.on_cloth();
            balls.set_motion(ball, &planar);
            taken += balls.mass[ball] * vertical;
        }
        self.exchanges += 1;
        let (after_i, after_j) = (balls.state(i), balls.state(j));
        let gained = balls.energy(i) + balls.energy(j) - energy;
        let lost = (after_i.velocity - before_i.velocity) * balls.mass[i]
            + (after_j.velocity - before_j.velocity) * balls.mass[j];
        let contact = self.overlaps.contact(overlap);
        let event = match contact {
            Some(contact) => {
                contact.exchanges += 1;
                self.recorder
                    .set_exchanges(contact.event, contact.exchanges);
                contact.event
            }
            None => {
                let event = self
                    .recorder
                    .event(time, EventKind::ball_ball(first, second), Some(1));
                *contact = Some(overlaps::Contact {
                    event,
                    exchanges: 1,
                });
                event
            }
        };
        self.book(time, gained, taken, first, Some(second));
        self.recorder
            .momentum_error(time, lost.norm(), first, second);
        self.recorder.jump(first, time, &before_i, &after_i, event);
        self.recorder.jump(second, time, &before_j, &after_j, event);
    }

    /// Books what an impact did to the kinetic energy: `gained` in all, of which the cloth took `taken` with the vertical motion.
    fn book(&mut self, time: f64, gained: f64, taken: f64, ball: usize, other: Option<usize>) {
        self.recorder
            .energy_change(time, gained + taken, ball, other);
        if taken > 0.0 {
            self.recorder.energy_change(time, -taken, ball, other);
        }
    }

    /// Balls that moved before this step's exchanges and have come out of them at rest.
    fn stops_after_exchange(&mut self, time: f64) {
        for k in 0..self.exchanged.len() {
            let i = self.exchanged[k];
            if self.stays(i) {
                self.tell(i, EventKind::Stop(self.balls.scene_index[i] as u32), time);
            }
        }
    }

    /// True when the centre of a ball is at rest, and no spin sets it in motion again.
    fn stays(&self, i: usize) -> bool {
        self.balls.speed(i) == 0.0 && !(self.balls.slides(i) && self.cloth.drives_slides())
    }

    /// 3.: the cloth slows every ball. Answers how many balls still move or spin.
    fn friction(&mut self, step: u64) -> usize {
        let moving = self.cloth.act(&mut self.balls, &mut self.ending);
        if self.ending.is_empty() {
            moving
        } else {
            moving + self.end_phases(step)
        }
    }

    /// Friction would turn a motion around within this step: it ends. Answers how many of these balls still move or spin.
    #[cold]
    #[inline(never)]
    fn end_phases(&mut self, step: u64) -> usize {
        let time = self.clock.time(step);
        let mut moving = 0;
        for k in 0..self.ending.len() {
            let i = self.ending[k];
            let end = self.cloth.end(&self.balls, i);
            let (ball, state) = (self.balls.scene_index[i], self.balls.state(i));
            self.recorder.pin(ball, time, &state);
            self.balls.set_motion(i, &end.motion);
            let kinds = [
                (end.slide, EventKind::SlideToRoll(ball as u32)),
                (end.stop, EventKind::Stop(ball as u32)),
                (end.spin, EventKind::SpinEnd(ball as u32)),
            ];
            let ended = kinds.into_iter().filter(|(ends, _)| *ends);
            self.ended.extend(ended.map(|(_, kind)| Ended {
                ball: i,
                kind,
                told: false,
            }));
            moving += usize::from(!self.balls.is_at_rest(i));
        }
        self.ending.clear();
        moving
    }

    /// 4.: a ball past a wall is moved to it and that velocity component is turned inward.
    fn cushions(&mut self, step: u64) {
        if self.walls.look(&self.balls.x, &self.balls.y) {
            self.meet_walls(step);
        }
    }

    #[cold]
    #[inline(never)]
    fn meet_walls(&mut self, step: u64) {
        let Some(law) = self.laws.cushion else {
            return;
        };
        for wall in 0..self.walls.count() {
            for block in 0..self.walls.suspects() {
                for i in self.walls.suspect(block, self.balls.len()) {
                    self.meet_wall(step, law, wall, i);
                }
            }
        }
    }

    /// Ball `i` against one wall, if it is past it.
    fn meet_wall(&mut self, step: u64, law: Cushion, wall: usize, i: usize) {
        let (side, limit) = self.walls.limit(wall, i);
        let outward = f64::from(side.sign());
        let beyond = outward * (self.balls.position(i)[side.axis()] - limit);
        // what is not a number is past no wall
        let past = beyond > 0.0;
        if !past {
            return;
        }
        let time = self.clock.time(step);
        let before = self.balls.state(i);
        let met = outward * before.velocity[side.axis()] > 0.0;
        let energy = self.balls.energy(i);
        let mut taken = 0.0;
        if met {
            self.tell_ended_of(i, time);
            let rebound = cushion::impact(law, &self.balls.body(i), side);
            let (planar, vertical) = rebound.motion.on_cloth();
            self.balls.set_motion(i, &planar);
            taken = self.balls.mass[i] * vertical;
        }
        if side.axis() == 0 {
            self.balls.x[i] = limit;
        } else {
            self.balls.y[i] = limit;
        }
        let after = self.balls.state(i);
        let ball = self.balls.scene_index[i];
        let event = self.recorder.event(
            time,
            EventKind::BallCushion(ball as u32, side),
            Some(u64::from(met)),
        );
        self.recorder.outside(time, beyond, ball);
        self.recorder.jump(ball, time, &before, &after, event);
        if met {
            self.book(time, self.balls.energy(i) - energy, taken, ball, None);
            if self.stays(i) {
                self.tell(i, EventKind::Stop(ball as u32), time);
            }
        }
    }

    /// 5.: positions move with the new velocities.
    fn advance(&mut self) {
        let (balls, dt) = (&mut self.balls, self.dt);
        for (x, v) in balls.x.iter_mut().zip(&balls.vx) {
            *x += v * dt;
        }
        for (y, v) in balls.y.iter_mut().zip(&balls.vy) {
            *y += v * dt;
        }
    }

    /// What ended in this step: it has ended from the end of the step on.
    fn tell_ended(&mut self, time: f64) {
        for k in 0..self.ended.len() {
            self.tell_once(k, time);
        }
        self.ended.clear();
    }

    /// What ended in this step for one ball, before a wall begins something new.
    fn tell_ended_of(&mut self, ball: usize, time: f64) {
        let first = self.ended.partition_point(|ended| ended.ball < ball);
        for k in first..self.ended.len() {
            if self.ended[k].ball > ball {
                break;
            }
            self.tell_once(k, time);
        }
    }

    fn tell_once(&mut self, k: usize, time: f64) {
        let Ended { ball, kind, told } = self.ended[k];
        if !told {
            self.ended[k].told = true;
            self.tell(ball, kind, time);
        }
    }

    /// Tells an event that changes nothing at its time: the end of a phase.
    fn tell(&mut self, i: usize, kind: EventKind, time: f64) {
        let (ball, state) = (self.balls.scene_index[i], self.balls.state(i));
        if let EventKind::Stop(_) = kind {
            self.recorder.stop(ball, time, &state, &state);
        } else {
            self.recorder.phase(ball, time, &state, &state, kind);
        }
    }

    /// True when a centre is in a pocket.
    fn any_pocketed(&self) -> bool {
        let mut any = false;
        for [px, py, radius] in self.pockets {
            let bound = radius * radius;
            for (x, y) in self.balls.x.iter().zip(&self.balls.y) {
                any |= (x - px) * (x - px) + (y - py) * (y - py) <= bound;
            }
        }
        any
    }

    /// After 5.: a ball whose centre is in a pocket leaves play.
    #[cold]
    #[inline(never)]
    fn pocket(&mut self, time: f64) {
        let Some(pockets) = &self.laws.pockets else {
            return;
        };
        self.leaving.clear();
        for i in 0..self.balls.len() {
            let state = self.balls.state(i);
            if let Some(pocket) = pockets::holding(pockets, &state.position) {
                let ball = self.balls.scene_index[i];
                self.recorder.pocket(ball, time, &state, pocket as u32);
                self.leaving.push(i);
            }
        }
        self.balls.remove(&self.leaving);
        self.sizes.remove(&self.leaving);
        self.walls.remove(&self.leaving);
        self.overlaps.remove(&self.leaving);
        self.pairs.forget();
    }
}
