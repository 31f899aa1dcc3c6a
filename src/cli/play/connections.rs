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
struct Entry {
    /// Counted from the first of all.
    number: u64,
    doing: Doing,
    socket: Arc<TcpStream>,
}

/// All connections, at most so many.
#[derive(Debug)]
pub struct Connections {
    most: usize,
    known: Mutex<(u64, Vec<Entry>)>,
}

/// What became of a new connection.
#[derive(Debug)]
pub enum Entered {
    /// It has a place.
    Place(Place),
    /// It has a place that another had to leave, which is told so if it has been told nothing yet.
    InPlaceOf(Place, Arc<TcpStream>, Doing),
    /// There is no room.
    Full(Arc<TcpStream>),
}

/// The place of one connection; free again when it is dropped.
#[derive(Debug)]
pub struct Place {
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
        entries.push(Entry {
            number: *last,
            doing: Doing::Asking,
            socket: Arc::clone(&socket),
        });
        let place = Place {
            connections: Arc::clone(self),
            number: *last,
            socket,
        };
        match gone {
            Some(entry) => Entered::InPlaceOf(place, entry.socket, entry.doing),
            None => Entered::Place(place),
        }
    }

    fn known(&self) -> MutexGuard<'_, (u64, Vec<Entry>)> {
        self.known.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Place {
    /// Says what the other side does from now on; false if it had to go.
    pub fn is(&self, doing: Doing) -> bool {
        let mut known = self.connections.known();
        let own = known.1.iter_mut().find(|entry| entry.number == self.number);
        own.map(|entry| entry.doing = doing).is_some()
    }
}

impl Drop for Place {
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
