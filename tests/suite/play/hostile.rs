//! Whatever bytes arrive, the answer is an answer.

use super::{Never, handle, site};
use carom::math::random::Draws;
use carom::web::{LARGEST_BODY, LARGEST_HEAD, Request, Unread, read};
use std::io::{self, Cursor, Read, Write};

/// A connection whose other side has sent all it will; what is written to it is kept.
struct Connection {
    received: Cursor<Vec<u8>>,
    sent: Vec<u8>,
}

impl Connection {
    fn with(bytes: impl Into<Vec<u8>>) -> Self {
        Connection {
            received: Cursor::new(bytes.into()),
            sent: Vec::new(),
        }
    }
}

impl Read for Connection {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        // in pieces, as they come from a network
        let piece = buffer.len().min(777);
        self.received.read(&mut buffer[..piece])
    }
}

impl Write for Connection {
    fn write(&mut self, buffer: &[u8]) -> io::Result<usize> {
        self.sent.write(buffer)
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

fn status(bytes: &[u8]) -> Result<Request, u16> {
    match read(&mut Connection::with(bytes)) {
        Ok(request) => Ok(request),
        Err(Unread::Gone) => Err(0),
        Err(Unread::Refused(status, why)) => {
            assert!(!why.is_empty());
            Err(status)
        }
    }
}

#[test]
fn every_part_of_a_request_is_bounded() {
    let head = |filler: usize| format!("GET / HTTP/1.1\r\nX: {}\r\n\r\n", "a".repeat(filler));
    let fixed = head(0).len();
    assert!(status(head(LARGEST_HEAD - fixed).as_bytes()).is_ok());
    assert_eq!(status(head(LARGEST_HEAD - fixed + 1).as_bytes()), Err(431));
    // without an end, however much comes
    assert_eq!(status("a".repeat(10 * LARGEST_HEAD).as_bytes()), Err(431));
    let many = format!("GET / HTTP/1.1\r\n{}\r\n", "X: 1\r\n".repeat(65));
    assert_eq!(status(many.as_bytes()), Err(431));
    let body = |length: usize| {
        format!(
            "POST /shot HTTP/1.1\r\nContent-Length: {length}\r\n\r\n{}",
            "a".repeat(length.min(LARGEST_BODY))
        )
    };
    let request = status(body(LARGEST_BODY).as_bytes()).unwrap();
    assert_eq!(request.body.len(), LARGEST_BODY);
    assert_eq!(status(body(LARGEST_BODY + 1).as_bytes()), Err(413));
}

#[test]
fn what_is_no_request_is_refused_by_its_kind() {
    for (bytes, wanted) in [
        ("", 0),
        ("GET / HTTP/1.1\r\n", 0),
        ("\u{16}\u{3}\u{1} TLS\r\n\r\n", 400),
        ("GET / HTTP/9\r\n\r\n", 400),
        ("GET http://evil.example/ HTTP/1.1\r\n\r\n", 400),
        ("POST /shot HTTP/1.1\r\n\r\n", 411),
        (
            "POST /shot HTTP/1.1\r\nTransfer-Encoding: chunked\r\n\r\n0\r\n\r\n",
            501,
        ),
        (
            "POST /shot HTTP/1.1\r\nContent-Length: 1\r\nContent-Length: 2\r\n\r\nab",
            400,
        ),
        ("POST /shot HTTP/1.1\r\nContent-Length: -1\r\n\r\n", 400),
        ("POST /shot HTTP/1.1\r\nContent-Length: +1\r\n\r\na", 400),
        (
            "POST /shot HTTP/1.1\r\nContent-Length: 99999999999999999999999\r\n\r\n",
            413,
        ),
        ("POST /shot HTTP/1.1\r\nContent-Length: 5\r\n\r\nabc", 400),
        ("GET / HTTP/1.1\r\nX : 1\r\n\r\n", 400),
    ] {
        assert_eq!(status(bytes.as_bytes()), Err(wanted), "{bytes:?}");
    }
}

#[test]
fn whoever_waits_to_be_told_to_go_on_is_told() {
    let mut connection = Connection::with(
        "POST /shot HTTP/1.1\r\nExpect: 100-continue\r\nContent-Length: 0\r\n\r\n",
    );
    assert!(read(&mut connection).is_ok());
    assert!(connection.sent.is_empty(), "nothing is left to wait for");
    let mut connection = Connection::with(
        "POST /shot HTTP/1.1\r\nExpect: 100-continue\r\nContent-Length: 2\r\n\r\n",
    );
    assert!(read(&mut connection).is_err(), "the body never came");
    assert_eq!(connection.sent, b"HTTP/1.1 100 Continue\r\n\r\n");
}

/// Requests that are right, from which the others are made.
fn models() -> Vec<Vec<u8>> {
    let host = format!("Host: 127.0.0.1:{}\r\n", super::PORT);
    let post = |path: &str, kind: &str, body: &str| {
        format!(
            "POST {path} HTTP/1.1\r\n{host}Content-Type: {kind}\r\nContent-Length: {}\r\n\r\n{body}",
            body.len()
        )
    };
    let json = "{\"fields\":{\"mass\":\"0.1\",\"effects.cushion\":\"han-2005\",\"friction\":[1,null]},\"engines\":\"exact\"}";
    let form = "mass=0.1&effects.pockets=given&effects.pockets.circles=1+2+3%0A4,5,6&scene=name+%3D+%22x%22&run=form&engine=stepper";
    let scene =
        serde_json::json!({ "scene": site().start, "fields": { "rack.gap": "1e-3" } }).to_string();
    let all = [
        format!("GET /?scene=slide&mass=1 HTTP/1.1\r\n{host}\r\n"),
        format!("GET /?toml=q1ZKz8zNTFWyUlDKSM3JyVeqBQA HTTP/1.1\r\n{host}\r\n"),
        format!("GET /scenes/pool-break HTTP/1.1\r\n{host}\r\n"),
        post("/shot", "application/json", json),
        post("/scene", "application/json", &scene),
        post("/scene", "application/x-www-form-urlencoded", form),
    ];
    all.map(String::into_bytes).to_vec()
}

#[test]
fn damaged_requests_are_answered_and_nothing_panics() {
    let (models, mut draws) = (models(), Draws::new(8, 0));
    let mut below = |n: usize| (draws.uniform() * n as f64) as usize % n.max(1);
    let (mut answered, mut refused) = (0, 0);
    for _ in 0..4000 {
        let mut bytes = models[below(models.len())].clone();
        for _ in 0..1 + below(6) {
            if bytes.is_empty() {
                break;
            }
            let at = below(bytes.len());
            match below(5) {
                0 => bytes[at] = below(256) as u8,
                1 => bytes.truncate(at),
                2 => {
                    bytes.remove(at);
                }
                3 => bytes.insert(at, b"\"%{}[]\n\r\0&=.-e9"[below(15)]),
                _ => {
                    let piece = bytes[at..(at + below(40)).min(bytes.len())].to_vec();
                    bytes.splice(at..at, piece);
                }
            }
        }
        match status(&bytes) {
            Ok(request) => {
                let response = handle(&request, &site(), &Never);
                let known = [200, 400, 403, 404, 405, 409, 415];
                assert!(known.contains(&response.status), "{}", response.status);
                assert!(!response.body.is_empty());
                answered += 1;
            }
            Err(_) => refused += 1,
        }
    }
    assert!(
        answered > 400 && refused > 400,
        "{answered} answered, {refused} refused"
    );
}

#[test]
fn a_link_that_unpacks_without_end_is_refused() {
    let zeros = vec![b'0'; 64 * 1024 * 1024];
    let packed = miniz_oxide::deflate::compress_to_vec(&zeros, 9);
    assert!(
        packed.len() < 100_000,
        "it would not fit into a request anyway"
    );
    let packed = {
        use base64::Engine as _;
        base64::engine::general_purpose::URL_SAFE_NO_PAD.encode(packed)
    };
    assert!(carom::web::unpacked(&packed).is_err());
    let link = carom::web::link("name = \"x\"").unwrap();
    let packed = link.strip_prefix("/?toml=").unwrap();
    assert_eq!(carom::web::unpacked(packed).unwrap(), "name = \"x\"");
}
