//! Reads a folder that `carom run --out` wrote, and prints how far each ball went and where it ended.
#![allow(clippy::print_stdout)]

use carom::trace::files::{self, Files};
use std::error::Error;
use std::path::PathBuf;

fn main() -> Result<(), Box<dyn Error>> {
    let folder = std::env::args_os().nth(1).map(PathBuf::from);
    let folder = folder.ok_or("which folder? one that `carom run --out` wrote")?;
    let text = |name: &str| std::fs::read_to_string(folder.join(name));
    let trace = files::read(&Files {
        events: text(files::EVENTS)?,
        samples: text(files::SAMPLES)?,
        final_states: text(files::FINAL)?,
        run: text(files::RUN)?,
    })?;
    println!(
        "{} collisions; {}",
        trace.collisions().count(),
        trace.ending.id()
    );
    for (ball, path) in trace.balls.iter().zip(&trace.paths) {
        let knots = &path.knots;
        let pieces = knots.windows(2);
        let steps = pieces.map(|two| (two[1].state.position - two[0].state.position).norm());
        let end = knots.last().map(|knot| knot.state.position);
        println!(
            "{ball}: {:.3} in all, ends at {end:.3?}",
            steps.sum::<f64>()
        );
    }
    Ok(())
}
