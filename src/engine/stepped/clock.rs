//! The clock of every engine that steps: how a duration is cut into steps, and how many of them are too many.

use crate::engine::Refusal;
use crate::engine::setting::refuse;
use crate::scene::Scene;

/// A duration that is this close to a whole number of steps, relative to it, takes exactly that number: it must not gain a step of
/// rounding length.
const WHOLE: f64 = 1e-9;

/// A step whose length differs from the others' by less than this part is as long as they are: times are products, and round.
const SHORTER: f64 = 1e-6;

/// How a duration is cut into steps. The last one is shorter where the step does not divide the duration.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Clock {
    /// Simulated time in all, s.
    pub duration: f64,
    /// The step, s.
    pub dt: f64,
    /// Number of steps, 1 or more.
    pub steps: u64,
}

/// One step, s.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Span {
    /// When it begins.
    pub start: f64,
    /// When it ends.
    pub end: f64,
}

impl Clock {
    /// Cuts `duration` into steps of `dt`, both s and above 0.
    pub fn new(duration: f64, dt: f64) -> Self {
        let exact = duration / dt;
        let steps = if (exact - exact.round()).abs() <= WHOLE * exact {
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
    #[inline]
    pub fn time(&self, step: u64) -> f64 {
        if step >= self.steps {
            self.duration
        } else {
            step as f64 * self.dt
        }
    }

    /// From when to when a step lasts; the first is 0.
    pub fn span(&self, step: u64) -> Span {
        Span {
            start: self.time(step),
            end: self.time(step + 1),
        }
    }

    /// Length of a step, s: dt itself and not a difference of times, except for a shorter last one.
    pub fn length(&self, step: u64) -> f64 {
        let span = self.span(step);
        let length = span.end - span.start;
        if (length - self.dt).abs() <= SHORTER * self.dt {
            self.dt
        } else {
            length
        }
    }
}

/// Refuses a step by which a scene takes more than `most` steps, or none. `key`: of the setting that is the step.
pub fn check_step(key: &str, dt: f64, scene: &Scene, most: f64) -> Result<(), Refusal> {
    let steps = scene.duration / dt;
    if dt > 0.0 && steps <= most {
        return Ok(());
    }
    let longest = format!("the {} s of scene {}", scene.duration, scene.name);
    let message = if dt > 0.0 {
        format!(
            "`{key}={dt}`: {longest} would take {steps:.1e} steps, more than {most:.0e}; raise {key}"
        )
    } else {
        format!("`{key}={dt}`: expected a step above 0 s, for {longest}")
    };
    Err(refuse(Some(key), message))
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
        for (duration, dt, steps) in [
            (1.0, 0.3, 4),
            (1.0, 0.03, 34),
            (1.0, 7.0, 1),
            (0.001, 1.0 / 60.0, 1),
        ] {
            let clock = Clock::new(duration, dt);
            assert_eq!(clock.steps, steps, "{duration} in {dt}");
            let total: f64 = (0..clock.steps).map(|step| clock.length(step)).sum();
            assert!(
                (total - duration).abs() < 1e-15 * clock.steps as f64,
                "{duration} in {dt}: {total}"
            );
        }
    }
}
