//! Who is connected, and who must go where more come than there is room for.
//!
//! Whoever only makes others wait goes first, the oldest of them: those who have their answer and stay, then those who have not
//! finished asking, then those who do not take their answer. A request that is being answered is never cut off; where there are
//! only such, whoever comes is turned away, at once and without being counted.

use std::net::{Shutdown, TcpStream};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

/// What the other side of a connection is doing, in the order in which it must go.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Doing {
    /// It has its whole answer.
    Leaving,
    /// It has not finished asking.
    Asking,
    /// It has not taken its answer.
    Taking,
    /// It waits, and this program works.
    Waiting,
}

/// One connection.
#[derive(Debug)]
struct OpenConnection {
    /// Counted from the first of all.
    number: u64,
    doing: Doing,
    socket: Arc<TcpStream>,
}

/// All connections, at most so many.
#[derive(Debug)]
pub struct Connections {
    most: usize,
    known: Mutex<(u64, Vec<OpenConnection>)>,
}

/// What became of a new connection.
#[derive(Debug)]
pub enum Entered {
    /// It has a place.
    Place(ConnectionPlace),
    /// It has a place that another had to leave, which is told so if it has been told nothing yet.
    InPlaceOf(ConnectionPlace, Arc<TcpStream>, Doing),
    /// There is no room.
    Full(Arc<TcpStream>),
}

/// The place of one connection; free again when it is dropped.
#[derive(Debug)]
pub struct ConnectionPlace {
    connections: Arc<Connections>,
    number: u64,
    /// The connection.
    pub socket: Arc<TcpStream>,
}

impl Connections {
    /// Room for `most` connections at a time.
    pub fn new(most: usize) -> Arc<Self> {
        Arc::new(Connections {
            most,
            known: Mutex::default(),
        })
    }

    /// A place for a connection.
    pub fn enter(self: &Arc<Self>, socket: TcpStream) -> Entered {
        let socket = Arc::new(socket);
        let mut known = self.known();
        let (last, entries) = &mut *known;
        let mut gone = None;
        if entries.len() >= self.most {
            let first = (0..entries.len())
                .filter(|&i| entries[i].doing != Doing::Waiting)
                .min_by_key(|&i| (entries[i].doing, entries[i].number));
            match first {
                Some(i) => gone = Some(entries.swap_remove(i)),
                None => return Entered::Full(socket),
            }
        }
        *last += 1;
        entries.push(OpenConnection {
            number: *last,
            doing: Doing::Asking,
            socket: Arc::clone(&socket),
        });
        let place = ConnectionPlace {
            connections: Arc::clone(self),
            number: *last,
            socket,
        };
        match gone {
            Some(entry) => Entered::InPlaceOf(place, entry.socket, entry.doing),
            None => Entered::Place(place),
        }
    }

    fn known(&self) -> MutexGuard<'_, (u64, Vec<OpenConnection>)> {
        self.known.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl ConnectionPlace {
    /// Says what the other side does from now on; false if it had to go.
    pub fn is(&self, doing: Doing) -> bool {
        let mut known = self.connections.known();
        let own = known.1.iter_mut().find(|entry| entry.number == self.number);
        own.map(|entry| entry.doing = doing).is_some()
    }
}

impl Drop for ConnectionPlace {
    fn drop(&mut self) {
        self.connections
            .known()
            .1
            .retain(|entry| entry.number != self.number);
    }
}

/// Ends a connection whatever its thread waits for.
pub fn end(socket: &TcpStream) {
    // one that is closed already is ended
    socket.shutdown(Shutdown::Both).ok();
}

#[cfg(test)]
#[allow(clippy::unwrap_used, clippy::expect_used)]
mod tests {
    use super::{ConnectionPlace, Connections, Doing, Entered};
    use std::net::{TcpListener, TcpStream};

    /// Both ends of a connection.
    fn pair(listener: &TcpListener) -> (TcpStream, TcpStream) {
        let there = TcpStream::connect(listener.local_addr().unwrap()).unwrap();
        (listener.accept().unwrap().0, there)
    }

    fn placed(entered: Entered) -> ConnectionPlace {
        match entered {
            Entered::Place(place) => place,
            other => panic!("{other:?}"),
        }
    }

    #[test]
    fn who_only_makes_others_wait_goes_first_and_the_oldest_of_them() {
        use Doing::{Asking, Leaving, Taking, Waiting};
        let listener = TcpListener::bind("127.0.0.1:0").unwrap();
        let connections = Connections::new(6);
        let doing = [Waiting, Asking, Taking, Leaving, Asking, Leaving];
        let places = doing.map(|doing| {
            let place = placed(connections.enter(pair(&listener).0));
            assert!(place.is(doing));
            place
        });
        let mut newer = Vec::new();
        for (first, was) in [
            (3, Leaving),
            (5, Leaving),
            (1, Asking),
            (4, Asking),
            (2, Taking),
        ] {
            let Entered::InPlaceOf(place, other, doing) = connections.enter(pair(&listener).0)
            else {
                panic!("nobody had to go");
            };
            assert_eq!(doing, was);
            let own = &places[first].socket;
            assert_eq!(other.peer_addr().unwrap(), own.peer_addr().unwrap());
            assert!(!places[first].is(Waiting), "{first} still has its place");
            assert!(place.is(Waiting));
            newer.push(place);
        }
        // all that are left are being answered: nobody is cut off, and who is turned away is not counted
        for _ in 0..3 {
            let entered = connections.enter(pair(&listener).0);
            assert!(matches!(entered, Entered::Full(_)), "{entered:?}");
        }
        drop(newer.pop());
        let _last = placed(connections.enter(pair(&listener).0));
        assert!(places[0].is(Waiting));
    }
}
