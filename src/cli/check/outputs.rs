//! What programs of a pipeline read: JUnit XML, and annotations of GitHub's runner.

use crate::cli::accepted::AcceptedPlace;
use crate::gate::{Change, Held};
use crate::oracle;
use crate::scene::printable;
use crate::study::check::{Case, Level, ORACLE, State, random_command};
use quick_junit::{NonSuccessKind, Report, TestCase, TestCaseStatus, TestSuite};

/// Changes of a case that its failure tells.
const TOLD: usize = 10;

/// Annotations of a step that GitHub shows.
const SHOWN: usize = 10;

/// JUnit XML: one suite a scene, one test case an engine and level, and a suite of baselines that no scene reads, where there are
/// any. Errors: what cannot be written, in one sentence.
pub fn junit(held: &Held, place: &AcceptedPlace<'_>) -> Result<String, String> {
    let mut report = Report::new("carom check");
    for name in held.outcome.names() {
        let mut suite = TestSuite::new(printable(name));
        let own = held.outcome.cases.iter().filter(|c| c.scene == name);
        suite.add_test_cases(own.map(|case| test_case(held, place, case)));
        report.add_test_suite(suite);
    }
    if !held.unread.is_empty() {
        let mut suite = TestSuite::new("baselines");
        suite.add_test_cases(held.unread.iter().map(|file| unread(file)));
        report.add_test_suite(suite);
    }
    let xml = report
        .to_string()
        .map_err(|error| format!("cannot write JUnit XML: {error}"))?;
    Ok(without_skipped_in_all(&xml))
}

/// The schema counts skipped cases by suite only; quick-junit counts them for the whole report too.
fn without_skipped_in_all(xml: &str) -> String {
    let lines = xml
        .lines()
        .map(|line| match line.split_once(" skipped=\"") {
            Some((before, rest)) if line.starts_with("<testsuites ") => {
                let after = rest.split_once('"').map_or("", |(_, after)| after);
                format!("{before}{after}\n")
            }
            _ => format!("{line}\n"),
        });
    lines.collect()
}

fn test_case(held: &Held, place: &AcceptedPlace<'_>, case: &Case) -> TestCase {
    let status = match (&case.state, failure(held, place, case)) {
        (State::Refused(why), _) => {
            // the schema gives it a text and no attributes
            let mut status = TestCaseStatus::skipped();
            status.set_description(printable(why));
            status
        }
        (State::Missing, _) => {
            let mut status = TestCaseStatus::non_success(NonSuccessKind::Error);
            status.set_message("it did not run to its end");
            status.set_type("missing");
            status
        }
        (State::Ran, Some((kind, lines))) => {
            let mut status = TestCaseStatus::non_success(NonSuccessKind::Failure);
            status.set_message(lines.first().map_or("", String::as_str));
            status.set_type(kind);
            status.set_description(lines.join("\n"));
            status
        }
        (State::Ran, None) if held.is_cut_short() => {
            let mut status = TestCaseStatus::skipped();
            status.set_description("not held: the check did not run to its end");
            status
        }
        (State::Ran, None) => TestCaseStatus::success(),
    };
    let name = format!("{} / {}", printable(&case.engine), case.level.id());
    let mut test = TestCase::new(name, status);
    test.set_classname(format!("carom.{}", printable(&case.scene)));
    test
}

/// A baseline that no scene reads.
fn unread(file: &str) -> TestCase {
    let mut status = TestCaseStatus::non_success(NonSuccessKind::Failure);
    status.set_message("no scene reads this baseline");
    status.set_type("baseline");
    status.set_description(format!("no scene reads {file}: remove it"));
    let mut test = TestCase::new(file, status);
    test.set_classname("carom.baselines");
    test
}

/// What is wrong with a case, in lines that a person can act on, and its kind; `None` where nothing is.
fn failure(
    held: &Held,
    place: &AcceptedPlace<'_>,
    case: &Case,
) -> Option<(&'static str, Vec<String>)> {
    let (kind, lines) = wrong(held, place, case)?;
    Some((kind, lines.iter().map(|line| printable(line)).collect()))
}

/// The same with names as they are.
fn wrong(
    held: &Held,
    place: &AcceptedPlace<'_>,
    case: &Case,
) -> Option<(&'static str, Vec<String>)> {
    let broken: Vec<String> = held
        .outcome
        .broken
        .iter()
        .filter(|b| b.level == case.level && b.scene == case.scene && b.engine == case.engine)
        .map(|b| match b.level {
            Level::Fuzz => format!("{} breaks {}: {}", b.engine, b.what, b.why),
            _ => format!("{} promises {}: {}", b.engine, b.what, b.why),
        })
        .collect();
    if !broken.is_empty() {
        return Some(("promise", with_advice(held, case, broken, None)));
    }
    let changes: Vec<&Change> = held
        .changes_of(&case.scene, &case.engine, case.level)
        .collect();
    let stale = held.stale.contains(&case.scene) && case.engine == ORACLE;
    let unknown = held.accepted_of(&case.scene).is_none();
    let mut lines: Vec<String> = changes
        .iter()
        .take(TOLD)
        .map(|change| held.sentence(&case.scene, change))
        .collect();
    if changes.len() > TOLD {
        lines.push(format!("and {} more", changes.len() - TOLD));
    }
    if stale {
        lines.insert(0, "the scene has changed since it was accepted".to_owned());
    }
    if case.engine == ORACLE && case.level == Level::Error {
        let own = held.contradictions.iter();
        let own = own.filter(|(scene, _)| *scene == case.scene);
        lines.extend(own.map(|(_, words)| words.clone()));
    }
    if unknown {
        lines.push("nothing is accepted of this scene".to_owned());
    }
    let kind = if changes.is_empty() {
        "baseline"
    } else {
        "change"
    };
    (!lines.is_empty()).then(|| (kind, with_advice(held, case, lines, Some(place))))
}

/// `place`: where it could be accepted, if it is up to acceptance.
fn with_advice(
    held: &Held,
    case: &Case,
    mut lines: Vec<String>,
    place: Option<&AcceptedPlace<'_>>,
) -> Vec<String> {
    if held.accepted_of(&case.scene).is_some() {
        lines.push(held.since(&case.scene, &case.engine));
    }
    let engine = if case.engine == ORACLE {
        oracle::engine().id().to_owned()
    } else {
        case.engine.replace(' ', ":")
    };
    let show = match case.level {
        Level::Promise | Level::Verdict => {
            format!("carom stability {} --engines {engine}", case.scene)
        }
        Level::Error => format!("carom compare {} --engines {engine}", case.scene),
        Level::Distribution => format!(
            "carom ensemble {} --samples {} --seed {} --engines {engine}",
            case.scene,
            crate::study::check::SAMPLES,
            crate::study::check::SEED
        ),
        Level::Work => format!(
            "carom run {} --engine {} --out DIR",
            case.scene,
            case.engine.replace(' ', " --set ")
        ),
        Level::Fuzz => random_command(&case.engine, None),
    };
    lines.push(format!("to see it: {show}"));
    if let Some(place) = place {
        let accept = place.command(&format!(" {}", case.scene));
        lines.push(format!("if it is right: {accept}"));
    }
    lines
}

/// Lines by which GitHub's runner marks lines of baselines, one a failing case; where those are built in there is no line to mark.
pub fn annotations(held: &Held, place: &AcceptedPlace<'_>) -> Vec<String> {
    let mut lines = Vec::new();
    for case in &held.outcome.cases {
        let Some((_, words)) = failure(held, place, case).filter(|_| case.state == State::Ran)
        else {
            continue;
        };
        let change = held
            .changes_of(&case.scene, &case.engine, case.level)
            .next();
        let address = change.and_then(Change::row).map(|row| row.address());
        let line = match (held.accepted_of(&case.scene), address) {
            (Some(accepted), Some(address)) => accepted.line(address),
            _ => 1,
        };
        let place = place.file(&case.scene).map_or(String::new(), |file| {
            let file = printable(&file.display().to_string());
            format!("file={},line={line},", property(&file))
        });
        lines.push(format!(
            "::error {place}title={}::{}",
            property(&printable(&format!("{} in {}", case.scene, case.engine))),
            escaped(&words.join("\n"))
        ));
    }
    let more = lines.len().saturating_sub(SHOWN);
    if more > 0 {
        lines.truncate(SHOWN - 1);
        let more = more + 1;
        lines.push(format!("::error::{more} more cases are not as accepted"));
    }
    lines
}

/// The text of an annotation: the runner ends it at a line break.
fn escaped(words: &str) -> String {
    words
        .replace('%', "%25")
        .replace('\r', "%0D")
        .replace('\n', "%0A")
}

/// A property of an annotation, which ends at a comma.
fn property(words: &str) -> String {
    escaped(words).replace(':', "%3A").replace(',', "%2C")
}
