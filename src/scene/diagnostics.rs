//! What is wrong with a scene file, where, and what would be right.
//!
//! A [`Diagnostic`] marks bytes of the text; [`Diagnostics`] holds all of one file and renders them as a compiler does. This
//! room knows text and positions only, no scene.

use super::printable::{is_hidden, printable};
use annotate_snippets::{AnnotationKind, Group, Level, Renderer, Snippet};
use std::borrow::Cow;
use std::fmt;
use std::ops::Range;
use thiserror::Error;

/// The kinds of error that a scene file can have.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[non_exhaustive]
pub enum Kind {
    /// The file is not UTF-8 text.
    Encoding,
    /// The text is not TOML.
    Syntax,
    /// A key that the format does not have.
    UnknownKey,
    /// A value of the wrong type, or a word that is not among the choices.
    WrongType,
    /// NaN or an infinity.
    NotFinite,
    /// A number outside its range.
    OutOfRange,
    /// A required key that is not there.
    Missing,
    /// Balls that overlap.
    Overlap,
    /// A ball outside the table.
    Outside,
    /// Two laws, or two statements, for one choice.
    TwoLaws,
    /// Two laws that cannot hold in one scene.
    Incompatible,
    /// An id, or a word of a set, used twice.
    Duplicate,
    /// A name that breaks the rules for names.
    BadName,
    /// A ball that the scene does not have.
    UnknownBall,
    /// A value that no named effect could use.
    NoEffect,
    /// Words that a table for people cannot show as they are. The one kind that is no error.
    Spelling,
}

impl Kind {
    fn level(self) -> Level<'static> {
        match self {
            Kind::Spelling => Level::WARNING,
            _ => Level::ERROR,
        }
    }
}

/// One thing that is wrong with a scene file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Diagnostic {
    /// What kind of error it is.
    pub kind: Kind,
    /// What is wrong, in one sentence without a full stop.
    pub message: String,
    /// The bytes of the text that are wrong.
    pub span: Range<usize>,
    /// Words under the marked bytes.
    pub label: String,
    /// Other places that have to do with it, each with a few words.
    pub also: Vec<(Range<usize>, String)>,
    /// What would be right.
    pub help: String,
    /// Path of the key that would mend it, such as `units.length_in_metres`: what is missing has no place of its own.
    pub wanted: Option<String>,
}

impl Diagnostic {
    /// An error at `span` that says what is wrong and what would be right.
    pub fn new(
        kind: Kind,
        span: Range<usize>,
        message: impl Into<String>,
        help: impl Into<String>,
    ) -> Self {
        Diagnostic {
            kind,
            message: message.into(),
            span,
            label: "here".to_owned(),
            also: Vec::new(),
            help: help.into(),
            wanted: None,
        }
    }

    /// The same error with other words under the mark.
    pub fn labelled(mut self, label: impl Into<String>) -> Self {
        self.label = label.into();
        self
    }

    /// The same error with the path of the key that would mend it.
    pub fn wanting(mut self, path: impl Into<String>) -> Self {
        self.wanted = Some(path.into());
        self
    }

    /// The same error with a second place marked.
    pub fn and(mut self, span: Range<usize>, label: impl Into<String>) -> Self {
        self.also.push((span, label.into()));
        self
    }
}

/// What is wrong with one scene file, in the order of the text. At least one.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Diagnostics {
    /// Name of the file, as the user gave it.
    pub file: String,
    /// Its text; bytes that are not UTF-8 are replaced.
    pub text: String,
    /// The first errors, by position.
    pub problems: Vec<Diagnostic>,
    /// Number of further errors.
    pub more: usize,
    /// Where each line begins.
    lines: Vec<usize>,
}

/// How many errors of one file are shown; the rest is counted.
const SHOWN: usize = 20;

impl Diagnostics {
    /// The errors of `file`: the first by position, and the number of the rest.
    pub(super) fn new(file: &str, text: &str, (problems, more): (Vec<Diagnostic>, usize)) -> Self {
        let starts = text.match_indices('\n').map(|(newline, _)| newline + 1);
        Diagnostics {
            file: file.to_owned(),
            text: text.to_owned(),
            problems,
            more,
            lines: std::iter::once(0).chain(starts).collect(),
        }
    }

    /// Line and column of byte `offset`, both from 1; columns count characters. What is beyond the text is at its end.
    pub fn position(&self, offset: usize) -> (usize, usize) {
        let before = self.text.get(..offset).unwrap_or(&self.text);
        let line = self.line_at(before.len());
        (line + 1, before[self.lines[line]..].chars().count() + 1)
    }

    /// The line, from 0, of byte `offset`.
    fn line_at(&self, offset: usize) -> usize {
        self.lines.partition_point(|start| *start <= offset) - 1
    }

    /// The errors as a compiler shows them, with ANSI colours if `colour`. No newline at the end.
    pub fn render(&self, colour: bool) -> String {
        let renderer = if colour {
            Renderer::styled()
        } else {
            Renderer::plain()
        };
        let shown = self.problems.iter().take(SHOWN);
        let mut parts: Vec<String> = shown
            .map(|problem| self.render_one(&renderer, problem))
            .collect();
        let more = self.problems.len().saturating_sub(SHOWN) + self.more;
        if more > 0 {
            let file = printable(&self.file);
            let warns = |problem: &Diagnostic| problem.kind == Kind::Spelling;
            parts.push(match self.problems.iter().all(warns) {
                true => format!("warning: {file}: {more} more warnings"),
                false => format!("error: {file}: {more} more errors"),
            });
        }
        parts.join("\n\n")
    }

    fn render_one(&self, renderer: &Renderer, problem: &Diagnostic) -> String {
        // the renderer reads all that it is given: the lines from the first mark to the last
        let marks = std::iter::once(&problem.span).chain(problem.also.iter().map(|also| &also.0));
        let spans: Vec<Range<usize>> = marks.map(|span| self.within(span)).collect();
        let first = spans.iter().map(|span| self.line_at(span.start)).min();
        let last = spans.iter().map(|span| self.line_at(span.end)).max();
        let (first, last) = (first.unwrap_or(0), last.unwrap_or(0));
        let start = self.lines[first];
        let end = self.lines.get(last + 1).copied().unwrap_or(self.text.len());
        let mark = |span: &Range<usize>, kind: AnnotationKind, label: &str| {
            let span = self.within(span);
            let label = printable(label);
            kind.span(span.start - start..span.end - start).label(label)
        };
        let primary = mark(&problem.span, AnnotationKind::Primary, &problem.label);
        let others = problem
            .also
            .iter()
            .map(|(span, label)| mark(span, AnnotationKind::Context, label));
        let snippet = Snippet::source(without_commands(&self.text[start..end]))
            .line_start(first + 1)
            .path(printable(&self.file))
            .annotation(primary)
            .annotations(others);
        let group: Group<'_> = problem
            .kind
            .level()
            .primary_title(printable(&problem.message))
            .element(snippet)
            .element(Level::HELP.message(printable(&problem.help)));
        without_empty_gutter_before_help(&renderer.render(&[group]))
    }

    /// The span cut to the text and to whole characters, so that no input can make the renderer slip.
    fn within(&self, span: &Range<usize>) -> Range<usize> {
        let clip = |at: usize| {
            let mut at = at.min(self.text.len());
            while !self.text.is_char_boundary(at) {
                at -= 1;
            }
            at
        };
        let (start, end) = (clip(span.start), clip(span.end));
        // a mark over several lines would show all of them: its first line says enough
        let first_line = self.text[start..end.max(start)]
            .find('\n')
            .map_or(end.max(start), |newline| start + newline);
        start..first_line
    }
}

impl fmt::Display for Diagnostics {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.render(false))
    }
}

/// `text` with the hidden characters beyond ASCII replaced by signs of the same length, so that no mark moves. The renderer
/// shows those of ASCII by their pictures, and passes these on; a terminal may take them for the start of a command.
fn without_commands(text: &str) -> Cow<'_, str> {
    let commands = |c: char| is_hidden(c) && !c.is_ascii();
    if !text.contains(commands) {
        return Cow::Borrowed(text);
    }
    let sign = |c: char| match c.len_utf8() {
        _ if !commands(c) => c,
        2 => '\u{b7}',
        3 => char::REPLACEMENT_CHARACTER,
        _ => '\u{10300}',
    };
    Cow::Owned(text.chars().map(sign).collect())
}

/// A number with at most six significant digits, as a person would write it.
pub fn short(x: f64) -> String {
    let rounded: f64 = format!("{x:.5e}").parse().unwrap_or(x);
    if rounded == 0.0 || (1e-3..1e6).contains(&rounded.abs()) {
        format!("{rounded}")
    } else {
        format!("{rounded:e}")
    }
}

/// The renderer puts an empty gutter line between the snippet and the help; the mark already parts them.
fn without_empty_gutter_before_help(rendered: &str) -> String {
    let lines: Vec<&str> = rendered.lines().collect();
    let mut kept = Vec::with_capacity(lines.len());
    for (i, line) in lines.iter().enumerate() {
        let before_help = lines
            .get(i + 1)
            .is_some_and(|next| next.trim_start().starts_with("= "));
        if !(before_help && line.trim() == "|") {
            kept.push(*line);
        }
    }
    kept.join("\n")
}

/// The word of `known` that `word` most likely was meant to be: at most a third of its letters differ.
pub fn nearest<'a>(word: &str, known: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    known
        .into_iter()
        .filter_map(|candidate| Some((edits(word, candidate)?, candidate)))
        .min_by_key(|&(distance, _)| distance)
        .map(|(_, candidate)| candidate)
}

/// Number of letters to insert, remove, replace or swap with a neighbour to get from one word to the other; `None` where that is more
/// than a third of the first, and more than one.
fn edits(from: &str, to: &str) -> Option<usize> {
    let (length, other) = (from.chars().count(), to.chars().count());
    let allowed = (length / 3).max(1);
    if length.abs_diff(other) > allowed {
        return None; // a word from a file may be long, and the distance takes the product of both
    }
    Some(strsim::osa_distance(from, to)).filter(|&distance| distance <= allowed)
}

/// At most three names of `known` that `name` may have been meant to be, the likeliest first: those with few other letters, then those
/// that begin with it, those that have all of its parts, as `report-break` has of `break-report`, and those that it begins with. Capitals,
/// underscores and spaces count as what stands for them in names.
pub fn nearest_names<'a>(name: &str, known: impl IntoIterator<Item = &'a str>) -> Vec<&'a str> {
    const MOST: usize = 3;
    /// Fewer letters are part of too many names.
    const FEWEST_LETTERS: usize = 3;
    let name = name.to_lowercase().replace(['_', ' '], "-");
    let tells = name.chars().filter(|&c| c != '-').count() >= FEWEST_LETTERS;
    // the kind of likeness, the closest first, and the number of other letters
    let likeness = |candidate: &str| {
        let parts = || name.split('-').all(|part| candidate.contains(part));
        match edits(&name, candidate) {
            Some(distance) => Some((0, distance)),
            None if !tells => None,
            None if candidate.starts_with(&name) => Some((1, 0)),
            None if parts() => Some((2, 0)),
            None if name.starts_with(candidate) => Some((3, 0)),
            None => None,
        }
    };
    let mut near: Vec<((u8, usize), &str)> = known
        .into_iter()
        .filter_map(|candidate| Some((likeness(candidate)?, candidate)))
        .collect();
    near.sort_by_key(|&(likeness, _)| likeness);
    if let Some(&((0, 0), same)) = near.first() {
        return vec![same];
    }
    near.into_iter().take(MOST).map(|(_, near)| near).collect()
}

/// Why there is no scene.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
#[non_exhaustive]
pub enum SceneError {
    /// The file is not a valid scene.
    #[error("{0}")]
    Invalid(Diagnostics),
    /// The catalogue has no scene of this name.
    #[error(
        "no scene is called `{}`; {}`carom scene list` prints all names",
        printable(name),
        guess(nearest)
    )]
    Unknown {
        /// The name that was asked for.
        name: String,
        /// At most three names that were probably meant, the likeliest first.
        nearest: Vec<String>,
    },
}

fn guess(nearest: &[String]) -> String {
    let quoted: Vec<String> = nearest.iter().map(|name| format!("`{name}`")).collect();
    match quoted.split_last() {
        None => String::new(),
        Some((only, [])) => format!("did you mean {only}? "),
        Some((last, others)) => format!("did you mean {} or {last}? ", others.join(", ")),
    }
}
