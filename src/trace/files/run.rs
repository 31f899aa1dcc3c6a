//! `run.json`: where a trace comes from, how it ended, and its extrema. Balls are named by id, as in the other files.

use super::{FileError, ball_index, id_of, number};
use crate::trace::{Ending, Extrema, Extremum, Provenance, Spot, Trace};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// The keys of `run.json`, in order. Only `stopped_early`, `parameters`, `ulp` (of f64 then) and `counters` may be left out.
#[derive(Serialize, Deserialize)]
struct RunFile {
    /// Only where it is true: the ending says the same, this key is what every command says it by.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    stopped_early: bool,
    engine: String,
    version: String,
    #[serde(default)]
    parameters: BTreeMap<String, serde_json::Value>,
    scene: String,
    scene_hash: String,
    #[serde(with = "number::finite")]
    resolution: f64,
    #[serde(with = "number::finite")]
    rest_speed: f64,
    #[serde(default = "double", with = "number::finite")]
    ulp: f64,
    ending: EndingEntry,
    #[serde(with = "number::finite")]
    end_time: f64,
    #[serde(default)]
    counters: BTreeMap<String, u64>,
    extrema: ExtremaEntry,
}

/// The scalar of a run that does not name it.
fn double() -> f64 {
    f64::EPSILON
}

/// An ending: its kind, and its place for the kinds that have one.
#[derive(Serialize, Deserialize)]
struct EndingEntry {
    kind: String,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    spot: Option<SpotEntry>,
}

#[derive(Serialize, Deserialize)]
struct SpotEntry {
    #[serde(with = "number::finite")]
    time: f64,
    balls: Vec<String>,
    why: String,
}

#[derive(Serialize, Deserialize)]
struct ExtremaEntry {
    energy_gained: ExtremumEntry,
    momentum: ExtremumEntry,
    overlap: ExtremumEntry,
    outside: ExtremumEntry,
    displaced: ExtremumEntry,
}

#[derive(Serialize, Deserialize)]
struct ExtremumEntry {
    #[serde(with = "number")]
    value: f64,
    #[serde(with = "number::finite")]
    time: f64,
    ball: Option<String>,
    other: Option<String>,
}

/// Everything of a trace that `run.json` holds.
pub struct RunPart {
    pub provenance: Provenance,
    pub extrema: Extrema,
    pub counters: BTreeMap<String, u64>,
    pub ending: Ending,
    pub end_time: f64,
}

/// The text of `run.json`.
pub fn write(trace: &Trace) -> Result<String, FileError> {
    let extremum = |e: &Extremum| -> Result<ExtremumEntry, FileError> {
        let id = |ball: Option<u32>| ball.map(|i| id_of(trace, i).map(str::to_owned)).transpose();
        Ok(ExtremumEntry {
            value: e.value,
            time: e.time,
            ball: id(e.ball)?,
            other: id(e.other)?,
        })
    };
    let spot = |spot: &Spot| -> Result<SpotEntry, FileError> {
        let ids = spot
            .balls
            .iter()
            .map(|&i| id_of(trace, i).map(str::to_owned));
        Ok(SpotEntry {
            time: spot.time,
            balls: ids.collect::<Result<_, _>>()?,
            why: spot.why.clone(),
        })
    };
    let (provenance, extrema) = (&trace.provenance, &trace.extrema);
    let file = RunFile {
        stopped_early: trace.ending == Ending::Cancelled,
        engine: provenance.engine.clone(),
        version: provenance.version.clone(),
        parameters: provenance.parameters.clone(),
        scene: provenance.scene.clone(),
        scene_hash: provenance.scene_hash.clone(),
        resolution: provenance.resolution,
        rest_speed: provenance.rest_speed,
        ulp: provenance.ulp,
        ending: EndingEntry {
            kind: trace.ending.id().to_owned(),
            spot: trace.ending.spot().map(spot).transpose()?,
        },
        end_time: trace.end_time,
        counters: trace.counters.clone(),
        extrema: ExtremaEntry {
            energy_gained: extremum(&extrema.energy_gained)?,
            momentum: extremum(&extrema.momentum)?,
            overlap: extremum(&extrema.overlap)?,
            outside: extremum(&extrema.outside)?,
            displaced: extremum(&extrema.displaced)?,
        },
    };
    let text = serde_json::to_string_pretty(&file).map_err(|error| FileError::Unwritable {
        problem: error.to_string(),
    })?;
    Ok(text + "\n")
}

/// Reads `run.json`; `balls`: the ids that `final.csv` names.
pub fn read(text: &str, balls: &[String]) -> Result<RunPart, FileError> {
    let file: RunFile = serde_json::from_str(text).map_err(|error| {
        let place = format!(" at line {} column {}", error.line(), error.column());
        FileError::Run {
            line: error.line(),
            column: error.column(),
            problem: error.to_string().replace(&place, ""),
        }
    })?;
    let extrema = file.extrema;
    let extremum = |key: &str, e: ExtremumEntry| -> Result<Extremum, FileError> {
        let index = |id: Option<String>| id.map(|id| ball_index(balls, &id)).transpose();
        let key = format!("extrema.{key}");
        let index = |id| {
            index(id).map_err(|problem| FileError::Value {
                key: key.clone(),
                problem,
            })
        };
        Ok(Extremum {
            value: e.value,
            time: e.time,
            ball: index(e.ball)?,
            other: index(e.other)?,
        })
    };
    let ending = ending(file.ending, balls)?;
    if file.stopped_early && ending != Ending::Cancelled {
        return Err(FileError::Value {
            key: "stopped_early".to_owned(),
            problem: format!("true, but the run ended as {}", ending.id()),
        });
    }
    Ok(RunPart {
        extrema: Extrema {
            energy_gained: extremum("energy_gained", extrema.energy_gained)?,
            momentum: extremum("momentum", extrema.momentum)?,
            overlap: extremum("overlap", extrema.overlap)?,
            outside: extremum("outside", extrema.outside)?,
            displaced: extremum("displaced", extrema.displaced)?,
        },
        provenance: Provenance {
            engine: file.engine,
            version: file.version,
            parameters: file.parameters,
            scene: file.scene,
            scene_hash: file.scene_hash,
            resolution: file.resolution,
            rest_speed: file.rest_speed,
            ulp: file.ulp,
        },
        counters: file.counters,
        ending,
        end_time: file.end_time,
    })
}

fn ending(entry: EndingEntry, balls: &[String]) -> Result<Ending, FileError> {
    let wrong = |problem: String| FileError::Value {
        key: "ending".to_owned(),
        problem,
    };
    let spot = match entry.spot {
        None => None,
        Some(spot) => {
            let indices = spot.balls.iter().map(|id| ball_index(balls, id));
            Some(Spot {
                time: spot.time,
                balls: indices.collect::<Result<_, _>>().map_err(wrong)?,
                why: spot.why,
            })
        }
    };
    match (entry.kind.as_str(), spot) {
        ("rest", None) => Ok(Ending::Rest),
        ("duration", None) => Ok(Ending::Duration),
        ("cancelled", None) => Ok(Ending::Cancelled),
        ("budget", Some(spot)) => Ok(Ending::Budget(spot)),
        ("indeterminate", Some(spot)) => Ok(Ending::Indeterminate(spot)),
        ("undecidable", Some(spot)) => Ok(Ending::Undecidable(spot)),
        ("collapsed", Some(spot)) => Ok(Ending::Collapsed(spot)),
        ("not-finite", Some(spot)) => Ok(Ending::NotFinite(spot)),
        (kind, _) => Err(wrong(format!(
            "kind `{kind}`: expected rest, duration or cancelled without a spot, or budget, indeterminate, \
             undecidable, collapsed or not-finite with one"
        ))),
    }
}
