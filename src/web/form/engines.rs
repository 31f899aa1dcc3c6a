//! Which engines run, with which step: boxes to tick, one step an engine that has one, and a line for anything else.

use crate::engine::{ENGINES, Refusal};
use crate::oracle;
use crate::scene::Scene;
use crate::study::Column;
use crate::study::compare::{default_columns, plan};
use crate::web::encoding::Pairs;
use crate::web::problem::Problem;

/// Name of the boxes.
pub const ENGINE: &str = "engine";

/// Name of the line for any other engine and setting.
pub const MORE: &str = "more-engines";

/// What the name of a field for a step begins with; the engine's id follows.
pub const STEP: &str = "dt.";

/// Most columns of one comparison.
const MOST_COLUMNS: usize = 12;

/// The part of the form about engines.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Engines {
    /// Boxes, ticked or not.
    pub boxes: Vec<Tick>,
    /// Steps.
    pub steps: Vec<Step>,
    /// Any other engines, as in `carom compare --engines`.
    pub more: String,
}

/// One engine with a setting that is always offered.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Tick {
    /// As in `carom compare --engines`.
    pub spec: String,
    /// Engine and setting.
    pub label: String,
    /// How it solves in time.
    pub method: &'static str,
    /// Whether it is ticked.
    pub ticked: bool,
}

/// The step of one engine.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Step {
    /// Id of the engine.
    pub engine: &'static str,
    /// What it means.
    pub meaning: String,
    /// As typed.
    pub value: String,
}

impl Engines {
    /// The fields about engines among `fields`, which are taken out; all default engines where none is named.
    pub fn taken_from(fields: &mut Pairs) -> Self {
        let named: Vec<String> = fields.all(ENGINE).map(str::to_owned).collect();
        fields.take(ENGINE);
        let boxes = plan(&default_columns()).into_iter().map(|column| {
            let spec = spec(&column);
            Tick {
                // the exact engine is what the others are held against: it always runs
                ticked: named.is_empty() || named.contains(&spec) || spec == oracle::engine().id(),
                label: column.label(),
                method: column.engine.about().method,
                spec,
            }
        });
        let boxes: Vec<Tick> = boxes.collect();
        let steps = ENGINES.iter().filter_map(|engine| {
            let knob = engine.knobs().into_iter().find(|knob| knob.key == "dt")?;
            let typed = fields.take(&format!("{STEP}{}", engine.id()));
            Some(Step {
                engine: engine.id(),
                meaning: knob.what,
                value: typed.unwrap_or(knob.default),
            })
        });
        let steps = steps.collect();
        let other = |spec: &&String| !boxes.iter().any(|known| known.spec == **spec);
        let mut more: Vec<String> = named.iter().filter(other).cloned().collect();
        more.extend(fields.take(MORE).filter(|more| !more.trim().is_empty()));
        Engines {
            boxes,
            steps,
            more: more.join(","),
        }
    }

    /// The columns that run `scene`. Errors: at the field that is wrong.
    ///
    /// An engine that cannot run the scene is an answer, not an error; so is one that refuses a setting, as in `carom compare`. A step
    /// that an engine does not understand is a mistake at its field.
    pub fn columns(&self, scene: &Scene) -> Result<Vec<Column>, Problem> {
        let ticked = self.boxes.iter().filter(|known| known.ticked);
        let mut columns = Vec::new();
        for known in ticked {
            columns.extend(listed(&known.spec, ENGINE)?);
        }
        for column in &mut columns {
            let id = column.engine.id();
            let knobs = column.engine.knobs();
            let default = knobs.iter().find(|knob| knob.key == "dt");
            let typed = self.steps.iter().find(|step| step.engine == id);
            let Some((typed, default)) = typed.zip(default) else {
                continue;
            };
            if typed.value.trim() == default.default {
                continue;
            }
            column.setting = column.setting.clone().with("dt", typed.value.trim());
            match column.engine.pace(scene, &column.setting) {
                Err(Refusal::Setting { message }) if message.starts_with("`dt=") => {
                    let field = format!("{STEP}{id}");
                    return Err(Problem::at(&field, message, typed.meaning.clone()));
                }
                _ => {}
            }
        }
        if !self.more.trim().is_empty() {
            columns.extend(listed(&self.more, MORE)?);
        }
        counted(columns)
    }
}

/// The columns of a list as `carom compare --engines` takes it.
pub fn columns(list: &str) -> Result<Vec<Column>, Problem> {
    counted(plan(&listed(list, "engines")?))
}

fn listed(list: &str, field: &str) -> Result<Vec<Column>, Problem> {
    let help = "such as stepper,rapier-f64:preset=stock:dt=1e-3";
    Column::list(list).map_err(|why| Problem::at(field, why, help))
}

/// The same columns, if there are not too many and each is there once.
fn counted(columns: Vec<Column>) -> Result<Vec<Column>, Problem> {
    if columns.len() > MOST_COLUMNS {
        let message = format!("{} engines are too many for one page", columns.len());
        let help = format!("{MOST_COLUMNS} are the most");
        return Err(Problem::at(MORE, message, help));
    }
    for (i, column) in columns.iter().enumerate() {
        let label = column.label();
        if columns[..i].iter().any(|known| known.label() == label) {
            let message = format!("`{label}` is listed twice");
            let help = "name each engine and setting once";
            return Err(Problem::at(MORE, message, help));
        }
    }
    Ok(columns)
}

/// `--engines LIST` for these columns, with a space before it; nothing for those that run where none is named.
pub fn as_argument<'c>(columns: impl Iterator<Item = &'c Column>) -> String {
    let specs: Vec<String> = columns.map(spec).collect();
    let default: Vec<String> = plan(&default_columns()).iter().map(spec).collect();
    match specs == default {
        true => String::new(),
        false => format!(" --engines {}", specs.join(",")),
    }
}

fn spec(column: &Column) -> String {
    let setting = column.setting.to_string();
    let parts = setting.split_whitespace();
    parts.fold(column.engine.id().to_owned(), |spec, part| {
        format!("{spec}:{part}")
    })
}
