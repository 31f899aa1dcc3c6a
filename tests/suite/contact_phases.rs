//! Contacts that last, as a comparison tells them: what engines that step have in place of them, against their own records, and why they
//! are off by the end.

use crate::support::{find, roster, run};
use assert_cmd::Command;
use carom::compare::{Comparison, METRICS, contact_phases, of_pair};
use carom::engine::Setting;
use carom::finding::{Block, Cell, Document, Table};
use carom::page::compare::{LengthUnit, shorten, summary};
use carom::scene::{Scene, catalogue};
use carom::study::compare::{Cause, ComparisonOutcome, ContactStanding, plan, study};
use carom::study::{Configuration, Timing, Watch};
use carom::trace::{EventKind, Knot, Partner, Record, Trace};

fn scene(name: &str) -> Scene {
    catalogue::scene(name).unwrap()
}

fn compared(name: &str, columns: &[(&str, &str)]) -> ComparisonOutcome {
    let column = |&(engine, setting): &(&str, &str)| Configuration {
        engine: find(engine).unwrap().clone(),
        setting: Setting::parse(setting.split_whitespace()).unwrap(),
    };
    let columns: Vec<Configuration> = columns.iter().map(column).collect();
    let columns = plan(roster(), &columns);
    study(&scene(name), None, &columns, Timing::None, Watch::NONE)
}

/// The contacts of one engine in a comparison of it with the exact one.
fn contacts_of(name: &str, engine: &str) -> Vec<ContactStanding> {
    let outcome = compared(name, &[(engine, "")]);
    let standing = outcome.entries[1].standing.clone();
    standing.unwrap().contacts
}

/// Where a ball is at `time`: the cubic through the knots around it. Plain sums, apart from those of the library.
fn place(trace: &Trace, ball: usize, time: f64) -> [f64; 2] {
    let knots = &trace.paths[ball].knots;
    let at = |knot: &Knot| [knot.state.position.x, knot.state.position.y];
    let Some(next) = knots.iter().position(|knot| knot.time > time) else {
        return at(knots.last().unwrap());
    };
    let (a, b) = (&knots[next - 1], &knots[next]);
    let h = b.time - a.time;
    let s = (time - a.time) / h;
    let (va, vb) = (a.state.velocity, b.state.velocity);
    let cubic = |p: f64, v: f64, q: f64, w: f64| {
        p + s
            * (h * v + s * (3.0 * (q - p) - h * (2.0 * v + w) + s * (2.0 * (p - q) + h * (v + w))))
    };
    let (p, q) = (at(a), at(b));
    [cubic(p[0], va.x, q[0], vb.x), cubic(p[1], va.y, q[1], vb.y)]
}

#[test]
fn a_contact_is_told_in_the_hits_and_places_of_every_engine() {
    // the contact as 60 digits give it: the scenes' descriptions and references/contact
    let cases = [
        (
            "accumulate-three",
            EventKind::BallBall(0, 1),
            0.299662020106,
            "the ball slides until it rolls",
        ),
        (
            "press-cushion",
            EventKind::BallCushion(0, carom::physics::Side::X1),
            0.2347962286,
            "until it rests",
        ),
    ];
    for (name, hit, begin, why) in cases {
        let outcome = compared(name, &[("stepper", ""), ("rapier-f64", "")]);
        let exact = outcome.entries[0].trace().unwrap();
        let hits: Vec<f64> = exact
            .events
            .iter()
            .filter(|e| e.kind == hit)
            .map(|e| e.time)
            .collect();
        let [phase] = contact_phases(exact)[..] else {
            panic!("{name} has one contact, {why}");
        };
        assert_eq!(phase.hit, hit, "{name}");
        assert!(
            (phase.begin - begin).abs() < 1e-9,
            "{name}: {}",
            phase.begin
        );
        let place_in = hits.iter().position(|time| *time == phase.from).unwrap();
        assert_eq!(
            phase.hits,
            hits.len() - place_in,
            "{name}: every hit from the first of the run leads to it"
        );
        for entry in &outcome.entries[1..] {
            let (label, trace) = (entry.label(), entry.trace().unwrap());
            let standing = entry.standing.as_ref().unwrap();
            let [contact] = &standing.contacts[..] else {
                panic!("{label} in {name}: {why}");
            };
            // an overlap that began earlier and lasts is one that the window has: none does in these scenes
            let dt = trace.provenance.resolution;
            let own = || {
                let within = |time: f64| time >= phase.from - dt && time <= phase.end + dt;
                trace
                    .events
                    .iter()
                    .filter(move |e| e.kind == hit && within(e.time))
            };
            assert!(own().count() > 0, "{label} in {name}");
            assert_eq!(contact.hits.episodes, own().count(), "{label} in {name}");
            let exchanges: u64 = own().filter_map(|e| e.exchanges).sum();
            assert_eq!(contact.hits.exchanges, exchanges, "{label} in {name}");
            let balls = if name == "press-cushion" { 1 } else { 2 };
            for (time, error) in [
                (phase.begin, contact.error_at_begin),
                (phase.end, contact.error_at_end),
            ] {
                let apart = (0..balls).map(|ball| {
                    let (p, q) = (place(trace, ball, time), place(exact, ball, time));
                    (p[0] - q[0]).hypot(p[1] - q[1])
                });
                let expected = apart.fold(0.0, f64::max) / outcome.scene.smallest_radius();
                let error = error.unwrap();
                // the same sums in another order
                assert!(
                    (error - expected).abs() < 1e-12,
                    "{label} in {name} at {time}: {error}, {expected}"
                );
            }
            let told = outcome
                .findings_of(&label, "contact-error-end")
                .map(|f| (f.subject.as_str(), f.value));
            let subject = if name == "press-cushion" {
                "cue-x1"
            } else {
                "cue-1"
            };
            assert_eq!(told.collect::<Vec<_>>(), [(subject, contact.error_at_end)]);
        }
    }
}

#[test]
fn what_impacts_come_to_is_known_though_more_digits_have_more_of_them() {
    // dd, which has them all, is where f64 is
    let outcome = compared(
        "accumulate-three",
        &[("exact", ""), ("exact", "precision=dd")],
    );
    let standing = outcome.entries[1].standing.as_ref().unwrap();
    let [contact] = &standing.contacts[..] else {
        panic!("one contact")
    };
    assert!(outcome.certain_until().is_infinite());
    for error in [contact.error_at_begin, contact.error_at_end] {
        assert!(error.unwrap() < carom::oracle::BAND, "{error:?}");
    }
    assert!(contact.own.is_none(), "it does not step");
}

#[test]
fn nothing_is_said_of_a_contact_beyond_the_horizon() {
    // f64 is certain of this shot to the end of both contacts, so both are told
    let outcome = compared("accumulate-four-lossy", &[("stepper", "")]);
    let (exact, standing) = (outcome.entries[0].trace(), &outcome.entries[1].standing);
    let phases = contact_phases(exact.unwrap());
    assert!(
        phases
            .iter()
            .all(|phase| phase.end <= outcome.certain_until())
    );
    let contacts = &standing.as_ref().unwrap().contacts;
    let told: Vec<_> = contacts.iter().map(|c| c.phase).collect();
    assert_eq!(told, phases);
    assert_eq!(told.len(), 2);
    // with a horizon between them only the first is
    let four = scene("accumulate-four-lossy");
    let [exact, stepper] =
        ["exact", "stepper"].map(|engine| run(engine, &[], &four, Record::Events));
    let between = 0.5 * (phases[0].end + phases[1].begin);
    let comparison = Comparison::new(&four, &stepper, &exact).up_to(between);
    let findings = of_pair(&comparison, "stepper");
    let begins = findings
        .iter()
        .filter(|f| f.metric == "contact-error-begin");
    assert_eq!(begins.count(), 1);
    // one that lies in a contact leaves its begin
    let scene = scene("press-plastic");
    let [exact, stepper] =
        ["exact", "stepper"].map(|engine| run(engine, &[], &scene, Record::Events));
    for (horizon, wanted) in [(1.0, [true, false]), (f64::INFINITY, [true, true])] {
        let comparison = Comparison::new(&scene, &stepper, &exact).up_to(horizon);
        let findings = of_pair(&comparison, "stepper");
        let has = |metric: &str| {
            findings
                .iter()
                .find(|f| f.metric == metric)
                .unwrap()
                .value
                .is_some()
        };
        assert_eq!(
            ["contact-error-begin", "contact-error-end"].map(has),
            wanted,
            "{horizon}"
        );
    }
}

#[test]
fn an_error_that_a_finer_step_does_not_cure_is_told_from_one_that_it_does() {
    // a ball whose slides are followed in full is off by the step alone; one that is pushed while it rolls loses part of its rolling
    // resistance at every exchange, however many there are
    for (name, cured) in [
        ("press-plastic", true),
        ("press-three", false),
        ("press-follow", false),
    ] {
        for contact in contacts_of(name, "stepper") {
            let own = contact.own.unwrap();
            let finest = own.ablations.iter().find(|a| a.finer > 1.0).unwrap();
            assert!(own.exchanges > 100, "{name}: {}", own.exchanges);
            if cured {
                // of first order: a 16th, up to a factor of 2
                assert!(finest.error < own.error / 8.0, "{name}: {own:?}");
            } else {
                assert!(finest.error > own.error / 2.0, "{name}: {own:?}");
            }
        }
    }
}

#[test]
fn what_no_step_cures_is_the_rolling_loss_that_exchanges_leave_out() {
    // each exchange J leaves a slide of 2 J / (7 mu_slide m g) in which rolling resistance takes nothing: of a force lambda the share
    // 2 lambda / (7 mu_slide m g), however small the exchanges are. A ball that slides pushes one that rolls until it rolls itself, and
    // both roll out with what was not taken
    let (g, mu_slide, mu_roll, mu) = (9.81, 0.2, 0.01, 0.06);
    let outcome = compared("press-follow", &[("stepper", "contact=approaching-only")]);
    let exact = outcome.entries[0].trace().unwrap();
    let own = outcome.entries[1].standing.as_ref().unwrap().contacts[0].clone();
    let begin = own.phase.begin;
    let rolls = |e: &&carom::trace::Event| e.kind == EventKind::SlideToRoll(0) && e.time > begin;
    let end = exact.events.iter().find(rolls).unwrap().time;
    let response = 1.0 + 5.0 / 7.0 * (1.0 - mu);
    let lambda = (mu_slide + mu_roll) * g / response;
    let left_out = 2.0 * lambda / (7.0 * mu_slide * g) * mu_roll * g;
    let faster = left_out / response * (end - begin);
    let speed = exact.paths[0].state_at(end).unwrap().velocity.x;
    let farther = 0.5 * faster * (end - begin) + (speed + 0.5 * faster) * faster / (mu_roll * g);
    let radius = outcome.scene.smallest_radius();
    let own = own.own.unwrap();
    let finest = own.ablations.iter().find(|a| a.finer > 1.0).unwrap();
    // lambda, and with it the time of the press, is itself less by what is left out of (mu_slide + mu_roll) g
    let tolerance = left_out / ((mu_slide + mu_roll) * g) * farther / radius;
    for error in [own.error, finest.error] {
        assert!(
            (error - farther / radius).abs() < tolerance,
            "{error}, predicted {} +- {tolerance}",
            farther / radius
        );
    }
}

#[test]
fn an_error_that_a_ball_has_without_contact_is_not_put_down_to_the_contact() {
    let contacts = contacts_of("press-plastic", "rapier-f64");
    let own = contacts[0].own.as_ref().unwrap();
    let alone = own.alone.unwrap();
    // rapier settles a ball into its cloth when it starts, which costs every ball so much
    assert!(
        alone * 4.0 > own.error && alone < own.error * 4.0,
        "{own:?}"
    );
}

#[test]
fn a_ball_at_a_cushion_is_held_against_no_ball_without_one() {
    let contacts = contacts_of("press-cushion", "stepper");
    let own = contacts[0].own.as_ref().unwrap();
    assert!(own.alone.is_none() && own.error > 0.0, "{own:?}");
}

#[test]
fn a_contact_that_ends_as_it_begins_is_off_by_what_was_before() {
    // a rack with losses: impacts of two come to a limit from which they part
    let contacts = contacts_of("soft-break-2ms", "stepper");
    let contact = contacts.first().unwrap();
    assert_eq!(contact.phase.begin, contact.phase.end);
    assert!(contact.is_short && contact.own.is_none());
    assert_eq!(contact.error_at_begin, contact.error_at_end);
}

fn contact_table(document: &Document) -> Option<&Table> {
    document.blocks.iter().find_map(|block| match block {
        Block::Table(table) if table.id == "contact-phases" => Some(table),
        _ => None,
    })
}

#[test]
fn the_table_has_a_row_a_contact_and_engine_and_says_why() {
    let outcome = compared("press-three", &[("stepper", "")]);
    let document = summary(&outcome, LengthUnit::Radius);
    let table = contact_table(&document).unwrap();
    assert_eq!(
        table.rows.len(),
        4,
        "two contacts, the reference and the stepper"
    );
    let words = |cell: &Cell| match cell {
        Cell::Text(words) => words.clone(),
        other => panic!("{other:?}"),
    };
    for row in [&table.rows[1], &table.rows[3]] {
        let why = words(row.last().unwrap());
        assert!(
            why.contains("not the overlap rule as written or the time step"),
            "{why}"
        );
        assert!(why.contains("exchanges in place of a force"), "{why}");
    }
    // a reader of a terminal gets as many rows as he takes in, and is told of the others
    let mut long = document.clone();
    for block in &mut long.blocks {
        if let Block::Table(table) = block
            && table.id == "contact-phases"
        {
            table.rows = table.rows.iter().cycle().take(15).cloned().collect();
        }
    }
    shorten(&mut long);
    let cut = contact_table(&long).unwrap();
    assert_eq!(cut.rows.len(), 12);
    assert!(cut.note.starts_with("And 3 more rows"), "{}", cut.note);
}

#[test]
fn the_terminal_shows_contacts_and_the_files_for_programs_have_them() {
    let printed = |arguments: &[&str]| {
        let output = Command::cargo_bin("carom")
            .unwrap()
            .args(arguments)
            .output()
            .unwrap();
        assert!(output.status.success(), "{output:?}");
        String::from_utf8(output.stdout).unwrap()
    };
    let engines = ["--engines", "exact,stepper"];
    let text = printed(&["compare", "press-plastic", engines[0], engines[1]]);
    assert!(text.contains("Contacts that last"), "{text}");
    let csv = printed(&[
        "compare",
        "press-plastic",
        engines[0],
        engines[1],
        "--format",
        "csv",
    ]);
    assert!(csv.contains("# contact-phases.csv"), "{csv}");
}

#[test]
fn a_scene_without_contacts_has_no_rows_of_them() {
    let outcome = compared("head-on", &[("stepper", "")]);
    assert!(contact_table(&summary(&outcome, LengthUnit::Radius)).is_none());
    let scene = scene("head-on");
    let [exact, stepper] =
        ["exact", "stepper"].map(|engine| run(engine, &[], &scene, Record::Events));
    let findings = of_pair(&Comparison::new(&scene, &stepper, &exact), "stepper");
    assert!(
        METRICS
            .iter()
            .filter(|metric| metric.id.starts_with("contact-"))
            .count()
            == 5
    );
    assert!(!findings.is_empty() && !findings.iter().any(|f| f.metric.starts_with("contact-")));
}

#[test]
fn hits_while_the_reference_presses_are_no_other_order_without_a_cause() {
    let outcome = compared("press-cushion", &[("stepper", "")]);
    let standing = outcome.entries[1].standing.as_ref().unwrap();
    let parting = standing.order.parting.as_ref().unwrap();
    let side = carom::physics::Side::X1;
    let exact = outcome.entries[0].trace().unwrap();
    let begin = exact
        .events
        .iter()
        .find(|e| e.kind == EventKind::ContactBegin(0, Partner::Cushion(side)));
    assert!(parting.event.unwrap().time > begin.unwrap().time);
    let Some(Cause::Contact { name, interval, .. }) = &standing.cause else {
        panic!("{:?}", standing.cause);
    };
    assert_eq!((name.as_str(), *interval), ("cue-x1", None));
}
