//! The live page: what it answers to a request, and the program that serves it.

mod answers;
mod browser;
mod crowd;
mod fields;
mod hostile;
mod pages;
mod server;

use browser::{Tag, sent};
use carom::scene::catalogue;
use carom::web::{Request, Response, Site, Turn, Turns, handle};
use serde_json::{Value, json};
use std::sync::atomic::AtomicBool;

const PORT: u16 = 4147;

/// Runs at once and to the end.
struct Now;

impl Turns for Now {
    fn take(&self, run: &mut dyn FnMut(&AtomicBool)) -> Turn {
        run(&AtomicBool::new(false));
        Turn::Done
    }
}

/// Runs nothing.
struct Never;

impl Turns for Never {
    fn take(&self, _run: &mut dyn FnMut(&AtomicBool)) -> Turn {
        Turn::Overtaken
    }
}

fn site() -> Site {
    Site {
        roster: crate::support::roster().clone(),
        port: PORT,
        start: catalogue::find("report-break").unwrap().text.to_owned(),
    }
}

fn request(method: &str, target: &str) -> Request {
    let (path, query) = target.split_once('?').unwrap_or((target, ""));
    Request {
        method: method.to_owned(),
        path: path.to_owned(),
        query: query.to_owned(),
        headers: vec![("Host".to_owned(), format!("127.0.0.1:{PORT}"))],
        body: Vec::new(),
    }
}

/// A body of this kind, posted.
fn post(target: &str, kind: &str, body: &str) -> Request {
    let mut request = request("POST", target);
    let header = ("Content-Type".to_owned(), kind.to_owned());
    request.headers.push(header);
    request.body = body.as_bytes().to_vec();
    request
}

fn get(target: &str) -> Response {
    handle(&request("GET", target), &site(), &Never)
}

/// What a body of JSON is answered with, nothing run.
fn drawn_up(body: &Value) -> Value {
    let request = post("/scene", "application/json", &body.to_string());
    let response = handle(&request, &site(), &Never);
    assert_eq!(response.status, 200);
    parsed(&response)
}

/// Status and answer of a shot.
fn shot(body: &Value, turns: &dyn Turns) -> (u16, Value) {
    let request = post("/shot", "application/json", &body.to_string());
    let response = handle(&request, &site(), turns);
    (response.status, parsed(&response))
}

fn parsed(response: &Response) -> Value {
    assert_eq!(response.kind, "application/json");
    serde_json::from_slice(&response.body).unwrap()
}

fn text(response: &Response) -> &str {
    std::str::from_utf8(&response.body).unwrap()
}

/// The errors of an answer as `field: message`.
fn errors(answer: &Value) -> Vec<String> {
    let errors = answer["errors"].as_array().into_iter().flatten();
    let words = errors.map(|error| {
        let field = error["field"].as_str().unwrap_or("-");
        format!("{field}: {}", error["message"].as_str().unwrap())
    });
    words.collect()
}

/// The fields of a form as JSON, the scene apart.
fn as_json(pairs: &[(String, String)]) -> Value {
    let mut fields = serde_json::Map::new();
    for (name, value) in pairs {
        if name == "scene" || name == "engine" {
            continue;
        }
        fields.insert(name.clone(), json!(value));
    }
    Value::Object(fields)
}
