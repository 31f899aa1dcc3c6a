//! Rules for the names and words of a scene: kebab-case, unique, and readable by the programs that get them in files.

use super::diagnostics::{Diagnostic, Kind};
use super::file::SceneFile;
use super::kebab_case::{LONGEST, is_kebab_case, kebab_case};
use super::located::Located;
use super::placed::{Placed, repetitions};
use super::problems::Problems;
use crate::physics::Side;
use std::ops::Range;

/// Checks the scene's own name, its sets and `richer`.
pub(super) fn check(file: &SceneFile, at: &Located<'_>, problems: &mut Problems) {
    let named = [("name", Some(&file.name)), ("richer", file.richer.as_ref())];
    for (path, name) in named {
        if let Some(name) = name.filter(|name| !is_kebab_case(name)) {
            let message = format!(
                "{path} must be kebab-case: lower-case letters, digits and single hyphens, at most {LONGEST}"
            );
            let help = match kebab_case(name) {
                Some(better) => format!("such as `{path} = \"{better}\"`"),
                None => format!("such as `{path} = \"my-shot\"`"),
            };
            let span = at.value(path);
            problems.push(Diagnostic::new(Kind::BadName, span, message, help));
        }
    }
    if file.richer.as_ref() == Some(&file.name) {
        let message = "a scene cannot be a model of itself";
        let help = "name the scene with more effects, or remove `richer`";
        let span = at.value("richer");
        problems.push(Diagnostic::new(Kind::BadName, span, message, help));
    }
    for (first, again) in repetitions(file.sets.iter().map(|set| set.id())) {
        let message = format!("set \"{}\" is named twice", file.sets[again].id());
        let span = at.value(&format!("sets[{again}]"));
        let first = at.value(&format!("sets[{first}]"));
        let help = "remove one of them";
        problems
            .push(Diagnostic::new(Kind::Duplicate, span, message, help).and(first, "first here"));
    }
}

/// Checks that the ids of all balls are unique and usable.
pub(super) fn check_balls(placed: &[Placed], at: &Located<'_>, problems: &mut Problems) {
    let place = |placed: &Placed| match placed.path.strip_suffix(".position") {
        Some(ball) => at.value(&format!("{ball}.id")),
        None => at.value("rack"),
    };
    let mut told = 0;
    for ball in placed {
        if let Some((message, help)) = wrong_with_id(&ball.ball.id) {
            problems.push_along(&mut told, || {
                Diagnostic::new(Kind::BadName, place(ball), message, help)
            });
        }
    }
    let ids = placed.iter().map(|p| p.ball.id.as_str());
    let mut told = 0;
    for (first, again) in repetitions(ids) {
        problems.push_along(&mut told, || repeated(placed, [first, again], place));
    }
}

/// A ball with the id of one before it.
fn repeated(
    placed: &[Placed],
    [first, again]: [usize; 2],
    place: impl Fn(&Placed) -> Range<usize>,
) -> Diagnostic {
    let id = &placed[again].ball.id;
    let from_rack = placed[again].path == "rack";
    let (span, other) = (place(&placed[again]), place(&placed[first]));
    if from_rack {
        let count = placed.iter().filter(|p| p.path == "rack").count();
        let message = format!("two balls have the id \"{id}\": this one and one of the rack");
        let help = format!("the rack's balls are \"1\" to \"{count}\"; choose another id");
        Diagnostic::new(Kind::Duplicate, other, message, help).and(span, "the rack")
    } else {
        let message = format!("two balls have the id \"{id}\"");
        let help = "every ball of a scene needs an id of its own";
        Diagnostic::new(Kind::Duplicate, span, message, help).and(other, "first used here")
    }
}

fn wrong_with_id(id: &str) -> Option<(String, String)> {
    let sides = Side::ALL.map(Side::id);
    let pocket = id.strip_prefix('p').is_some_and(|number| {
        !number.is_empty() && number.bytes().all(|byte| byte.is_ascii_digit())
    });
    let help = "such as `id = \"cue\"` or `id = \"7\"`".to_owned();
    if id.is_empty() {
        return Some(("the id of a ball must not be empty".to_owned(), help));
    }
    if sides.contains(&id) || pocket {
        let what = if pocket { "a pocket" } else { "a cushion" };
        let message = format!("\"{id}\" is the name of {what} in event files, not of a ball");
        return Some((message, help));
    }
    let bad = |c: char| c.is_control() || c.is_whitespace() || matches!(c, ',' | '"' | ';');
    if id.contains(bad) || id.chars().count() > LONGEST {
        let message = format!(
            "the id of a ball must be free of spaces, commas, semicolons, quotes and control characters, and at most {LONGEST} long"
        );
        return Some((message, help));
    }
    None
}
