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
    /// The words of a choice; empty for a number.
    pub choices: Vec<String>,
    /// What it is to a study.
    pub role: KnobRole,
}

/// What a knob is to a study.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum KnobRole {
    /// The engine's step, s.
    Step,
    /// It stands for the defaults of other knobs and has no effect of its own.
    Preset,
    /// Any other.
    #[default]
    Plain,
}

impl Setting {
    /// Reads `KEY=VALUE` pairs. A key given twice, or a pair without `=`, is an error.
    pub fn parse<'a>(pairs: impl IntoIterator<Item = &'a str>) -> Result<Self, Refusal> {
        let mut values = BTreeMap::new();
        for pair in pairs {
            let Some((key, value)) = pair.split_once('=') else {
                return Err(refuse(None, format!("`{pair}` is not KEY=VALUE")));
            };
            let (key, value) = (key.trim().to_owned(), value.trim().to_owned());
            if values.insert(key.clone(), value).is_some() {
                let message = format!("`{key}` is set twice");
                return Err(refuse(Some(&key), message));
            }
        }
        Ok(Setting { values })
    }

    /// The same setting with one key added or replaced.
    pub fn with(mut self, key: &str, value: impl ToString) -> Self {
        self.values.insert(key.to_owned(), value.to_string());
        self
    }

    /// What is set besides `other`; `None` where something of it is not set, or to another value.
    pub fn besides(&self, other: &Setting) -> Option<Setting> {
        let mut rest = self.clone();
        for (key, value) in &other.values {
            if rest.values.remove(key).as_ref() != Some(value) {
                return None;
            }
        }
        Some(rest)
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
                let message = format!("unknown setting `{key}`; known are {}", known.join(", "));
                return Err(refuse(Some(key), message));
            };
            let value = value_like(default, key, text)?;
            // each key by itself first, so that the answer names it
            let mut alone = untouched.clone();
            alone.insert(key.clone(), value.clone());
            if let Err(error) = serde_json::from_value::<S>(Value::Object(alone)) {
                return Err(refuse(Some(key), format!("`{key}={text}`: {error}")));
            }
            fields.insert(key.clone(), value);
        }
        serde_json::from_value(Value::Object(fields))
            .map_err(|error| refuse(None, error.to_string()))
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

/// The knobs of a settings struct: keys and defaults from its serialisation, meaning and choices from its schema. `roles`: of those
/// that are not plain.
pub fn knobs_of<S: Serialize + Default + JsonSchema>(roles: &[(&str, KnobRole)]) -> Vec<Knob> {
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
        choices: choices(schema.as_value(), &key),
        role: (roles.iter().find(|(of, _)| *of == key)).map_or(KnobRole::Plain, |(_, role)| *role),
        default: plain(&value),
        key,
    };
    fields_of(&S::default()).into_iter().map(knob).collect()
}

/// The words of a choice among the properties of a schema; empty for any other property.
fn choices(schema: &Value, key: &str) -> Vec<String> {
    let named = |reference: &Value| {
        let name = reference.as_str()?.strip_prefix('#')?;
        schema.pointer(name)
    };
    let property = schema.pointer(&format!("/properties/{key}"));
    let choice = property.and_then(|property| property.get("$ref").map_or(Some(property), named));
    let words = |list: &Value| -> Vec<String> {
        let word = |one: &Value| one.get("const").unwrap_or(one).as_str().map(str::to_owned);
        list.as_array()
            .into_iter()
            .flatten()
            .filter_map(word)
            .collect()
    };
    let lists = ["oneOf", "enum"].into_iter();
    let lists = lists.filter_map(|list| choice?.get(list));
    lists.flat_map(words).collect()
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
    let wrong = |wanted: &str| refuse(Some(key), format!("`{key}={text}`: expected {wanted}"));
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

/// A refusal because of a setting; `key`: the one that is at fault, if a single one is.
pub fn refuse(key: Option<&str>, message: String) -> Refusal {
    Refusal::Setting {
        key: key.map(str::to_owned),
        message,
    }
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
