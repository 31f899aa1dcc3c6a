//! Random cells of what is accepted, each set to what it is not: `check` and `stability` notice every one.
//!
//! The gate and the hard cases run once; each altered file is then held as the commands hold it.

use carom::finding::{Hold, Tolerance};
use carom::gate::{self, Accepted, Held, hold_cases};
use carom::math::random::Draws;
use carom::scene::{Scene, SetName, catalogue};
use carom::study::compare::default_columns;
use carom::study::matrix::{Configuration, Watch};
use carom::study::{check, stability};
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

/// Cells that are altered of either kind.
const CELLS: usize = 60;

/// What draws them.
const SEED: u64 = 13;

fn accepted(folder: &str, scene: &Scene) -> Accepted {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("validation")
        .join(folder);
    let path = folder.join(format!("{}.csv", scene.name));
    let text = std::fs::read_to_string(&path).unwrap_or_else(|e| panic!("{path:?}: {e}"));
    gate::read(&text).unwrap_or_else(|e| panic!("{path:?}: {e}"))
}

/// What a cell is set to, with a name for each; `None` where the value beside it is the same within its tolerance, so that another cell
/// is drawn.
fn alterations(
    accepted: &Accepted,
    row: usize,
    tolerance: Tolerance,
) -> Option<[(&'static str, f64); 6]> {
    let value = accepted.rows[row].value?;
    let beside = (1..accepted.rows.len())
        .map(|step| (row + step) % accepted.rows.len())
        .find_map(|at| accepted.rows[at].value)?;
    let all = [
        ("infinity", f64::INFINITY),
        ("minus infinity", f64::NEG_INFINITY),
        ("no number", f64::NAN),
        ("nearly the largest", 1e308),
        ("that of the next row", beside),
        ("moved by 1 % and 1e-3", 1.01 * value + 1e-3),
    ];
    (!tolerance.holds(value, beside)).then_some(all)
}

/// Numbers below `n`, drawn.
fn draw(draws: &mut Draws, n: usize) -> usize {
    (draws.bits() % n as u64) as usize
}

#[test]
fn sixty_cells_of_the_baselines_are_noticed_whatever_they_become() {
    let scenes = catalogue::set(SetName::Gate).unwrap();
    let files: Vec<Accepted> = scenes.iter().map(|s| accepted("baselines", s)).collect();
    let outcome = check::study(
        crate::support::roster(),
        &scenes,
        &default_columns(crate::support::roster()),
        Watch::NONE,
    )
    .unwrap();
    let hold = |files: &[Accepted]| {
        let files = files.iter().cloned().map(Some).collect();
        Held::new(outcome.clone(), files, Vec::new())
    };
    let held = hold(&files);
    assert_eq!((held.changes.len(), held.standing().stale), (0, 0));
    let mut draws = Draws::new(SEED, 0);
    let mut drawn = BTreeSet::new();
    while drawn.len() < CELLS {
        let scene = draw(&mut draws, files.len());
        let row = draw(&mut draws, files[scene].rows.len());
        let own = files[scene].rows[row].clone();
        let tolerance = outcome.tolerance(&own.engine, &own.check);
        let Some(all) = alterations(&files[scene], row, tolerance) else {
            continue;
        };
        if !drawn.insert((scene, row)) {
            continue;
        }
        for (what, value) in all {
            let mut altered = files.clone();
            altered[scene].rows[row].value = Some(value);
            // through the text, as the command reads it
            altered[scene] = gate::read(&gate::write(&altered[scene])).unwrap();
            let held = hold(&altered);
            let name = &scenes[scene].name;
            assert_eq!(held.changes.len(), 1, "{name} {own:?}: {what}");
            assert_eq!(
                held.changes[0].change.row().unwrap().address(),
                own.address()
            );
            assert_eq!(held.standing().decision(), gate::Decision::NotMet, "{what}");
        }
        // and the other way round: the engine becomes what the file is not
        for (what, value) in all {
            let mut outcome = outcome.clone();
            let mut findings = outcome.findings.iter_mut();
            let finding = findings.find(|f| {
                f.scene == scenes[scene].name
                    && [&f.engine[..], f.metric, &f.subject] == own.address()
            });
            finding.unwrap().value = Some(value);
            let accepted = files.iter().cloned().map(Some).collect();
            let held = Held::new(outcome, accepted, Vec::new());
            assert_eq!(held.changes.len(), 1, "{own:?} was found as {what}");
        }
    }
}

/// The preset whose matrix holds a run: the one whose label its own continues, or that of the engine for what a scene tries.
fn preset_of(label: &str) -> Configuration {
    let presets = stability::presets(crate::support::roster());
    let continues = |preset: &&Configuration| {
        let rest = label.strip_prefix(&preset.label());
        rest.is_some_and(|rest| rest.is_empty() || rest.starts_with(" dt="))
    };
    let engine = |preset: &&Configuration| label.split(' ').next() == Some(preset.engine.id());
    let found = presets
        .iter()
        .find(continues)
        .or_else(|| presets.iter().find(engine));
    found
        .unwrap_or_else(|| panic!("no preset runs {label}"))
        .clone()
}

#[test]
fn sixty_cells_of_the_hard_cases_are_noticed_whatever_they_become() {
    let mut scenes = catalogue::set(SetName::Hard).unwrap();
    scenes.retain(|scene| !scene.is_in(SetName::Full));
    let files: Vec<Accepted> = scenes.iter().map(|s| accepted("hard", s)).collect();
    let mut draws = Draws::new(SEED, 1);
    let mut drawn: BTreeMap<usize, BTreeSet<usize>> = BTreeMap::new();
    while drawn.values().map(BTreeSet::len).sum::<usize>() < CELLS {
        let scene = draw(&mut draws, files.len());
        let row = draw(&mut draws, files[scene].rows.len());
        let own = &files[scene].rows[row];
        // the widest tolerance that any engine has
        let ulp = f64::from(f32::EPSILON);
        let tolerance = stability::rule(&own.check)
            .map_or_else(|| Hold::Figure.tolerance(ulp), |rule| rule.tolerance(ulp));
        if alterations(&files[scene], row, tolerance).is_some() {
            drawn.entry(scene).or_default().insert(row);
        }
    }
    let mut altered_cells = 0;
    for (scene, rows) in drawn {
        let (file, name) = (&files[scene], &scenes[scene].name);
        let mut presets: Vec<Configuration> = Vec::new();
        for row in &rows {
            let preset = preset_of(&file.rows[*row].engine);
            if presets.iter().all(|known| known.label() != preset.label()) {
                presets.push(preset);
            }
        }
        let question = stability::Question {
            roster: crate::support::roster().clone(),
            scenes: vec![scenes[scene].clone()],
            presets,
            full: false,
            pictures: false,
        };
        let outcome = stability::study(question, Watch::NONE).unwrap();
        let held = hold_cases(&outcome, 0, file, true);
        assert_eq!(held.changes, [], "{name}");
        assert!(!held.stale && held.contradictions.is_empty(), "{name}");
        for row in rows {
            let own = &file.rows[row];
            let tolerance = outcome.tolerance(&own.engine, &own.check);
            let all = alterations(file, row, tolerance).unwrap();
            for (what, value) in all {
                let mut altered = file.clone();
                altered.rows[row].value = Some(value);
                let altered = gate::read(&gate::write(&altered)).unwrap();
                let held = hold_cases(&outcome, 0, &altered, true);
                assert_eq!(held.changes.len(), 1, "{name} {own:?}: {what}");
                assert_eq!(held.changes[0].row().unwrap().address(), own.address());
            }
            altered_cells += 1;
        }
    }
    assert_eq!(altered_cells, CELLS);
}
