//! Any bytes as a scene that runs: what is a scene must hold in `exact` and in the stepper, as the random scenes must.
#![no_main]

use carom::engine::{Limits, Roster};
use carom::scene::parse_bytes;
use carom::study::Configuration;
use carom::study::random::judge;
use libfuzzer_sys::fuzz_target;

const MOST_BALLS: usize = 16;
const MAX_EVENTS: u64 = 200;
const STEPS: f64 = 200.0;

fuzz_target!(|bytes: &[u8]| {
    let Ok(mut scene) = parse_bytes("input.toml", bytes) else {
        return;
    };
    if scene.balls.len() > MOST_BALLS {
        return;
    }
    let limits = Limits {
        max_events: MAX_EVENTS,
        ..Limits::NONE
    };
    let tried = format!("stepper dt={:e}", scene.duration / STEPS);
    scene.try_settings = vec![tried.parse().unwrap()];
    for column in Configuration::presets(&Roster::built_in(), |preset| preset.sound) {
        let column = column.as_tried(&scene);
        if let Ok((_, _, verdict)) = judge(&scene, &column, &limits, true) {
            assert_eq!(verdict.faults, [], "{}", column.label());
        }
    }
});
