//! The catalogue: every scene is what its name says, to the bit where others have its numbers.

use crate::support::{G, MU, R};
use carom::math::Vec3;
use carom::math::random::Draws;
use carom::physics::cue::Strike;
use carom::physics::{Cloth, Contact, Cushion};
use carom::scene::{
    Scene, SetName, Shot, Table, catalogue, is_kebab_case, nearest_names, parse, plan_vector,
    schema,
};
use serde_json::Value;
use std::collections::BTreeSet;
use std::fs;

fn scene(name: &str) -> Scene {
    catalogue::scene(name).unwrap_or_else(|error| panic!("{name}: {error}"))
}

fn reference(name: &str) -> Value {
    let path = format!(
        "{}/validation/references/{name}.json",
        env!("CARGO_MANIFEST_DIR")
    );
    serde_json::from_str(&fs::read_to_string(path).unwrap()).unwrap()
}

/// A number of a reference, which is text where the source has more digits than f64.
fn number(value: &Value) -> f64 {
    match value {
        Value::String(digits) => digits.parse().unwrap(),
        other => other.as_f64().unwrap(),
    }
}

#[test]
fn the_catalogue_is_the_directory() {
    let folder = format!("{}/validation/scenes", env!("CARGO_MANIFEST_DIR"));
    let files: BTreeSet<String> = fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    let listed: BTreeSet<String> = catalogue::all().iter().map(|e| e.file_name()).collect();
    assert_eq!(
        listed, files,
        "catalogue::all() and validation/scenes/ differ"
    );
    assert_eq!(
        listed.len(),
        catalogue::all().len(),
        "a scene is listed twice"
    );
}

#[test]
fn every_scene_is_named_like_its_file_and_says_what_would_be_right() {
    for entry in catalogue::all() {
        let scene = scene(entry.name);
        assert_eq!(scene.name, entry.name);
        assert!(is_kebab_case(&scene.name), "{}", scene.name);
        assert!(
            scene.description.contains("ight "),
            "{}: {}",
            scene.name,
            scene.description
        );
        assert!(!scene.sets.is_empty(), "{} is in no set", scene.name);
        if let Some(richer) = &scene.richer {
            assert!(
                catalogue::find(richer).is_some(),
                "{}: no scene {richer}",
                scene.name
            );
        }
    }
}

#[test]
fn every_set_finds_its_scenes() {
    assert!(catalogue::set(SetName::Report).unwrap().len() >= 8);
    assert!(catalogue::set(SetName::Gate).unwrap().len() >= 8);
}

#[test]
fn an_unknown_scene_is_answered_with_the_nearest_and_never_with_all() {
    const LIST: &str = "`carom scene list` prints all names";
    for (name, nearest, why) in [
        ("snooker", "", "nothing is like it"),
        ("x", "", "too short to tell"),
        ("-", "", "no letter at all"),
        (
            "Report_Break",
            "did you mean `report-break`? ",
            "the same but for how names are written",
        ),
        (
            "slde",
            "did you mean `slide` or `side`? ",
            "both are one letter away",
        ),
        (
            "rack-at",
            "did you mean `rack-at-rest` or `rack-at-rest-long`? ",
            "names that begin so",
        ),
        (
            "frozen-rack-c",
            "did you mean `rack-frozen-central`, `rack-frozen-central-reflections` or `rack-frozen-oblique`? ",
            "the same parts in another order, in the order of the catalogue",
        ),
        (
            "rack",
            "did you mean `rack-frozen-central`, `rack-frozen-central-reflections` or `rack-frozen-oblique`? ",
            "three of many",
        ),
        (
            "discs-in-a-box-with-gravity",
            "did you mean `discs-in-a-box`? ",
            "what it begins with",
        ),
    ] {
        let said = catalogue::scene(name).unwrap_err().to_string();
        let expected = format!("no scene is called `{name}`; {nearest}{LIST}");
        assert_eq!(said, expected, "{why}");
    }
}

#[test]
fn every_slip_in_a_name_leads_back_to_it() {
    let names: Vec<&str> = catalogue::all().iter().map(|entry| entry.name).collect();
    for &name in &names {
        let letters: Vec<char> = name.chars().collect();
        for at in 0..letters.len() {
            let (mut lost, mut swapped) = (letters.clone(), letters.clone());
            lost.remove(at);
            swapped.swap(at, (at + 1).min(letters.len() - 1));
            for slip in [lost, swapped] {
                let slip: String = slip.into_iter().collect();
                let near = nearest_names(&slip, names.iter().copied());
                assert!((1..=3).contains(&near.len()), "{slip}: {near:?}");
                // four names end in one digit after cradle-gap-1e-: any three of them are as good
                let as_near = |near: &&str| strsim::osa_distance(&slip, near) <= 1;
                assert!(
                    near.contains(&name) || near.iter().all(as_near),
                    "{slip}: {near:?}"
                );
            }
        }
    }
}

#[test]
fn reading_a_scene_twice_gives_the_same_hash_and_another_number_another() {
    let entry = catalogue::find("report-break").unwrap();
    let hash = |text: &str| parse("a.toml", text).unwrap().hash();
    assert_eq!(
        hash(entry.text),
        hash(&entry.text.replace("rows = 5", "rows =   5 # five"))
    );
    assert_ne!(
        hash(entry.text),
        hash(&entry.text.replace("90.2", "90.20000000000001"))
    );
}

#[test]
fn the_report_break_is_that_of_the_report() {
    let scene = scene("report-break");
    let corner = Table {
        min: [0.0, 0.0],
        max: [12.63, 24.3],
    };
    assert_eq!(scene.table, Some(corner));
    assert_eq!((scene.gravity, scene.duration), (G, 20.0));
    assert_eq!(scene.effects.cloth, Some(Cloth::Translational { mu: MU }));
    assert_eq!(scene.effects.contact, Some(Contact::Elastic {}));
    assert_eq!(scene.effects.cushion, Some(Cushion::Elastic {}));
    let ids: Vec<&str> = scene.balls.iter().map(|ball| ball.id.as_str()).collect();
    let expected = [
        "cue", "1", "2", "3", "4", "5", "6", "7", "8", "9", "10", "11", "12", "13", "14", "15",
    ];
    assert_eq!(ids, expected);
    assert!(
        scene
            .balls
            .iter()
            .all(|b| b.radius == R && b.mass == 0.107 && b.state.position.z == R)
    );
    let cue = &scene.balls[0].state;
    assert_eq!((cue.position.x, cue.position.y), (6.315, 6.075));
    // v = F t / m: 108 x 0.01 / 0.107; cos and sin each round once
    let (speed, angle) = (108.0 * 0.01 / 0.107, 90.2_f64.to_radians());
    assert!((cue.velocity.norm() - speed).abs() < 4.0 * f64::EPSILON * speed);
    assert!(
        (speed - 10.0934579).abs() < 1e-7,
        "the report's shot is 10.09, got {speed}"
    );
    assert!(
        (cue.velocity.x - speed * angle.cos()).abs() < 1e-14,
        "{}",
        cue.velocity.x
    );
    let shot = Shot::Force {
        ball: 0,
        angle_deg: 90.2,
        force: 108.0,
        contact_time: 0.01,
    };
    assert_eq!(scene.shot, Some(shot));
    assert!(scene.balls[1..].iter().all(|ball| ball.state.is_at_rest()));
}

/// A pool ball on a rotating cloth, struck off its centre.
const STRIKE: &str = r#"name = "strike"
duration = 5.0
gravity = 9.81
units = { length = "m", length_in_metres = 1.0 }
[ball]
radius = 0.028575
mass = 0.170097
[[balls]]
id = "cue"
position = [0.5, 0.5]
[shot.strike]
ball = "cue"
speed = 2.0
angle_deg = 30.0
elevation_deg = 5.0
cue_mass = 0.567
end_mass = 0.0056699
side = 0.3
top = -0.2
[effects.cloth.rotational]
mu_slide = 0.2
mu_roll = 0.01
mu_spin = 0.0127
[effects.contact.inelastic]
e = 0.95
[effects.friction.alciatore]
a = 0.009951
b = 0.108
c = 1.088
"#;

#[test]
fn a_strike_is_played_when_the_scene_is_read_and_the_scene_remembers_it() {
    let scene = parse("strike.toml", STRIKE).unwrap();
    let strike = Strike {
        speed: 2.0,
        angle_deg: 30.0,
        elevation_deg: 5.0,
        cue_mass: 0.567,
        end_mass: Some(0.0056699),
        side: 0.3,
        top: -0.2,
    };
    assert_eq!(scene.shot, Some(Shot::Strike { ball: 0, strike }));
    assert_eq!(scene.cue_ball(), 0);
    let cue = &scene.balls[0];
    let motion = strike.motion(cue.mass, cue.radius);
    assert_eq!(cue.state.velocity, motion.velocity);
    assert_eq!(cue.state.spin, motion.spin);
    // the energy of a rotating scene is that of velocity and spin, I = 2/5 m R^2
    let turning = 0.2 * cue.mass * (cue.radius * motion.spin.norm()).powi(2);
    let energy = 0.5 * cue.mass * motion.velocity.norm_squared() + turning;
    assert!((scene.initial_energy() - energy).abs() <= 8.0 * f64::EPSILON * energy);
    assert!(turning > 0.01 * energy);
    // what is absent is the middle of the ball, a level cue and no deflection
    let mut plain = STRIKE.to_owned();
    for line in [
        "elevation_deg = 5.0\n",
        "end_mass = 0.0056699\n",
        "side = 0.3\n",
        "top = -0.2\n",
    ] {
        plain = plain.replacen(line, "", 1);
    }
    let plain = parse("strike.toml", &plain).unwrap();
    assert_eq!(plain.balls[0].state.spin, Vec3::zeros());
    let along = plan_vector(1.0, 30.0);
    let aside = plain.balls[0].state.velocity.cross(&along);
    assert!(aside.norm() <= 4.0 * f64::EPSILON * plain.largest_speed());
    assert_ne!(plain.hash(), scene.hash());
}

#[test]
fn a_rack_is_a_triangle_of_neighbours_at_the_gap() {
    for (name, gap) in [("report-break", 1e-2 * R), ("report-break-frozen", 0.0)] {
        let scene = scene(name);
        let at = |i: usize| scene.balls[i].state.position;
        assert_eq!((at(1).x, at(1).y), (6.315, 18.225), "{name}: apex");
        // row by row: ball numbers of the rows of a triangle
        let rows: [&[usize]; 5] = [
            &[1],
            &[2, 3],
            &[4, 5, 6],
            &[7, 8, 9, 10],
            &[11, 12, 13, 14, 15],
        ];
        let mut neighbours = Vec::new();
        for (r, row) in rows.iter().enumerate() {
            for (k, &ball) in row.iter().enumerate() {
                if k > 0 {
                    neighbours.push((row[k - 1], ball));
                    assert!(at(row[k - 1]).x < at(ball).x, "{name}: x ascends in a row");
                }
                if let Some(next) = rows.get(r + 1) {
                    neighbours.extend([(ball, next[k]), (ball, next[k + 1])]);
                }
            }
        }
        assert_eq!(
            neighbours.len(),
            30,
            "a triangle of five rows has 30 touching pairs"
        );
        // a coordinate of 20 rounds to 3.6e-15; a distance has two of them, and the rack is built from one more
        let rounding = 3.0 * 20.0 * f64::EPSILON;
        for (a, b) in neighbours {
            let found = (at(a) - at(b)).norm() - 2.0 * R;
            assert!(
                (found - gap).abs() < rounding,
                "{name}: {a}-{b} have gap {found}, not {gap}"
            );
        }
    }
}

#[test]
fn jitter_is_a_function_of_seed_and_ball_and_stays_within_its_disc() {
    let text = catalogue::find("report-break").unwrap().text;
    let jittered = |seed: u32, rows: u32| {
        let rack = format!("rows = {rows}\njitter = 1e-3\nseed = {seed}");
        parse("a.toml", &text.replace("rows = 5", &rack)).unwrap()
    };
    let (still, seven) = (scene("report-break"), jittered(7, 5));
    for i in 1..still.balls.len() {
        let moved = seven.balls[i].state.position - still.balls[i].state.position;
        // the sum rounds to the spacing of f64 at 20
        assert!(
            moved.norm() > 0.0 && moved.norm() <= 1e-3 + 20.0 * f64::EPSILON,
            "{moved}"
        );
        let (dx, dy) = Draws::new(7, i as u64 - 1).in_disc(1e-3);
        assert!(
            (moved.x - dx).abs() < 1e-14 && (moved.y - dy).abs() < 1e-14,
            "ball {i}"
        );
    }
    assert_eq!(seven, jittered(7, 5), "the same seed gives the same scene");
    assert_ne!(
        seven.balls,
        jittered(8, 5).balls,
        "another seed gives another"
    );
    assert_eq!(
        jittered(7, 3).balls[..],
        seven.balls[..7],
        "a smaller rack draws the same"
    );
}

#[test]
fn scenes_with_known_answers_have_the_initial_data_of_their_reference_to_the_bit() {
    let known = [
        ("six-balls", "d1_report_6balls_mp50", ["table_x", "table_y"]),
        (
            "break-36-events",
            "d2_report_break_gap0.01_mp50",
            ["table_x", "table_y"],
        ),
        ("discs-in-a-box", "e_discs_seed1_mp260", ["L", "W"]),
    ];
    for (name, file, [width, length]) in known {
        let (scene, data) = (scene(name), reference(file));
        let meta = &data["meta"];
        let size = [number(&meta[width]), number(&meta[length])];
        assert_eq!(
            scene.table,
            Some(Table {
                min: [0.0, 0.0],
                max: size
            }),
            "{name}"
        );
        let (r0, v0) = (
            meta["r0"].as_array().unwrap(),
            meta["v0"].as_array().unwrap(),
        );
        assert_eq!(scene.balls.len(), r0.len(), "{name}");
        for (i, ball) in scene.balls.iter().enumerate() {
            let id = meta["names"][i]
                .as_str()
                .map_or(i.to_string(), str::to_owned);
            let mass = meta.get("m").unwrap_or(&meta["masses"][i]);
            let numbers = [
                (ball.state.position.x, &r0[i][0]),
                (ball.state.position.y, &r0[i][1]),
                (ball.state.velocity.x, &v0[i][0]),
                (ball.state.velocity.y, &v0[i][1]),
                (ball.radius, &meta["R"]),
                (ball.mass, mass),
            ];
            assert_eq!(ball.id, id, "{name}");
            for (got, expected) in numbers {
                assert_eq!(
                    got.to_bits(),
                    number(expected).to_bits(),
                    "{name}, ball {id}"
                );
            }
        }
        let mu = match scene.effects.cloth {
            Some(Cloth::Translational { mu }) => mu,
            Some(Cloth::Rotational { .. }) => panic!("{name} turns balls"),
            None => 0.0,
        };
        assert_eq!(mu, number(&meta["mu"]), "{name}");
        assert_eq!(scene.gravity, meta.get("g").map_or(0.0, number), "{name}");
        assert_eq!(scene.effects.contact, Some(Contact::Elastic {}), "{name}");
        assert_eq!(scene.effects.cushion, Some(Cushion::Elastic {}), "{name}");
    }
}

#[test]
fn scenes_with_known_answers_last_as_long_as_the_answer_is_within_reach() {
    let time = |data: &Value, i: usize| number(&data["events"][i]["t"]);
    for (name, file, last) in [
        ("six-balls", "d1_report_6balls_mp50", 6),
        ("break-36-events", "d2_report_break_gap0.01_mp50", 35),
        // chaotic: f64 keeps the order to about the 110th event, and the reference has 200
        ("discs-in-a-box", "e_discs_seed1_mp260", 110),
    ] {
        let (scene, data) = (scene(name), reference(file));
        assert!(
            scene.duration > time(&data, last),
            "{name} ends before event {last}"
        );
    }
}

#[test]
fn oblique_pairs_are_hit_at_their_cut_angle() {
    let scene = scene("oblique");
    let mut pairs = 0;
    for pair in scene.balls.chunks(2) {
        let offset = pair[1].state.position - pair[0].state.position;
        let cut: f64 = pair[0].id[1..].parse().unwrap();
        assert_eq!(pair[0].id[1..], pair[1].id[1..]);
        let expected = 2.0 * pair[0].radius * cut.to_radians().sin();
        // coordinates of at most 16 round to 1.8e-15, and the file's decimals to as much
        assert!(
            (offset.x - expected).abs() < 4e-15,
            "{cut}: offset {}",
            offset.x
        );
        assert!(
            offset.y > 2.0 * pair[0].radius && pair[1].state.is_at_rest(),
            "{cut}"
        );
        pairs += 1;
    }
    assert_eq!(pairs, 7);
    // the longest way a ball can go is that of the undisturbed cue ball, v^2 / (2 mu g), within the 2 m between pairs
    let reach = 1.5_f64.powi(2) / (2.0 * 0.2 * 9.81);
    assert!(
        2.0 * (reach + 0.028575) < 2.0,
        "pairs could meet: each reaches {reach}"
    );
}

#[test]
fn the_schema_knows_every_key_that_a_scene_uses_and_describes_it() {
    let schema = schema();
    let mut described = BTreeSet::new();
    let mut keys = BTreeSet::new();
    properties(&schema, &mut |key, property, parent| {
        keys.insert(key.to_owned());
        // one law of a choice is described beside its key, not below it
        if property["description"].is_string() || parent["description"].is_string() {
            described.insert(key.to_owned());
        }
    });
    let mut used = BTreeSet::new();
    for entry in catalogue::all() {
        let table: toml::Table = entry.text.parse().unwrap();
        keys_of(&toml::Value::Table(table), &mut used);
    }
    assert!(used.len() > 20, "{used:?}");
    let unknown: Vec<&String> = used.difference(&keys).collect();
    assert!(unknown.is_empty(), "the schema lacks {unknown:?}");
    let bare: Vec<&String> = keys.difference(&described).collect();
    assert!(bare.is_empty(), "the schema does not describe {bare:?}");
    assert_eq!(
        schema["additionalProperties"], false,
        "an editor must mark unknown keys"
    );
}

/// Calls `found` for every property anywhere in a schema: its key, its own schema and the one that it is in.
fn properties(schema: &Value, found: &mut impl FnMut(&str, &Value, &Value)) {
    if let Some(map) = schema["properties"].as_object() {
        map.iter()
            .for_each(|(key, property)| found(key, property, schema));
    }
    match schema {
        Value::Object(map) => map.values().for_each(|inner| properties(inner, found)),
        Value::Array(list) => list.iter().for_each(|inner| properties(inner, found)),
        _ => {}
    }
}

fn keys_of(value: &toml::Value, keys: &mut BTreeSet<String>) {
    match value {
        toml::Value::Table(table) => {
            for (key, inner) in table {
                keys.insert(key.clone());
                keys_of(inner, keys);
            }
        }
        toml::Value::Array(list) => list.iter().for_each(|inner| keys_of(inner, keys)),
        _ => {}
    }
}
