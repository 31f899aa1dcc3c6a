//! Scenes: the file as a person writes it, and the resolved [`Scene`] that engines see.
//!
//! The two are different types. In a [`Scene`] every ball is explicit, every default applied and the shot has been
//! played, so that an engine has nothing left to interpret. [`parse`] is the way from one to the other, and [`catalogue`]
//! holds the scenes that come with the program. No path is touched here.

pub mod adversarial;
mod builder;
pub mod catalogue;
mod check;
mod choices;
mod diagnostics;
mod file;
pub mod format;
pub mod generate;
mod geometry;
mod kebab_case;
mod laws;
mod located;
mod names;
pub mod perturb;
mod pieces;
mod placed;
mod printable;
mod problems;
mod rack;
mod resolve;
mod resolved;
mod shot;
mod spelled;
mod tried;

pub use builder::SceneBuilder;
pub use choices::{SetName, Simultaneous, TimeUnit};
pub use diagnostics::{Diagnostic, Diagnostics, Kind, SceneError, nearest, nearest_names};
pub use file::{SceneFile, schema};
pub use kebab_case::is_kebab_case;
pub use printable::{is_hidden, printable};
pub use resolved::{Ball, Scene, Shot, Table, Units, plan_vector};
pub use spelled::{Spelled, spelled};
pub use tried::{Tried, TriedError};

use located::Located;
use pieces::{Pieces, Shift};
use problems::Problems;
use std::sync::LazyLock;
use toml::de::{DeTable, Error};

/// The schema that files are held against: a constant that takes longer to make than a scene to read.
static SCHEMA: LazyLock<serde_json::Value> = LazyLock::new(schema);

/// Reads a scene from the text of a file. `file_name` is for messages only.
///
/// Every error of the file is reported at once, as far as one does not hide another: first syntax, then keys, types and
/// ranges, then what does not fit together.
pub fn parse(file_name: &str, text: &str) -> Result<Scene, SceneError> {
    // editors on some systems begin a file with a byte order mark, which is no part of its first line
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let invalid = |problems: Problems| SceneError::Invalid(problems.of_file(file_name, text));
    let pieces = Pieces::of(text);
    let (file, located) = read(text, pieces.as_ref()).map_err(invalid)?;
    resolve::resolve(file, &located).map_err(invalid)
}

/// What is written in a file that has no fault by itself, with the place of everything in it.
fn read<'t>(
    text: &'t str,
    pieces: Option<&'t Pieces<'_>>,
) -> Result<(SceneFile, Located<'t>), Problems> {
    if let Some(read) = pieces.and_then(|pieces| in_pieces(text, pieces)) {
        return read;
    }
    let (root, errors) = DeTable::parse_recoverable(text);
    if !errors.is_empty() {
        return Err(syntax_errors(text, &errors));
    }
    let located = Located::whole(text, root.into_inner());
    let problems = check::check(&located, &SCHEMA);
    if !problems.is_empty() {
        return Err(problems);
    }
    // the walk above has seen every key and type; this cannot fail unless the schema and the types disagree
    match toml::from_str(text) {
        Ok(file) => Ok((file, located)),
        Err(error) => {
            let mut problems = Problems::new();
            problems.push(syntax(&error));
            Err(problems)
        }
    }
}

/// The same of a large file; `None` where it must be read as a whole.
fn in_pieces<'t>(
    text: &'t str,
    pieces: &'t Pieces<'_>,
) -> Option<Result<(SceneFile, Located<'t>), Problems>> {
    let (root, errors) = DeTable::parse_recoverable(&pieces.around);
    if !errors.is_empty() || root.get_ref().contains_key("balls") {
        return None;
    }
    let mut problems = Problems::new();
    check::check_table(root.get_ref(), &SCHEMA, pieces.shift(), &mut problems);
    let (mut balls, mut chunks) = (Vec::new(), Vec::new());
    for piece in pieces.each() {
        let piece = piece?;
        let list = ("balls", piece.chunk.first);
        let shift = Shift::to(piece.chunk.text.start);
        check::check_items(list, piece.balls(), &SCHEMA, shift, &mut problems);
        chunks.push(piece.chunk.clone());
        if problems.is_empty() {
            balls.extend(piece.read().ok()?);
        }
    }
    if !problems.is_empty() {
        return Some(Err(problems));
    }
    let mut file: SceneFile = toml::from_str(&pieces.around).ok()?;
    file.balls = balls;
    // the table borrows from the text around the balls
    let located = Located::in_pieces(text, root.into_inner(), pieces.shift(), chunks);
    Some(Ok((file, located)))
}

/// The path of the deepest key at byte `place` of a scene file, such as `effects.cloth.translational.mu`; empty if there is none.
pub fn path_at(text: &str, place: usize) -> String {
    let (root, _) = DeTable::parse_recoverable(text);
    Located::whole(text, root.into_inner()).path_at(place)
}

/// The text of a scene file as carom would write it: comments and layout are lost, the scene is the same.
///
/// `None` if `text` is not a scene file.
pub fn rewritten(text: &str) -> Option<String> {
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let file: SceneFile = toml::from_str(text).ok()?;
    file.text().ok()
}

/// Reads a scene from the bytes of a file, which must be UTF-8.
pub fn parse_bytes(file_name: &str, bytes: &[u8]) -> Result<Scene, SceneError> {
    match std::str::from_utf8(bytes) {
        Ok(text) => parse(file_name, text),
        Err(error) => {
            let at = error.valid_up_to();
            let text = String::from_utf8_lossy(bytes);
            let byte = bytes.get(at).copied().unwrap_or_default();
            let problem = Diagnostic::new(
                Kind::Encoding,
                at..at + char::REPLACEMENT_CHARACTER.len_utf8(),
                format!("the file is not UTF-8 text: byte {byte:#04x}"),
                "save it as UTF-8",
            );
            let mut problems = Problems::new();
            problems.push(problem);
            let diagnostics = problems.of_file(file_name, &text);
            Err(SceneError::Invalid(diagnostics))
        }
    }
}

/// One error a line: the parser goes on after an error, and what it meets in the rest of that line is mostly its own confusion.
fn syntax_errors(text: &str, errors: &[Error]) -> Problems {
    let start = |error: &Error| error.span().unwrap_or_default().start;
    let mut errors: Vec<&Error> = errors.iter().collect();
    errors.sort_by_key(|error| start(error));
    let ends: Vec<usize> = text.match_indices('\n').map(|(at, _)| at).collect();
    errors.dedup_by_key(|error| ends.partition_point(|end| *end < start(error)));
    let mut problems = Problems::new();
    for error in errors {
        problems.push_at(error.span().unwrap_or_default(), |_| syntax(error));
    }
    problems
}

fn syntax(error: &Error) -> Diagnostic {
    let span = error.span().unwrap_or_default();
    let message = error.message().replace('\n', ", ");
    if message == "duplicate key" {
        let message = "this key is in its table already";
        let help = "a key may stand once in a table: remove one of the two";
        return Diagnostic::new(Kind::Duplicate, span, message, help);
    }
    // the parser guesses what a bare word was meant to be, and mostly guesses wrong
    let bare_word = [
        "string values must be quoted",
        "invalid boolean",
        "invalid float",
    ];
    if bare_word.iter().any(|start| message.starts_with(start)) {
        let message = "a value is expected here";
        let help = "text stands in quotes, numbers as 1.5 or 2e-3, truth as true or false, lists as [1, 2]";
        return Diagnostic::new(Kind::Syntax, span, message, help);
    }
    let help = "a scene is a TOML file: `[table]` headers and lines of `key = value`";
    Diagnostic::new(Kind::Syntax, span, message, help)
}
