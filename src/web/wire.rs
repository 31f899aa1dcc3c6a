//! HTTP/1.1 as far as one page on one machine needs it: one request a connection, every part of it bounded.
//!
//! No socket, thread or clock is touched here: the caller brings a stream that gives up in time.

use std::io::{self, Read, Write};

/// Longest request line and headers together, bytes; a link with a whole scene is part of it.
pub const LARGEST_HEAD: usize = 16 * 1024;

/// Most headers of a request.
const MOST_HEADERS: usize = 64;

/// Longest body, bytes: a scene of 200 balls takes about a tenth of it.
pub const LARGEST_BODY: usize = 256 * 1024;

/// What ends the head of a request.
const END_OF_HEAD: &[u8] = b"\r\n\r\n";

/// What the page of this server may do where it says nothing else: nothing.
const NOTHING: &str =
    "default-src 'none'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

/// One request.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Request {
    /// Such as `GET`.
    pub method: String,
    /// Such as `/scenes/slide`, as sent.
    pub path: String,
    /// What follows `?`, as sent; empty if nothing does.
    pub query: String,
    /// Names as sent, and values. Values that are not text are read as far as they are.
    pub headers: Vec<(String, String)>,
    /// The body, [`LARGEST_BODY`] at most.
    pub body: Vec<u8>,
}

impl Request {
    /// Every value of a header, whatever the case of its name.
    pub fn all<'a>(&'a self, name: &'a str) -> impl Iterator<Item = &'a str> {
        let named = self
            .headers
            .iter()
            .filter(|(n, _)| n.eq_ignore_ascii_case(name));
        named.map(|(_, value)| value.as_str())
    }

    /// The value of a header; `None` if it is not there or stands more than once.
    pub fn only<'a>(&'a self, name: &'a str) -> Option<&'a str> {
        let mut values = self.all(name);
        let first = values.next()?;
        values.next().is_none().then_some(first)
    }

    /// Whether the one `Content-Type` is `kind`, whatever its parameters.
    pub fn is_of(&self, kind: &str) -> bool {
        let named = self.only("Content-Type").unwrap_or_default();
        let media = named.split(';').next().unwrap_or_default();
        media.trim().eq_ignore_ascii_case(kind)
    }

    /// Whether a header called `name` has `word` in its list.
    pub fn lists(&self, name: &str, word: &str) -> bool {
        let items = self.all(name).flat_map(|value| value.split(','));
        let mut words = items.map(|item| item.split(';').next().unwrap_or_default());
        words.any(|known| known.trim().eq_ignore_ascii_case(word))
    }
}

/// One answer.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Response {
    /// Such as 200.
    pub status: u16,
    /// Media type of the body.
    pub kind: &'static str,
    /// Further headers.
    pub headers: Vec<(&'static str, String)>,
    /// The body.
    pub body: Vec<u8>,
}

impl Response {
    /// An answer for programs.
    pub fn json(status: u16, body: String) -> Self {
        Response {
            status,
            kind: "application/json",
            headers: vec![("Content-Security-Policy", NOTHING.to_owned())],
            body: body.into_bytes(),
        }
    }

    /// A page that may do nothing.
    pub fn bare_page(status: u16, body: String) -> Self {
        Response::page(status, NOTHING.to_owned(), body)
    }

    /// A page, with what it may do.
    pub fn page(status: u16, policy: String, body: String) -> Self {
        Response {
            status,
            kind: "text/html; charset=utf-8",
            headers: vec![("Content-Security-Policy", policy)],
            body: body.into_bytes(),
        }
    }

    /// The same answer with one more header.
    pub fn with(mut self, name: &'static str, value: &str) -> Self {
        self.headers.push((name, value.to_owned()));
        self
    }

    /// Writes the answer, without its body if `head_only`. No other page may frame it, embed it or read it, and none keeps it.
    pub fn write(&self, stream: &mut impl Write, head_only: bool) -> io::Result<()> {
        let mut head = format!(
            "HTTP/1.1 {} {}\r\nContent-Type: {}\r\nContent-Length: {}\r\nConnection: close\r\nCache-Control: no-store\r\n\
             X-Content-Type-Options: nosniff\r\nX-Frame-Options: DENY\r\nReferrer-Policy: same-origin\r\n\
             Cross-Origin-Opener-Policy: same-origin\r\nCross-Origin-Resource-Policy: same-origin\r\n",
            self.status,
            reason(self.status),
            self.kind,
            self.body.len()
        );
        for (name, value) in &self.headers {
            head += &format!("{name}: {value}\r\n");
        }
        head += "\r\n";
        stream.write_all(head.as_bytes())?;
        if !head_only {
            stream.write_all(&self.body)?;
        }
        stream.flush()
    }
}

/// What a status is called.
fn reason(status: u16) -> &'static str {
    match status {
        200 => "OK",
        400 => "Bad Request",
        403 => "Forbidden",
        404 => "Not Found",
        405 => "Method Not Allowed",
        408 => "Request Timeout",
        409 => "Conflict",
        411 => "Length Required",
        413 => "Content Too Large",
        415 => "Unsupported Media Type",
        431 => "Request Header Fields Too Large",
        500 => "Internal Server Error",
        501 => "Not Implemented",
        503 => "Service Unavailable",
        _ => "Unknown",
    }
}

/// Why there is no request.
#[derive(Debug)]
pub enum Unread {
    /// The other side went away, or said nothing in time, before it asked for anything.
    Gone,
    /// What it sent is no request that this server takes: status, and what is wrong in one sentence.
    Refused(u16, String),
}

fn refused(status: u16, why: impl Into<String>) -> Unread {
    Unread::Refused(status, why.into())
}

/// Reads one request.
pub fn read(stream: &mut (impl Read + Write)) -> Result<Request, Unread> {
    let mut received = Vec::new();
    let end = head(stream, &mut received)?;
    let mut request = parse(&received[..end])?;
    let length = length(&request)?;
    if length > LARGEST_BODY {
        let why = format!("the body has {length} bytes; {LARGEST_BODY} is the most");
        return Err(refused(413, why));
    }
    let mut body = received.split_off(end);
    if body.len() < length && request.lists("Expect", "100-continue") {
        let go_on = stream.write_all(b"HTTP/1.1 100 Continue\r\n\r\n");
        go_on.and_then(|()| stream.flush()).map_err(unread)?;
    }
    body.truncate(length);
    let missing = (length - body.len()) as u64;
    stream
        .take(missing)
        .read_to_end(&mut body)
        .map_err(unread)?;
    if body.len() < length {
        let why = format!("the body ends after {} of {length} bytes", body.len());
        return Err(refused(400, why));
    }
    request.body = body;
    Ok(request)
}

/// Reads until the head of the request is complete, and says where it ends.
fn head(stream: &mut impl Read, received: &mut Vec<u8>) -> Result<usize, Unread> {
    let mut piece = [0; 4096];
    loop {
        let n = match stream.read(&mut piece) {
            Ok(n) => n,
            Err(error) if error.kind() == io::ErrorKind::Interrupted => continue,
            Err(_) if received.is_empty() => return Err(Unread::Gone),
            Err(error) => return Err(unread(error)),
        };
        if n == 0 {
            return Err(Unread::Gone);
        }
        let from = received.len().saturating_sub(END_OF_HEAD.len() - 1);
        received.extend_from_slice(&piece[..n]);
        let found = received[from..]
            .windows(END_OF_HEAD.len())
            .position(|window| window == END_OF_HEAD);
        let end = found.map(|at| from + at + END_OF_HEAD.len());
        if end.unwrap_or(received.len()) > LARGEST_HEAD {
            let why = format!("the request line and headers are longer than {LARGEST_HEAD} bytes");
            return Err(refused(431, why));
        }
        if let Some(end) = end {
            return Ok(end);
        }
    }
}

fn unread(error: io::Error) -> Unread {
    match error.kind() {
        io::ErrorKind::WouldBlock | io::ErrorKind::TimedOut => {
            refused(408, "the request did not arrive in time")
        }
        _ => Unread::Gone,
    }
}

fn parse(head: &[u8]) -> Result<Request, Unread> {
    let mut headers = [httparse::EMPTY_HEADER; MOST_HEADERS];
    let mut parsed = httparse::Request::new(&mut headers);
    match parsed.parse(head) {
        Ok(httparse::Status::Complete(_)) => {}
        Ok(httparse::Status::Partial) => return Err(refused(400, "the request is not HTTP/1.1")),
        Err(httparse::Error::TooManyHeaders) => {
            return Err(refused(
                431,
                format!("there are more than {MOST_HEADERS} headers"),
            ));
        }
        Err(error) => {
            return Err(refused(
                400,
                format!("the request is not HTTP/1.1: {error}"),
            ));
        }
    }
    let target = parsed.path.unwrap_or_default();
    if !target.starts_with('/') {
        return Err(refused(400, "the request must name a path, such as /"));
    }
    let (path, query) = target.split_once('?').unwrap_or((target, ""));
    let header = |header: &httparse::Header<'_>| {
        let value = String::from_utf8_lossy(header.value).into_owned();
        (header.name.to_owned(), value)
    };
    Ok(Request {
        method: parsed.method.unwrap_or_default().to_owned(),
        path: path.to_owned(),
        query: query.to_owned(),
        headers: parsed.headers.iter().map(header).collect(),
        body: Vec::new(),
    })
}

/// The length of the body, bytes.
fn length(request: &Request) -> Result<usize, Unread> {
    if request.all("Transfer-Encoding").next().is_some() {
        return Err(refused(
            501,
            "the body must come in one piece, with its Content-Length",
        ));
    }
    let mut lengths = request.all("Content-Length");
    match (lengths.next(), lengths.next()) {
        (None, _) if request.method == "POST" => {
            Err(refused(411, "the body must come with its Content-Length"))
        }
        (None, _) => Ok(0),
        (Some(digits), None)
            if !digits.is_empty() && digits.bytes().all(|b| b.is_ascii_digit()) =>
        {
            // more digits than a machine word has are more bytes than any bound
            Ok(digits.parse().unwrap_or(usize::MAX))
        }
        _ => Err(refused(400, "Content-Length must be one whole number")),
    }
}
