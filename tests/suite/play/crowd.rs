//! More connections than there is room for: whoever asks is answered, whoever only waits is told to go.

use super::server::{Server, answer, status};
use super::{PORT, parsed, request, site};
use carom::web::{Request, Response, Turn, Turns};
use std::io::{Read, Write};
use std::net::TcpStream;
use std::sync::atomic::AtomicBool;

/// Connections that want to keep a server busy; it has room for 64.
const CROWD: usize = 300;
const ROOM: usize = 64;

/// What a connection was told until it ended, however it ended.
fn told(mut stream: TcpStream) -> String {
    let mut bytes = Vec::new();
    let mut piece = [0; 4096];
    while let Ok(n @ 1..) = stream.read(&mut piece) {
        bytes.extend_from_slice(&piece[..n]);
    }
    String::from_utf8_lossy(&bytes).into_owned()
}

/// The status of an answer whose body says what happened.
fn with_words(answer: &str) -> &str {
    let (head, body) = answer.split_once("\r\n\r\n").unwrap_or_default();
    let body: serde_json::Value =
        serde_json::from_str(body).unwrap_or_else(|error| panic!("{error}: {answer}"));
    let message = body["errors"][0]["message"].as_str().unwrap();
    assert!(message.len() > 10, "{answer}");
    assert!(!head.contains("Unknown"), "{head}");
    status(answer)
}

#[test]
fn who_asks_is_answered_while_hundreds_ask_slowly() {
    let server = Server::start(&["slide", "--port", "0"]);
    // nothing, a little, a request that never ends, a body that never comes
    let beginnings = [
        String::new(),
        "G".to_owned(),
        format!("GET / HTTP/1.1\r\n{}X-Slow: ", server.host()),
        format!(
            "POST /shot HTTP/1.1\r\n{}Content-Type: application/json\r\nContent-Length: 1000\r\n\r\n{{",
            server.host()
        ),
    ];
    let mut crowd: Vec<TcpStream> = (0..CROWD)
        .map(|i| server.send(&beginnings[i % beginnings.len()]))
        .collect();
    // more of them comes all the time, which gives none of them more time
    for stream in &mut crowd {
        stream.write_all(b"a").ok();
    }
    assert_eq!(status(&server.get("/")), "200");
    let shot = answer(server.post("/shot", "{\"engines\":\"exact\"}"));
    assert_eq!(status(&shot), "200");
    // the first that came had to go, and each was told so
    let gone = crowd.drain(..CROWD + 1 - ROOM);
    let statuses: Vec<String> = gone
        .map(|stream| with_words(&told(stream)).to_owned())
        .collect();
    let refused = statuses.iter().filter(|status| *status == "503").count();
    let late = statuses.iter().filter(|status| *status == "408").count();
    assert_eq!(refused + late, CROWD + 1 - ROOM, "{statuses:?}");
    assert!(refused > 0);
}

#[test]
fn who_asks_is_answered_while_hundreds_do_not_take_their_answers_or_do_not_leave() {
    let server = Server::start(&["slide", "--port", "0"]);
    let page = format!("GET / HTTP/1.1\r\n{}\r\n", server.host());
    let none = format!("GET /none HTTP/1.1\r\n{}\r\n", server.host());
    let crowd: Vec<TcpStream> = (0..CROWD)
        .map(|i| server.send(if i % 2 == 0 { &page } else { &none }))
        .collect();
    // each of the crowd was counted while it was answered; how many are at one moment is up to the machine
    let get = || told(server.send(&page));
    let mut tries = 0;
    while status(&get()) != "200" {
        tries += 1;
        assert!(tries < 100, "nobody is answered");
        std::thread::sleep(std::time::Duration::from_millis(20));
    }
    drop(crowd);
}

#[test]
fn connections_that_say_nothing_take_no_room() {
    let server = Server::start(&["slide", "--port", "0"]);
    for _ in 0..5 {
        let silent: Vec<TcpStream> = (0..ROOM).map(|_| server.connect()).collect();
        assert_eq!(status(&server.get("/")), "200");
        let first = silent.into_iter().next().unwrap();
        let first = told(first);
        assert!(matches!(with_words(&first), "503" | "408"), "{first}");
    }
}

/// Where a shot would run, this program has a defect.
struct Defect;

impl Turns for Defect {
    fn take(&self, _run: &mut dyn FnMut(&AtomicBool)) -> Turn {
        panic!("this panic belongs to a test");
    }
}

/// An answer as it goes over the wire.
fn sent(response: &Response) -> String {
    let mut bytes = Vec::new();
    response.write(&mut bytes, false).unwrap();
    String::from_utf8(bytes).unwrap()
}

fn asked(method: &str, target: &str, html: bool) -> Request {
    let mut asked = match method {
        "POST" => super::post(target, "application/x-www-form-urlencoded", "run=form"),
        _ => request(method, target),
    };
    if html {
        let accept = ("Accept".to_owned(), "text/html,*/*;q=0.8".to_owned());
        asked.headers.push(accept);
    }
    asked
}

#[test]
fn a_defect_is_answered_with_words_in_the_form_that_is_shown() {
    let response = carom::web::answer(&asked("POST", "/shot", false), &site(), &Defect);
    assert_eq!(response.status, 500);
    let message = parsed(&response)["errors"][0]["message"].clone();
    assert!(message.as_str().unwrap().contains("defect"), "{message}");
    assert!(sent(&response).starts_with("HTTP/1.1 500 Internal Server Error\r\n"));
    let page = carom::web::answer(&asked("POST", "/shot", true), &site(), &Defect);
    assert_eq!((page.status, page.kind), (500, "text/html; charset=utf-8"));
    assert!(sent(&page).contains("defect of carom"), "{}", sent(&page));
}

#[test]
fn every_refusal_has_a_name_and_words_for_programs_and_for_browsers() {
    let foreign = |mut request: Request| {
        request.headers[0].1 = format!("evil.example:{PORT}");
        request
    };
    let plain = |mut request: Request| {
        request.headers[1].1 = "text/plain".to_owned();
        request
    };
    for html in [false, true] {
        for (request, wanted) in [
            (foreign(asked("GET", "/", html)), 403),
            (asked("GET", "/none", html), 404),
            (asked("GET", "/scenes/<b>", html), 404),
            (asked("DELETE", "/", html), 405),
            (plain(asked("POST", "/shot", html)), 415),
        ] {
            let response = carom::web::answer(&request, &site(), &super::Never);
            assert_eq!(response.status, wanted);
            let sent = sent(&response);
            assert!(!sent.lines().next().unwrap().contains("Unknown"), "{sent}");
            if html {
                assert_eq!(response.kind, "text/html; charset=utf-8", "{wanted}");
                assert!(sent.contains(&format!("<h1>{wanted}</h1>\n<p>")), "{sent}");
                assert!(!sent.contains("<b>"), "{sent}");
            } else {
                assert_eq!(with_words(&sent), wanted.to_string());
            }
        }
    }
}
