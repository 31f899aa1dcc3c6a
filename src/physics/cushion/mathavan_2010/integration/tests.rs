//! The integration against a finer one, its derivatives against difference quotients, and its edges.

use super::{Accuracy, rebound};
use crate::math::random::Draws;
use crate::math::{DoubleDouble, Dual, Real};

/// What double-double can do in a test: ten to a thousand times finer everywhere.
const FINE: Accuracy = Accuracy {
    step: 1e-17,
    rounding: 1e-28,
    ended: 1e-13,
    creep: 1e-6,
    lag: 1e-6,
    leave: 1e-10,
};

/// `[e, mu, mu_cloth, height]` and the start of some impact: any spin, or rolling, which leaves the cloth no slip.
fn draw(draws: &mut Draws, index: usize) -> ([f64; 4], [f64; 5]) {
    let most = [0.3, 0.6, 0.9][index % 3];
    let numbers = [
        draws.between(0.0, 1.0),
        draws.between(0.0, most),
        draws.between(0.0, most),
        draws.between(0.7, 1.6),
    ];
    let mut between = || draws.between(-1.0, 1.0);
    let (vx, vy) = (between().abs(), between());
    let start = match index % 4 {
        0 => [vx, vy, -vy, vx, 0.0],
        1 => [vx, vy, -vy, vx, between()],
        2 => [vx, 0.0, 0.0, between(), 0.0],
        _ => [vx, vy, between(), between(), between()],
    };
    (numbers, start)
}

#[test]
fn the_stated_error_covers_the_difference_to_a_finer_run() {
    let mut draws = Draws::new(41, 0);
    for index in 0..1000 {
        let (numbers, start) = draw(&mut draws, index);
        let (got, error) = rebound(numbers, start, Accuracy::F64);
        let (numbers2, start2) = (
            numbers.map(DoubleDouble::lift),
            start.map(DoubleDouble::lift),
        );
        let (want, fine) = rebound(numbers2, start2, FINE);
        for (got, want) in got.iter().zip(want) {
            let off = (DoubleDouble::lift(*got) - want).abs().to_f64();
            assert!(
                off <= error + fine,
                "{index}: {numbers:?} {start:?}: off by {off:e}, stated {error:e} and {fine:e}"
            );
        }
        // a millionth of the speed at worst, where a slip creeps for long
        assert!(error <= 1e-6, "{index}: {error:e}");
    }
}

/// Differentiates the rebound by everything and holds it against difference quotients along `directions` of the inputs.
fn hold_derivatives(index: usize, inputs: [f64; 9], directions: &[[f64; 9]]) {
    let split = |all: [Dual<f64, 9>; 9]| {
        let (numbers, start) = all.split_at(4);
        (
            std::array::from_fn(|i| numbers[i]),
            std::array::from_fn(|i| start[i]),
        )
    };
    let (numbers, start) = split(std::array::from_fn(|i| {
        let seeds = directions.iter().map(|direction| direction[i]);
        let mut seeded = Dual::constant(inputs[i]);
        for (partial, seed) in seeded.partials.iter_mut().zip(seeds) {
            *partial = seed;
        }
        seeded
    }));
    let (end, _) = rebound::<Dual<f64, 9>>(numbers, start, Accuracy::F64);
    for (lane, direction) in directions.iter().enumerate() {
        let moved = |step: f64| {
            let all: [DoubleDouble; 9] =
                std::array::from_fn(|i| DoubleDouble::lift(inputs[i] + step * direction[i]));
            let (numbers, start) = all.split_at(4);
            let (end, _) = rebound::<DoubleDouble>(
                std::array::from_fn(|i| numbers[i]),
                std::array::from_fn(|i| start[i]),
                FINE,
            );
            end
        };
        let h = 1e-6;
        let (back, forth) = (moved(-h), moved(h));
        for (k, got) in end.iter().enumerate() {
            let want = ((forth[k] - back[k]).to_f64()) / (2.0 * h);
            let error = (got.partials[lane] - want).abs();
            // the quotient is good to h^2 and to rounding by h; what a creeping slip neglects has a derivative of the size
            // of its lag, 1e-4, times the sensitivity
            let allowed = 1e-3 * (1.0 + want.abs());
            assert!(
                error <= allowed,
                "{index}, {inputs:?} along {direction:?}, component {k}: {} instead of {want}",
                got.partials[lane]
            );
        }
    }
}

#[test]
fn a_ball_that_friction_wedges_between_nose_and_cloth_stays_there() {
    // both contacts hold once mu >= cos th / (1 + sin th) = 1/3 at a nose of 1.8 radii
    let (end, _) = rebound(
        [0.98, 0.5, 0.5, 1.8],
        [1.0, 0.0, 0.0, 0.0, 0.0],
        Accuracy::F64,
    );
    assert!(end.iter().all(|x| x.abs() <= 1e-15), "{end:?}");
    let (end, _) = rebound(
        [0.98, 0.2, 0.2, 1.8],
        [1.0, 0.0, 0.0, 0.0, 0.0],
        Accuracy::F64,
    );
    assert!(end[0] < 0.0, "{end:?}");
}

#[test]
fn a_ball_that_hardly_moves_into_the_cushion_leaves_it_with_no_more_speed() {
    // the work of compression, which goes with the square, underflows below 1e-154 of the other speeds; and a speed of 1e-11
    // is what slips are good to
    for vx in [1e-10, 1e-11, 1e-12, 1e-90, 1e-148, 1e-161, 1e-300] {
        for (along, spin) in [(-0.018, 0.018), (1.0, 0.3), (0.0, 1.0), (1.0, -1.0)] {
            for height in [0.1, 1.0, 1.4, 1.9] {
                let start = [vx, along, spin, 0.0, 0.0];
                let (end, error) = rebound([0.5, 0.37, 0.5, height], start, Accuracy::F64);
                let what = format!("{start:?} at {height}: {end:?}, {error:e}");
                assert!(end[0] <= 0.0 && end[0] >= -0.5 * vx, "{what}");
                // an impulse per vx is at most (1 + e) / cos th, a few; friction adds as much and a spin 5/2 of it
                for (got, was) in end.iter().zip(start).skip(1) {
                    assert!(
                        (got - was).abs() <= 30.0 * vx + error + f64::EPSILON,
                        "{what}"
                    );
                }
                assert!(error <= 100.0 * (vx + Accuracy::F64.ended), "{what}");
            }
        }
    }
}

#[test]
fn a_ball_at_the_edge_of_a_slip_and_of_a_speed_leaves_the_cushion() {
    // from random scene 41523 of seed 5: it rolls along the cushion, so that neither contact slips by more than it may
    let r = 0.23856697044680325;
    let spin = [
        -5.60462349472582,
        -8.066935567845232e-12,
        -24.42998743001525,
    ]
    .map(|w| w * r);
    for vx in [7.1e-11, 7.1e-10, 7.1e-9, 7.1e-8] {
        let start = [vx, 1.3370780477295472, spin[0], spin[1], spin[2]];
        let numbers = [0.902858435918292, 0.37387557787003567, 0.5, 1.9];
        let (end, error) = rebound(numbers, start, Accuracy::F64);
        assert!(
            end[0] <= error && error < 1e-7,
            "{vx:e}: {end:?}, {error:e}"
        );
    }
}

#[test]
fn dual_numbers_carry_the_derivative_through_slipping_and_sticking() {
    let unit = |i: usize| -> [f64; 9] { std::array::from_fn(|j| f64::from(u8::from(i == j))) };
    let mut draws = Draws::new(43, 0);
    for index in 0..40 {
        let (numbers, start) = draw(&mut draws, index);
        let inputs = std::array::from_fn(|i| if i < 4 { numbers[i] } else { start[i - 4] });
        match index % 4 {
            3 => hold_derivatives(index, inputs, &[0, 1, 2, 3, 4, 5, 6, 7, 8].map(unit)),
            // a ball that rolls goes on rolling when it is sent elsewhere: its spin moves with its velocity
            0 | 1 => {
                let mut along_x = unit(4);
                along_x[7] = 1.0;
                let mut along_y = unit(5);
                along_y[6] = -1.0;
                let directions = [unit(0), unit(1), unit(2), unit(3), along_x, along_y];
                hold_derivatives(index, inputs, &directions);
            }
            // in the plane across the cushion a slip can pass through zero, where the derivative out of the plane has a logarithm
            _ => {}
        }
    }
}

#[test]
fn no_impact_adds_energy_beyond_its_stated_error() {
    let energy =
        |[vx, vy, sx, sy, sz]: [f64; 5]| vx * vx + vy * vy + 0.4 * (sx * sx + sy * sy + sz * sz);
    for index in 0..3000 {
        let mut draws = Draws::new(44, index);
        let (mut numbers, mut start) = draw(&mut draws, index as usize);
        numbers[3] = draws.between(0.1, 1.9);
        // weak friction and slips that are next to none, with all of the work returned
        for mu in &mut numbers[1..3] {
            if draws.uniform() < 0.5 {
                *mu = 10_f64.powf(draws.between(-12.0, -1.0));
            } else {
                *mu = mu.min(0.5);
            }
        }
        if draws.uniform() < 0.5 {
            numbers[0] = 1.0;
        }
        for value in &mut start[1..] {
            if draws.uniform() < 0.5 {
                *value *= 10_f64.powf(draws.between(-16.0, 0.0));
            }
        }
        // and slips that such friction ends within the impact, under a nose that does not turn the ball
        if index % 3 == 0 {
            numbers[1] = 10_f64.powf(draws.between(-12.0, -6.0));
            numbers[3] = 1.0;
            start = [
                start[0],
                0.0,
                0.0,
                0.0,
                numbers[1] * draws.between(-3.0, 3.0),
            ];
        }
        let (end, error) = rebound(numbers, start, Accuracy::F64);
        let size = start.iter().fold(0.0_f64, |size, x| size.max(x.abs()));
        let gained = energy(end) - energy(start);
        // an error of each of five speeds, once for the error and once for its weight in the energy
        let allowed = 5.0 * size * (2.0 * error + 1e-15 * size);
        assert!(
            gained <= allowed,
            "{index}: {numbers:?} {start:?}: {gained:e} > {allowed:e}"
        );
        // what a slip that creeps neglects is a millionth at most
        assert!(
            error <= 1e-5 * size,
            "{index}: {numbers:?} {start:?}: {error:e}"
        );
    }
}

#[test]
fn speeds_at_the_end_of_the_range_of_numbers_leave_the_cushion() {
    for size in [1e-300, 1e-307, 1.03e-308, 4e-309, 1e-315, 5e-324] {
        let start = [size, 0.0, 0.0, 0.4 * size, 0.0];
        let (end, error) = rebound([0.9, 0.19, 0.26, 0.6], start, Accuracy::F64);
        // a few of the smallest numbers are all that is left of digits
        let allowed = error + 1e-323;
        assert!(
            end[0] <= allowed && end[0] >= -size - allowed,
            "{size:e}: {end:?}"
        );
    }
}

#[test]
fn a_ball_that_rolls_along_a_smooth_cushion_leaves_it() {
    // no slip at the nose but a few roundings, and next to no friction that could hold it
    let along = 4.213325464718789e-8;
    let spin = -3.270141844413234e-9 * 12.884228466003464;
    for mu in [0.0, 1e-12, 1e-9, 1e-6] {
        for (vy, sz) in [(along, spin), (-along, -spin)] {
            let start = [8.663933992415733e-9, vy, 0.0, 0.0, sz];
            let (end, error) = rebound([0.0, mu, 0.0, 1.0], start, Accuracy::F64);
            assert!(end[0].abs() <= error, "{mu:e}: {end:?}");
            assert!(
                (end[1] - vy).abs() <= mu * start[0] + error,
                "{mu:e}: {end:?}"
            );
        }
    }
}
