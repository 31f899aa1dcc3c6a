//! How far each ball has turned: what spins add up to.
//!
//! Spins jump at impacts, and two engines put an impact a step apart; what they add up to does not jump.

use super::{Comparison, Measured, Metric, Reads};
use crate::finding::Hold;
use crate::math::Vec3;
use crate::trace::Path;

/// Difference of the angles through which each ball has turned.
pub const TURNED: Metric = Metric {
    id: "turned",
    unit: "rad",
    hold: Hold::Figure,
    what: "difference of the integrals of each ball's spin over time, as vectors",
    reads: Reads::Pair(|c: &Comparison<'_>| {
        if !c.scene.effects.rotates() {
            return Vec::new();
        }
        let end = c.common_end();
        let pairs = c.trace.paths.iter().zip(&c.reference.paths);
        let measured = |(ball, (ours, theirs)): (usize, (&Path, &Path))| Measured {
            subject: c.trace.balls[ball].clone(),
            value: (!c.trace.pocketed(ball) && !c.reference.pocketed(ball))
                .then(|| (turned(ours, end) - turned(theirs, end)).norm()),
        };
        pairs.enumerate().map(measured).collect()
    }),
};

/// The integral of the spin up to `end`, rad; exact for spins that are linear between knots.
fn turned(path: &Path, end: f64) -> Vec3 {
    let mut angle = Vec3::zeros();
    for pair in path.knots.windows(2) {
        let (k0, k1) = (&pair[0], &pair[1]);
        let whole = k1.time - k0.time;
        let h = k1.time.min(end) - k0.time;
        if h > 0.0 {
            let last = k0.state.spin.lerp(&k1.state.spin, h / whole);
            angle += (k0.state.spin + last) * (0.5 * h);
        }
    }
    angle
}

#[cfg(test)]
mod tests {
    use super::turned;
    use crate::math::Vec3;
    use crate::physics::State;
    use crate::trace::{Knot, Path};

    #[test]
    fn a_spin_that_falls_evenly_turns_a_ball_by_half_of_its_start_times_the_time() {
        let knot = |time: f64, spin: f64| Knot {
            time,
            state: State {
                spin: Vec3::new(0.0, 0.0, spin),
                ..State::at_rest(Vec3::zeros())
            },
            after: None,
        };
        // 8 to 0 in 4 s, a jump to 2 that lasts for 1 s
        let path = Path {
            knots: vec![
                knot(0.0, 8.0),
                knot(4.0, 0.0),
                knot(4.0, 2.0),
                knot(5.0, 2.0),
            ],
        };
        for (end, angle) in [(f64::INFINITY, 18.0), (4.0, 16.0), (2.0, 12.0)] {
            assert_eq!(turned(&path, end).z, angle, "up to {end} s");
        }
    }
}
