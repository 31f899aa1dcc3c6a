//! The stepping loop, the same for both precisions.

use super::cloth::rest_speed;
use super::interface::World;
use super::journal::{Journal, Span};
use super::settings::Settings;
use super::sheet;
use crate::engine::setting::parameters;
use crate::engine::{Inside, Limits, Parameter, Run};
use crate::physics::State;
use crate::scene::Scene;
use crate::trace::{Ending, Provenance, Record, Spot, Trace};

/// A scene inside rapier, ready to run.
pub(super) struct Simulation<'a, W> {
    pub scene: &'a Scene,
    pub settings: Settings,
    pub world: W,
    pub provenance: Provenance,
}

impl<W: World> Run for Simulation<'_, W> {
    fn inside(&self) -> Inside {
        self.world.inside()
    }

    fn sheet(&self) -> Vec<Parameter> {
        sheet::sheet(
            self.scene,
            &self.settings,
            &self.world.inside(),
            self.world.gravity(),
        )
    }

    fn simulate(mut self: Box<Self>, record: Record, limits: &Limits<'_>) -> Trace {
        let clock = Clock::new(self.scene.duration, self.settings.dt);
        let mut before = Vec::new();
        self.world.read(&mut before);
        let mut after = before.clone();
        let mut pushes = Vec::new();
        let mut presses = vec![0.0; before.len()];
        let provenance = std::mem::take(&mut self.provenance);
        let mut journal = Journal::new(self.scene, provenance, record, &before, W::ULP);
        let mut step = 0;
        let ending = loop {
            if !self.scene.run_to_duration && journal.all_at_rest(&before) {
                break Ending::Rest;
            }
            if step == clock.steps {
                break Ending::Duration;
            }
            if limits.is_cancelled() {
                break Ending::Cancelled;
            }
            let span = clock.span(step);
            let dt = clock.length(step);
            if journal.loads() {
                for (ball, state) in before.iter().enumerate() {
                    self.world.load(ball, &journal.load(ball, state, dt));
                }
            }
            self.world.step(dt);
            self.world.read(&mut after);
            if let Some(spot) = self.broken(&after, span.end) {
                break Ending::NotFinite(spot);
            }
            self.world.pushes(&mut pushes);
            if journal.loads() {
                self.world.presses(&mut presses);
            }
            journal.step(span, &before, &after, &mut pushes, &presses);
            for ball in journal.left() {
                self.world.remove(*ball);
            }
            std::mem::swap(&mut before, &mut after);
            step += 1;
        };
        let substeps = step * self.settings.substeps;
        journal.finish(clock.time(step), &before, ending, step, substeps)
    }
}

impl<'a, W: World> Simulation<'a, W> {
    /// A run of `scene` in `world`, which holds it.
    pub fn new(
        scene: &'a Scene,
        settings: Settings,
        world: W,
        engine: &str,
        version: String,
    ) -> Self {
        Simulation {
            provenance: Provenance {
                engine: engine.to_owned(),
                version,
                parameters: parameters(&settings),
                scene: scene.name.clone(),
                scene_hash: scene.hash(),
                resolution: settings.dt,
                rest_speed: rest_speed(scene),
            },
            scene,
            settings,
            world,
        }
    }

    /// The balls that stopped being numbers in the step that ends at `time`.
    fn broken(&self, states: &[State], time: f64) -> Option<Spot> {
        let is_finite = |state: &State| {
            let sum = state.position + state.velocity + state.spin;
            sum.iter().all(|x| x.is_finite())
        };
        let mut balls = self.world.quarantined();
        balls.extend((0..states.len() as u32).filter(|i| !is_finite(&states[*i as usize])));
        balls.sort_unstable();
        balls.dedup();
        (!balls.is_empty()).then(|| Spot {
            time,
            balls,
            why: "a state inside rapier stopped being a number".to_owned(),
        })
    }
}

/// How a duration is cut into steps. The last one is shorter where the step does not divide the duration.
struct Clock {
    duration: f64,
    dt: f64,
    steps: u64,
}

impl Clock {
    fn new(duration: f64, dt: f64) -> Self {
        let exact = duration / dt;
        // a duration that dt divides must not gain a step of rounding length
        let steps = if (exact - exact.round()).abs() <= 1e-9 * exact {
            exact.round()
        } else {
            exact.ceil()
        };
        Clock {
            duration,
            dt,
            steps: steps.max(1.0) as u64,
        }
    }

    /// The end of the first `step` steps, s.
    fn time(&self, step: u64) -> f64 {
        if step >= self.steps {
            self.duration
        } else {
            step as f64 * self.dt
        }
    }

    fn span(&self, step: u64) -> Span {
        Span {
            start: self.time(step),
            end: self.time(step + 1),
        }
    }

    /// Length of a step, s: dt itself and not a difference of times, except for a shorter last one.
    fn length(&self, step: u64) -> f64 {
        let span = self.span(step);
        let length = span.end - span.start;
        if (length - self.dt).abs() <= 1e-6 * self.dt {
            self.dt
        } else {
            length
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::engine::rapier::interface::Push;
    use crate::math::Vec3;
    use crate::physics::Effects;
    use crate::scene::{Ball, Simultaneous, Units};

    /// One ball at speed 1 that stops being a number, or is taken out, in its third step.
    struct Failing {
        steps: u32,
        quarantine: bool,
    }

    impl World for Failing {
        const ULP: f64 = f64::EPSILON;
        fn step(&mut self, _dt: f64) {
            self.steps += 1;
        }
        fn read(&self, states: &mut Vec<State>) {
            let broken = self.steps == 3 && !self.quarantine;
            let x = if broken {
                f64::NAN
            } else {
                0.1 * f64::from(self.steps)
            };
            *states = vec![State {
                velocity: Vec3::x(),
                ..State::at_rest(Vec3::new(x, 0.0, 1.0))
            }];
        }
        fn pushes(&self, pushes: &mut Vec<Push>) {
            pushes.clear();
        }
        fn load(&mut self, _ball: usize, _load: &crate::engine::rapier::cloth::Load) {}
        fn remove(&mut self, _ball: usize) {}
        fn presses(&self, presses: &mut Vec<f64>) {
            *presses = vec![0.0];
        }
        fn quarantined(&self) -> Vec<u32> {
            vec![0; usize::from(self.steps == 3 && self.quarantine)]
        }
        fn inside(&self) -> Inside {
            Inside {
                balls: Vec::new(),
                inertia: Vec::new(),
                energy: 0.0,
                materials: Vec::new(),
                ulp: f64::EPSILON,
                contact_time: None,
            }
        }
        fn gravity(&self) -> f64 {
            0.0
        }
    }

    fn one_ball() -> Scene {
        let mut states = Vec::new();
        let world = Failing {
            steps: 0,
            quarantine: false,
        };
        world.read(&mut states);
        Scene {
            name: "failing".into(),
            description: String::new(),
            sets: Vec::new(),
            duration: 1.0,
            run_to_duration: false,
            gravity: 0.0,
            units: Units {
                length: "m".into(),
                length_in_metres: None,
                mass: "kg".into(),
                mass_in_kg: None,
                time: "s".into(),
            },
            table: None,
            balls: vec![Ball {
                id: "cue".into(),
                radius: 1.0,
                mass: 1.0,
                state: states[0],
            }],
            shot: None,
            effects: Effects::default(),
            simultaneous: Simultaneous::Refuse,
            richer: None,
            try_settings: Vec::new(),
        }
    }

    #[test]
    fn a_number_that_stops_being_one_ends_the_run_at_the_last_good_step() {
        for quarantine in [false, true] {
            let scene = one_ball();
            let settings = Settings {
                dt: 0.1,
                ..Settings::default()
            };
            let world = Failing {
                steps: 0,
                quarantine,
            };
            let simulation = Simulation::new(&scene, settings, world, "failing", String::new());
            let trace = Box::new(simulation).simulate(Record::Events, &Limits::NONE);
            let spot = trace.ending.spot().cloned();
            assert!(
                matches!(trace.ending, Ending::NotFinite(_)),
                "{:?}",
                trace.ending
            );
            let spot = spot.unwrap_or_else(|| panic!("no spot"));
            assert_eq!(spot.balls, [0], "quarantine {quarantine}");
            assert!((spot.time - 0.3).abs() < 1e-15, "quarantine {quarantine}");
            assert_eq!(trace.end_time, 0.2, "quarantine {quarantine}");
            let last = trace.paths[0].last();
            assert_eq!(last.map(|state| state.position.x), Some(0.2));
        }
    }

    #[test]
    fn a_step_that_divides_the_duration_is_never_shortened() {
        for (duration, dt) in [(2.0, 1e-3), (20.0, 1.0 / 60.0), (0.3, 0.1), (4.0, 1e-4)] {
            let clock = Clock::new(duration, dt);
            assert_eq!(
                clock.steps as f64,
                (duration / dt).round(),
                "{duration} in {dt}"
            );
            assert_eq!(clock.time(clock.steps), duration);
            assert_eq!(clock.length(clock.steps - 1), dt, "{duration} in {dt}");
        }
    }

    #[test]
    fn a_step_that_does_not_divide_the_duration_leaves_a_shorter_last_one() {
        for (duration, dt, steps) in [(1.0, 0.3, 4), (1.0, 7.0, 1), (0.001, 1.0 / 60.0, 1)] {
            let clock = Clock::new(duration, dt);
            assert_eq!(clock.steps, steps, "{duration} in {dt}");
            let total: f64 = (0..clock.steps).map(|step| clock.length(step)).sum();
            assert!(
                (total - duration).abs() < 1e-15,
                "{duration} in {dt}: {total}"
            );
        }
    }
}
