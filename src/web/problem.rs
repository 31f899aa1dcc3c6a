//! What is wrong with a request, at the field that caused it.

use crate::scene::printable;
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
}

/// The body of an answer that says what is wrong.
pub fn body(problems: &[Problem]) -> String {
    json!({ "errors": problems }).to_string()
}
