//! What a matrix of hard cases says, in sentences.

use crate::finding::Verdict;
use crate::study::Configuration;
use crate::study::stability::{Case, Reach, Role, StabilityOutcome, bounds_in_words};

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
pub fn sentence(outcome: &StabilityOutcome) -> String {
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

/// What the engines do that promise to hold in every case.
fn own_models(outcome: &StabilityOutcome) -> String {
    let promises = outcome.broken_promises().len();
    let promised = match promises {
        0 if outcome.is_cut_short() => "Nothing that ran breaks a promise".to_owned(),
        0 => "No promised invariant is broken".to_owned(),
        1 => "One promised invariant is broken".to_owned(),
        n => format!("{n} promised invariants are broken"),
    };
    let mut sound = Configuration::presets(&outcome.question.roster, |preset| preset.sound);
    Configuration::solvers_first(&mut sound);
    let broken = sound.iter().map(|column| {
        let own = |case: &Case| {
            let asked = &case.planned.column;
            asked.engine.id() == column.engine.id()
                && asked.setting.besides(&column.setting).is_some()
        };
        let at = |preset: bool| {
            outcome.count(Verdict::Breaks, |case| {
                own(case) && is_preset(case) == preset
            })
        };
        let name = short_words(column);
        match column.engine.solves() {
            true => format!("{name} breaks in {} of its runs", at(true) + at(false)),
            false => format!(
                "{name} breaks in {} at its own step and {} at others",
                at(true),
                at(false)
            ),
        }
    });
    let sentences: Vec<String> = std::iter::once(promised).chain(broken).collect();
    format!("{}.", sentences.join("; "))
}

/// What was left out, and why; `None` where nothing was.
pub fn left_out(outcome: &StabilityOutcome) -> Option<String> {
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
    Some(format!("{}. {}", parts.join(", "), bounds_in_words()))
}

/// The column of a case as a heading of short words.
pub fn heading(case: &Case) -> String {
    short_words(&case.planned.column)
}

/// Engine, preset and what is set besides, in short words: `stepper approach check`.
fn short_words(column: &Configuration) -> String {
    let mut words = vec![column.engine.id().replace('-', " ")];
    if let Some((preset, besides)) = column.preset() {
        // what the defaults are called is no name for another setting
        if besides.values.is_empty() || !preset.setting.values.is_empty() {
            words.push(preset.words.into_owned());
        }
        let besides = besides.values.iter();
        words.extend(besides.map(|(key, value)| format!("{key} {value}")));
    }
    words.retain(|word| !word.is_empty());
    words.join(" ")
}

/// Why a cell did not run.
pub fn absent(outcome: &StabilityOutcome, case: &Case) -> &'static str {
    match case.planned.reach {
        Reach::Never => "out of reach",
        Reach::Full if !outcome.question.full => "only with --full",
        _ => "not run",
    }
}

/// One mark of a step's cell: a letter, `.` where it is left to --full, `-` where it is out of reach, `?` where it was cut short.
pub fn mark(outcome: &StabilityOutcome, case: &Case) -> char {
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
