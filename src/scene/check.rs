//! Holds a parsed file against the schema: unknown and missing keys, types, ranges, two laws for one choice.
//!
//! One walk finds all of them at once, each with its position. It knows no key by name: keys, types, ranges and advice come
//! from the schema, which comes from the types of `file`, so a new key or law is checked as soon as it exists.

use super::diagnostics::{Diagnostic, Kind, nearest};
use super::format::{ANY_SIZE, advice, keys, kind_of, list, target, variants, wanted, words};
use super::located::{Located, header, join, last};
use super::printable::printable;
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
pub(super) fn check(located: &Located<'_>, schema: &Value) -> Vec<Diagnostic> {
    let mut walk = Walk {
        schema,
        problems: Vec::new(),
    };
    walk.table("", schema, &located.root, 0..0);
    walk.problems
}

/// What a list, or the key itself, says of values that say nothing of their own.
#[derive(Clone, Debug, Default)]
struct Around {
    advice: String,
    /// Whether they may be smaller than [`SMALLEST`].
    any_size: bool,
}

struct Walk<'s> {
    schema: &'s Value,
    problems: Vec<Diagnostic>,
}

type Entry<'a, 't> = (&'a Spanned<DeString<'t>>, &'a Spanned<DeValue<'t>>);

impl<'s> Walk<'s> {
    /// `around`: what the list that the value stands in says of its values.
    fn value(
        &mut self,
        path: &str,
        schema: &'s Value,
        around: &Around,
        value: &Spanned<DeValue<'_>>,
    ) {
        let target = target(self.schema, schema);
        let own = advice(schema, target);
        let around = Around {
            advice: match (own.is_empty(), around.advice.is_empty()) {
                (false, _) => own,
                (true, false) => around.advice.clone(),
                // a law of several has its description beside it, not on itself
                (true, true) if kind_of(target) == "object" => contents(path, target),
                (true, true) => own,
            },
            any_size: around.any_size || schema[ANY_SIZE] == true,
        };
        let advice = around.advice.as_str();
        let span = value.span();
        if let Some(words) = words(target) {
            return self.word(path, &words, value);
        }
        match (kind_of(target), value.get_ref()) {
            ("choice", DeValue::Table(table)) => self.choice(path, variants(target), table, span),
            ("object", DeValue::Table(table)) => self.table(path, target, table, span),
            ("array", DeValue::Array(items)) => {
                let size = target["minItems"].as_u64();
                if size.is_some_and(|n| n != items.len() as u64) {
                    let found = items.len();
                    let message = format!("{} must be {}, not {found}", last(path), wanted(target));
                    self.report(Kind::WrongType, span, message, advice);
                }
                for (i, item) in items.iter().enumerate() {
                    self.value(&format!("{path}[{i}]"), &target["items"], &around, item);
                }
            }
            ("number", DeValue::Float(_) | DeValue::Integer(_)) => {
                self.number(path, target, &around, value);
            }
            ("integer", DeValue::Integer(_)) => self.number(path, target, &around, value),
            ("string", DeValue::String(_)) | ("boolean", DeValue::Boolean(_)) => {}
            (kind, found) => {
                let fraction = kind == "integer" && matches!(found, DeValue::Float(_));
                let found = if fraction {
                    "a number with a fraction"
                } else {
                    name_of_type(found)
                };
                let message = format!("{} must be {}, not {found}", last(path), wanted(target));
                self.report(Kind::WrongType, span, message, advice);
            }
        }
    }

    fn number(
        &mut self,
        path: &str,
        schema: &Value,
        around: &Around,
        value: &Spanned<DeValue<'_>>,
    ) {
        let advice = around.advice.as_str();
        let smallest = if around.any_size { 0.0 } else { SMALLEST };
        let must = format!("{} must be {}", last(path), wanted(schema));
        let x = match value.get_ref() {
            DeValue::Float(float) => float.as_str().parse::<f64>().unwrap_or(f64::NAN),
            // TOML promises 64 bits for integers; larger ones are numbers all the same, but must be written as such
            DeValue::Integer(digits) => {
                match i64::from_str_radix(digits.as_str(), digits.radix()) {
                    Ok(whole) => whole as f64,
                    Err(_) => {
                        let message =
                            format!("{} has more digits than a whole number can", last(path));
                        let help = "write it with a decimal point or an exponent, such as 1.0e20";
                        return self.report(Kind::OutOfRange, value.span(), message, help);
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
            self.report(Kind::NotFinite, value.span(), must, advice);
        } else if low || high {
            self.report(Kind::OutOfRange, value.span(), must, advice);
        } else if x != 0.0 && !(smallest..=LARGEST).contains(&x.abs()) {
            let least = if around.any_size {
                format!("at most {LARGEST:e}")
            } else {
                format!("0 or between {SMALLEST:e} and {LARGEST:e}")
            };
            let message = format!("{} must be {least} in size", last(path));
            let help = "choose units in which the numbers of the scene are nearer to 1";
            self.report(Kind::OutOfRange, value.span(), message, help);
        }
    }

    fn word(&mut self, path: &str, words: &[&str], value: &Spanned<DeValue<'_>>) {
        let all = words
            .iter()
            .map(|word| format!("\"{word}\""))
            .collect::<Vec<_>>()
            .join(", ");
        let DeValue::String(word) = value.get_ref() else {
            let found = name_of_type(value.get_ref());
            let message = format!("{} must be one of {all}, not {found}", last(path));
            return self.report(Kind::WrongType, value.span(), message, "write it in quotes");
        };
        if words.contains(&word.as_ref()) {
            return;
        }
        let message = format!("unknown word \"{word}\" for {}", last(path));
        let help = with_guess(word, words.iter().copied(), &format!("known are {all}"));
        self.report(Kind::WrongType, value.span(), message, help);
    }

    fn table(&mut self, path: &str, schema: &'s Value, table: &DeTable<'_>, span: Range<usize>) {
        let known = &schema["properties"];
        for (key, value) in table {
            let inner = join(path, key.get_ref());
            if let Some(property) = known.get(key.get_ref().as_ref()) {
                self.value(&inner, property, &Around::default(), value);
            } else {
                self.unknown_key(path, (key, value), keys(known));
            }
        }
        for key in list(&schema["required"]).iter().filter_map(Value::as_str) {
            if !table.contains_key(key) {
                let property = known.get(key).unwrap_or(&Value::Null);
                let target = target(self.schema, property);
                let message = format!("{} must have `{key}`, {}", header(path), wanted(target));
                let help = advice(property, target);
                let problem = missing(span.clone(), message, help);
                self.report_at(problem.wanting(join(path, key)));
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
                self.value(&inner, schema, &Around::default(), value);
            } else {
                let known = variants.iter().map(|(name, _)| *name).collect();
                self.unknown_key(path, (key, value), known);
                continue;
            }
            named.push(key.span());
            laws.push((key.span().start, key.get_ref().to_string()));
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
            self.report_at(problem);
        } else if named.is_empty() && table.is_empty() {
            let known: Vec<&str> = variants.iter().map(|(name, _)| *name).collect();
            let message = format!("{} names no law", header(path));
            let help = format!("known are {}", quoted(&known));
            self.report_at(missing(span, message, help));
        }
    }

    fn unknown_key(&mut self, path: &str, (key, value): Entry<'_, '_>, known: Vec<&str>) {
        let word = key.get_ref();
        let top = keys(&self.schema["properties"]);
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
        self.report(Kind::UnknownKey, key.span(), message, help);
    }

    fn report(
        &mut self,
        kind: Kind,
        span: Range<usize>,
        message: impl Into<String>,
        help: impl Into<String>,
    ) {
        self.report_at(Diagnostic::new(kind, span, message, help));
    }

    fn report_at(&mut self, problem: Diagnostic) {
        self.problems.push(problem);
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
