//! Who is wrong, and how: every mutant with the scenes of the gate set that its fault can touch.

use super::engines::{Fault, Wrong};
use super::slip::Slip;
use carom::engine::Setting;
use carom::math::Vec3;
use carom::physics::{Contact, Side};
use carom::scene::Scene;
use carom::study::matrix::Configuration;
use carom::trace::{EventKind, Trace};
use std::sync::atomic::{AtomicU32, Ordering};

/// An engine with one thing wrong.
pub struct Mutant {
    /// Unique kebab-case name.
    pub id: &'static str,
    /// What is wrong, in a few words.
    pub what: &'static str,
    /// The engine that it stands for.
    pub engine: &'static str,
    /// With this setting, as on the command line.
    pub setting: &'static [&'static str],
    /// What is wrong.
    pub fault: Fault,
    /// Scenes of the gate set in which it can show.
    pub scenes: &'static [&'static str],
}

impl Mutant {
    /// The column in which it runs.
    pub fn column(&self) -> Configuration {
        Configuration {
            engine: Wrong::engine(self.engine, self.fault),
            setting: Setting::parse(self.setting.iter().copied()).unwrap(),
        }
    }
}

const AS_WRITTEN: &[&str] = &[];
const APPROACHING: &[&str] = &["contact=approaching-only"];

const fn step(
    id: &'static str,
    what: &'static str,
    slip: Slip,
    setting: &'static [&'static str],
    scenes: &'static [&'static str],
) -> Mutant {
    Mutant {
        id,
        what,
        engine: "stepper",
        setting,
        fault: Fault::Step(slip),
        scenes,
    }
}

const fn scene(
    id: &'static str,
    what: &'static str,
    engine: &'static str,
    change: fn(&mut Scene),
    scenes: &'static [&'static str],
) -> Mutant {
    Mutant {
        id,
        what,
        engine,
        setting: AS_WRITTEN,
        fault: Fault::Scene(change),
        scenes,
    }
}

const fn trace(
    id: &'static str,
    what: &'static str,
    engine: &'static str,
    change: fn(&Scene, &mut Trace),
    scenes: &'static [&'static str],
) -> Mutant {
    Mutant {
        id,
        what,
        engine,
        setting: AS_WRITTEN,
        fault: Fault::Trace(change),
        scenes,
    }
}

const fn setting(
    id: &'static str,
    what: &'static str,
    engine: &'static str,
    (key, value): (&'static str, &'static str),
    scenes: &'static [&'static str],
) -> Mutant {
    Mutant {
        id,
        what,
        engine,
        setting: AS_WRITTEN,
        fault: Fault::Setting(key, value),
        scenes,
    }
}

/// Every mutant: slips in the steps of the report's model, engines that run another scene, engines that tell something else.
pub const MUTANTS: &[Mutant] = &[
    step(
        "restitution-squared",
        "e^2 instead of e between balls",
        Slip::RestitutionSquared,
        AS_WRITTEN,
        &["draw", "follow"],
    ),
    step(
        "cushion-loses-twice",
        "e^2 instead of e at cushions",
        Slip::CushionLosesTwice,
        AS_WRITTEN,
        &["bank"],
    ),
    step(
        "friction-pushes",
        "-mu instead of mu",
        Slip::FrictionPushes,
        AS_WRITTEN,
        &["slide"],
    ),
    step(
        "friction-on-one-axis",
        "the cloth slows vx and not vy",
        Slip::FrictionOnOneAxis,
        AS_WRITTEN,
        &["slide"],
    ),
    step(
        "half-gravity",
        "g/2 instead of g",
        Slip::HalfGravity,
        AS_WRITTEN,
        &["slide"],
    ),
    step(
        "four-sevenths",
        "a sphere rolls at 4/7 of its speed instead of 5/7",
        Slip::RollAtFourSevenths,
        AS_WRITTEN,
        &["follow", "side"],
    ),
    step(
        "rolling-doubled",
        "twice the rolling resistance",
        Slip::RollingDoubled,
        AS_WRITTEN,
        &["side"],
    ),
    step(
        "sleeps-early",
        "a ball below 0.01 length/s is put to rest",
        Slip::SleepsEarly,
        AS_WRITTEN,
        &["slide"],
    ),
    step(
        "pair-dropped",
        "the first pair is never looked at",
        Slip::PairDropped,
        AS_WRITTEN,
        &["three-ball", "six-balls"],
    ),
    step(
        "pairs-reversed",
        "pairs in one step are taken in reverse",
        Slip::PairsReversed,
        AS_WRITTEN,
        &["rack-frozen-central"],
    ),
    step(
        "stale-contact",
        "a pair exchanges once more in the step after",
        Slip::StaleContact,
        APPROACHING,
        &["oblique"],
    ),
    step(
        "contact-told-late",
        "contacts carry the time of the next step",
        Slip::ContactToldLate,
        AS_WRITTEN,
        &["oblique"],
    ),
    step(
        "normal-turned",
        "the normal of a contact is turned by 0.1 degrees",
        Slip::NormalTurned,
        APPROACHING,
        &["oblique"],
    ),
    step(
        "energy-leaks",
        "each hit loses 1e-6 of the energy",
        Slip::EnergyLeaks,
        APPROACHING,
        &["head-on", "six-balls"],
    ),
    step(
        "not-quite-elastic",
        "e = 1 - 1e-6 instead of 1",
        Slip::NotQuiteElastic,
        APPROACHING,
        &["head-on"],
    ),
    step(
        "spinning-doubled",
        "twice the friction against spin about the vertical",
        Slip::SpinningDoubled,
        AS_WRITTEN,
        &["side"],
    ),
    step(
        "mass-ignored",
        "unequal balls exchange like equal ones",
        Slip::MassIgnored,
        APPROACHING,
        &["heavy-into-light"],
    ),
    step(
        "throw-off",
        "no friction between balls",
        Slip::ThrowOff,
        APPROACHING,
        &["throw"],
    ),
    step(
        "spin-reversed",
        "balls leave a hit with the opposite spin",
        Slip::SpinReversed,
        APPROACHING,
        &["throw"],
    ),
    step(
        "not-a-number",
        "a hit to the left leaves a NaN",
        Slip::NotANumber,
        AS_WRITTEN,
        &["six-balls"],
    ),
    step(
        "wall-missing",
        "there is no cushion x1",
        Slip::WallMissing,
        AS_WRITTEN,
        &["cushions", "three-ball"],
    ),
    step(
        "cushion-late",
        "a cushion acts one step late",
        Slip::CushionLate,
        AS_WRITTEN,
        &["cushions"],
    ),
    step(
        "wall-forgets-place",
        "a cushion turns the ball and leaves it where it is",
        Slip::WallForgetsPlace,
        AS_WRITTEN,
        &["cushions"],
    ),
    step(
        "walls-first",
        "cushions before contacts and friction",
        Slip::WallsFirst,
        AS_WRITTEN,
        &["frozen-to-cushion", "break-36-events"],
    ),
    step(
        "corner-reversed",
        "in a corner y comes before x",
        Slip::CornerReversed,
        AS_WRITTEN,
        &["corner-double-hit"],
    ),
    step(
        "side-forgotten",
        "cushions take all spin about the vertical",
        Slip::SideForgotten,
        AS_WRITTEN,
        &["bank-side"],
    ),
    step(
        "pocket-missed",
        "balls roll over pockets",
        Slip::PocketMissed,
        AS_WRITTEN,
        &["ladder-pockets"],
    ),
    step(
        "step-doubled",
        "positions move by 2 dt",
        Slip::StepDoubled,
        AS_WRITTEN,
        &["slide"],
    ),
    scene(
        "exact-restitution-squared",
        "e^2 instead of e between balls",
        "exact",
        restitution_squared,
        &["draw"],
    ),
    scene(
        "exact-half-gravity",
        "g/2 instead of g",
        "exact",
        |s| s.gravity /= 2.0,
        &["slide"],
    ),
    scene(
        "exact-one-effect-less",
        "no friction between balls",
        "exact",
        |s| s.effects.friction = None,
        &["throw"],
    ),
    scene(
        "exact-balls-too-large",
        "radii larger by 1e-8",
        "exact",
        |s| s.balls.iter_mut().for_each(|b| b.radius *= 1.0 + 1e-8),
        &["oblique"],
    ),
    scene(
        "exact-cushion-off",
        "cushion x1 is off by 1e-6 R",
        "exact",
        cushion_off,
        &["cushions"],
    ),
    scene(
        "exact-cushion-missing",
        "no cushion at all",
        "exact",
        |s| s.effects.cushion = None,
        &["cushions"],
    ),
    scene(
        "exact-pocket-missing",
        "the last pocket is not there",
        "exact",
        pocket_missing,
        &["ladder-pockets"],
    ),
    scene(
        "exact-masses-equal",
        "every ball has the mass of the first",
        "exact",
        masses_equal,
        &["heavy-into-light"],
    ),
    scene(
        "exact-side-forgotten",
        "balls start without spin about the vertical",
        "exact",
        side_forgotten,
        &["bank-side"],
    ),
    trace(
        "ids-swapped",
        "the first two balls have changed names",
        "exact",
        ids_swapped,
        &["six-balls"],
    ),
    trace(
        "event-not-told",
        "the first collision is not reported",
        "exact",
        event_not_told,
        &["six-balls"],
    ),
    trace(
        "corner-told-reversed",
        "in a corner y is told before x",
        "exact",
        corner_reversed,
        &["corner-double-hit"],
    ),
    trace(
        "position-drifts",
        "positions drift by 1e-8 R a second",
        "exact",
        position_drifts,
        &["slide"],
    ),
    trace(
        "wrong-after-the-horizon",
        "balls come to rest one R aside, once nobody can know",
        "exact",
        wrong_after_the_horizon,
        &["discs-in-a-box"],
    ),
    trace(
        "twice-the-work",
        "everything is computed twice",
        "exact",
        |_, t| t.counters.values_mut().for_each(|n| *n *= 2),
        &["slide"],
    ),
    trace(
        "not-the-same-twice",
        "each run ends one ulp from the one before",
        "exact",
        not_the_same_twice,
        &["three-ball"],
    ),
    trace(
        "stop-told-late",
        "stops are told one step late",
        "stepper",
        |_, t| {
            t.stop_times
                .iter_mut()
                .flatten()
                .for_each(|time| *time += 1e-3)
        },
        &["slide"],
    ),
    trace(
        "phases-told-late",
        "slides end a step late in the events, not in the path",
        "exact",
        phases_told_late,
        &["side"],
    ),
    trace(
        "phases-not-told",
        "that a slide or a spin ends is not reported",
        "exact",
        phases_not_told,
        &["side"],
    ),
    trace(
        "spin-told-reversed",
        "spins are written with the wrong sign",
        "exact",
        spin_told_reversed,
        &["draw"],
    ),
    trace(
        "exchanges-not-counted",
        "every contact is told as one exchange",
        "stepper",
        |_, t| {
            t.events
                .iter_mut()
                .for_each(|e| e.exchanges = e.exchanges.map(|_| 1))
        },
        &["rack-frozen-central", "throw"],
    ),
    setting(
        "exact-in-f32",
        "24 bits instead of 53",
        "exact",
        ("precision", "f32"),
        &["oblique"],
    ),
    setting(
        "longer-steps",
        "dt = 2e-3 instead of 1e-3",
        "stepper",
        ("dt", "2e-3"),
        &["slide"],
    ),
    setting(
        "rapier-stock",
        "the engine's own defaults instead of the equivalent scene",
        "rapier-f64",
        ("preset", "stock"),
        &["slide", "head-on"],
    ),
    scene(
        "rapier-half-gravity",
        "g/2 instead of g",
        "rapier-f64",
        |s| s.gravity /= 2.0,
        &["slide"],
    ),
    scene(
        "rapier-restitution",
        "e = 0.99 instead of 1",
        "rapier-f64",
        |s| s.effects.contact = Some(Contact::Inelastic { e: 0.99 }),
        &["head-on"],
    ),
    scene(
        "rapier-f32-restitution",
        "e = 0.999 instead of 1",
        "rapier-f32",
        |s| s.effects.contact = Some(Contact::Inelastic { e: 0.999 }),
        &["head-on"],
    ),
];

fn restitution_squared(scene: &mut Scene) {
    if let Some(Contact::Inelastic { e }) = &mut scene.effects.contact {
        *e *= *e;
    }
}

fn cushion_off(scene: &mut Scene) {
    let off = 1e-6 * scene.smallest_radius();
    if let Some(table) = &mut scene.table {
        table.max[0] += off;
    }
}

fn pocket_missing(scene: &mut Scene) {
    if let Some(pockets) = &mut scene.effects.pockets {
        pockets.circles.pop();
    }
}

fn masses_equal(scene: &mut Scene) {
    let mass = scene.balls[0].mass;
    scene.balls.iter_mut().for_each(|ball| ball.mass = mass);
}

fn side_forgotten(scene: &mut Scene) {
    for ball in &mut scene.balls {
        ball.state.spin.z = 0.0;
    }
}

fn ids_swapped(_: &Scene, trace: &mut Trace) {
    if trace.paths.len() > 1 {
        trace.paths.swap(0, 1);
        trace.stop_times.swap(0, 1);
    }
}

/// The rows of some events and their far sides are left out.
fn without(trace: &mut Trace, left_out: impl Fn(usize, EventKind) -> bool) {
    let mut place = Vec::new();
    let mut kept = 0;
    for (i, event) in trace.events.iter().enumerate() {
        let told = !left_out(i, event.kind);
        place.push(told.then_some(kept));
        kept += u32::from(told);
    }
    let mut told = place.iter().map(Option::is_some);
    trace.events.retain(|_| told.next().unwrap());
    for path in &mut trace.paths {
        path.knots
            .retain(|knot| knot.after.is_none_or(|e| place[e as usize].is_some()));
        for knot in &mut path.knots {
            knot.after = knot.after.and_then(|e| place[e as usize]);
        }
    }
}

fn event_not_told(_: &Scene, trace: &mut Trace) {
    let first = trace.events.iter().position(|e| e.kind.is_collision());
    without(trace, |i, _| Some(i) == first);
}

fn phases_not_told(_: &Scene, trace: &mut Trace) {
    let phase = |kind| matches!(kind, EventKind::SlideToRoll(_) | EventKind::SpinEnd(_));
    trace.events.retain(|event| !phase(event.kind));
    for knot in trace.paths.iter_mut().flat_map(|path| &mut path.knots) {
        knot.after = None;
    }
}

fn phases_told_late(_: &Scene, trace: &mut Trace) {
    for event in &mut trace.events {
        if let EventKind::SlideToRoll(_) = event.kind {
            event.time += 1e-3;
        }
    }
}

fn spin_told_reversed(_: &Scene, trace: &mut Trace) {
    for knot in trace.paths.iter_mut().flat_map(|path| &mut path.knots) {
        knot.state.spin = -knot.state.spin;
    }
}

fn corner_reversed(_: &Scene, trace: &mut Trace) {
    for i in 1..trace.events.len() {
        let (a, b) = (trace.events[i - 1], trace.events[i]);
        if let (EventKind::BallCushion(x, one), EventKind::BallCushion(y, two)) = (a.kind, b.kind)
            && a.time == b.time
            && x == y
            && matches!(one, Side::X0 | Side::X1)
            && matches!(two, Side::Y0 | Side::Y1)
        {
            trace.events.swap(i - 1, i);
        }
    }
}

fn position_drifts(scene: &Scene, trace: &mut Trace) {
    let rate = 1e-8 * scene.smallest_radius();
    for knot in trace.paths.iter_mut().flat_map(|path| &mut path.knots) {
        knot.state.position.x += rate * knot.time;
    }
}

/// Only the end is moved: nothing else is told of what comes after the horizon.
fn wrong_after_the_horizon(scene: &Scene, trace: &mut Trace) {
    let aside = Vec3::new(scene.smallest_radius(), 0.0, 0.0);
    for path in &mut trace.paths {
        if let Some(last) = path.knots.last_mut() {
            last.state.position += aside;
        }
    }
}

fn not_the_same_twice(_: &Scene, trace: &mut Trace) {
    static RUNS: AtomicU32 = AtomicU32::new(0);
    let runs = RUNS.fetch_add(1, Ordering::Relaxed);
    if let Some(last) = trace.paths[0].knots.last_mut() {
        for _ in 0..runs % 4 {
            last.state.position.x = last.state.position.x.next_up();
        }
    }
}
