//! The scene format as its JSON Schema tells it: what a value is, its range, its meaning and the advice on it.
//!
//! The check of a file and the form of the live page both read the format here, so neither knows a key by name.

use serde_json::Value;

/// Keyword of a schema whose numbers may be as small as f64 holds.
pub(super) const ANY_SIZE: &str = "anySize";

/// The schema that says what a value is, behind references and `null` alternatives. `root`: the schema of the whole file.
pub fn target<'s>(root: &'s Value, mut schema: &'s Value) -> &'s Value {
    loop {
        if let Some(reference) = schema["$ref"].as_str() {
            match root.pointer(reference.trim_start_matches('#')) {
                Some(found) => schema = found,
                None => return schema,
            }
        } else if let Some(real) = list(&schema["anyOf"])
            .iter()
            .find(|choice| choice["type"] != "null")
        {
            schema = real;
        } else {
            return schema;
        }
    }
}

/// The items of a list; none for anything else.
pub fn list(value: &Value) -> &[Value] {
    value.as_array().map_or(&[], Vec::as_slice)
}

/// The keys of the `properties` of a schema.
pub fn keys(properties: &Value) -> Vec<&str> {
    let map = properties.as_object();
    map.map_or_else(Vec::new, |map| map.keys().map(String::as_str).collect())
}

/// The words of a schema that is a choice of words.
pub fn words(schema: &Value) -> Option<Vec<&str>> {
    if let Some(words) = schema["enum"].as_array() {
        return Some(words.iter().filter_map(Value::as_str).collect());
    }
    let choices = list(&schema["oneOf"]);
    let words: Vec<&str> = choices.iter().filter_map(|c| c["const"].as_str()).collect();
    (!words.is_empty() && words.len() == choices.len()).then_some(words)
}

/// The laws of a schema that is a choice of tables.
pub fn variants(schema: &Value) -> Vec<(&str, &Value)> {
    let properties = list(&schema["oneOf"])
        .iter()
        .filter_map(|choice| choice["properties"].as_object());
    properties
        .flat_map(|map| map.iter().map(|(name, law)| (name.as_str(), law)))
        .collect()
}

/// `choice` of laws, `object`, `array`, `number`, `integer`, `string` or `boolean`; empty for what the format does not have.
pub fn kind_of(schema: &Value) -> &str {
    if schema["oneOf"].is_array() {
        return "choice";
    }
    match &schema["type"] {
        Value::String(kind) => kind,
        Value::Array(kinds) => kinds
            .iter()
            .filter_map(Value::as_str)
            .find(|kind| *kind != "null")
            .unwrap_or_default(),
        _ => "",
    }
}

/// What a value must be, in words.
pub fn wanted(schema: &Value) -> String {
    match kind_of(schema) {
        "choice" => "a table with one law".to_owned(),
        "object" => "a table".to_owned(),
        "array" => match schema["minItems"].as_u64() {
            Some(n) => format!("a list of {n} numbers"),
            None => "a list".to_owned(),
        },
        "string" => "text in quotes".to_owned(),
        "boolean" => "true or false".to_owned(),
        kind => {
            let what = if kind == "integer" {
                "a whole number"
            } else {
                "a finite number"
            };
            what.to_owned() + &range(schema)
        }
    }
}

fn range(schema: &Value) -> String {
    let bound = |key: &str| schema[key].as_f64();
    match (
        bound("minimum"),
        bound("exclusiveMinimum"),
        bound("maximum"),
        bound("exclusiveMaximum"),
    ) {
        (Some(least), _, Some(most), _) => format!(" from {least} to {most}"),
        (Some(least), _, None, Some(bound)) => format!(" from {least}, less than {bound}"),
        (Some(least), _, None, None) => format!(", {least} or greater"),
        (None, Some(bound), Some(most), _) => format!(" greater than {bound}, at most {most}"),
        (None, Some(low), None, Some(high)) => format!(" greater than {low} and less than {high}"),
        (None, Some(bound), None, None) => format!(" greater than {bound}"),
        (None, None, Some(most), _) => format!(", at most {most}"),
        (None, None, None, Some(bound)) => format!(" less than {bound}"),
        (None, None, None, None) => String::new(),
    }
}

/// What a key means: its description up to the last semicolon, as one line. `target`: the schema behind its reference.
pub fn meaning(schema: &Value, target: &Value) -> String {
    let words = description(schema, target);
    let meaning = words.rsplit_once("; ").map_or(words.as_str(), |(m, _)| m);
    meaning.trim_end_matches('.').to_owned()
}

/// The advice of a description: what follows its last semicolon, else all of it.
pub fn advice(schema: &Value, target: &Value) -> String {
    let words = description(schema, target);
    let advice = words.rsplit("; ").next().unwrap_or_default();
    advice.trim_end_matches('.').to_owned()
}

/// True if a value has a description of its own, and so advice.
pub(super) fn is_described(schema: &Value, target: &Value) -> bool {
    !described(schema, target).trim().is_empty()
}

fn described<'s>(schema: &'s Value, target: &'s Value) -> &'s str {
    let own = schema["description"].as_str();
    own.or(target["description"].as_str()).unwrap_or_default()
}

fn description(schema: &Value, target: &Value) -> String {
    described(schema, target)
        .split_whitespace()
        .collect::<Vec<_>>()
        .join(" ")
}

/// A value that is right for a key where a scene does not say: what a form holds before a person changes it.
pub fn example(schema: &Value) -> Option<f64> {
    schema["examples"].get(0)?.as_f64()
}
