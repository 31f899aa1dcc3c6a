//! Engine `exact` with many balls: cells change what a run costs and nothing else.

use crate::support::{MU, R, run, scenario};
use carom::engine::{self, Limits, Setting};
use carom::math::first_root::{Approach, Blur, Contact, first_contact, first_contact_by};
use carom::math::random::Draws;
use carom::scene::generate::{Recipe, generate};
use carom::scene::{Scene, Simultaneous, catalogue, parse};
use carom::trace::{Ending, EventKind, Record, Trace};
use std::collections::BTreeMap;
use std::f64::consts::PI;

/// A generated scene, changed.
struct Discs {
    recipe: Recipe,
    /// Radii are drawn from this part of the recipe's radius up to all of it.
    smallest: f64,
    /// Part of the balls that rests.
    resting: f64,
    /// Whether there is a table.
    bounded: bool,
}

impl Discs {
    fn new(balls: usize, density: f64, seed: u64, duration: f64) -> Self {
        Discs {
            recipe: Recipe {
                balls,
                density,
                seed,
                duration,
                ..Recipe::default()
            },
            smallest: 1.0,
            resting: 0.0,
            bounded: true,
        }
    }

    fn cloth(mut self, mu: f64) -> Self {
        self.recipe.mu = Some(mu);
        self.recipe.speed = 5.0;
        self
    }

    fn radii_from(mut self, smallest: f64) -> Self {
        self.smallest = smallest;
        self
    }

    fn resting(mut self, part: f64) -> Self {
        self.resting = part;
        self
    }

    fn unbounded(mut self) -> Self {
        self.bounded = false;
        self
    }

    fn scene(&self) -> Scene {
        let text = generate(&self.recipe).unwrap();
        let mut scene = parse("generated", &text).unwrap();
        for (i, ball) in scene.balls.iter_mut().enumerate() {
            let mut draws = Draws::new(self.recipe.seed + 1000, i as u64);
            ball.radius *= draws.between(self.smallest, 1.0);
            ball.mass = ball.radius * ball.radius;
            ball.state.position.z = ball.radius;
            if draws.uniform() < self.resting {
                ball.state.velocity.fill(0.0);
            }
        }
        if !self.bounded {
            scene.table = None;
            scene.effects.cushion = None;
        }
        scene
    }
}

fn trace(scene: &Scene, precision: &str, partners: &str) -> Trace {
    let settings = [
        format!("precision={precision}"),
        format!("partners={partners}"),
    ];
    let settings: Vec<&str> = settings.iter().map(String::as_str).collect();
    run("exact", &settings, scene, Record::Events)
}

/// The trace without what says how it came about.
fn outcome(mut trace: Trace) -> Trace {
    trace.counters.clear();
    trace.provenance.parameters.clear();
    trace
}

fn hold_equal(name: &str, scene: &Scene, precision: &str, least_events: usize) {
    let (all, cells) = (
        trace(scene, precision, "all"),
        trace(scene, precision, "cells"),
    );
    let context = format!("exact, {name}, {precision}: {:?}", cells.counters);
    assert!(all.events.len() >= least_events, "{context}");
    assert_eq!(all.counters["cell_crossings"], 0, "{context}");
    assert!(cells.counters["cell_crossings"] > 0, "{context}");
    assert!(
        cells.counters["root_calls"] < all.counters["root_calls"],
        "{context}"
    );
    for (i, (a, b)) in all.events.iter().zip(&cells.events).enumerate() {
        assert_eq!(a, b, "event {i}; {context}");
    }
    assert!(outcome(all) == outcome(cells), "{context}");
}

#[test]
fn cells_change_no_bit_of_a_trace() {
    let discs = Discs::new;
    for (name, discs, least_events) in [
        ("thin gas", discs(150, 0.02, 1, 100.0), 100),
        ("gas", discs(200, 0.3, 2, 10.0), 100),
        ("dense", discs(100, 0.6, 3, 4.0), 100),
        ("close-packed", discs(120, 0.8, 4, 0.5), 100),
        ("cloth", discs(200, 0.3, 5, 20.0).cloth(0.05), 100),
        (
            "cloth, most at rest",
            discs(300, 0.4, 6, 20.0).cloth(0.02).resting(0.9),
            100,
        ),
        ("many radii", discs(200, 0.4, 7, 8.0).radii_from(0.2), 100),
        (
            "many radii on a cloth",
            discs(150, 0.5, 8, 20.0).cloth(0.1).radii_from(0.3),
            100,
        ),
        ("plane", discs(200, 0.5, 9, 50.0).unbounded(), 100),
        (
            "plane with a cloth",
            discs(200, 0.5, 10, 20.0).cloth(0.05).unbounded(),
            100,
        ),
        (
            "most at rest on a plane",
            discs(200, 0.6, 11, 50.0).resting(0.9).unbounded(),
            80,
        ),
    ] {
        hold_equal(name, &discs.scene(), "f64", least_events);
    }
}

#[test]
fn cells_change_no_bit_in_any_scalar() {
    for precision in ["f32", "dd", "f256"] {
        for (name, discs, least_events) in [
            ("gas", Discs::new(60, 0.3, 21, 3.0), 40),
            (
                "cloth",
                Discs::new(50, 0.3, 22, 3.0).cloth(0.05).resting(0.5),
                40,
            ),
            (
                "plane, many radii",
                Discs::new(60, 0.6, 23, 5.0).radii_from(0.4).unbounded(),
                40,
            ),
        ] {
            hold_equal(name, &discs.scene(), precision, least_events);
        }
    }
}

#[test]
fn a_gas_that_flies_apart_lays_its_cells_out_anew() {
    // after 1e6 s the outermost squares of the first layout would hold everything
    let scene = Discs::new(400, 0.3, 31, 1e6).unbounded().scene();
    let cells = trace(&scene, "f64", "cells");
    assert!(cells.counters["cell_layouts"] > 1, "{:?}", cells.counters);
    // a layout is left in a number of steps that does not grow with the time
    assert!(
        cells.counters["cell_crossings"] < 400 * 1000,
        "{:?}",
        cells.counters
    );
    hold_equal("flying apart", &scene, "f64", 100);
}

#[test]
fn cells_change_no_bit_of_the_scenes_of_the_catalogue() {
    let mut crossings = 0;
    for entry in catalogue::all() {
        let scene = entry.scene().unwrap();
        let (all, cells) = (trace(&scene, "f64", "all"), trace(&scene, "f64", "cells"));
        crossings += cells.counters["cell_crossings"];
        assert!(outcome(all) == outcome(cells), "exact, {}", scene.name);
    }
    assert!(crossings > 0);
}

#[test]
fn touching_balls_are_found_through_cells() {
    for simultaneous in [Simultaneous::Refuse, Simultaneous::GeneralizedReflections] {
        // a hexagonal crystal without gaps, and one ball that is shot into it
        let mut builder = scenario("crystal").cloth(MU).duration(20.0);
        for row in 0..8 {
            for place in 0..8 {
                let shift = 0.5 * f64::from(row % 2);
                let x = 2.0 * R * (f64::from(place) + shift);
                let y = 2.0 * R * 0.75_f64.sqrt() * f64::from(row);
                builder = builder.resting(&format!("{row}-{place}"), [x, y]);
            }
        }
        let mut scene = builder.shot("cue", [R, -3.0], 10.0, 91.0).build();
        scene.simultaneous = simultaneous;
        let (all, cells) = (trace(&scene, "f64", "all"), trace(&scene, "f64", "cells"));
        match simultaneous {
            Simultaneous::Refuse => assert_eq!(cells.ending.id(), "indeterminate"),
            _ => assert!(cells.events.len() > 64, "{:?}", cells.ending),
        }
        assert!(outcome(all) == outcome(cells), "exact, {simultaneous:?}");
    }
}

/// Work and memory of a whole run up to a number of events: most bytes at one time, and counters.
fn consumption(balls: usize, events: u64) -> (f64, BTreeMap<String, u64>) {
    let scene = Discs::new(balls, 0.3, 41, 1e3).scene();
    let engine = crate::support::find("exact").unwrap();
    let limits = Limits {
        max_events: events,
        ..Limits::NONE
    };
    let mut counters = BTreeMap::new();
    let used = allocation_counter::measure(|| {
        let run = engine::prepare(engine.as_ref(), &scene, &Setting::default()).unwrap();
        counters = run.simulate(Record::Final, &limits).counters;
    });
    (used.bytes_max as f64, counters)
}

#[test]
fn memory_grows_linearly_with_the_balls_and_work_for_an_event_not_at_all() {
    // sizes whose trees and lists are as full as each other: a power of two apart
    let (small, large) = (2_000, 8_000);
    let (bytes, counters) = consumption(small, 4_000);
    let (more_bytes, more_counters) = consumption(large, 16_000);
    assert_eq!(counters["events"], 4_000);
    assert_eq!(more_counters["events"], 16_000);
    // lists whose length is a square root, such as those of the edge of the box, grow less; nothing grows more
    let ratio = more_bytes / bytes;
    assert!(
        ratio <= 4.1,
        "{bytes} bytes for {small}, {more_bytes} for {large}"
    );
    // below is nothing that could be hidden: states, flights and candidates of every ball are 300 bytes at least
    assert!(bytes >= 300.0 * small as f64, "{bytes}");
    // four times the events; 0.055 of the small box is within a contact of a cushion, 8 sqrt(0.3 / pi / N), where work differs
    for name in ["root_calls", "cell_crossings"] {
        let ratio = more_counters[name] as f64 / counters[name] as f64;
        assert!((ratio / 4.0 - 1.0).abs() <= 0.055, "{name}: {ratio}");
    }
}

/// Collisions of a gas of discs for each disc and second, by Enskog with the contact value of Henderson (1975, Mol. Phys. 30,
/// 971): `sqrt(pi) n D g sqrt(k T / m)`, `g = (1 - 7 eta / 16) / (1 - eta)^2`. Radius 1, root mean square of the speeds 1;
/// `area`: of the box, for each disc.
fn enskog_rate(area: f64) -> f64 {
    let eta = PI / area;
    let at_contact = (1.0 - 7.0 * eta / 16.0) / (1.0 - eta).powi(2);
    // two degrees of freedom share the mean square
    PI.sqrt() / area * 2.0 * at_contact * 0.5_f64.sqrt()
}

#[test]
fn a_gas_of_discs_collides_as_often_as_enskog_says() {
    let (balls, density, from, to) = (4_000, 0.3, 5.0, 15.0);
    let scene = Discs::new(balls, density, 51, to).scene();
    let trace = run("exact", &[], &scene, Record::Events);
    assert_eq!(trace.ending, Ending::Duration);
    // the lattice is forgotten after a few collisions of every disc
    let hits = trace
        .events
        .iter()
        .filter(|event| matches!(event.kind, EventKind::BallBall(..)) && event.time >= from);
    let hits = hits.count() as f64;
    let rate = hits / (balls as f64 * (to - from));
    let area = PI / density;
    let expected = enskog_rate(area);
    // centres have a box that is a diameter smaller; the truth lies between both
    let side = (area * balls as f64).sqrt();
    let edge = enskog_rate((side - 2.0).powi(2) / balls as f64) / expected - 1.0;
    let chance = 3.0 / hits.sqrt();
    assert!(
        (rate / expected - 1.0).abs() <= edge + chance,
        "exact, {balls} discs: {rate} collisions a disc and second, Enskog {expected}, edge {edge}, chance {chance}"
    );
}

#[test]
fn a_search_that_may_give_up_finds_the_same_contact_to_the_bit() {
    let blur = Blur {
        length: 1e-14,
        speed: 1e-14,
    };
    let (end, mut kept, mut given_up) = (4.0, 0, 0);
    for index in 0..20_000 {
        let mut draws = Draws::new(61, index);
        let mut vector = |size: f64| {
            let (x, y) = draws.in_disc(size);
            [x, y]
        };
        let approach = Approach {
            p: vector(8.0),
            v: vector(4.0),
            a: vector(2.0),
            distance: 1.0,
        };
        let found = first_contact(&approach, end, &blur);
        let (Contact::At(time) | Contact::Unclear(time)) = found else {
            continue;
        };
        // a few ulps later is what the finder asks for
        for limit in [time + 1e-14, 1.1 * time, 0.5 * (time + end), end] {
            let limit = limit.min(end);
            assert_eq!(
                first_contact_by(&approach, end, limit, &blur),
                found,
                "{approach:?}"
            );
            kept += 1;
        }
        if first_contact_by(&approach, end, 0.5 * time, &blur) == Contact::Never {
            given_up += 1;
        }
    }
    assert!(
        kept > 4_000 && given_up > 1_000,
        "{kept} kept, {given_up} given up"
    );
}
