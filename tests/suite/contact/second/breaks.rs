//! The breaks that are compared: three scenes at two speeds, moved by the law of `carom ensemble --seed 3`.

use super::laws::Laws;
use carom::engine::Limits;
use carom::engine::exact::solve;
use carom::physics::{Cloth, Contact, Friction};
use carom::scene::perturb::{Law, Perturbation};
use carom::scene::{Scene, parse};
use carom::trace::Trace;

/// Length unit of the report's scenes, m.
const FOOT: f64 = 0.12192;

/// What the report's scenes get for their own laws: balls that turn, and lose.
const LAWS: &str = "
[effects.cloth.rotational]
mu_slide = 0.2
mu_roll = 0.01
mu_spin = 0.0127
[effects.contact.inelastic]
e = 0.95
[effects.cushion.han-2005]
e = 0.85
mu = 0.2
height = 1.28
";

/// Which break.
#[derive(Clone, Copy, Debug)]
pub enum Break {
    /// `pool-break`, with friction of balls.
    Pool,
    /// `report-break` at 92 degrees.
    Report,
    /// `report-break-frozen` at 92 degrees: an ensemble opens its gaps to 1e-5 R.
    Frozen,
}

impl Break {
    /// What its samples are drawn from, at this speed of the cue ball, m/s.
    pub fn samples(self, speed: f64) -> Perturbation {
        let text = match self {
            Break::Pool => {
                let hard = include_str!("../../../../validation/scenes/pool-break.toml");
                let soft = hard.replace("\nspeed = 12.0\n", &format!("\nspeed = {speed:?}\n"));
                assert_ne!(soft, hard, "another speed");
                soft
            }
            Break::Report => {
                let text = include_str!("../../../../validation/scenes/report-break.toml");
                turned(&text.replace("richer = \"report-break-real\"\n", ""), speed)
            }
            Break::Frozen => {
                let text = include_str!("../../../../validation/scenes/report-break-frozen.toml");
                turned(text, speed)
            }
        };
        let scene = parse("break", &text).unwrap_or_else(|error| panic!("{error}"));
        let drawn = Perturbation::new(&scene, Law::default_for(&scene));
        drawn.unwrap_or_else(|error| panic!("{error}"))
    }
}

/// A scene of the report with another shot, its gravity in its own units, and other laws.
fn turned(text: &str, speed: f64) -> String {
    let (before, _) = text.split_once("[shot.force]").unwrap();
    let gravity = format!("gravity = {:?}", 9.81 / FOOT);
    let own = before.replace("gravity = 9.81", &gravity);
    assert_ne!(own, before, "another gravity");
    let shot = format!(
        "[shot.velocity]\nball = \"cue\"\nspeed = {:?}\nangle_deg = 92.0\n",
        speed / FOOT
    );
    own + &shot + LAWS
}

/// The laws of a scene, as the second method has them.
pub fn laws(scene: &Scene) -> Laws {
    let g = scene.gravity;
    let Some(Cloth::Rotational {
        mu_slide,
        mu_roll,
        mu_spin,
    }) = scene.effects.cloth
    else {
        panic!("no such cloth");
    };
    let Some(Contact::Inelastic { e }) = scene.effects.contact else {
        panic!("no such contact");
    };
    let friction = match scene.effects.friction {
        Some(Friction::Alciatore { a, b, c, .. }) => [a, b, c * metres(scene)],
        Some(Friction::Constant { mu }) => [mu, 0.0, 0.0],
        None => [0.0; 3],
    };
    Laws {
        diameter: 2.0 * scene.balls[0].radius,
        slide: mu_slide * g,
        roll: mu_roll * g,
        spin: 2.5 * mu_spin * g,
        e,
        friction,
    }
}

/// Metres per unit of length.
pub fn metres(scene: &Scene) -> f64 {
    scene.units.length_in_metres.unwrap_or(1.0)
}

/// The run of a scene up to so many events, or to its end.
pub fn run(scene: &Scene, max_events: u64) -> Trace {
    let limits = Limits {
        max_events,
        ..Limits::NONE
    };
    solve::<f64>(scene, &limits).trace
}
