//! Documents that no study would write.

use carom::finding::{
    Align, Axis, Block, Cell, Column, Document, Figure, Mark, Replay, ReplayBall, ReplayDivergence,
    ReplayEvent, ReplayParting, ReplayRun, Series, Sign, Style, Table, Tone,
};
use carom::math::Vec3;
use carom::physics::State;
use carom::trace::{Knot, Path};
use proptest::prelude::*;

/// Every sign of a field.
pub const SIGNS: [Sign; 5] = [
    Sign::Dot,
    Sign::Triangle,
    Sign::Cross,
    Sign::Ring,
    Sign::Dash,
];

fn number() -> impl Strategy<Value = f64> {
    prop_oneof![
        3 => any::<f64>(),
        3 => -10.0..10.0f64,
        1 => prop::sample::select(vec![0.0, -0.0, f64::NAN, f64::INFINITY, f64::MAX, f64::MIN, 5e-324]),
    ]
}

fn words() -> impl Strategy<Value = String> {
    prop_oneof![3 => "[a-z]{0,9}( [a-z]{1,9}){0,3}", 1 => ".{0,40}", 1 => "[<>&|`*_\\[\\]\"',\\\\\n-]{0,12}", 1 => "[a-z]{120}"]
}

fn figure() -> impl Strategy<Value = Figure> {
    let axis = || {
        let names = prop_oneof![
            3 => Just(Vec::new()),
            1 => prop::collection::vec(words(), 1..5),
        ];
        (words(), words(), any::<bool>(), names).prop_map(|(label, unit, log, names)| Axis {
            label,
            unit,
            log,
            names: names.into(),
        })
    };
    let style = prop_oneof![
        Just(Style::Line),
        Just(Style::Points),
        Just(Style::Words),
        Just(Style::Rings),
        Just(Style::Crosses),
        Just(Style::Guide),
        Just(Style::Band),
        prop::sample::select(SIGNS.to_vec()).prop_map(Style::Tiles),
        number().prop_map(Style::Discs)
    ];
    let points = prop::collection::vec([number(), number()], 0..12);
    let series = (words(), points, style).prop_map(|(name, points, style)| Series {
        name,
        points,
        style,
    });
    let mark = (number(), words()).prop_map(|(at, label)| Mark { at, label });
    let outline = prop::option::of([[number(), number()], [number(), number()]]);
    (
        [words(), words(), words()],
        [axis(), axis()],
        any::<bool>(),
        outline,
        prop::collection::vec(series, 0..4),
        prop::collection::vec(mark, 0..5),
    )
        .prop_map(
            |([id, title, caption], [x, y], equal_scale, outline, series, marks)| Figure {
                id,
                title,
                caption,
                x,
                y,
                equal_scale,
                outline,
                series,
                marks,
            },
        )
}

fn cell() -> impl Strategy<Value = Cell> {
    let tone = prop::sample::select(vec![Tone::Good, Tone::Notice, Tone::Bad, Tone::Quiet]);
    prop_oneof![
        Just(Cell::Empty),
        words().prop_map(Cell::Text),
        number().prop_map(Cell::Number),
        (number(), any::<u8>()).prop_map(|(x, digits)| Cell::Fixed(x, digits)),
        any::<u64>().prop_map(Cell::Count),
        (number(), words()).prop_map(|(x, owner)| Cell::Owned(x, owner)),
        (tone, words()).prop_map(|(tone, words)| Cell::Verdict(tone, words)),
        (words(), words()).prop_map(|(id, words)| Cell::Page(id, words)),
        figure().prop_map(|figure| Cell::Picture(Box::new(figure))),
    ]
}

fn table() -> impl Strategy<Value = Table> {
    let align = prop::sample::select(vec![Align::Left, Align::Right]);
    let column = (words(), words(), words(), align).prop_map(|(key, title, unit, align)| Column {
        key,
        title,
        unit,
        align,
    });
    let columns = prop::collection::vec(column, 0..14);
    // rows of the wrong length too
    let rows = prop::collection::vec(prop::collection::vec(cell(), 0..14), 0..4);
    ([words(), words(), words()], columns, rows).prop_map(|([id, title, note], columns, rows)| {
        Table {
            id,
            title,
            columns,
            rows,
            note,
        }
    })
}

fn block() -> impl Strategy<Value = Block> {
    prop_oneof![
        words().prop_map(Block::Heading),
        words().prop_map(Block::Text),
        prop::collection::vec(words(), 0..3).prop_map(Block::List),
        words().prop_map(Block::Command),
        table().prop_map(Block::Table),
        figure().prop_map(Block::Figure),
        replay().prop_map(|replay| Block::Replay(Box::new(replay))),
    ]
}

/// A replay whose numbers and references make no sense.
fn replay() -> impl Strategy<Value = Replay> {
    let scene = (
        [words(), words(), words(), words()],
        [number(), number(), number()],
        any::<bool>(),
    );
    let parts = (
        [words(), words(), words()],
        prop::collection::vec(number(), 9),
        any::<[usize; 2]>(),
    );
    (scene, parts).prop_map(
        |(([name, length, time, remark], [a, b, c], rotates), ([id, label, said], n, runs))| {
            let triple = |k: usize| Vec3::new(n[k % 9], n[(k + 1) % 9], n[(k + 2) % 9]);
            let knot = Knot {
                time: n[0],
                state: State {
                    position: triple(1),
                    velocity: triple(4),
                    spin: triple(6),
                },
                after: None,
            };
            let event = ReplayEvent {
                time: n[1],
                kind: "ball-ball",
                a: id.clone(),
                b: label.clone(),
            };
            Replay {
                scene: name,
                duration: a,
                length_unit: length,
                time_unit: time,
                origin: [a, b, c],
                radius: b,
                speed_scale: c,
                table: rotates.then_some([[a, b], [b, c]]),
                pockets: vec![[a, b, c]],
                rotates,
                balls: vec![ReplayBall {
                    id: id.clone(),
                    radius: n[2],
                    mass: n[3],
                    inertia: n[4],
                }],
                runs: vec![ReplayRun {
                    label,
                    engine: said.clone(),
                    reference: rotates,
                    end: n[5],
                    ending: said.clone(),
                    resolution: n[6],
                    events: vec![event],
                    paths: vec![Path {
                        knots: vec![knot; 3],
                    }],
                    left_out: runs[0],
                    tolerance: n[7],
                }],
                partings: vec![ReplayParting {
                    time: n[8],
                    runs,
                    balls: vec![id],
                    words: said,
                }],
                horizon: rotates.then_some(n[0]),
                divergence: vec![ReplayDivergence {
                    run: runs[0],
                    against: runs[1],
                    points: vec![[n[0], n[1]]],
                }],
                remark,
            }
        },
    )
}

/// A document with up to two pages, one of them deeper.
pub fn document() -> impl Strategy<Value = Document> {
    let page = || {
        (
            [words(), words(), words()],
            prop::collection::vec(block(), 0..4),
        )
            .prop_map(|([id, title, lead], blocks)| Document {
                stopped_early: None,
                id,
                title,
                lead,
                blocks,
                pages: Vec::new(),
            })
    };
    (page(), page(), page(), 0..3).prop_map(|(mut first, mut second, third, depth)| {
        if depth > 1 {
            second.pages.push(third);
        }
        if depth > 0 {
            first.pages.push(second);
        }
        first
    })
}
