//! Everything wrong with a scene, at the fields of the form that hold it.

use super::form::Form;
use super::problem::Problem;
use crate::scene::{Diagnostics, Kind, SceneError, path_at, printable};

/// Everything wrong with a scene, each at the field of `form` that holds it.
pub fn of_scene(error: &SceneError, form: &Form) -> Vec<Problem> {
    match error {
        SceneError::Invalid(diagnostics) => of_diagnostics(diagnostics, form),
        other => vec![Problem::at("scene", other.to_string(), "")],
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
