//! Any four texts, parted by a byte that no text has, as a trace: one that reads back as the same, or an error with place and words.
#![no_main]

use carom::study::mutation::trace_files;
use carom::trace::files::Files;
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    let mut texts = bytes
        .split(|byte| *byte == 0xff)
        .map(|text| String::from_utf8_lossy(text).into_owned());
    let mut next = || texts.next().unwrap_or_default();
    let files = Files {
        events: next(),
        samples: next(),
        final_states: next(),
        run: next(),
    };
    if let Err(fault) = trace_files(&files) {
        panic!("{fault:?}");
    }
});
