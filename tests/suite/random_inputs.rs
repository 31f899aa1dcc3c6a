//! A hundred thousand damaged inputs: every reader answers each of them, with a scene or trace that reads back as the same, or with
//! an error that has a place and words. `carom fuzz --inputs` reads as many as one likes.

use carom::scene::catalogue;
use carom::scene::{parse, rewritten};
use carom::study::Watch;
use carom::study::mutation::{Examples, Plan, Reader, engine_list, scene_file, study, trace_files};
use carom::trace::files::Files;

const INPUTS: u64 = 100_000;

#[test]
fn a_hundred_thousand_damaged_inputs_are_read_or_refused_as_they_should_be() {
    let plan = Plan {
        first: 0,
        inputs: INPUTS,
        seed: 20_261_124,
    };
    let outcome = study(
        plan,
        &Examples::new(crate::support::roster()).unwrap(),
        Watch::NONE,
    );
    assert_eq!(outcome.failures, [], "{} faults", outcome.faults);
    assert_eq!(outcome.done(), INPUTS);
    // both answers must be met, or only one of them is tested
    for (reader, [accepted, refused]) in Reader::ALL.into_iter().zip(outcome.counts) {
        let all = accepted + refused;
        assert!(all >= INPUTS / 10, "{}: {all}", reader.words());
        assert!(
            accepted > all / 50 && refused > all / 50,
            "{}: {accepted} of {all}",
            reader.words()
        );
    }
}

#[test]
fn every_scene_of_the_catalogue_is_written_as_the_same_scene() {
    let mut scenes = 0;
    for entry in catalogue::all() {
        let again = rewritten(entry.text).unwrap();
        let scene = parse("again", &again).unwrap();
        assert_eq!(scene, entry.scene().unwrap(), "{}", entry.name);
        assert_eq!(scene.hash(), entry.scene().unwrap().hash());
        scenes += 1;
    }
    assert!(scenes > 30);
}

#[test]
fn readers_that_are_given_nothing_refuse_it_with_a_place_and_words() {
    assert_eq!(scene_file(b""), Ok(false));
    assert_eq!(trace_files(&Files::default()), Ok(false));
    let scene = catalogue::scene("head-on").unwrap();
    assert_eq!(engine_list(crate::support::roster(), "", &scene), Ok(false));
    assert_eq!(
        engine_list(crate::support::roster(), "exact", &scene),
        Ok(true)
    );
}
