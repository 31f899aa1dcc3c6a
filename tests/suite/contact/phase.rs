//! What holds while a contact lasts: the distance, what the knots explain, the energy that nothing brings.

use super::{R, lasting, reach, runs};
use carom::engine::Limits;
use carom::engine::exact::solve;
use carom::math::{DoubleDouble, Real};
use carom::scene::catalogue;
use carom::trace::{Ending, Knot, Partner, Path, Trace};

/// What a held pair may drift, in radii: some roundings of coordinates below 2 m.
const DRIFT: f64 = 1e-12;

/// What the knots of a held ball leave unexplained, in radii.
const UNEXPLAINED: f64 = 2e-9;

/// Two precisions agree within this many radii: what the workbench asks of them up to the horizon.
const AGREE: f64 = 1e-9;

/// Knots of a ball strictly within a phase or at its ends; of those at its ends the sides that belong to it.
pub fn within(trace: &Trace, ball: usize, begin: f64, end: f64) -> Vec<Knot> {
    let knots = trace.paths[ball].knots.iter().copied();
    let inside = knots.filter(|knot| knot.time > begin && knot.time < end);
    let edge = |time: f64, state: Option<carom::physics::State>| {
        state.map(|state| Knot {
            time,
            state,
            after: None,
        })
    };
    let path = &trace.paths[ball];
    let mut all: Vec<Knot> = edge(begin, path.state_at(begin)).into_iter().collect();
    all.extend(inside);
    all.extend(edge(end, path.before(end)));
    all
}

#[test]
fn a_contact_keeps_its_distance_while_it_lasts() {
    let mut compared = 0;
    for (case, solution) in runs() {
        let trace = &solution.trace;
        for (ball, partner, begin, end) in lasting(trace) {
            for knot in within(trace, ball, begin, end) {
                let drift = match partner {
                    Partner::Cushion(side) => {
                        knot.state.position[side.axis()] - reach(&case.scene, side)
                    }
                    Partner::Ball(other) => {
                        // between knots a path is a cubic, good to what it leaves unexplained
                        let other = within(trace, other as usize, begin, end);
                        let Some(at) = other.iter().find(|other| other.time == knot.time) else {
                            continue;
                        };
                        (at.state.position - knot.state.position).norm() - 2.0 * R
                    }
                };
                compared += 1;
                assert!(
                    drift.abs() <= DRIFT * R,
                    "{}: {ball} and {partner:?} are {drift:e} off at {}",
                    case.name,
                    knot.time
                );
            }
        }
    }
    assert!(compared >= 100, "{compared} knots");
}

#[test]
fn the_knots_of_a_held_ball_explain_its_motion() {
    for (case, solution) in runs() {
        let trace = &solution.trace;
        for (ball, partner, begin, end) in lasting(trace) {
            let other = match partner {
                Partner::Ball(other) => Some(other as usize),
                Partner::Cushion(_) => None,
            };
            for ball in std::iter::once(ball).chain(other) {
                let knots = within(trace, ball, begin, end);
                let left = Path { knots }.unexplained();
                assert!(
                    left <= UNEXPLAINED * R,
                    "{}: ball {ball} moves {left:e} unexplained between {begin} and {end}",
                    case.name
                );
            }
        }
    }
}

#[test]
fn energy_never_grows_through_limits_and_contacts() {
    for (case, solution) in runs() {
        let gained = solution.trace.extrema.energy_gained.value;
        let initial = case.scene.initial_energy();
        assert!(
            gained <= 1e-12 * initial,
            "{}: gains {gained:e} of {initial:e}",
            case.name
        );
    }
}

#[test]
fn racks_that_end_up_resting_on_each_other_do_so_alike_in_two_precisions() {
    for name in ["rack-lossy", "report-break-pressed"] {
        let scene = catalogue::scene(name).unwrap_or_else(|error| panic!("{name}: {error}"));
        let (coarse, fine) = (
            solve::<f64>(&scene, &Limits::NONE),
            solve::<DoubleDouble>(&scene, &Limits::NONE),
        );
        for trace in [&coarse.trace, &fine.trace] {
            assert_eq!(trace.ending, Ending::Rest, "{name}: {:?}", trace.ending);
            let gained = trace.extrema.energy_gained.value;
            assert!(
                gained <= 1e-12 * scene.initial_energy(),
                "{name}: gains {gained:e}"
            );
        }
        let mut worst: f64 = 0.0;
        for (one, other) in coarse.positions.iter().zip(&fine.positions) {
            for axis in 0..2 {
                worst = worst.max((one[axis] - other[axis].to_f64()).abs());
            }
        }
        let allowed = AGREE * scene.smallest_radius();
        assert!(
            worst <= allowed,
            "{name}: {worst:e} apart, allowed {allowed:e}"
        );
    }
}
