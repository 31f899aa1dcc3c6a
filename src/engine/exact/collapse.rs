//! When impacts follow each other too closely to be finite in number.
//!
//! An event-driven run can be asked for infinitely many impacts before some time. Inelastic balls that are pressed together do it with intervals
//! that shrink by a factor each time, and so do elastic ones on a cloth (by .78 where a sliding ball presses on a rolling one), because rolling gives
//! back 2/7 of each impulse; only elastic balls that slide or meet no cloth do not. Where contacts are followed the run goes on from the limit
//! (`finer`). This room is for where they are not, and for balls without a cloth: no number of events gets past the limit's time, so the
//! run must end and say so. One sign is counted for each ball: it is hit again and again while the clock stands still (its time advances by less
//! than rounding).
//!
//! Intervals that shrink by a fixed part lead to it: a geometric sequence reaches the resolution of the clock after
//! `log(resolution) / log(ratio)` impacts and stands still from there on. Nothing that ends by itself is cut short.

use crate::math::Real;

/// Impacts of one ball at one instant beyond which it counts as collapsed. Elastic balls can need many (a light ball between two
/// heavy ones), but no finite cluster of a real scene comes near it.
pub const MOST_IMPACTS_AT_ONCE: u32 = 10_000;

/// Two impacts closer than this many ulps of the time are at one instant.
const RESOLUTION: f64 = 16.0;

/// Counts, for each ball, the impacts while no time passes.
#[derive(Clone, Debug)]
pub struct Streaks<T> {
    /// Since when, and how often.
    balls: Vec<(T, u32)>,
}

impl<T: Real> Streaks<T> {
    /// No impacts yet of `n` balls.
    pub fn new(n: usize) -> Self {
        Streaks {
            balls: vec![(T::zero(), 0); n],
        }
    }

    /// Counts an impact of `balls` at time `now`, s; answers, in one sentence, when one of them has been hit too often.
    pub fn count(&mut self, balls: impl IntoIterator<Item = usize>, now: T) -> Option<String> {
        let resolution = now * T::lift(RESOLUTION * T::ULP);
        let mut collapsed = None;
        for ball in balls {
            let (since, count) = &mut self.balls[ball];
            if now - *since > resolution {
                *since = now;
                *count = 0;
            }
            *count += 1;
            if *count > MOST_IMPACTS_AT_ONCE {
                collapsed = Some(format!(
                    "more than {MOST_IMPACTS_AT_ONCE} impacts without time passing"
                ));
            }
        }
        collapsed
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A ball that bounces on a floor under gravity 1 with restitution `e`: its impacts, as far as the clock counts them.
    fn bounces(e: f64, most: usize) -> impl Iterator<Item = f64> {
        let (mut time, mut speed) = (1.0, 1.0);
        (0..most).map(move |_| {
            let now = time;
            speed *= e;
            time += 2.0 * speed;
            now
        })
    }

    #[test]
    fn a_ball_that_loses_a_part_of_its_speed_in_every_impact_collapses() {
        for e in [0.2, 0.64, 0.9, 0.99] {
            let mut streaks = Streaks::<f64>::new(2);
            // all but rounding of the geometric series is over after this many impacts
            let until_still = (f64::EPSILON.ln() / f64::ln(e)) as usize;
            let most = until_still + 2 * MOST_IMPACTS_AT_ONCE as usize;
            let found = bounces(e, most).position(|now| streaks.count([1], now).is_some());
            let Some(impacts) = found else {
                panic!("e {e}: {most} impacts and no end");
            };
            // never before the clock stands still, and soon after
            assert!(impacts >= MOST_IMPACTS_AT_ONCE as usize, "e {e}: {impacts}");
            assert!(impacts <= most, "e {e}: {impacts}");
            let limit = 1.0 + 2.0 * e / (1.0 - e);
            let at = bounces(e, impacts + 1).last().unwrap_or(f64::NAN);
            // the clock stands at the sum of the series, but for an ulp or so for each of its terms
            let rounding = f64::EPSILON * limit * (until_still as f64 + 16.0);
            assert!(
                (at - limit).abs() <= rounding,
                "e {e}: at {at}, sum {limit}"
            );
        }
    }

    /// Three equal balls on a line, the outer ones closing in on the middle one at speed 1 with restitution `e`: the times of
    /// their impacts and the first ball of each. Gaps and closing speeds are what is computed, so that nothing cancels
    /// while they shrink.
    fn three_on_a_line(e: f64, most: usize) -> Vec<(f64, usize)> {
        let (mut now, mut gaps, mut closing) = (1.0, [0.1, 0.2], [1.0, 1.0]);
        let mut impacts = Vec::new();
        while impacts.len() < most {
            let wait = |pair: usize| {
                let (gap, speed) = (gaps[pair], closing[pair]);
                if speed > 0.0 {
                    gap / speed
                } else {
                    f64::INFINITY
                }
            };
            let pair = usize::from(wait(1) < wait(0));
            let after: f64 = wait(pair);
            if after.is_infinite() {
                break;
            }
            now += after;
            for i in 0..2 {
                gaps[i] = if i == pair {
                    0.0
                } else {
                    gaps[i] - closing[i] * after
                };
            }
            // the middle ball takes half of (1 + e) times the closing speed into the other pair
            closing[1 - pair] += 0.5 * (1.0 + e) * closing[pair];
            closing[pair] *= -e;
            impacts.push((now, pair));
        }
        impacts
    }

    #[test]
    fn three_balls_on_a_line_collapse_below_the_restitution_of_mcnamara_and_young() {
        // McNamara and Young 1992, Phys. Fluids A 4, 496: infinitely many impacts in finite time below 7 - 4 sqrt 3
        let critical = 7.0 - 4.0 * 3.0_f64.sqrt();
        let most = 4 * MOST_IMPACTS_AT_ONCE as usize;
        for (part, collapses) in [
            (0.3, true),
            (0.9, true),
            (0.99, true),
            (1.05, false),
            (4.0, false),
        ] {
            let impacts = three_on_a_line(part * critical, most);
            let mut streaks = Streaks::<f64>::new(3);
            let counted = impacts
                .iter()
                .position(|(now, first)| streaks.count([*first, first + 1], *now).is_some());
            assert_eq!(
                counted.is_some(),
                collapses,
                "e {part} of critical: {} impacts",
                impacts.len()
            );
            if collapses {
                // the middle ball takes part in all of them
                assert!(
                    counted >= Some(MOST_IMPACTS_AT_ONCE as usize),
                    "{counted:?}"
                );
            } else {
                assert!(impacts.len() < 100, "{} impacts", impacts.len());
            }
        }
    }

    #[test]
    fn impacts_that_leave_time_between_them_never_count() {
        let mut streaks = Streaks::<f64>::new(1);
        for i in 0..5 * MOST_IMPACTS_AT_ONCE {
            let now = 1.0 + f64::from(i) * 1e-12;
            assert_eq!(streaks.count([0], now), None, "impact {i}");
        }
        // as many as it takes, but of different balls
        let mut streaks = Streaks::<f64>::new(MOST_IMPACTS_AT_ONCE as usize + 2);
        for ball in 0..MOST_IMPACTS_AT_ONCE as usize + 2 {
            assert_eq!(streaks.count([ball], 1.0), None);
        }
    }
}
