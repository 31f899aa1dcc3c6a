//! Any bytes as a scene file: a scene that reads back as the same, or errors with place and words.
#![no_main]

use carom::study::mutation::scene_file;
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    if let Err(fault) = scene_file(bytes) {
        panic!("{fault:?}");
    }
});
