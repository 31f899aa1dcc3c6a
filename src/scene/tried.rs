//! What a scene wants tried: an engine by name and settings, read once from a line of its `try`.

use super::diagnostics::{Diagnostic, Kind};
use super::kebab_case::is_kebab_case;
use super::located::Located;
use super::problems::Problems;
use serde::{Serialize, Serializer};
use std::collections::BTreeMap;
use std::fmt;
use std::str::FromStr;
use thiserror::Error;

/// An engine with settings that a scene wants tried besides the presets: `stepper dt=0.1`.
///
/// Which engines there are, and which settings they know, is not for a scene to say.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Tried {
    written: String,
    engine: String,
    values: BTreeMap<String, String>,
}

/// Why a line is nothing that can be tried.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum TriedError {
    /// It is not an engine and its settings.
    #[error("try must hold an engine and its settings, as ENGINE KEY=VALUE ...")]
    Form,
    /// One key has two values.
    #[error("`{key}` is set twice")]
    Twice {
        /// The key.
        key: String,
    },
}

impl Tried {
    /// Id of the engine, kebab-case.
    pub fn engine(&self) -> &str {
        &self.engine
    }

    /// Values as written, by key.
    pub fn values(&self) -> &BTreeMap<String, String> {
        &self.values
    }
}

impl FromStr for Tried {
    type Err = TriedError;

    fn from_str(line: &str) -> Result<Self, TriedError> {
        let mut words = line.split_whitespace();
        let engine = words.next().filter(|word| is_kebab_case(word));
        let engine = engine.ok_or(TriedError::Form)?.to_owned();
        let mut values = BTreeMap::new();
        for word in words {
            let pair = word.split_once('=');
            let pair = pair.filter(|(key, value)| !key.is_empty() && !value.is_empty());
            let (key, value) = pair.ok_or(TriedError::Form)?;
            if values.insert(key.to_owned(), value.to_owned()).is_some() {
                let key = key.to_owned();
                return Err(TriedError::Twice { key });
            }
        }
        Ok(Tried {
            written: line.to_owned(),
            engine,
            values,
        })
    }
}

/// The line as written.
impl fmt::Display for Tried {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.written)
    }
}

/// The line as written, so that the fingerprint of a scene is that of its file.
impl Serialize for Tried {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(&self.written)
    }
}

/// What the lines of a file's `try` say; of one that says nothing, its error with its place.
pub(super) fn tried(lines: &[String], at: &Located<'_>, problems: &mut Problems) -> Vec<Tried> {
    let mut all = Vec::new();
    for (i, line) in lines.iter().enumerate() {
        match line.parse() {
            Ok(tried) => all.push(tried),
            Err(error) => {
                let (kind, help) = match &error {
                    TriedError::Form => (Kind::BadName, "such as `try = [\"stepper dt=0.1\"]`"),
                    TriedError::Twice { .. } => (Kind::Duplicate, "remove one of them"),
                };
                let span = at.value(&format!("try[{i}]"));
                problems.push(Diagnostic::new(kind, span, error.to_string(), help));
            }
        }
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_is_an_engine_and_values_by_key_and_is_kept_as_written() {
        let line = "an-engine  b=2 a=x=y";
        let tried: Tried = line.parse().unwrap_or_else(|error| panic!("{error}"));
        assert_eq!(tried.engine(), "an-engine");
        let values: Vec<(&str, &str)> = tried
            .values()
            .iter()
            .map(|(key, value)| (key.as_str(), value.as_str()))
            .collect();
        assert_eq!(values, [("a", "x=y"), ("b", "2")]);
        assert_eq!(tried.to_string(), line);
        assert_eq!(serde_json::json!(tried), line);
    }

    #[test]
    fn anything_else_is_none() {
        let twice = TriedError::Twice { key: "a".into() };
        for (line, error) in [
            ("", TriedError::Form),
            ("a=1", TriedError::Form),
            ("An-Engine a=1", TriedError::Form),
            ("an-engine a", TriedError::Form),
            ("an-engine =1", TriedError::Form),
            ("an-engine a=", TriedError::Form),
            ("an-engine a=1 b=2 a=1", twice),
        ] {
            assert_eq!(line.parse::<Tried>(), Err(error), "{line}");
        }
    }
}
