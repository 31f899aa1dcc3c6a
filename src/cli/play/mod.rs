//! `carom play`: the live page on this machine. Sockets, threads and clocks of it are here, what it says is in `web`.

mod connections;

use super::arguments::PlayArguments;
use super::exit::Exit;
use super::{Failure, scene, terminal};
use crate::engine::Roster;
use crate::web::{self, Problem, Response, Site, Turn, Turns, Unread};
use connections::{ConnectionPlace, Connections, Doing, Entered, end};
use std::io::{self, ErrorKind, Read, Write};
use std::net::{Ipv4Addr, Shutdown, TcpListener, TcpStream};
use std::process::{Command, ExitCode, Stdio};
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread;
use std::time::{Duration, Instant};

/// Where the page is looked for first.
const PORT: u16 = 4147;

/// How many ports after it are tried where it is taken.
const PORTS: u16 = 20;

/// Most connections at a time; a browser opens six.
const MOST_CONNECTIONS: usize = 64;

/// How long a request may take to arrive, and an answer to be taken: each in all, however many pieces it has.
const PATIENCE: Duration = Duration::from_secs(10);

/// How long whoever has sent no request that can be answered may take to hear why, if that is longer than its request had left.
const LAST_WORDS: Duration = Duration::from_secs(1);

/// How long a shot may take.
const LONGEST_SHOT: Duration = Duration::from_secs(10);

/// How often it is looked whether a shot must stop, and whether the program must.
const LOOK: Duration = Duration::from_millis(25);

/// Most bytes that are read and thrown away so that a refusal arrives: a socket closed with bytes unread takes back what was sent.
const THROWN_AWAY: usize = 1024 * 1024;

/// Serves the page until Ctrl-C or SIGTERM.
pub fn play(arguments: &PlayArguments, roster: &Roster) -> Result<ExitCode, Failure> {
    let start = scene::text(&arguments.scene)?;
    let listener = listen(arguments.port)?;
    let port = match listener.local_addr() {
        Ok(address) => address.port(),
        Err(error) => return Err(Failure::Message(format!("cannot listen: {error}"))),
    };
    let address = format!("http://127.0.0.1:{port}/");
    // before the address is known to anybody
    let cancelled = terminal::cancelled();
    let server = Arc::new(Server {
        site: Site {
            port,
            start,
            roster: roster.clone(),
        },
        newest: AtomicU64::new(0),
        running: Mutex::new(()),
    });
    thread::spawn(move || accept(&listener, &server));
    terminal::print(&format!("carom play: {address}\n"))?;
    if !arguments.no_open {
        thread::spawn(move || open(&address));
    }
    while !cancelled.load(Ordering::Relaxed) {
        thread::sleep(LOOK);
    }
    // a server that its user stopped has finished
    Ok(Exit::Finished.into())
}

/// A socket on this machine alone.
fn listen(port: Option<u16>) -> Result<TcpListener, Failure> {
    let bind = |port| TcpListener::bind((Ipv4Addr::LOCALHOST, port));
    let taken = |error: &io::Error| error.kind() == ErrorKind::AddrInUse;
    if let Some(port) = port {
        return bind(port).map_err(|error| {
            let help = match taken(&error) {
                true => "; name another with --port, or none for the next that is free",
                false => "",
            };
            Failure::Message(format!("cannot listen on port {port}: {error}{help}"))
        });
    }
    for port in PORT..PORT + PORTS {
        match bind(port) {
            Err(error) if taken(&error) => {}
            other => {
                return other.map_err(|error| Failure::Message(format!("cannot listen: {error}")));
            }
        }
    }
    bind(0).map_err(|error| Failure::Message(format!("cannot listen: {error}")))
}

/// Asks the system to show the page.
fn open(address: &str) {
    let mut command = if cfg!(target_os = "macos") {
        Command::new("open")
    } else if cfg!(target_os = "windows") {
        let mut command = Command::new("cmd");
        command.args(["/C", "start", ""]);
        command
    } else {
        Command::new("xdg-open")
    };
    let command = command.arg(address).stdin(Stdio::null());
    let opened = command.stdout(Stdio::null()).stderr(Stdio::null()).status();
    if !opened.is_ok_and(|status| status.success()) {
        terminal::say(&format!(
            "warning: no browser could be opened; the page is at {address}"
        ));
    }
}

/// What all connections share.
struct Server {
    site: Site,
    /// Number of the newest shot.
    newest: AtomicU64,
    /// Held by the shot that runs.
    running: Mutex<()>,
}

fn accept(listener: &TcpListener, server: &Arc<Server>) {
    let connections = Connections::new(MOST_CONNECTIONS);
    for stream in listener.incoming() {
        let Ok(stream) = stream else {
            // out of descriptors: some connection will end
            thread::sleep(LOOK);
            continue;
        };
        let place = match connections.enter(stream) {
            Entered::Place(place) => place,
            Entered::InPlaceOf(place, other, doing) => {
                if doing == Doing::Asking {
                    turn_away(&other, "this connection had to make room for a newer one");
                }
                end(&other);
                place
            }
            Entered::Full(socket) => {
                turn_away(&socket, "there are too many connections at a time");
                continue;
            }
        };
        let (server, socket) = (Arc::clone(server), Arc::clone(&place.socket));
        let started = thread::Builder::new().spawn(move || server.serve(&place));
        if started.is_err() {
            turn_away(
                &socket,
                "the system lets this program start no more threads",
            );
        }
    }
}

fn refusal(status: u16, why: String) -> Response {
    Response::json(status, web::problems(&[Problem::new(why)]))
}

/// Tells a connection that has been told nothing yet why it is not answered, and waits for nothing.
fn turn_away(mut socket: &TcpStream, why: &str) {
    let mut words = Vec::new();
    let response = refusal(503, why.to_owned());
    if response.write(&mut words, false).is_err() {
        return;
    }
    // a few hundred bytes fit into what the system keeps for a socket to which nothing was written
    socket.set_write_timeout(Some(LOOK)).ok();
    let told = socket.write_all(&words);
    let told = told.and_then(|()| socket.shutdown(Shutdown::Write));
    // what has come is read: a socket closed with bytes unread takes back what was sent
    if told.is_ok() && socket.set_nonblocking(true).is_ok() {
        let (mut piece, mut read) = ([0; 4096], 0);
        while read < web::LARGEST_HEAD {
            match socket.read(&mut piece) {
                Ok(0) | Err(_) => return,
                Ok(n) => read += n,
            }
        }
    }
}

impl Server {
    /// Answers the one request of a connection.
    fn serve(&self, place: &ConnectionPlace) {
        let mut stream = Timely::new(&place.socket);
        let request = match web::read(&mut stream) {
            Ok(request) => request,
            Err(Unread::Gone) => return,
            Err(Unread::Refused(status, why)) => {
                if place.is(Doing::Taking) {
                    stream.refuse(&refusal(status, why), place);
                }
                return;
            }
        };
        if !place.is(Doing::Waiting) {
            return;
        }
        let seat = Seat {
            server: self,
            socket: &place.socket,
        };
        let response = web::answer(&request, &self.site, &seat);
        if place.is(Doing::Taking) {
            stream.answer(&response, request.method == "HEAD", place);
        }
    }
}

/// The place of one request among those that want to run a shot: the newest runs, and stops whichever ran before it.
struct Seat<'a> {
    server: &'a Server,
    socket: &'a TcpStream,
}

impl Turns for Seat<'_> {
    fn take(&self, run: &mut dyn FnMut(&AtomicBool)) -> Turn {
        let number = self.server.newest.fetch_add(1, Ordering::Relaxed) + 1;
        let running = self.server.running.lock();
        let _running = running.unwrap_or_else(PoisonError::into_inner);
        if self.is_overtaken(number) {
            return Turn::Overtaken;
        }
        let cancelled = AtomicBool::new(false);
        let (done, is_done) = channel();
        thread::scope(|scope| {
            let flag = &cancelled;
            let watcher = scope.spawn(move || self.watch(number, flag, &is_done));
            run(flag);
            drop(done);
            watcher.join().unwrap_or(Turn::Done)
        })
    }
}

impl Seat<'_> {
    fn is_overtaken(&self, number: u64) -> bool {
        self.server.newest.load(Ordering::Relaxed) != number
    }

    /// Looks, until the shot is done, whether it must stop; and why it had to.
    fn watch(&self, number: u64, cancelled: &AtomicBool, is_done: &Receiver<()>) -> Turn {
        let begin = Instant::now();
        // the thread that runs the shot does not read or write meanwhile
        let can_look = self.socket.set_nonblocking(true).is_ok();
        let mut turn = Turn::Done;
        while is_done.recv_timeout(LOOK) == Err(RecvTimeoutError::Timeout) {
            if turn != Turn::Done {
                continue;
            }
            if begin.elapsed() > LONGEST_SHOT {
                turn = Turn::TooLong(LONGEST_SHOT.as_secs_f64());
            } else if self.is_overtaken(number) || (can_look && is_gone(self.socket)) {
                turn = Turn::Overtaken;
            }
            if turn != Turn::Done {
                cancelled.store(true, Ordering::Relaxed);
            }
        }
        // if it does not become one that waits again, writing fails and nobody is answered
        self.socket.set_nonblocking(false).ok();
        turn
    }
}

/// True once the other side closed its end: whoever asked no longer waits.
fn is_gone(socket: &TcpStream) -> bool {
    match socket.peek(&mut [0]) {
        Ok(bytes) => bytes == 0,
        Err(error) => error.kind() != ErrorKind::WouldBlock,
    }
}

/// A socket that gives up when its time is over, however slowly bytes come and go.
struct Timely<'a> {
    socket: &'a TcpStream,
    until: Instant,
}

impl<'a> Timely<'a> {
    fn new(socket: &'a TcpStream) -> Self {
        Timely {
            socket,
            until: Instant::now() + PATIENCE,
        }
    }

    /// Sends the answer to a request, which has a time of its own: what came before it was the time of this program.
    fn answer(&mut self, response: &Response, head_only: bool, place: &ConnectionPlace) {
        self.until = Instant::now() + PATIENCE;
        self.send(response, head_only, place);
    }

    /// Says what is wrong with a request, within the time that it had to arrive.
    fn refuse(&mut self, response: &Response, place: &ConnectionPlace) {
        self.until = self.until.max(Instant::now() + LAST_WORDS);
        self.send(response, false, place);
    }

    /// Sends an answer, and waits for it to be taken as long as there is time.
    fn send(&mut self, response: &Response, head_only: bool, place: &ConnectionPlace) {
        if response.write(self, head_only).is_err()
            || self.socket.shutdown(Shutdown::Write).is_err()
            || !place.is(Doing::Leaving)
        {
            return;
        }
        let (mut piece, mut read) = ([0; 4096], 0);
        while read < THROWN_AWAY {
            match self.read(&mut piece) {
                Ok(0) | Err(_) => return,
                Ok(n) => read += n,
            }
        }
    }

    fn left(&self) -> io::Result<Option<Duration>> {
        let left = self.until.saturating_duration_since(Instant::now());
        match left.is_zero() {
            true => Err(ErrorKind::TimedOut.into()),
            false => Ok(Some(left)),
        }
    }
}

impl Read for Timely<'_> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        self.socket.set_read_timeout(self.left()?)?;
        self.socket.read(buffer)
    }
}

impl Write for Timely<'_> {
    fn write(&mut self, buffer: &[u8]) -> io::Result<usize> {
        self.socket.set_write_timeout(self.left()?)?;
        self.socket.write(buffer)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.socket.flush()
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::connections::{Connections, Entered};
    use super::{LAST_WORDS, Timely, refusal};
    use std::net::{TcpListener, TcpStream};
    use std::time::Instant;

    #[test]
    fn a_refusal_gives_no_more_time_than_the_request_had() {
        let listener = TcpListener::bind("127.0.0.1:0").unwrap();
        let there = TcpStream::connect(listener.local_addr().unwrap()).unwrap();
        let connections = Connections::new(1);
        let Entered::Place(place) = connections.enter(listener.accept().unwrap().0) else {
            panic!("there is room for one");
        };
        // nobody stays to listen, so that nobody is waited for
        drop(there);
        let mut stream = Timely::new(&place.socket);
        for until in [stream.until, Instant::now()] {
            stream.until = until;
            stream.refuse(&refusal(400, "no request".to_owned()), &place);
            assert!(stream.until <= until.max(Instant::now() + LAST_WORDS));
        }
    }
}
