//! One contract for every engine: what it promises of a scene must hold of every trace.
//!
//! Bounds are those of `law`; measures are taken here anew, from the knots of the paths alone, and no account of an engine is believed: what
//! `check` measures by the extrema of a trace is not measured so again. Each is seen to fail on a fault that those accounts keep silent about.
//!
//! The suite walks the list of engines and runs each on random scenes; an invariant that some engine promises and that was
//! never checked fails the suite, so a crashed or empty run cannot pass.

use crate::support::{R, roster, scenario};
use carom::compare::deepest_overlap;
use carom::engine::{Engine, Limits, Refusal, Roster, Setting, prepare};
use carom::law::{self, closed_forms};
use carom::math::Vec3;
use carom::math::random::Draws;
use carom::physics::invariants::{Invariant, kinetic_energy};
use carom::physics::{
    Cloth, Contact, Cushion, EFFECTS, Effects, Friction, Pockets, State, friction,
};
use carom::scene::{Scene, Table};
use carom::trace::{Ending, Event, EventKind, Record, Trace};
use nalgebra::Vector3;
use std::collections::BTreeMap;

/// Settings under which each engine is held to its promises, besides its defaults.
const VARIANTS: [(&str, &[&str]); 4] = [
    ("stepper", &["contact=approaching-only"]),
    ("stepper", &["dt=0.004"]),
    ("rapier-f64", &["preset=stock"]),
    ("rapier-f32", &["preset=stock"]),
];

const SCENES: u64 = 40;

/// The laws of the report, which no engine may lack.
const REPORTS: [&str; 3] = ["cloth.translational", "contact.elastic", "cushion.elastic"];

/// Half the table: it is symmetric about the origin, so that mirrors and quarter turns are exact in f64.
pub const HALF: f64 = 3.0;

/// A random scene: 1 to 10 balls of one size, not touching, on a square table; friction in two of three.
fn random_scene(index: u64) -> Scene {
    let mut draw = Draws::new(20_261_123, index);
    let balls = 1 + (draw.uniform() * 10.0) as usize;
    let mut scene = scenario(&format!("random-{index}")).duration(8.0);
    let mut placed: Vec<[f64; 2]> = Vec::new();
    while placed.len() < balls {
        let reach = HALF - R;
        let p = [draw.between(-reach, reach), draw.between(-reach, reach)];
        if placed
            .iter()
            .all(|q| (p[0] - q[0]).hypot(p[1] - q[1]) > 2.02 * R)
        {
            let moving = placed.is_empty() || draw.uniform() < 0.4;
            let speed = if moving { 4.0 } else { 0.0 };
            let v = [draw.between(-speed, speed), draw.between(-speed, speed)];
            scene = scene.moving(&placed.len().to_string(), p, v);
            placed.push(p);
        }
    }
    if index.is_multiple_of(3) {
        scene = scene.duration(1.5);
    } else {
        scene = scene.cloth(draw.between(0.1, 0.4));
    }
    let mut scene = scene.cushions(2.0 * HALF, 2.0 * HALF).build();
    scene.table = Some(Table {
        min: [-HALF, -HALF],
        max: [HALF, HALF],
    });
    scene
}

/// Random scenes that name more than the report's laws; an engine is held to those that it can simulate.
const SCENES_WITH_EFFECTS: u64 = 48;

/// A further one of them, in which two balls are pressed together by the cloth until infinitely many impacts fall into finite
/// time: rounding sets the end of that run, and its promises must know.
const SCENE_THAT_COLLAPSES: u64 = 365;

/// Radius of the pockets in the corners. Cushions keep a centre within `HALF - R`, so that it can enter.
const POCKET: f64 = 2.0 * R;

/// A random scene with laws drawn from the whole list: every third without a cloth, every third without rotation of its own;
/// among them balls of several sizes and masses.
fn random_scene_with_effects(index: u64) -> Scene {
    let mut draw = Draws::new(20_261_124, index);
    let balls = 1 + (draw.uniform() * 8.0) as usize;
    let mut scene = scenario(&format!("random-with-effects-{index}"));
    let mut placed: Vec<[f64; 2]> = Vec::new();
    while placed.len() < balls {
        let reach = HALF - R;
        let p = [draw.between(-reach, reach), draw.between(-reach, reach)];
        let in_pocket = (HALF - p[0].abs()).hypot(HALF - p[1].abs()) <= 1.1 * POCKET;
        let free = |q: &[f64; 2]| (p[0] - q[0]).hypot(p[1] - q[1]) > 2.02 * R;
        if !in_pocket && placed.iter().all(free) {
            let moving = placed.is_empty() || draw.uniform() < 0.5;
            let speed = if moving { 4.0 } else { 0.0 };
            let v = [draw.between(-speed, speed), draw.between(-speed, speed)];
            scene = scene.moving(&placed.len().to_string(), p, v);
            placed.push(p);
        }
    }
    let mut scene = scene.cushions(2.0 * HALF, 2.0 * HALF).build();
    scene.table = Some(Table {
        min: [-HALF, -HALF],
        max: [HALF, HALF],
    });
    scene.effects = random_effects(index, &mut draw);
    scene.duration = match scene.effects.cloth {
        None => 1.5,
        Some(Cloth::Translational { .. }) => 8.0,
        // rolling at 0.05 g stops from 6 length units/s after 12 s
        Some(Cloth::Rotational { .. }) => 30.0,
    };
    let rotates = scene.effects.rotates();
    for ball in &mut scene.balls {
        let spins = [0; 3].map(|_| draw.between(-15.0, 15.0));
        if rotates {
            ball.state.spin = Vec3::from(spins);
        }
        if index % 4 >= 2 {
            ball.radius = R * draw.between(0.6, 1.0);
            ball.state.position.z = ball.radius;
        }
        if index % 4 == 3 {
            ball.mass *= draw.between(0.5, 2.0);
        }
    }
    scene
}

fn random_effects(index: u64, draw: &mut Draws) -> Effects {
    let cloth = match index % 3 {
        0 => None,
        1 => Some(Cloth::Translational {
            mu: draw.between(0.1, 0.4),
        }),
        _ => Some(Cloth::Rotational {
            mu_slide: draw.between(0.1, 0.4),
            mu_roll: draw.between(0.05, 0.1),
            mu_spin: draw.between(0.02, 0.1),
        }),
    };
    // a cloth without rotation leaves nothing for laws that turn balls
    let turns = index % 3 != 1;
    let contact = if draw.uniform() < 0.3 {
        Contact::Elastic {}
    } else {
        Contact::Inelastic {
            e: draw.between(0.5, 1.0),
        }
    };
    let friction = match (turns, (draw.uniform() * 3.0) as u32) {
        (false, _) | (true, 0) => None,
        (true, 1) => Some(Friction::Constant {
            mu: draw.between(0.0, 0.3),
        }),
        (true, _) => Some(Friction::Alciatore {
            a: friction::alciatore::PUBLISHED[0],
            b: friction::alciatore::PUBLISHED[1],
            c: friction::alciatore::PUBLISHED[2],
            length_in_metres: 0.12192,
        }),
    };
    let laws = if turns { 4.0 } else { 2.0 };
    let (e, mu, height) = (draw.between(0.5, 0.95), draw.between(0.05, 0.3), 1.28);
    let cushion = match (draw.uniform() * laws) as u32 {
        0 => Cushion::Elastic {},
        1 => Cushion::Restitution { e },
        2 => Cushion::Han2005 { e, mu, height },
        _ => Cushion::Mathavan2010 {
            e,
            mu,
            mu_cloth: 0.2,
            height,
        },
    };
    let corners = [[-1.0, -1.0], [1.0, -1.0], [-1.0, 1.0], [1.0, 1.0]];
    let pockets = (draw.uniform() < 0.5).then(|| Pockets {
        circles: corners.map(|[x, y]| [x * HALF, y * HALF, POCKET]).to_vec(),
    });
    Effects {
        cloth,
        contact: Some(contact),
        friction,
        cushion: Some(cushion),
        pockets,
    }
}

/// A trace that is held to a promise of its engine.
pub struct Case<'a> {
    pub engine: &'a dyn Engine,
    pub setting: &'a Setting,
    pub scene: &'a Scene,
    pub trace: &'a Trace,
}

impl Case<'_> {
    fn rerun(&self, scene: &Scene) -> Trace {
        run(self.engine, self.setting, scene)
    }

    /// Rounding of the engine's scalar.
    fn ulp(&self) -> f64 {
        self.engine.ulp(self.setting)
    }

    /// The run as the bounds of `law` see it.
    fn run(&self) -> law::Run<'_> {
        law::Run {
            ulp: self.ulp(),
            ..law::Run::of(self.scene, self.trace)
        }
    }

    fn within(&self, what: &str, got: f64, bound: f64) -> Result<(), String> {
        // a NaN is not within anything
        if got <= bound {
            Ok(())
        } else {
            Err(format!("{what} is {got:e}, bound {bound:e}"))
        }
    }

    pub fn check(&self, invariant: Invariant) -> Result<(), String> {
        let (trace, scene) = (self.trace, self.scene);
        let everyone = || (0..scene.balls.len()).collect();
        match invariant {
            Invariant::Finite => self.finite(),
            Invariant::Momentum => {
                let bound = law::momentum::bound(scene, self.ulp());
                let said = trace.extrema.momentum.value;
                self.within("momentum error by its own account", said, bound)?;
                self.momentum(bound)
            }
            Invariant::ImpactEnergy => self.within(
                "energy error of an impact",
                self.impact_energy(),
                law::impact_energy::bound(scene.initial_energy(), self.ulp()),
            ),
            Invariant::EnergyNeverGrows => {
                let energy = scene.initial_energy();
                let once = 16.0 * self.ulp() * energy;
                let events = trace.events.len() as f64 + 1.0;
                let said = trace.extrema.energy_gained.value;
                self.within("energy gained by its own account", said, once * events)?;
                let bound = law::energy::bound(&self.run()) * energy;
                self.within("energy gained", self.energy_gained(), bound)
            }
            Invariant::Bounds => self.bounds(),
            Invariant::Overlap => self.within(
                "overlap by parry",
                deepest_overlap(scene, trace),
                law::overlap::of_a_pair(&self.run()),
            ),
            Invariant::EverythingStops => match trace.ending {
                Ending::Rest => Ok(()),
                ref other => Err(format!("ended as {other:?}")),
            },
            Invariant::Rerun => same(trace, &self.rerun(scene)),
            Invariant::Mirror => {
                let mirror = |v: Vec3| Vec3::new(-v.x, v.y, v.z);
                self.transformed(mirror, -1.0, everyone())
            }
            Invariant::QuarterTurn => {
                let turn = |v: Vec3| Vec3::new(-v.y, v.x, v.z);
                self.transformed(turn, 1.0, everyone())
            }
            Invariant::Relabelling => {
                self.transformed(|v| v, 1.0, (0..scene.balls.len()).rev().collect())
            }
            Invariant::Scaling => self.scaled(),
            Invariant::TimeReversal => self.reversed(),
            Invariant::Laws => match closed_forms::check(scene, trace).faults.first() {
                None => Ok(()),
                Some(fault) => Err(format!("{}: {}", fault.what, fault.words)),
            },
        }
    }

    fn finite(&self) -> Result<(), String> {
        let finite = |s: &State| {
            let numbers = s.position.iter().chain(&s.velocity).chain(&s.spin);
            numbers.into_iter().all(|x| x.is_finite())
        };
        let mut knots = self.trace.paths.iter().flat_map(|path| &path.knots);
        match knots.find(|knot| !finite(&knot.state)) {
            Some(knot) => Err(format!("state {knot:?}")),
            None => Ok(()),
        }
    }

    /// What is summed over both sides of each ball-ball event, in plan: a table takes what is vertical.
    fn of_impacts<T: std::ops::Add<Output = T> + Copy>(
        &self,
        zero: T,
        change: impl Fn(usize, &State, &State) -> T,
    ) -> Vec<(usize, T)> {
        let mut sums = BTreeMap::new();
        for (ball, path) in self.trace.paths.iter().enumerate() {
            for pair in path.knots.windows(2) {
                if let Some(event) = pair[1].after {
                    let sum = sums.entry(event).or_insert(zero);
                    *sum = *sum + change(ball, &pair[0].state, &pair[1].state);
                }
            }
        }
        let met = |event: u32| {
            let kind = self.trace.events[event as usize].kind;
            matches!(kind, EventKind::BallBall(..))
        };
        let own = sums.into_iter().filter(|(event, _)| met(*event));
        own.map(|(event, sum)| (event as usize, sum)).collect()
    }

    /// True where a ball of an event meets something else within a step: what a step does to a ball is then of both.
    fn is_crowded(&self, event: usize) -> bool {
        let (events, step) = (&self.trace.events, self.trace.provenance.resolution);
        let own = events[event];
        let near = |other: &Event| {
            let apart = (other.time - own.time).abs();
            other.kind.is_collision() && other.kind.shares_ball(own.kind) && apart <= 1.5 * step
        };
        let others = events.iter().enumerate().filter(|(at, _)| *at != event);
        step > 0.0 && others.map(|(_, other)| other).any(near)
    }

    /// Each impact keeps the momentum of its two balls, in each of its exchanges.
    fn momentum(&self, bound: f64) -> Result<(), String> {
        // a pair that the cloth presses together: a step tells one impact of as many as there is no number for
        let pressed = format!("random-with-effects-{SCENE_THAT_COLLAPSES}");
        if self.trace.provenance.resolution > 0.0 && self.scene.name == pressed {
            return Ok(());
        }
        let change = |ball: usize, near: &State, far: &State| {
            let p = (far.velocity - near.velocity) * self.scene.balls[ball].mass;
            Vector3::new(p.x, p.y, 0.5)
        };
        for (event, sum) in self.of_impacts(Vector3::zeros(), change) {
            if self.is_crowded(event) {
                continue;
            }
            let told = self.trace.events[event].exchanges.unwrap_or(1);
            let exchanges = sum.z.max(told as f64);
            let allowed = exchanges * (bound + self.pull());
            self.within("momentum error", sum.xy().norm(), allowed)?;
        }
        Ok(())
    }

    /// What the cloth takes of the momentum of two balls in a step: both sides of an impact may be a step apart.
    fn pull(&self) -> f64 {
        let mu = match self.scene.effects.cloth {
            None => 0.0,
            Some(Cloth::Translational { mu } | Cloth::Rotational { mu_slide: mu, .. }) => mu,
        };
        let step = self.trace.provenance.resolution;
        2.0 * law::momentum::heaviest(self.scene) * mu * self.scene.gravity * step
    }

    fn energy(&self, ball: usize, state: &State) -> f64 {
        let own = &self.scene.balls[ball];
        kinetic_energy(state, own.mass, self.scene.inertia(ball))
    }

    /// Largest change of energy in an impact, from both sides of it.
    fn impact_energy(&self) -> f64 {
        let change = |ball: usize, near: &State, far: &State| {
            self.energy(ball, far) - self.energy(ball, near)
        };
        let changes = self.of_impacts(0.0, change);
        changes
            .iter()
            .map(|(_, change)| change.abs())
            .fold(0.0, f64::max)
    }

    /// Largest rise above an earlier level of the energy that all balls had at their last knots.
    fn energy_gained(&self) -> f64 {
        let paths = self.trace.paths.iter().enumerate();
        let knots = paths.flat_map(|(ball, path)| {
            let own = path.knots.iter().enumerate();
            own.map(move |(at, knot)| (knot.time, at, ball))
        });
        let mut knots: Vec<(f64, usize, usize)> = knots.collect();
        knots.sort_by(|a, b| a.partial_cmp(b).unwrap());
        let balls = self.scene.balls.iter().enumerate();
        let mut now: Vec<f64> = balls.map(|(i, b)| self.energy(i, &b.state)).collect();
        let (mut least, mut most) = (now.iter().sum::<f64>(), 0.0_f64);
        for together in knots.chunk_by(|a, b| a.0 == b.0) {
            for &(_, at, ball) in together {
                now[ball] = self.energy(ball, &self.trace.paths[ball].knots[at].state);
            }
            let all: f64 = now.iter().sum();
            most = most.max(all - least);
            least = least.min(all);
        }
        most
    }

    /// Every centre, on the table of [`HALF`], within what its cushions let it.
    fn bounds(&self) -> Result<(), String> {
        let reach = self.run().reach();
        for (ball, path) in self.trace.paths.iter().enumerate() {
            let edge = HALF - self.scene.balls[ball].radius;
            let beyond = |s: &State| s.position.x.abs().max(s.position.y.abs()) - edge;
            let all = path.knots.iter().map(|knot| beyond(&knot.state));
            let farthest = all.fold(f64::NEG_INFINITY, f64::max);
            let allowed = law::outside::bound(&reach, ball);
            self.within(
                &format!("distance outside of ball {ball}"),
                farthest,
                allowed,
            )?;
        }
        Ok(())
    }

    /// The trace of the transformed scene is the transformed trace, up to rounding times the growth of an error. `hand`: -1 for a
    /// map that turns right hands into left ones, by which spins change sign besides.
    fn transformed(
        &self,
        map: impl Fn(Vec3) -> Vec3,
        hand: f64,
        order: Vec<usize>,
    ) -> Result<(), String> {
        let mapped = |s: &State| State {
            position: map(s.position),
            velocity: map(s.velocity),
            spin: map(s.spin) * hand,
        };
        let mut scene = self.scene.clone();
        scene.balls = order.iter().map(|&i| self.scene.balls[i].clone()).collect();
        for ball in &mut scene.balls {
            ball.state = mapped(&ball.state);
        }
        for circle in scene
            .effects
            .pockets
            .iter_mut()
            .flat_map(|p| &mut p.circles)
        {
            let centre = map(Vec3::new(circle[0], circle[1], 0.0));
            (circle[0], circle[1]) = (centre.x, centre.y);
        }
        let other = self.rerun(&scene);
        let mut expected = self.trace.clone();
        expected.paths = order.iter().map(|&i| self.trace.paths[i].clone()).collect();
        for knot in expected.paths.iter_mut().flat_map(|path| &mut path.knots) {
            knot.state = mapped(&knot.state);
        }
        self.within(
            "distance of the final states",
            apart(&expected, &other),
            self.rounding_grown(),
        )
    }

    /// Lengths, speeds and gravity times four: the same times, lengths times four.
    fn scaled(&self) -> Result<(), String> {
        let mut scene = self.scene.clone();
        scene.gravity *= 4.0;
        scene.table = scene.table.map(|t| Table {
            min: t.min.map(|x| 4.0 * x),
            max: t.max.map(|x| 4.0 * x),
        });
        for ball in &mut scene.balls {
            ball.radius *= 4.0;
            ball.state.position *= 4.0;
            ball.state.velocity *= 4.0;
        }
        for circle in scene
            .effects
            .pockets
            .iter_mut()
            .flat_map(|p| &mut p.circles)
        {
            *circle = circle.map(|length| 4.0 * length);
        }
        // a law with constants in metres: the same scene in another unit
        if let Some(Friction::Alciatore {
            length_in_metres, ..
        }) = &mut scene.effects.friction
        {
            *length_in_metres /= 4.0;
        }
        let mut other = self.rerun(&scene);
        for knot in other.paths.iter_mut().flat_map(|path| &mut path.knots) {
            knot.state.position /= 4.0;
            knot.state.velocity /= 4.0;
        }
        self.within(
            "distance of the final states",
            apart(self.trace, &other),
            self.rounding_grown(),
        )
    }

    /// Run, turn every velocity round, run as long again: back at the start.
    fn reversed(&self) -> Result<(), String> {
        let mut scene = self.scene.clone();
        for (ball, path) in scene.balls.iter_mut().zip(&self.trace.paths) {
            let end = path.last().unwrap();
            ball.state.position = end.position;
            ball.state.velocity = -end.velocity;
            ball.state.spin = -end.spin;
        }
        let back = self.rerun(&scene);
        let distance = |(i, path): (usize, &carom::trace::Path)| {
            (path.last().unwrap().position - self.scene.balls[i].state.position).norm()
        };
        let worst = back
            .paths
            .iter()
            .enumerate()
            .map(distance)
            .fold(0.0, f64::max);
        // there and back: the error of the way there grows on the way back too
        self.within(
            "distance from the start",
            worst,
            law::time_reversal::bound(self.rounding_grown(), self.growth()),
        )
    }

    /// By how much an error of the start has grown at the end: measured by moving the first moving ball by 1e-7 R.
    fn growth(&self) -> f64 {
        let nudge = 1e-7 * R;
        let mut worst = 1.0_f64;
        for axis in 0..2 {
            let mut scene = self.scene.clone();
            scene.balls[0].state.position[axis] += nudge;
            worst = worst.max(apart(self.trace, &self.rerun(&scene)) / nudge);
        }
        worst
    }

    /// Rounding of coordinates of the size of the table, once per event, times the growth measured above and a factor of 100
    /// for the directions that were not tried.
    fn rounding_grown(&self) -> f64 {
        100.0 * self.ulp() * HALF * (self.trace.events.len() as f64 + 1.0) * self.growth()
    }
}

/// Largest distance of a ball between the ends of two traces, or infinity if their events differ in number. Two runs that
/// collapse are compared at the earlier of their ends: rounding says which impact is the last that can be told apart.
fn apart(a: &Trace, b: &Trace) -> f64 {
    let collapse = |trace: &Trace| matches!(trace.ending, Ending::Collapsed(_));
    let end = match (collapse(a), collapse(b)) {
        (true, true) => a.end_time.min(b.end_time),
        (false, false) if a.events.len() == b.events.len() => f64::INFINITY,
        _ => return f64::INFINITY,
    };
    // with one ending at a time of its own, states are those at the ends
    let last = |path: &carom::trace::Path| match end.is_finite() {
        true => path.state_at(end).or(path.last()),
        false => path.last(),
    };
    let ends = a.paths.iter().zip(&b.paths);
    ends.map(|(p, q)| (last(p).unwrap().position - last(q).unwrap().position).norm())
        .fold(0.0, f64::max)
}

fn same(a: &Trace, b: &Trace) -> Result<(), String> {
    let first = |x: &[Event], y: &[Event]| x.iter().zip(y).position(|(p, q)| p != q);
    match a == b {
        true => Ok(()),
        false => Err(format!(
            "differs; first differing event {:?}",
            first(&a.events, &b.events)
        )),
    }
}

fn run(engine: &dyn Engine, setting: &Setting, scene: &Scene) -> Trace {
    let run = prepare(engine, scene, setting)
        .unwrap_or_else(|refusal| panic!("{} on {}: {refusal}", engine.id(), scene.name));
    run.simulate(Record::Every(0.02), &Limits::NONE)
}

/// How often each law was seen and each invariant held, by engine.
#[derive(Default)]
struct Counts {
    checked: BTreeMap<(String, &'static str), u64>,
    held: BTreeMap<(String, &'static str), u64>,
}

/// Holds every engine of a roster to the contract, by its defaults and in `variants`.
pub fn hold_contract(roster: &Roster, variants: &[(&str, &[&str])]) {
    hold(roster, variants);
}

fn hold(roster: &Roster, variants: &[(&str, &[&str])]) -> Counts {
    let mut counts = Counts::default();
    let mut promised: Vec<(String, &str)> = Vec::new();
    let mut broken = Vec::new();
    let defaults = roster.iter().map(|engine| (engine.id(), &[] as &[&str]));
    for (id, settings) in defaults.chain(variants.iter().copied()) {
        let engine = roster.find(id).unwrap().as_ref();
        let setting = Setting::parse(settings.iter().copied()).unwrap();
        // a run of rapier costs a thousand times one of exact
        let scenes = if id.starts_with("rapier") {
            SCENES / 10
        } else {
            SCENES
        };
        let plain = (0..scenes).map(random_scene);
        let some = 0..SCENES_WITH_EFFECTS * scenes / SCENES;
        let with_effects = some
            .chain([SCENE_THAT_COLLAPSES])
            .map(random_scene_with_effects);
        for scene in plain.chain(with_effects) {
            let missing = engine.missing(&scene);
            if !missing.is_empty() {
                assert!(
                    missing
                        .iter()
                        .all(|effect| !REPORTS.contains(&effect.as_ref())),
                    "{id} lacks {missing:?}"
                );
                continue;
            }
            match prepare(engine, &scene, &setting) {
                Ok(_) => {}
                // the report's exchange is one of equal masses
                Err(Refusal::Setting { .. }) if !scene.equal_masses() => continue,
                Err(refusal) => panic!("{id} {settings:?} on {}: {refusal}", scene.name),
            }
            let trace = run(engine, &setting, &scene);
            for effect in scene.effects.named() {
                *counts.held.entry((id.to_owned(), effect)).or_default() += 1;
            }
            let case = Case {
                engine,
                setting: &setting,
                scene: &scene,
                trace: &trace,
            };
            for invariant in engine.promises(&scene, &setting) {
                let key = (id.to_owned(), invariant.id());
                promised.push(key.clone());
                match case.check(invariant) {
                    Ok(()) => *counts.checked.entry(key).or_default() += 1,
                    Err(why) => broken.push(format!(
                        "{id} {settings:?} in scene {}: {}: {why}",
                        scene.name,
                        invariant.id()
                    )),
                }
            }
        }
    }
    assert!(
        broken.is_empty(),
        "{} broken promises:\n{}",
        broken.len(),
        broken.join("\n")
    );
    for key in promised {
        assert!(
            counts.checked.contains_key(&key),
            "{key:?} was promised and never held"
        );
    }
    for engine in roster {
        let of = |id| (engine.id().to_owned(), id);
        for effect in REPORTS {
            assert!(counts.held[&of(effect)] >= 2, "{} {effect}", engine.id());
        }
        for invariant in [Invariant::Finite, Invariant::Momentum, Invariant::Rerun] {
            let times = counts.checked[&of(invariant.id())];
            assert!(times >= 4, "{} {}", engine.id(), invariant.id());
        }
    }
    counts
}

#[test]
fn every_engine_keeps_its_promises_in_random_scenes() {
    let counts = hold(roster(), &VARIANTS);
    // two engines simulate everything that a scene can name, and were seen to
    for (engine, effect) in ["exact", "stepper"]
        .iter()
        .flat_map(|e| EFFECTS.iter().map(|f| (*e, f.id)))
    {
        let scenes = counts.held.get(&(engine.to_owned(), effect)).copied();
        let scenes = scenes.unwrap_or(0);
        assert!(scenes >= 4, "{engine} {effect}: held in {scenes} scenes");
    }
}
