//! The page before any script runs, and without one.

use super::browser::{encoded, tags};
use super::{Never, Now, Tag, get, handle, parsed, post, request, sent, site, text};
use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use carom::scene::catalogue;
use carom::web::form::FIVE;
use sha2::{Digest, Sha256};

fn tag<'t>(tags: &'t [Tag], name: &str, attribute: &str, value: &str) -> &'t Tag {
    let found = tags
        .iter()
        .find(|tag| tag.name == name && tag.get(attribute) == Some(value));
    found.unwrap_or_else(|| panic!("no {name} with {attribute}={value}"))
}

#[test]
fn the_page_holds_the_five_inputs_with_labels_values_ranges_and_what_is_recommended() {
    let page = get("/");
    assert_eq!(page.status, 200);
    let tags = tags(text(&page));
    for (name, value, words, range) in [
        ("mass", "0.107", "recommended 0.107", ["0", ""]),
        ("force", "108", "recommended 108", ["0", ""]),
        ("gravity", "9.81", "recommended 9.81", ["0", ""]),
        ("friction", "0.2", "0.15 to 0.4", ["0", ""]),
        ("angle", "90.2", "recommended 90", ["-360", "360"]),
    ] {
        let input = tag(&tags, "input", "name", name);
        assert_eq!(input.get("value"), Some(value), "{name}");
        assert_eq!(input.get("type"), Some("number"), "{name}");
        assert_eq!(input.get("step"), Some("any"), "{name}");
        assert_eq!(input.get("min").unwrap_or_default(), range[0], "{name}");
        assert_eq!(input.get("max").unwrap_or_default(), range[1], "{name}");
        let id = input.get("id").unwrap();
        assert!(!tag(&tags, "label", "for", id).text.is_empty(), "{name}");
        let hint = tag(&tags, "p", "id", input.get("aria-describedby").unwrap());
        assert!(hint.text.contains(words), "{name}: {}", hint.text);
    }
    assert_eq!(FIVE.len(), 5);
    let form = tag(&tags, "form", "id", "shot");
    assert_eq!(form.get("method"), Some("post"));
    assert_eq!(form.get("action"), Some("/shot"));
}

#[test]
fn every_control_has_an_id_of_its_own_a_label_and_a_description() {
    let page = get("/?scene=pool-break");
    let tags = tags(text(&page));
    let ids: Vec<&str> = tags.iter().filter_map(|tag| tag.get("id")).collect();
    let unique: std::collections::BTreeSet<&&str> = ids.iter().collect();
    assert_eq!(unique.len(), ids.len(), "an id stands twice");
    let mut controls = 0;
    for control in &tags {
        let is_control = ["input", "select", "textarea"].contains(&control.name.as_str());
        if !is_control || control.get("type") == Some("hidden") {
            continue;
        }
        let id = control.get("id").unwrap();
        assert!(!tag(&tags, "label", "for", id).text.is_empty(), "{id}");
        for described in control
            .get("aria-describedby")
            .into_iter()
            .flat_map(|ids| ids.split(' '))
        {
            assert!(ids.contains(&described), "{id} is described by {described}");
        }
        controls += 1;
    }
    // five inputs, and at least one control for every law's number
    assert!(controls > 40, "{controls} controls");
}

#[test]
fn the_policy_allows_the_script_and_style_of_the_page_and_nothing_else() {
    let page = get("/");
    let policy = &page
        .headers
        .iter()
        .find(|(name, _)| *name == "Content-Security-Policy")
        .unwrap()
        .1;
    let tags = tags(text(&page));
    for (name, directive) in [("script", "script-src"), ("style", "style-src")] {
        let own: Vec<&Tag> = tags.iter().filter(|tag| tag.name == name).collect();
        assert_eq!(own.len(), 1, "{name}");
        let hash = STANDARD.encode(Sha256::digest(own[0].text.as_bytes()));
        let rule = format!("{directive} 'sha256-{hash}';");
        assert!(policy.contains(&rule), "{policy} lacks {rule}");
    }
    for rule in [
        "default-src 'none'",
        "connect-src 'self'",
        "form-action 'self'",
        "frame-ancestors 'none'",
    ] {
        assert!(policy.contains(rule), "{policy} lacks {rule}");
    }
    assert!(!policy.contains("unsafe"), "{policy}");
    let styled: Vec<&Tag> = tags
        .iter()
        .filter(|tag| tag.get("style").is_some())
        .collect();
    assert!(styled.is_empty(), "the policy forbids {styled:?}");
}

#[test]
fn a_link_fills_in_the_form_by_name_and_by_field() {
    for (query, wanted) in [
        (
            "/?scene=slide",
            vec![("shot.velocity.speed", "5"), ("angle", "30")],
        ),
        (
            "/?mass=0.17&friction=0.3",
            vec![("mass", "0.17"), ("friction", "0.3"), ("force", "108")],
        ),
        (
            "/?scene=pool-break&friction=0.25&angle=80",
            vec![("friction", "0.25"), ("angle", "80")],
        ),
        (
            "/?engine=exact&engine=stepper&dt.stepper=1e-4",
            vec![("dt.stepper", "1e-4"), ("dt.rapier-f64", "0.001")],
        ),
    ] {
        let page = get(query);
        assert_eq!(page.status, 200, "{query}");
        let pairs = sent(text(&page));
        for (name, value) in wanted {
            let found = pairs.iter().find(|(known, _)| known == name);
            assert_eq!(
                found.map(|(_, v)| v.as_str()),
                Some(value),
                "{query}: {name}"
            );
        }
    }
    let one = sent(text(&get("/?engine=exact&engine=stepper")));
    let engines: Vec<&str> = one
        .iter()
        .filter(|(name, _)| name == "engine")
        .map(|(_, v)| v.as_str())
        .collect();
    assert_eq!(engines, ["stepper", "exact"]);
}

#[test]
fn a_link_that_is_wrong_says_so_on_the_page() {
    for (query, words) in [
        ("/?scene=slid", "did you mean `slide`"),
        ("/?toml=AAAA", "the link is damaged"),
        ("/?toml=%00", "the link is damaged"),
        ("/?friction=-1", "0 or greater"),
        ("/?friktion=1", "there is no field"),
    ] {
        let page = get(query);
        assert_eq!(page.status, 400, "{query}");
        let shown = text(&page).replace("<code>", "`").replace("</code>", "`");
        assert!(shown.contains(words), "{query}");
        // and the form is there to go on with
        assert!(shown.contains("name=\"mass\""), "{query}");
    }
}

#[test]
fn without_scripts_a_form_is_answered_with_the_whole_comparison() {
    let mut pairs = sent(text(&get("/?scene=report-break")));
    pairs.retain(|(name, _)| name != "engine");
    pairs.push(("engine".to_owned(), "stepper".to_owned()));
    let mut asked = post(
        "/shot",
        "application/x-www-form-urlencoded",
        &encoded(&pairs),
    );
    asked
        .headers
        .push(("Accept".to_owned(), "text/html,*/*;q=0.8".to_owned()));
    let page = handle(&asked, &site(), &Now);
    assert_eq!((page.status, page.kind), (200, "text/html; charset=utf-8"));
    let shown = text(&page);
    for wanted in [
        "First difference",
        "Ball by ball",
        "<svg",
        "exact (reference)",
        "stepper",
    ] {
        assert!(shown.contains(wanted), "the page lacks {wanted}");
    }
    let answer = shown.split("id=\"answer\"").nth(1).unwrap();
    assert!(
        answer.contains("stepper") && !answer.contains("rapier"),
        "an engine ran that nobody asked for"
    );
    // the same errors, at the same fields
    for (name, value) in &mut pairs {
        if name == "duration" {
            *value = "0".to_owned();
        }
    }
    asked.body = encoded(&pairs).into_bytes();
    let page = handle(&asked, &site(), &Never);
    assert_eq!(page.status, 400);
    let tags = tags(text(&page));
    let wrong: Vec<&str> = tags
        .iter()
        .filter(|tag| tag.get("aria-invalid").is_some())
        .filter_map(|tag| tag.get("name"))
        .collect();
    assert_eq!(wrong, ["duration"]);
    let words = tag(&tags, "p", "id", "error-f-duration");
    assert!(words.text.contains("greater than 0"), "{}", words.text);
}

#[test]
fn a_head_request_and_the_scenes_of_the_catalogue_are_answered() {
    assert_eq!(handle(&request("HEAD", "/"), &site(), &Never).status, 200);
    for entry in catalogue::all() {
        let answer = parsed(&get(&format!("/scenes/{}", entry.name)));
        // some are larger than this page takes, and say so
        match answer["toml"].as_str() {
            Some(toml) => assert_eq!(toml, entry.text),
            None => {
                let why = super::errors(&answer);
                assert!(
                    why.iter().all(|why| why.contains("for this page")),
                    "{}: {why:?}",
                    entry.name
                );
            }
        }
    }
    let shown = catalogue::all()
        .iter()
        .filter(|entry| parsed(&get(&format!("/scenes/{}", entry.name)))["toml"].is_string());
    assert!(shown.count() > catalogue::all().len() / 2);
}
