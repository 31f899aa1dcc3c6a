//! The gate tests itself: engines with one thing wrong, each of which `check` must catch.

mod engines;
mod plain;
mod slip;

use crate::support::run;
use carom::scene::catalogue;
use carom::trace::Record;
use engines::Wrong;
use slip::Slip;

#[test]
fn the_plain_copy_without_a_slip_is_the_stepper_to_the_bit() {
    let scenes = catalogue::set("gate").unwrap();
    assert!(scenes.len() > 20, "{} scenes", scenes.len());
    let copy = Wrong::stepping(Slip::None);
    for scene in &scenes {
        for setting in [&[][..], &["contact=approaching-only"]] {
            let want = run("stepper", setting, scene, Record::Every(0.01));
            let got = engines::run(copy, setting, scene, Record::Every(0.01));
            assert_eq!(
                got.events, want.events,
                "{} {setting:?}: events",
                scene.name
            );
            assert_eq!(got.counters, want.counters, "{}: counters", scene.name);
            assert_eq!(got, want, "{} {setting:?}", scene.name);
        }
    }
}
