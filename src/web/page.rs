//! The page: one HTML document with its style, script and filled-in form, complete before any script runs.

use super::asked::{Asked, Drawn};
use super::encoding::link;
use super::form::is_changed;
use super::problem::Problem;
use super::wire::Response;
use super::{Site, Turns, form, shot, start};
use crate::page::answer;
use crate::report::html;
use crate::report::svg::escape;
use crate::scene::catalogue;
use std::sync::LazyLock;

/// The script, built from `src/client`.
static SCRIPT: LazyLock<String> =
    LazyLock::new(|| html::embeddable(include_str!("../client/dist/live.js")));

/// The sheet, built from `src/client`.
const SHEET: &str = include_str!("../client/dist/live.css");

/// The sheet of the page: the report's, the page's own, and the rules that show the keys of chosen laws.
static STYLE: LazyLock<String> =
    LazyLock::new(|| html::embeddable(&(html::style() + SHEET + &form::rules())));

/// What the page may do: its own style and script, and to ask this server.
static POLICY: LazyLock<String> = LazyLock::new(|| {
    format!(
        "default-src 'none'; script-src '{}'; style-src '{}'; img-src data:; connect-src 'self'; \
         form-action 'self'; base-uri 'none'; frame-ancestors 'none'",
        html::hash(&SCRIPT),
        html::hash(&STYLE)
    )
});

/// The page of a link.
pub fn opened(query: &str, site: &Site) -> Response {
    let (asked, problem) = Asked::of_link(query, site, None);
    let mut drawn = asked.drawn_up();
    drawn.problems.splice(0..0, problem);
    page(&asked, &drawn, "")
}

/// The page of a form that was sent without scripts, nothing run.
pub fn filled_in(asked: &Asked) -> Response {
    page(asked, &asked.drawn_up(), "")
}

/// The page of a form that was sent without scripts, with the comparison.
pub fn answered(asked: &Asked, turns: &dyn Turns) -> Response {
    let mut drawn = asked.drawn_up();
    match shot::run(asked, &drawn, turns) {
        Ok(shot) => {
            let notice = match shot.notice.as_str() {
                "" => String::new(),
                words => format!(
                    "<p class=\"notice-line\" role=\"status\">{}</p>\n",
                    escape(words)
                ),
            };
            let answer = html::fragment(&answer::page(&shot.answer));
            page(asked, &drawn, &(notice + &answer))
        }
        Err((status, problems)) => {
            drawn.problems = problems;
            Response {
                status,
                ..page(asked, &drawn, "")
            }
        }
    }
}

/// A page that says what is wrong with a request that no form can be filled in for.
pub fn refused(status: u16, problem: &Problem) -> Response {
    let words = escape(&problem.message);
    let help = match problem.help.as_str() {
        "" => String::new(),
        help => format!("<p>{}</p>\n", escape(help)),
    };
    let html = format!(
        "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<title>carom play: {status}</title>\n</head>\n\
         <body>\n<h1>{status}</h1>\n<p>{words}.</p>\n{help}<p><a href=\"/\">To the page</a></p>\n</body>\n</html>\n"
    );
    Response::bare_page(status, html)
}

fn page(asked: &Asked, drawn: &Drawn, answer: &str) -> Response {
    let status = if drawn.problems.is_empty() { 200 } else { 400 };
    let name = escape(drawn.name());
    let html = format!(
        "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <meta name=\"color-scheme\" content=\"light dark\">\n<title>{name} · carom play</title>\n\
         <link rel=\"icon\" href=\"data:,\">\n<style>{style}</style>\n</head>\n<body class=\"live\">\n\
         <a class=\"skip\" href=\"#shot\">To the shot</a>\n\
         <header class=\"top\"><h1>carom play <span id=\"name\">{name}</span></h1>{picker}</header>\n\
         <main>\n<form id=\"shot\" class=\"shot\" method=\"post\" action=\"/shot\" accept-charset=\"utf-8\" aria-label=\"Shot\">\n{form}</form>\n\
         <section class=\"stage\" aria-label=\"Replay and comparison\">\n\
         <div class=\"tools\" id=\"tools\">{link}</div>\n\
         <p class=\"status\" id=\"status\" role=\"status\"></p>\n\
         <p class=\"lead\" id=\"lead\" role=\"status\"></p>\n\
         <div class=\"replay\" id=\"replay\">{picture}</div>\n\
         <div id=\"answer\">{answer}</div>\n</section>\n</main>\n<script>{script}</script>\n</body>\n</html>\n",
        style = STYLE.as_str(),
        script = SCRIPT.as_str(),
        picker = picker(&name),
        form = shot::form_of(asked, drawn),
        link = link_to(drawn),
        picture = drawn.scene.as_ref().map(start::html).unwrap_or_default(),
    );
    Response::page(status, POLICY.clone(), html)
}

/// A list of the scenes that come with the program.
fn picker(name: &str) -> String {
    let option = |entry: &catalogue::CatalogueEntry| {
        let of_it = entry.name == name || is_changed(name, entry.name);
        let selected = if of_it { " selected" } else { "" };
        format!("<option{selected}>{}</option>", entry.name)
    };
    let options: String = catalogue::all().iter().map(option).collect();
    format!(
        "<form class=\"picker\" id=\"picker\" method=\"get\" action=\"/\"><label for=\"scene\">Scene</label>\
         <select id=\"scene\" name=\"scene\">{options}</select><button type=\"submit\">Open</button></form>"
    )
}

fn link_to(drawn: &Drawn) -> String {
    let link = drawn.scene.as_ref().and_then(|_| link(&drawn.text));
    match link {
        Some(link) => format!(
            "<a id=\"link\" href=\"{}\">Link to this shot</a>",
            escape(&link)
        ),
        None => String::new(),
    }
}
