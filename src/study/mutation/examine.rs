//! What must hold of everything that is read, whatever it is: no panic, an error that says where and what, and what is accepted is
//! written as text that reads back as the same.

use crate::engine::{self, Refusal, Roster};
use crate::law::Fault;
use crate::scene::generate::{Recipe, generate};
use crate::scene::{Diagnostics, Scene, SceneError, parse_bytes, rewritten};
use crate::study::Configuration;
use crate::trace::files::{self, Files};

/// Whether an input was accepted, or what is wrong with how it was read.
pub type Examined = Result<bool, Fault>;

fn fault(what: &'static str, words: impl Into<String>) -> Fault {
    Fault::new(what, words.into())
}

/// A scene file.
pub fn scene_file(bytes: &[u8]) -> Examined {
    match parse_bytes("input.toml", bytes) {
        Ok(scene) => {
            finite(&scene)?;
            reads_back(bytes, &scene)?;
            Ok(true)
        }
        Err(SceneError::Invalid(found)) => {
            has_place_and_words(&found)?;
            Ok(false)
        }
        Err(other) => Err(fault("other-error", other.to_string())),
    }
}

/// Everything that engines calculate with, and its square, is finite.
fn finite(scene: &Scene) -> Result<(), Fault> {
    let mut numbers = vec![
        scene.duration,
        scene.gravity,
        scene.touching(),
        scene.initial_energy(),
        scene.largest_speed() * scene.duration,
    ];
    for ball in &scene.balls {
        let state = &ball.state;
        let sizes = [ball.radius, ball.mass];
        numbers.extend(sizes.iter().chain(sizes.map(f64::recip).iter()));
        let vectors = state.position.iter().chain(&state.velocity);
        numbers.extend(vectors.chain(&state.spin));
    }
    if let Some(table) = scene.table {
        numbers.extend(table.min.iter().chain(&table.max));
    }
    scene.effects.map(|_, number| numbers.push(number));
    match numbers.iter().find(|x| !(**x * **x).is_finite()) {
        Some(x) => Err(fault("not-finite", format!("{x:e} in an accepted scene"))),
        None if scene.balls.is_empty() => Err(fault("no-ball", "an accepted scene has none")),
        None => Ok(()),
    }
}

/// The scene is written as a text that is the same scene.
fn reads_back(bytes: &[u8], scene: &Scene) -> Result<(), Fault> {
    let text = String::from_utf8_lossy(bytes);
    let again = rewritten(&text).ok_or_else(|| fault("cannot-be-written", ""))?;
    match parse_bytes("again.toml", again.as_bytes()) {
        Ok(read) if read == *scene && read.hash() == scene.hash() => Ok(()),
        Ok(_) => Err(fault("reads-back-otherwise", again)),
        Err(error) => Err(fault("does-not-read-back", error.to_string())),
    }
}

fn has_place_and_words(found: &Diagnostics) -> Result<(), Fault> {
    if found.problems.is_empty() {
        return Err(fault("no-cause", "an error without a cause"));
    }
    for problem in &found.problems {
        let (line, column) = found.position(problem.span.start);
        let lines = found.text.matches('\n').count() + 1;
        let inside = problem.span.start <= found.text.len() && line >= 1 && line <= lines;
        if !inside || column < 1 {
            return Err(fault("no-place", format!("{problem:?}")));
        }
        if problem.message.is_empty() || problem.help.is_empty() {
            return Err(fault("no-words", format!("{problem:?}")));
        }
    }
    for shown in [found.render(false), found.render(true)] {
        let commands = |c: char| c.is_control() && !matches!(c, '\n' | '\u{1b}');
        if shown.is_empty() || shown.contains(commands) {
            return Err(fault("not-printable", shown));
        }
    }
    Ok(())
}

/// The four files of a trace.
pub fn trace_files(texts: &Files) -> Examined {
    match files::read(texts) {
        Ok(trace) => {
            let written = files::write(&trace)
                .map_err(|error| fault("cannot-be-written", error.to_string()))?;
            let again = files::read(&written)
                .map_err(|error| fault("does-not-read-back", error.to_string()))?;
            // numbers are written by their shortest digits: equal texts are equal traces
            match files::write(&again) {
                Ok(twice) if twice == written => Ok(true),
                _ => Err(fault("reads-back-otherwise", "")),
            }
        }
        Err(error) => {
            let words = error.to_string();
            let names = [files::EVENTS, files::SAMPLES, files::FINAL, files::RUN];
            // file, place, and what is wrong
            let placed = names.iter().any(|name| {
                let rest = words
                    .strip_prefix(name)
                    .and_then(|rest| rest.strip_prefix(':'));
                rest.is_some_and(|rest| rest.trim().len() > 3)
            });
            if placed {
                Ok(false)
            } else {
                Err(fault("no-place", words))
            }
        }
    }
}

/// A list of engines with settings, as after `--engines`.
pub fn engine_list(roster: &Roster, list: &str, scene: &Scene) -> Examined {
    let columns = match Configuration::list(roster, list) {
        Ok(columns) => columns,
        Err(error) if error.to_string().trim().is_empty() => return Err(fault("no-words", list)),
        Err(_) => return Ok(false),
    };
    let labels: Vec<String> = columns.iter().map(Configuration::label).collect();
    let again = labels.join(",").replace(' ', ":");
    match Configuration::list(roster, &again) {
        Ok(read) if read.iter().map(Configuration::label).eq(labels) => {}
        // a value may hold what separates settings in a label
        _ if list.contains(char::is_whitespace) => {}
        _ => return Err(fault("reads-back-otherwise", again)),
    }
    let mut accepted = true;
    for column in &columns {
        match engine::prepare(column.engine.as_ref(), scene, &column.setting) {
            Ok(_) => {}
            Err(Refusal::Audit { differs }) => return Err(fault("audit", differs.join("; "))),
            Err(refusal) if refusal.to_string().is_empty() => {
                return Err(fault("no-words", list));
            }
            Err(_) => accepted = false,
        }
    }
    Ok(accepted)
}

/// The arguments of `carom scene generate`.
pub fn recipe(recipe: &Recipe) -> Examined {
    match generate(recipe) {
        Ok(text) => match parse_bytes("generated.toml", text.as_bytes()) {
            Ok(scene) if scene.balls.len() == recipe.balls => Ok(true),
            Ok(scene) => Err(fault("other-balls", scene.balls.len().to_string())),
            Err(error) => Err(fault("no-scene", format!("{recipe:?}: {error}"))),
        },
        Err(error) if error.to_string().is_empty() => Err(fault("no-words", "")),
        Err(_) => Ok(false),
    }
}
