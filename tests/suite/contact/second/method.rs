//! The second method: impacts one by one up to one whose approach is slow, which is made inelastic; then time stepping that holds the two.
//! The state at the end has an error in the approach speed that was cut, and one in the step: both are extrapolated.

use super::flight::Flight;
use super::laws::{Ball, Laws, Plane, Space};
use super::stepping::Stepping;
use super::window::Window;
use carom::physics::State;

/// What the method knows at the end of a window.
pub struct Known {
    /// Numbers of every ball: place, velocity, speed of the surface.
    pub numbers: Vec<[f64; 7]>,
    /// Where the impacts of the pair end, s, and what is open of that.
    pub limit: (f64, f64),
    /// What the last columns leave open, of places and of speeds.
    pub doubt: [f64; 2],
}

/// Speeds at which impacts are cut, the first below each.
pub const CUTS: usize = 4;
/// Numbers of steps: the least, then twice that ...
pub const STEPS: [u32; 3] = [1000, 2000, 4000];

pub fn ball(state: &State, origin: Plane, radius: f64) -> Ball {
    Ball {
        r: Plane::new(state.position.x, state.position.y) - origin,
        v: Plane::new(state.velocity.x, state.velocity.y),
        w: Space::new(state.spin.x, state.spin.y, state.spin.z) * radius,
    }
}

/// Value at 0 of the polynomial through points by Neville, and that without the first of them.
fn at_zero(points: &[(f64, f64)]) -> [f64; 2] {
    let mut column: Vec<f64> = points.iter().map(|(_, y)| *y).collect();
    let mut before = column[points.len() - 1];
    for width in 1..points.len() {
        before = column[column.len() - 1];
        column = (0..column.len() - 1)
            .map(|i| {
                let (near, far) = (points[i + width].0, points[i].0);
                (far * column[i + 1] - near * column[i]) / (far - near)
            })
            .collect();
    }
    [column[0], before]
}

fn flat(balls: &[Ball]) -> Vec<f64> {
    balls.iter().flat_map(Ball::numbers).collect()
}

/// Columns of many numbers at once: the best, and what the last two differ by.
fn extrapolated(at: &[f64], rows: &[Vec<f64>]) -> (Vec<f64>, Vec<f64>) {
    let one = |k: usize| {
        let points: Vec<(f64, f64)> = at.iter().zip(rows).map(|(x, row)| (*x, row[k])).collect();
        let [best, before] = at_zero(&points);
        (best, (best - before).abs())
    };
    (0..rows[0].len()).map(one).unzip()
}

/// What the balls of a window, which are so at its start, do up to its end.
pub fn play(laws: &Laws, window: &Window, start: &[Ball], cut: f64, nothing: f64) -> Option<Known> {
    let until = window.balls.iter().map(|(_, until)| *until).collect();
    let flight = Flight::new(laws, window.from, start.to_vec(), until, nothing);
    // which impacts of the two are cut, and their speeds: slow ones, each at most half as fast as the one before
    let (mut met, mut below) = (0, cut);
    let mut chosen: Vec<(usize, f64)> = Vec::new();
    let mut whole = flight.clone();
    whole.run(window.to, |i, j, speed| {
        if (i, j) == (0, 1) {
            if met == 0 {
                below = cut.min(0.5 * speed);
            } else if speed < below {
                chosen.push((met, speed));
                below = 0.5 * speed;
            }
            met += 1;
        }
        chosen.len() == CUTS
    });
    if chosen.len() < CUTS {
        return None;
    }
    let cuts: Vec<f64> = chosen.iter().map(|(_, speed)| *speed).collect();
    let (mut rows, mut times, mut doubt) = (Vec::new(), Vec::new(), [0.0_f64; 2]);
    let worse = |doubt: &mut [f64; 2], open: &[f64]| {
        // of the two alone: what the others do later is not followed
        for (k, open) in open.iter().take(14).enumerate() {
            let kind = usize::from(k % 7 >= 2);
            doubt[kind] = doubt[kind].max(*open);
        }
    };
    for (last, _) in &chosen {
        let mut cut = flight.clone();
        let mut met = 0;
        cut.run(window.to, |i, j, _| {
            met += usize::from((i, j) == (0, 1));
            met == last + 1
        });
        let left = window.to - cut.time;
        times.push(vec![cut.time - window.begin]);
        let ends = STEPS.map(|steps| {
            let mut stepping = Stepping {
                laws,
                balls: cut.balls.clone(),
                held: (0, 1),
                apart: 0.0,
                time: cut.time,
                until: &cut.until,
            };
            for _ in 0..steps {
                stepping.step(left / f64::from(steps));
            }
            flat(&stepping.balls)
        });
        let at = STEPS.map(|steps| 1.0 / f64::from(steps));
        let (best, open) = extrapolated(&at, &ends);
        rows.push(best);
        // the same for all cuts but for what they change
        doubt = [0.0; 2];
        worse(&mut doubt, &open);
    }
    let (best, open) = extrapolated(&cuts, &rows);
    let mut all = [0.0; 2];
    worse(&mut all, &open);
    let (limit, late) = extrapolated(&cuts, &times);
    let numbers = best.chunks(7).map(|c| std::array::from_fn(|k| c[k]));
    Some(Known {
        numbers: numbers.collect(),
        limit: (limit[0], late[0]),
        doubt: [doubt[0] + all[0], doubt[1] + all[1]],
    })
}
