//! Settings of an engine: what `--set KEY=VALUE` gives, read into the engine's own serde struct.

use super::Refusal;
use schemars::JsonSchema;
use serde::{Serialize, de::DeserializeOwned};
use serde_json::{Map, Value};
use std::collections::BTreeMap;
use std::fmt;

/// Keys and values given for one engine; empty means every default.
#[derive(Clone, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Setting {
    /// Values as written, by key.
    pub values: BTreeMap<String, String>,
}

/// One key of `--set`.
#[derive(Clone, Debug, PartialEq)]
pub struct Knob {
    /// The key.
    pub key: String,
    /// Default, as text.
    pub default: String,
    /// Meaning, unit and effect; for a choice also its words.
    pub what: String,
}

impl Setting {
    /// Reads `KEY=VALUE` pairs. A key given twice, or a pair without `=`, is an error.
    pub fn parse<'a>(pairs: impl IntoIterator<Item = &'a str>) -> Result<Self, Refusal> {
        let mut values = BTreeMap::new();
        for pair in pairs {
            let Some((key, value)) = pair.split_once('=') else {
                return Err(refuse(format!("`{pair}` is not KEY=VALUE")));
            };
            let (key, value) = (key.trim().to_owned(), value.trim().to_owned());
            if values.insert(key.clone(), value).is_some() {
                return Err(refuse(format!("`{key}` is set twice")));
            }
        }
        Ok(Setting { values })
    }

    /// The same setting with one key added or replaced.
    pub fn with(mut self, key: &str, value: impl ToString) -> Self {
        self.values.insert(key.to_owned(), value.to_string());
        self
    }

    /// Reads the setting into an engine's struct `S`, starting from its defaults.
    ///
    /// `S` is a flat struct of numbers, booleans and words. An unknown key is answered with the known ones.
    pub fn read<S: Serialize + DeserializeOwned + Default>(&self) -> Result<S, Refusal> {
        self.read_over(&S::default())
    }

    /// Reads the setting into an engine's struct `S`, starting from `defaults`: how a preset supplies the values of the keys
    /// that are not given.
    pub fn read_over<S: Serialize + DeserializeOwned>(&self, defaults: &S) -> Result<S, Refusal> {
        let untouched = fields_of(defaults);
        let mut fields = untouched.clone();
        for (key, text) in &self.values {
            let Some(default) = untouched.get(key) else {
                let known: Vec<&str> = untouched.keys().map(String::as_str).collect();
                return Err(refuse(format!(
                    "unknown setting `{key}`; known are {}",
                    known.join(", ")
                )));
            };
            let value = value_like(default, key, text)?;
            // each key by itself first, so that the answer names it
            let mut alone = untouched.clone();
            alone.insert(key.clone(), value.clone());
            if let Err(error) = serde_json::from_value::<S>(Value::Object(alone)) {
                return Err(refuse(format!("`{key}={text}`: {error}")));
            }
            fields.insert(key.clone(), value);
        }
        serde_json::from_value(Value::Object(fields)).map_err(|error| refuse(error.to_string()))
    }
}

/// The fields of a settings struct, by key.
fn fields_of<S: Serialize>(settings: &S) -> Map<String, Value> {
    match serde_json::to_value(settings) {
        Ok(Value::Object(fields)) => fields,
        _ => Map::new(),
    }
}

/// Every effective parameter of a settings struct, by key.
pub fn parameters<S: Serialize>(settings: &S) -> BTreeMap<String, Value> {
    fields_of(settings).into_iter().collect()
}

/// The knobs of a settings struct: keys and defaults from its serialisation, meaning from its comments.
pub fn knobs_of<S: Serialize + Default + JsonSchema>() -> Vec<Knob> {
    let schema = schemars::schema_for!(S);
    let described = |key: &str| {
        let property = schema.pointer(&format!("/properties/{key}"));
        let text = property
            .and_then(|p| p.get("description"))
            .and_then(Value::as_str)
            .unwrap_or_default();
        text.split_whitespace().collect::<Vec<_>>().join(" ")
    };
    let knob = |(key, value): (String, Value)| Knob {
        what: described(&key),
        default: plain(&value),
        key,
    };
    fields_of(&S::default()).into_iter().map(knob).collect()
}

/// A value as it is written after `=`.
fn plain(value: &Value) -> String {
    match value {
        Value::String(word) => word.clone(),
        other => other.to_string(),
    }
}

/// Reads `text` as the same type as the default `field`.
fn value_like(field: &Value, key: &str, text: &str) -> Result<Value, Refusal> {
    let wrong = |wanted: &str| refuse(format!("`{key}={text}`: expected {wanted}"));
    match field {
        Value::Bool(_) => text
            .parse()
            .map(Value::Bool)
            .map_err(|_| wrong("true or false")),
        Value::Number(n) if n.is_u64() => text
            .parse::<u64>()
            .map(Value::from)
            .map_err(|_| wrong("a whole number, 0 or more")),
        Value::Number(_) => match text.parse::<f64>() {
            Ok(number) if number.is_finite() => Ok(Value::from(number)),
            _ => Err(wrong("a finite number")),
        },
        _ => Ok(Value::String(text.to_owned())),
    }
}

/// A refusal because of a setting.
pub fn refuse(message: String) -> Refusal {
    Refusal::Setting { message }
}

impl fmt::Display for Setting {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let pairs: Vec<String> = self
            .values
            .iter()
            .map(|(key, value)| format!("{key}={value}"))
            .collect();
        f.write_str(&pairs.join(" "))
    }
}
