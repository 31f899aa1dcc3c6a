//! The exact engine with rotation, losses, throw, cushion laws and pockets, held against independent data and closed forms.

mod closed_forms;
mod full_shots;
mod replays;

use crate::support::run;
use carom::scene::{Scene, parse};
use carom::trace::{EventKind, Record, Trace};

/// A pool ball and cloth, as in the reference files.
pub const R: f64 = 0.028575;
pub const G: f64 = 9.81;
pub const SLIDE: f64 = 0.2;
pub const ROLL: f64 = 0.01;
pub const SPIN: f64 = 0.0127;

pub const CLOTH: &str =
    "[effects.cloth.rotational]\nmu_slide = 0.2\nmu_roll = 0.01\nmu_spin = 0.0127\n";

/// Id, centre, velocity and spin of a ball.
pub type BallOf<'a> = (&'a str, [f64; 2], [f64; 2], [f64; 3]);

/// A scene in SI units with effects as written.
pub fn scene(table: &str, balls: &[BallOf<'_>], effects: &str) -> Scene {
    let mut text = format!(
        "name = \"shot\"\nduration = 200.0\ngravity = {G:?}\nunits = {{ length = \"m\", length_in_metres = 1.0 }}\n\n\
         {table}\n[ball]\nradius = {R:?}\nmass = 0.170097\n"
    );
    for (id, position, velocity, spin) in balls {
        text += &format!(
            "\n[[balls]]\nid = \"{id}\"\nposition = {position:?}\nvelocity = {velocity:?}\nspin = {spin:?}\n"
        );
    }
    text += &format!("\n{effects}");
    parse("shot.toml", &text).unwrap_or_else(|error| panic!("{error:?}\n{text}"))
}

pub const POOL: &str = "[table]\nwidth = 1.27\nlength = 2.54\n";

pub fn exact(scene: &Scene) -> Trace {
    run("exact", &[], scene, Record::Events)
}

pub fn events_of(trace: &Trace, ball: u32) -> Vec<(f64, EventKind)> {
    let own = trace
        .events
        .iter()
        .filter(|event| event.kind.balls().0 == ball as usize);
    own.map(|event| (event.time, event.kind)).collect()
}
