//! Holds a parsed file against the schema: unknown and missing keys, types, ranges, two laws for one choice.
//!
//! One walk finds all of them at once, each with its position. It knows no key by name: keys, types, ranges and advice come
//! from the schema, which comes from the types of `file`, so a new key or law is checked as soon as it exists.

use super::diagnostics::{Diagnostic, Kind, nearest};
use super::format::{
    ANY_SIZE, advice, is_described, keys, kind_of, list, target, variants, wanted, words,
};
use super::located::{Located, header, join, last};
use super::pieces::Shift;
use super::printable::printable;
use super::problems::Problems;
use serde_json::Value;
use std::ops::Range;
use toml::Spanned;
use toml::de::{DeString, DeTable, DeValue};

/// Largest size of a number in a scene. Its square, and that of a speed times a duration, stays far from overflow.
pub(super) const LARGEST: f64 = 1e30;

/// Smallest size of a number in a scene that is not 0. Its square stays far from underflow. A schema that says
/// [`ANY_SIZE`] has no such bound: a speed may be what a cosine left over.
pub(super) const SMALLEST: f64 = 1e-30;

/// Everything in which the file at hand departs from `schema`.
pub(super) fn check(located: &Located<'_>, schema: &Value) -> Problems {
    let mut problems = Problems::new();
    check_table(&located.root, schema, Shift::default(), &mut problems);
    problems
}

/// Everything in which a file departs from `schema`, whose keys are those of `root` and stand where `shift` says.
pub(super) fn check_table(
    root: &DeTable<'_>,
    schema: &Value,
    shift: Shift,
    problems: &mut Problems,
) {
    let mut walk = Walk {
        schema,
        shift,
        problems,
    };
    // what is missing in the file has no place in it
    walk.shift.from = walk.shift.from.max(1);
    walk.table("", schema, root, 0..0);
}

/// Everything in which items of the list at `key` depart from `schema`. `first`: the index of the first.
pub(super) fn check_items(
    (key, first): (&str, usize),
    items: &[Spanned<DeValue<'_>>],
    schema: &Value,
    shift: Shift,
    problems: &mut Problems,
) {
    let property = &schema["properties"][key];
    let list = target(schema, property);
    let around = Around {
        says: is_described(property, list).then_some((property, list)),
        any_size: property[ANY_SIZE] == true,
    };
    let mut walk = Walk {
        schema,
        shift,
        problems,
    };
    for (i, item) in items.iter().enumerate() {
        let path = format!("{key}[{}]", first + i);
        walk.value(&path, &list["items"], around, item);
    }
}

/// What a list, or the key itself, says of values that say nothing of their own.
#[derive(Clone, Copy, Debug, Default)]
struct Around<'s> {
    /// The schema that describes them, and the one behind its reference.
    says: Option<(&'s Value, &'s Value)>,
    /// Whether they may be smaller than [`SMALLEST`].
    any_size: bool,
}

impl Around<'_> {
    /// The advice on a value at `path`, whose schema is `target`. Put together only for an error: most values are right.
    fn advice(&self, path: &str, target: &Value) -> String {
        match self.says {
            Some((schema, target)) => advice(schema, target),
            // a law of several has its description beside it, not on itself
            None if kind_of(target) == "object" => contents(path, target),
            None => String::new(),
        }
    }
}

struct Walk<'s, 'p> {
    schema: &'s Value,
    /// Where what is walked stands in the text.
    shift: Shift,
    problems: &'p mut Problems,
}

type KeyValue<'a, 't> = (&'a Spanned<DeString<'t>>, &'a Spanned<DeValue<'t>>);

impl<'s> Walk<'s, '_> {
    /// `around`: what the list that the value stands in says of its values.
    fn value(
        &mut self,
        path: &str,
        schema: &'s Value,
        around: Around<'s>,
        value: &Spanned<DeValue<'_>>,
    ) {
        let target = target(self.schema, schema);
        let own = is_described(schema, target).then_some((schema, target));
        let around = Around {
            says: own.or(around.says),
            any_size: around.any_size || schema[ANY_SIZE] == true,
        };
        let span = self.shift.place(value.span());
        if let Some(words) = words(target) {
            return self.word(path, &words, value);
        }
        match (kind_of(target), value.get_ref()) {
            ("choice", DeValue::Table(table)) => self.choice(path, variants(target), table, span),
            ("object", DeValue::Table(table)) => self.table(path, target, table, span),
            ("array", DeValue::Array(items)) => {
                let size = target["minItems"].as_u64();
                if size.is_some_and(|n| n != items.len() as u64) {
                    self.report(Kind::WrongType, span, || {
                        let (must, found) = (wanted(target), items.len());
                        let message = format!("{} must be {must}, not {found}", last(path));
                        (message, around.advice(path, target))
                    });
                }
                for (i, item) in items.iter().enumerate() {
                    self.value(&format!("{path}[{i}]"), &target["items"], around, item);
                }
            }
            ("number", DeValue::Float(_) | DeValue::Integer(_)) => {
                self.number(path, target, around, value);
            }
            ("integer", DeValue::Integer(_)) => self.number(path, target, around, value),
            ("string", DeValue::String(_)) | ("boolean", DeValue::Boolean(_)) => {}
            (kind, found) => {
                let fraction = kind == "integer" && matches!(found, DeValue::Float(_));
                let found = if fraction {
                    "a number with a fraction"
                } else {
                    name_of_type(found)
                };
                self.report(Kind::WrongType, span, || {
                    let message = format!("{} must be {}, not {found}", last(path), wanted(target));
                    (message, around.advice(path, target))
                });
            }
        }
    }

    fn number(
        &mut self,
        path: &str,
        schema: &Value,
        around: Around<'s>,
        value: &Spanned<DeValue<'_>>,
    ) {
        let smallest = if around.any_size { 0.0 } else { SMALLEST };
        let must = || {
            let message = format!("{} must be {}", last(path), wanted(schema));
            (message, around.advice(path, schema))
        };
        let x = match value.get_ref() {
            DeValue::Float(float) => float.as_str().parse::<f64>().unwrap_or(f64::NAN),
            // TOML promises 64 bits for integers; larger ones are numbers all the same, but must be written as such
            DeValue::Integer(digits) => {
                match i64::from_str_radix(digits.as_str(), digits.radix()) {
                    Ok(whole) => whole as f64,
                    Err(_) => {
                        return self.report(
                            Kind::OutOfRange,
                            self.shift.place(value.span()),
                            || {
                                let what = last(path);
                                let message =
                                    format!("{what} has more digits than a whole number can");
                                let help =
                                    "write it with a decimal point or an exponent, such as 1.0e20";
                                (message, help.to_owned())
                            },
                        );
                    }
                }
            }
            _ => f64::NAN,
        };
        let low = schema["minimum"].as_f64().is_some_and(|least| x < least)
            || schema["exclusiveMinimum"]
                .as_f64()
                .is_some_and(|bound| x <= bound);
        let high = schema["maximum"].as_f64().is_some_and(|most| x > most)
            || schema["exclusiveMaximum"]
                .as_f64()
                .is_some_and(|bound| x >= bound);
        // shortest decimals never round to an infinity, so one that was written in digits is too large
        let written_in_digits = match value.get_ref() {
            DeValue::Float(float) => float.as_str().contains(|c: char| c.is_ascii_digit()),
            _ => true,
        };
        if !x.is_finite() && !written_in_digits {
            self.report(Kind::NotFinite, self.shift.place(value.span()), must);
        } else if low || high {
            self.report(Kind::OutOfRange, self.shift.place(value.span()), must);
        } else if x != 0.0 && !(smallest..=LARGEST).contains(&x.abs()) {
            self.report(Kind::OutOfRange, self.shift.place(value.span()), || {
                let least = if around.any_size {
                    format!("at most {LARGEST:e}")
                } else {
                    format!("0 or between {SMALLEST:e} and {LARGEST:e}")
                };
                let message = format!("{} must be {least} in size", last(path));
                let help = "choose units in which the numbers of the scene are nearer to 1";
                (message, help.to_owned())
            });
        }
    }

    fn word(&mut self, path: &str, words: &[&str], value: &Spanned<DeValue<'_>>) {
        let all = || {
            let quoted: Vec<String> = words.iter().map(|word| format!("\"{word}\"")).collect();
            quoted.join(", ")
        };
        let DeValue::String(word) = value.get_ref() else {
            return self.report(Kind::WrongType, self.shift.place(value.span()), || {
                let found = name_of_type(value.get_ref());
                let message = format!("{} must be one of {}, not {found}", last(path), all());
                (message, "write it in quotes".to_owned())
            });
        };
        if words.contains(&word.as_ref()) {
            return;
        }
        self.report(Kind::WrongType, self.shift.place(value.span()), || {
            let message = format!("unknown word \"{word}\" for {}", last(path));
            let known = format!("known are {}", all());
            (message, with_guess(word, words.iter().copied(), &known))
        });
    }

    fn table(&mut self, path: &str, schema: &'s Value, table: &DeTable<'_>, span: Range<usize>) {
        let known = &schema["properties"];
        for (key, value) in table {
            let inner = join(path, key.get_ref());
            if let Some(property) = known.get(key.get_ref().as_ref()) {
                self.value(&inner, property, Around::default(), value);
            } else {
                self.unknown_key(path, (key, value), || keys(known));
            }
        }
        for key in list(&schema["required"]).iter().filter_map(Value::as_str) {
            if !table.contains_key(key) {
                let property = known.get(key).unwrap_or(&Value::Null);
                let target = target(self.schema, property);
                self.problems.push_at(span.clone(), |span| {
                    let message = format!("{} must have `{key}`, {}", header(path), wanted(target));
                    let help = advice(property, target);
                    missing(span, message, help).wanting(join(path, key))
                });
            }
        }
    }

    /// A table that names one of several laws, each a table of its own.
    fn choice(
        &mut self,
        path: &str,
        variants: Vec<(&'s str, &'s Value)>,
        table: &DeTable<'_>,
        span: Range<usize>,
    ) {
        let mut named: Vec<Range<usize>> = Vec::new();
        let mut laws = Vec::new();
        for (key, value) in table {
            let inner = join(path, key.get_ref());
            let law = variants.iter().find(|(name, _)| name == key.get_ref());
            if let Some((_, schema)) = law {
                self.value(&inner, schema, Around::default(), value);
            } else {
                let known = || variants.iter().map(|(name, _)| *name).collect();
                self.unknown_key(path, (key, value), known);
                continue;
            }
            named.push(self.shift.place(key.span()));
            laws.push((
                self.shift.place(key.span()).start,
                key.get_ref().to_string(),
            ));
        }
        if named.len() > 1 {
            laws.sort();
            named.sort_by_key(|span| span.start);
            let laws: Vec<String> = laws.iter().map(|(_, name)| format!("`{name}`")).collect();
            let message = format!(
                "two laws for one choice in {}: {}",
                header(path),
                laws.join(" and ")
            );
            let help = "name one of them and remove the other";
            let mut problem = Diagnostic::new(Kind::TwoLaws, named[1].clone(), message, help)
                .labelled("this is one more");
            problem = problem.and(named[0].clone(), "one is named here");
            self.problems.push(problem);
        } else if named.is_empty() && table.is_empty() {
            let known: Vec<&str> = variants.iter().map(|(name, _)| *name).collect();
            let message = format!("{} names no law", header(path));
            let help = format!("known are {}", quoted(&known));
            self.problems.push(missing(span, message, help));
        }
    }

    fn unknown_key<'k>(
        &mut self,
        path: &str,
        (key, value): KeyValue<'_, '_>,
        known: impl FnOnce() -> Vec<&'k str>,
    ) {
        let schema = self.schema;
        self.report(Kind::UnknownKey, self.shift.place(key.span()), || {
            let (word, known) = (key.get_ref(), known());
            let top = keys(&schema["properties"]);
            let misplaced =
                !path.is_empty() && top.contains(&word.as_ref()) && !known.contains(&word.as_ref());
            let message = format!("unknown key `{word}` in {}", header(path));
            let help = if misplaced && !matches!(value.get_ref(), DeValue::Table(_)) {
                format!("`{word}` belongs at the top of the file, before the first [table]")
            } else if known.is_empty() {
                format!("{} takes no keys", header(path))
            } else {
                with_guess(
                    word,
                    known.iter().copied(),
                    &format!("known are {}", quoted(&known)),
                )
            };
            (message, help)
        });
    }

    /// `words`: the message and the help.
    fn report(&mut self, kind: Kind, span: Range<usize>, words: impl FnOnce() -> (String, String)) {
        self.problems.push_at(span, |span| {
            let (message, help) = words();
            Diagnostic::new(kind, span, message, help)
        });
    }
}

/// A missing key: the mark is the header of the table that lacks it, or the start of the file.
pub(super) fn missing(
    span: Range<usize>,
    message: impl Into<String>,
    help: impl Into<String>,
) -> Diagnostic {
    let label = if span.is_empty() {
        "at the top of the file"
    } else {
        "in this table"
    };
    Diagnostic::new(Kind::Missing, span, message, help).labelled(label)
}

/// What a table without advice of its own holds.
fn contents(path: &str, schema: &Value) -> String {
    let known = keys(&schema["properties"]);
    if known.is_empty() {
        format!("write it as {}, which takes no keys", header(path))
    } else {
        format!("write it as {} with {}", header(path), quoted(&known))
    }
}

fn with_guess<'a>(word: &str, known: impl Iterator<Item = &'a str>, otherwise: &str) -> String {
    match nearest(word, known) {
        Some(guess) => format!("did you mean `{}`?", printable(guess)),
        None => otherwise.to_owned(),
    }
}

fn quoted(words: &[&str]) -> String {
    let quoted: Vec<String> = words.iter().map(|word| format!("`{word}`")).collect();
    quoted.join(", ")
}

fn name_of_type(value: &DeValue<'_>) -> &'static str {
    match value {
        DeValue::String(_) => "text",
        DeValue::Integer(_) | DeValue::Float(_) => "a number",
        DeValue::Boolean(_) => "true or false",
        DeValue::Datetime(_) => "a date",
        DeValue::Array(_) => "a list",
        DeValue::Table(_) => "a table",
    }
}
