//! Documents: text, tables with ids and units, figures as plain points, replays.

use super::Replay;
use serde::Serialize;

/// What a study ends in: a first page and the pages that it links to.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Document {
    /// Kebab-case, unique among the pages: file name and anchor.
    pub id: String,
    /// What stands before everything else because the user asked to stop before it had finished: one sentence with the words
    /// `stopped early`; `None` where nothing was left out for that reason.
    pub stopped_early: Option<String>,
    /// Title.
    pub title: String,
    /// The sentence a person came for; empty if there is none.
    pub lead: String,
    /// Contents in order.
    pub blocks: Vec<Block>,
    /// Further pages, each linked from a [`Cell::Page`] or listed at the end.
    pub pages: Vec<Document>,
}

/// One piece of a page.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Block {
    /// A section title.
    Heading(String),
    /// A paragraph.
    Text(String),
    /// Lines of equal rank.
    List(Vec<String>),
    /// A command that a reader can run, as typed.
    Command(String),
    /// A table.
    Table(Table),
    /// A picture with its numbers.
    Figure(Figure),
    /// A scene as every engine ran it, to be played.
    Replay(Box<Replay>),
}

/// A table. Every row has one cell a column.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Table {
    /// Kebab-case, unique in the document: anchor and CSV file name.
    pub id: String,
    /// Title; may be empty.
    pub title: String,
    /// Columns, with units in the heading.
    pub columns: Vec<Column>,
    /// Rows.
    pub rows: Vec<Vec<Cell>>,
    /// What a reader must know to read it; may be empty.
    pub note: String,
}

/// One column.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Column {
    /// Kebab-case: key in JSON and CSV.
    pub key: String,
    /// Heading.
    pub title: String,
    /// Unit; empty for none.
    pub unit: String,
    /// Alignment.
    pub align: Align,
}

/// Alignment of a column.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Align {
    /// Words.
    Left,
    /// Numbers.
    Right,
}

/// One cell. A number keeps all its digits; how many are shown is for the writer and this hint.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Cell {
    /// There is no value. Not 0.
    Empty,
    /// Words.
    Text(String),
    /// A number shown with three significant digits.
    Number(f64),
    /// A number shown with this many digits after the point.
    Fixed(f64, u8),
    /// A whole number.
    Count(u64),
    /// A number with three significant digits and its owner in brackets: `1.23 (7)`.
    Owned(f64, String),
    /// A few words that judge; the words carry the meaning, the tone only points at them.
    Verdict(Tone, String),
    /// A link to a page of the document: its id and the words to show.
    Page(String, String),
    /// A small picture.
    Picture(Box<Figure>),
}

/// What a verdict means to a reader who only glances.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Tone {
    /// As it should be.
    Good,
    /// Worth a look.
    Notice,
    /// Not as it should be.
    Bad,
    /// Says nothing either way, such as an engine that could not run.
    Quiet,
}

/// A picture as plain points.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Figure {
    /// Kebab-case, unique in the document.
    pub id: String,
    /// Title.
    pub title: String,
    /// What to see in it.
    pub caption: String,
    /// Horizontal axis.
    pub x: Axis,
    /// Vertical axis.
    pub y: Axis,
    /// True for a picture of the table: one unit is equally long on both axes. A tall one is laid on its side, y to the right.
    pub equal_scale: bool,
    /// A rectangle to draw, such as the table: smallest and largest corner.
    pub outline: Option<[[f64; 2]; 2]>,
    /// Curves and points.
    pub series: Vec<Series>,
    /// Times or places to mark with a line across the horizontal axis.
    pub marks: Vec<Mark>,
}

/// One axis.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Axis {
    /// What it measures.
    pub label: String,
    /// Unit; empty for none.
    pub unit: String,
    /// Logarithmic; points at or below zero are left out and counted in the caption by the writer.
    pub log: bool,
    /// Words in place of numbers: the first stands at 1, the second at 2; on a vertical axis from the top down. Empty for numbers.
    pub names: Box<[String]>,
}

impl Axis {
    /// A linear axis.
    pub fn linear(label: &str, unit: &str) -> Self {
        Axis {
            label: label.to_owned(),
            unit: unit.to_owned(),
            log: false,
            names: Box::default(),
        }
    }

    /// An axis of words.
    pub fn of_names(label: &str, names: Vec<String>) -> Self {
        Axis {
            names: names.into(),
            ..Axis::linear(label, "")
        }
    }

    /// The words at a place of an axis of words.
    pub fn name_at(&self, place: f64) -> Option<&str> {
        let inside = place >= 1.0 && place <= self.names.len() as f64 && place.fract() == 0.0;
        inside.then(|| self.names[place as usize - 1].as_str())
    }

    /// A logarithmic axis.
    pub fn log(label: &str, unit: &str) -> Self {
        Axis {
            log: true,
            ..Axis::linear(label, unit)
        }
    }
}

/// One curve, or one set of points.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Series {
    /// Name in the legend. Series that share a name share a colour and one legend entry; one without a name is drawn in grey
    /// and has no entry.
    pub name: String,
    /// Points in order, x and y in the units of the axes. A NaN interrupts a line.
    pub points: Vec<[f64; 2]>,
    /// How it is drawn.
    pub style: Style,
}

/// How a series is drawn. Each can be told apart in black and white.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Style {
    /// A line, with dashes and signs of its own where there are several.
    Line,
    /// Points.
    Points,
    /// Rings, to go around points that need a warning.
    Rings,
    /// Large crosses, for what has no proper place: a run that failed.
    Crosses,
    /// Circles of this radius in the units of the axes, as balls on a table.
    Discs(f64),
    /// The name of the series, written at each of its points; it has no legend entry.
    Words,
    /// A thin line to hold others against, its name written at its end instead of in the legend.
    Guide,
    /// A broad pale line below all others, such as the front of what is best.
    Band,
    /// Fields of a matrix: a square of one unit around each point, and a sign in it.
    Tiles(Sign),
}

/// What a field of a matrix looks like: the more ink, the more it asks for attention.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Sign {
    /// A small dot on a pale field.
    Dot,
    /// A triangle on a field in a middle shade.
    Triangle,
    /// A cross on a dark field.
    Cross,
    /// A ring on an empty field.
    Ring,
    /// A dash on an empty field.
    Dash,
}

/// A vertical line with a few words.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Mark {
    /// Where, in units of the horizontal axis.
    pub at: f64,
    /// Words; may be empty for a minor mark.
    pub label: String,
}

impl Column {
    /// A column of words.
    pub fn words(key: &str, title: &str) -> Self {
        Column {
            key: key.to_owned(),
            title: title.to_owned(),
            unit: String::new(),
            align: Align::Left,
        }
    }

    /// A column of numbers; `unit` is empty for counts and ratios.
    pub fn number(key: &str, title: &str, unit: &str) -> Self {
        Column {
            align: Align::Right,
            unit: unit.to_owned(),
            ..Column::words(key, title)
        }
    }
}

impl Cell {
    /// A number, or empty.
    pub fn maybe(value: Option<f64>) -> Self {
        value.map_or(Cell::Empty, Cell::Number)
    }

    /// Words.
    pub fn text(words: impl Into<String>) -> Self {
        Cell::Text(words.into())
    }

    /// Words that judge.
    pub fn verdict(tone: Tone, words: impl Into<String>) -> Self {
        Cell::Verdict(tone, words.into())
    }
}
