//! What the laws of a scene need of it and of each other: gravity, units, a contact to rub at, a cloth that lets balls turn.

use super::check::missing;
use super::diagnostics::{Diagnostic, Kind, short};
use super::file::SceneFile;
use super::located::Located;
use super::problems::Problems;
use crate::physics::{Cloth, Effects, Friction};

/// Checks the laws that the file names.
pub(super) fn check(file: &SceneFile, at: &Located<'_>, problems: &mut Problems) {
    gravity(file, at, problems);
    friction(file, at, problems);
    rotation(file, at, problems);
    circles(file, at, problems);
}

/// The same effects with the size of the length unit where a law has constants in metres.
pub(super) fn in_units(mut effects: Effects, metres: Option<f64>) -> Effects {
    if let (
        Some(Friction::Alciatore {
            length_in_metres, ..
        }),
        Some(metres),
    ) = (&mut effects.friction, metres)
    {
        *length_in_metres = metres;
    }
    effects
}

fn path(id: &str) -> String {
    format!("effects.{id}")
}

fn gravity(file: &SceneFile, at: &Located<'_>, problems: &mut Problems) {
    if let (Some(law), None) = (file.effects.cloth, file.gravity) {
        let law = path(law.id());
        let message = format!("`[{law}]` needs `gravity`, which the scene does not give");
        let help = "add `gravity` at the top of the file, in length/s^2; 9.81 in metres";
        let span = at.value(&law);
        let problem = missing(span, message, help).labelled("this law uses it");
        problems.push(problem.wanting("gravity"));
    }
}

fn friction(file: &SceneFile, at: &Located<'_>, problems: &mut Problems) {
    let Some(law) = file.effects.friction else {
        return;
    };
    let name = path(law.id());
    if file.effects.contact.is_none() {
        let message = format!(
            "`[{name}]` needs a `[effects.contact]`: balls that pass through each other do not rub"
        );
        let help = "add `[effects.contact.elastic]` or `[effects.contact.inelastic]`, or remove the friction";
        let label = "friction is named here";
        let problem = missing(at.value(&name), message, help).labelled(label);
        problems.push(problem.wanting("effects.contact"));
    }
    match law {
        Friction::Constant { .. } => {}
        Friction::Alciatore { .. } => {
            if file.units.length_in_metres.is_none() {
                let message = format!(
                    "`[{name}]` needs the size of the length unit: its slip speed is in m/s"
                );
                let help = "add `length_in_metres` to `[units]`; 1.0 in metres";
                let label = "this law has constants in metres";
                let problem = missing(at.value(&name), message, help).labelled(label);
                problems.push(problem.wanting("units.length_in_metres"));
            }
        }
    }
}

/// A cloth without rotation leaves nothing for a law that turns balls.
fn rotation(file: &SceneFile, at: &Located<'_>, problems: &mut Problems) {
    let Some(cloth @ Cloth::Translational { .. }) = file.effects.cloth else {
        return;
    };
    let friction = file.effects.friction.map(|law| law.id());
    let cushion = file.effects.cushion.filter(|law| law.rotates());
    let laws = [friction, cushion.map(|law| law.id())];
    for law in laws.into_iter().flatten().map(path) {
        let cloth = path(cloth.id());
        let message = format!("`[{law}]` turns balls, and `[{cloth}]` is a law without rotation");
        let help = "use `[effects.cloth.rotational]`, or a law that does not turn balls";
        let problem = Diagnostic::new(Kind::Incompatible, at.value(&law), message, help)
            .labelled("this law turns balls")
            .and(at.value(&cloth), "this one does not let them turn");
        problems.push(problem);
    }
}

fn circles(file: &SceneFile, at: &Located<'_>, problems: &mut Problems) {
    let Some(pockets) = &file.effects.pockets else {
        return;
    };
    let help = "a pocket is `[x, y, r]`: its centre in plan and its radius, greater than 0";
    if pockets.circles.is_empty() {
        let span = at.value("effects.pockets.circles");
        let message = "`[effects.pockets]` names no pocket";
        problems.push(Diagnostic::new(Kind::Missing, span, message, help));
    }
    for (i, [_, _, radius]) in pockets.circles.iter().enumerate() {
        if *radius <= 0.0 {
            let span = at.value(&format!("effects.pockets.circles[{i}][2]"));
            let message = format!(
                "the radius of pocket p{i} must be greater than 0, not {}",
                short(*radius)
            );
            problems.push(Diagnostic::new(Kind::OutOfRange, span, message, help));
        }
    }
}
