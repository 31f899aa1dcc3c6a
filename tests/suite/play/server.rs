//! The program over sockets: what it prints, whom it answers, how it ends.

use std::io::{BufRead, BufReader, Read, Write};
use std::net::{TcpListener, TcpStream};
use std::process::{Child, Command, Stdio};
use std::thread;
use std::time::Duration;

/// A running `carom play`, ended with the test.
pub struct Server {
    child: Child,
    pub port: u16,
}

impl Server {
    pub fn start(arguments: &[&str]) -> Self {
        let mut command = Command::new(assert_cmd::cargo::cargo_bin("carom"));
        command.arg("play").args(arguments).arg("--no-open");
        let mut child = command.stdout(Stdio::piped()).spawn().unwrap();
        let mut line = String::new();
        let mut out = BufReader::new(child.stdout.take().unwrap());
        out.read_line(&mut line).unwrap();
        let port = line
            .trim_end()
            .strip_prefix("carom play: http://127.0.0.1:");
        let port = port
            .and_then(|rest| rest.strip_suffix('/'))
            .expect("the address in one line");
        Server {
            port: port.parse().unwrap(),
            child,
        }
    }

    pub fn connect(&self) -> TcpStream {
        let stream = TcpStream::connect(("127.0.0.1", self.port)).unwrap();
        // a server that does not answer fails the test instead of holding it up
        stream
            .set_read_timeout(Some(Duration::from_secs(60)))
            .unwrap();
        stream
    }

    pub fn send(&self, bytes: &str) -> TcpStream {
        let mut stream = self.connect();
        stream.write_all(bytes.as_bytes()).unwrap();
        stream
    }

    pub fn host(&self) -> String {
        format!("Host: 127.0.0.1:{}\r\n", self.port)
    }

    pub fn get(&self, path: &str) -> String {
        answer(self.send(&format!("GET {path} HTTP/1.1\r\n{}\r\n", self.host())))
    }

    pub fn post(&self, path: &str, body: &str) -> TcpStream {
        self.send(&format!(
            "POST {path} HTTP/1.1\r\n{}Content-Type: application/json\r\nContent-Length: {}\r\n\r\n{body}",
            self.host(),
            body.len()
        ))
    }
}

impl Drop for Server {
    fn drop(&mut self) {
        self.child.kill().ok();
        self.child.wait().ok();
    }
}

pub fn answer(mut stream: TcpStream) -> String {
    let mut answer = Vec::new();
    stream.read_to_end(&mut answer).unwrap();
    String::from_utf8(answer).unwrap()
}

pub fn status(answer: &str) -> &str {
    answer.split(' ').nth(1).unwrap_or(answer)
}

#[test]
fn the_page_is_served_on_this_machine_to_requests_of_its_own() {
    let server = Server::start(&["slide", "--port", "0"]);
    let page = server.get("/");
    assert_eq!(status(&page), "200");
    for header in [
        "Cache-Control: no-store",
        "X-Content-Type-Options: nosniff",
        "X-Frame-Options: DENY",
        "Referrer-Policy: same-origin",
        "Connection: close",
    ] {
        assert!(page.contains(&format!("{header}\r\n")), "no {header}");
    }
    assert!(
        page.contains("name = \"slide\""),
        "it does not open with the scene that was named"
    );
    let head = answer(server.send(&format!("HEAD / HTTP/1.1\r\n{}\r\n", server.host())));
    assert!(
        status(&head) == "200" && head.ends_with("\r\n\r\n"),
        "{head}"
    );
    for (request, wanted) in [
        (
            "GET / HTTP/1.1\r\nHost: evil.example\r\n\r\n".to_owned(),
            "403",
        ),
        (
            format!(
                "GET / HTTP/1.1\r\n{}Origin: http://evil.example\r\n\r\n",
                server.host()
            ),
            "403",
        ),
        (
            format!(
                "POST /shot HTTP/1.1\r\n{}Content-Length: 300000\r\n\r\n{}",
                server.host(),
                "a".repeat(300_000)
            ),
            "413",
        ),
        (
            format!("GET /{} HTTP/1.1\r\n\r\n", "a".repeat(20_000)),
            "431",
        ),
        (
            format!("GET /etc/passwd HTTP/1.1\r\n{}\r\n", server.host()),
            "404",
        ),
        ("hello\r\n\r\n".to_owned(), "400"),
    ] {
        let answer = answer(server.send(&request));
        assert_eq!(
            status(&answer),
            wanted,
            "{}",
            &answer[..answer.len().min(200)]
        );
        assert!(answer.contains("{\"errors\":["), "{answer}");
    }
}

#[cfg(target_os = "linux")]
#[test]
fn no_other_address_of_this_machine_is_listened_on() {
    let server = Server::start(&["slide", "--port", "0"]);
    assert!(TcpStream::connect(("127.0.0.1", server.port)).is_ok());
    assert!(TcpStream::connect(("127.0.0.2", server.port)).is_err());
    assert!(TcpStream::connect(("::1", server.port)).is_err());
}

#[test]
fn a_newer_shot_takes_the_place_of_an_older_one() {
    let server = Server::start(&["report-break", "--port", "0"]);
    // a thousand times finer than by default, which takes minutes
    let older = server.post("/shot", "{\"engines\":\"rapier-f64:dt=1e-6\"}");
    let waiting = thread::spawn(move || answer(older));
    // until the older one runs there is nothing to take the place of
    thread::sleep(Duration::from_millis(300));
    let newer = answer(server.post("/shot", "{\"engines\":\"exact\"}"));
    assert_eq!(status(&newer), "200");
    let older = waiting.join().unwrap();
    assert_eq!(status(&older), "409", "{}", &older[..older.len().min(300)]);
    // and whoever went away holds up nobody
    drop(server.post("/shot", "{\"engines\":\"rapier-f64:dt=1e-6\"}"));
    assert_eq!(
        status(&answer(server.post("/shot", "{\"engines\":\"exact\"}"))),
        "200"
    );
}

#[test]
fn a_port_that_is_taken_is_an_error_where_it_was_named_and_passed_over_where_not() {
    let taken = TcpListener::bind("127.0.0.1:0").unwrap();
    let port = taken.local_addr().unwrap().port();
    let mut command = Command::new(assert_cmd::cargo::cargo_bin("carom"));
    let output = command
        .args(["play", "--no-open", "--port", &port.to_string()])
        .output()
        .unwrap();
    assert_eq!(output.status.code(), Some(2));
    let said = String::from_utf8(output.stderr).unwrap();
    assert!(
        said.contains(&format!("cannot listen on port {port}")) && said.contains("--port"),
        "{said}"
    );
    // whoever holds the usual port, this test or somebody else
    let _usual = TcpListener::bind("127.0.0.1:4147");
    let server = Server::start(&["slide"]);
    assert_ne!(server.port, 4147);
    assert_eq!(status(&server.get("/")), "200");
}

#[test]
fn what_is_no_scene_is_not_served() {
    for (scene, wanted) in [
        ("slid", "did you mean `slide`"),
        ("no/such.toml", "no such file"),
    ] {
        let mut command = Command::new(assert_cmd::cargo::cargo_bin("carom"));
        let output = command
            .args(["play", scene, "--no-open", "--port", "0"])
            .output()
            .unwrap();
        assert_eq!(output.status.code(), Some(2), "{scene}");
        assert!(
            String::from_utf8(output.stderr).unwrap().contains(wanted),
            "{scene}"
        );
        assert!(output.stdout.is_empty(), "{scene}");
    }
}

#[cfg(unix)]
#[test]
fn ctrl_c_and_sigterm_end_it_with_success() {
    // a server has no end of its own: whoever stops it has used it as it is meant
    for signal in ["-INT", "-TERM"] {
        let mut server = Server::start(&["slide", "--port", "0"]);
        let pid = server.child.id().to_string();
        let sent = Command::new("kill").args([signal, &pid]).status().unwrap();
        assert!(sent.success());
        assert_eq!(server.child.wait().unwrap().code(), Some(0), "{signal}");
    }
}
