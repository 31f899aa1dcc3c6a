//! What a matrix of hard cases says, in sentences.

use super::plan::Role;
use super::{Case, Outcome, Reach};
use crate::finding::Verdict;
use crate::oracle;

/// One word of a verdict, short enough for a matrix of seven columns.
pub fn word(verdict: Verdict) -> &'static str {
    match verdict {
        Verdict::CannotExpress => "cannot",
        Verdict::Holds => "holds",
        Verdict::Indeterminate => "indet.",
        Verdict::Drifts => "drifts",
        Verdict::Breaks => "breaks",
    }
}

/// One letter of a verdict.
pub fn letter(verdict: Verdict) -> char {
    match verdict {
        Verdict::CannotExpress => 'c',
        Verdict::Holds => 'h',
        Verdict::Indeterminate => 'i',
        Verdict::Drifts => 'd',
        Verdict::Breaks => 'b',
    }
}

/// The sentence a person came for.
pub fn sentence(outcome: &Outcome) -> String {
    let scenes = outcome.question.scenes.len();
    let all = |_: &Case| true;
    let counts: Vec<String> = [
        (Verdict::Holds, "hold"),
        (Verdict::Drifts, "drift"),
        (Verdict::Breaks, "break"),
        (Verdict::Indeterminate, "have no single right answer"),
        (Verdict::CannotExpress, "cannot be expressed"),
    ]
    .iter()
    .map(|(verdict, words)| format!("{} {words}", outcome.count(*verdict, all)))
    .collect();
    let plural = if scenes == 1 { "" } else { "s" };
    format!(
        "{} runs of {scenes} hard case{plural}: {}. {}",
        outcome.done(),
        counts.join(", "),
        own_models(outcome)
    )
}

/// What our own models do in every case.
fn own_models(outcome: &Outcome) -> String {
    let checked = |case: &Case| {
        let column = &case.planned.column;
        let rule = column.setting.values.get("contact").map(String::as_str);
        column.engine.id() == "stepper" && rule == Some("approaching-only")
    };
    let exact = |case: &Case| oracle::is_reference(case.planned.column.engine);
    let promises = outcome.broken_promises().len();
    let promised = match promises {
        0 if outcome.is_cut_short() => "Nothing that ran breaks a promise".to_owned(),
        0 => "No promised invariant is broken".to_owned(),
        1 => "One promised invariant is broken".to_owned(),
        n => format!("{n} promised invariants are broken"),
    };
    let own_step = |case: &Case| checked(case) && is_preset(case);
    let other_step = |case: &Case| checked(case) && !is_preset(case);
    format!(
        "{promised}; exact breaks in {} of its runs, the stepper with the approach check in {} at its own step and {} at others.",
        outcome.count(Verdict::Breaks, exact),
        outcome.count(Verdict::Breaks, own_step),
        outcome.count(Verdict::Breaks, other_step)
    )
}

/// What was left out, and why; `None` where nothing was.
pub fn left_out(outcome: &Outcome) -> Option<String> {
    let of = |reach: Reach| {
        let left = outcome.cases.iter().filter(|case| {
            case.planned.reach == reach && !outcome.question.runs(case.planned.reach)
        });
        left.count()
    };
    let (full, never) = (of(Reach::Full), of(Reach::Never));
    if full + never == 0 {
        return None;
    }
    let mut parts = Vec::new();
    if full > 0 {
        parts.push(format!("{full} runs are left to --full"));
    }
    if never > 0 {
        parts.push(format!("{never} are out of reach"));
    }
    Some(format!(
        "{}. {}",
        parts.join(", "),
        super::plan::bounds_in_words()
    ))
}

/// `stepper contact=approaching-only` as a heading of short words.
pub fn heading(case: &Case) -> String {
    let column = &case.planned.column;
    let values = column.setting.values.iter();
    let words: Vec<String> = values
        .map(|(key, value)| match (key.as_str(), value.as_str()) {
            ("contact", "approaching-only") => "approach check".to_owned(),
            ("preset", preset) => preset.to_owned(),
            (key, value) => format!("{key} {value}"),
        })
        .collect();
    let engine = column.engine.id().replace('-', " ");
    let bare = words.is_empty() && column.engine.id() == "stepper";
    let words = if bare {
        "as written".to_owned()
    } else {
        words.join(" ")
    };
    format!("{engine} {words}").trim_end().to_owned()
}

/// Why a cell did not run.
pub fn absent(outcome: &Outcome, case: &Case) -> &'static str {
    match case.planned.reach {
        Reach::Never => "out of reach",
        Reach::Full if !outcome.question.full => "only with --full",
        _ => "not run",
    }
}

/// One mark of a step's cell: a letter, `.` where it is left to --full, `-` where it is out of reach, `?` where it was cut short.
pub fn mark(outcome: &Outcome, case: &Case) -> char {
    match (&case.judged, case.planned.reach) {
        (Some(judged), _) => letter(judged.verdict),
        (None, Reach::Never) => '-',
        (None, Reach::Full) if !outcome.question.full => '.',
        (None, _) => '?',
    }
}

/// True for the cells of presets.
pub fn is_preset(case: &Case) -> bool {
    case.planned.role == Role::Preset
}
