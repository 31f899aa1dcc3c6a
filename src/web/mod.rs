//! The live page: a form with the scene in it, and an answer by all engines for each shot.
//!
//! [`handle`] makes an answer of a request and touches nothing else: no socket, no file, no clock, no thread. Those are the caller's,
//! which lends a [`Turns`] to whatever takes time. Paths and methods:
//!
//! | path | method | answer |
//! |---|---|---|
//! | `/` | GET | the page; `?scene=NAME`, `?toml=PACKED` and fields by name fill in its form |
//! | `/scenes/NAME` | GET | a scene of the catalogue: its text and its form |
//! | `/scene` | POST | a scene with fields put into it: its text, its form, a link; nothing runs |
//! | `/shot` | POST | the same, run by all engines that are asked for: comparison and replay |
//!
//! A body is JSON, `{"scene": TEXT, "fields": {NAME: VALUE}, "engines": LIST}` with every part optional, or a form. Answers are JSON;
//! to a browser that asks for HTML they are whole pages, so that everything works without scripts. Errors are
//! `{"errors": [{"field", "line", "column", "message", "help"}]}`, or a page with the same words. [`answer`] is [`handle`] with a defect
//! of this program as one more error.

mod asked;
mod encoding;
pub mod form;
mod guard;
mod misplaced;
mod page;
mod problem;
mod shot;
mod start;
mod wire;

pub use asked::{MOST_BALL_SECONDS, MOST_BALLS};
pub use encoding::{Pairs, link, unpacked};
pub use problem::{Problem, body as problems};
pub use shot::MOST_EVENTS;
pub use wire::{LARGEST_BODY, LARGEST_HEAD, Request, Response, Unread, read};

use crate::engine::Roster;
use crate::scene::catalogue;
use asked::Asked;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::atomic::AtomicBool;

/// What a server serves.
#[derive(Clone, Debug)]
pub struct Site {
    /// The port that it listens on: part of its name.
    pub port: u16,
    /// The scene that the page opens with, as written.
    pub start: String,
    /// The engines that it offers.
    pub roster: Roster,
}

/// Whose turn it is to run, and for how long.
pub trait Turns {
    /// Waits for a turn and calls `run`, once at most, with the flag that tells it to stop.
    fn take(&self, run: &mut dyn FnMut(&AtomicBool)) -> Turn;
}

/// How a turn went.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Turn {
    /// It ran to its end.
    Done,
    /// It was told to stop after so many seconds.
    TooLong(f64),
    /// A newer request took its place.
    Overtaken,
}

/// Paths and their methods; `*` stands for a name.
const PATHS: [(&str, &str); 4] = [
    ("/", "GET, HEAD"),
    ("/scenes/*", "GET, HEAD"),
    ("/scene", "POST"),
    ("/shot", "POST"),
];

/// The answer to a request, whatever happens: where this program has a defect, the answer says so.
pub fn answer(request: &Request, site: &Site, turns: &dyn Turns) -> Response {
    let handled = catch_unwind(AssertUnwindSafe(|| handle(request, site, turns)));
    handled.unwrap_or_else(|_| {
        let why =
            "this request met a defect of carom; what went wrong is on the terminal that it runs in";
        refused(request, 500, Problem::new(why))
    })
}

/// An answer that says what is wrong in the form in which whoever asks shows it: JSON to a script or program, a page to a browser.
fn refused(request: &Request, status: u16, problem: Problem) -> Response {
    if request.lists("Accept", "text/html") {
        page::refused(status, &problem)
    } else {
        Response::json(status, problems(&[problem]))
    }
}

/// The answer to a request.
pub fn handle(request: &Request, site: &Site, turns: &dyn Turns) -> Response {
    let wrong = |status, why: String| refused(request, status, Problem::new(why));
    if let Err(why) = guard::check(request, site.port) {
        return wrong(403, why);
    }
    let scene = request.path.strip_prefix("/scenes/");
    let path = scene.map_or(request.path.as_str(), |_| "/scenes/*");
    let Some((path, methods)) = PATHS.iter().find(|(known, _)| *known == path) else {
        return wrong(404, "there is no such page; the page is at /".to_owned());
    };
    if !methods.split(", ").any(|method| method == request.method) {
        return wrong(405, format!("this takes {methods}")).with("Allow", methods);
    }
    match (*path, scene) {
        ("/", _) => page::opened(&request.query, site),
        (_, Some(name)) => match catalogue::find(name) {
            Some(entry) => shot::drawn_up(&Asked::of_link("", site, Some(entry.text)).0),
            None => wrong(404, catalogue::unknown(name).to_string()),
        },
        (path, None) => posted(request, path, site, turns),
    }
}

/// The answer to a body.
fn posted(request: &Request, path: &str, site: &Site, turns: &dyn Turns) -> Response {
    let known = ["application/json", "application/x-www-form-urlencoded"];
    if !known.iter().any(|kind| request.is_of(kind)) {
        let why = format!(
            "the Content-Type of the body must be {}",
            known.join(" or ")
        );
        return refused(request, 415, Problem::new(why));
    }
    let asked = match Asked::of_body(request, site) {
        Ok(asked) => asked,
        Err(problem) => return refused(request, 400, problem),
    };
    match (path, request.lists("Accept", "text/html")) {
        ("/shot", false) => shot::answer(&asked, turns),
        ("/shot", true) => page::answered(&asked, turns),
        (_, true) => page::filled_in(&asked),
        (_, false) => shot::drawn_up(&asked),
    }
}
