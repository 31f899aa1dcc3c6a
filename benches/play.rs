//! The live page: how long it takes to open and to answer the report's shot, over the socket, and what travels.

#![allow(missing_docs, clippy::expect_used, clippy::print_stdout)]

use std::io::{BufRead, BufReader, Read, Write};
use std::net::TcpStream;
use std::process::{Command, Stdio};
use std::time::Instant;

/// Rounds; the median of each time counts.
const ROUNDS: usize = 9;

/// One request to the server: seconds until all of the answer is there, and its bytes.
fn ask(address: &str, request: &str) -> (f64, usize) {
    let start = Instant::now();
    let mut stream = TcpStream::connect(address).expect("a server");
    stream.write_all(request.as_bytes()).expect("a request");
    let mut answer = Vec::new();
    stream.read_to_end(&mut answer).expect("an answer");
    assert!(answer.starts_with(b"HTTP/1.1 200 "), "refused");
    (start.elapsed().as_secs_f64(), answer.len())
}

fn median(times: &mut [f64]) -> f64 {
    times.sort_by(f64::total_cmp);
    times[times.len() / 2]
}

fn main() {
    let (mut from_nothing, mut page, mut form, mut shot) = (vec![], vec![], vec![], vec![]);
    let mut bytes = [0; 3];
    for _ in 0..ROUNDS {
        let start = Instant::now();
        let mut program = Command::new(env!("CARGO_BIN_EXE_carom"))
            .args(["play", "--no-open", "--port", "0"])
            .stdout(Stdio::piped())
            .spawn()
            .expect("carom");
        let mut line = String::new();
        let out = program.stdout.take().expect("its output");
        BufReader::new(out)
            .read_line(&mut line)
            .expect("its address");
        let address = line.trim().trim_start_matches("carom play: http://");
        let address = address.trim_end_matches('/');
        let get = format!("GET / HTTP/1.1\r\nHost: {address}\r\n\r\n");
        bytes[0] = ask(address, &get).1;
        from_nothing.push(start.elapsed().as_secs_f64());
        page.push(ask(address, &get).0);
        let post = |path: &str| {
            format!(
                "POST {path} HTTP/1.1\r\nHost: {address}\r\nContent-Type: application/json\r\nContent-Length: 2\r\n\r\n{{}}"
            )
        };
        let (time, size) = ask(address, &post("/scene"));
        form.push(time);
        bytes[1] = size;
        let (time, size) = ask(address, &post("/shot"));
        shot.push(time);
        bytes[2] = size;
        program.kill().expect("an end");
        program.wait().expect("an end");
    }
    println!("the live page with the report's break, median of {ROUNDS}");
    for (what, times, size) in [
        (
            "program started to page received",
            &mut from_nothing,
            bytes[0],
        ),
        ("page again", &mut page, bytes[0]),
        ("inputs changed: scene, form, picture", &mut form, bytes[1]),
        ("shot in 5 engines: comparison, replay", &mut shot, bytes[2]),
    ] {
        println!(
            "  {what:<38} {:>7.1} ms {:>8.0} kB",
            1e3 * median(times),
            size as f64 / 1e3
        );
    }
}
