//! Tables of hard cases: the matrix, the steps, one scene in full, the rules.

use super::words::{absent, heading, is_preset, mark, word};
use crate::finding::{Cell, Column, Table, Tone, Verdict};
use crate::study::stability::{
    Case, RULES, Reach, Role, Rule, STEPS, StabilityOutcome, bounds_in_words, is_swept, step_of,
};

/// What a verdict is to a reader who only glances.
pub fn tone(verdict: Verdict) -> Tone {
    match verdict {
        Verdict::Holds => Tone::Good,
        Verdict::Drifts => Tone::Notice,
        Verdict::Breaks => Tone::Bad,
        Verdict::Indeterminate | Verdict::CannotExpress => Tone::Quiet,
    }
}

fn scene_column() -> Column {
    Column::words("scene", "scene")
}

fn scene_cell(outcome: &StabilityOutcome, scene: usize) -> Cell {
    let name = &outcome.question.scenes[scene].name;
    Cell::Page(name.clone(), name.clone())
}

/// Scenes x presets. `changed`: whether a cell differs from what was accepted.
pub fn matrix(outcome: &StabilityOutcome, changed: &dyn Fn(usize, &str) -> bool) -> Table {
    let mut columns = vec![scene_column()];
    let presets = &outcome.question.presets;
    for preset in presets {
        let case = outcome
            .cases
            .iter()
            .find(|case| is_preset(case) && case.planned.column.label() == preset.label());
        let title = case.map_or_else(|| preset.label(), heading);
        columns.push(Column::words(
            &preset.label().replace([' ', '='], "-"),
            &title,
        ));
    }
    let row = |scene: usize| {
        let mut row = vec![scene_cell(outcome, scene)];
        let cells = outcome.of_scene(scene).filter(|case| is_preset(case));
        row.extend(cells.map(|case| {
            let Some(judged) = &case.judged else {
                return Cell::verdict(Tone::Quiet, "?");
            };
            let sign = match changed(scene, &case.planned.column.label()) {
                true => " !",
                false => "",
            };
            Cell::verdict(
                tone(judged.verdict),
                format!("{}{sign}", word(judged.verdict)),
            )
        }));
        row
    };
    Table {
        id: "matrix".to_owned(),
        title: "Hard cases on every engine and preset".to_owned(),
        columns,
        rows: (0..outcome.question.scenes.len()).map(row).collect(),
        note: "holds: every rule; drifts: off by more than step and scalar explain, or in another order that they do explain; breaks: against a \
               law; indet.: no single right answer; cannot: the engine cannot express the scene. A ! differs from what was accepted."
            .to_owned(),
    }
}

/// Scenes x engines: one letter a step, and one for each setting that the scene asks for.
pub fn steps(outcome: &StabilityOutcome) -> Option<Table> {
    let swept: Vec<usize> = (0..outcome.question.presets.len())
        .filter(|&p| is_swept(&outcome.question.presets[p]))
        .collect();
    let tried = outcome
        .cases
        .iter()
        .any(|case| case.planned.role == Role::Tried);
    if swept.is_empty() && !tried {
        return None;
    }
    let mut columns = vec![scene_column()];
    for &p in &swept {
        let label = outcome.question.presets[p].label();
        let case = outcome
            .cases
            .iter()
            .find(|case| case.planned.column.label() == label);
        columns.push(Column::words(
            &format!("{}-steps", label.replace([' ', '='], "-")),
            &case.map_or(label, heading),
        ));
    }
    if tried {
        columns.push(Column::words("tried", "tried"));
    }
    let row = |scene: usize| {
        let mut row = vec![scene_cell(outcome, scene)];
        for &p in &swept {
            let marks = (0..STEPS.len())
                .map(|s| of_step(outcome, scene, p, s).map_or(' ', |case| mark(outcome, case)));
            row.push(Cell::text(marks.collect::<String>()));
        }
        if tried {
            let own = outcome
                .of_scene(scene)
                .filter(|case| case.planned.role == Role::Tried);
            row.push(Cell::text(
                own.map(|case| mark(outcome, case)).collect::<String>(),
            ));
        }
        row
    };
    Some(Table {
        id: "steps".to_owned(),
        title: format!("Steps from {:e} to {:e} s", STEPS[0], STEPS[STEPS.len() - 1]),
        columns,
        rows: (0..outcome.question.scenes.len()).map(row).collect(),
        note: "One letter a step, the finest first: h holds, d drifts, b breaks, i indeterminate, c cannot express; . left to --full, - out of reach. \
               tried: settings that the scene asks for."
            .to_owned(),
    })
}

/// The cell of a scene in a preset with its step replaced; a preset's own step stands in its place.
pub fn of_step(
    outcome: &StabilityOutcome,
    scene: usize,
    preset: usize,
    step: usize,
) -> Option<&Case> {
    outcome
        .of_scene(scene)
        .find(|case| match case.planned.role {
            Role::Step(its_preset, its_step) => (its_preset, its_step) == (preset, step),
            Role::Preset => {
                case.planned.column.label() == outcome.question.presets[preset].label()
                    && step_of(&case.planned.column) == STEPS.get(step).copied()
            }
            Role::Tried => false,
        })
}

/// Every cell of one scene, with its sentence.
pub fn scene(outcome: &StabilityOutcome, scene: usize) -> Table {
    let mut rows = Vec::new();
    let mut left = 0;
    for case in outcome.of_scene(scene) {
        let Some(judged) = &case.judged else {
            left += usize::from(case.planned.reach != Reach::Always);
            continue;
        };
        let spoken = judged.spoken().filter(|_| judged.verdict != Verdict::Holds);
        rows.push(vec![
            Cell::text(case.planned.column.label()),
            Cell::verdict(tone(judged.verdict), word(judged.verdict)),
            spoken.map_or(Cell::Empty, |(rule, _)| Cell::text(rule.id)),
            Cell::text(judged.why.clone()),
        ]);
    }
    Table {
        id: format!("cells-{}", outcome.question.scenes[scene].name),
        title: "Every run".to_owned(),
        columns: vec![
            Column::words("engine", "engine"),
            Column::words("verdict", "verdict"),
            Column::words("rule", "rule"),
            Column::words("why", "why"),
        ],
        rows,
        note: match left {
            0 => String::new(),
            n => format!("{n} runs are left to --full or out of reach."),
        },
    }
}

/// Every figure of one scene: rows are rules, columns the presets and what the scene asks for.
pub fn figures(outcome: &StabilityOutcome, scene: usize) -> Table {
    let cases: Vec<&Case> = outcome
        .of_scene(scene)
        .filter(|case| !matches!(case.planned.role, Role::Step(..)) && case.judged.is_some())
        .collect();
    let mut columns = vec![
        Column::words("check", "check"),
        Column::words("unit", "unit"),
    ];
    for case in &cases {
        let label = case.planned.column.label();
        columns.push(Column::number(&label.replace([' ', '='], "-"), &label, ""));
    }
    let rows = RULES.iter().enumerate().map(|(index, rule)| {
        let mut row = vec![Cell::text(rule.id), Cell::text(rule.unit)];
        row.extend(cases.iter().map(|case| {
            let judgements = case.judged.iter().flat_map(|judged| &judged.judgements);
            let own = judgements.into_iter().find(|(rule, _)| *rule == index);
            let value = own.and_then(|(_, judgement)| judgement.value);
            Cell::maybe(value)
        }));
        row
    });
    Table {
        id: format!("figures-{}", outcome.question.scenes[scene].name),
        title: "Every figure".to_owned(),
        columns,
        rows: rows.collect(),
        note: String::new(),
    }
}

/// Every cell that does not run, and why.
pub fn absent_cells(outcome: &StabilityOutcome) -> Option<Table> {
    let rows: Vec<Vec<Cell>> = outcome
        .cases
        .iter()
        .filter(|case| case.judged.is_none())
        .map(|case| {
            vec![
                Cell::text(outcome.scene(case).name.clone()),
                Cell::text(case.planned.column.label()),
                Cell::text(absent(outcome, case)),
                Cell::Number(case.planned.time * 1e-9),
            ]
        })
        .collect();
    (!rows.is_empty()).then(|| Table {
        id: "left-out".to_owned(),
        title: "What did not run".to_owned(),
        columns: vec![
            scene_column(),
            Column::words("engine", "engine"),
            Column::words("why", "why"),
            Column::number("time", "expected time", "s"),
        ],
        rows,
        note: bounds_in_words(),
    })
}

/// The rules.
pub fn rules() -> Table {
    let row = |rule: &Rule| {
        vec![
            Cell::text(rule.id),
            Cell::text(rule.unit),
            Cell::text(rule.what()),
        ]
    };
    Table {
        id: "rules".to_owned(),
        title: "The rules".to_owned(),
        columns: vec![
            Column::words("rule", "rule"),
            Column::words("unit", "unit"),
            Column::words("what", "what it demands"),
        ],
        rows: RULES.iter().map(row).collect(),
        note: "Of several rules with the worst verdict the first speaks for the run. E0: initial kinetic energy; m v0: largest mass x largest initial \
               speed; v: largest speed; G: largest factor by which the exact run lets a perturbation grow; ulp: rounding of the engine's scalar."
            .to_owned(),
    }
}
