//! Who may meet whom before one of the two leaves its place: squares in which every ball is listed.
//!
//! A square is wider than any two balls at contact, with slack to spare, so balls that touch are in neighbouring squares, and a
//! prediction looks at nine of them. A ball that leaves its square is listed in the next one and predicted anew: that is an
//! event of the queue and none of the trace. The outermost squares reach to infinity, so a ball that flies away stops leaving
//! squares; when too many balls have gathered in too few squares, they are laid out anew over where the balls are by then.

use super::flight::Flight;
use super::queue::{Candidate, What};
use crate::math::Real;
use crate::math::first_root::{Blur, Contact, first_crossing};
use crate::math::grid::Grid;
use crate::physics::Side;

/// Balls from which on cells are worth their trouble: below, looking at every ball is as quick.
pub const ENOUGH_BALLS: usize = 20;

/// Sides of squares, in largest contact distances. Narrower ones are left more often, wider ones hold more balls.
const WIDTH: f64 = 1.125;

/// The slack in units of what positions are good to, where that is more.
const UNCERTAINTIES: f64 = 256.0;

/// Squares for each ball, at most.
const SQUARES: usize = 2;

/// Partners for each ball that a layout may look at in vain before it is laid out anew.
const PATIENCE: u64 = 64;

/// Partners of one prediction that are not too many.
const FEW: u64 = 24;

/// No ball, or the end of a list.
const NONE: u32 = u32::MAX;

/// The squares and the balls in each.
#[derive(Clone, Debug)]
pub struct Cells {
    grid: Grid,
    /// Column and row of each ball.
    place: Vec<[u32; 2]>,
    /// The first ball of each square.
    first: Vec<u32>,
    /// The ball listed after each ball in its square.
    next: Vec<u32>,
    /// Gap of two balls, length, up to which they are sure to be in neighbouring squares.
    pub slack: f64,
    /// Partners looked at beyond those that were to be expected, since the squares were laid out.
    in_vain: u64,
}

impl Cells {
    /// Empty cells for balls at `positions`. `contact`: the largest distance of two centres at contact; `uncertainty`: what
    /// positions are good to; lengths.
    pub fn over(positions: &[[f64; 2]], contact: f64, uncertainty: f64) -> Self {
        let least = (WIDTH * contact).max(contact + UNCERTAINTIES * uncertainty);
        let grid = Grid::over(positions, least, SQUARES * positions.len());
        let n = positions.len();
        Cells {
            place: vec![[0; 2]; n],
            first: vec![NONE; grid.squares()],
            next: vec![NONE; n],
            // the other half is for the rounding of when a ball leaves
            slack: 0.5 * (grid.size() - contact),
            grid,
            in_vain: 0,
        }
    }

    /// Lists a ball that is not yet listed.
    pub fn enter(&mut self, ball: usize, position: [f64; 2]) {
        self.place[ball] = self.grid.place(position);
        self.list(ball);
    }

    fn list(&mut self, ball: usize) {
        let first = &mut self.first[self.grid.square(self.place[ball])];
        self.next[ball] = *first;
        *first = ball as u32;
    }

    /// Moves a ball from its square to the next one on `side`.
    pub fn cross(&mut self, ball: usize, side: Side) {
        let square = self.grid.square(self.place[ball]);
        let after = self.next[ball];
        let mut here = self.first[square];
        if here as usize == ball {
            self.first[square] = after;
        } else {
            while self.next[here as usize] as usize != ball {
                here = self.next[here as usize];
                self.in_vain += 1;
            }
            self.next[here as usize] = after;
        }
        let step = if side.sign() < 0 { u32::MAX } else { 1 };
        let index = &mut self.place[ball][side.axis()];
        *index = index.wrapping_add(step);
        self.list(ball);
    }

    /// Writes the balls in and around the square of `ball` into `found`, itself included.
    pub fn around(&mut self, ball: usize, found: &mut Vec<u32>) {
        found.clear();
        for row in self.grid.around(self.place[ball]) {
            for first in &self.first[row] {
                let mut here = *first;
                while here != NONE {
                    found.push(here);
                    here = self.next[here as usize];
                }
            }
        }
        self.in_vain += (found.len() as u64).saturating_sub(FEW);
    }

    /// The balls that may be within the slack of `ball`, itself included, in scene order.
    pub fn within_slack(&self, ball: usize) -> Vec<usize> {
        let mut found = Vec::new();
        for row in self.grid.around(self.place[ball]) {
            for first in &self.first[row] {
                let mut here = *first;
                while here != NONE {
                    found.push(here as usize);
                    here = self.next[here as usize];
                }
            }
        }
        found.sort_unstable();
        found
    }

    /// True when the squares no longer fit where the balls are.
    pub fn worn_out(&self) -> bool {
        self.in_vain > PATIENCE * self.place.len() as u64
    }

    /// Replaces `best` by the ball's leaving its square, if that precedes. `now`: s; not before the start of the flight.
    pub fn leaving<T: Real>(
        &self,
        ball: usize,
        flight: &Flight<T>,
        now: T,
        best: &mut Candidate<T>,
    ) {
        let exactly = Blur {
            length: T::zero(),
            speed: T::zero(),
        };
        let (position, velocity) = flight.from(now);
        for axis in 0..2 {
            let edges = self.grid.edges(axis, self.place[ball][axis]);
            for (edge, outward) in edges.into_iter().zip([-T::one(), T::one()]) {
                let Some(edge) = edge else {
                    continue;
                };
                let speed = velocity[axis] * outward;
                let acceleration = flight.acceleration[axis] * outward;
                let limit = best.time - now;
                // also when it would turn outward only after the limit
                if speed <= T::zero() && speed + acceleration * limit <= T::zero() {
                    continue;
                }
                let gap = (T::lift(edge) - position[axis]) * outward;
                if gap > (speed + acceleration.at_least(T::zero()) * limit) * limit {
                    continue;
                }
                let found = if acceleration.is_zero() {
                    Contact::At((gap / speed).at_least(T::zero()))
                } else {
                    first_crossing(gap, speed, acceleration, limit, &exactly)
                };
                if let Contact::At(after) | Contact::Unclear(after) = found {
                    let one = Candidate {
                        time: now + after,
                        what: What::Leaving(ball as u32, side(axis, outward < T::zero())),
                        stamp: 0,
                    };
                    if one.precedes(best) {
                        *best = one;
                    }
                }
            }
        }
    }
}

fn side(axis: usize, low: bool) -> Side {
    match (axis, low) {
        (0, true) => Side::X0,
        (0, false) => Side::X1,
        (_, true) => Side::Y0,
        (_, false) => Side::Y1,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::engine::exact::flight::Ground;
    use crate::math::random::Draws;

    /// Discs of radius 1, touching at the distance 2, somewhere in a square of side 40.
    fn positions(n: usize) -> Vec<[f64; 2]> {
        let point = |i: usize| {
            let mut draws = Draws::new(5, i as u64);
            [draws.between(0.0, 40.0), draws.between(0.0, 40.0)]
        };
        (0..n).map(point).collect()
    }

    fn filled(positions: &[[f64; 2]]) -> Cells {
        let mut cells = Cells::over(positions, 2.0, 1e-14);
        for (ball, position) in positions.iter().enumerate() {
            cells.enter(ball, *position);
        }
        cells
    }

    /// What is around each ball must hold every ball within contact and slack.
    fn hold_near(cells: &mut Cells, positions: &[[f64; 2]]) -> usize {
        let (mut near, mut found) = (0, Vec::new());
        for (a, here) in positions.iter().enumerate() {
            cells.around(a, &mut found);
            let mut sorted: Vec<usize> = found.iter().map(|ball| *ball as usize).collect();
            sorted.sort_unstable();
            assert_eq!(sorted, cells.within_slack(a));
            for (b, there) in positions.iter().enumerate() {
                if (here[0] - there[0]).hypot(here[1] - there[1]) <= 2.0 + cells.slack {
                    assert!(sorted.contains(&b), "{a} at {here:?}, {b} at {there:?}");
                    near += 1;
                }
            }
        }
        near
    }

    #[test]
    fn balls_that_move_from_square_to_square_are_found_by_those_near_them() {
        for ground in [Ground::<f64>::Frictionless, Ground::Coulomb(0.3)] {
            let starts = positions(150);
            let mut cells = filled(&starts);
            let flights: Vec<Flight<f64>> = starts
                .iter()
                .enumerate()
                .map(|(i, start)| {
                    let (vx, vy) = Draws::new(6, i as u64).in_disc(3.0);
                    Flight::new(ground, 0.0, *start, [vx, vy])
                })
                .collect();
            let mut crossings = 0;
            let mut clock = vec![0.0; starts.len()];
            for step in 1..=12 {
                let time = f64::from(step);
                let mut there = Vec::new();
                for (ball, flight) in flights.iter().enumerate() {
                    loop {
                        let mut next = Candidate {
                            time: time.min(flight.end),
                            ..Candidate::none()
                        };
                        cells.leaving(ball, flight, clock[ball], &mut next);
                        let What::Leaving(_, side) = next.what else {
                            break;
                        };
                        clock[ball] = next.time.max(clock[ball]);
                        cells.cross(ball, side);
                        crossings += 1;
                    }
                    clock[ball] = time.min(flight.end);
                    there.push(flight.at(clock[ball]).0);
                }
                assert!(hold_near(&mut cells, &there) >= starts.len());
            }
            assert!(crossings > starts.len(), "{crossings}");
        }
    }

    #[test]
    fn a_crowd_in_few_squares_wears_the_layout_out() {
        let starts = positions(150);
        let mut cells = filled(&starts);
        let mut found = Vec::new();
        for ball in 0..starts.len() {
            cells.around(ball, &mut found);
        }
        assert!(!cells.worn_out());
        // all at one place, looked at again and again
        let mut cells = Cells::over(&starts, 2.0, 1e-14);
        for ball in 0..starts.len() {
            cells.enter(ball, [20.0, 20.0]);
        }
        let looks = PATIENCE as usize * starts.len() / (starts.len() - FEW as usize) + 1;
        for _ in 0..looks {
            cells.around(0, &mut found);
        }
        assert_eq!(found.len(), starts.len());
        assert!(cells.worn_out());
    }
}
