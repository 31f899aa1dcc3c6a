//! The stepping loop: a world, and what it is called, become a run.

use super::clock::Clock;
use super::journal::Journal;
use super::rest::rest_speed;
use super::world::World;
use crate::engine::{Inside, Limits, Parameter, Run};
use crate::physics::State;
use crate::scene::Scene;
use crate::trace::{Ending, Provenance, Record, Spot, Trace};
use serde_json::Value;
use std::collections::BTreeMap;

/// What a run says of itself, and how its time is cut.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Setup {
    /// Id of the engine.
    pub engine: String,
    /// Name, version and source of what does the work.
    pub version: String,
    /// Every effective parameter, by the key of `--set`.
    pub parameters: BTreeMap<String, Value>,
    /// Every parameter that changes physics.
    pub sheet: Vec<Parameter>,
    /// Step, s, > 0.
    pub dt: f64,
    /// Substeps in a step; 1 for an engine that has none.
    pub substeps: u64,
}

/// A scene inside a world, ready to run.
#[derive(Debug)]
pub struct Stepped<'a, W> {
    scene: &'a Scene,
    world: W,
    inside: Inside,
    setup: Setup,
}

impl<'a, W: World> Stepped<'a, W> {
    /// A run of `scene` in `world`, which holds it. `setup` is told what was read back from inside the world.
    pub fn new(scene: &'a Scene, world: W, setup: impl FnOnce(&Inside) -> Setup) -> Self {
        let inside = world.inside();
        let setup = setup(&inside);
        Stepped {
            scene,
            world,
            inside,
            setup,
        }
    }

    fn provenance(&mut self) -> Provenance {
        Provenance {
            engine: std::mem::take(&mut self.setup.engine),
            version: std::mem::take(&mut self.setup.version),
            parameters: std::mem::take(&mut self.setup.parameters),
            scene: self.scene.name.clone(),
            scene_hash: self.scene.hash(),
            resolution: self.setup.dt,
            rest_speed: rest_speed(self.scene),
            ulp: self.inside.ulp,
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
            why: "a state inside the engine stopped being a number".to_owned(),
        })
    }
}

impl<W: World> Run for Stepped<'_, W> {
    fn inside(&self) -> Inside {
        self.inside.clone()
    }

    fn sheet(&self) -> Vec<Parameter> {
        self.setup.sheet.clone()
    }

    fn simulate(mut self: Box<Self>, record: Record, limits: &Limits<'_>) -> Trace {
        let clock = Clock::new(self.scene.duration, self.setup.dt);
        let mut before = Vec::new();
        self.world.read(&mut before);
        let mut after = before.clone();
        let mut pushes = Vec::new();
        let mut presses = vec![0.0; before.len()];
        let provenance = self.provenance();
        let mut journal = Journal::new(self.scene, provenance, record, &before, self.inside.ulp);
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
        let substeps = step * self.setup.substeps;
        journal.finish(clock.time(step), &before, ending, step, substeps)
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Load, Push};
    use super::*;
    use crate::math::Vec3;
    use crate::physics::Effects;
    use crate::scene::{Ball, Simultaneous, Units};

    /// One ball at speed 1 that stops being a number, or is taken out, in its third step.
    struct Failing {
        steps: u32,
        quarantine: bool,
    }

    impl World for Failing {
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
        fn load(&mut self, _ball: usize, _load: &Load) {}
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
            let world = Failing {
                steps: 0,
                quarantine,
            };
            let run = Stepped::new(&scene, world, |_| Setup {
                dt: 0.1,
                ..Setup::default()
            });
            let trace = Box::new(run).simulate(Record::Events, &Limits::NONE);
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
}
