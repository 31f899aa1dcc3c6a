//! Wrong laws in random scenes: each must be flagged by the closed forms that are written apart, with a fault that names the law.
//!
//! Most of them keep energy, edges and overlaps, which is all that random scenes were held to before.

use super::engines::{Fault, Wrong};
use super::slip::Slip;
use super::told;
use carom::engine::Setting;
use carom::physics::{Cloth, Contact, Cushion, Friction};
use carom::scene::Scene;
use carom::study::matrix::{Configuration, Watch};
use carom::study::random::{Failure, Plan, RandomOutcome, study};
use std::collections::BTreeSet;

/// Enough for each law with numbers that show it.
const SCENES: u64 = 400;

const SEED: u64 = 7;

const EXACT: &str = "exact";
const STEPPER: &str = "stepper";

/// One wrong law: the engine, what is wrong, the fault that must be seen, and a word of the law that it names.
type Mutant = (&'static str, Fault, &'static str, &'static str);

fn outcome(engine: &str, fault: Fault, scenes: u64) -> RandomOutcome {
    let rule = (engine == STEPPER).then_some("contact=approaching-only");
    let plan = Plan {
        first: 0,
        scenes,
        seed: SEED,
        columns: vec![Configuration {
            engine: Wrong::engine(engine, fault),
            setting: Setting::parse(rule).unwrap(),
        }],
        max_events: 100,
    };
    let watch = Watch::NONE;
    study(plan, watch)
}

#[test]
fn a_wrong_law_is_flagged_by_name_in_some_hundred_random_scenes() {
    let mut missed = Vec::new();
    for (number, (engine, fault, what, law)) in MUTANTS.iter().enumerate() {
        let named =
            |failure: &Failure| failure.fault.what == *what && failure.fault.words.contains(law);
        let flagged = |found: &RandomOutcome| found.failures.iter().any(named);
        let mut found = outcome(engine, *fault, SCENES);
        if !flagged(&found) {
            // a law that few scenes have
            found = outcome(engine, *fault, 10 * SCENES);
        }
        if !flagged(&found) {
            let seen: BTreeSet<&str> = found.failures.iter().map(|f| f.fault.what).collect();
            missed.push(format!("{number}: {engine} {what} {law}: {seen:?}"));
        }
    }
    assert!(MUTANTS.len() > 40, "{}", MUTANTS.len());
    assert!(missed.is_empty(), "not flagged:\n{}", missed.join("\n"));
}

#[test]
fn the_engines_as_they_are_are_flagged_by_nothing_where_the_wrong_ones_are() {
    for engine in [EXACT, STEPPER] {
        let found = outcome(engine, Fault::Scene(|_| {}), SCENES);
        assert_eq!(found.failures, [], "{engine}");
        let held = &found.entries[0].laws;
        assert!(
            held.impacts > 2000 && held.pieces > 5000,
            "{engine}: {held:?}"
        );
        assert!(held.integrated > 5, "{engine}: {held:?}");
        // looked at, and not from afar
        assert!(held.impact.value > 1e-3, "{engine}: {held:?}");
        assert!(held.piece.value > 1e-3, "{engine}: {held:?}");
    }
}

const MUTANTS: &[Mutant] = &[
    (
        EXACT,
        Fault::Scene(restitution_squared),
        "hit-restitution",
        "contact.inelastic",
    ),
    (
        EXACT,
        Fault::Scene(always_elastic),
        "hit-restitution",
        "contact.inelastic",
    ),
    (
        EXACT,
        Fault::Scene(not_quite_elastic),
        "hit-restitution",
        "contact.elastic",
    ),
    (
        EXACT,
        Fault::Scene(masses_equal),
        "hit-restitution",
        "contact.",
    ),
    (
        EXACT,
        Fault::Scene(|s| s.effects.friction = None),
        "hit-friction",
        "friction.constant",
    ),
    (
        EXACT,
        Fault::Scene(|s| s.effects.friction = None),
        "hit-spin",
        "friction.alciatore",
    ),
    (
        EXACT,
        Fault::Scene(friction_doubled),
        "hit-friction",
        "friction.constant",
    ),
    (
        EXACT,
        Fault::Scene(friction_pushes),
        "hit-friction",
        "friction.constant",
    ),
    (
        EXACT,
        Fault::Scene(slip_ignored),
        "hit-friction",
        "friction.alciatore",
    ),
    (
        EXACT,
        Fault::Scene(length_unit_ignored),
        "hit-friction",
        "friction.alciatore",
    ),
    (
        EXACT,
        Fault::Scene(falls_twice_as_fast),
        "hit-friction",
        "friction.alciatore",
    ),
    (
        EXACT,
        Fault::Scene(balls_too_large),
        "hit-distance",
        "touch",
    ),
    (
        EXACT,
        Fault::Trace(told::touch_at_the_sum),
        "hit-distance",
        "touch",
    ),
    (
        EXACT,
        Fault::Trace(told::spin_reversed),
        "hit-spin",
        "friction.",
    ),
    (
        EXACT,
        Fault::Trace(told::one_ball_only),
        "hit-momentum",
        "momentum",
    ),
    (
        EXACT,
        Fault::Scene(cushion_squared),
        "cushion-restitution",
        "cushion.restitution",
    ),
    (
        EXACT,
        Fault::Scene(cushion_elastic),
        "cushion-restitution",
        "cushion.restitution",
    ),
    (EXACT, Fault::Scene(cushion_off), "cushion-place", "place"),
    (
        EXACT,
        Fault::Scene(han_squared),
        "cushion-restitution",
        "cushion.han-2005",
    ),
    (
        EXACT,
        Fault::Scene(han_friction_off),
        "cushion-friction",
        "cushion.han-2005",
    ),
    (
        EXACT,
        Fault::Scene(han_friction_doubled),
        "cushion-spin",
        "cushion.han-2005",
    ),
    (
        EXACT,
        Fault::Scene(han_nose_lower),
        "cushion-restitution",
        "cushion.han-2005",
    ),
    (
        EXACT,
        Fault::Trace(told::han_never_sticks),
        "cushion-friction",
        "cushion.han-2005",
    ),
    (
        EXACT,
        Fault::Trace(told::han_always_sticks),
        "cushion-friction",
        "cushion.han-2005",
    ),
    (
        EXACT,
        Fault::Scene(mathavan_work_is_speed),
        "cushion-restitution",
        "cushion.mathavan-2010",
    ),
    (
        EXACT,
        Fault::Scene(mathavan_nose_smooth),
        "cushion-friction",
        "cushion.mathavan-2010",
    ),
    (
        EXACT,
        Fault::Scene(mathavan_cloth_smooth),
        "cushion-restitution",
        "cushion.mathavan-2010",
    ),
    (
        EXACT,
        Fault::Trace(told::side_forgotten),
        "cushion-spin",
        "cushion.elastic",
    ),
    (
        EXACT,
        Fault::Scene(|s| s.gravity /= 2.0),
        "cloth-velocity",
        "cloth.translational",
    ),
    (
        EXACT,
        Fault::Scene(|s| s.gravity /= 2.0),
        "cloth-velocity",
        "cloth.rotational",
    ),
    (
        EXACT,
        Fault::Scene(rolling_doubled),
        "cloth-velocity",
        "cloth.rotational",
    ),
    (
        EXACT,
        Fault::Scene(spinning_doubled),
        "cloth-spin",
        "cloth.rotational",
    ),
    (
        EXACT,
        Fault::Scene(sliding_doubled),
        "cloth-velocity",
        "cloth.rotational",
    ),
    (
        EXACT,
        Fault::Scene(|s| s.effects.cloth = None),
        "cloth-velocity",
        "cloth.translational",
    ),
    (
        EXACT,
        Fault::Trace(told::position_drifts),
        "cloth-place",
        "cloth.",
    ),
    (
        EXACT,
        Fault::Trace(told::stops_early),
        "cloth-velocity",
        "no cloth",
    ),
    (
        EXACT,
        Fault::Scene(|s| s.effects.pockets = None),
        "pocket-missed",
        "goes through pocket",
    ),
    (
        EXACT,
        Fault::Scene(pockets_too_small),
        "pocket-place",
        "rim",
    ),
    (EXACT, Fault::Trace(told::event_not_told), "told", "paths"),
    (
        STEPPER,
        Fault::Step(Slip::RestitutionSquared),
        "hit-restitution",
        "contact.inelastic",
    ),
    (
        STEPPER,
        Fault::Step(Slip::NotQuiteElastic),
        "hit-restitution",
        "contact.elastic",
    ),
    (
        STEPPER,
        Fault::Step(Slip::EnergyLeaks),
        "hit-restitution",
        "contact.",
    ),
    (
        STEPPER,
        Fault::Step(Slip::NormalTurned),
        "hit-friction",
        "no friction between balls",
    ),
    (
        STEPPER,
        Fault::Step(Slip::MassIgnored),
        "hit-momentum",
        "momentum",
    ),
    (
        STEPPER,
        Fault::Step(Slip::StaleContact),
        "hit-parting",
        "contact.",
    ),
    (
        STEPPER,
        Fault::Step(Slip::ThrowOff),
        "hit-friction",
        "friction.constant",
    ),
    (
        STEPPER,
        Fault::Step(Slip::SpinReversed),
        "hit-spin",
        "friction.",
    ),
    (
        STEPPER,
        Fault::Step(Slip::CushionLosesTwice),
        "cushion-restitution",
        "cushion.han-2005",
    ),
    (
        STEPPER,
        Fault::Step(Slip::SideForgotten),
        "cushion-spin",
        "cushion.elastic",
    ),
    (
        STEPPER,
        Fault::Step(Slip::WallForgetsPlace),
        "cushion-place",
        "place",
    ),
    (
        STEPPER,
        Fault::Step(Slip::CornerReversed),
        "corner-order",
        "into both",
    ),
    (
        STEPPER,
        Fault::Step(Slip::FrictionOnOneAxis),
        "cloth-velocity",
        "cloth.translational",
    ),
    (
        STEPPER,
        Fault::Step(Slip::FrictionPushes),
        "cloth-velocity",
        "cloth.translational",
    ),
    (
        STEPPER,
        Fault::Step(Slip::HalfGravity),
        "cloth-velocity",
        "cloth.translational",
    ),
    (
        STEPPER,
        Fault::Step(Slip::RollAtFourSevenths),
        "cloth-spin",
        "cloth.rotational",
    ),
    (
        STEPPER,
        Fault::Step(Slip::RollingDoubled),
        "cloth-velocity",
        "cloth.rotational",
    ),
    (
        STEPPER,
        Fault::Step(Slip::SpinningDoubled),
        "cloth-spin",
        "cloth.rotational",
    ),
    (
        STEPPER,
        Fault::Step(Slip::StepDoubled),
        "cloth-place",
        "cloth.",
    ),
    (
        STEPPER,
        Fault::Step(Slip::PocketMissed),
        "pocket-missed",
        "goes through pocket",
    ),
];

fn restitution_squared(scene: &mut Scene) {
    if let Some(Contact::Inelastic { e }) = &mut scene.effects.contact {
        *e *= *e;
    }
}

fn always_elastic(scene: &mut Scene) {
    scene.effects.contact = scene.effects.contact.map(|_| Contact::Elastic {});
}

fn not_quite_elastic(scene: &mut Scene) {
    if let Some(Contact::Elastic {}) = scene.effects.contact {
        scene.effects.contact = Some(Contact::Inelastic { e: 1.0 - 1e-9 });
    }
}

fn masses_equal(scene: &mut Scene) {
    let mass = scene.balls[0].mass;
    scene.balls.iter_mut().for_each(|ball| ball.mass = mass);
}

fn friction_doubled(scene: &mut Scene) {
    if let Some(Friction::Constant { mu }) = &mut scene.effects.friction {
        *mu *= 2.0;
    }
}

fn friction_pushes(scene: &mut Scene) {
    if let Some(Friction::Constant { mu }) = &mut scene.effects.friction {
        *mu = -*mu;
    }
}

/// The coefficient of a slip of nothing.
fn slip_ignored(scene: &mut Scene) {
    if let Some(Friction::Alciatore { a, b, .. }) = scene.effects.friction {
        scene.effects.friction = Some(Friction::Constant { mu: a + b });
    }
}

fn length_unit_ignored(scene: &mut Scene) {
    if let Some(Friction::Alciatore {
        length_in_metres, ..
    }) = &mut scene.effects.friction
    {
        *length_in_metres = 1.0;
    }
}

fn falls_twice_as_fast(scene: &mut Scene) {
    if let Some(Friction::Alciatore { c, .. }) = &mut scene.effects.friction {
        *c *= 2.0;
    }
}

fn balls_too_large(scene: &mut Scene) {
    scene
        .balls
        .iter_mut()
        .for_each(|ball| ball.radius *= 1.0 + 1e-8);
}

fn cushion_squared(scene: &mut Scene) {
    if let Some(Cushion::Restitution { e }) = &mut scene.effects.cushion {
        *e *= *e;
    }
}

fn cushion_elastic(scene: &mut Scene) {
    if let Some(Cushion::Restitution { .. }) = scene.effects.cushion {
        scene.effects.cushion = Some(Cushion::Elastic {});
    }
}

fn cushion_off(scene: &mut Scene) {
    let off = 1e-6 * scene.smallest_radius();
    if let Some(table) = &mut scene.table {
        table.max[0] += off;
    }
}

fn han(scene: &mut Scene, change: fn(&mut f64, &mut f64, &mut f64)) {
    if let Some(Cushion::Han2005 { e, mu, height }) = &mut scene.effects.cushion {
        change(e, mu, height);
    }
}

fn han_squared(scene: &mut Scene) {
    han(scene, |e, _, _| *e *= *e);
}

fn han_friction_off(scene: &mut Scene) {
    han(scene, |_, mu, _| *mu = 0.0);
}

fn han_friction_doubled(scene: &mut Scene) {
    han(scene, |_, mu, _| *mu *= 2.0);
}

fn han_nose_lower(scene: &mut Scene) {
    han(scene, |_, _, height| *height *= 0.99);
}

fn mathavan(scene: &mut Scene, change: fn(&mut f64, &mut f64, &mut f64)) {
    if let Some(Cushion::Mathavan2010 {
        e, mu, mu_cloth, ..
    }) = &mut scene.effects.cushion
    {
        change(e, mu, mu_cloth);
    }
}

/// Work returns `e` of what it was, where it should return `e^2`.
fn mathavan_work_is_speed(scene: &mut Scene) {
    mathavan(scene, |e, _, _| *e = e.sqrt());
}

fn mathavan_nose_smooth(scene: &mut Scene) {
    mathavan(scene, |_, mu, _| *mu = 0.0);
}

fn mathavan_cloth_smooth(scene: &mut Scene) {
    mathavan(scene, |_, _, mu_cloth| *mu_cloth = 0.0);
}

fn cloth(scene: &mut Scene, change: fn(&mut f64, &mut f64, &mut f64)) {
    if let Some(Cloth::Rotational {
        mu_slide,
        mu_roll,
        mu_spin,
    }) = &mut scene.effects.cloth
    {
        change(mu_slide, mu_roll, mu_spin);
    }
}

fn sliding_doubled(scene: &mut Scene) {
    cloth(scene, |slide, _, _| *slide *= 2.0);
}

fn rolling_doubled(scene: &mut Scene) {
    cloth(scene, |_, roll, _| *roll *= 2.0);
}

fn spinning_doubled(scene: &mut Scene) {
    cloth(scene, |_, _, spin| *spin *= 2.0);
}

fn pockets_too_small(scene: &mut Scene) {
    for circle in scene
        .effects
        .pockets
        .iter_mut()
        .flat_map(|p| &mut p.circles)
    {
        circle[2] *= 0.9;
    }
}
