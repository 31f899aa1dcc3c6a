//! What is wrong with a request, at the field that caused it.

use super::form::Form;
use crate::scene::{Diagnostics, Kind, SceneError, path_at, printable};
use serde::Serialize;
use serde_json::json;

/// One thing that is wrong.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Problem {
    /// Name of the field in the form; `None` if it is not of one field.
    pub field: Option<String>,
    /// Line of the scene, or of the JSON of the request, from 1; `None` if it has no place in a text.
    pub line: Option<usize>,
    /// Column, characters from 1.
    pub column: Option<usize>,
    /// What is wrong, in one sentence without a full stop.
    pub message: String,
    /// What would be right; may be empty.
    pub help: String,
}

impl Problem {
    /// Something wrong with the request as a whole.
    pub fn new(message: impl Into<String>) -> Self {
        Problem {
            message: message.into(),
            ..Problem::default()
        }
    }

    /// Something wrong with one field.
    pub fn at(field: &str, message: impl Into<String>, help: impl Into<String>) -> Self {
        Problem {
            field: Some(printable(field)),
            message: message.into(),
            help: help.into(),
            ..Problem::default()
        }
    }

    /// Everything wrong with a scene, each at the field of `form` that holds it.
    pub fn of_scene(error: &SceneError, form: &Form) -> Vec<Self> {
        match error {
            SceneError::Invalid(diagnostics) => of_diagnostics(diagnostics, form),
            other => vec![Problem::at("scene", other.to_string(), "")],
        }
    }
}

fn of_diagnostics(diagnostics: &Diagnostics, form: &Form) -> Vec<Problem> {
    let problems = diagnostics.problems.iter().map(|problem| {
        let (line, column) = diagnostics.position(problem.span.start);
        let located = || path_at(&diagnostics.text, problem.span.start);
        let path = match problem.kind {
            Kind::Syntax | Kind::Encoding => String::new(),
            _ => problem.wanted.clone().unwrap_or_else(located),
        };
        Problem {
            field: form.name_of(&path),
            line: Some(line),
            column: Some(column),
            message: printable(&problem.message),
            help: printable(&problem.help),
        }
    });
    problems.collect()
}

/// The body of an answer that says what is wrong.
pub fn body(problems: &[Problem]) -> String {
    json!({ "errors": problems }).to_string()
}
