//! A shot: the scene that was asked for, run in every engine that was asked for.

use super::asked::{Asked, Drawn};
use super::encoding::link;
use super::form::{self, Filled};
use super::problem::{Problem, body};
use super::wire::Response;
use super::{Turn, Turns, start};
use crate::engine::Roster;
use crate::page::answer;
use crate::page::compare::{LengthUnit, replay};
use crate::report::{html, json, replay};
use crate::scene::Scene;
use crate::study::{Answer, Configuration, Timing, Watch};
use serde_json::json;

/// Most events of a run of the exact engine on this page.
pub const MOST_EVENTS: u64 = 20_000;

/// What a shot came to.
#[derive(Debug)]
pub struct Shot {
    /// The comparison.
    pub answer: Answer,
    /// What a person must know of it; empty for nothing.
    pub notice: String,
}

/// Runs a scene. Errors: status and what is wrong.
pub fn run(asked: &Asked, drawn: &Drawn, turns: &dyn Turns) -> Result<Shot, (u16, Vec<Problem>)> {
    let Some(scene) = &drawn.scene else {
        return Err((400, drawn.problems.clone()));
    };
    let columns = asked
        .columns(scene)
        .map_err(|problem| (400, vec![problem]))?;
    let mut found = None;
    let turn = turns.take(&mut |cancelled| {
        let watch = Watch {
            progress: &|_, _, _| {},
            cancelled,
        };
        found = Some(compared(scene, &columns, watch));
    });
    let notice = match turn {
        Turn::Done => String::new(),
        Turn::TooLong(seconds) => format!(
            "The computation was stopped after {seconds} s. What follows is of the engines that had come to their end by then: \
             of the others nothing is shown."
        ),
        Turn::Overtaken => {
            let problem = Problem::new("a newer shot took the place of this one");
            return Err((409, vec![problem]));
        }
    };
    match found {
        Some(Ok(answer)) => Ok(Shot { answer, notice }),
        Some(Err(problem)) => Err((400, vec![problem])),
        None => Err((409, vec![Problem::new("the shot was not run")])),
    }
}

/// Each engine by itself, so that the times beside the results are what `carom compare` prints.
fn compared(scene: &Scene, columns: &[Configuration], watch: Watch<'_>) -> Result<Answer, Problem> {
    Answer::to(scene, columns, Timing::Alone, MOST_EVENTS, watch)
        .map_err(|error| Problem::at("richer", error.to_string(), ""))
}

/// The answer to a program or a script: the scene as run, its form, the comparison, the replay.
pub fn answer(asked: &Asked, turns: &dyn Turns) -> Response {
    let drawn = asked.drawn_up();
    let shot = match run(asked, &drawn, turns) {
        Ok(shot) => shot,
        Err((status, problems)) => return Response::json(status, body(&problems)),
    };
    let summary = answer::summary(&shot.answer, LengthUnit::Radius);
    let (replay, why) = match replay(&shot.answer.outcome) {
        Ok(data) => (replay::data(&data), String::new()),
        Err(why) => ("null".to_owned(), why),
    };
    // the document is written once and by one writer: byte for byte that of the command line
    let body = format!(
        "{{\"name\":{},\"toml\":{},\"form\":{},\"link\":{},\"notice\":{},\"command\":{},\"html\":{},\"no_replay\":{},\"document\":{},\"replay\":{}}}",
        json!(drawn.name()),
        json!(drawn.text),
        json!(form_of(asked, &drawn)),
        json!(link(&drawn.text)),
        json!(shot.notice),
        json!(command(&asked.engines.roster, &drawn, &shot)),
        json!(html::fragment(&summary)),
        json!(why),
        json::write(&summary).trim_end(),
        replay
    );
    Response::json(200, body)
}

/// The command that prints the same numbers of the saved scene.
fn command(roster: &Roster, drawn: &Drawn, shot: &Shot) -> String {
    let columns = shot
        .answer
        .outcome
        .entries
        .iter()
        .map(|entry| &entry.column);
    format!(
        "carom compare {}.toml{}",
        drawn.name(),
        form::as_argument(roster, columns)
    )
}

/// The answer that runs nothing: the scene as a file, its form, a link to it; or what is wrong with it, which is an answer as well.
pub fn drawn_up(asked: &Asked) -> Response {
    let mut drawn = asked.drawn_up();
    let engines = drawn.scene.as_ref().map(|scene| asked.columns(scene));
    drawn.problems.extend(engines.and_then(Result::err));
    let Some(scene) = drawn.scene.as_ref().filter(|_| drawn.problems.is_empty()) else {
        return Response::json(200, body(&drawn.problems));
    };
    let answer = json!({
        "name": drawn.name(),
        "toml": drawn.text,
        "form": form_of(asked, &drawn),
        "link": link(&drawn.text),
        "picture": start::html(scene),
    });
    Response::json(200, answer.to_string())
}

/// The inside of the form.
pub fn form_of(asked: &Asked, drawn: &Drawn) -> String {
    form::html(Filled {
        scene: &drawn.table,
        text: &drawn.text,
        engines: &asked.engines,
        problems: &drawn.problems,
    })
}
