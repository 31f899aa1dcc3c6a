//! The stepping loop, the same for both precisions.

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
    pub engine: &'static str,
    pub version: String,
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
        let provenance = self.provenance();
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
            self.world.step(clock.length(step));
            self.world.read(&mut after);
            if let Some(spot) = self.broken(&after, span.end) {
                break Ending::NotFinite(spot);
            }
            self.world.pushes(&mut pushes);
            journal.step(span, &before, &after, &mut pushes);
            std::mem::swap(&mut before, &mut after);
            step += 1;
        };
        let substeps = step * self.settings.substeps;
        journal.finish(clock.time(step), &before, ending, step, substeps)
    }
}

impl<W: World> Simulation<'_, W> {
    fn provenance(&self) -> Provenance {
        Provenance {
            engine: self.engine.to_owned(),
            version: self.version.clone(),
            parameters: parameters(&self.settings),
            scene: self.scene.name.clone(),
            scene_hash: self.scene.hash(),
            resolution: self.settings.dt,
            rest_speed: rest_speed(self.scene),
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

/// Speed at or below which a ball counts as stopped, length/s: `1e-6 sqrt(g R)`, and 0 where nothing slows a ball.
pub(super) fn rest_speed(scene: &Scene) -> f64 {
    match scene.effects.cloth {
        Some(_) => 1e-6 * (scene.gravity * scene.smallest_radius()).sqrt(),
        None => 0.0,
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
    use super::Clock;

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
