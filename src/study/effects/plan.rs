//! Which runs an ablation needs: the scene with some of its effects, and the scenes of its ladder. Equal ones run once.

use super::optional::{Optional, dependents, present, reduced};
use crate::math::Vec3;
use crate::scene::{Scene, SceneError, catalogue};

/// What is run.
#[derive(Clone, Debug)]
pub struct Plan {
    /// The scene as written.
    pub scene: Scene,
    /// The optional effects that it calls for.
    pub effects: Vec<Optional>,
    /// Every scene that is run, each once. The first is the scene as written.
    pub rows: Vec<Scene>,
    /// Row of the bare model.
    pub bare: usize,
    /// Each effect on the bare model.
    pub alone: Vec<Variant>,
    /// The scene without each effect.
    pub without: Vec<Variant>,
    /// From the poorest to the richest.
    pub ladder: Vec<Rung>,
    /// Whether the ladder is the chain of `richer` through the scene, and not its own effects one upon the other.
    pub is_chain: bool,
}

/// The scene with one effect added to the bare model, or left out.
#[derive(Clone, Debug, PartialEq)]
pub struct Variant {
    /// The effect.
    pub effect: Optional,
    /// What comes or goes with it, because one cannot act without the other.
    pub along: Vec<Optional>,
    /// Index of the row.
    pub row: usize,
}

/// One step of the ladder.
#[derive(Clone, Debug, PartialEq)]
pub struct Rung {
    /// The scene's name, or what is added.
    pub name: String,
    /// Index of the row.
    pub row: usize,
}

/// The row of the scene as written.
pub const WHOLE: usize = 0;

impl Plan {
    /// The ablation of `scene`. Errors: a scene of its chain is not in the catalogue, or not a scene.
    pub fn new(scene: &Scene) -> Result<Plan, SceneError> {
        let effects = present(&scene.effects);
        let mut rows = vec![scene.clone()];
        let bare = enter(&mut rows, with(scene, &[]));
        let mut alone = Vec::new();
        let mut without = Vec::new();
        for &effect in &effects {
            let along: Vec<Optional> = effect.needs(&scene.effects).into_iter().collect();
            let kept = [&along[..], &[effect]].concat();
            let row = enter(&mut rows, with(scene, &kept));
            alone.push(Variant { effect, along, row });
            let along = dependents(&scene.effects, effect);
            let mut kept = effects.clone();
            kept.retain(|other| *other != effect && !along.contains(other));
            let row = enter(&mut rows, with(scene, &kept));
            without.push(Variant { effect, along, row });
        }
        let chain = chain(scene)?;
        let is_chain = chain.len() > 1;
        let ladder = if is_chain {
            let rung = |rung: Scene| Rung {
                name: rung.name.clone(),
                row: enter(&mut rows, rung),
            };
            chain.into_iter().map(rung).collect()
        } else {
            let rung = |n: usize| Rung {
                name: match n.checked_sub(1) {
                    None => "bare model".to_owned(),
                    Some(last) => format!("+ {}", effects[last].name()),
                },
                row: enter(&mut rows, with(scene, &effects[..n])),
            };
            (0..=effects.len()).map(rung).collect()
        };
        Ok(Plan {
            scene: scene.clone(),
            effects,
            rows,
            bare,
            alone,
            without,
            ladder,
            is_chain,
        })
    }

    /// The richest scene of the ladder.
    pub fn top(&self) -> usize {
        self.ladder.last().map_or(WHOLE, |rung| rung.row)
    }
}

/// The scene with only these of its optional effects. Where nothing turns balls any more, they have no spin.
fn with(scene: &Scene, kept: &[Optional]) -> Scene {
    let mut variant = scene.clone();
    variant.effects = reduced(&scene.effects, kept);
    if !variant.effects.rotates() {
        for ball in &mut variant.balls {
            ball.state.spin = Vec3::zeros();
        }
    }
    variant
}

/// The index of the row that runs `scene`, made if there is none.
fn enter(rows: &mut Vec<Scene>, scene: Scene) -> usize {
    let known = rows.iter().position(|row| same_physics(row, &scene));
    known.unwrap_or_else(|| {
        rows.push(scene);
        rows.len() - 1
    })
}

/// Whether two scenes run alike, whatever they are called.
fn same_physics(a: &Scene, b: &Scene) -> bool {
    let named_alike = Scene {
        name: b.name.clone(),
        description: b.description.clone(),
        sets: b.sets.clone(),
        richer: b.richer.clone(),
        ..a.clone()
    };
    named_alike == *b
}

/// The scenes that `richer` links with this one, from the poorest to the richest; this one alone if there are none.
///
/// Below a scene the chain goes on as long as exactly one scene of the catalogue names it.
fn chain(scene: &Scene) -> Result<Vec<Scene>, SceneError> {
    let mut everything = Vec::new();
    for entry in catalogue::all() {
        everything.push(entry.scene()?);
    }
    let mut chain = vec![scene.clone()];
    let knows = |chain: &[Scene], name: &str| chain.iter().any(|known| known.name == name);
    while let Some(name) = chain.last().and_then(|last| last.richer.clone()) {
        if knows(&chain, &name) {
            break;
        }
        chain.push(catalogue::scene(&name)?);
    }
    while let Some(first) = chain.first() {
        let names_it = |poorer: &&Scene| poorer.richer.as_ref() == Some(&first.name);
        let mut poorer = everything.iter().filter(names_it);
        let (Some(one), None) = (poorer.next(), poorer.next()) else {
            break;
        };
        if knows(&chain, &one.name) {
            break;
        }
        chain.insert(0, one.clone());
    }
    Ok(chain)
}
