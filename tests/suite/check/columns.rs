//! Every cell of every file that `carom run` writes: one that is changed is noticed by `carom diff`, or is in a list with a reason.

use super::diff::{carom, run};
use super::said;
use serde_json::Value;
use std::fs;
use std::path::Path;

/// Values of `run.json` that two runs may differ in, with the reason, and the words by which the difference is told instead.
const MAY_DIFFER: &[(&str, &str, &str)] = &[
    (
        "/engine",
        "two engines are held against each other",
        "against",
    ),
    ("/version", "so are two versions of one", "against"),
    ("/parameters/", "and two settings", "Other settings: "),
    (
        "/ending/spot/why",
        "words for a person, with digits of one target in them; time and balls of the spot are held",
        "",
    ),
    (
        "/extrema/ of nothing",
        "the largest of many roundings is another one on another target",
        "Not held: when and where ",
    ),
];

/// Exit code and words of a diff, without line breaks.
fn diff(a: &Path, b: &Path) -> (i32, String) {
    let output = carom(&["diff", a.to_str().unwrap(), b.to_str().unwrap()]);
    let words = said(&output);
    let words: Vec<&str> = words.split_whitespace().collect();
    (output.status.code().unwrap(), words.join(" "))
}

/// A number that is visibly another one.
fn moved(text: &str) -> Option<String> {
    if let Ok(count) = text.parse::<u64>() {
        return Some((count + 1).to_string());
    }
    let x: f64 = text.parse().ok()?;
    if !x.is_finite() {
        return Some("0.5".to_owned());
    }
    Some(format!("{:?}", 1.01 * x + 1e-3))
}

/// Another value of a cell: a number that moved, a word that is another one of its kind, something where nothing was.
fn other(column: &str, text: &str) -> String {
    match (column, text) {
        ("kind", "stop") => "spin-end".to_owned(),
        ("kind", _) => "stop".to_owned(),
        ("stop_time" | "margin" | "condition" | "time_error", "") => "0.5".to_owned(),
        ("exchanges" | "event", "") => "0".to_owned(),
        (_, "x0") => "x1".to_owned(),
        (_, "x1") => "x0".to_owned(),
        (_, "y0") => "y1".to_owned(),
        (_, "y1") => "y0".to_owned(),
        // a ball by its number is no number
        ("ball" | "a" | "b", "cue") => "1".to_owned(),
        ("ball" | "a" | "b", _) => "cue".to_owned(),
        _ => moved(text).unwrap_or_else(|| format!("{text}0")),
    }
}

/// A run in a folder, and a copy of it in which one file at a time is altered.
struct Copy {
    folder: tempfile::TempDir,
}

impl Copy {
    fn of(scene: &str, engine: &str) -> Copy {
        let folder = tempfile::tempdir().unwrap();
        run(&folder.path().join("a"), scene, engine, &[]);
        run(&folder.path().join("b"), scene, engine, &[]);
        Copy { folder }
    }

    /// The file as it was written.
    fn text(&self, file: &str) -> String {
        fs::read_to_string(self.folder.path().join("a").join(file)).unwrap()
    }

    /// Exit code and words of the diff with `text` in the place of a file.
    fn with(&self, file: &str, text: &str) -> (i32, String) {
        let (a, b) = (self.folder.path().join("a"), self.folder.path().join("b"));
        fs::write(b.join(file), text).unwrap();
        let found = diff(&a, &b);
        fs::copy(a.join(file), b.join(file)).unwrap();
        found
    }
}

/// Rows of a table whose cells are altered: the first, the last, one in between, and of each column the first that is not empty and the
/// first that is.
fn rows_to_alter(rows: &[Vec<&str>], column: usize) -> Vec<usize> {
    let empty = |wanted: bool| rows.iter().position(|row| row[column].is_empty() == wanted);
    let mut some = vec![0, rows.len() / 2, rows.len() - 1];
    some.extend(empty(false));
    some.extend(empty(true));
    some.sort_unstable();
    some.dedup();
    some
}

fn every_column(copy: &Copy, file: &str) -> usize {
    let text = copy.text(file);
    let mut lines = text.lines();
    let header: Vec<&str> = lines.next().unwrap().split(',').collect();
    let rows: Vec<Vec<&str>> = lines.map(|line| line.split(',').collect()).collect();
    if rows.is_empty() {
        return 0;
    }
    let mut altered = 0;
    for (column, name) in header.iter().enumerate() {
        for row in rows_to_alter(&rows, column) {
            let mut changed = rows.clone();
            let cell = other(name, rows[row][column]);
            changed[row][column] = &cell;
            let lines = changed.iter().map(|row| row.join(",") + "\n");
            let text = header.join(",") + "\n" + &lines.collect::<String>();
            let (code, words) = copy.with(file, &text);
            assert!(
                code == 1 || code == 2,
                "{file}, {name} of row {row}: {} became {cell}: {code}, {words}",
                rows[row][column]
            );
            altered += 1;
        }
    }
    altered
}

/// Every value of a JSON document that holds no others, by its path.
fn leaves(value: &Value, path: &str, found: &mut Vec<String>) {
    match value {
        Value::Object(map) => {
            for (key, value) in map {
                leaves(value, &format!("{path}/{key}"), found);
            }
        }
        Value::Array(list) => {
            for (index, value) in list.iter().enumerate() {
                leaves(value, &format!("{path}/{index}"), found);
            }
        }
        _ => found.push(path.to_owned()),
    }
}

/// Why a value of `run.json` is not held, and what is told instead; `None` for one that must be noticed.
fn exemption(
    document: &Value,
    path: &str,
) -> Option<&'static (&'static str, &'static str, &'static str)> {
    let extremum = path
        .strip_prefix("/extrema/")
        .and_then(|rest| rest.rsplit_once('/'));
    let nothing = extremum.is_some_and(|(name, key)| {
        let value = document.pointer(&format!("/extrema/{name}/value")).unwrap();
        key != "value" && value.as_f64().unwrap() < 1e-9
    });
    MAY_DIFFER.iter().find(|(known, _, _)| match *known {
        "/extrema/ of nothing" => nothing,
        prefix if prefix.ends_with('/') => path.starts_with(prefix),
        whole => path == whole,
    })
}

fn every_value(copy: &Copy) -> usize {
    let text = copy.text("run.json");
    let document: Value = serde_json::from_str(&text).unwrap();
    let mut paths = Vec::new();
    leaves(&document, "", &mut paths);
    for path in &paths {
        let mut changed = document.clone();
        let value = changed.pointer_mut(path).unwrap();
        *value = match &*value {
            Value::Null => Value::from("cue"),
            Value::Bool(truth) => Value::from(!*truth),
            Value::String(word) if path.contains("/balls/") || path.starts_with("/extrema/") => {
                Value::from(other("ball", word))
            }
            Value::String(word) if path == "/ending/kind" => {
                Value::from(if word == "rest" { "duration" } else { "budget" })
            }
            Value::String(word) => Value::from(format!("{word}0")),
            number => match number.as_u64() {
                Some(count) => Value::from(count + 1),
                None => Value::from(1.01 * number.as_f64().unwrap() + 1e-3),
            },
        };
        let text = serde_json::to_string_pretty(&changed).unwrap();
        let (code, words) = copy.with("run.json", &text);
        match exemption(&document, path) {
            None => assert!(code == 1 || code == 2, "{path}: {code}, {words}"),
            Some((_, why, told)) => {
                assert_eq!(code, 0, "{path}: {why}, and yet: {words}");
                assert!(words.contains(told), "{path}: {words}");
            }
        }
    }
    paths.len()
}

#[test]
fn one_cell_of_any_column_of_any_file_is_noticed_by_a_diff() {
    let (mut cells, mut values) = (0, 0);
    for (scene, engine) in [
        // certainty, cushions, phases of motion, spins
        ("bank-side", "exact"),
        // exchanges, a resolution and a rest speed of its own
        ("three-ball", "stepper"),
        ("head-on", "rapier-f64"),
        // an ending with a place
        ("triple-hit", "exact"),
    ] {
        let copy = Copy::of(scene, engine);
        assert_eq!(copy.with("run.json", &copy.text("run.json")).0, 0);
        for file in ["events.csv", "samples.csv", "final.csv"] {
            cells += every_column(&copy, file);
        }
        values += every_value(&copy);
    }
    assert!(
        cells > 200 && values > 100,
        "{cells} cells, {values} values"
    );
}

#[test]
fn a_row_that_is_not_there_is_noticed_though_its_ball_was_at_rest() {
    let copy = Copy::of("head-on", "stepper");
    let mut removed = 0;
    for file in ["events.csv", "samples.csv", "final.csv"] {
        let text = copy.text(file);
        let lines: Vec<&str> = text.lines().collect();
        // every tenth row, and those around which nothing moves
        let still = |line: &str| line.contains(",0,0,0,0,0,0,");
        let rows = (1..lines.len()).filter(|&at| at % 10 == 1 || still(lines[at]));
        for at in rows.take(40) {
            let rest = lines.iter().enumerate().filter(|(i, _)| *i != at);
            let text: String = rest.map(|(_, line)| format!("{line}\n")).collect();
            let (code, words) = copy.with(file, &text);
            assert!(code == 1 || code == 2, "{file}, row {at}: {code}, {words}");
            removed += 1;
        }
    }
    assert!(removed > 10, "{removed}");
}

#[test]
fn events_of_one_time_in_another_order_are_noticed() {
    let copy = Copy::of("head-on", "stepper");
    let text = copy.text("events.csv");
    let rows: Vec<Vec<&str>> = text
        .lines()
        .skip(1)
        .map(|l| l.split(',').collect())
        .collect();
    let at =
        (1..rows.len()).find(|&i| rows[i][1] == rows[i - 1][1] && rows[i][2] != rows[i - 1][2]);
    let at = at.expect("a stop at the time of a hit");
    let mut swapped = rows.clone();
    swapped.swap(at - 1, at);
    // the numbers stay in their places
    (swapped[at - 1][0], swapped[at][0]) = (rows[at - 1][0], rows[at][0]);
    let lines = swapped.iter().map(|row| row.join(",") + "\n");
    let header = text.lines().next().unwrap();
    let (code, words) = copy.with(
        "events.csv",
        &format!("{header}\n{}", lines.collect::<String>()),
    );
    assert!(code == 1 || code == 2, "{code}, {words}");
}
