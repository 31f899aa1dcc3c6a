//! Compares two engines on a scene that is a string: where they part, when and why.
#![allow(clippy::print_stdout)]

use carom::engine::{Limits, Roster};
use carom::page::{answer::summary, compare::LengthUnit};
use carom::report::{FORMATS, text};
use carom::study::{Answer, Configuration, Timing, Watch};
use std::error::Error;

const SCENE: &str = r#"
name = "two-balls"
duration = 3.0
gravity = 9.81
[ball]
radius = 0.028575
mass = 0.17
[[balls]]
id = "cue"
position = [0.0, 0.0]
velocity = [1.5, 0.0]
[[balls]]
id = "object"
position = [0.3, 0.02]
[effects.cloth.translational]
mu = 0.2
[effects.contact.elastic]
"#;

fn main() -> Result<(), Box<dyn Error>> {
    let scene = carom::scene::parse("two-balls.toml", SCENE)?;
    let columns = Configuration::list(&Roster::built_in(), "exact,stepper:dt=2e-3")?;
    let most = Limits::NONE.max_events;
    let answer = Answer::to(&scene, &columns, Timing::None, most, Watch::NONE)?;
    print!(
        "{}",
        (FORMATS[0].write)(&summary(&answer, LengthUnit::Radius), text::WIDTH)
    );
    Ok(())
}
