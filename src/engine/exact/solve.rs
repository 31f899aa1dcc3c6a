//! The event loop: take the earliest event, advance its balls to it, apply its law, predict again.
//!
//! Only the balls of an event are touched. Every other ball stays where its own last event left it, so nothing is
//! accumulated. The loop never decides what the scalar cannot tell: it ends with the reason instead.

use super::cells::{Cells, ENOUGH_BALLS};
use super::collapse::Streaks;
use super::flight::Flight;
use super::predict::{Near, Notes, View};
use super::queue::{Candidate, Queue, What};
use super::spin::Spin;
use super::world::World;
use crate::engine::Limits;
use crate::math::{Real, Vec3};
use crate::physics::{Side, State};
use crate::scene::Scene;
use crate::trace::{Counter, Ending, Provenance, Record, Recorder, Spot, Trace};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::ops::Range;

/// Which balls a prediction looks at. The trace is the same to the bit.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Partners {
    /// Those nearby in scenes of many balls, all in others.
    #[default]
    Auto,
    /// All others.
    All,
    /// Those nearby.
    Cells,
}

/// A run in the scalar `T`.
#[derive(Debug)]
pub struct Solver<'a, T: Real> {
    /// The scene: names, and the third dimension of states.
    pub scene: &'a Scene,
    /// What stays the same.
    pub world: World<T>,
    /// What every ball does now.
    pub flights: Vec<Flight<T>>,
    /// How every ball turns meanwhile; empty in a scene that does not call for rotation.
    pub spins: Vec<Spin<T>>,
    /// Which balls a prediction looks at.
    pub partners: Partners,
}

impl<'a, T: Real> Solver<'a, T> {
    /// A scene at time 0.
    pub fn new(scene: &'a Scene) -> Self {
        let world = World::new(scene);
        let (flights, spins) = world.first_flights(scene);
        Solver {
            scene,
            world,
            flights,
            spins,
            partners: Partners::Auto,
        }
    }

    /// States at time 0, read back from the flights.
    pub fn states(&self) -> Vec<State> {
        let read = |(ball, flight): (usize, &Flight<T>)| {
            self.state(ball, flight.position, flight.velocity, flight.start)
        };
        self.flights.iter().enumerate().map(read).collect()
    }

    /// A state in f64 for the trace: centre and velocity in the plane as given, spin that of the ball's flight at time `t`.
    pub fn state(&self, ball: usize, position: [T; 2], velocity: [T; 2], t: T) -> State {
        self.state_with(ball, position, velocity, self.spin_at(ball, t))
    }

    /// A state in f64 for the trace.
    pub fn state_with(
        &self,
        ball: usize,
        position: [T; 2],
        velocity: [T; 2],
        spin: [T; 3],
    ) -> State {
        let height = self.scene.balls[ball].state.position.z;
        State {
            position: Vec3::new(position[0].to_f64(), position[1].to_f64(), height),
            velocity: Vec3::new(velocity[0].to_f64(), velocity[1].to_f64(), 0.0),
            spin: spin.map(T::to_f64).into(),
        }
    }

    /// Angular velocity of a ball at time `t` of its flight, rad/s; zero in a scene that does not call for rotation.
    pub fn spin_at(&self, ball: usize, t: T) -> [T; 3] {
        match self.spins.get(ball) {
            None => [T::zero(); 3],
            Some(spin) => spin.after(t - self.flights[ball].start),
        }
    }

    /// True while a ball moves or turns.
    pub fn is_active(&self, ball: usize) -> bool {
        self.flights[ball].moves() || self.spins.get(ball).is_some_and(Spin::turns)
    }

    /// Runs to an ending.
    pub fn run(self, provenance: Provenance, record: Record, limits: &Limits<'_>) -> Trace {
        let mut run = self.start(provenance, record);
        let ending = run.play(limits);
        run.finish(ending)
    }

    /// A run that has not begun.
    pub fn start(self, provenance: Provenance, record: Record) -> Loop<'a, T> {
        let recorder = Recorder::new(self.scene, provenance, record, &self.states());
        let n = self.flights.len();
        Loop {
            times: None,
            versions: vec![0; n],
            queue: Queue::new(n),
            notes: Notes {
                root_calls: 0,
                watch: None,
                known: None,
                near: Vec::new(),
            },
            now: T::zero(),
            moving: (0..n).filter(|ball| self.is_active(*ball)).count(),
            turned: Vec::new(),
            streaks: Streaks::new(n),
            recorder,
            counts: Counts::default(),
            cells: None,
            nearby: Vec::new(),
            solver: self,
        }
    }
}

/// Work done.
#[derive(Clone, Copy, Debug, Default)]
pub struct Counts {
    /// Rows of the trace.
    pub events: u64,
    /// Impacts of two balls.
    pub ball_ball: u64,
    /// Impacts on cushions.
    pub ball_cushion: u64,
    /// Balls that left their square of the cells.
    pub cell_crossings: u64,
    /// Layouts of the cells.
    pub cell_layouts: u64,
}

/// How a ball turns on both sides of an impact.
#[derive(Clone, Copy, Debug)]
pub struct Turned<T> {
    /// Index in scene order.
    pub ball: usize,
    /// What it did until now.
    pub spin: Spin<T>,
    /// Angular velocity on the near side.
    pub before: [T; 3],
    /// Angular velocity on the far side.
    pub after: [T; 3],
}

/// A run under way.
pub struct Loop<'a, T: Real> {
    /// Scene, world and flights.
    pub solver: Solver<'a, T>,
    /// How often every ball has changed its flight.
    pub versions: Vec<u32>,
    /// The next event of every ball.
    pub queue: Queue<T>,
    /// What predictions left behind.
    pub notes: Notes<T>,
    /// Time of the latest event, s.
    pub now: T,
    /// Who may meet whom, where there are many balls.
    pub cells: Option<Cells>,
    /// The partners of the prediction at hand.
    pub nearby: Vec<u32>,
    /// Balls that move or turn.
    pub moving: usize,
    /// How the balls of the impact at hand turn, in a scene that calls for rotation.
    pub turned: Vec<Turned<T>>,
    /// How often each ball was hit without time passing.
    pub streaks: Streaks<T>,
    /// The trace.
    pub recorder: Recorder,
    /// Work done.
    pub counts: Counts,
    /// Time of every event in the scalar of the run, where someone asks for it.
    pub times: Option<Vec<T>>,
}

impl<T: Real> Loop<'_, T> {
    /// Runs to an ending; once.
    pub fn play(&mut self, limits: &Limits<'_>) -> Ending {
        if let Some(ending) = self.unfit() {
            return ending;
        }
        self.predict_all();
        loop {
            let (ball, next) = self.queue.first();
            if next.what == What::Nothing {
                return self.nothing_left();
            }
            if limits.is_cancelled() {
                return Ending::Cancelled;
            }
            if self.is_stale(ball, &next) {
                self.now_is(next.time);
                self.predict(ball, None);
                continue;
            }
            if let What::Leaving(a, side) = next.what {
                self.now_is(next.time);
                self.leave(a as usize, side);
                continue;
            }
            if self.counts.events >= limits.max_events {
                let why = format!("the limit of {} events is reached", limits.max_events);
                return Ending::Budget(self.spot(&next.what.balls(), &why));
            }
            self.now_is(next.time);
            let ended = match next.what {
                What::Pair(a, b) => self.pair(a as usize, b as usize),
                What::Cushion(a, side) => self.cushion(a as usize, side),
                What::Pocket(a, pocket) => self.pocket(a as usize, pocket),
                What::End(a) if self.solver.spins.is_empty() => self.phase_end(a as usize),
                What::End(a) => self.turn_end(a as usize),
                What::UnclearPair(a, b) => Some(Ending::Undecidable(self.spot(
                    &[a as usize, b as usize],
                    "they pass so closely, or so slowly, that rounding decides whether they touch",
                ))),
                What::UnclearCushion(a, side) => Some(Ending::Undecidable(self.spot(
                    &[a as usize],
                    &format!(
                        "it stops so close to {} that rounding decides whether it touches",
                        side.id()
                    ),
                ))),
                What::UnclearPocket(a, pocket) => Some(Ending::Undecidable(self.spot(
                    &[a as usize],
                    &format!("it passes pocket p{pocket} so closely that rounding decides whether it falls"),
                ))),
                What::Leaving(..) | What::Nothing => None,
            };
            if let Some(ending) = ended {
                return ending;
            }
        }
    }

    /// The end of a run in which nothing happens any more.
    fn nothing_left(&mut self) -> Ending {
        if self.moving == 0 && !self.solver.scene.run_to_duration {
            return Ending::Rest;
        }
        self.now = self.solver.world.duration;
        Ending::Duration
    }

    fn now_is(&mut self, time: T) {
        self.now = self.now.at_least(time);
    }

    fn is_stale(&self, ball: usize, candidate: &Candidate<T>) -> bool {
        match candidate.what {
            What::Pair(a, b) | What::UnclearPair(a, b) => {
                let other = if a as usize == ball { b } else { a };
                self.versions[other as usize] != candidate.stamp
            }
            What::Cushion(..)
            | What::UnclearCushion(..)
            | What::Pocket(..)
            | What::UnclearPocket(..)
            | What::End(_)
            | What::Leaving(..)
            | What::Nothing => false,
        }
    }

    /// Predicts the next events of all balls, each pair once: the row of the ball that comes later holds it.
    fn predict_all(&mut self) {
        let n = self.versions.len();
        let cells = match self.solver.partners {
            Partners::Auto => n >= ENOUGH_BALLS,
            Partners::All => false,
            Partners::Cells => true,
        };
        // balls that pass through each other need no partners
        if !cells || self.solver.world.contact.is_none() {
            for ball in 0..n {
                self.predict_among(ball, 0..ball);
            }
            return;
        }
        let positions: Vec<[f64; 2]> = (0..n).map(|ball| self.place(ball).map(T::to_f64)).collect();
        self.counts.cell_layouts += 1;
        let world = &self.solver.world;
        let (widest, blur) = (world.widest_distance(), world.blur_of_places());
        self.cells = Some(Cells::over(&positions, widest, blur));
        for (ball, position) in positions.into_iter().enumerate() {
            if let Some(cells) = &mut self.cells {
                cells.enter(ball, position);
            }
            self.predict(ball, None);
        }
    }

    /// Predicts the next event of a ball, but for the encounter `except`.
    pub fn predict(&mut self, ball: usize, except: Option<Near>) {
        let view = View {
            world: &self.solver.world,
            flights: &self.solver.flights,
            versions: &self.versions,
        };
        let all = 0..self.versions.len();
        let next = match &mut self.cells {
            None => view.next_event(ball, self.now, all, except, &mut self.notes),
            Some(cells) => {
                let mut best = view.end(ball);
                let flight = &self.solver.flights[ball];
                if flight.moves() {
                    cells.leaving(ball, flight, self.now, &mut best);
                }
                // what is noted may be farther away than the squares tell
                let watch = self.notes.watch.map_or(0.0, T::to_f64);
                if watch <= cells.slack {
                    cells.around(ball, &mut self.nearby);
                    let nearby = self.nearby.iter().map(|other| *other as usize);
                    view.among(ball, nearby, except, &mut best, &mut self.notes);
                } else {
                    view.among(ball, all, except, &mut best, &mut self.notes);
                }
                best.time = best.time.at_least(self.now);
                best
            }
        };
        self.queue.set(ball, next);
    }

    /// Predicts the next event of a ball among `partners`.
    fn predict_among(&mut self, ball: usize, partners: Range<usize>) {
        let view = View {
            world: &self.solver.world,
            flights: &self.solver.flights,
            versions: &self.versions,
        };
        let next = view.next_event(ball, self.now, partners, None, &mut self.notes);
        self.queue.set(ball, next);
    }

    /// A ball goes on into the next square of the cells.
    fn leave(&mut self, ball: usize, side: Side) {
        self.counts.cell_crossings += 1;
        let Some(cells) = &mut self.cells else {
            return;
        };
        cells.cross(ball, side);
        if cells.worn_out() {
            self.predict_all();
        } else {
            self.predict(ball, None);
        }
    }

    /// Balls that may be within `gap` of a ball, by surfaces; itself included, in scene order.
    pub fn neighbours(&self, ball: usize, gap: T) -> Vec<usize> {
        match &self.cells {
            Some(cells) if gap.to_f64() <= cells.slack => cells.within_slack(ball),
            _ => (0..self.versions.len()).collect(),
        }
    }

    /// Numbers whose products leave the range of the scalar cannot be run.
    fn unfit(&self) -> Option<Ending> {
        let solver = &self.solver;
        let fit = |flight: &Flight<T>| {
            let [x, y] = flight.position;
            let [vx, vy] = flight.velocity;
            let [ax, ay] = flight.acceleration;
            let (p, v, a) = (x * x + y * y, vx * vx + vy * vy, ax * ax + ay * ay);
            (p * v).is_finite() && (p * a).is_finite() && (v * v).is_finite() && (a * a).is_finite()
        };
        let unfit: Vec<usize> = (0..solver.flights.len())
            .filter(|ball| !fit(&solver.flights[*ball]) || self.creeps(*ball))
            .collect();
        let range = solver.world.fastest.is_finite() && solver.world.blur.length.is_finite();
        if unfit.is_empty() && range && solver.world.duration.is_finite() {
            return None;
        }
        Some(Ending::NotFinite(self.spot(
            &unfit,
            "its position or velocity is not a number, or too large or too small to compute with",
        )))
    }

    /// True if a ball is so slow that the square of its speed has lost its digits, and still gets somewhere within the duration:
    /// farther than surfaces that touch may be apart.
    fn creeps(&self, ball: usize) -> bool {
        let world = &self.solver.world;
        let given = self.solver.scene.balls[ball].state.velocity;
        // without squares that vanish
        let path = given.x.hypot(given.y) * world.duration.to_f64();
        // products with the square must keep their digits: a number that survives an ulp of itself has room for them
        let [x, y] = [T::lift(given.x), T::lift(given.y)];
        let square = x * x + y * y;
        let small = T::lift(T::ULP) / T::lift(3.0);
        let lost = (square * small / small - square).abs();
        (square == T::zero() || lost > square * T::lift(16.0 * T::ULP))
            && path > world.touching.to_f64()
    }

    /// Counts an event at this time.
    pub fn count_event(&mut self) {
        self.counts.events += 1;
        if let Some(times) = &mut self.times {
            times.push(self.now);
        }
    }

    /// Here and now.
    pub fn spot(&self, balls: &[usize], why: &str) -> Spot {
        Spot {
            time: self.now.to_f64(),
            balls: balls.iter().map(|b| *b as u32).collect(),
            why: why.to_owned(),
        }
    }

    /// The trace, rounded to f64.
    pub fn finish(self, ending: Ending) -> Trace {
        let read = |ball: usize| {
            let (position, velocity) = self.solver.flights[ball].at(self.now);
            self.solver.state(ball, position, velocity, self.now)
        };
        let states: Vec<State> = (0..self.versions.len()).map(read).collect();
        let counters = [
            (Counter::Events, self.counts.events),
            (Counter::BallBall, self.counts.ball_ball),
            (Counter::BallCushion, self.counts.ball_cushion),
            (Counter::CellCrossings, self.counts.cell_crossings),
            (Counter::CellLayouts, self.counts.cell_layouts),
            (Counter::RootCalls, self.notes.root_calls),
        ];
        self.recorder
            .finish(self.now.to_f64(), &states, ending, counters)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Vec3;
    use crate::physics::{Cloth, Contact, Cushion, Effects};
    use crate::scene::{Ball, Simultaneous, Table, Units};

    fn three_balls() -> Scene {
        let ball = |id: &str, x: f64, y: f64, vx: f64, vy: f64| Ball {
            id: id.to_owned(),
            radius: 0.25,
            mass: 0.17,
            state: State {
                position: Vec3::new(x, y, 0.25),
                velocity: Vec3::new(vx, vy, 0.0),
                spin: Vec3::zeros(),
            },
        };
        Scene {
            name: "three".to_owned(),
            description: String::new(),
            sets: Vec::new(),
            duration: 20.0,
            run_to_duration: false,
            gravity: 9.81,
            units: Units {
                length: "L".to_owned(),
                length_in_metres: None,
                mass: "M".to_owned(),
                mass_in_kg: None,
                time: "s".to_owned(),
            },
            table: Some(Table {
                min: [0.0, 0.0],
                max: [6.0, 10.0],
            }),
            balls: vec![
                ball("a", 1.0, 1.0, 3.0, 6.0),
                ball("b", 2.5, 3.8, 0.0, 0.0),
                ball("c", 4.0, 8.0, -1.0, -2.0),
            ],
            shot: None,
            effects: Effects {
                cloth: Some(Cloth::Translational { mu: 0.2 }),
                contact: Some(Contact::Elastic {}),
                cushion: Some(Cushion::Elastic {}),
                ..Effects::default()
            },
            simultaneous: Simultaneous::Refuse,
            richer: None,
            try_settings: Vec::new(),
        }
    }

    fn run<T: Real>(scene: &Scene) -> Trace {
        Solver::<T>::new(scene).run(Provenance::default(), Record::Events, &Limits::NONE)
    }

    #[test]
    fn another_scalar_runs_the_same_source() {
        let scene = three_balls();
        let (wide, narrow) = (run::<f64>(&scene), run::<f32>(&scene));
        assert_eq!(
            (&wide.ending, &narrow.ending),
            (&Ending::Rest, &Ending::Rest)
        );
        let kinds = |trace: &Trace| -> Vec<_> { trace.events.iter().map(|e| e.kind).collect() };
        assert_eq!(kinds(&wide), kinds(&narrow));
        assert!(wide.counters["ball_ball"] > 0, "{:?}", wide.counters);
        for (a, b) in wide.paths.iter().zip(&narrow.paths) {
            let ends = a.last().zip(b.last());
            let error = ends.map_or(f64::NAN, |(a, b)| (a.position - b.position).norm());
            // an ulp of f32 at 10 is 1e-6; a few hits let it grow
            assert!(error > 0.0 && error < 1e-3, "off by {error:e}");
        }
    }
}
