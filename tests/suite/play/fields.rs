//! From a scene to the fields of its form and back, and errors at the fields.

use super::browser::encoded;
use super::{Never, as_json, drawn_up, errors, get, handle, parsed, post, sent, shot, site, text};
use carom::math::random::Draws;
use carom::physics::EFFECTS;
use carom::scene::{catalogue, parse};
use carom::web::MOST_BALLS;
use serde_json::{Value, json};

/// The form of a catalogue scene as a browser sends it, untouched.
fn untouched(name: &str) -> Vec<(String, String)> {
    sent(text(&get(&format!("/?scene={name}"))))
}

#[test]
fn a_form_that_nobody_touched_is_the_scene_as_written() {
    let mut same = 0;
    for entry in catalogue::all() {
        let pairs = untouched(entry.name);
        // through a body of a form, whose lines end as HTTP's do
        let mut as_sent = pairs.clone();
        for (name, value) in &mut as_sent {
            if name == "scene" {
                *value = value.replace('\n', "\r\n");
            }
        }
        let request = post(
            "/scene",
            "application/x-www-form-urlencoded",
            &encoded(&as_sent),
        );
        let by_form = parsed(&handle(&request, &site(), &Never));
        let by_json = drawn_up(&json!({ "scene": entry.text, "fields": as_json(&pairs) }));
        for answer in [by_form, by_json] {
            match answer["toml"].as_str() {
                Some(toml) => {
                    assert_eq!(toml, entry.text, "{}", entry.name);
                    same += 1;
                }
                None => {
                    let why = errors(&answer);
                    assert!(
                        why.iter().all(|why| why.contains("for this page")),
                        "{}: {why:?}",
                        entry.name
                    );
                }
            }
        }
    }
    assert!(same > catalogue::all().len(), "{same} of two ways each");
}

#[test]
fn every_law_of_the_format_is_in_the_form_with_numbers_that_make_a_scene() {
    for effect in EFFECTS {
        let (choice, law) = effect.id.split_once('.').unwrap_or((effect.id, "given"));
        let path = format!("effects.{choice}");
        let mut fields = json!({ path: law });
        let rotates = match effect.id {
            "cloth.translational" => false,
            id => id.starts_with("friction") || id.contains("han") || id.contains("mathavan"),
        };
        if rotates {
            fields["effects.cloth"] = json!("rotational");
        }
        let answer = drawn_up(&json!({ "fields": fields }));
        assert_eq!(errors(&answer), [""; 0], "{}", effect.id);
        let scene = parse("x.toml", answer["toml"].as_str().unwrap()).unwrap();
        assert!(scene.effects.named().contains(&effect.id), "{}", effect.id);
        // its numbers are fields, unless they are of the five
        let form = answer["form"].as_str().unwrap();
        for number in effect.numbers {
            let own = format!("name=\"effects.{}.{number}\"", effect.id);
            let above = form.contains(&format!("<b>{}</b> is <a", number.replace('_', " ")));
            assert!(form.contains(&own) || above, "{} lacks {number}", effect.id);
        }
    }
    for kind in ["force", "velocity", "strike"] {
        let fields = json!({ "shot": kind, "effects.cloth": "rotational" });
        let answer = drawn_up(&json!({ "fields": fields }));
        let scene = parse("x.toml", answer["toml"].as_str().unwrap()).unwrap();
        let ball = &scene.balls[scene.cue_ball()];
        assert!(ball.state.speed() > 0.0 && ball.id == "cue", "{kind}");
    }
}

#[test]
fn pockets_without_a_list_are_the_six_of_a_pool_table() {
    let pool = catalogue::scene("pool-break").unwrap();
    let listed = pool.effects.pockets.unwrap().circles;
    let fields = json!({ "effects.pockets.circles": "" });
    let text = catalogue::find("pool-break").unwrap().text;
    let answer = drawn_up(&json!({ "scene": text, "fields": fields }));
    let scene = parse("x.toml", answer["toml"].as_str().unwrap()).unwrap();
    let six = scene.effects.pockets.unwrap().circles;
    assert_eq!(six.len(), listed.len());
    for (ours, theirs) in six.iter().flatten().zip(listed.iter().flatten()) {
        // half a unit of the last digit that the file gives
        assert!((ours - theirs).abs() <= 0.5e-6, "{ours} for {theirs}");
    }
}

#[test]
fn a_changed_scene_of_the_catalogue_does_not_keep_what_was_said_of_it() {
    let answer = drawn_up(&json!({ "fields": { "friction": "0.3" } }));
    let scene = parse("x.toml", answer["toml"].as_str().unwrap()).unwrap();
    assert_eq!(scene.name, "report-break-changed");
    assert_eq!((scene.richer, scene.description.as_str()), (None, ""));
    assert!(scene.sets.is_empty());
    // a name of one's own stays, and so does what is said of it
    let own = drawn_up(
        &json!({ "fields": { "name": "mine", "description": "my break", "friction": 0.3 } }),
    );
    let scene = parse("x.toml", own["toml"].as_str().unwrap()).unwrap();
    assert_eq!(
        (scene.name.as_str(), scene.description.as_str()),
        ("mine", "my break")
    );
}

#[test]
fn an_error_stands_at_the_field_that_caused_it() {
    for (fields, wanted) in [
        (
            json!({ "friction": "-1" }),
            "friction: mu must be a finite number, 0 or greater",
        ),
        (
            json!({ "friction": "abc" }),
            "friction: mu must be a finite number, 0 or greater, not text",
        ),
        (
            json!({ "friction": "NaN" }),
            "friction: mu must be a finite number, 0 or greater",
        ),
        (json!({ "friction": "" }), "friction: mu must be given"),
        (
            json!({ "friction": -1, "effects.cloth": "rotational" }),
            "friction: mu_slide must be",
        ),
        (
            json!({ "mass": 0 }),
            "mass: mass must be a finite number greater than 0",
        ),
        (
            json!({ "mass": "" }),
            "mass: the balls of the rack have no mass",
        ),
        (json!({ "mass": "1e40" }), "mass: mass must be 0 or between"),
        (json!({ "force": "-3" }), "force: force must be"),
        (json!({ "force": "" }), "force: force must be given"),
        (
            json!({ "gravity": "" }),
            "gravity: `[effects.cloth.translational]` needs `gravity`",
        ),
        (json!({ "gravity": "inf" }), "gravity: gravity must be"),
        (
            json!({ "angle": "361" }),
            "angle: angle_deg must be a finite number from -360 to 360",
        ),
        (json!({ "duration": "0" }), "duration: duration must be"),
        (
            json!({ "duration": "5000" }),
            "duration: 5000 s are too long for this page",
        ),
        (json!({ "rack.rows": "6" }), "rack.rows: rows must be"),
        (json!({ "rack.rows": "2.5" }), "rack.rows: rows must be"),
        (
            json!({ "rack.apex": "1, 2, 3" }),
            "rack.apex: apex must be a list of 2 numbers",
        ),
        (
            json!({ "effects.cushion": "rubber" }),
            "effects.cushion: unknown word \"rubber\"",
        ),
        (
            json!({ "effects.cushion": "han-2005" }),
            "effects.cushion: `[effects.cushion.han-2005]` turns balls",
        ),
        (
            json!({ "simultaneous": "maybe" }),
            "simultaneous: unknown word \"maybe\"",
        ),
        (json!({ "shot": "strike" }), "shot: a strike turns the ball"),
        (
            json!({ "shot.force.ball": "9 ball" }),
            "shot.force.ball: the scene has no ball",
        ),
        (
            json!({ "name": "My Shot" }),
            "name: name must be kebab-case",
        ),
        (json!({ "forse": 1 }), "forse: there is no field `forse`"),
        (
            json!({ "shot.velocity.speed": 1 }),
            "shot.velocity.speed: the shot of this scene is `force`",
        ),
        (json!({ "dt.stepper": "0" }), "dt.stepper: `dt=0`"),
        (json!({ "dt.rapier-f64": "x" }), "dt.rapier-f64: `dt=x`"),
        (
            json!({ "more-engines": "jolt" }),
            "more-engines: no engine is called `jolt`",
        ),
        (
            json!({ "more-engines": "stepper" }),
            "more-engines: `stepper` is listed twice",
        ),
    ] {
        let body = json!({ "fields": fields });
        let found = errors(&drawn_up(&body));
        assert!(
            found.iter().any(|found| found.starts_with(wanted)),
            "{fields}: {found:?}"
        );
        let field = wanted.split(':').next().unwrap();
        let elsewhere = found.iter().find(|found| !found.starts_with(field));
        assert_eq!(elsewhere, None, "{fields}");
        let (status, answer) = shot(&body, &Never);
        assert_eq!((status, errors(&answer)), (400, found), "{fields}");
    }
    // several at once, each at its own
    let body = json!({ "fields": { "friction": "-1", "mass": "x", "force": "" } });
    let found = errors(&drawn_up(&body));
    let fields: Vec<&str> = found
        .iter()
        .map(|found| found.split(':').next().unwrap())
        .collect();
    assert_eq!(fields, ["force", "mass", "friction"]);
}

#[test]
fn an_error_of_a_scene_as_a_file_has_its_line_and_column() {
    let broken = "name = \"x\"\nduration = 1.0\n[table\nwidth = 1\n";
    let with = |line: &str| site().start.replace("mu = 0.2", line);
    for (scene, line, column) in [
        (broken.to_owned(), 3, 7),
        (with("mu = 0.2 0.3"), 35, 6),
        (with("mu = -0.2"), 35, 6),
        (with("mu = 0.2\nmy = 1.0"), 36, 1),
        ("".to_owned(), 1, 1),
    ] {
        let answer = drawn_up(&json!({ "scene": scene }));
        let first = &answer["errors"][0];
        assert_eq!(
            (first["line"].as_u64(), first["column"].as_u64()),
            (Some(line), Some(column)),
            "{scene}: {answer}"
        );
        assert!(!first["message"].as_str().unwrap().is_empty());
    }
}

#[test]
fn a_field_of_a_law_that_is_not_chosen_counts_only_where_a_whole_form_is_sent() {
    let fields = json!({ "shot": "velocity", "force": 50, "shot.velocity.speed": 3 });
    let answer = drawn_up(&json!({ "fields": fields }));
    let scene = parse("x.toml", answer["toml"].as_str().unwrap()).unwrap();
    assert_eq!(scene.balls[0].state.speed(), 3.0);
    let slide = catalogue::find("slide").unwrap().text;
    let answer = drawn_up(&json!({ "scene": slide, "fields": { "force": 50 } }));
    assert_eq!(
        errors(&answer),
        ["force: the shot of this scene is `velocity`, which has no force"]
    );
}

#[test]
fn a_scene_is_bounded_in_balls() {
    let ball = |i: usize| format!("[[balls]]\nid = \"b{i}\"\nposition = [{i}.0, 0.0]\n");
    for (balls, taken) in [(MOST_BALLS, true), (MOST_BALLS + 1, false)] {
        let all: String = (0..balls).map(ball).collect();
        let scene =
            format!("name = \"many\"\nduration = 1.0\n[ball]\nradius = 0.1\nmass = 1.0\n{all}");
        let answer = drawn_up(&json!({ "scene": scene }));
        assert_eq!(
            answer["toml"] == Value::String(scene),
            taken,
            "{balls} balls: {:?}",
            errors(&answer)
        );
    }
}

#[test]
fn a_link_carries_the_whole_scene() {
    let mut carried = 0;
    for entry in catalogue::all() {
        let answer = drawn_up(&json!({ "scene": entry.text }));
        let Some(link) = answer["link"].as_str() else {
            continue;
        };
        let pairs = sent(text(&get(link)));
        let scene = pairs.iter().find(|(name, _)| name == "scene");
        assert_eq!(
            scene.map(|(_, text)| text.as_str()),
            Some(entry.text),
            "{}",
            entry.name
        );
        carried += 1;
    }
    assert!(carried > catalogue::all().len() / 2, "{carried} links");
    // what cannot be pressed into a link has none
    let mut draws = Draws::new(8, 1);
    let noise: String = (0..20_000)
        .map(|_| char::from(b'a' + draws.between(0.0, 26.0) as u8))
        .collect();
    let long = site().start.replace("The report's shot", &noise);
    let answer = drawn_up(&json!({ "scene": long }));
    assert!(answer["toml"] == long && answer["link"].is_null());
}
