//! What a shot is answered with: the numbers of `carom compare`, and a replay.

use super::{Never, Now, errors, get, handle, parsed, post, request, shot, site};
use assert_cmd::Command;
use carom::scene::catalogue;
use carom::web::{Turn, Turns};
use serde_json::{Value, json};
use std::fs;
use std::sync::atomic::AtomicBool;

/// The document without the times of this machine.
fn timeless(mut document: Value) -> Value {
    let rows = document["tables"]["comparison"]["rows"].as_array_mut();
    for row in rows.unwrap() {
        row["time-per-shot"] = Value::Null;
    }
    document
}

/// What `carom compare --format json` prints of a scene file.
fn compared(toml: &str, engines: &[&str]) -> Value {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("saved.toml");
    fs::write(&file, toml).unwrap();
    let mut command = Command::cargo_bin("carom").unwrap();
    command.args(["compare", "--format", "json"]).arg(&file);
    let output = command.args(engines).output().unwrap();
    assert_eq!(output.status.code(), Some(0));
    serde_json::from_slice(&output.stdout).unwrap()
}

#[test]
fn the_numbers_are_those_of_carom_compare_with_the_saved_scene() {
    let all = json!({});
    let five =
        json!({ "mass": 0.12, "force": 120, "gravity": 9.7, "friction": 0.25, "angle": 89.5 });
    let real = json!({ "effects.cloth": "rotational", "effects.cushion": "restitution", "effects.pockets": "given" });
    let frozen = catalogue::find("triple-hit-ensemble").unwrap().text;
    for (body, engines) in [
        (json!({ "fields": all }), vec![]),
        (json!({ "fields": five }), vec![]),
        (
            json!({ "fields": real, "engines": "stepper,rapier-f32:dt=2e-3" }),
            vec!["--engines", "stepper,rapier-f32:dt=2e-3"],
        ),
        (json!({ "scene": frozen }), vec![]),
    ] {
        let (status, answer) = shot(&body, &Now);
        assert_eq!(status, 200, "{:?}", errors(&answer));
        let printed = compared(answer["toml"].as_str().unwrap(), &engines);
        assert_eq!(
            timeless(answer["document"].clone()),
            timeless(printed),
            "{body}"
        );
        assert_eq!(answer["notice"], "");
        // and the answer says by which command
        let name = answer["name"].as_str().unwrap();
        let listed = engines
            .last()
            .map_or(String::new(), |list| format!(" --engines exact,{list}"));
        assert_eq!(
            answer["command"],
            format!("carom compare {name}.toml{listed}")
        );
    }
}

#[test]
fn the_answer_holds_a_replay_of_every_engine_and_the_comparison_as_a_part_of_a_page() {
    let (_, answer) = shot(&json!({ "engines": "stepper,rapier-f64" }), &Now);
    let labels: Vec<&str> = answer["replay"]["runs"]
        .as_array()
        .unwrap()
        .iter()
        .map(|run| run["label"].as_str().unwrap())
        .collect();
    assert_eq!(labels, ["exact", "stepper", "rapier-f64"]);
    let html = answer["html"].as_str().unwrap();
    for row in answer["document"]["tables"]["comparison"]["rows"]
        .as_array()
        .unwrap()
    {
        assert!(html.contains(row["engine"].as_str().unwrap()), "{row}");
    }
    assert!(
        !html.contains("<script"),
        "a part of a page brings a script"
    );
    assert_eq!(answer["no_replay"], "");
}

/// Stops whatever runs, as a clock would.
struct Stopped;

impl Turns for Stopped {
    fn take(&self, run: &mut dyn FnMut(&AtomicBool)) -> Turn {
        run(&AtomicBool::new(true));
        Turn::TooLong(10.0)
    }
}

#[test]
fn a_shot_that_is_stopped_is_answered_as_far_as_it_came_and_says_so() {
    let (status, answer) = shot(&json!({}), &Stopped);
    assert_eq!(status, 200);
    assert!(
        answer["notice"]
            .as_str()
            .unwrap()
            .contains("stopped after 10 s"),
        "{}",
        answer["notice"]
    );
    let document = &answer["document"];
    let stopped = document["stopped_early"].as_str().unwrap();
    assert!(stopped.contains("stopped early"), "{stopped}");
    let lead = document["lead"].as_str().unwrap();
    assert_eq!(
        lead,
        "Nothing to hold the engines against: exact was stopped before its end."
    );
    let html = answer["html"].as_str().unwrap();
    assert!(html.starts_with("<p role=\"note\">"), "{html}");
    assert_eq!(answer["replay"], Value::Null);
    let (status, answer) = shot(&json!({}), &Never);
    assert_eq!(status, 409);
    assert_eq!(
        errors(&answer),
        ["-: a newer shot took the place of this one"]
    );
}

#[test]
fn a_body_that_is_not_json_is_answered_with_the_place() {
    for (body, line, column) in [
        ("", 1, 0),
        ("{", 1, 1),
        ("{\n  \"scene\": 3\n}", 2, 12),
        ("{\"fields\": {\"mass\": }}", 1, 21),
        ("{\"fields\": {},\n \"scenes\": \"\"}", 2, 9),
        ("{\"fields\": [1]}", 1, 11),
        ("nonsense", 1, 2),
        ("{} {}", 1, 4),
    ] {
        let response = handle(&post("/shot", "application/json", body), &site(), &Never);
        let answer = parsed(&response);
        let first = &answer["errors"][0];
        assert_eq!(response.status, 400, "{body}");
        assert_eq!(
            (first["line"].as_u64(), first["column"].as_u64()),
            (Some(line), Some(column)),
            "{body}: {first}"
        );
    }
}

#[test]
fn only_known_paths_and_methods_are_answered() {
    for path in [
        "/favicon.ico",
        "/scenes",
        "/scenes/",
        "/scenes/../etc",
        "/shot/",
        "//",
        "/index.html",
    ] {
        assert_eq!(get(path).status, 404, "{path}");
    }
    for (method, path, allowed) in [
        ("POST", "/", "GET, HEAD"),
        ("GET", "/shot", "POST"),
        ("OPTIONS", "/shot", "POST"),
        ("PUT", "/scene", "POST"),
        ("DELETE", "/scenes/slide", "GET, HEAD"),
    ] {
        let response = handle(&request(method, path), &site(), &Never);
        assert_eq!(response.status, 405, "{method} {path}");
        assert!(
            response.headers.contains(&("Allow", allowed.to_owned())),
            "{method} {path}"
        );
    }
    // what a page of another site may send without asking is none of them
    for kind in [
        "text/plain",
        "text/plain; x=application/json",
        "multipart/form-data",
        "",
    ] {
        let response = handle(&post("/shot", kind, "{}"), &site(), &Never);
        assert_eq!(response.status, 415, "{kind}");
    }
    let response = handle(
        &post("/scene", "Application/JSON; charset=utf-8", "{}"),
        &site(),
        &Never,
    );
    assert_eq!(response.status, 200);
}

#[test]
fn a_request_that_a_foreign_page_may_have_made_is_refused() {
    let own = format!("127.0.0.1:{}", super::PORT);
    let with = |method: &str, headers: &[(&str, &str)]| {
        let mut request = match method {
            "GET" => request("GET", "/"),
            _ => post("/scene", "application/json", "{}"),
        };
        request.headers.retain(|(name, _)| name != "Host");
        let headers = headers
            .iter()
            .map(|(name, value)| ((*name).to_owned(), (*value).to_owned()));
        request.headers.extend(headers);
        handle(&request, &site(), &Never).status
    };
    let localhost = format!("localhost:{}", super::PORT);
    let six = format!("[::1]:{}", super::PORT);
    for host in [&own, &localhost, &six] {
        assert_eq!(with("GET", &[("Host", host)]), 200, "{host}");
        assert_eq!(
            with(
                "POST",
                &[("host", host), ("Origin", &format!("http://{host}"))]
            ),
            200,
            "{host}"
        );
    }
    for host in [
        "evil.example",
        "127.0.0.1",
        "127.0.0.1:80",
        "localhost",
        "127.0.0.2:4147",
        "",
    ] {
        assert_eq!(with("GET", &[("Host", host)]), 403, "{host}");
    }
    assert_eq!(with("GET", &[]), 403);
    assert_eq!(with("GET", &[("Host", &own), ("Host", &own)]), 403);
    for origin in [
        "null",
        "http://evil.example",
        "http://127.0.0.1:1",
        "https://127.0.0.1:4147",
        &format!("http://{localhost}"),
        "",
    ] {
        assert_eq!(
            with("POST", &[("Host", &own), ("Origin", origin)]),
            403,
            "{origin}"
        );
    }
    for (site, status) in [
        ("cross-site", 403),
        ("same-site", 403),
        ("same-origin", 200),
        ("none", 200),
    ] {
        assert_eq!(
            with("POST", &[("Host", &own), ("Sec-Fetch-Site", site)]),
            status,
            "{site}"
        );
        // a link on another page may lead here: it runs nothing
        assert_eq!(
            with("GET", &[("Host", &own), ("Sec-Fetch-Site", site)]),
            200,
            "{site}"
        );
    }
    let response = get("/");
    let cors = response
        .headers
        .iter()
        .any(|(name, _)| name.starts_with("Access-Control"));
    assert!(!cors, "another page may read the answer");
}
