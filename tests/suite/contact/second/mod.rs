//! The first contact of breaks against a second method, which shares nothing with carom but the state before the impacts that lead
//! to it: impacts one by one, a slow one of which is made inelastic, then inelastic time stepping after Moreau. The error of the former is
//! linear in the speed that is cut, that of the latter in the step; both are extrapolated, and their last two columns say how well.

mod balance;
mod breaks;
mod flight;
mod laws;
mod method;
mod stepping;
mod window;

pub use breaks::Break;
use carom::compare::sweep;
use carom::trace::Trace;
use laws::Plane;
use method::{Known, STEPS};
use std::collections::BTreeMap;
use window::{Until, Window};

/// Samples of each break.
const SAMPLES: u64 = 50;

/// Impacts of slower approach than this are cut, m/s.
const CUT: f64 = 1e-4;

/// A slip or speed below this is rounding, m/s.
const NOTHING: f64 = 1e-10;

/// How wrong the engine may be in the time of a limit in f64, s: what `TIMES` demands of the cases of the reference.
const LATE: f64 = super::TIMES;

/// Longest drift of a held pair, and most that a trace may gain of its energy.
const DRIFT: f64 = 1e-12;
const GAIN: f64 = 1e-12;

/// What the balance of a contact may leave, in its energy at the start.
const BALANCE: f64 = 1e-10;

/// The run of a sample as far as its first contact needs, with that; `None` where it comes to rest without.
fn first(scene: &carom::scene::Scene) -> (Trace, Option<Window>) {
    let mut most = 100;
    loop {
        let trace = breaks::run(scene, most);
        let window = window::first(&trace);
        let known = window
            .as_ref()
            .is_some_and(|window| window.until != Until::Past || window.is_past(&trace));
        if known || trace.ending.is_complete() {
            return (trace, window);
        }
        most += most / 2;
    }
}

/// Largest part of what is allowed by which the two methods differ at the end of a window: of places, and of speeds.
fn apart(scene: &carom::scene::Scene, trace: &Trace, window: &Window) -> Result<[f64; 2], String> {
    let (laws, metres) = (breaks::laws(scene), breaks::metres(scene));
    let state = |ball: usize, time: f64| {
        let state = trace.paths[ball].before(time);
        state.unwrap_or_else(|| panic!("no ball {ball}"))
    };
    let origin = state(window.pair.0, window.from).position;
    let origin = Plane::new(origin.x, origin.y);
    let radius = 0.5 * laws.diameter;
    let ball = |ball: usize, time: f64| method::ball(&state(ball, time), origin, radius);
    let start: Vec<_> = window
        .balls
        .iter()
        .map(|(i, _)| ball(*i, window.from))
        .collect();
    let Some(known) = method::play(&laws, window, &start, CUT / metres, NOTHING / metres) else {
        return Err("its impacts have no limit".into());
    };
    let Known { limit, doubt, .. } = known;
    if limit.0.abs() > LATE + 10.0 * limit.1 {
        return Err(format!(
            "its limit is {:e} s off, {:e} are open",
            limit.0, limit.1
        ));
    }
    // what rounds: every event in the engine, and every step here
    let within = |time: f64| time > window.from && time < window.to;
    let events = trace
        .events
        .iter()
        .filter(|event| within(event.time))
        .count() as f64;
    let steps = f64::from(STEPS[STEPS.len() - 1]);
    let both = [window.pair.0, window.pair.1];
    let (mut place, mut speed): (f64, f64) = (0.0, 0.0);
    let (mut far, mut fast): (f64, f64) = (0.0, 0.0);
    for (numbers, i) in known.numbers.iter().zip(both) {
        let there = ball(i, window.to);
        for (k, (one, other)) in numbers.iter().zip(there.numbers()).enumerate() {
            let worst = if k < 2 { &mut place } else { &mut speed };
            *worst = worst.max((one - other).abs());
        }
        far = far.max(state(i, window.to).position.norm());
        fast = fast.max(there.v.norm()).max(there.w.norm());
    }
    // a limit that is told so much late: for so long a ball rolls as between impacts, not as under pressure
    let late = laws.roll * limit.0.abs().min(LATE);
    let allowed = [
        10.0 * doubt[0] + late * (window.to - window.begin) + events * f64::EPSILON * far,
        10.0 * doubt[1] + late + (events + steps) * f64::EPSILON * fast,
    ];
    Ok([place / allowed[0], speed / allowed[1]])
}

/// Largest drift of the distance of a held pair at its knots and between them, in radii.
fn drift(trace: &Trace, window: &Window, diameter: f64) -> f64 {
    let end = window.end.min(trace.end_time);
    let (one, other) = window.pair;
    let knots = trace.paths[one].knots.iter().map(|knot| knot.time);
    let times: Vec<f64> = knots.filter(|t| *t >= window.begin && *t <= end).collect();
    let mut worst: f64 = 0.0;
    for pair in times.windows(2).filter(|pair| pair[1] > pair[0]) {
        for part in [0.0, 0.25, 0.5, 0.75] {
            let time = pair[0] + part * (pair[1] - pair[0]);
            let at = |ball: usize| trace.paths[ball].state_at(time).map(|state| state.position);
            let gap = at(one)
                .zip(at(other))
                .map(|(p, q)| (p - q).norm() - diameter);
            worst = worst.max(gap.unwrap_or(f64::NAN).abs());
        }
    }
    2.0 * worst / diameter
}

/// Holds the samples of a break, and says how many were; at least so many of them have a contact.
#[allow(clippy::print_stdout)]
fn hold(which: Break, speed: f64, least: usize) {
    let samples = which.samples(speed);
    let mut ends: BTreeMap<Until, usize> = BTreeMap::new();
    let (mut none, mut faults, mut worst) = (0, Vec::new(), [0.0_f64; 2]);
    let mut balanced = [0; 2];
    for index in 0..SAMPLES {
        let scene = samples.sample(3, index);
        let (trace, window) = first(&scene);
        let gained = trace.extrema.energy_gained.value / scene.initial_energy();
        if gained > GAIN {
            faults.push(format!("{index}: gains {gained:e} of its energy"));
        }
        let seen = sweep(&scene, &trace, scene.touching());
        if !seen.overlaps.is_empty() || !seen.outside.is_empty() || seen.given_up > 0 {
            faults.push(format!("{index}: a hit is missed: {seen:?}"));
        }
        let Some(window) = window else {
            none += 1;
            continue;
        };
        *ends.entry(window.until).or_default() += 1;
        let drift = drift(&trace, &window, 2.0 * scene.balls[0].radius);
        if drift > DRIFT {
            faults.push(format!("{index}: {:?} drift by {drift:e} R", window.pair));
        }
        let lasts = [window.begin, window.end.min(window.to)];
        if lasts[1] > lasts[0] {
            let laws = breaks::laws(&scene);
            let [left, open] = balance::unbalanced(&trace, window.pair, lasts, &laws);
            // the rule over every second knot is worse than that over all by far more than the latter is wrong
            if left.abs() > BALANCE.max(open.abs()) {
                faults.push(format!(
                    "{index}: {left:e} of the energy is unbalanced, {open:e} unresolved, {window:?}"
                ));
            }
            balanced[usize::from(left.abs() <= BALANCE)] += 1;
        }
        match apart(&scene, &trace, &window) {
            Err(why) => faults.push(format!("{index}: {why}, {window:?}")),
            Ok(parts) => {
                worst = [worst[0].max(parts[0]), worst[1].max(parts[1])];
                if parts.iter().any(|part| part.is_nan() || *part > 1.0) {
                    faults.push(format!(
                        "{index}: {parts:?} times what is allowed, {window:?}"
                    ));
                }
            }
        }
    }
    let contacts: usize = ends.values().sum();
    println!(
        "{which:?} at {speed} m/s: {contacts} samples of {SAMPLES} have a contact, {none} none; compared up to {ends:?}"
    );
    println!("  at most {worst:?} of what is allowed");
    println!(
        "  the energy of {} phases balances to {BALANCE:e}, that of {} as far as their knots resolve it",
        balanced[1], balanced[0]
    );
    assert!(faults.is_empty(), "{which:?} at {speed} m/s: {faults:#?}");
    assert!(contacts >= least, "{contacts} contacts");
}

#[test]
fn pool_breaks_at_2_metres_a_second_agree_with_a_second_method_through_their_first_contact() {
    hold(Break::Pool, 2.0, 40);
}

#[test]
fn pool_breaks_at_4_metres_a_second_agree_with_a_second_method_through_their_first_contact() {
    hold(Break::Pool, 4.0, 12);
}

#[test]
fn breaks_at_92_degrees_and_2_metres_a_second_agree_with_a_second_method() {
    hold(Break::Report, 2.0, 30);
}

#[test]
fn breaks_at_92_degrees_and_4_metres_a_second_agree_with_a_second_method() {
    hold(Break::Report, 4.0, 30);
}

#[test]
fn breaks_of_a_frozen_rack_at_2_metres_a_second_agree_with_a_second_method() {
    hold(Break::Frozen, 2.0, 40);
}

#[test]
fn breaks_of_a_frozen_rack_at_4_metres_a_second_agree_with_a_second_method() {
    hold(Break::Frozen, 4.0, 40);
}
