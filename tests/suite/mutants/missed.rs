//! What the gate once missed, as far as an engine can have it without another source: the rest are mutants of the sources
//! (`tests/mutants`).

use super::engines::Fault;
use super::roster::Mutant;
use carom::physics::{Cushion, Friction};
use carom::scene::Scene;

const APPROACHING: &[&str] = &["contact=approaching-only"];

/// Keys that are ignored, a unit that is forgotten, numbers of a law that are taken for others.
pub const MISSED: &[Mutant] = &[
    Mutant {
        id: "rapier-substeps-ignored",
        what: "4 substeps instead of 1",
        engine: "rapier-f64",
        setting: &["substeps=1"],
        fault: Fault::Setting("substeps", "4"),
        scenes: &["keys-of-rapier"],
    },
    Mutant {
        id: "rapier-iterations-ignored",
        what: "1 sweep over the contacts instead of 4",
        engine: "rapier-f64",
        setting: &["internal_iterations=4"],
        fault: Fault::Setting("internal_iterations", "1"),
        scenes: &["keys-of-rapier"],
    },
    Mutant {
        id: "rapier-warm-start-ignored",
        what: "contacts start from all of their last impulse instead of none",
        engine: "rapier-f32",
        setting: &["warmstart_coefficient=0.0"],
        fault: Fault::Setting("warmstart_coefficient", "1.0"),
        scenes: &["keys-of-rapier"],
    },
    Mutant {
        id: "launch-ignored",
        what: "the force acts for the contact time instead of one step",
        engine: "stepper",
        setting: &["launch=as-written"],
        fault: Fault::Setting("launch", "contact-time"),
        scenes: &["launched"],
    },
    Mutant {
        id: "han-nose-at-the-centre",
        what: "the nose of the cushion at the height of the centre",
        engine: "stepper",
        setting: &[],
        fault: Fault::Scene(nose_at_the_centre),
        scenes: &["cushions-han"],
    },
    Mutant {
        id: "exact-slip-in-inches",
        what: "slip speeds in inches taken for metres",
        engine: "exact",
        setting: &[],
        fault: Fault::Scene(|s| length_unit(s, |_| 1.0)),
        scenes: &["throw-alciatore"],
    },
    Mutant {
        id: "rapier-slip-in-inches",
        what: "slip speeds in inches taken for metres",
        engine: "rapier-f64",
        setting: &[],
        fault: Fault::Scene(|s| length_unit(s, |_| 1.0)),
        scenes: &["throw-alciatore"],
    },
    Mutant {
        id: "length-unit-reversed",
        what: "slip speeds divided by the length of an inch",
        engine: "stepper",
        setting: APPROACHING,
        fault: Fault::Scene(|s| length_unit(s, |unit| 1.0 / unit)),
        scenes: &["throw-alciatore-masses"],
    },
    Mutant {
        id: "stepper-e-for-e-squared",
        what: "e instead of e^2 of the work at a cushion of Mathavan",
        engine: "stepper",
        setting: &[],
        fault: Fault::Scene(|s| {
            mathavan(s, |[e, mu, cloth, height]| [e.sqrt(), mu, cloth, height])
        }),
        scenes: &["cushions-mathavan"],
    },
    Mutant {
        id: "exact-frictions-swapped",
        what: "friction of the nose at the cloth, and that of the cloth at the nose",
        engine: "exact",
        setting: &[],
        fault: Fault::Scene(|s| mathavan(s, |[e, mu, cloth, height]| [e, cloth, mu, height])),
        scenes: &["cushions-mathavan"],
    },
    Mutant {
        id: "exact-smooth-cloth-at-cushions",
        what: "the cloth does not rub while a ball meets a cushion",
        engine: "exact",
        setting: &[],
        fault: Fault::Scene(|s| mathavan(s, |[e, mu, _, height]| [e, mu, 0.0, height])),
        scenes: &["cushions-mathavan"],
    },
];

fn nose_at_the_centre(scene: &mut Scene) {
    if let Some(Cushion::Han2005 { height, .. }) = &mut scene.effects.cushion {
        *height = 1.0;
    }
}

fn length_unit(scene: &mut Scene, change: fn(f64) -> f64) {
    if let Some(Friction::Alciatore {
        length_in_metres, ..
    }) = &mut scene.effects.friction
    {
        *length_in_metres = change(*length_in_metres);
    }
}

fn mathavan(scene: &mut Scene, change: fn([f64; 4]) -> [f64; 4]) {
    if let Some(Cushion::Mathavan2010 {
        e,
        mu,
        mu_cloth,
        height,
    }) = &mut scene.effects.cushion
    {
        [*e, *mu, *mu_cloth, *height] = change([*e, *mu, *mu_cloth, *height]);
    }
}
